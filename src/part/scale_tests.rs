//! A part is the same part at every scale: what is told of it is told in its own size, never in millimetres.

use super::inspect::InspectReport;
use super::{Part, Placement, SurfaceRule, Surfaces, Units};
use crate::sample::{Triangles, solids, stl_bytes};
use nalgebra::Vector3;
use proptest::prelude::*;

/// Solids with faults: cracks of a rounding, a facet wound wrongly, one twice, one missing, one without area.
fn faulty(which: usize, at: usize) -> Triangles {
    let mut all = [
        solids::cylinder(20.0, 50.0, 24),
        solids::v_groove(30.0, 8.0, 6.1, 21.3),
        solids::cone(12.0, 30.0, 20),
        solids::sphere(25.0, 12, 7),
    ][which]
        .clone();
    let count = all.len();
    for t in all.iter_mut().step_by(3) {
        // Above the rounding of zeros, which has no digits to spare.
        *t = t.map(|p| p.map(|x| if x.abs() > 1e-3 { f64::from((x as f32).next_up()) } else { x }));
    }
    all[at % count].swap(0, 1);
    all.push(all[(at + 3) % count]);
    let [a, b, _] = all[(at + 7) % count];
    all.push([a, b, a]);
    all.remove((at + 11) % count);
    all
}

fn part(triangles: &Triangles) -> Part {
    Part::from_bytes(&stl_bytes(triangles), Units::Mm, &Placement::default(), &[]).expect("a part")
}

fn rule(scale: f64) -> SurfaceRule {
    SurfaceRule { angle_deg: 20.0, min_area_mm2: 12.0 * scale * scale, hysteresis_deg: 10.0 }
}

fn surfaces(part: &Part, scale: f64) -> Surfaces {
    Surfaces::new(&part.mesh, &part.tree, &part.dihedral_deg, &rule(scale), &[], &[])
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    /// From 1e-20 to 1e20: powers of two, so that nothing is rounded and all figures are the same to the last bit.
    #[test]
    fn a_part_is_the_same_at_every_scale(power in -66..67i32, which in 0..4usize, at in 0..200usize) {
        let scale = libm::ldexp(1.0, power);
        let triangles: Triangles = faulty(which, at).iter().map(|t| t.map(|p| p.map(|x| f64::from(x as f32)))).collect();
        let scaled = triangles.iter().map(|t| t.map(|p| p.map(|x| if x.abs() < 1e-9 { 0.0 } else { x * scale }))).collect();
        let triangles = triangles.iter().map(|t| t.map(|p| p.map(|x| if x.abs() < 1e-9 { 0.0 } else { x }))).collect();
        let (one, two) = (part(&triangles), part(&scaled));
        prop_assert_eq!((&one.mesh.facets, &one.mesh.edges, &one.mesh.defects), (&two.mesh.facets, &two.mesh.edges, &two.mesh.defects));
        prop_assert_eq!((&one.mesh.normals, &one.dihedral_deg), (&two.mesh.normals, &two.dihedral_deg));
        let areas: Vec<f64> = one.mesh.areas.iter().map(|a| a * scale * scale).collect();
        prop_assert_eq!(areas, two.mesh.areas.clone());
        let (a, b) = (surfaces(&one, 1.0), surfaces(&two, scale));
        prop_assert_eq!(&a.of_facet, &b.of_facet);
        let (r, s) = (InspectReport::new(&one, &a, &rule(1.0), 0.0), InspectReport::new(&two, &b, &rule(scale), 0.0));
        prop_assert!(r.joined_corners > 0);
        let counts = |r: &InspectReport| (r.vertices, r.boundary_edges, r.non_manifold_edges, r.joined_corners, r.shells, r.flipped_facets);
        prop_assert_eq!(counts(&r), counts(&s));
        prop_assert_eq!(r.volume_mm3.map(|v| v * scale * scale * scale), s.volume_mm3);
        for (x, y) in r.surfaces.iter().zip(&s.surfaces) {
            prop_assert_eq!((x.shape.scaled(scale), x.area_mm2 * scale * scale), (y.shape, y.area_mm2));
        }
        let joined = one.figures.joined_within_mm * scale;
        prop_assert_eq!(joined, two.figures.joined_within_mm);
        let from = one.mesh.bounds().0 - Vector3::new(1.0, 2.0, 1.5);
        let along = Vector3::new(0.48, 0.6, 0.64);
        let hit = |part: &Part, scale: f64| {
            let hit = part.bvh.nearest_hit(&(from * scale), &along, 0.0, f64::INFINITY);
            hit.map(|h| (h.facet, h.t_mm / scale))
        };
        prop_assert_eq!(hit(&one, 1.0), hit(&two, scale));
    }
}
