//! A cloud as a PLY file, with figures of each point: what other programs open. Binary, little-endian; places in f64,
//! since a part may stand far from nought.

use super::Cloud;
use std::fmt::Write as _;

/// The bytes of a cloud with these figures, each under its name with one value a point.
pub fn bytes(cloud: &Cloud, figures: &[(&str, &[f32])]) -> Vec<u8> {
    let mut head = format!("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", cloud.len());
    for axis in ["x", "y", "z"] {
        let _ = writeln!(head, "property double {axis}");
    }
    if cloud.colours.is_some() {
        for colour in ["red", "green", "blue"] {
            let _ = writeln!(head, "property uchar {colour}");
        }
    }
    for (name, _) in figures {
        let _ = writeln!(head, "property float {name}");
    }
    head.push_str("end_header\n");
    let mut out = head.into_bytes();
    for (i, p) in cloud.points().enumerate() {
        p.iter().for_each(|c| out.extend(c.to_le_bytes()));
        if let Some(colours) = &cloud.colours {
            out.extend(colours[i]);
        }
        for (_, values) in figures {
            out.extend(values.get(i).copied().unwrap_or(f32::NAN).to_le_bytes());
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Progress;
    use crate::scan::file;
    use nalgebra::Point3;

    #[test]
    fn what_is_written_is_read() {
        let points = [Point3::new(1.5, -2.0, 4e6), Point3::new(3.0, 0.25, 4e6 + 1.0)];
        let cloud = Cloud { colours: Some(vec![[1, 2, 3], [4, 5, 6]]), ..Cloud::of_points(&points) };
        let written = bytes(&cloud, &[("deviation_mm", &[0.25, f32::NAN])]);
        let read = file::from_bytes("out.ply", &written, &Progress::default()).expect("reads").cloud;
        assert_eq!(read.colours, cloud.colours);
        for (found, p) in read.points().zip(points) {
            assert!((found - p).norm() < 1e-6, "{found}, not {p}");
        }
    }
}
