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

#[cfg(test)]
mod tests {
    use super::super::{Abb, Estun, Kuka, Yaskawa};
    use super::*;

    #[test]
    fn what_a_controller_refuses_is_named() {
        assert_eq!(Kuka::default().check(), Ok(()));
        assert_eq!(Abb::default().check(), Ok(()));
        assert_eq!(Yaskawa::default().check(), Ok(()));
        assert_eq!(Estun::default().check(), Ok(()));
        let said = |refused: Result<(), String>| refused.expect_err("refused");
        let kuka = said(Kuka { name: "a_name_that_is_much_too_long".into(), ..Kuka::default() }.check());
        assert!(kuka.starts_with("kuka.name") && kuka.contains("20"), "{kuka}");
        let start = said(Kuka { start: vec!["two\nlines".into()], ..Kuka::default() }.check());
        assert!(start.starts_with("kuka.start"), "{start}");
        let mass = said(Abb { mass_kg: 0.0, ..Abb::default() }.check());
        assert!(mass.starts_with("abb.mass_kg = 0"), "{mass}");
        let long = Yaskawa { name: "CLEANING".into(), ..Yaskawa::default() };
        assert!(said(long.check()).contains("at most 5"));
        assert_eq!(Yaskawa { longest_name: 32, ..long }.check(), Ok(()));
        let none = said(Estun { wait: "Wait{}".into(), ..Estun::default() }.check());
        assert!(none.starts_with("estun.wait"), "{none}");
        assert!(identifier("x", "1a", 9).is_err() && identifier("x", "", 9).is_err());
    }
}
