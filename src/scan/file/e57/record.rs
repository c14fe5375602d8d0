//! Which values of an E57 record are what, and what is made of them: spherical coordinates become cartesian, colours are
//! brought to 0 to 255 by their limits, and marks of what was not measured are heeded.

use crate::scan::file::gather::Has;
use crate::scan::file::{E57Fault, ScanFileError};
use ::e57::{PointCloud, Record, RecordDataType, RecordName, RecordValue, Transform};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// Three values of a record.
type Three = [usize; 3];

/// The values of the records of one scan.
pub(super) struct Columns {
    prototype: Vec<Record>,
    place: Place,
    /// Not 0: the point was not measured.
    place_invalid: Option<usize>,
    normal: Option<Three>,
    colour: Option<(Three, [Range; 3])>,
    colour_invalid: Option<usize>,
    intensity: Option<usize>,
    intensity_invalid: Option<usize>,
    /// What its points have.
    pub has: Has,
    /// Whether its coordinates are single numbers.
    pub are_single: bool,
    /// Bits of a record, at least 1.
    pub bits: u64,
    /// Names of values that are nothing a cloud keeps.
    pub unread: Vec<String>,
}

enum Place {
    Cartesian(Three),
    /// Range, azimuth, elevation.
    Spherical(Three),
}

/// What a colour's values lie between.
#[derive(Clone, Copy)]
struct Range {
    least: f64,
    greatest: f64,
}

impl Columns {
    /// The columns of a scan.
    ///
    /// # Errors
    /// It has no coordinates, or records that take no bits, of which there might be any number.
    pub fn of(cloud: &PointCloud) -> Result<Columns, ScanFileError> {
        let prototype = cloud.prototype.clone();
        let at = |name: &RecordName| prototype.iter().position(|r| r.name == *name);
        let three = |[a, b, c]: [RecordName; 3]| Some([at(&a)?, at(&b)?, at(&c)?]);
        let extension = |word: &str| {
            prototype.iter().position(|r| matches!(&r.name, RecordName::Unknown { name, .. } if name == word))
        };
        let cartesian = three([RecordName::CartesianX, RecordName::CartesianY, RecordName::CartesianZ]);
        let spherical = [RecordName::SphericalRange, RecordName::SphericalAzimuth, RecordName::SphericalElevation];
        let (place, places, invalid) = match (cartesian, three(spherical)) {
            (Some(c), _) => (Place::Cartesian(c), c, RecordName::CartesianInvalidState),
            (None, Some(s)) => (Place::Spherical(s), s, RecordName::SphericalInvalidState),
            (None, None) => {
                return Err(ScanFileError::NoCoordinates { columns: prototype.iter().map(word).collect() });
            }
        };
        let bits = prototype.iter().map(|r| bits(&r.data_type)).sum();
        if bits == 0 {
            return Err(E57Fault::NotHandled.into());
        }
        let normal = ["normalX", "normalY", "normalZ"].map(extension);
        let normal = normal.into_iter().collect::<Option<Vec<_>>>().and_then(|n| n.try_into().ok());
        let colour = three([RecordName::ColorRed, RecordName::ColorGreen, RecordName::ColorBlue]);
        let colour = colour.map(|c: Three| (c, ranges(cloud, c)));
        let intensity = at(&RecordName::Intensity);
        let has = Has { normals: normal.is_some(), colours: colour.is_some(), intensities: intensity.is_some() };
        let (place_invalid, colour_invalid) = (at(&invalid), at(&RecordName::IsColorInvalid));
        let intensity_invalid = at(&RecordName::IsIntensityInvalid);
        let are_single = matches!(place, Place::Cartesian(_))
            && places.iter().all(|&k| matches!(prototype[k].data_type, RecordDataType::Single { .. }));
        let flags = [place_invalid, colour_invalid, intensity_invalid, intensity];
        let used: Vec<usize> = places.into_iter().chain(normal.into_iter().flatten()).collect();
        let is_read =
            |k: usize| used.contains(&k) || flags.contains(&Some(k)) || colour.is_some_and(|(c, _)| c.contains(&k));
        let unread = prototype.iter().enumerate().filter(|(k, _)| !is_read(*k)).map(|(_, r)| word(r)).collect();
        Ok(Columns {
            prototype,
            place,
            place_invalid,
            normal,
            colour,
            colour_invalid,
            intensity,
            intensity_invalid,
            has,
            are_single,
            bits,
            unread,
        })
    }

    fn number(&self, record: &[RecordValue], column: usize) -> f64 {
        let typed = record.get(column).zip(self.prototype.get(column));
        typed.and_then(|(value, of)| value.to_f64(&of.data_type).ok()).unwrap_or(f64::NAN)
    }

    fn three(&self, record: &[RecordValue], columns: Three) -> Vector3<f64> {
        Vector3::from(columns.map(|k| self.number(record, k)))
    }

    fn is_set(&self, record: &[RecordValue], flag: Option<usize>) -> bool {
        flag.is_some_and(|k| self.number(record, k) != 0.0)
    }

