//! Rows of bytes of one fixed width, as binary PLY and PCD have them.

use super::ScanFileError;
use super::gather::{ColourScale, Gather, Has};
use super::number::Number;
use super::role::{Role, Roles};
use super::stream::{CHUNK, Stream};

/// A column of bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Field {
    /// Where it begins in its row.
    pub at: usize,
    /// The type of its numbers.
    pub number: Number,
    /// What it is.
    pub role: Role,
}

/// The columns of rows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Table {
    /// Those that are read.
    pub fields: Vec<Field>,
    /// Bytes of a row.
    pub stride: usize,
    /// The highest byte of a number comes first.
    pub is_big: bool,
}

/// An empty gathering for columns of these types.
pub(super) fn gather_for(roles: &Roles, numbers: impl Iterator<Item = Number> + Clone) -> Gather {
    let typed = roles.of.iter().zip(numbers).filter_map(|(role, number)| role.map(|r| (r, number)));
    let places = typed.clone().filter(|(r, _)| matches!(r, Role::Place(_)));
    let from_origin = places.map(|(_, n)| n).all(Number::fits_f32);
    let colour = typed.clone().find(|(r, _)| matches!(r, Role::Colour(_))).map(|(_, n)| n);
    let scale = match colour {
        Some(Number::F32 | Number::F64) => ColourScale::Fractions,
        Some(Number::U16 | Number::I16) => ColourScale::Words,
        _ => ColourScale::Bytes,
    };
    Gather::new(Has::of(roles), scale, from_origin)
}

impl Table {
    /// Reads so many rows; returns how many there are, fewer where the file ends.
    ///
    /// # Errors
    /// Of the stream, or too many points.
    pub fn read(&self, count: u64, stream: &mut Stream<'_>, gather: &mut Gather) -> Result<u64, ScanFileError> {
        gather.reserve(count.min(stream.remaining() / self.stride.max(1) as u64))?;
        let mut read = 0;
        while read < count {
            stream.need(self.stride.max(CHUNK))?;
            let whole = (stream.bytes().len() / self.stride.max(1)).min((count - read).min(1 << 32) as usize);
            if whole == 0 {
                break;
            }
            let bytes = whole * self.stride;
            for row in stream.bytes()[..bytes].chunks_exact(self.stride) {
                let point = gather.push();
                for field in &self.fields {
                    self.put(gather, point, field, &row[field.at..]);
                }
            }
            stream.take(bytes);
            read += whole as u64;
        }
        Ok(read)
    }

    /// Gives a point what its bytes begin with.
    #[inline]
    pub fn put(&self, gather: &mut Gather, point: usize, field: &Field, bytes: &[u8]) {
        if field.role == Role::Packed {
            if let Some(b) = bytes.first_chunk() {
                gather.set_packed(point, if self.is_big { u32::from_be_bytes(*b) } else { u32::from_le_bytes(*b) });
            }
        } else {
            gather.set(point, field.role, field.number.read(bytes, self.is_big));
        }
    }
}
