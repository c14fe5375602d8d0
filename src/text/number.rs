//! Numbers as people read them. Units stand in the messages.

/// A number with this many decimals, without a minus before a zero.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(zero) if zero.bytes().all(|digit| matches!(digit, b'0' | b'.')) => zero.to_owned(),
        _ => text,
    }
}

/// A number with all its digits.
pub(crate) fn exact(value: f64) -> String {
    value.to_string()
}

/// Hours, minutes and seconds: `01:02:03`.
pub(crate) fn clock(seconds: f64) -> String {
    let s = seconds.max(0.0).round() as u64;
    format!("{:02}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60)
}

/// A number with one to three decimals, without trailing zeros.
pub(crate) fn short(value: f64) -> String {
    let text = fixed(value, 3);
    match text.strip_suffix("00") {
        Some(short) => short.to_owned(),
        None => text.trim_end_matches('0').to_owned(),
    }
}

/// A number by its first two digits: `0.00013`, `1.2e-17`.
pub(crate) fn rough(value: f64) -> String {
    let text = format!("{value:.1e}");
    let number = text.parse().unwrap_or(value);
    if number == 0.0 || (1e-6..1e6).contains(&number.abs()) { exact(number) } else { text }
}

/// A share as per cent, without the sign.
pub(crate) fn percent(share: f64, decimals: usize) -> String {
    fixed(100.0 * share, decimals)
}

/// The time of day of a moment, counted from midnight UTC of any day: `14:32`.
pub(crate) fn hour_and_minute(seconds: u64) -> String {
    format!("{:02}:{:02}", seconds / 3600 % 24, seconds / 60 % 60)
}

/// `1 426`: digits in groups of three.
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

    #[test]
    fn short_figures_keep_the_decimals_that_say_something() {
        let cases = [(380.0, "380.0"), (-0.0002, "0.0"), (0.14, "0.14"), (-12.3456, "-12.346"), (1.5, "1.5")];
        for (value, text) in cases {
            assert_eq!(short(value), text);
        }
    }

    #[test]
    fn rough_figures_have_two_digits() {
        let cases = [(0.000_126, "0.00013"), (1.234e-17, "1.2e-17"), (0.0, "0"), (9.96e7, "1.0e8"), (123.0, "120")];
        for (value, text) in cases {
            assert_eq!(rough(value), text);
        }
    }

    #[test]
    fn a_clock_counts_whole_seconds() {
        let cases = [(0.0, "00:00:00"), (-3.0, "00:00:00"), (59.6, "00:01:00"), (3_723.0, "01:02:03")];
        for (seconds, text) in cases {
            assert_eq!(clock(seconds), text);
        }
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
