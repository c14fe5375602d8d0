//! What an operator waits for at the real window, painted by software OpenGL without a screen: frames while a camera
//! moves, alone and beside a plan that is being made, and edits by the mouse on a helical gear, from the first
//! changed number to the first changed picture, and from the last one until all that is shown is current.
//!
//! `cargo bench --bench window`, or with numbers of thousands of facets behind it (`100`, `1000`): those gears alone; with
//! `drawing`: facets alone.

#[path = "../tests/common/glow_renderer.rs"]
mod glow_renderer;
#[path = "../tests/common/window.rs"]
mod window;

use clearbeam::app::{App, Command};
use clearbeam::sample::solids::{helical_gear, sphere};
use clearbeam::sample::{Triangles, stl_bytes};
use clearbeam::view::{Bounds, Camera, Detail, MeshItem, Renderer, Scene, ViewSize};
use eframe::egui::{PointerButton, Pos2, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use nalgebra::{Isometry3, Point3};
use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

type Failure = Box<dyn std::error::Error>;

/// Frames of each camera move.
const FRAMES: usize = 40;

fn main() -> Result<(), Failure> {
    let wanted: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with("--")).collect();
    type Gear = (&'static str, fn() -> Triangles);
    let gears: [Gear; 2] = [("100", || helical_gear(40, 8, 15, 4)), ("1000", || helical_gear(40, 24, 54, 11))];
    if wanted.is_empty() || wanted.iter().any(|w| w == "drawing") {
        of_drawing()?;
    }
    for (_, made) in gears.into_iter().filter(|(name, _)| wanted.is_empty() || wanted.iter().any(|w| w == name)) {
        let triangles = made();
        println!("gear of {} facets", triangles.len());
        let folder = tempfile::tempdir()?;
        std::fs::write(folder.path().join("gear.stl"), stl_bytes(&triangles))?;
        of_camera(folder.path())?;
        of_edits(folder.path())?;
        println!("  memory: {:.0} MB at most", peak_mb());
    }
    Ok(())
}

/// Facets alone, in a picture of 1440 × 900: whole, and as a moving camera sees them.
fn of_drawing() -> Result<(), Failure> {
    let gl = glow_renderer::thread_gl();
    let mut renderer = Renderer::new(gl.gl())?;
    for (round, high) in [(300, 80), (450, 112), (1000, 500)] {
        let triangles = sphere(50.0, round, high);
        let facets = triangles.len();
        let mesh = MeshItem {
            geometry_key: facets as u64,
            positions: Arc::new(triangles.into_iter().flatten().map(|at| at.map(|x| x as f32)).collect()),
            colors_key: 0,
            facet_colors: Arc::new(vec![[120, 160, 200, 255]; facets]),
            edges: None,
            scene_from_item: Isometry3::identity(),
        };
        let scene = Scene { meshes: vec![mesh], ..Scene::default() };
        let size_px = [1440, 900];
        let bounds = Bounds { min: Point3::new(-50.0, -50.0, -50.0), max: Point3::new(50.0, 50.0, 50.0) };
        let mut camera = Camera::fitted(bounds, ViewSize::new(1440.0, 900.0));
        let started = Instant::now();
        renderer.draw(&scene, &camera, size_px)?;
        let first = started.elapsed();
        let mut taken = [false, true].map(|thinned| (thinned, Duration::ZERO));
        for (thinned, taken) in &mut taken {
            for turn in 0..11 {
                camera.orbit(5.0, 1.0);
                let started = Instant::now();
                renderer.draw_in_detail(&scene, &camera, size_px, Detail { px_per_point: 1.0, thinned: *thinned })?;
                // Without it the picture may not be there yet. SAFETY: the context is current on this thread.
                unsafe { egui_glow::glow::HasContext::finish(&*gl.gl()) };
                *taken += if turn == 0 { Duration::ZERO } else { started.elapsed() / 10 };
            }
        }
        let [whole, moving] = taken.map(|(_, taken)| ms(taken));
        println!("{facets:9} facets drawn: at first {:.0} ms, again {whole:.0} ms, moving {moving:.0} ms", ms(first));
    }
    Ok(())
}

fn job(folder: &Path, spacing_mm: f64, surfaces: &str) -> Result<std::path::PathBuf, Failure> {
    let path = folder.join("job.toml");
    let text = format!("[part]\nfile = \"gear.stl\"\n[clean]\n{surfaces}\n[layers]\nspacing_mm = {spacing_mm}\n");
    std::fs::write(&path, text)?;
    Ok(path)
}

/// A frame as the operator gets it: everything laid out, tessellated and painted; and how long it took.
fn frame(h: &mut Harness<'static, App>) -> Result<(Duration, image::RgbaImage), Failure> {
    let started = Instant::now();
    h.step();
    let picture = h.render()?;
    Ok((started.elapsed(), picture))
}

/// The camera is turned by the mouse: on the part alone, beside a plan that is being made, and with its lines.
fn of_camera(folder: &Path) -> Result<(), Failure> {
    let mut h = window::window(Some(job(folder, 4.0, "surfaces = []")?), &window::Answers::default());
    turned(&mut h, "part alone")?;
    let all = h.state().surfaces();
    h.state_mut().give(Command::Clean, &all);
    turned(&mut h, "while a plan is made")?;
    let was_over = h.state().is_settled();
    println!("    (the plan was {})", if was_over { "over before that" } else { "still being made" });
    rest(&mut h);
    turned(&mut h, "with the lines of its plan")
}

fn turned(h: &mut Harness<'static, App>, what: &str) -> Result<(), Failure> {
    let at = Pos2::new(640.0, 400.0);
    h.hover_at(at);
    frame(h)?;
    h.event(pressed(at, true));
    let mut taken: Vec<Duration> = Vec::with_capacity(FRAMES);
    for i in 0..FRAMES {
        h.hover_at(at + Vec2::new(3.0 * i as f32, 0.5 * i as f32));
        taken.push(frame(h)?.0);
    }
    h.event(pressed(at, false));
    frame(h)?;
    let mut whole = Duration::ZERO;
    // More than the time after which a camera counts as at rest, in steps of a sixtieth of a second.
    for _ in 0..20 {
        whole = whole.max(frame(h)?.0);
    }
    let (at_rest, _) = frame(h)?;
    taken.sort_unstable();
    let [middle, worst] = [taken[FRAMES / 2], taken[FRAMES - 1]].map(ms);
    println!(
        "  {what:28} {middle:6.0} ms a frame, {worst:.0} at most; the whole picture {:.0} ms, a frame at rest {:.0} ms",
        ms(whole),
        ms(at_rest)
    );
    Ok(())
}

fn pressed(pos: Pos2, pressed: bool) -> eframe::egui::Event {
    let (button, modifiers) = (PointerButton::Middle, Default::default());
    eframe::egui::Event::PointerButton { pos, button, pressed, modifiers }
}

/// Fields are dragged.
fn of_edits(folder: &Path) -> Result<(), Failure> {
    let mut h = window::window(Some(job(folder, 4.0, "surfaces = \"all\"")?), &window::Answers::default());
    rest(&mut h);
    for label in ["Crease angle", "Spacing", "Defocus distance"] {
        window::bring(&mut h, label);
        rest(&mut h);
        let at = h.get_by_label(label).rect().center();
        let values = |h: &Harness<'static, App>| {
            let job = h.state().document().job();
            [job.surfaces.angle_deg, job.layers.spacing_mm, job.beam.defocus_mm]
        };
        let from = values(&h);
        let before = h.render()?;
        h.hover_at(at);
        frame(&mut h)?;
        h.drag_at(at);
        frame(&mut h)?;
        let (started, mut first, mut worst) = (Instant::now(), None, Duration::ZERO);
        for i in 1..=12 {
            h.hover_at(at + Vec2::new(4.0 * i as f32, 0.0));
            let (taken, picture) = frame(&mut h)?;
            worst = worst.max(taken);
            if first.is_none() && view(&picture) != view(&before) {
                first = Some(started.elapsed());
            }
        }
        h.drop_at(at + Vec2::new(48.0, 0.0));
        let dropped = Instant::now();
        let mut planned = None;
        while !h.state().is_settled() {
            let (taken, picture) = frame(&mut h)?;
            worst = worst.max(taken);
            if first.is_none() && view(&picture) != view(&before) {
                first = Some(started.elapsed());
            }
            planned = planned.or(h.state().plan().map(|_| dropped.elapsed()));
            if planned.is_none() {
                // So often progress is shown while something is computed.
                std::thread::sleep(Duration::from_millis(100).saturating_sub(taken));
            }
        }
        println!(
            "  {label:28} first other picture after {:6.0} ms; after the last number its plan {:6.0} ms, all of it {:6.0} ms; \
             longest frame {:.0}",
            first.map_or(f64::NAN, ms),
            planned.map_or(f64::NAN, ms),
            ms(dropped.elapsed()),
            ms(worst)
        );
        println!("    {from:?} became {:?}", values(&h));
    }
    Ok(())
}

/// The middle of the view, free of panels and legends.
fn view(picture: &image::RgbaImage) -> Vec<u8> {
    image::imageops::crop_imm(picture, 480, 250, 320, 300).to_image().into_raw()
}

/// Frames until all that is shown is current.
fn rest(h: &mut Harness<'static, App>) {
    let until = Instant::now() + Duration::from_secs(300);
    while !h.state().is_settled() && Instant::now() < until {
        h.step();
        std::thread::sleep(Duration::from_millis(5));
    }
    h.run_steps(8);
}

fn ms(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

/// The most memory that this process ever had, MB; 0 where the system does not tell.
fn peak_mb() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|rest| rest.trim().strip_suffix(" kB")?.trim().parse::<f64>().ok()).unwrap_or(0.0) / 1024.0
}
