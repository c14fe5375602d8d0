//! Why unsaved changes cannot be kept, and why some that were left behind cannot be read.

use super::document::path;
use super::{Sentence, say};
use crate::document::journal::{JournalError, StateError};

impl Sentence for JournalError {
    fn sentence(&self) -> String {
        match self {
            JournalError::Folder { folder, source } => {
                say!(journal_no_folder, folder = path(folder), reason = source.to_string())
            }
            JournalError::Write { file, source } => {
                say!(journal_not_written, file = path(file), reason = source.to_string())
            }
            JournalError::Job(e) => say!(journal_no_job, what = e.sentence()),
            JournalError::Name(source) => say!(journal_bad_name, reason = source.to_string()),
            JournalError::Unreadable { file, source } => {
                say!(journal_unreadable, file = path(file), what = source.sentence())
            }
        }
    }
}

impl Sentence for StateError {
    fn sentence(&self) -> String {
        match self {
            StateError::Read(source) => source.to_string(),
            StateError::NoText(source) => say!(not_utf8, reason = source.to_string()),
            StateError::NoOwner => say!(journal_no_owner),
            StateError::Owner(source) => say!(journal_bad_owner, reason = source.to_string()),
            StateError::Damaged => say!(journal_damaged),
            StateError::Job(e) => e.sentence(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_state_that_cannot_be_read_is_named_with_a_remedy() {
        let said = JournalError::Unreadable { file: "j/1.toml".into(), source: StateError::Damaged }.sentence();
        assert!(said.starts_with("j/1.toml: ") && said.contains("not as it was written"), "{said}");
        assert!(said.ends_with("remove it"), "{said}");
    }
}
