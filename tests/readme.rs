//! The README's table of parameters is made from the table in the program.

use clearbeam::document::PARAMETERS;
use clearbeam::text::parameter::{label, meaning};
use std::fmt::Write as _;

#[test]
fn the_readme_holds_the_parameter_table() {
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
    let readme = include_str!("../README.md");
    if std::env::var_os("CLEARBEAM_BLESS").is_some() {
        let before = readme.split("| parameter | option |").next().expect("a beginning");
        let behind = readme[before.len()..].split_once("\n\n").expect("a table ends with a blank line").1;
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/README.md");
        std::fs::write(file, format!("{before}{table}\n{behind}")).expect("writes");
        return;
    }
    assert!(readme.contains(&table), "README.md should hold this table; `CLEARBEAM_BLESS=1` writes it:\n{table}");
}

#[test]
fn the_readme_s_recipe_is_one() {
    let readme = include_str!("../README.md");
    let section = readme.split("## Recipes and strategies").nth(1).expect("the section");
    let block = section.split("```toml").nth(1).and_then(|rest| rest.split("```").next()).expect("its example");
    let job: clearbeam::document::Job = toml::from_str(block).expect("a job");
    assert_eq!(job.check_recipes(), Ok(()));
    assert_eq!(job.of_surface(clearbeam::part::SurfaceId(4)).layers.spacing_mm, 0.3);
}
