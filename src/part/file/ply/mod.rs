//! PLY files: text and binary in both byte orders. Here the mesh of one: vertices and faces; what other elements it has
//! is skipped and told. [`header`] and [`rows`] know elements of any name, so that point clouds can be read by them.

pub mod header;
pub mod rows;

use super::{PartFileError, PlyFault, polygon};
use crate::part::raw_part::{RawPart, UnreadKind};
use crate::progress::Progress;
use header::{Element, Header, Property};
use rows::Rows;

/// Polygons one behind the other.
#[derive(Default)]
struct Faces {
    indices: Vec<f64>,
    /// Where each face ends among the indices, and where it begins in the file.
    ends: Vec<(usize, usize)>,
}

/// Parses a PLY file as a mesh.
///
/// # Errors
/// It cannot be read, or holds no faces; [`PartFileError::Cancelled`] when `progress` says so.
pub(super) fn read(bytes: &[u8], progress: &Progress) -> Result<RawPart, PartFileError> {
    let header = Header::of(bytes)?;
    header.check_size(bytes.len())?;
    let mut rows = Rows::new(bytes, &header);
    let mut part = RawPart { solids: 1, ..RawPart::default() };
    let (mut vertices, mut faces) = (Vec::new(), Faces::default());
    for element in &header.elements {
        match element.name.as_str() {
            "vertex" => vertices = read_vertices(&mut rows, element, progress)?,
            "face" => faces = read_faces(&mut rows, element, progress)?,
            other => {
                for row in 0..element.count {
                    progress.check()?;
                    rows.skip(&element.properties).map_err(|e| e.told(element, row))?;
                }
                if other != "tristrips" {
                    part.leave_unread(UnreadKind::Element(other.into()), element.count as usize);
                }
            }
        }
    }
    if faces.ends.is_empty() && header.elements.iter().any(|e| e.name == "tristrips" && e.count > 0) {
        return Err(PlyFault::Strips.into());
    }
    if faces.ends.is_empty() && !vertices.is_empty() {
        return Err(PartFileError::PointCloud { points: vertices.len() });
    }
    push_faces(&mut part, &vertices, &faces, progress)?;
    if let Some((at, count)) = rows.left() {
        part.pass_over(count, at);
    }
    Ok(part)
}

fn read_vertices(rows: &mut Rows<'_>, element: &Element, progress: &Progress) -> Result<Vec<[f32; 3]>, PartFileError> {
    let place = |name: &str| element.properties.iter().position(|p| p.name == name && p.list.is_none());
    let [Some(x), Some(y), Some(z)] = ["x", "y", "z"].map(place) else { return Err(PlyFault::NoCoordinates.into()) };
    let mut out = Vec::new();
    let mut values = Vec::new();
    for row in 0..element.count {
        progress.check()?;
        rows.values(&element.properties, &mut values).map_err(|e| e.told(element, row))?;
        let value = |k: usize| values.get(k).copied().unwrap_or(f64::NAN) as f32;
        out.push([value(x), value(y), value(z)]);
    }
    Ok(out)
}

fn read_faces(rows: &mut Rows<'_>, element: &Element, progress: &Progress) -> Result<Faces, PartFileError> {
    let is_list = |p: &Property| p.list.is_some() && matches!(p.name.as_str(), "vertex_indices" | "vertex_index");
    let of_face = element.properties.iter().position(is_list).ok_or(PlyFault::NoIndices)?;
    let (before, rest) = element.properties.split_at(of_face);
    let mut faces = Faces::default();
    for row in 0..element.count {
        progress.check()?;
        let byte = rows.at();
        let read = rows.skip(before).and_then(|()| rows.list(&rest[0], &mut faces.indices));
        read.and_then(|()| rows.skip(&rest[1..])).map_err(|e| e.told(element, row))?;
        faces.ends.push((faces.indices.len(), byte));
    }
    Ok(faces)
}

fn push_faces(
    part: &mut RawPart,
    vertices: &[[f32; 3]],
    faces: &Faces,
    progress: &Progress,
) -> Result<(), PartFileError> {
    let mut begin = 0;
    let mut corners = Vec::new();
    for (face, (end, byte)) in faces.ends.iter().enumerate() {
        progress.check()?;
        corners.clear();
        for index in &faces.indices[begin..*end] {
            // Negative and broken numbers become an index that no vertex has.
            let at = if index.fract() == 0.0 && *index >= 0.0 { *index as usize } else { usize::MAX };
            corners.push(*vertices.get(at).ok_or(PlyFault::NoSuchVertex { face, vertices: vertices.len() })?);
        }
        polygon::push(part, &corners, *byte);
        begin = *end;
    }
    Ok(())
}

#[cfg(test)]
mod tests;
