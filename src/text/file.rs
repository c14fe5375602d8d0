//! Why a file cannot be read, and what is wrong in which line of it.

use super::{Sentence, id, listed, say};
use crate::file::{FileError, NoText, TomlError, TomlFault};

impl Sentence for FileError {
    fn sentence(&self) -> String {
        match self {
            FileError::Read { file, source } => say!(file_not_read, file, reason = source.to_string()),
            FileError::NoText { file, source } => say!(in_file, file, what = source.sentence()),
            FileError::Toml { file, source } => say!(in_file, file, what = source.sentence()),
        }
    }
}

impl Sentence for NoText {
    fn sentence(&self) -> String {
        match self {
            NoText::Utf16 => say!(no_text_utf16),
            NoText::Byte { line, byte } => say!(no_text_byte, line = id(line), byte = format!("{byte:02X}")),
        }
    }
}

impl Sentence for TomlError {
    fn sentence(&self) -> String {
        let what = match &self.fault {
            TomlFault::Backslash => say!(toml_backslash),
            TomlFault::NotFinite(value) => say!(toml_not_finite, value),
            TomlFault::UnknownKey { meant: Some(meant), .. } => say!(toml_unknown_meant, meant),
            TomlFault::UnknownKey { known, .. } => say!(toml_unknown_key, known = listed(known)),
            TomlFault::Other(said) => said.clone(),
        };
        match self.key.as_str() {
            "" => say!(in_line, line = id(self.line), what),
            key => say!(toml_at, line = id(self.line), key, what),
        }
    }
}

/// What is wrong in a file, in a line where that is known.
pub(super) fn in_line_of(file: &str, line: Option<usize>, what: String) -> String {
    match line {
        Some(line) => say!(in_line_of_file, file, line = id(line), what),
        None => say!(in_file, file, what),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::job_file;

    #[test]
    fn a_fault_is_told_with_line_key_and_remedy() {
        let said = |text: &str| job_file::parse(text).expect_err(text).sentence();
        assert_eq!(
            said("[part.placement]\nrotation_deg = [inf, 0.0, 0.0]"),
            "line 2: part.placement.rotation_deg: inf is no number to work with; give a finite one"
        );
        assert_eq!(
            said("[layers]\nspaceing_mm = 2"),
            "line 2: layers.spaceing_mm: there is no such key; did you mean spacing_mm?"
        );
        let backslash = said("[part]\nfile = \"C:\\parts\\Users\\box.stl\"");
        assert!(backslash.starts_with("line 2: file: a backslash") && backslash.contains("with /"), "{backslash}");
        let latin = job_file::from_bytes(b"[part]\n# gr\xf6\xdfe").expect_err("Latin-1").sentence();
        assert!(latin.starts_with("line 2: ") && latin.contains("F6") && latin.contains("save"), "{latin}");
        assert_eq!(
            said("[clean]\nsurfaces = [-1]"),
            "line 2: clean.surfaces: give \"all\" or a list of surface numbers"
        );
        assert_eq!(
            said("[layers]\n\nspacing_mm = 0"),
            "line 3: layers.spacing_mm = 0: give a number above 0, up to 1000 mm"
        );
    }
}
