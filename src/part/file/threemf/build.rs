//! What a 3MF file builds: its items, and the objects that those are made of, each where its transforms put it.

use super::super::{PartFileError, ThreeMfFault};
use super::model::{IDENTITY, Model, Object, Placed, Transform};
use super::package::Package;
use crate::part::raw_part::{RawPart, UnreadKind};
use crate::part::units::StatedUnit;
use crate::progress::Progress;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

/// Objects are made of others in no more steps; programs use one or two.
const DEEPEST: usize = 32;

/// No more objects are placed, and no more facets made of them: a few lines that repeat each other can ask for
/// billions. A plate of small parts holds hundreds.
const MOST_OBJECTS: usize = 100_000;
const MOST_FACETS: usize = 20_000_000;

/// A text that takes longer to parse than the operator should wait: some 10 ms.
const LONG: usize = 1 << 20;

/// Between two looks while a long text is parsed.
const BETWEEN_LOOKS: Duration = Duration::from_millis(20);

/// The part that comes of a file.
pub(super) struct Build<'p, 'a> {
    package: &'p mut Package<'a>,
    /// Models by their entries, the slash before them left out, and which of their objects are used.
    models: BTreeMap<String, Model>,
    used: BTreeSet<(String, u32)>,
    unit: StatedUnit,
    /// Objects that were placed.
    placed: usize,
    part: RawPart,
}

impl<'p, 'a> Build<'p, 'a> {
    /// Builds what the main model, by its entry, asks for.
    pub fn of(package: &'p mut Package<'a>, main: &str) -> Result<RawPart, PartFileError> {
        let main = main.trim_start_matches('/').to_owned();
        let model = read_model(package, &main)?;
        let (unit, items) = (model.unit, model.items.clone());
        let part = RawPart { solids: items.len(), stated_unit: Some(unit), ..RawPart::default() };
        let models = BTreeMap::from([(main.clone(), model)]);
        let mut build = Build { package, models, used: BTreeSet::new(), unit, placed: 0, part };
        for item in &items {
            build.add(item, &main, &IDENTITY, 0)?;
        }
        Ok(build.with_what_is_left())
    }

    /// Adds an object of the model in `entry`, or of the one that it names itself.
    fn add(&mut self, placed: &Placed, entry: &str, by: &Transform, depth: usize) -> Result<(), PartFileError> {
        let entry = placed.entry.as_deref().map_or(entry, |e| e.trim_start_matches('/')).to_owned();
        let transform = after(&placed.transform, by);
        self.load(&entry)?;
        if depth > DEEPEST {
            return Err(ThreeMfFault::TooDeep.into());
        }
        self.placed += 1;
        if self.placed > MOST_OBJECTS {
            return Err(ThreeMfFault::TooManyObjects { most: MOST_OBJECTS }.into());
        }
        self.used.insert((entry.clone(), placed.object));
        let missing = ThreeMfFault::NoSuchObject { object: placed.object };
        let object = self.models.get(&entry).and_then(|m| m.objects.get(&placed.object)).ok_or(missing)?;
        if object.is_support {
            self.part.solids -= usize::from(depth == 0);
            return Ok(());
        }
        push_mesh(&mut self.part, object, placed.object, &transform, self.package.progress)?;
        let components = object.components.clone();
        for component in components.iter() {
            self.add(component, &entry, &transform, depth + 1)?;
        }
        Ok(())
    }

    fn load(&mut self, entry: &str) -> Result<(), PartFileError> {
        if !self.models.contains_key(entry) {
            let model = read_model(self.package, entry)?;
            if model.unit != self.unit {
                return Err(ThreeMfFault::UnitsDiffer.into());
            }
            self.models.insert(entry.to_owned(), model);
        }
        Ok(())
    }

    /// The part, with what of the file is not in it.
    fn with_what_is_left(mut self) -> RawPart {
        let is_used = |entry: &String, number: u32| self.used.contains(&(entry.clone(), number));
        let all = || self.models.iter().flat_map(|(e, m)| m.objects.iter().map(move |(n, o)| (o, is_used(e, *n))));
        let not_built = all().filter(|(o, used)| !used && !o.is_support && !o.triangles.is_empty()).count();
        let supports = all().filter(|(o, _)| o.is_support).count();
        let beams = all().filter(|(o, used)| *used && !o.is_support).map(|(o, _)| o.beams).sum();
        self.part.leave_unread(UnreadKind::ObjectsNotBuilt, not_built);
        self.part.leave_unread(UnreadKind::Supports, supports);
        self.part.leave_unread(UnreadKind::LatticeBeams, beams);
        self.part
    }
}

/// An entry as a model. A long one is read on a thread of its own, because nothing ends the parser before its end:
/// cancelled, it is left to itself, and what it reads is dropped.
fn read_model(package: &mut Package<'_>, name: &str) -> Result<Model, PartFileError> {
    let text = package.text(name)?;
    if text.len() < LONG {
        return Ok(Model::of(&text, name)?);
    }
    let (done, model) = channel();
    let name = name.to_owned();
    std::thread::spawn(move || {
        // Nobody waits for it any more where this fails.
        let _ = done.send(Model::of(&text, &name));
    });
    loop {
        match model.recv_timeout(BETWEEN_LOOKS) {
            Ok(read) => return Ok(read?),
            Err(RecvTimeoutError::Timeout) => package.progress.check()?,
            Err(RecvTimeoutError::Disconnected) => return Err(ThreeMfFault::Archive.into()),
        }
    }
}

/// Adds the triangles of an object where the transform puts it. A mirror turns them inside out, so their winding is
/// turned as well.
fn push_mesh(
    part: &mut RawPart,
    object: &Object,
    number: u32,
    transform: &Transform,
    progress: &Progress,
) -> Result<(), PartFileError> {
    if part.facets.len() + part.invalid.len() + object.triangles.len() > MOST_FACETS {
        return Err(ThreeMfFault::TooManyFacets { most: MOST_FACETS }.into());
    }
    // Only those of triangles, whose number is bounded: one triangle may stand there with millions of vertices.
    let place = |v: usize| object.vertices.get(v).map(|p| apply(transform, *p).map(|x| x as f32));
    let mirrors = determinant(transform) < 0.0;
    for (corners, byte) in &object.triangles {
        progress.check()?;
        let [a, b, c] = if mirrors { [corners[0], corners[2], corners[1]] } else { *corners };
        let (Some(a), Some(b), Some(c)) = (place(a), place(b), place(c)) else {
            return Err(ThreeMfFault::NoSuchVertex { object: number, vertices: object.vertices.len() }.into());
        };
        part.push_checked([a, b, c], *byte);
    }
    Ok(())
}

/// What a transform makes of a point.
fn apply(t: &Transform, p: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| p[0] * t[k] + p[1] * t[3 + k] + p[2] * t[6 + k] + t[9 + k])
}

/// First one transform, then another.
fn after(first: &Transform, then: &Transform) -> Transform {
    // Only the last row is a place, which is moved as well; the others are directions.
    let mut turn = *then;
    turn[9..].fill(0.0);
    let row = |r: usize| [first[3 * r], first[3 * r + 1], first[3 * r + 2]];
    let rows = [apply(&turn, row(0)), apply(&turn, row(1)), apply(&turn, row(2)), apply(then, row(3))];
    std::array::from_fn(|k| rows[k / 3][k % 3])
}

fn determinant(t: &Transform) -> f64 {
    t[0] * (t[4] * t[8] - t[5] * t[7]) - t[1] * (t[3] * t[8] - t[5] * t[6]) + t[2] * (t[3] * t[7] - t[4] * t[6])
}