    /// The point in its scan's frame, m; `None`: it was not measured.
    pub fn place(&self, record: &[RecordValue]) -> Option<Vector3<f64>> {
        if self.is_set(record, self.place_invalid) {
            return None;
        }
        Some(match self.place {
            Place::Cartesian(columns) => self.three(record, columns),
            Place::Spherical(columns) => {
                let [range, azimuth, elevation] = self.three(record, columns).into();
                let flat = range * libm::cos(elevation);
                Vector3::new(flat * libm::cos(azimuth), flat * libm::sin(azimuth), range * libm::sin(elevation))
            }
        })
    }

    /// Its normal in its scan's frame.
    pub fn normal(&self, record: &[RecordValue]) -> Option<Vector3<f64>> {
        self.normal.map(|columns| self.three(record, columns))
    }

    /// Its colour, 0 to 255.
    pub fn colour(&self, record: &[RecordValue]) -> Option<[f64; 3]> {
        let (columns, ranges) = self.colour.filter(|_| !self.is_set(record, self.colour_invalid))?;
        let share = |k: usize| {
            let Range { least, greatest } = ranges[k];
            (self.number(record, columns[k]) - least) / (greatest - least) * 255.0
        };
        Some([share(0), share(1), share(2)])
    }

    /// How bright it came back.
    pub fn intensity(&self, record: &[RecordValue]) -> Option<f64> {
        let column = self.intensity.filter(|_| !self.is_set(record, self.intensity_invalid))?;
        Some(self.number(record, column))
    }
}

fn word(record: &Record) -> String {
    match &record.name {
        RecordName::Unknown { name, .. } => name.clone(),
        known => format!("{known:?}"),
    }
}

fn bits(of: &RecordDataType) -> u64 {
    match of {
        RecordDataType::Single { .. } => 32,
        RecordDataType::Double { .. } => 64,
        RecordDataType::ScaledInteger { min, max, .. } | RecordDataType::Integer { min, max } => {
            u64::from((i128::from(*max) - i128::from(*min)).max(0).checked_ilog2().map_or(0, |b| b + 1))
        }
    }
}

/// What the colours of a scan lie between: by its limits, else by the whole numbers that can be, else 0 to 1.
fn ranges(cloud: &PointCloud, columns: Three) -> [Range; 3] {
    let limits = cloud.color_limits.clone();
    let limits = limits.map_or([const { (None, None) }; 3], |l| {
        [(l.red_min, l.red_max), (l.green_min, l.green_max), (l.blue_min, l.blue_max)]
    });
    std::array::from_fn(|k| {
        let of = &cloud.prototype[columns[k]].data_type;
        let number = |value: &Option<RecordValue>| value.as_ref().and_then(|v| v.to_f64(of).ok());
        let by_type = match of {
            RecordDataType::Integer { min, max } if *max <= 1 << 32 => (*min as f64, *max as f64),
            RecordDataType::Integer { .. } => (0.0, 255.0),
            RecordDataType::ScaledInteger { min, max, scale, offset } if *max <= 1 << 32 => {
                (*min as f64 * scale + offset, *max as f64 * scale + offset)
            }
            RecordDataType::Single { min: Some(a), max: Some(b) } => (f64::from(*a), f64::from(*b)),
            RecordDataType::Double { min: Some(a), max: Some(b) } => (*a, *b),
            _ => (0.0, 1.0),
        };
        let told = (number(&limits[k].0), number(&limits[k].1));
        let (least, greatest) = if let (Some(a), Some(b)) = told { (a, b) } else { by_type };
        if greatest > least { Range { least, greatest } } else { Range { least: 0.0, greatest: 255.0 } }
    })
}

/// Where a scan lies in its file.
pub(super) struct Pose {
    turn: UnitQuaternion<f64>,
    shift: Vector3<f64>,
}

/// A quaternion's length may be so far from one: files have them rounded.
const ROUNDING: f64 = 1e-3;

impl Pose {
    /// The pose of a scan; the file's own frame where it has none. `None`: it is no motion.
    pub fn of(transform: Option<&Transform>) -> Option<Pose> {
        let Some(t) = transform else {
            return Some(Pose { turn: UnitQuaternion::identity(), shift: Vector3::zeros() });
        };
        let turn = Quaternion::new(t.rotation.w, t.rotation.x, t.rotation.y, t.rotation.z);
        let shift = Vector3::new(t.translation.x, t.translation.y, t.translation.z);
        let is_motion = (turn.norm() - 1.0).abs() < ROUNDING && shift.iter().all(|s| s.is_finite());
        is_motion.then(|| Pose { turn: UnitQuaternion::from_quaternion(turn), shift })
    }

    /// A point of the scan in the file's frame.
    pub fn placed(&self, point: Vector3<f64>) -> Vector3<f64> {
        self.turn * point + self.shift
    }

    /// A direction of the scan in the file's frame.
    pub fn turned(&self, direction: Vector3<f64>) -> Vector3<f64> {
        self.turn * direction
    }
}
