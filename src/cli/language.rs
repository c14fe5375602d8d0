//! `--lang`: taken out of the arguments before anything else is read, so that help and refusals are in that
//! language as well. An unknown language is left for the parser to refuse.

use crate::text::{Language, choose, language_of, languages, say};
use clap::Arg;
use clap::builder::PossibleValuesParser;
use std::ffi::OsString;

const OPTION: &str = "--lang";

/// The option for the parser, which shows it in the help and refuses a wrong value.
pub(super) fn option() -> Arg {
    let codes: Vec<&str> = languages().map(Language::code).collect();
    Arg::new("lang")
        .long("lang")
        .value_name("LANG")
        .global(true)
        .value_parser(PossibleValuesParser::new(codes))
        .help(say!(cli_lang))
}

/// Chooses the language that is named last, and returns the other arguments.
pub(super) fn taken(arguments: impl IntoIterator<Item = OsString>) -> Vec<OsString> {
    let (language, rest) = split(arguments);
    if let Some(language) = language {
        choose(language);
    }
    rest
}

fn split(arguments: impl IntoIterator<Item = OsString>) -> (Option<Language>, Vec<OsString>) {
    let (mut language, mut rest) = (None, Vec::new());
    let mut arguments = arguments.into_iter().peekable();
    while let Some(argument) = arguments.next() {
        if argument == "--" {
            // What follows are names of files.
            rest.push(argument);
            rest.extend(arguments);
            break;
        }
        let found = match argument.to_str().and_then(|a| a.strip_prefix(OPTION)) {
            Some("") => arguments.next_if(|next| next.to_str().is_some_and(|n| language_of(n).is_some())),
            Some(code) => code.strip_prefix('=').filter(|code| language_of(code).is_some()).map(OsString::from),
            None => None,
        };
        match found {
            Some(code) => language = code.to_str().and_then(language_of),
            None => rest.push(argument),
        }
    }
    (language, rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rest(arguments: &[&str]) -> (Option<&'static str>, Vec<String>) {
        let (language, rest) = split(arguments.iter().map(OsString::from));
        (language.map(Language::code), rest.into_iter().filter_map(|a| a.into_string().ok()).collect())
    }

    #[test]
    fn a_language_is_taken_out_and_the_others_stay() {
        let command = ["clearbeam", "inspect", "x.stl"].map(str::to_owned).to_vec();
        for given in [
            &["clearbeam", "--lang", "en", "inspect", "x.stl"][..],
            &["clearbeam", "inspect", "--lang=en", "x.stl"],
            &["clearbeam", "inspect", "x.stl", "--lang", "en"],
        ] {
            assert_eq!(rest(given), (Some("en"), command.clone()));
        }
        for kept in [
            &["clearbeam", "inspect", "x.stl"][..],
            &["clearbeam", "--lang", "xx", "x.stl"],
            &["clearbeam", "--lang=xx"],
            &["clearbeam", "--lang"],
            &["clearbeam", "--language", "en"],
            &["clearbeam", "--", "--lang", "en"],
        ] {
            assert_eq!(rest(kept), (None, kept.iter().map(|a| (*a).to_owned()).collect()));
        }
    }
}
