//! The shipped scan of a camshaft as a part, held against the part that it was made of.

use super::*;
use crate::part::raw_part::RawPart;
use crate::part::{Part, Placement, Source, Units, Weld};
use crate::scan::{file, transform_file};
use nalgebra::Vector3;

const SCAN: &[u8] = include_bytes!("../../../assets/samples/camshaft_scan.ply");
const MODEL: &[u8] = include_bytes!("../../../assets/samples/camshaft.stl");
const TRUTH: &str = include_str!("../../../assets/samples/camshaft_truth.json");
const NOISE_MM: f64 = 0.03;

/// The scan where it was taken from the model.
fn scan() -> Cloud {
    let cloud = file::from_bytes("camshaft_scan.ply", SCAN, &Progress::default()).expect("reads").cloud;
    let truth: serde_json::Value = serde_json::from_str(TRUTH).expect("JSON");
    let numbers = truth["model_from_scan"].as_array().expect("a list").iter();
    let rows: Vec<f64> = numbers.map(|x| x.as_f64().expect("a number")).collect();
    cloud.moved(&transform_file::rigid(&rows.try_into().expect("sixteen")).expect("a motion"))
}

fn part_of(mesh: &ScanMesh) -> Part {
    let raw = RawPart { facets: mesh.facets_f32(), solids: 1, ..RawPart::default() };
    let source = Source { raw, sha256: String::new() };
    let made = source.part(Units::Mm, Weld::default(), &Placement::default(), &[], &Progress::default());
    made.expect("a part").expect("nobody cancels")
}

/// Whether the model is flat or smooth for so far around a point.
fn is_off_edges(model: &Part, p: &Point3<f64>, normal: &Vector3<f64>, within_mm: f64) -> bool {
    let mut smooth = true;
    model.bvh.visit_near(p, within_mm, |facet, _| smooth &= model.mesh.normals[facet as usize].dot(normal) > 0.7);
    smooth
}

/// The mesh lies within the noise of the model where that has no edges and was not worn (0.2 mm deep at most).
#[test]
fn the_scan_of_the_camshaft_becomes_a_part() {
    let mesh = mesh_of(&scan(), &Progress::default()).expect("a surface");
    let part = part_of(&mesh);
    assert_eq!(part.mesh.facets.len(), mesh.facets.len());
    assert_eq!((part.figures.non_manifold_edges, part.figures.degenerate_facets), (0, 0));
    assert_eq!(part.figures.boundary_edges, mesh.rim_edges.len());
    let model = Part::from_bytes(MODEL, Units::Mm, &Placement::default(), &[]).expect("a part");
    let (mut off_edges, mut all, mut facing) = (Vec::new(), Vec::new(), 0);
    for f in 0..part.mesh.facets.len() {
        let middle = part.mesh.centroid(f);
        let closest = model.bvh.closest(&middle, 10.0).expect("near the model");
        let normal = model.mesh.normals[closest.facet as usize];
        facing += usize::from(normal.dot(&part.mesh.normals[f]) > 0.0);
        all.push(closest.distance_mm);
        if is_off_edges(&model, &closest.foot, &normal, 2.0 * mesh.cell_mm) {
            off_edges.push(closest.distance_mm);
        }
    }
    all.sort_by(f64::total_cmp);
    let share = |s: f64| all[(s * (all.len() - 1) as f64) as usize];
    let rms = (off_edges.iter().map(|d| d * d).sum::<f64>() / off_edges.len() as f64).sqrt();
    println!(
        "{} of {} facets off edges: rms {rms} mm; shells {:?}",
        off_edges.len(),
        all.len(),
        part.orientation.shell_of.iter().max()
    );
    assert!(rms < NOISE_MM, "{rms}");
    // What overhangs at a rim, is rounded at an edge or cuts a bend short: 0.11 and 0.28 cells were found.
    assert!(share(0.9) < 0.15 * mesh.cell_mm && share(0.99) < 0.4 * mesh.cell_mm, "{} {}", share(0.9), share(0.99));
    assert!(facing as f64 > 0.99 * all.len() as f64, "{facing} of {}", all.len());
}
