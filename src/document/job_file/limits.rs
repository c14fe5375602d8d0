//! Whether the numbers of a job file can be, each by itself, and the line of what cannot.

use super::error::JobFileError;
use crate::cell::frame::{MOST_TURNS_DEG, OF_SCANNER};
use crate::document::PARAMETERS;
use crate::document::model::{AreaChoice, Job, PatchChoice, ScanRegion};
use crate::document::value_error::RecipeError;
use crate::file::Step::{self as WayStep, Entry, Key};
use crate::file::{line_of, way_of};
use crate::scan::cleaning::Step;

/// So far a part, a clamp or a place may lie from the origin, mm: 10 000 km, which is what coordinates of a survey come
/// to. Beyond, a double has steps of thousandths, and no robot has any business.
pub const FARTHEST_MM: f64 = 1e10;

/// More neighbours than this tell no more of noise and cost memory; 20 are usual.
const MOST_NEIGHBOURS: f64 = 1000.0;

/// Nothing lies so many standard deviations off.
const MOST_SIGMA: f64 = 1e6;

/// No image is wider than this, px.
const MOST_PIXELS: f64 = 1e6;

/// No surface is rougher than this, µm.
const MOST_ROUGHNESS_UM: f64 = 1e5;

/// Nothing leans farther from the normal than this, degrees.
const MOST_TILT_DEG: f64 = 90.0;

/// Checks each number by itself.
///
/// # Errors
/// The first that cannot be, with its line.
pub(super) fn check(job: &Job, text: &str) -> Result<(), JobFileError> {
    PARAMETERS.iter().try_for_each(|p| p.check(job.number(p))).map_err(|e| in_line(text, e.into()))?;
    for (i, recipe) in job.recipes.iter().enumerate() {
        recipe.check().map_err(|e| {
            let key = match &e {
                RecipeError::Number { source, .. } => source.parameter.key,
                RecipeError::NotForRecipes { key, .. } => key,
                _ => "",
            };
            at(
                line_of(text, &[Key("recipes"), Entry(i), Key("values"), Key(key)]),
                JobFileError::Recipe(Box::new(e.clone())),
            )
        })?;
    }
    job.scan.model_from_scan().map_err(|e| in_line(text, JobFileError::Transform(e)))?;
    let listed = [
        place(job),
        tilts(job),
        clamps(job),
        scan(job),
        weld(job),
        job.layers.centre_mm.map_or_else(Vec::new, |c| far("layers.centre_mm", &way_of("layers.centre_mm"), c)),
    ];
    let bad = listed.into_iter().flatten().find(|n| !(n.low..=n.high).contains(&n.value));
    bad.map_or(Ok(()), |Numbered { key, way, value, low, high }| {
        Err(at(line_of(text, &way), JobFileError::Range { key, value, low, high }))
    })
}

/// A number with its key and the way to it.
struct Numbered<'k> {
    key: &'static str,
    way: Vec<WayStep<'k>>,
    value: f64,
    low: f64,
    high: f64,
}

fn within<'k>(key: &'static str, way: &[WayStep<'k>], values: &[f64], low: f64, high: f64) -> Vec<Numbered<'k>> {
    values.iter().map(|&value| Numbered { key, way: way.to_vec(), value, low, high }).collect()
}

fn far<'k>(key: &'static str, way: &[WayStep<'k>], point: [f64; 3]) -> Vec<Numbered<'k>> {
    within(key, way, &point, -FARTHEST_MM, FARTHEST_MM)
}

fn place(job: &Job) -> Vec<Numbered<'static>> {
    let (turn, shift) = ("part.placement.rotation_deg", "part.placement.translation_mm");
    let placement = &job.part.placement;
    let mut out = within(turn, &way_of(turn), &placement.rotation_deg, -MOST_TURNS_DEG, MOST_TURNS_DEG);
    out.extend(far(shift, &way_of(shift), placement.translation_mm));
    out
}

/// Rules, pins and centres of single surfaces. The lists of the file may be in another order than surfaces are, so the
/// line is that of the list.
fn tilts(job: &Job) -> Vec<Numbered<'static>> {
    let mut out = Vec::new();
    for (_, settings) in job.settings.iter() {
        let rule = &settings.tilt;
        let preferred = [rule.preferred.lead_deg, rule.preferred.lean_deg];
        out.extend(within("tilts.preferred", &[Key("tilts")], &preferred, -MOST_TILT_DEG, MOST_TILT_DEG));
        out.extend(within("tilts.least_deg", &[Key("tilts")], &[rule.least_deg], 0.0, MOST_TILT_DEG));
        for pin in &settings.pins {
            let tilt = [pin.tilt.lead_deg, pin.tilt.lean_deg];
            out.extend(within("pins.tilt", &[Key("pins")], &tilt, -MOST_TILT_DEG, MOST_TILT_DEG));
            out.extend(within("pins.at_mm", &[Key("pins")], &[pin.at_mm], 0.0, FARTHEST_MM));
        }
        out.extend(settings.centre_mm.map_or_else(Vec::new, |c| far("starts.centre_mm", &[Key("starts")], c)));
    }
    out
}

