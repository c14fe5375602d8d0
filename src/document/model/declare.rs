//! Declares the tables of a job: a struct whose numbers have their defaults in the table of parameters, with all
//! that would be forgotten beside it.

use super::super::parameter::Parameter;
use crate::number_fields::Number;
use serde::de::{Deserializer, Error, Unexpected, Visitor};
use std::fmt;

/// `parameters! { struct Name in "table" { number: f64, other: Type = default } }`.
///
/// A field without a default is a number, which has its row in [`super::super::parameter::PARAMETERS`] under
/// `table.field`: without one it does not compile. A count is a `u32`. From the list of fields come `Default`, the
/// key of all that is computed from them ([`crate::part::Keyed`]), and the numbers by name
/// ([`crate::number_fields::NumberFields`]).
macro_rules! parameters {
    (
        $(#[$of:meta])*
        pub struct $name:ident in $table:literal {
            $($(#[$meta:meta])* pub $field:ident: $type:ty $(= $default:expr)?),* $(,)?
        }
    ) => {
        $(#[$of])*
        pub struct $name {
            $($(#[$meta])* pub $field: $type,)*
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($field: $crate::document::model::declare::parameters!(@ $table, $field, $type $(, $default)?),)* }
            }
        }

        $crate::part::keyed!($name { $($field),* });
        $crate::number_fields::number_fields!($name { $($field $(: ($default))?),* });
    };
    (@ $table:literal, $field:ident, $type:ty) => {
        {
            // An item, so that `cargo check` looks for the row already.
            const DEFAULT: f64 =
                $crate::document::model::declare::default_of::<$type>(concat!($table, ".", stringify!($field)));
            $crate::number_fields::Number::of(DEFAULT)
        }
    };
    (@ $table:literal, $field:ident, $type:ty, $default:expr) => { $default };
}
pub(super) use parameters;

/// The default of a number, for constants: where key or type are not those of a row, it does not compile.
pub(super) const fn default_of<T: Number>(key: &str) -> f64 {
    let row = Parameter::named(key);
    assert!(row.kind.is_whole() == T::IS_WHOLE, "a count is a u32, any other number an f64");
    row.default
}

/// Reads a count, also where it is written with a decimal point, as clearbeam wrote it once.
///
/// # Errors
/// It is not whole, or below 0.
pub(super) fn count<'de, D: Deserializer<'de>>(d: D) -> Result<u32, D::Error> {
    struct Count;
    impl Visitor<'_> for Count {
        type Value = u32;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("a whole number")
        }

        fn visit_i64<E: Error>(self, v: i64) -> Result<u32, E> {
            u32::try_from(v).map_err(|_| E::invalid_value(Unexpected::Signed(v), &self))
        }

        fn visit_u64<E: Error>(self, v: u64) -> Result<u32, E> {
            u32::try_from(v).map_err(|_| E::invalid_value(Unexpected::Unsigned(v), &self))
        }

        fn visit_f64<E: Error>(self, v: f64) -> Result<u32, E> {
            let is_count = v.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&v);
            if is_count { Ok(v as u32) } else { Err(E::invalid_value(Unexpected::Float(v), &self)) }
        }
    }
    d.deserialize_any(Count)
}
