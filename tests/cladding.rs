//! Beads in layers: each on the part as those before have made it, proven on that part, and read back.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::document::{Job, files, segmented};
use clearbeam::part::{SurfaceId, angle};
use clearbeam::path::AxisSource;
use clearbeam::planning::proof::prover;
use clearbeam::planning::report::Report;
use clearbeam::planning::{Plan, PlanCache, PlanError, export, verify};
use clearbeam::pose::Correction;
use clearbeam::program::{ProgramLine, lines};
use clearbeam::progress::Progress;
use clearbeam::sample::{Triangles, solids};
use clearbeam::text::program_comment;
use nalgebra::Vector3;
use parts::{Case, setup};
use std::path::PathBuf;
use std::sync::Arc;

impl Case {
    /// A solid of which the surface that looks along `n` is clad with beads of 2 × 0.5 mm.
    fn clad(solid: &Triangles, n: [f64; 3], layers: u32) -> Case {
        let part = parts::part(solid);
        let mut job = Job::default();
        let surfaces = segmented(&part, &job);
        let off = |f: u32| (part.mesh.normals[f as usize] - Vector3::from(n)).norm();
        let chosen = surfaces.list.iter().find(|s| s.facets.iter().any(|&f| off(f) < 0.1)).expect("a surface").number;
        job.settings.choose(vec![chosen]);
        job.layers.direction = "x".parse().expect("a direction");
        (job.bead.width_mm, job.bead.height_mm, job.bead.layers) = (2.0, 0.5, layers);
        job.layers.spacing_mm = job.bead_spacing_mm().expect("a bead");
        Case { part, surfaces, job, setup: setup() }
    }

    /// Plans it with what is known already.
    fn plan_knowing(&self, cache: &PlanCache) -> Result<Plan, PlanError> {
        self.plan_with(cache, &Progress::default())
    }

    /// The program, written and verified by the reader with the second opinion.
    fn verified(&self, plan: &Plan) -> verify::Verdict {
        let report = Report::new(plan, &self.surfaces);
        let files =
            export::program(&self.job, "part.stl", &self.setup, plan, &report, program_comment).expect("writes");
        let open = |name: &str| files.iter().find(|f| f.name == name).map(|f| f.text.clone());
        verify::check(&self.part, plan, &self.setup, &self.job, &files[0], &open, true).expect("reads").1
    }
}

#[test]
fn layers_rise_by_the_bead_and_are_proven_where_they_lie() {
    let mut case = Case::clad(&solids::cube(10.0), [0.0, 0.0, 1.0], 3);
    case.job.bead.alternate = true;
    let plan = case.plan();
    let report = Report::new(&plan, &case.surfaces);
    assert_eq!((report.layers, plan.grown.len(), plan.surfaces.len(), report.surfaces.len()), (3, 3, 3, 1));
    assert_eq!(report.surfaces[0].passes, plan.passes.len());
    assert!((plan.grown[2].part.mesh.bounds().1.z - 11.5).abs() < 1e-9, "what connecting moves keep clear of");
    assert!((report.surfaces[0].work_mm - report.work_mm).abs() < 1e-9);
    let layers: Vec<u32> = plan.passes.iter().map(|p| p.settings.layer).collect();
    assert!(layers.is_sorted() && layers.contains(&2));
    for pass in &plan.passes {
        let z = 10.0 + 0.5 * f64::from(pass.settings.layer);
        assert!(pass.targets.iter().all(|t| (t.p.z - z).abs() < 1e-9), "each on top of the one before");
        // Every second layer runs across.
        let m = if pass.settings.layer == 1 { pass.plane_normal.y } else { pass.plane_normal.x };
        assert!((m.abs() - 1.0).abs() < 1e-9);
    }
    let proof = plan.proof.as_ref().expect("a proof");
    assert!(proof.lit_moves > 10 && proof.proven == proof.lit_moves, "{proof:?}");
    let verdict = case.verified(&plan);
    assert_eq!(verdict.findings, []);
    assert_eq!(verdict.proof.proven, verdict.lit_moves);
    let lines = lines(&plan.steps, &case.setup);
    let comments: Vec<String> = lines
        .iter()
        .filter_map(|l| if let ProgramLine::Comment(comment) = l { Some(program_comment(comment)) } else { None })
        .collect();
    let said = |text: &str| comments.iter().any(|c| c.ends_with(text));
    assert!(said("layer 2") && said("layer 3") && !said("layer 1"));
}

