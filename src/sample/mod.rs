//! The sample parts of the papers, made from formulas, closed-form solids for tests and benches, scans of either, and
//! the images of a welded panel.
//!
//! P1 to P3 show a test workpiece, a worm gear, a connecting rod, a front shaft, an acetabular cup
//! and a worn camshaft, but give no files. These are parts of the same kinds with dimensions of our own, so that
//! every claim of the papers (the crater beside the plate, the tooth gaps) can be tried. All are
//! closed skins that weld exactly, except the cup, which is an open sheet. P4's images are those of a scene,
//! [`weld_panel`]. Nothing here reads files, and nothing of the planner is used. Same bytes on every machine: `libm`
//! only, no hashing.

mod cam_lobe;
pub mod camshaft;
pub mod camshaft_scan;
#[cfg(test)]
mod check;
mod connecting_rod;
mod cup;
mod fixed_numbers;
mod folds;
mod front_shaft;
mod gear_solid;
mod grooves;
mod outline;
mod plate;
pub mod scan_maker;
mod shell;
pub mod solids;
mod tooth_gap;
mod turning;
pub mod weld_panel;
mod workpiece;
mod worm_gear;

pub use fixed_numbers::FixedNumbers;
pub use shell::Triangles;
use stl_io::{Normal, Triangle, Vertex};

/// The sample parts by kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SamplePart {
    /// The test workpiece of P1 (Fig. 2d).
    Workpiece,
    /// The worm gear of P1 (Fig. 2a, 7, 8).
    WormGear,
    /// The acetabular cup of P2.
    AcetabularCup,
    /// The connecting rod of P1 (Fig. 2c).
    ConnectingRod,
    /// The front shaft of P1 (Fig. 2b).
    FrontShaft,
    /// The camshaft of P3.
    Camshaft,
}

/// A sample part.
#[derive(Clone, Copy, Debug)]
pub struct ShippedSample {
    /// The file's name without `.stl`.
    pub name: &'static str,
    /// Which one it is.
    pub part: SamplePart,
    /// Makes its facets, mm.
    pub triangles: fn() -> Triangles,
}

/// All sample parts.
pub const SAMPLES: [ShippedSample; 6] = [
    ShippedSample { name: "workpiece", part: SamplePart::Workpiece, triangles: workpiece::triangles },
    ShippedSample { name: "worm_gear", part: SamplePart::WormGear, triangles: worm_gear::triangles },
    ShippedSample { name: "acetabular_cup", part: SamplePart::AcetabularCup, triangles: cup::triangles },
    ShippedSample { name: "connecting_rod", part: SamplePart::ConnectingRod, triangles: connecting_rod::triangles },
    ShippedSample { name: "front_shaft", part: SamplePart::FrontShaft, triangles: front_shaft::triangles },
    ShippedSample { name: "camshaft", part: SamplePart::Camshaft, triangles: camshaft::triangles },
];

/// Binary STL. Corners are exact (they are f32 already); normals are computed from them.
pub fn stl_bytes(triangles: &Triangles) -> Vec<u8> {
    let facets: Vec<Triangle> = triangles
        .iter()
        .map(|t| Triangle {
            normal: Normal::new(unit_normal(t)),
            vertices: t.map(|p| Vertex::new(p.map(|x| x as f32))),
        })
        .collect();
    let mut bytes = Vec::with_capacity(84 + 50 * facets.len());
    match stl_io::write_stl(&mut bytes, facets.iter()) {
        Ok(()) => bytes,
        // A Vec takes every write, so stl_io has nothing to fail on.
        Err(error) => unreachable!("writing to memory failed: {error}"),
    }
}

/// The unit normal of a facet; zero if it has no area.
fn unit_normal([a, b, c]: &[[f64; 3]; 3]) -> [f32; 3] {
    let [u, v] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
    if length > 0.0 { n.map(|x| (x / length) as f32) } else { [0.0; 3] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sample_but_the_cup_is_watertight() {
        for sample in SAMPLES.iter().filter(|s| s.name != "acetabular_cup") {
            let skin = check::closed(sample.name, &(sample.triangles)());
            println!("{}: {skin:?}", sample.name);
        }
    }

    #[test]
    fn bytes_are_binary_stl_and_always_the_same() {
        for sample in SAMPLES {
            let triangles = (sample.triangles)();
            let bytes = stl_bytes(&triangles);
            assert_eq!(bytes.len(), 84 + 50 * triangles.len(), "{}", sample.name);
            assert!(!bytes.starts_with(b"solid"));
            assert_eq!(bytes, stl_bytes(&(sample.triangles)()));
            let read = stl_io::read_stl(&mut std::io::Cursor::new(&bytes)).expect("reads back");
            assert_eq!(read.faces.len(), triangles.len());
        }
    }
}
