//! The reference's table of parameters is made from the table in the program.

use clearbeam::document::PARAMETERS;
use clearbeam::text::parameter::{label, meaning};
use std::fmt::Write as _;

#[test]
fn the_reference_holds_the_parameter_table() {
    let mut table = String::from(
        "| parameter | option | key in the job | range | default | meaning |\n|---|---|---|---|---|---|\n",
    );
    for p in PARAMETERS {
        let option = p.option.map_or(String::new(), |o| format!("`--{o}`"));
        let dots = if p.limits.is_above_least { "<.." } else { ".." };
        let symbol = if p.symbol.is_empty() { String::new() } else { format!(" ({})", p.symbol) };
        let unit = p.kind.unit();
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        let _ = writeln!(
            table,
            "| {}{symbol} | {option} | `{}` | {} {dots} {}{unit} | {} | {} |",
            label(p),
            p.key,
            p.limits.least,
            p.limits.greatest,
            p.default,
            meaning(p)
        );
    }
    let reference = include_str!("../docs/reference.md");
    if std::env::var_os("CLEARBEAM_BLESS").is_some() {
        let before = reference.split("| parameter | option |").next().expect("a beginning");
        let behind = reference[before.len()..].split_once("\n\n").expect("a table ends with a blank line").1;
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/reference.md");
        std::fs::write(file, format!("{before}{table}\n{behind}")).expect("writes");
        return;
    }
    assert!(
        reference.contains(&table),
        "docs/reference.md should hold this table; `CLEARBEAM_BLESS=1` writes it:\n{table}"
    );
}

#[test]
fn the_reference_s_recipe_is_one() {
    let reference = include_str!("../docs/reference.md");
    let section = reference.split("## Recipes and strategies").nth(1).expect("the section");
    let block = section.split("```toml").nth(1).and_then(|rest| rest.split("```").next()).expect("its example");
    let job: clearbeam::document::Job = toml::from_str(block).expect("a job");
    assert_eq!(job.check_recipes(), Ok(()));
    assert_eq!(job.of_surface(clearbeam::part::SurfaceId(4)).layers.spacing_mm, 0.3);
}

/// Stages of the table are those of the bench: a figure of something that is no longer timed is none.
#[test]
fn the_stages_of_the_reference_s_table_are_those_of_the_bench() {
    let source = include_str!("../benches/stages.rs");
    let named = source.split("bench_function(format!(\"").skip(1).filter_map(|rest| rest.split('"').next());
    let names: Vec<&str> = named.filter_map(|name| name.strip_suffix("/{size}")).collect();
    // A number that is filled in may be any.
    let is_of = |name: &str, stage: &str| {
        let (begin, rest) = name.split_once('{').unwrap_or((name, ""));
        let end = rest.split_once('}').map_or("", |(_, end)| end);
        stage == name || !rest.is_empty() && stage.starts_with(begin) && stage.ends_with(end)
    };
    let section = include_str!("../docs/reference.md").split("\n## How fast").nth(1).expect("the section");
    let rows = section.split("|---|---|---|---|---|\n").nth(1).expect("a table").lines();
    let stages: Vec<&str> = rows.map_while(|row| row.strip_prefix("| ")?.split(" | ").next()).collect();
    let timed = stages.iter().filter(|stage| !stage.starts_with("clearbeam "));
    assert!(timed.clone().count() > 10, "{stages:?}");
    for stage in timed {
        assert!(names.iter().any(|name| is_of(name, stage)), "{stage} is none of {names:?}");
    }
}
