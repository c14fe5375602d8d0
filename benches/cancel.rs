//! How long work goes on after it was cancelled, stage by stage, on a part of a million facets: each stage is begun a
//! few times and cancelled at other moments of the time that it takes. An operator expects an answer within 100 ms.
//!
//! `cargo bench --bench cancel`, or with words of the names of stages behind it: those alone.

use clearbeam::document::{CarriedOver, Chosen, Job, Remembered, segmented};
use clearbeam::part::{Part, Placement, Source, Surfaces, Units, Weld};
use clearbeam::path::strategy::Strategy;
use clearbeam::planning::export::{self, ExportInput, ExportOf, ExportOptions};
use clearbeam::planning::{self, Plan, PlanCache, dose, preview};
use clearbeam::pose::Correction;
use clearbeam::progress::Progress;
use clearbeam::sample::{Triangles, solids, stl_bytes};
use clearbeam::text::program_comment;
use std::fmt::Write as _;
use std::io::{Cursor, Write as _};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// How often each stage is cancelled.
const TRIES: usize = 12;

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let wanted: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with("--")).collect();
    let bench = Bench { wanted };
    let sphere = solids::sphere(50.0, 1000, 500);
    println!("{} facets; tried {TRIES} times each", sphere.len());
    println!("{:28} {:>9} {:>12}", "stage", "takes, ms", "goes on, ms");
    let folder = tempfile::tempdir()?;
    bench.readers(&sphere, folder.path())?;
    let source = Source::from_bytes(&stl_bytes(&sphere))?;
    let torn = Source::from_bytes(&stl_bytes(&a_rounding_apart(&sphere)))?;
    let build = |source: &Source, progress: &Progress| {
        drop(source.part(Units::Mm, Weld::Auto, &Placement::default(), &[], progress));
    };
    bench.stage("build", |progress| build(&source, progress));
    bench.stage("build, all edges open", |progress| build(&torn, progress));
    let part = Part::from_bytes(&stl_bytes(&sphere), Units::Mm, &Placement::default(), &[])?;
    let mut job = Job::default();
    job.settings.choose(Chosen::All);
    (job.layers.spacing_mm, job.layers.direction) = (2.0, "x".parse().map_err(|_| "no direction")?);
    bench.timed("surfaces (window's thread)", || drop(segmented(&part, &job)));
    let surfaces = segmented(&part, &job);
    job.part.landmarks = Remembered::of(&job, &part, &job.part);
    job.part.sha256.clone_from(&part.sha256);
    let moved: Triangles = sphere.iter().map(|t| t.map(|[x, y, z]| [y, -x, z + 7.0])).collect();
    let changed = Source::from_bytes(&stl_bytes(&moved))?;
    bench.stage("carried over", |progress| {
        drop(CarriedOver::to_file(&job, &changed, Path::new("changed.stl"), progress));
    });
    for strategy in Strategy::ALL {
        let mut job = job.clone();
        job.layers.strategy = strategy;
        bench.stage(&format!("lines, {}", strategy.word()), |progress| {
            drop(preview(&part, &surfaces, &job, &PlanCache::default(), progress));
        });
    }
    bench.plans(&part, &surfaces, job)
}

/// The same facets, each corner a rounding beside those of its neighbours.
fn a_rounding_apart(triangles: &Triangles) -> Triangles {
    let off = |facet: usize| 1e-5 * (facet % 7) as f64;
    triangles.iter().enumerate().map(|(f, t)| t.map(|[x, y, z]| [x + off(f), y - off(f + 3), z + off(f + 5)])).collect()
}

struct Bench {
    wanted: Vec<String>,
}

impl Bench {
    fn wants(&self, name: &str) -> bool {
        self.wanted.is_empty() || self.wanted.iter().any(|word| name.contains(word.as_str()))
    }

    fn timed(&self, name: &str, work: impl FnOnce()) {
        if self.wants(name) {
            let begun = Instant::now();
            work();
            println!("{name:28} {:9.0}", begun.elapsed().as_secs_f64() * 1e3);
        }
    }

    fn stage(&self, name: &str, work: impl Fn(&Progress) + Sync) {
        if !self.wants(name) {
            return;
        }
        let begun = Instant::now();
        work(&Progress::default());
        let whole = begun.elapsed();
        let mut worst = (Duration::ZERO, 0.0);
        for k in 0..TRIES {
            // The golden ratio spreads the moments, the same ones each time.
            let share = (0.618_034 * (k + 1) as f64).fract();
            let progress = Progress::default();
            let goes_on = std::thread::scope(|scope| {
                let worker = scope.spawn(|| work(&progress));
                std::thread::sleep(whole.mul_f64(share));
                progress.cancel();
                let cancelled = Instant::now();
                drop(worker.join());
                cancelled.elapsed()
            });
            if goes_on > worst.0 {
                worst = (goes_on, share);
            }
        }
        let (goes_on, share) = worst;
        let [whole, goes_on] = [whole, goes_on].map(|d| d.as_secs_f64() * 1e3);
        println!("{name:28} {whole:9.0} {goes_on:12.1}  at {:.0} %", 100.0 * share);
    }

