//! Why a plan was not exported, and what stands in its way.

use super::{Sentence, id, listed_clauses, say};
use crate::planning::export::{ConflictReason, ExportError, FileConflict};

impl Sentence for ExportError {
    fn sentence(&self) -> String {
        match self {
            ExportError::Document(e) => e.sentence(),
            ExportError::Conflicts { dir, conflicts } => {
                let list = listed_clauses(conflicts.iter().map(Sentence::sentence));
                say!(export_conflicts, folder = dir.display().to_string(), list)
            }
            ExportError::Busy { dir } => say!(export_busy, folder = dir.display().to_string()),
            ExportError::Name { name } => say!(export_name, name),
            ExportError::Unwritable(e) => say!(export_unwritable, reason = e.sentence()),
            ExportError::Unreadable(e) => say!(export_unreadable, reason = e.sentence()),
            ExportError::NotThePlan { first, findings } => {
                let (file, line, what) = (&first.file, id(first.line), first.sentence());
                say!(export_not_the_plan, file, line, what, findings = *findings)
            }
            ExportError::FromPass(e) => e.sentence(),
            ExportError::Dose(e) => say!(export_dose, reason = e.sentence()),
            ExportError::Cancelled => say!(text_cancelled),
        }
    }
}

impl Sentence for FileConflict {
    fn sentence(&self) -> String {
        let name = &self.name;
        match &self.reason {
            ConflictReason::ChangedByHand => say!(conflict_changed_by_hand, name),
            ConflictReason::OtherJob(of) => say!(conflict_other_job, name, job = &of.job, part = &of.part),
            ConflictReason::NoExports => say!(conflict_no_exports, name),
            ConflictReason::EarlierVersion => say!(conflict_earlier_version, name),
            ConflictReason::Folder => say!(conflict_folder, name),
        }
    }
}