fn clamps(job: &Job) -> Vec<Numbered<'static>> {
    let (place, turn) = ("position_mm", "rz_ry_rx_deg");
    let one = |(i, clamp): (usize, &crate::beam::Obstacle)| {
        let way = |key| [Key("clamps"), Entry(i), Key(key)];
        let mut out = far("clamps.position_mm", &way(place), clamp.position_mm);
        let most = MOST_TURNS_DEG;
        out.extend(within("clamps.rz_ry_rx_deg", &way(turn), &clamp.rz_ry_rx_deg, -most, most));
        out
    };
    job.clamps.iter().enumerate().flat_map(one).collect()
}

fn scan(job: &Job) -> Vec<Numbered<'static>> {
    let of_list = |list, i| [Key("scan"), Key(list), Entry(i)];
    let way = way_of("scan.transform");
    let mut out = job.scan.transform.map_or_else(Vec::new, |t| far("scan.transform", &way, [t[3], t[7], t[11]]));
    for (i, pair) in job.scan.pairs.iter().enumerate() {
        out.extend(far("scan.pairs", &of_list("pairs", i), pair.model_mm));
        out.extend(far("scan.pairs", &of_list("pairs", i), pair.scan_mm));
    }
    for (i, shape) in job.scan.left_out.iter().enumerate() {
        out.extend(region("scan.left_out", shape, &of_list("left_out", i)));
    }
    for (i, damage) in job.scan.continued.iter().enumerate() {
        let shapes = damage.damaged.iter().chain(&damage.sound);
        out.extend(shapes.flat_map(|shape| region("scan.continued", shape, &of_list("continued", i))));
    }
    for (i, step) in job.scan.steps.iter().enumerate() {
        out.extend(cleaning(step, &of_list("steps", i)));
    }
    if let PatchChoice::At(places) = &job.scan.patches {
        let way = |i| of_list("patches", i);
        out.extend(places.iter().enumerate().flat_map(|(i, place)| far("scan.patches", &way(i), *place)));
    }
    out
}

fn weld(job: &Job) -> Vec<Numbered<'static>> {
    let of_list = |list, i| [Key("weld"), Key(list), Entry(i)];
    let pixel = |key, way: &[WayStep<'static>], at: &[f64; 2]| within(key, way, at, -MOST_PIXELS, MOST_PIXELS);
    let levels: Vec<f64> = job.weld.threshold.into_iter().collect();
    let mut out = within("weld.threshold", &way_of("weld.threshold"), &levels, 0.0, 255.0);
    for (i, stroke) in job.weld.painted.iter().enumerate() {
        let way = of_list("painted", i);
        out.extend(within("weld.painted", &way, &[stroke.radius_px], 0.0, MOST_PIXELS));
        out.extend(stroke.way_px.iter().flat_map(|at| pixel("weld.painted", &way, at)));
    }
    if let AreaChoice::At(places) = &job.weld.areas {
        let places = places.iter().enumerate();
        out.extend(places.flat_map(|(i, at)| pixel("weld.areas", &of_list("areas", i), at)));
    }
    for (i, pass) in job.weld.history.iter().enumerate() {
        let heights = [pass.height_mm, pass.planned_mm];
        out.extend(within("weld.history", &of_list("history", i), &heights, 0.0, FARTHEST_MM));
    }
    for (i, reading) in job.weld.roughness.iter().enumerate() {
        let roughness: Vec<f64> = [Some(reading.before_um), reading.after_um].into_iter().flatten().collect();
        out.extend(within("weld.roughness", &of_list("roughness", i), &roughness, 0.0, MOST_ROUGHNESS_UM));
    }
    out
}

/// The numbers of a region of the model.
fn region<'k>(key: &'static str, shape: &ScanRegion, way: &[WayStep<'k>]) -> Vec<Numbered<'k>> {
    match *shape {
        ScanRegion::Sphere { centre_mm, radius_mm } => {
            let mut out = far(key, way, centre_mm);
            out.extend(within(key, way, &[radius_mm], 0.0, FARTHEST_MM));
            out
        }
        ScanRegion::Box { min_mm, max_mm } => {
            let mut out = far(key, way, min_mm);
            out.extend(far(key, way, max_mm));
            out
        }
    }
}

/// The numbers of a cleaning step.
fn cleaning<'k>(step: &Step, way: &[WayStep<'k>]) -> Vec<Numbered<'k>> {
    let size = |mm: f64| within("scan.steps", way, &[mm], 0.0, FARTHEST_MM);
    let place = |p: &[f64; 3]| far("scan.steps", way, *p);
    match step {
        Step::Outliers { neighbours, sigma } => {
            let mut out = within("scan.steps", way, &[f64::from(*neighbours)], 1.0, MOST_NEIGHBOURS);
            out.extend(within("scan.steps", way, &[*sigma], 0.0, MOST_SIGMA));
            out
        }
        Step::Thin { voxel_mm } => size(*voxel_mm),
        Step::Smooth { radius_mm, noise_mm } => {
            [Some(*radius_mm), *noise_mm].into_iter().flatten().flat_map(size).collect()
        }
        Step::CutBox { min, max, keep: _ } => [min, max].into_iter().flat_map(place).collect(),
        Step::CutPlane { point, normal } => [point, normal].into_iter().flat_map(place).collect(),
        Step::Erase { centres, radius_mm } => {
            size(*radius_mm).into_iter().chain(centres.iter().flat_map(place)).collect()
        }
    }
}