#[test]
fn a_move_below_the_metal_of_its_layer_is_refuted() {
    let case = Case::clad(&solids::cube(10.0), [0.0, 0.0, 1.0], 3);
    let plan = case.plan();
    let moves = plan.steps.lit_moves(&case.setup.mounted());
    let prover = prover(&case.part, &case.setup, &case.job).on_layers(&plan.grown);
    let first = *moves.iter().find(|m| m.settings.layer == 0).expect("the first layer");
    let hits = |m| prover.hit(m).expect("nobody cancels").is_some();
    assert!(!hits(&first));
    let mut buried = first;
    buried.settings.layer = 2;
    assert!(hits(&buried), "1 mm of metal lies on that line by then");
}

#[test]
fn closed_lines_begin_elsewhere_in_each_layer() {
    let mut case = Case::clad(&solids::cylinder(15.0, 12.0, 120), [1.0, 0.0, 0.0], 3);
    case.job.layers.direction = "z".parse().expect("a direction");
    let start = |plan: &Plan, layer: u32| {
        let lowest = plan
            .passes
            .iter()
            .filter(|p| p.settings.layer == layer)
            .min_by(|a, b| a.targets[0].p.z.total_cmp(&b.targets[0].p.z));
        lowest.expect("a pass").targets[0].p
    };
    let turned_deg = |plan: &Plan| {
        let flat = |layer| Vector3::new(start(plan, layer).x, start(plan, layer).y, 0.0);
        [angle::between_deg(&flat(0), &flat(1)), angle::between_deg(&flat(0), &flat(2))]
    };
    let [one, two] = turned_deg(&case.plan());
    assert!(one < 1e-6 && two < 1e-6, "at one place without a shift: {one} {two}");
    case.job.bead.start_shift_mm = 4.0;
    let [one, two] = turned_deg(&case.plan());
    // Radii 15.5 and 16 mm; on a prism of 120 sides arc and side hardly differ.
    for (found, exact) in [(one, (4.0f64 / 15.5).to_degrees()), (two, (8.0f64 / 16.0).to_degrees())] {
        assert!((found - exact).abs() < 0.05, "{found} instead of {exact}");
    }
}

#[test]
fn a_bore_that_would_close_is_refused() {
    let mut case = Case::clad(&solids::cylinder(3.0, 12.0, 60), [1.0, 0.0, 0.0], 4);
    let flipped = case.job.chosen(&case.surfaces);
    case.job.settings.change(SurfaceId(flipped[0]), |s| s.flipped = true);
    case.surfaces = segmented(&case.part, &case.job);
    case.job.path.correction = Correction::None;
    assert!(case.plan_knowing(&PlanCache::default()).is_ok(), "2 of 3 mm");
    case.job.bead.layers = 9;
    let refused = case.plan_knowing(&PlanCache::default()).expect_err("4.5 of 3 mm");
    let PlanError::Folds { surface, layers } = refused else { panic!("{refused}") };
    assert_eq!((surface, layers), (flipped[0], 6), "3 mm");
}

#[test]
fn another_layer_leaves_those_below_as_they_are() {
    let mut case = Case::clad(&solids::cube(10.0), [0.0, 0.0, 1.0], 2);
    let cache = PlanCache::default();
    let two = case.plan_knowing(&cache).expect("plans");
    case.job.bead.layers = 3;
    let three = case.plan_knowing(&cache).expect("plans");
    assert_eq!((two.surfaces.len(), three.surfaces.len()), (2, 3));
    assert!(two.surfaces.iter().zip(&three.surfaces).all(|(a, b)| Arc::ptr_eq(a, b)));
    let fresh = case.plan();
    assert!(fresh.passes == three.passes && fresh.steps == three.steps, "and nothing depends on the cache");
    case.job.bead = Default::default();
    let bare = case.plan_knowing(&cache).expect("plans");
    assert!(bare.grown.is_empty() && bare.passes.iter().all(|p| p.settings.layer == 0));
}

