//! The words of the text form of STL, and whether bytes begin like it.

/// Whether the bytes begin like the text form: `solid`, further on `facet` or `endsolid`, and before that no NUL, with
/// which binary headers are padded.
pub fn begins(bytes: &[u8]) -> bool {
    let mut tokens = Tokens { bytes, at: bom_len(bytes) };
    if !tokens.next().is_some_and(|t| t.word == Word::Solid) {
        return false;
    }
    let near = &bytes[..bytes.len().min(1 << 20)];
    let words = near.split(|b| *b == 0).next().unwrap_or_default();
    let holds = |word: &[u8]| words.windows(word.len()).any(|w| w.eq_ignore_ascii_case(word));
    holds(b"facet") || holds(b"endsolid") || holds(b"end solid")
}

/// No name of a solid is longer.
pub const NAME: usize = 512;

/// Bytes of the mark of UTF-8 that some systems put before a text.
pub fn bom_len(bytes: &[u8]) -> usize {
    if bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 }
}

/// What a word of the text means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Word {
    /// `solid`
    Solid,
    /// `endsolid`
    EndSolid,
    /// `facet`
    Facet,
    /// `endfacet`
    EndFacet,
    /// `normal`
    Normal,
    /// `vertex`
    Vertex,
    /// `outer`, `loop`, `endloop`: they say nothing that the vertices do not.
    Loop,
    /// A number, a name, or something unknown.
    Other,
}

fn meaning(word: &[u8]) -> Word {
    let is = |keyword: &str| word.eq_ignore_ascii_case(keyword.as_bytes());
    match word.first().map(u8::to_ascii_lowercase) {
        Some(b'v') if is("vertex") => Word::Vertex,
        Some(b'e') if is("endloop") => Word::Loop,
        Some(b'e') if is("endfacet") => Word::EndFacet,
        Some(b'e') if is("endsolid") => Word::EndSolid,
        Some(b'f') if is("facet") => Word::Facet,
        Some(b'n') if is("normal") => Word::Normal,
        Some(b'o') if is("outer") => Word::Loop,
        Some(b'l') if is("loop") => Word::Loop,
        Some(b's') if is("solid") => Word::Solid,
        _ => Word::Other,
    }
}

/// A word with its place.
#[derive(Clone, Copy)]
pub struct Token<'a> {
    /// As it stands.
    pub text: &'a [u8],
    /// What it means.
    pub word: Word,
    /// Where it begins.
    pub byte: usize,
}

/// White-space separated words; `end loop` is one.
#[derive(Clone)]
pub struct Tokens<'a> {
    /// The file.
    pub bytes: &'a [u8],
    /// Where the next word is looked for.
    pub at: usize,
}

impl<'a> Tokens<'a> {
    fn next_text(&mut self) -> Option<(usize, &'a [u8])> {
        let rest = &self.bytes[self.at..];
        let start = rest.iter().position(|b| !b.is_ascii_whitespace())?;
        let len = rest[start..].iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len() - start);
        let byte = self.at + start;
        self.at = byte + len;
        Some((byte, &rest[start..start + len]))
    }
}

impl<'a> Iterator for Tokens<'a> {
    type Item = Token<'a>;

    fn next(&mut self) -> Option<Token<'a>> {
        let (byte, text) = self.next_text()?;
        if !text.eq_ignore_ascii_case(b"end") {
            return Some(Token { text, word: meaning(text), byte });
        }
        let mut ahead = self.clone();
        let word = match ahead.next_text().map(|(_, what)| meaning(what)) {
            Some(Word::Solid) => Word::EndSolid,
            Some(Word::Facet) => Word::EndFacet,
            Some(Word::Loop) => Word::Loop,
            _ => return Some(Token { text, word: Word::Other, byte }),
        };
        self.at = ahead.at;
        Some(Token { text, word, byte })
    }
}

impl<'a> Tokens<'a> {
    fn line_end(&self) -> usize {
        let end = self.bytes[self.at..].iter().position(|b| matches!(b, b'\n' | b'\r'));
        end.map_or(self.bytes.len(), |n| self.at + n)
    }

    /// Skips a solid's name: to the end of the line, or to `facet normal` on the same line.
    pub fn skip_name(&mut self) {
        let line_end = self.line_end();
        let mut ahead = self.clone();
        loop {
            let before = ahead.at;
            match ahead.next() {
                Some(t) if t.byte < line_end => {
                    let next_is_normal = || ahead.clone().next().is_some_and(|n| n.word == Word::Normal);
                    if t.word == Word::Facet && next_is_normal() {
                        self.at = before;
                        return;
                    }
                }
                _ => break,
            }
        }
        self.at = line_end;
    }

    /// Up to three words that are no keywords: the numbers of a vertex or a normal.
    pub fn numbers(&mut self) -> [Option<Token<'a>>; 3] {
        std::array::from_fn(|_| {
            let mut ahead = self.clone();
            let number = ahead.next().filter(|t| t.word == Word::Other);
            if number.is_some() {
                self.at = ahead.at;
            }
            number
        })
    }
}
