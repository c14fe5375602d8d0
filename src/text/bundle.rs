//! Languages, and how a message becomes words.

use super::messages::LANGUAGES;
use super::number::grouped;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue, concurrent::FluentBundle};
use std::borrow::Cow;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A language that has a folder of words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Language(usize);

impl Language {
    /// The folder's name, as `--lang` takes it.
    pub fn code(self) -> &'static str {
        LANGUAGES[self.0].0
    }

    /// The language behind it, the first one behind the last.
    pub fn next(self) -> Language {
        Language((self.0 + 1) % LANGUAGES.len())
    }

    /// English, for texts that must not depend on the language in use.
    pub(crate) fn english() -> Language {
        Language(LANGUAGES.iter().position(|l| l.0 == "en").unwrap_or_default())
    }
}

/// All languages.
pub fn languages() -> impl Iterator<Item = Language> {
    (0..LANGUAGES.len()).map(Language)
}

/// Index of the language in use, plus one; 0: none was chosen.
static IN_USE: AtomicUsize = AtomicUsize::new(0);

/// The language of a code, as `--lang` takes it.
pub fn language_of(code: &str) -> Option<Language> {
    languages().find(|l| l.code() == code)
}

/// Whether a language was chosen.
pub fn is_chosen() -> bool {
    IN_USE.load(Ordering::Relaxed) > 0
}

/// Takes a language for all words of this process from now on.
pub fn choose(language: Language) {
    IN_USE.store(language.0 + 1, Ordering::Relaxed);
}

/// The language in use: English, unless another was chosen.
pub fn language() -> Language {
    IN_USE.load(Ordering::Relaxed).checked_sub(1).map_or_else(Language::english, Language)
}

/// The value of a variable of a message.
#[derive(Clone, Debug)]
pub(crate) enum Arg<'a> {
    /// Text that is put into the message as it is, but for what would break its line.
    Words(Cow<'a, str>),
    /// A count: its digits are grouped, and the message may depend on it. Numbers of facets, lines and surfaces are
    /// no counts: see [`id`].
    Count(u64),
}

impl<'a> From<&'a str> for Arg<'a> {
    fn from(words: &'a str) -> Self {
        Arg::Words(words.into())
    }
}

impl<'a> From<&'a String> for Arg<'a> {
    fn from(words: &'a String) -> Self {
        Arg::Words(words.as_str().into())
    }
}

impl From<String> for Arg<'_> {
    fn from(words: String) -> Self {
        Arg::Words(words.into())
    }
}

impl From<usize> for Arg<'_> {
    fn from(count: usize) -> Self {
        Arg::Count(count as u64)
    }
}

impl From<u64> for Arg<'_> {
    fn from(count: u64) -> Self {
        Arg::Count(count)
    }
}

impl From<u32> for Arg<'_> {
    fn from(count: u32) -> Self {
        Arg::Count(count.into())
    }
}

/// The number of a thing (facet, line, surface, output): its digits stay together, as they are typed and searched.
pub(crate) fn id(number: impl std::fmt::Display) -> Arg<'static> {
    Arg::Words(number.to_string().into())
}

/// A message with its arguments.
pub(crate) trait Message: Sized {
    /// Its words in a language.
    fn text_in(self, language: Language) -> String;

    /// In the language in use.
    fn text(self) -> String {
        self.text_in(language())
    }

    /// In English, whatever the language: what stands in programs.
    fn english(self) -> String {
        self.text_in(Language::english())
    }
}

type Bundle = FluentBundle<FluentResource>;

