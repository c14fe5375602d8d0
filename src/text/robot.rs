//! What is wrong with a robot file.

use super::file::in_line_of;
use super::{Sentence, exact, fixed, id, listed, quoted, say};
use crate::cell::RobotError;
use crate::cell::robot::RobotFigureError;

impl Sentence for RobotError {
    fn sentence(&self) -> String {
        match self {
            RobotError::Unknown { name, shipped } => {
                say!(robot_unknown, name = quoted(name), shipped = shipped.join(" "))
            }
            RobotError::File(e) => e.sentence(),
            RobotError::Mesh { file, key, what } => {
                say!(in_file, file, what = say!(robot_mesh, key = *key, what = what.sentence()))
            }
            RobotError::Figure { file, line, what } => in_line_of(file, *line, what.sentence()),
        }
    }
}

impl Sentence for RobotFigureError {
    fn sentence(&self) -> String {
        match self {
            RobotFigureError::Figure(e) => e.sentence(),
            RobotFigureError::Kinematics => say!(robot_kinematics),
            RobotFigureError::Short { key, value_mm, least_mm } => {
                say!(robot_short, key = *key, value = exact(*value_mm), least = exact(*least_mm))
            }
            RobotFigureError::Sign { value } => say!(robot_sign, value = exact(*value)),
            RobotFigureError::Limits { joint, range_deg: [low, high] } => {
                say!(robot_limits, joint = id(joint), low = exact(*low), high = exact(*high))
            }
            RobotFigureError::Speed { joint, value, low, high } => {
                say!(robot_speed, joint = id(joint), value = exact(*value), low = exact(*low), high = exact(*high))
            }
            RobotFigureError::MeshFacets { facets, most } => say!(robot_mesh_facets, facets = *facets, most = *most),
            RobotFigureError::MeshOff { key, file, off_mm } => {
                say!(robot_mesh_off, key = *key, file, off = fixed(*off_mm, 0))
            }
            RobotFigureError::Dialect { dialect, known } => {
                say!(robot_dialect, dialect = quoted(dialect), known = listed(known.iter().copied()))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::LoadError;

    #[test]
    fn a_missing_body_is_told_with_file_key_and_what_to_do() {
        let source = std::io::Error::from(std::io::ErrorKind::NotFound);
        let what = LoadError::Io { file: "arm/j3.stl".into(), source };
        let error = RobotError::Mesh { file: "arm/my.toml".into(), key: "links.meshes.j3", what };
        let told = error.sentence();
        assert!(told.starts_with("arm/my.toml: links.meshes.j3: arm/j3.stl"), "{told}");
        assert!(
            told.ends_with(
                "name an STL file beside the robot file, or leave the key out: then a capsule stands for the link"
            ),
            "{told}"
        );
    }
}
