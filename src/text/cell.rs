//! What is wrong with a cell file, and why a robot cannot stand in a cell.

use super::file::in_line_of;
use super::{Sentence, exact, id, listed, quoted, say};
use crate::cell::check::{FigureError, Letters, WordForm};
use crate::cell::controllers::templates::{TemplateError, TemplateFault};
use crate::cell::{CellError, PlaceError};

impl Sentence for CellError {
    fn sentence(&self) -> String {
        match self {
            CellError::NoneFor { robot } => say!(cell_none_for, robot = quoted(robot)),
            CellError::File(e) => e.sentence(),
            CellError::Obstacle(e) => say!(cell_obstacle, what = e.sentence()),
            CellError::Figure { file, line, what } => in_line_of(file, *line, what.sentence()),
            CellError::Place { cell, what } => say!(in_file, file = cell, what = what.sentence()),
        }
    }
}

impl Sentence for PlaceError {
    fn sentence(&self) -> String {
        match self {
            PlaceError::BeyondJoint { key, joint, deg, range_deg: [low, high], robot } => say!(
                place_beyond_joint,
                key = *key,
                joint = id(joint),
                deg = exact(*deg),
                low = exact(*low),
                high = exact(*high),
                robot,
            ),
            PlaceError::HighTable { table_z_mm } => say!(place_high_table, z = exact(*table_z_mm)),
            PlaceError::LaserInBase { base_mm } => say!(place_laser_in_base, width = exact(*base_mm)),
        }
    }
}

impl Sentence for FigureError {
    fn sentence(&self) -> String {
        match self {
            FigureError::Range { key, value, low, high } => {
                say!(figure_range, key, value = exact(*value), low = exact(*low), high = exact(*high))
            }
            FigureError::NotPositive { key, value, high } => {
                say!(figure_positive, key = *key, value = exact(*value), high = exact(*high))
            }
            FigureError::NotFinite { key, value } => say!(figure_not_finite, key = *key, value = exact(*value)),
            FigureError::HeadPiece { from_mm, to_mm } => {
                say!(figure_head_piece, from = exact(*from_mm), to = exact(*to_mm))
            }
            FigureError::Obstacle { file } => say!(figure_obstacle, file),
            FigureError::Name { key, value, letters, longest } => name(key, &quoted(value), *letters, *longest),
            FigureError::Line { key, line } => say!(program_line, key = *key, line = quoted(line)),
            FigureError::WordForm { key, value, form } => in_form(key, value, *form),
            FigureError::Template(e) => e.sentence(),
            FigureError::Taken { key, number, by } => say!(figure_taken, key, number = id(number), by = *by),
            FigureError::TipPoses { frame } => say!(frame_tip_poses, frame = *frame),
            FigureError::Frame(e) => e.sentence(),
        }
    }
}

fn name(key: &str, value: &str, letters: Letters, longest: usize) -> String {
    match letters {
        Letters::Identifier => say!(name_identifier, key, value, longest),
        Letters::CapitalIdentifier => say!(name_capital_identifier, key, value, longest),
        Letters::Capitals => say!(name_capitals, key, value, longest),
    }
}

fn in_form(key: &str, value: &str, form: WordForm) -> String {
    match form {
        WordForm::Version => say!(form_version, key, value),
        WordForm::Termination => say!(form_termination, key, value),
        WordForm::Configuration => say!(form_configuration, key, value),
        WordForm::Unit => say!(form_unit, key, value),
        WordForm::LongestName => say!(form_longest_name, key, value),
        WordForm::Attributes => say!(form_attributes, key, value),
        WordForm::Pulses => say!(form_pulses, key, value),
    }
}

impl Sentence for TemplateError {
    fn sentence(&self) -> String {
        let (key, template) = (&self.key, quoted(&self.template));
        let braced = |name: &str| format!("{{{name}}}");
        match &self.fault {
            TemplateFault::Lacks(name) => say!(template_lacks, key, template, name = braced(name)),
            TemplateFault::Unknown { name, known } => {
                let known = listed(known.iter().map(|name| braced(name)));
                say!(template_unknown, key, template, name = braced(name), known)
            }
            TemplateFault::Touching => say!(template_touching, key, template),
            TemplateFault::Blank => say!(template_blank, key),
            TemplateFault::NotPlain => say!(template_not_plain, key, template),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_figure_is_told_with_its_key_and_what_it_may_be() {
        let range = FigureError::Range { key: "outputs.power.scale".into(), value: 0.0, low: 1e-6, high: 1e6 };
        assert_eq!(range.sentence(), "outputs.power.scale = 0: give 0.000001 to 1000000");
        let template = TemplateError {
            key: "nachi.output_on".into(),
            template: "SET {m}".into(),
            fault: TemplateFault::Unknown { name: "m".into(), known: &["n", "v"] },
        };
        assert_eq!(template.sentence(), "nachi.output_on = \"SET {m}\" has {m}: give {n}, {v}");
        let what = PlaceError::LaserInBase { base_mm: 300.0 };
        let place = CellError::Place { cell: "MZ04".into(), what }.sentence();
        assert!(place.starts_with("MZ04: base_from_laser: ") && place.contains("300 mm wide"), "{place}");
    }
}
