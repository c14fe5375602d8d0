//! What is wrong with a package of a job.

use super::{Sentence, id, say};
use crate::document::files::package::PackageError;

impl Sentence for PackageError {
    fn sentence(&self) -> String {
        match self {
            PackageError::Archive => say!(package_archive),
            PackageError::NoJob => say!(package_no_job),
            PackageError::Later { schema } => say!(package_later, schema = id(schema)),
            PackageError::Name { name } => say!(package_name, name),
            PackageError::TooLarge { most_mib } => say!(package_too_large, most = id(most_mib)),
            PackageError::Occupied { folder, file } => {
                say!(package_occupied, folder = folder.display().to_string(), file)
            }
            PackageError::Outside { of: _, file } => say!(package_outside, file),
            PackageError::Unwritable { reason } => say!(package_unwritable, reason),
        }
    }
}