    fn readers(&self, triangles: &Triangles, folder: &Path) -> Result<(), Failure> {
        let put = |name: &str, bytes: &[u8]| -> Result<PathBuf, Failure> {
            let file = folder.join(name);
            std::fs::write(&file, bytes)?;
            Ok(file)
        };
        let (obj, ply, model) = (obj(triangles)?, ply(triangles)?, model(triangles)?);
        let files = [
            ("read STL, binary", put("a.stl", &stl_bytes(triangles))?),
            ("read STL, text", put("text.stl", stl_text(triangles)?.as_bytes())?),
            ("read OBJ", put("a.obj", obj.as_bytes())?),
            ("read PLY", put("a.ply", ply.as_bytes())?),
            ("read 3MF", put("a.3mf", &archive(&model)?)?),
        ];
        for (name, file) in &files {
            self.stage(name, |progress| drop(Source::read_under(progress, file)));
        }
        Ok(())
    }

    fn plans(&self, part: &Part, surfaces: &Surfaces, mut job: Job) -> Result<(), Failure> {
        let setup = clearbeam::cell::Setup::shipped()?;
        for correction in [Correction::None, Correction::SectionPlane, Correction::Clearance] {
            job.path.correction = correction;
            self.stage(&format!("plan, {correction:?}"), |progress| {
                drop(planning::plan(part, surfaces, &job, &setup, &PlanCache::default(), progress));
            });
        }
        job.path.correction = Correction::None;
        if !["dose", "patches", "ply", "export"].iter().any(|name| self.wants(name)) {
            return Ok(());
        }
        let plan: Plan = planning::plan(part, surfaces, &job, &setup, &PlanCache::default(), &Progress::default())?;
        self.stage("dose", |progress| drop(planning::dose(part, surfaces, &plan, &job, &setup, progress)));
        let map = planning::dose(part, surfaces, &plan, &job, &setup, &Progress::default())?;
        self.stage("patches of the dose", |progress| {
            drop(dose::not_cleanable((part, surfaces), &plan, &job, &map, progress));
        });
        self.stage("ply of the dose", |progress| drop(dose::ply(&map, surfaces, progress)));
        let (wording, options) = (program_comment, ExportOptions::default());
        let input = ExportInput {
            job: &job,
            part,
            surfaces,
            setup: &setup,
            plan: &plan,
            findings: &[],
            wording,
            options,
            page: None,
        };
        let of = ExportOf { job: "part".into(), part: "part.stl".into() };
        self.stage("export", |progress| drop(export::files(&input, &of, progress)));
        Ok(())
    }
}

fn stl_text(triangles: &Triangles) -> Result<String, std::fmt::Error> {
    let mut out = String::from("solid a\n");
    for t in triangles {
        out.push_str("facet normal 0 0 0\nouter loop\n");
        for [x, y, z] in t {
            writeln!(out, "vertex {x:.6} {y:.6} {z:.6}")?;
        }
        out.push_str("endloop\nendfacet\n");
    }
    out.push_str("endsolid a\n");
    Ok(out)
}

fn obj(triangles: &Triangles) -> Result<String, std::fmt::Error> {
    let mut out = String::new();
    for [x, y, z] in triangles.iter().flatten() {
        writeln!(out, "v {x:.6} {y:.6} {z:.6}")?;
    }
    for f in 0..triangles.len() {
        writeln!(out, "f {} {} {}", 3 * f + 1, 3 * f + 2, 3 * f + 3)?;
    }
    Ok(out)
}

fn ply(triangles: &Triangles) -> Result<String, std::fmt::Error> {
    let count = triangles.len();
    let mut out = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {count}\nproperty list uchar int vertex_indices\nend_header\n",
        3 * count
    );
    for [x, y, z] in triangles.iter().flatten() {
        writeln!(out, "{x:.6} {y:.6} {z:.6}")?;
    }
    for f in 0..count {
        writeln!(out, "3 {} {} {}", 3 * f, 3 * f + 1, 3 * f + 2)?;
    }
    Ok(out)
}

/// The model of a 3MF file.
fn model(triangles: &Triangles) -> Result<String, std::fmt::Error> {
    let mut out = String::from(
        "<model xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources><object id=\"1\"><mesh>\
         <vertices>",
    );
    for [x, y, z] in triangles.iter().flatten() {
        write!(out, "<vertex x=\"{x:.3}\" y=\"{y:.3}\" z=\"{z:.3}\"/>")?;
    }
    out.push_str("</vertices><triangles>");
    for f in 0..triangles.len() {
        write!(out, "<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>", 3 * f, 3 * f + 1, 3 * f + 2)?;
    }
    out.push_str("</triangles></mesh></object></resources><build><item objectid=\"1\"/></build></model>");
    Ok(out)
}

fn archive(model: &str) -> Result<Vec<u8>, Failure> {
    const RELATIONSHIPS: &str = "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\
        <Relationship Id=\"a\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\" Target=\"/a.model\"/>\
        </Relationships>";
    let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let options = zip::write::SimpleFileOptions::default().compression_method(zip::CompressionMethod::Deflated);
    for (name, text) in [("_rels/.rels", RELATIONSHIPS), ("a.model", model)] {
        zip.start_file(name, options)?;
        zip.write_all(text.as_bytes())?;
    }
    Ok(zip.finish()?.into_inner())
}
