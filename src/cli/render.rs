//! `clearbeam render`: a picture without a screen.

use super::{CommandFailure, CommandOutcome, print};
use crate::document::{Job, files, segmented};
use crate::picture::dose::legend;
use crate::picture::{
    DoseLook, Legend, PartLook, PartPicture, deviation_points, deviation_scale, dose_item, part_with_lines, png, still,
};
use crate::planning::scanned::Scanned;
use crate::planning::{self, Pipeline, PlannedJob};
use crate::progress::Progress;
use crate::text::{listed, say};
use crate::view::{Bounds, HeadlessGl, MeshItem, Scene, StandardView};
use std::path::PathBuf;
use std::sync::Arc;

/// Options of `render`.
#[derive(clap::Args, Debug)]
pub struct RenderArguments {
    #[arg(help = say!(cli_render_input))]
    input: PathBuf,
    #[arg(long, value_name = "FILE.png", help = say!(cli_render_out))]
    out: PathBuf,
    #[arg(long, value_name = "WxH", default_value = "1280x800", value_parser = size, help = say!(cli_render_size))]
    size: [u32; 2],
    #[arg(long, default_value = "iso", value_parser = view, help = say!(cli_render_view))]
    view: StandardView,
    #[arg(long, default_value = "surface", value_parser = color, help = say!(cli_render_color))]
    color: Color,
}

/// What the colours show.
#[derive(Clone, Copy, Debug)]
enum Color {
    Surface,
    Dose(DoseLook),
}

fn color(text: &str) -> Result<Color, String> {
    match text {
        "surface" => Ok(Color::Surface),
        "dose" => Ok(Color::Dose(DoseLook::Dose)),
        "incidence" => Ok(Color::Dose(DoseLook::Incidence)),
        _ => Err(say!(cli_not_a_color, text)),
    }
}

fn size(text: &str) -> Result<[u32; 2], String> {
    let parsed = text.split_once('x').and_then(|(w, h)| Some([w.parse().ok()?, h.parse().ok()?]));
    parsed.filter(|s| s.iter().all(|x| (16..=8192).contains(x))).ok_or_else(|| say!(cli_not_a_size, text))
}

fn view(text: &str) -> Result<StandardView, String> {
    let found = StandardView::ALL.into_iter().find(|v| v.word() == text);
    found.ok_or_else(|| say!(cli_not_a_view, text, views = listed(StandardView::ALL.map(StandardView::word))))
}

/// Draws and writes.
pub fn run(a: &RenderArguments) -> Result<CommandOutcome, CommandFailure> {
    let (mut job, job_file) = super::plan::opened(&a.input)?;
    let file = files::part_file(&job, job_file.as_deref()).map_err(CommandFailure::failed)?;
    let source = files::read_part(&job, job_file.as_deref()).map_err(CommandFailure::failed)?;
    job.part.begin_with(&source, job_file.as_deref());
    // A part alone is drawn as it is; what lands on it needs a plan.
    let wants_plan = job_file.is_some() || matches!(a.color, Color::Dose(_));
    let (scene, legend, (min, max)) = if wants_plan && (job.scan.is_there() || !job.settings.cleans_nothing()) {
        let (pipeline, planned) =
            Pipeline::planned(Arc::new(source), &job, job_file.as_deref()).map_err(CommandFailure::failed)?;
        let (mut scene, mut legend) = planned_scene(&planned, a.color)?;
        if let (Color::Surface, Some(scanned)) = (a.color, pipeline.scanned()) {
            legend = scan_on(&mut scene, &scanned, &job);
        }
        (scene, legend, planned.part.mesh.bounds())
    } else {
        let built =
            files::build_part(&source, &job.part, &file, &Progress::default()).map_err(CommandFailure::failed)?;
        // Nobody can have cancelled it.
        let part = built.unwrap_or_default();
        let surfaces = segmented(&part, &job);
        let item = PartPicture::new(&part, &surfaces, None).item(&surfaces, &PartLook::default());
        (Scene { meshes: vec![item], ..Scene::default() }, None, part.mesh.bounds())
    };
    let gl = HeadlessGl::new().map_err(CommandFailure::failed)?;
    let drawn = still(&gl, &scene, Bounds { min, max }, (a.view, a.size));
    let mut image = drawn.map_err(CommandFailure::failed)?;
    if let Some(legend) = &legend {
        super::legend::paint(&mut image, legend);
    }
    files::write_atomic(
        &a.out,
        &png(&image).map_err(|e| CommandFailure::Failed(say!(picture_not_packed, reason = e.to_string())))?,
    )
    .map_err(CommandFailure::failed)?;
    print(&format!("{}\n", say!(cli_wrote, file = a.out.display().to_string())));
    Ok(CommandOutcome::Done)
}

/// The part with its lines, or with what lands on it.
fn planned_scene(planned: &PlannedJob, color: Color) -> Result<(Scene, Option<Legend>), CommandFailure> {
    let Color::Dose(look) = color else { return Ok((part_with_lines(planned).0, None)) };
    let PlannedJob { part, surfaces, plan, job, setup, .. } = planned;
    let map = planning::dose(part, surfaces, plan, job, setup, &Progress::default()).map_err(CommandFailure::failed)?;
    let edges = PartPicture::new(part, surfaces, None).item(surfaces, &PartLook::default()).edges;
    let item = MeshItem { edges, ..dose_item(&map, surfaces, look) };
    Ok((Scene { meshes: vec![item], ..Scene::default() }, Some(legend(&map, look))))
}

/// Puts the points of a scan on the part, in colours of how far they are off it.
fn scan_on(scene: &mut Scene, scanned: &Scanned, job: &Job) -> Option<Legend> {
    let (laid, compared) = (scanned.laid.as_ref()?, scanned.compared.as_ref()?);
    let scale = deviation_scale(compared, &job.scan);
    scene.clouds.push(deviation_points(laid, compared, scale));
    Some(scale.legend())
}
