//! The numbers of a struct by the names of its fields, which are their names in the job file. What they mean, and
//! what they may be, is told in `document::parameter`.

/// What a field of a number can be.
pub trait Number: Copy {
    /// Whether it counts something.
    const IS_WHOLE: bool;

    /// As a plain number.
    fn value(self) -> f64;

    /// From a plain number; a count takes the nearest that it can be.
    fn of(value: f64) -> Self;
}

impl Number for f64 {
    const IS_WHOLE: bool = false;

    fn value(self) -> f64 {
        self
    }

    fn of(value: f64) -> f64 {
        value
    }
}

impl Number for u32 {
    const IS_WHOLE: bool = true;

    fn value(self) -> f64 {
        self.into()
    }

    fn of(value: f64) -> u32 {
        value.round() as u32
    }
}

/// A struct whose numbers are found by the names of their fields.
pub trait NumberFields {
    /// The number of a field; `None`: there is no such number.
    fn number(&self, field: &str) -> Option<f64>;

    /// Puts a number into a field, where there is one of that name.
    fn set_number(&mut self, field: &str, value: f64);
}

/// Implements [`NumberFields`] for a struct by the list of its fields, those that are no numbers marked as in a
/// pattern: `number_fields!(Type { number, other: _ })`. A field that was forgotten does not compile.
macro_rules! number_fields {
    ($type:ty { $($field:ident $(: $other:tt)?),* $(,)? }) => {
        impl $crate::number_fields::NumberFields for $type {
            fn number(&self, field: &str) -> Option<f64> {
                let Self { $($field: _),* } = self;
                $($crate::number_fields::number_fields!(@read self, field, $field $(: $other)?);)*
                None
            }

            fn set_number(&mut self, field: &str, value: f64) {
                $($crate::number_fields::number_fields!(@write self, field, value, $field $(: $other)?);)*
            }
        }
    };
    (@read $self:ident, $name:ident, $field:ident) => {
        if $name == stringify!($field) {
            return Some($crate::number_fields::Number::value($self.$field));
        }
    };
    (@write $self:ident, $name:ident, $value:ident, $field:ident) => {
        if $name == stringify!($field) {
            $self.$field = $crate::number_fields::Number::of($value);
        }
    };
    (@read $self:ident, $name:ident, $field:ident: $other:tt) => {};
    (@write $self:ident, $name:ident, $value:ident, $field:ident: $other:tt) => {};
}
pub(crate) use number_fields;

#[cfg(test)]
mod tests {
    use super::*;

    struct Box {
        length_mm: f64,
        count: u32,
        name: &'static str,
    }

    number_fields!(Box { length_mm, count, name: _ });

    #[test]
    fn numbers_are_read_and_written_by_name() {
        let mut b = Box { length_mm: 1.5, count: 2, name: "a" };
        assert_eq!((b.number("length_mm"), b.number("count")), (Some(1.5), Some(2.0)));
        b.set_number("length_mm", 0.25);
        b.set_number("count", 7.0);
        assert_eq!((b.length_mm, b.count), (0.25, 7));
        b.set_number("name", 1.0);
        assert_eq!((b.number("name"), b.number("breadth_mm"), b.name), (None, None, "a"));
    }
}
