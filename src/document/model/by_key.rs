//! The numbers of a job by their parameters.

use super::Job;
use crate::document::parameter::Parameter;
use crate::number_fields::NumberFields;

impl Job {
    /// The number of a parameter, in its unit.
    pub fn number(&self, parameter: &Parameter) -> f64 {
        let (table, field) = parameter.table_and_field();
        let tables: [(&str, &dyn NumberFields); 11] = [
            ("part.placement", &self.part.placement),
            ("scan", &self.scan),
            ("weld", &self.weld),
            ("surfaces", &self.surfaces),
            ("layers", &self.layers),
            ("beam", &self.beam),
            ("optics", &self.optics),
            ("path", &self.path),
            ("bead", &self.bead),
            ("dose", &self.dose),
            ("cell", &self.cell),
        ];
        let found = tables.iter().find(|t| t.0 == table).and_then(|t| t.1.number(field));
        debug_assert!(found.is_some(), "{} is a number of no job", parameter.key);
        found.unwrap_or(parameter.default)
    }

    /// Puts a number in the place of a parameter, whether it can be that or not: see [`Parameter::check`]. A count
    /// takes the nearest whole one.
    pub fn set_number(&mut self, parameter: &Parameter, value: f64) {
        let (table, field) = parameter.table_and_field();
        let tables: [(&str, &mut dyn NumberFields); 11] = [
            ("part.placement", &mut self.part.placement),
            ("scan", &mut self.scan),
            ("weld", &mut self.weld),
            ("surfaces", &mut self.surfaces),
            ("layers", &mut self.layers),
            ("beam", &mut self.beam),
            ("optics", &mut self.optics),
            ("path", &mut self.path),
            ("bead", &mut self.bead),
            ("dose", &mut self.dose),
            ("cell", &mut self.cell),
        ];
        for (_, numbers) in tables.into_iter().filter(|t| t.0 == table) {
            numbers.set_number(field, value);
        }
    }
}
