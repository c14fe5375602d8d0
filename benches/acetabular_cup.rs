//! P2 reproduced: the acetabular cup from its STL file to a robot program, in the form of P2's Table 4
//! and Fig. 16.
//!
//! `cargo bench --bench acetabular_cup` prints the tables; nothing is compared or asserted here.

use clearbeam::cell::Setup;
use clearbeam::document::{Job, files, segmented};
use clearbeam::part::{Mesh, Part, Surfaces, rpy};
use clearbeam::planning::export::{self, ExportError, ExportInput, ExportOf, ExportOptions};
use clearbeam::planning::report::Report;
use clearbeam::planning::{self, Plan, PlanCache};
use clearbeam::program::{ProgramFile, ProgramLine, lines, spot};
use clearbeam::progress::Progress;
use clearbeam::text::program_comment;
use nalgebra::Isometry3;
use std::path::Path;
use std::time::Instant;

/// The job of the sample holds P2's Table 3.
const JOB: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/samples/acetabular_cup.toml");
/// Planned so often; the quickest counts.
const ROUNDS: usize = 5;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let file = Path::new(JOB);
    let job = files::read(file)?;
    let setup = files::load_setup(&job, Some(file))?;
    let stl = file.with_file_name(&job.part.file);
    let kilobytes = std::fs::metadata(&stl)?.len() / 1000;

    let mut quickest = [f64::INFINITY; 2];
    let mut last = None;
    for _ in 0..ROUNDS {
        let begun = Instant::now();
        let part = files::load_part(&job, Some(file))?;
        let surfaces = segmented(&part, &job);
        let plan = planning::plan(&part, &surfaces, &job, &setup, &PlanCache::default(), &Progress::default())?;
        let report = Report::new(&plan, &surfaces);
        let program = export::program(&job, &job.part.file, &setup, &plan, &report, program_comment)?;
        quickest[0] = quickest[0].min(begun.elapsed().as_secs_f64());
        exported((&job, file), &part, &surfaces, &setup, &plan)?;
        quickest[1] = quickest[1].min(begun.elapsed().as_secs_f64());
        last = Some((part, plan, report, program));
    }
    let Some((part, plan, report, program)) = last else { return Ok(()) };

    println!("STL file {kilobytes} kB (P2: 402 kB)\n");
    topology(&part);
    points(&part, &plan, &report, &job);
    times(quickest, &program);
    angles(&plan, &setup, job.beam.defocus_mm);
    Ok(())
}

/// All files of the plan, in memory.
fn exported(
    (job, file): (&Job, &Path),
    part: &Part,
    surfaces: &Surfaces,
    setup: &Setup,
    plan: &Plan,
) -> Result<(), ExportError> {
    let (wording, options) = (program_comment, ExportOptions { dose: true, ..ExportOptions::default() });
    let input = ExportInput { job, part, surfaces, setup, plan, findings: &[], wording, options, page: None };
    export::files(&input, &ExportOf::new(job, Some(file)), &Progress::default()).map(|_| ())
}

/// Vertices, edges and facets before and behind the reconstruction.
fn topology(part: &Part) {
    let Mesh { vertices, edges, facets, .. } = &part.mesh;
    let corners = 3 * facets.len();
    println!("                          facets   edges  vertices   (P2: facets   edges  vertices)");
    println!("before reconstruction   {:>8}{corners:>8}{corners:>10}   (        3656   10968     10968)", facets.len());
    println!(
        "after reconstruction    {:>8}{:>8}{:>10}   (        3656    5527      1872)",
        facets.len(),
        edges.len(),
        vertices.len()
    );
    println!("V - E + F = {}\n", vertices.len() as i64 - edges.len() as i64 + facets.len() as i64);
}

