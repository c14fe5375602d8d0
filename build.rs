//! Makes a Rust type of each English message, so that a word that is missing, unused or given other arguments does
//! not compile.
//!
//! Reads `assets/text/en/*.ftl` for the types, and lists the files of every language folder beside it. A message of
//! `parameters.ftl` gets no type: its words are looked up by the key of a parameter, and a test compares both lists.

use fluent_syntax::ast::{Entry, Expression, InlineExpression, Pattern, PatternElement};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// Messages that are looked up by the key of a parameter.
const BY_KEY: &str = "parameters";

fn main() {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR").expect("cargo sets it")).join("assets/text");
    println!("cargo:rerun-if-changed={}", root.display());
    let mut out = String::from("pub(super) static LANGUAGES: &[(&str, &[(&str, &str)])] = &[\n");
    // A glossary stands beside the folders.
    for language in sorted(&root).into_iter().filter(|path| path.is_dir()) {
        let name = stem(&language);
        let _ = writeln!(out, "    ({name:?}, &[");
        for file in sorted(&language) {
            let _ = writeln!(out, "        ({:?}, include_str!({:?})),", stem(&file), file.display().to_string());
        }
        out.push_str("    ]),\n");
    }
    out.push_str("];\n");
    for file in sorted(&root.join("en")).into_iter().filter(|f| stem(f) != BY_KEY) {
        messages(&file, &mut out);
    }
    let target = PathBuf::from(env::var("OUT_DIR").expect("cargo sets it")).join("messages.rs");
    fs::write(target, out).expect("the build folder can be written");
}

fn sorted(folder: &Path) -> Vec<PathBuf> {
    println!("cargo:rerun-if-changed={}", folder.display());
    let entries = fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut out: Vec<PathBuf> = entries.map(|e| e.expect("readable").path()).collect();
    out.sort();
    out
}

fn stem(path: &Path) -> String {
    path.file_stem().expect("named").to_string_lossy().into_owned()
}

/// The types of one file's messages.
fn messages(file: &Path, out: &mut String) {
    println!("cargo:rerun-if-changed={}", file.display());
    let source = fs::read_to_string(file).expect("readable");
    let resource = match fluent_syntax::parser::parse(source.as_str()) {
        Ok(resource) => resource,
        Err((_, errors)) => panic!("{}: {errors:?}", file.display()),
    };
    for entry in resource.body {
        let Entry::Message(message) = entry else { continue };
        let (key, value) = (message.id.name, message.value.expect("a message says something"));
        let mut arguments = BTreeSet::new();
        variables(&value, &mut arguments);
        let lifetime = if arguments.is_empty() { "" } else { "<'a>" };
        let elided = if arguments.is_empty() { "" } else { "<'_>" };
        let fields: String = arguments.iter().map(|a| format!("pub(crate) {a}: super::Arg<'a>, ")).collect();
        let pairs: String = arguments.iter().map(|a| format!("({a:?}, self.{a}), ")).collect();
        let _ = write!(
            out,
            "pub(crate) struct {key}{lifetime} {{ {fields}}}\n\
             impl super::Message for {key}{elided} {{\n    \
             fn text_in(self, language: super::Language) -> String {{ super::render(language, {key:?}, [{pairs}]) }}\n}}\n"
        );
    }
}

fn variables<'s>(pattern: &Pattern<&'s str>, out: &mut BTreeSet<&'s str>) {
    for element in &pattern.elements {
        if let PatternElement::Placeable { expression } = element {
            of_expression(expression, out);
        }
    }
}

fn of_expression<'s>(expression: &Expression<&'s str>, out: &mut BTreeSet<&'s str>) {
    match expression {
        Expression::Inline(inline) => of_inline(inline, out),
        Expression::Select { selector, variants } => {
            of_inline(selector, out);
            variants.iter().for_each(|v| variables(&v.value, out));
        }
    }
}

fn of_inline<'s>(inline: &InlineExpression<&'s str>, out: &mut BTreeSet<&'s str>) {
    match inline {
        InlineExpression::VariableReference { id } => {
            out.insert(id.name);
        }
        InlineExpression::Placeable { expression } => of_expression(expression, out),
        _ => {}
    }
}
