//! The `[kuka]` table of a cell file.

use super::templates::{check_force, check_signals, check_template};
use crate::cell::check::{FigureError, Letters, name, plain_lines, ranges};
use serde::{Deserialize, Serialize};

/// What the KRL program needs; words that sources disagree on are templates.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Kuka {
    /// Name of the program and its files.
    pub name: String,
    /// Attributes before `DEF`.
    pub attributes: Vec<String>,
    /// Lines after `DEF`, before the frames.
    pub start: Vec<String>,
    /// Declarations in the data list.
    pub data: Vec<String>,
    /// Lines of a file, about, before it is split into subprograms.
    pub max_lines: usize,
    /// `$APO.CDIS`: how far from a point the corner may be rounded, mm.
    pub blend_mm: f64,
    /// Greatest `$VEL.CP`, m/s.
    pub max_m_s: f64,
    /// Greatest `$VEL.ORI1` and `$VEL.ORI2`, degrees per second.
    pub max_turn_deg_s: f64,
    /// Line that sets the joints' speed to `{percent}`, a whole number.
    pub joint_speed: String,
    /// Line that switches output `{n}` on.
    pub output_on: String,
    /// Line that switches it off.
    pub output_off: String,
    /// Line that sets analogue output `{n}` to `{v}`.
    pub analogue: String,
    /// Line that sets the group `{n}` of digital outputs to the whole number `{v}`; KRL wants it
    /// declared as a `SIGNAL` of that name.
    pub group: String,
    /// Line that waits `{s}` seconds.
    pub wait: String,
    /// Comment line; `{text}` is replaced.
    pub comment: String,
    /// Line that makes a contact tool press with `{f}` newtons from there on; empty: that is a comment.
    pub force_on: String,
    /// Line that ends it.
    pub force_off: String,
    /// Ends lines with CR LF.
    pub crlf: bool,
}

impl Default for Kuka {
    fn default() -> Self {
        let lines = |list: &[&str]| list.iter().map(|l| l.to_string()).collect();
        Kuka {
            name: "clearbeam".into(),
            attributes: lines(&["&ACCESS RVP", "&REL 1"]),
            start: lines(&[
                "GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM( )",
                "INTERRUPT ON 3",
                "BAS(#INITMOV,0)",
            ]),
            data: lines(&["EXT BAS(BAS_COMMAND :IN,REAL :IN)", "DECL INT SUCCESS"]),
            max_lines: 1400,
            blend_mm: 0.5,
            max_m_s: 2.0,
            max_turn_deg_s: 200.0,
            joint_speed: "BAS(#VEL_PTP,{percent})".into(),
            output_on: "$OUT[{n}]=TRUE".into(),
            output_off: "$OUT[{n}]=FALSE".into(),
            analogue: "$ANOUT[{n}]={v}".into(),
            group: "GROUP{n}={v}".into(),
            wait: "WAIT SEC {s}".into(),
            comment: "; {text}".into(),
            force_on: String::new(),
            force_off: String::new(),
            crlf: true,
        }
    }
}

impl Kuka {
    /// Whether the controller can take all of it.
    ///
    /// # Errors
    /// The first that it cannot.
    pub fn check(&self) -> Result<(), FigureError> {
        // 24 letters, and subprograms add up to four.
        name("kuka.name", &self.name, Letters::Identifier, 20)?;
        plain_lines("kuka.attributes", &self.attributes)?;
        plain_lines("kuka.start", &self.start)?;
        plain_lines("kuka.data", &self.data)?;
        ranges(&[
            ("kuka.max_lines", self.max_lines as f64, 100.0, 100_000.0),
            ("kuka.blend_mm", self.blend_mm, 0.0, 50.0),
            ("kuka.max_m_s", self.max_m_s, 0.01, 3.0),
            ("kuka.max_turn_deg_s", self.max_turn_deg_s, 1.0, 1000.0),
        ])?;
        check_template("kuka.joint_speed", &self.joint_speed, &["percent"])?;
        let all = [&self.output_on, &self.output_off, &self.analogue, &self.group, &self.wait, &self.comment];
        check_signals("kuka", all.map(|t| Some(t.as_str())))?;
        check_force("kuka", &self.force_on, &self.force_off)?;
        Ok(())
    }
}
