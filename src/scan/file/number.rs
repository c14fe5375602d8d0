//! Numbers in the bytes of binary clouds, of any type that PLY and PCD have.

use crate::part::file::ply::header::Scalar;

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Number {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl From<Scalar> for Number {
    fn from(scalar: Scalar) -> Number {
        match scalar {
            Scalar::I8 => Number::I8,
            Scalar::U8 => Number::U8,
            Scalar::I16 => Number::I16,
            Scalar::U16 => Number::U16,
            Scalar::I32 => Number::I32,
            Scalar::U32 => Number::U32,
            Scalar::F32 => Number::F32,
            Scalar::F64 => Number::F64,
        }
    }
}

impl Number {
    /// Bytes of one.
    pub fn size(self) -> usize {
        match self {
            Number::I8 | Number::U8 => 1,
            Number::I16 | Number::U16 => 2,
            Number::I32 | Number::U32 | Number::F32 => 4,
            Number::I64 | Number::U64 | Number::F64 => 8,
        }
    }

    /// Whether an f32 holds each of its values.
    pub fn fits_f32(self) -> bool {
        matches!(self, Number::I8 | Number::U8 | Number::I16 | Number::U16 | Number::F32)
    }

    /// The number that the bytes begin with; NaN where they are too few. `is_big`: the highest byte comes first.
    #[inline]
    pub fn read(self, bytes: &[u8], is_big: bool) -> f64 {
        macro_rules! number {
            ($of:ty) => {
                bytes.first_chunk().map_or(f64::NAN, |b| {
                    (if is_big { <$of>::from_be_bytes(*b) } else { <$of>::from_le_bytes(*b) }) as f64
                })
            };
        }
        match self {
            Number::I8 => number!(i8),
            Number::U8 => number!(u8),
            Number::I16 => number!(i16),
            Number::U16 => number!(u16),
            Number::I32 => number!(i32),
            Number::U32 => number!(u32),
            Number::I64 => number!(i64),
            Number::U64 => number!(u64),
            Number::F32 => number!(f32),
            Number::F64 => number!(f64),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_type_is_read_in_both_orders() {
        assert_eq!(Number::I16.read(&(-2i16).to_le_bytes(), false), -2.0);
        assert_eq!(Number::I16.read(&(-2i16).to_be_bytes(), true), -2.0);
        assert_eq!(Number::U32.read(&4_000_000_000u32.to_be_bytes(), true), 4e9);
        assert_eq!(Number::F64.read(&0.1f64.to_le_bytes(), false), 0.1);
        assert_eq!(Number::F32.read(&0.1f32.to_be_bytes(), true), f64::from(0.1f32));
        assert!(Number::I64.read(&[1, 2, 3], false).is_nan());
    }
}
