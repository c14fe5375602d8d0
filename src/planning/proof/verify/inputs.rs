//! Files that a program was planned from and that are others by now: its plan is made anew from those there are.

use crate::document::files::{InputDigest, InputKind};

/// A file that is another one than when the program was made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputChange {
    /// What it is to the job.
    pub kind: InputKind,
    /// Its name now; that of then, where it is gone.
    pub name: String,
    /// SHA-256 when the program was made; `None`: there was none.
    pub was: Option<String>,
    /// SHA-256 now; `None`: there is none, or it cannot be read.
    pub is: Option<String>,
}

/// Compares the files of then and now, those of a kind in their order.
pub fn changed_inputs(then: &[InputDigest], now: &[InputDigest]) -> Vec<InputChange> {
    let mut kinds: Vec<InputKind> = then.iter().chain(now).map(|i| i.kind).collect();
    kinds.sort_unstable();
    kinds.dedup();
    let mut out = Vec::new();
    for kind in kinds {
        let of_kind = |all: &'_ [InputDigest]| all.iter().filter(|i| i.kind == kind).cloned().collect::<Vec<_>>();
        let (then, now) = (of_kind(then), of_kind(now));
        for n in 0..then.len().max(now.len()) {
            let (was, is) = (then.get(n), now.get(n));
            if was.map(|i| &i.sha256) != is.map(|i| &i.sha256) {
                let name = is.or(was).map(|i| i.name.clone()).unwrap_or_default();
                let sha256 = |i: Option<&InputDigest>| i.map(|i| i.sha256.clone());
                out.push(InputChange { kind, name, was: sha256(was), is: sha256(is) });
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_that_changed_came_or_went_are_told() {
        let input = |kind, name: &str, sha256: &str| InputDigest { kind, name: name.into(), sha256: sha256.into() };
        let then = [
            input(InputKind::Part, "a.stl", "1"),
            input(InputKind::Clamp, "c.stl", "2"),
            input(InputKind::Clamp, "d.stl", "3"),
            input(InputKind::Robot, "gp7", "4"),
        ];
        assert_eq!(changed_inputs(&then, &then), []);
        let now = [
            input(InputKind::Part, "b.stl", "1"),
            input(InputKind::Robot, "gp7", "5"),
            input(InputKind::Head, "h.toml", "6"),
            input(InputKind::Clamp, "c.stl", "2"),
        ];
        let told: Vec<(String, Option<String>, Option<String>)> =
            changed_inputs(&then, &now).into_iter().map(|c| (c.name, c.was, c.is)).collect();
        let some = |t: &str| Some(t.to_owned());
        assert_eq!(
            told,
            [
                ("gp7".into(), some("4"), some("5")),
                ("h.toml".into(), None, some("6")),
                ("d.stl".into(), some("3"), None)
            ],
            "another name for the same bytes is no change"
        );
    }
}
