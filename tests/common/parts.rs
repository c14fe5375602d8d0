//! Parts and plans for the tests that need no window. Nothing here touches OpenGL.
#![allow(dead_code, reason = "each test file uses its own share")]

use clearbeam::beam::{Head, Tool};
use clearbeam::cell::{Cell, Setup};
use clearbeam::document::{Chosen, Job, segmented};
use clearbeam::part::distance::point_triangle;
use clearbeam::part::{Part, Placement, Surfaces, Units};
use clearbeam::path::normals::VertexNormals;
use clearbeam::path::section::sections;
use clearbeam::path::{SurfacePlanes, TransversalLine, planes};
use clearbeam::planning::export::{self, ExportInput, ExportOf, ExportOptions, OutputFile};
use clearbeam::planning::report::Report;
use clearbeam::planning::{self, Plan, PlanCache, PlanError};
use clearbeam::pose::checker::Checker;
use clearbeam::pose::{Pass, Target};
use clearbeam::progress::Progress;
use clearbeam::sample::{SAMPLES, Triangles, stl_bytes};
use clearbeam::text::program_comment;
use nalgebra::{Point3, Vector3};

/// A part with its surfaces, a job and the plan of it.
pub struct Planned {
    pub part: Part,
    pub surfaces: Surfaces,
    pub job: Job,
    pub plan: Plan,
}

/// What a plan is made of.
pub struct Case {
    pub part: Part,
    pub surfaces: Surfaces,
    pub job: Job,
    pub setup: Setup,
}

impl Case {
    /// Plans it with what is known already.
    pub fn plan_with(&self, cache: &PlanCache, progress: &Progress) -> Result<Plan, PlanError> {
        planning::plan(&self.part, &self.surfaces, &self.job, &self.setup, cache, progress)
    }

    /// Plans it afresh.
    pub fn plan(&self) -> Plan {
        self.plan_with(&PlanCache::default(), &Progress::default()).expect("a plan")
    }
}

/// The part of these facets, as it is read from their STL file.
pub fn part(triangles: &Triangles) -> Part {
    placed(triangles, &Placement::default())
}

/// The same, placed.
pub fn placed(triangles: &Triangles, placement: &Placement) -> Part {
    Part::from_bytes(&stl_bytes(triangles), Units::Mm, placement, &[]).expect("a readable part")
}

/// The facets of a shipped sample.
pub fn sample(name: &str) -> Triangles {
    (SAMPLES.iter().find(|s| s.name == name).expect("a sample").triangles)()
}

/// A job on all surfaces, with the default of every other parameter.
pub fn job(direction: &str, spacing_mm: f64) -> Job {
    let mut job = Job::default();
    job.settings.choose(Chosen::All);
    job.layers.direction = direction.parse().expect("a direction");
    job.layers.spacing_mm = spacing_mm;
    job
}

/// The job on these surfaces only.
pub fn on(mut job: Job, surfaces: &[u32]) -> Job {
    job.settings.choose(surfaces.to_vec());
    job
}

/// Plans a job without a robot.
pub fn planned(part: Part, job: Job) -> Planned {
    planned_in(part, job, &setup())
}

/// Plans a job in a cell.
pub fn planned_in(part: Part, job: Job, setup: &Setup) -> Planned {
    let surfaces = segmented(&part, &job);
    let plan =
        planning::plan(&part, &surfaces, &job, setup, &PlanCache::default(), &Progress::default()).expect("a plan");
    Planned { part, surfaces, job, plan }
}

/// Plans the surfaces that these points lie on.
pub fn planned_at(triangles: &Triangles, points: &[[f64; 3]], job: Job) -> Planned {
    let part = part(triangles);
    let surfaces = segmented(&part, &job);
    let chosen: Vec<u32> = points.iter().map(|p| surface_at(&part, &surfaces, *p)).collect();
    planned(part, on(job, &chosen))
}

/// Number of the surface that a point lies on.
pub fn surface_at(part: &Part, surfaces: &Surfaces, point: [f64; 3]) -> u32 {
    let p = Point3::from(point);
    let off = |f: &usize| point_triangle(&p, &part.mesh.corners(*f));
    let facet = (0..part.mesh.facets.len()).min_by(|a, b| off(a).total_cmp(&off(b))).expect("facets");
    surfaces.of_facet[facet]
}

/// The lines of the surface that `at` lies on, before any point is dropped.
pub fn cut(
    triangles: &Triangles,
    at: [f64; 3],
    direction: &str,
    spacing_mm: f64,
) -> (SurfacePlanes, Vec<TransversalLine>) {
    let part = part(triangles);
    let job = job(direction, spacing_mm);
    let surfaces = segmented(&part, &job);
    let number = surface_at(&part, &surfaces, at);
    let surface = surfaces.get(number).expect("there");
    let family = {
        let layout =
            planes::PlaneRaster { surface: number, direction: job.layers.direction, spacing_mm, offset_mm: None };
        planes::planes(&part.mesh, &surfaces, &[layout], &nalgebra::Rotation3::identity()).remove(0)
    };
    let normals = VertexNormals::new(&part.mesh, &surfaces, surface);
    let merge_mm = 1e-6 * part.mesh.diagonal();
    let lines = sections(&part.mesh, surface, &normals, &family.normal, &family.heights_mm, merge_mm);
    (family, lines)
}