#[test]
fn a_robot_lays_layers_too() {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("assets/samples/workpiece.toml");
    let mut job = files::read(&file).expect("reads");
    job.settings.choose(vec![3]);
    job.cell.robot = "mz04".into();
    (job.bead.width_mm, job.bead.height_mm, job.bead.layers) = (3.0, 0.6, 2);
    job.layers.spacing_mm = job.bead_spacing_mm().expect("a bead");
    let part = files::load_part(&job, Some(&file)).expect("loads");
    let setup = files::load_setup(&job, Some(&file)).expect("a cell");
    let surfaces = segmented(&part, &job);
    let case = Case { part, surfaces, job, setup };
    let plan = case.plan();
    let report = Report::new(&plan, &case.surfaces);
    assert_eq!((report.layers, report.proven), (2, true), "{:?}", report.problems);
    assert!(plan.passes.iter().filter(|p| p.settings.layer == 1).any(|p| p.targets.iter().any(|t| t.laser)));
    assert_eq!(case.verified(&plan).findings, []);
}

#[test]
fn axes_from_neighbours_stand_on_the_cup_as_its_radii_do() {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("assets/samples/acetabular_cup.toml");
    let mut job = files::read(&file).expect("reads");
    (job.layers.spacing_mm, job.path.axis) = (1.0, AxisSource::Neighbours);
    (job.path.chord_error_mm, job.path.max_turn_deg) = (0.02, 5.0);
    let part = files::load_part(&job, Some(&file)).expect("loads");
    let setup = files::load_setup(&job, Some(&file)).expect("a cell");
    let surfaces = segmented(&part, &job);
    let case = Case { part, surfaces, job, setup };
    let plan = case.plan();
    let centre = Vector3::new(0.0, 0.0, 5.0);
    // On the sphere, away from skirt, pole and the ends' single neighbours.
    let on_sphere = plan.passes.iter().flat_map(|p| &p.targets).filter(|t| (7.0..24.0).contains(&t.p.z));
    let worst = on_sphere.map(|t| angle::between_deg(&t.n, &(t.p.coords - centre))).fold(0.0, f64::max);
    // Facets of 4.7 by 4.2 degrees are what the lines know of the sphere.
    assert!(worst < 2.5, "{worst}");
    assert_eq!(case.verified(&plan).findings, []);
}

#[test]
fn a_least_tilt_lets_nothing_return_into_the_head() {
    let mut case = Case::clad(&solids::cube(10.0), [0.0, 0.0, 1.0], 2);
    case.job.path.correction = Correction::Clearance;
    let surface = SurfaceId(case.job.chosen(&case.surfaces)[0]);
    case.job.settings.change(surface, |s| s.tilt.least_deg = 5.0);
    let plan = case.plan();
    let tilts: Vec<f64> = plan.passes.iter().flat_map(|p| &p.targets).map(|t| t.tilt_deg()).collect();
    assert!(tilts.iter().all(|deg| (deg - 5.0).abs() < 1e-6), "{tilts:?}");
    assert_eq!(case.verified(&plan).findings, []);
}

#[test]
fn the_readme_tells_a_job_that_can_be_planned() {
    let reference = include_str!("../docs/reference.md");
    let (_, rest) = reference.split_once("## Cladding").expect("a section");
    let text = rest.split_once("```toml\n").and_then(|(_, t)| t.split_once("```")).expect("a job").0;
    let job: Job = toml::from_str(text).expect("reads");
    job.check().expect("sound");
    assert_eq!(job.layer_count(), 3);
    let spacing_mm = job.bead_spacing_mm().expect("a bead");
    assert!((spacing_mm - job.layers.spacing_mm).abs() < 1e-3, "{spacing_mm}");
}
