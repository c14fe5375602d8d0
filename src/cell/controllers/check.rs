//! What the tables of several controllers check alike. Each answers with a sentence for people.

/// # Errors
/// It is no name of a program: letters, digits and `_`, a letter first, not too long.
pub fn identifier(name: &str, value: &str, longest: usize) -> Result<(), String> {
    let mut chars = value.chars();
    let fits = chars.next().is_some_and(|c| c.is_ascii_alphabetic())
        && chars.all(|c| c.is_ascii_alphanumeric() || c == '_')
        && value.len() <= longest;
    if fits {
        return Ok(());
    }
    Err(format!("{name} = {value:?}: give a letter, then letters, digits and _, at most {longest} in all"))
}

/// # Errors
/// One of the lines would be more than a line, or holds what a controller might not take.
pub fn plain_lines(name: &str, lines: &[String]) -> Result<(), String> {
    match lines.iter().find(|l| l.trim().is_empty() || !l.chars().all(|c| c.is_ascii_graphic() || c == ' ')) {
        Some(bad) => Err(format!("{name} has {bad:?}: give lines of ASCII, one each")),
        None => Ok(()),
    }
}

/// # Errors
/// One of the figures is out of its range; each comes with its name and its limits.
pub fn ranges(list: &[(&str, f64, f64, f64)]) -> Result<(), String> {
    match list.iter().find(|(_, value, low, high)| !(low..=high).contains(&value)) {
        Some((name, value, low, high)) => Err(format!("{name} = {value}: give {low} to {high}")),
        None => Ok(()),
    }
}