/// Length of a line.
pub fn length(line: &TransversalLine) -> f64 {
    let closing = line.closed.then(|| line.points[0]);
    let ring: Vec<_> = line.points.iter().copied().chain(closing).collect();
    ring.windows(2).map(|w| (w[1].p - w[0].p).norm()).sum()
}

/// The cell that is taken without `--cell`.
pub fn cell() -> Cell {
    Cell::shipped("mz04").expect("the shipped cell")
}

/// The shipped cell without a robot.
pub fn setup() -> Setup {
    Setup::shipped().expect("the shipped cell")
}

impl Planned {
    /// All targets, pass by pass.
    pub fn targets(&self) -> impl Iterator<Item = &Target> {
        self.plan.passes.iter().flat_map(|p| &p.targets)
    }

    /// The passes of one surface.
    pub fn passes_of(&self, surface: u32) -> impl Iterator<Item = &Pass> {
        self.plan.passes.iter().filter(move |p| p.surface == surface)
    }

    /// The surface that a point lies on.
    pub fn surface_at(&self, point: [f64; 3]) -> u32 {
        surface_at(&self.part, &self.surfaces, point)
    }

    /// The report.
    pub fn report(&self) -> Report {
        Report::new(&self.plan, &self.surfaces)
    }

    /// The files that `plan` would write.
    pub fn files(&self) -> Vec<OutputFile> {
        self.files_in(&setup())
    }

    /// The same in a cell.
    pub fn files_in(&self, setup: &Setup) -> Vec<OutputFile> {
        let Planned { part, surfaces, job, plan } = self;
        let (wording, options) = (program_comment, ExportOptions::default());
        let input = ExportInput { job, part, surfaces, setup, plan, findings: &[], wording, options, page: None };
        let of = ExportOf { job: "part".into(), part: "part.stl".into() };
        export::files(&input, &of, &Progress::default()).expect("files").0
    }

    /// The second opinion on this part.
    pub fn checker(&self) -> Checker {
        checker(&self.part)
    }
}

/// The second opinion on a part.
pub fn checker(part: &Part) -> Checker {
    Checker::new((0..part.mesh.facets.len()).map(|f| part.mesh.corners(f)))
}

/// A sheet without thickness: a profile (x, z) from left to right, drawn out along y from 0 to
/// `length`; its upper side is the outer one.
pub fn sheet(profile: &[[f64; 2]], length: f64) -> Triangles {
    let mut out = Triangles::new();
    for w in profile.windows(2) {
        let at = |k: usize, y: f64| [w[k][0], y, w[k][1]];
        let [a, b, c, d] = [at(0, 0.0), at(1, 0.0), at(1, length), at(0, length)];
        out.extend([[a, b, c], [a, c, d]]);
    }
    out
}

/// A box from one corner to the other: 12 facets.
pub fn block(low: [f64; 3], high: [f64; 3]) -> Triangles {
    let size: [f64; 3] = std::array::from_fn(|k| high[k] - low[k]);
    let unit = clearbeam::sample::solids::cube(1.0);
    unit.into_iter().map(|t| t.map(|p| std::array::from_fn(|k| low[k] + size[k] * p[k]))).collect()
}

/// A head: a cylinder of this radius, from 20 to 120 mm behind the focus.
pub fn cylinder(radius: f64) -> Tool {
    let text = format!("[[part]]\nfrom_mm = 20\nto_mm = 120\nr0_mm = {radius}\nr1_mm = {radius}\n");
    Tool { head: Some(Head::from_toml(&text).expect("a stack")), ..Tool::default() }
}

/// Perimeter and area of a regular polygon inscribed in a circle.
pub fn polygon(radius: f64, sides: usize) -> (f64, f64) {
    let n = sides as f64;
    let half = std::f64::consts::PI / n;
    (2.0 * n * radius * libm::sin(half), 0.5 * n * radius * radius * libm::sin(2.0 * half))
}

/// Angle between two directions in degrees, from the length of their difference.
pub fn angle_deg(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    2.0 * libm::asin((0.5 * (a.normalize() - b.normalize()).norm()).min(1.0)).to_degrees()
}

/// Fails unless two numbers agree to a share of the second.
pub fn near(what: &str, value: f64, expected: f64, share: f64) {
    assert!((value - expected).abs() <= share * expected.abs(), "{what}: {value} instead of {expected}");
}
