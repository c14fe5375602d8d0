//! Several files as one, so that changes go through all of them and may mix up their names: before each stands a line
//! `%%% NAME`.

const MARK: &str = "%%% ";

/// Puts files one behind the other.
pub fn bundle<'f>(files: impl IntoIterator<Item = (&'f str, &'f str)>) -> Vec<u8> {
    files.into_iter().map(|(name, text)| format!("{MARK}{name}\n{text}")).collect::<String>().into_bytes()
}

/// Names and texts; what stands before the first mark has no name.
pub fn unbundled(bytes: &[u8]) -> Vec<(String, String)> {
    let text = String::from_utf8_lossy(bytes);
    let mut out: Vec<(String, String)> = Vec::new();
    for line in text.split_inclusive('\n') {
        match (line.strip_prefix(MARK), out.last_mut()) {
            (Some(name), _) => out.push((name.trim_end().to_owned(), String::new())),
            (None, Some((_, text))) => text.push_str(line),
            (None, None) => out.push((String::new(), line.to_owned())),
        }
    }
    out
}

#[test]
fn files_come_out_as_they_went_in() {
    let files = [("a.src", "one\ntwo\n"), ("b.dat", "")];
    let owned = files.map(|(name, text)| (name.to_owned(), text.to_owned()));
    assert_eq!(unbundled(&bundle(files)), owned);
    assert_eq!(unbundled(b"x\r\ny"), [(String::new(), "x\r\ny".to_owned())]);
    assert_eq!(unbundled(b""), []);
}
