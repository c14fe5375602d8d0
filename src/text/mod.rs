//! Words for people: sentences of what the rooms below find, refuse and fail at, and those of the doors.
//!
//! They stand in Project Fluent files, `assets/text/<language>/*.ftl`; a folder more is a language more. The build
//! makes a type of each English message (`say!` fills it), so that a missing or unused key, or a wrong argument,
//! does not compile. The rooms below know no words: their findings are types, and [`Sentence`] makes lines of them. Only
//! the parser's own line about a broken TOML file, and the `Display` of an error for a log, are English everywhere.
//! Comments in programs are English whatever the language (`Message::english`).

mod advice;
mod assumed;
mod beam;
mod bundle;
mod calibration;
mod cell;
mod changed_part;
pub(crate) mod choices;
mod cure;
mod document;
mod dose;
mod edits;
mod export;
mod file;
mod inspect;
mod journal;
mod library;
mod list;
pub(crate) mod messages;
mod motion;
mod naming;
mod notice;
#[cfg(test)]
mod notice_tests;
mod number;
mod package;
mod page;
pub mod parameter;
mod part;
mod part_file;
mod path;
mod picture;
mod plan_status;
mod planning;
mod program;
mod program_comment;
mod progress;
mod reading;
pub(crate) mod recipe_table;
mod remark;
mod report;
mod robot;
mod sample;
mod scan;
mod scan_file;
mod values;
mod verify;
mod view;
mod weld;

pub(crate) use assumed::assumed;
pub(crate) use bundle::{Arg, Message, id, render};
pub use bundle::{Language, choose, is_chosen, language, language_of, languages};
pub use changed_part::carried_lines;
pub use dose::dose_lines;
pub(crate) use inspect::{inspected, shape_label};
pub(crate) use list::{listed, listed_clauses};
pub use naming::{NamedSentence, Naming};
pub use notice::{example, notice_line, remedy};
pub(crate) use number::{clock, exact, fixed, grouped, hour_and_minute, percent, rough, short};
pub use page::report_page;
pub(crate) use part::with_option;
pub(crate) use picture::{legend_entry, legend_mark, spacing_labels};
pub use program_comment::program_comment;
pub use report::report_lines;
pub(crate) use sample::about_sample;
pub use scan::{
    deviation_lines, deviation_summary, how_it_lies, registration_lines, scan_not_placed, unit_doubt_sentence,
};
pub(crate) use view::name_view;
pub use weld::{area_word, weld_lines};

/// The words of a message: `say!(key)`, `say!(key, count, name = expression)`.
macro_rules! say {
    ($key:ident $(, $name:ident $(= $value:expr)?)* $(,)?) => {
        $crate::text::Message::text(
            $crate::text::messages::$key { $($name: $crate::text::Arg::from($crate::text::say!(@ $name $($value)?))),* }
        )
    };
    (@ $name:ident) => { $name };
    (@ $name:ident $value:expr) => { $value };
}
pub(crate) use say;

/// Words from a file in quotation marks, escaped as in code.
fn quoted(words: &str) -> String {
    format!("{words:?}")
}

/// A finding or an error as a sentence for people, in the language in use.
pub trait Sentence {
    /// One line, without a full stop; it begins with a small letter, as it may follow a file's name.
    fn sentence(&self) -> String;
}

impl<T: Sentence + ?Sized> Sentence for &T {
    fn sentence(&self) -> String {
        (**self).sentence()
    }
}

impl<T: Sentence + ?Sized> Sentence for std::sync::Arc<T> {
    fn sentence(&self) -> String {
        (**self).sentence()
    }
}
