//! Where a user's own things are kept on this system. Nothing is made or read here.

use std::ffi::OsString;
use std::path::PathBuf;

/// The user's recipes: they are set up once and belong to the configuration.
pub fn recipes() -> Option<PathBuf> {
    recipes_by(cfg!(windows), &|name| std::env::var_os(name))
}

/// The journals of running windows. Their locks belong to one machine, so they stay off roaming profiles.
pub fn journal() -> Option<PathBuf> {
    journal_by(cfg!(windows), &|name| std::env::var_os(name))
}

/// Small pictures of files that were opened: they can be made again, so they belong to the cache.
pub fn thumbnails() -> Option<PathBuf> {
    let cache = base(cfg!(windows), ["LOCALAPPDATA", "XDG_CACHE_HOME", ".cache"], &|name| std::env::var_os(name));
    Some(cache?.join("thumbnails"))
}

fn recipes_by(windows: bool, variable: &dyn Fn(&str) -> Option<OsString>) -> Option<PathBuf> {
    Some(base(windows, ["APPDATA", "XDG_CONFIG_HOME", ".config"], variable)?.join("recipes"))
}

fn journal_by(windows: bool, variable: &dyn Fn(&str) -> Option<OsString>) -> Option<PathBuf> {
    Some(base(windows, ["LOCALAPPDATA", "XDG_DATA_HOME", ".local/share"], variable)?.join("journal"))
}

/// The program's folder: under the variable of Windows, else under that of XDG or its place in HOME.
fn base(
    windows: bool,
    [on_windows, xdg, in_home]: [&str; 3],
    variable: &dyn Fn(&str) -> Option<OsString>,
) -> Option<PathBuf> {
    // Relative paths in these variables are to be ignored, says their specification.
    let whole = |name: &str| variable(name).map(PathBuf::from).filter(|p| p.has_root());
    let base = match windows {
        true => whole(on_windows),
        false => whole(xdg).or_else(|| Some(whole("HOME")?.join(in_home))),
    };
    Some(base?.join("clearbeam"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(pairs: &'static [(&str, &str)]) -> impl Fn(&str) -> Option<OsString> {
        move |name: &str| pairs.iter().find(|(n, _)| *n == name).map(|(_, v)| OsString::from(v))
    }

    #[test]
    fn recipes_are_where_each_system_has_them() {
        let found = |windows, pairs| recipes_by(windows, &with(pairs));
        assert_eq!(found(false, &[("HOME", "/h")]), Some("/h/.config/clearbeam/recipes".into()));
        assert_eq!(found(false, &[("HOME", "/h"), ("XDG_CONFIG_HOME", "/x")]), Some("/x/clearbeam/recipes".into()));
        assert_eq!(found(false, &[("HOME", "/h"), ("XDG_CONFIG_HOME", "x")]), found(false, &[("HOME", "/h")]));
        assert_eq!(found(true, &[("HOME", "/h"), ("APPDATA", "/a")]), Some("/a/clearbeam/recipes".into()));
        assert_eq!(found(true, &[("HOME", "/h")]), None);
    }

    #[test]
    fn journals_are_where_each_system_has_data() {
        let found = |windows, pairs| journal_by(windows, &with(pairs));
        assert_eq!(found(false, &[("HOME", "/h")]), Some("/h/.local/share/clearbeam/journal".into()));
        assert_eq!(found(false, &[("HOME", "/h"), ("XDG_DATA_HOME", "/x")]), Some("/x/clearbeam/journal".into()));
        assert_eq!(found(true, &[("HOME", "/h"), ("LOCALAPPDATA", "/a")]), Some("/a/clearbeam/journal".into()));
        assert_eq!(found(false, &[]), None);
    }
}
