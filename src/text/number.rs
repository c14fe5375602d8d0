//! Numbers as people read them. Units stand in the messages.

/// With so many decimals.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    format!("{value:.decimals$}")
}

/// With so many decimals, and no minus before a zero.
pub(crate) fn figure(value: f64, decimals: usize) -> String {
    let power = (0..decimals).fold(1.0, |power, _| 10.0 * power);
    fixed((value * power).round() / power + 0.0, decimals)
}

/// With up to three decimals, as many as say something, and one at least.
pub(crate) fn short(value: f64) -> String {
    let text = figure(value, 3);
    match text.strip_suffix("00") {
        Some(short) => short.to_owned(),
        None => text.trim_end_matches('0').to_owned(),
    }
}

/// With all digits that it has.
pub(crate) fn exact(value: f64) -> String {
    value.to_string()
}

/// A share as per cent, without the sign.
pub(crate) fn percent(share: f64, decimals: usize) -> String {
    fixed(100.0 * share, decimals)
}

/// Hours, minutes and seconds: `01:02:03`.
pub(crate) fn clock(seconds: f64) -> String {
    let s = seconds.max(0.0).round() as u64;
    format!("{:02}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60)
}

/// The time of day of a moment, counted from midnight UTC of any day: `14:32`.
pub(crate) fn hour_and_minute(seconds: u64) -> String {
    format!("{:02}:{:02}", seconds / 3600 % 24, seconds / 60 % 60)
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
    fn figures_are_short_and_never_minus_zero() {
        let cases = [(380.0, "380.0"), (-0.0002, "0.0"), (0.14, "0.14"), (-12.3456, "-12.346"), (1.5, "1.5")];
        for (value, text) in cases {
            assert_eq!(short(value), text);
        }
        assert_eq!((figure(-0.04, 1), figure(-0.05, 1), figure(-0.4, 0)), ("0.0".into(), "-0.1".into(), "0".into()));
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
