//! Lists in sentences. What stands between two items is a message, so that each language has its own.

use super::say;

/// `A, B, C`.
pub(crate) fn listed<T: Into<String>>(items: impl IntoIterator<Item = T>) -> String {
    joined(items, |list, next| say!(list_and_next, list, next))
}

/// `A; B; C`: items that may hold commas.
pub(crate) fn listed_clauses<T: Into<String>>(items: impl IntoIterator<Item = T>) -> String {
    joined(items, |list, next| say!(list_and_next_clause, list, next))
}

/// `A, B or C`: alternatives.
pub(super) fn listed_choices<T: Into<String>>(items: impl IntoIterator<Item = T>) -> String {
    let mut items: Vec<String> = items.into_iter().map(Into::into).collect();
    match items.pop() {
        Some(last) if !items.is_empty() => say!(read_one_more, first = listed(items), last),
        last => last.unwrap_or_default(),
    }
}

/// Items joined one by one; without items an empty text.
pub(super) fn joined<T: Into<String>>(
    items: impl IntoIterator<Item = T>,
    join: impl Fn(String, String) -> String,
) -> String {
    items.into_iter().map(Into::into).reduce(join).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_stand_between_commas() {
        assert_eq!(listed([""; 0]), "");
        assert_eq!(listed(["a", "b", "c"]), "a, b, c");
        assert_eq!(listed_clauses(["a, b", "c"]), "a, b; c");
        assert_eq!(listed_choices(["a", "b", "c"]), "a, b or c");
        assert_eq!((listed_choices(["a"]), listed_choices([""; 0])), ("a".into(), String::new()));
    }
}
