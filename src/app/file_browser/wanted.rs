//! What is asked for: title, endings of the files that are shown, and whether a file or a folder is picked.

use super::super::dialogs::Purpose;
use crate::part::file::ENDINGS;
use crate::scan;
use crate::text::say;

/// What a dialog asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Wanted {
    /// What its title says.
    pub title: String,
    /// Endings of files, in small letters; of a folder none.
    pub endings: Vec<String>,
    /// What is picked.
    pub kind: WantedKind,
}

/// What is picked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum WantedKind {
    /// A file that is there.
    File,
    /// A file to be written, with the name that is suggested.
    NewFile(String),
    /// A folder.
    Folder,
}

/// Endings that grey images have and depth images have not, and the other way round.
const JPEG: [&str; 2] = ["jpg", "jpeg"];
const PGM: [&str; 1] = ["pgm"];
const IMAGES: [&str; 3] = ["png", "tif", "tiff"];

impl Wanted {
    /// What is asked for a purpose; `name` is suggested for a file that is written.
    pub fn of(purpose: Purpose, name: &str) -> Wanted {
        let file = |title: String, endings: &[&[&str]]| Wanted {
            title,
            endings: endings.concat().into_iter().map(str::to_owned).collect(),
            kind: WantedKind::File,
        };
        let folder = |title: String| Wanted { title, endings: Vec::new(), kind: WantedKind::Folder };
        match purpose {
            Purpose::Open => file(say!(dialog_part_or_job), &[&["toml", "clearbeam"], &ENDINGS]),
            Purpose::SaveJob => Wanted {
                kind: WantedKind::NewFile(name.to_owned()),
                ..file(say!(dialog_job), &[&["toml", "clearbeam"]])
            },
            Purpose::Export => folder(say!(dialog_program_folder)),
            Purpose::ExportDryRun => folder(say!(dialog_dry_run_folder)),
            Purpose::Part => file(say!(dialog_part), &[&ENDINGS]),
            Purpose::Cell => file(say!(dialog_cell), &[&["toml"]]),
            Purpose::Robot => file(say!(dialog_robot), &[&["toml"]]),
            Purpose::Head => file(say!(dialog_head), &[&["toml"], &ENDINGS]),
            Purpose::SaveHead => {
                Wanted { kind: WantedKind::NewFile("head.toml".into()), ..file(say!(dialog_save_head), &[&["toml"]]) }
            }
            Purpose::Clamp => file(say!(dialog_clamp), &[&ENDINGS]),
            Purpose::Scan => file(say!(dialog_scan), &[&scan::file::ENDINGS]),
            Purpose::WeldGray | Purpose::NextGray => file(say!(dialog_weld_gray), &[&IMAGES, &JPEG]),
            Purpose::WeldDepth | Purpose::NextDepth => file(say!(dialog_weld_depth), &[&IMAGES, &PGM]),
            Purpose::WeldCamera => file(say!(dialog_weld_camera), &[&["toml", "json"]]),
            Purpose::HandEye => file(say!(dialog_hand_eye), &[&["toml"]]),
            Purpose::GrindingTool => file(say!(dialog_grinding_tool), &[&["toml"]]),
        }
    }

    /// Whether a file of this name is one of those that are asked for.
    pub fn takes(&self, name: &str) -> bool {
        let ending = name.rsplit_once('.').map_or(String::new(), |(_, ending)| ending.to_lowercase());
        self.endings.contains(&ending)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_taken_by_their_ending_in_large_and_small_letters() {
        let open = Wanted::of(Purpose::Open, "");
        for (name, taken) in [("a.stl", true), ("A.STL", true), ("job.toml", true), ("b.txt", false), ("stl", false)] {
            assert_eq!(open.takes(name), taken, "{name}");
        }
        let save = Wanted::of(Purpose::SaveJob, "job.toml");
        assert_eq!(save.kind, WantedKind::NewFile("job.toml".into()));
        assert_eq!(Wanted::of(Purpose::Export, "").kind, WantedKind::Folder);
    }
}
