//! The `[yaskawa]` table of a cell file.

use serde::{Deserialize, Serialize};

/// What the program needs; words that sources disagree on are templates.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Yaskawa {
    /// Ends lines with CR LF.
    pub crlf: bool,
}
