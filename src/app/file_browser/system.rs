//! The dialogs of the system: whether there are any, and asking them. On Linux they come from a desktop portal or from
//! zenity, and a bare window manager has neither: then a question is answered at once, without having been shown.

use super::wanted::{Wanted, WantedKind};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Nobody closes a dialog so soon after it was asked for: it was never shown. A portal says within 50 ms that it has no
/// dialog of files.
const NEVER_SHOWN: Duration = Duration::from_millis(250);

/// How the system has answered.
pub(super) enum Asked {
    /// What the user picked; `None`: nothing.
    Answered(Option<PathBuf>),
    /// It has shown no dialog.
    NotShown,
}

/// Asks, and waits for the answer; not to be called where the window is drawn.
pub(super) fn ask(wanted: &Wanted) -> Asked {
    let begun = Instant::now();
    // Some systems tell large letters from small ones.
    let endings: Vec<String> = wanted.endings.iter().flat_map(|e| [e.clone(), e.to_uppercase()]).collect();
    let dialog = rfd::FileDialog::new().set_title(&wanted.title);
    let dialog = if endings.is_empty() { dialog } else { dialog.add_filter(&wanted.title, &endings) };
    let picked = match &wanted.kind {
        WantedKind::File => dialog.pick_file(),
        WantedKind::NewFile(name) => dialog.set_file_name(name).save_file(),
        WantedKind::Folder => dialog.pick_folder(),
    };
    match picked {
        None if begun.elapsed() < NEVER_SHOWN => Asked::NotShown,
        picked => Asked::Answered(picked),
    }
}

/// Whether the system can be expected to have dialogs. `variable`: an environment variable.
pub(super) fn is_there(variable: &dyn Fn(&str) -> Option<OsString>) -> bool {
    if cfg!(any(windows, target_os = "macos")) {
        return true;
    }
    let has_bus = variable("DBUS_SESSION_BUS_ADDRESS").is_some()
        || variable("XDG_RUNTIME_DIR").is_some_and(|dir| Path::new(&dir).join("bus").exists());
    let data = variable("XDG_DATA_DIRS").filter(|dirs| !dirs.is_empty());
    let data = data.unwrap_or_else(|| "/usr/local/share:/usr/share".into());
    let portal = "dbus-1/services/org.freedesktop.portal.Desktop.service";
    let has_portal = has_bus && std::env::split_paths(&data).any(|dir| dir.join(portal).is_file());
    let path = variable("PATH").unwrap_or_default();
    has_portal || std::env::split_paths(&path).any(|dir| dir.join("zenity").is_file())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(target_os = "linux")]
    fn a_portal_or_zenity_is_needed() {
        let dir = tempfile::tempdir().expect("a folder");
        let services = dir.path().join("dbus-1/services");
        std::fs::create_dir_all(&services).expect("made");
        let of = |pairs: &[(&str, OsString)]| {
            is_there(&|name| pairs.iter().find(|(n, _)| *n == name).map(|(_, value)| value.clone()))
        };
        let data = ("XDG_DATA_DIRS", dir.path().as_os_str().to_owned());
        let bus = ("DBUS_SESSION_BUS_ADDRESS", OsString::from("unix:path=/run/bus"));
        assert!(!of(&[bus.clone(), data.clone()]), "a bus without the portal's service");
        std::fs::write(services.join("org.freedesktop.portal.Desktop.service"), "").expect("writes");
        assert!(of(&[bus, data.clone()]));
        assert!(!of(&[data]), "a portal without a bus");
        assert!(!of(&[]));
        std::fs::write(dir.path().join("zenity"), "").expect("writes");
        assert!(of(&[("PATH", dir.path().as_os_str().to_owned())]));
    }
}