/// What is wrong, with the line of the key that it names.
pub(super) fn in_line(text: &str, what: JobFileError) -> JobFileError {
    let key = match &what {
        JobFileError::Parameter(e) => e.parameter.key,
        JobFileError::Later(_) | JobFileError::NoVersion(_) => "version",
        JobFileError::NoNumber { key, text: number } => {
            let way = [way_of(key), vec![Key(number)]].concat();
            return at(line_of(text, &way), what);
        }
        JobFileError::Twice { key, .. } | JobFileError::Range { key, .. } => key,
        JobFileError::Frame(e) => {
            let table = if OF_SCANNER.contains(&e.frame) { "scan" } else { "cell" };
            return at(line_of(text, &[Key(table), Key(e.frame)]), what);
        }
        JobFileError::Transform(_) => "scan.transform",
        JobFileError::NoText(_) | JobFileError::Toml(_) | JobFileError::Table(_) => return what,
        JobFileError::Recipe(_) | JobFileError::InLine { .. } => return what,
    };
    let line = line_of(text, &way_of(key));
    at(line, what)
}

fn at(line: Option<usize>, what: JobFileError) -> JobFileError {
    match line {
        Some(line) => JobFileError::InLine { line, what: Box::new(what) },
        None => what,
    }
}

#[cfg(test)]
mod tests {
    use super::super::parse;
    use super::*;

    fn line_and_key(text: &str) -> (usize, &'static str) {
        match parse(text).expect_err(text) {
            JobFileError::InLine { line, what } => match *what {
                JobFileError::Range { key, .. } => (line, key),
                JobFileError::Parameter(e) => (line, e.parameter.key),
                other => panic!("{text}: {other}"),
            },
            other => panic!("{text}: {other}"),
        }
    }

    #[test]
    fn numbers_of_no_row_have_their_range_as_well() {
        for (text, line, key) in [
            ("[part.placement]\ntranslation_mm = [0.0, 1e12, 0.0]", 2, "part.placement.translation_mm"),
            ("[part]\n[part.placement]\n\nrotation_deg = [1e9, 0, 0]", 4, "part.placement.rotation_deg"),
            ("[[tilts]]\nsurface = 3\nleast_deg = -1", 1, "tilts.least_deg"),
            ("[[pins]]\nsurface = 3\nline = 1\nat_mm = 5\ntilt = { lead_deg = 91 }", 1, "pins.tilt"),
            ("[[starts]]\nsurface = 3\ncentre_mm = [0, 0, -1e11]", 1, "starts.centre_mm"),
            (
                "[[clamps]]\nfile = \"a.stl\"\n[[clamps]]\nfile = \"b.stl\"\nposition_mm = [1e11, 0, 0]",
                5,
                "clamps.position_mm",
            ),
            ("[scan]\n[[scan.pairs]]\nmodel_mm = [0, 0, 0]\nscan_mm = [0, 1e11, 0]", 2, "scan.pairs"),
            ("[[scan.left_out]]\nshape = \"sphere\"\ncentre_mm = [0, 0, 0]\nradius_mm = -1", 1, "scan.left_out"),
            ("[scan]\npatches = [[0, 0, 0],\n[0, 0, 1e11]]", 3, "scan.patches"),
            (
                "[[scan.steps]]\nstep = \"thin\"\nvoxel_mm = 1\n[[scan.steps]]\nstep = \"outliers\"\nneighbours = 0\nsigma = 2",
                4,
                "scan.steps",
            ),
            ("[scan]\nmin_depth_mm = 0", 2, "scan.min_depth_mm"),
            ("[layers]\nspacing_mm = 0", 2, "layers.spacing_mm"),
            ("[layers]\ncentre_mm = [1e11, 0, 0]", 2, "layers.centre_mm"),
        ] {
            assert_eq!(line_and_key(text), (line, key), "{text}");
        }
        parse("[part.placement]\ntranslation_mm = [-512345.0, -5412345000.0, 0.0]").expect("coordinates of a survey");
    }

    #[test]
    fn a_value_of_a_recipe_is_found_in_its_line() {
        let text = "[[recipes]]\nname = \"A\"\n[[recipes]]\nname = \"B\"\n[recipes.values]\n\"layers.spacing_mm\" = -2";
        let e = parse(text).expect_err("refused");
        assert!(
            matches!(&e, JobFileError::InLine { line: 6, what } if matches!(**what, JobFileError::Recipe(_))),
            "{e}"
        );
    }
}