/// The words of a message.
pub(crate) fn render<const N: usize>(language: Language, key: &str, arguments: [(&str, Arg<'_>); N]) -> String {
    let mut args = FluentArgs::with_capacity(N);
    for (name, arg) in arguments {
        let value = match arg {
            Arg::Words(words) => FluentValue::String(on_one_line(words)),
            Arg::Count(count) => FluentValue::from(count as f64),
        };
        args.set(name, value);
    }
    pattern(language, key, None, &args)
}

/// Words with signs that break lines escaped, as in code: names from files may hold them (`"a\nb" = 1` is TOML), and a
/// sentence is one line.
fn on_one_line(words: Cow<'_, str>) -> Cow<'_, str> {
    let breaks = |c: char| (c.is_control() && c != '\t') || matches!(c, '\u{2028}' | '\u{2029}');
    if !words.contains(breaks) {
        return words;
    }
    let escaped = |c: char| if breaks(c) { c.escape_default().to_string() } else { c.to_string() };
    words.chars().map(escaped).collect::<String>().into()
}

/// The words of a message, or of one of its attributes, by its key; the key itself where there is none, which a test
/// rules out.
fn pattern(language: Language, key: &str, attribute: Option<&str>, args: &FluentArgs<'_>) -> String {
    let bundle = bundle(language);
    let message = bundle.get_message(key);
    let found = match attribute {
        None => message.and_then(|m| m.value()),
        Some(name) => message.and_then(|m| m.get_attribute(name)).map(|a| a.value()),
    };
    let Some(found) = found else { return key.to_owned() };
    let mut errors = Vec::new();
    let text = bundle.format_pattern(found, Some(args), &mut errors).into_owned();
    debug_assert!(errors.is_empty(), "{key}: {errors:?}");
    text
}

/// Words that are looked up by the key of a parameter, or an attribute of theirs.
pub(super) fn by_key(key: &str, attribute: Option<&str>) -> String {
    pattern(language(), key, attribute, &FluentArgs::new())
}

fn bundle(language: Language) -> &'static Bundle {
    static BUNDLES: OnceLock<Vec<Bundle>> = OnceLock::new();
    &BUNDLES.get_or_init(|| LANGUAGES.iter().map(|(code, files)| built(code, files)).collect())[language.0]
}

fn built(code: &str, files: &[(&str, &str)]) -> Bundle {
    let mut bundle = Bundle::new_concurrent(vec![code.parse().unwrap_or_default()]);
    // Else invisible marks stand around every argument.
    bundle.set_use_isolating(false);
    bundle.set_formatter(Some(|value, _| match value {
        FluentValue::Number(n) => Some(grouped(n.value as u64)),
        _ => None,
    }));
    for (_, source) in files {
        // What a file gets wrong is told by the tests; the rest of it is good.
        let resource = FluentResource::try_new((*source).into()).unwrap_or_else(|(rest, _)| rest);
        let _ = bundle.add_resource(resource);
    }
    bundle
}

#[cfg(test)]
mod tests {
    use super::*;
    use fluent_syntax::ast::Entry;
    use std::collections::{BTreeMap, BTreeSet};

    #[test]
    fn words_of_a_file_break_no_line() {
        let said = |words: &str| render(Language::english(), "in_file", [("file", words.into()), ("what", "b".into())]);
        assert_eq!(said("größe\t.toml"), "größe\t.toml: b");
        assert_eq!(said("a\nb\r\u{2028}\u{1}"), "a\\nb\\r\\u{2028}\\u{1}: b");
    }

    /// Each message's variables, attributes named as `key.attribute`.
    fn keys(files: &[(&str, &str)]) -> BTreeMap<String, BTreeSet<String>> {
        let mut out = BTreeMap::new();
        for (file, source) in files {
            let resource = fluent_syntax::parser::parse(*source).unwrap_or_else(|(_, e)| panic!("{file}: {e:?}"));
            for entry in resource.body {
                let Entry::Message(m) = entry else { continue };
                let text = fluent_syntax::serializer::serialize(&fluent_syntax::ast::Resource {
                    body: vec![Entry::Message(m.clone())],
                });
                let names = text.split('$').skip(1);
                let names = names.map(|t| t.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect());
                let before = out.insert(m.id.name.to_owned(), names.collect());
                assert!(before.is_none(), "{file}: {} stands twice", m.id.name);
                for a in m.attributes {
                    out.insert(format!("{}.{}", m.id.name, a.id.name), BTreeSet::new());
                }
            }
        }
        out
    }

    #[test]
    fn every_language_says_the_same_messages_with_the_same_arguments() {
        // Comments in programs are English whatever the language.
        let own: Vec<(&str, &str)> =
            LANGUAGES[Language::english().0].1.iter().filter(|(file, _)| *file != "comment").copied().collect();
        let english = keys(&own);
        assert!(!english.is_empty() && own.len() + 1 == LANGUAGES[Language::english().0].1.len());
        for (code, files) in LANGUAGES.iter().filter(|(code, _)| *code != "en") {
            assert_eq!(keys(files), english, "{code}");
        }
    }

    #[test]
    fn arguments_stand_bare_and_counts_are_grouped() {
        let text = render(Language::english(), "verify_count", [("count", Arg::from(97_280_usize))]);
        assert_eq!(text, "97 280 findings");
        assert_eq!(render(Language::english(), "verify_count", [("count", Arg::from(1_usize))]), "1 finding");
    }
}
