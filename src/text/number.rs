//! Numbers as people read them. Units stand in the messages.

/// With so many decimals, and no minus before a zero.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(zero) if zero.bytes().all(|digit| matches!(digit, b'0' | b'.')) => zero.to_owned(),
        _ => text,
    }
}

/// With all digits that it has.
pub(crate) fn exact(value: f64) -> String {
    value.to_string()
}

/// Hours, minutes and seconds: `01:02:03`.
pub(crate) fn clock(seconds: f64) -> String {
    let s = seconds.max(0.0).round() as u64;
    format!("{:02}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60)
}

/// `1 426`: a blank before every three digits.
pub(crate) fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let mut out = String::with_capacity(digits.len() + digits.len() / 3);
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(' ');
        }
        out.push(digit);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn zero_has_no_sign() {
        assert_eq!([-0.0, -0.04, -0.06, 12.25].map(|v| fixed(v, 1)), ["0.0", "0.0", "-0.1", "12.2"]);
        assert_eq!(fixed(-0.4, 0), "0");
    }

    proptest! {
        #[test]
        fn grouped_digits_are_the_number(count in any::<u64>()) {
            let text = grouped(count);
            prop_assert_eq!(text.replace(' ', ""), count.to_string());
            let groups: Vec<&str> = text.split(' ').collect();
            prop_assert!(groups.iter().skip(1).all(|g| g.len() == 3) && (1..=3).contains(&groups[0].len()));
        }
    }
}