/// Points before and behind the arch height reduction, circle by circle.
fn points(part: &Part, plan: &Plan, report: &Report, job: &Job) {
    let error_mm = job.path.chord_error_mm;
    println!("arch height error {error_mm} mm, spacing {} mm, D {} mm", job.layers.spacing_mm, job.beam.defocus_mm);
    println!("pass       z  radius  section  dense  targets  chords  least chords on the circle  sag mm");
    let lowest = part.mesh.bounds().0.z;
    let (mut chords, mut least) = (0, 0);
    for (number, pass) in plan.passes.iter().enumerate() {
        let Some(first) = pass.targets.first() else { continue };
        let radius_mm = libm::hypot(first.p.x, first.p.y);
        let best = (std::f64::consts::PI / libm::acos(1.0 - error_mm / radius_mm)).ceil() as usize;
        let own = pass.targets.len() - 1;
        (chords, least) = (chords + own, least + best);
        println!(
            "{number:>4}{:>8.2}{radius_mm:>8.2}{:>9}{:>7}{:>9}{own:>8}{best:>28}{:>8.3}",
            first.p.z - lowest,
            pass.line_points,
            pass.dense_points,
            pass.targets.len(),
            pass.chord_error_mm
        );
    }
    let ratio = |count: usize, of: usize| 100.0 * count as f64 / of as f64;
    println!("direct points           {:>5}   (P2: 850)", report.line_points);
    println!(
        "simplified points       {chords:>5}   (P2: 74); least on circles {least}; {} with the closing ones",
        report.points
    );
    println!("ratio                   {:>5.1} % (P2: 8.7 %)", ratio(chords, report.line_points));
    println!(
        "dense line              {:>5}   of which {:.1} % are kept\n",
        report.dense_points,
        ratio(report.points, report.dense_points)
    );
}

/// The quickest of all rounds.
fn times([program_s, all_s]: [f64; 2], program: &[ProgramFile]) {
    let moves: usize = program.iter().map(|f| f.text.lines().filter(|l| l.starts_with("MOVEX")).count()).sum();
    println!("from the STL to the program   {program_s:>7.3} s (P2: less than 30 s; teaching: more than two hours)");
    println!("with dose, report, read back  {all_s:>7.3} s");
    println!("moves of the program          {moves:>5}\n");
}

/// Pose angles as P2's Eqs 4 to 9 have them: of `[n o a]` transposed, the part's rotation under a laser that
/// points down, at every twentieth of a pass's length as the program goes.
fn angles(plan: &Plan, setup: &Setup, defocus_mm: f64) {
    let lines = lines(&plan.steps, setup);
    println!("pass,share,alpha_deg,beta_deg,gamma_deg");
    let mut pass = None;
    let mut runs: Vec<(usize, Vec<Isometry3<f64>>)> = Vec::new();
    for line in &lines {
        let ProgramLine::Move(m) = line else { continue };
        let began = m.target.map(|t| t.0).filter(|t| Some(*t) != pass);
        match (m.part_from_focus, began) {
            (Some(frame), Some(number)) => runs.push((number, vec![frame])),
            (Some(frame), None) if m.lit => runs.last_mut().into_iter().for_each(|r| r.1.push(frame)),
            _ => {}
        }
        pass = began.or(pass);
    }
    for (number, frames) in &runs {
        let spots: Vec<_> = frames.iter().map(|f| spot::planned_spot(f, defocus_mm)).collect();
        let mut along_mm = vec![0.0];
        for w in spots.windows(2) {
            along_mm.push(along_mm.last().copied().unwrap_or(0.0) + (w[1] - w[0]).norm());
        }
        let (Some(whole_mm), Some(last)) = (along_mm.last(), frames.len().checked_sub(2)) else { continue };
        let mut range = [(f64::INFINITY, f64::NEG_INFINITY); 3];
        for twentieth in 0..=20 {
            let share = f64::from(twentieth) / 20.0;
            let from = along_mm.partition_point(|mm| *mm <= share * whole_mm).saturating_sub(1).min(last);
            let t = (share * whole_mm - along_mm[from]) / (along_mm[from + 1] - along_mm[from]).max(1e-9);
            let pose = frames[from].lerp_slerp(&frames[from + 1], t.min(1.0));
            let own = rpy::from_rotation(&pose.rotation.inverse().to_rotation_matrix());
            for (r, a) in range.iter_mut().zip(own) {
                *r = (r.0.min(a), r.1.max(a));
            }
            let [alpha, beta, gamma] = own.map(|a| (a * 10.0).round() / 10.0 + 0.0);
            println!("{number},{share:.2},{alpha:.1},{beta:.1},{gamma:.1}");
        }
        let [a, b, c] = range.map(|(low, high)| format!("{low:.0} to {high:.0}"));
        println!("# pass {number}: alpha {a}, beta {b}, gamma {c} degrees");
    }
    println!("# P2: alpha -180 to 180, beta and gamma -90 to 90 degrees");
}
