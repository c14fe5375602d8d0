//! Points as readers find them, row by row or column by column: 31 bytes a point, with what is counted on the way. What
//! of them becomes the cloud is settled at the end, in `settle`.

use super::ScanFileError;
use super::role::{Role, Roles};

/// How numbers of a colour are meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ColourScale {
    /// 0 to 255.
    Bytes,
    /// 0 to 65535.
    Words,
    /// Fractions up to 1, until one above 1 is found: then 0 to 255, and what was read before is taken anew.
    Fractions,
}

/// What points have beside their places.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Has {
    pub normals: bool,
    pub colours: bool,
    pub intensities: bool,
}

impl Has {
    /// What these columns have.
    pub fn of(roles: &Roles) -> Has {
        Has {
            normals: roles.any(|r| matches!(r, Role::Normal(_))),
            colours: roles.any(|r| matches!(r, Role::Colour(_) | Role::Packed)),
            intensities: roles.any(|r| matches!(r, Role::Intensity)),
        }
    }

    /// What either has.
    pub fn or(self, other: Has) -> Has {
        Has {
            normals: self.normals || other.normals,
            colours: self.colours || other.colours,
            intensities: self.intensities || other.intensities,
        }
    }
}

/// Points that are gathered.
#[derive(Debug)]
pub(super) struct Gather {
    pub has: Has,
    /// What the offsets count from, each axis by itself; `None`: no number of it was found yet.
    pub base: [Option<f64>; 3],
    pub offsets: Vec<[f32; 3]>,
    pub normals: Vec<[f32; 3]>,
    pub colours: Vec<[u8; 3]>,
    pub intensities: Vec<f32>,
    pub scale: ColourScale,
    /// Points that were given a red, a green, a blue.
    pub coloured: [u64; 3],
    /// Values of colours that were clamped.
    pub clamped: u64,
    /// The first point that is too far from the base for an f32.
    pub too_far: Option<u64>,
}

impl Gather {
    /// For points that have this. `from_origin`: their coordinates are single numbers, so offsets from 0 hold all their
    /// digits; else they count from the first point.
    pub fn new(has: Has, scale: ColourScale, from_origin: bool) -> Gather {
        Gather {
            has,
            base: [from_origin.then_some(0.0); 3],
            offsets: Vec::new(),
            normals: Vec::new(),
            colours: Vec::new(),
            intensities: Vec::new(),
            scale,
            coloured: [0; 3],
            clamped: 0,
            too_far: None,
        }
    }

    /// Makes room for as many points more; the file has room for them.
    ///
    /// # Errors
    /// [`ScanFileError::TooMany`].
    pub fn reserve(&mut self, points: u64) -> Result<(), ScanFileError> {
        // Points are numbered by u32 in all that is done with clouds.
        let all = (self.offsets.len() as u64).saturating_add(points);
        let too_many = ScanFileError::TooMany { points: all };
        if all > u64::from(u32::MAX) {
            return Err(too_many);
        }
        let more = |has: bool| if has { points as usize } else { 0 };
        let reserved = self
            .offsets
            .try_reserve_exact(points as usize)
            .and_then(|()| self.normals.try_reserve_exact(more(self.has.normals)))
            .and_then(|()| self.colours.try_reserve_exact(more(self.has.colours)))
            .and_then(|()| self.intensities.try_reserve_exact(more(self.has.intensities)));
        reserved.map_err(|_| too_many)
    }

    /// Adds a point without any number, and returns its own.
    #[inline]
    pub fn push(&mut self) -> usize {
        self.offsets.push([f32::NAN; 3]);
        if self.has.normals {
            self.normals.push([f32::NAN; 3]);
        }
        if self.has.colours {
            self.colours.push([0; 3]);
        }
        if self.has.intensities {
            self.intensities.push(f32::NAN);
        }
        self.offsets.len() - 1
    }

    /// Gives a point what a column has of it. Not for [`Role::Packed`].
    #[inline]
    pub fn set(&mut self, point: usize, role: Role, value: f64) {
        match role {
            Role::Place(axis) => self.set_place(point, axis, value),
            Role::Normal(axis) => {
                if let Some(normal) = self.normals.get_mut(point) {
                    normal[axis] = value as f32;
                }
            }
            Role::Colour(channel) => self.set_colour(point, channel, value),
            Role::Packed => {}
            Role::Intensity => {
                if let Some(intensity) = self.intensities.get_mut(point) {
                    *intensity = value as f32;
                }
            }
        }
    }

    #[inline]
    fn set_place(&mut self, point: usize, axis: usize, value: f64) {
        let base = self.base[axis].unwrap_or_else(|| {
            if value.is_finite() {
                self.base[axis] = Some(value);
            }
            value
        });
        let offset = (value - base) as f32;
        // What is infinite itself is dropped; what became so has been lost.
        if !offset.is_finite() && value.is_finite() {
            self.too_far.get_or_insert(point as u64);
        }
        if let Some(place) = self.offsets.get_mut(point) {
            place[axis] = if value.is_finite() { offset } else { value as f32 };
        }
    }

    fn set_colour(&mut self, point: usize, channel: usize, value: f64) {
        if value.is_nan() || point >= self.colours.len() {
            return;
        }
        self.coloured[channel] += 1;
        if self.scale == ColourScale::Fractions && value > 1.0 {
            self.scale = ColourScale::Bytes;
            for c in self.colours.as_flattened_mut() {
                *c = u8::from(*c >= 128);
            }
        }
        let byte = match self.scale {
            ColourScale::Bytes => value,
            ColourScale::Words => value / 257.0,
            ColourScale::Fractions => value * 255.0,
        };
        let byte = byte.round();
        self.clamped += u64::from(!(0.0..=255.0).contains(&byte));
        self.colours[point][channel] = byte as u8;
    }

    /// Gives a point the colour that stands in one number, blue lowest.
    #[inline]
    pub fn set_packed(&mut self, point: usize, bits: u32) {
        if let Some(colour) = self.colours.get_mut(point) {
            let [_, red, green, blue] = bits.to_be_bytes();
            *colour = [red, green, blue];
            self.coloured = self.coloured.map(|c| c + 1);
        }
    }
}
