//! The keys of the stages: digests of all that each depends on.
//!
//! A job is taken apart field by field, so that a new one does not compile until it is said here which
//! stages it makes stale. Names, notes and places of files are in no key; what the files hold is.

use crate::document::model::{JobPart, JobScan, JobWeld, SurfaceParameters};
use crate::document::{Job, Settings};
use crate::part::{Digest, Hasher, Source};
use std::path::Path;

/// The keys of the stages of a scan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ScanKeys {
    /// Key of its points: the files and their unit.
    pub read: Digest,
    /// Key of the cleaned points.
    pub cleaned: Digest,
    /// Key of where it lies.
    pub laid: Digest,
    /// Key of what it is off the part.
    pub compared: Digest,
    /// Key of the part with patches.
    pub worn: Digest,
}

impl ScanKeys {
    fn new(files: Digest, part: Digest, surfaces: Digest, scan: &JobScan, bead_mm: Option<f64>) -> ScanKeys {
        let JobScan {
            units,
            min_depth_mm,
            tolerance_mm,
            gate_mm,
            work,
            lines,
            transform,
            patches,
            files: named,
            together,
            steps,
            pairs,
            left_out,
            continued,
            base_from_scan: _,
            flange_from_scan: _,
        } = scan;
        let read = Hasher::default().of(&files).of(named).of(units).of(together).finish();
        let cleaned = Hasher::default().of(&read).of(steps).finish();
        // Normals are interpolated within surfaces.
        let laid = Hasher::default()
            .of(&cleaned)
            .of(&part)
            .of(&surfaces)
            .of(transform)
            .of(pairs)
            .of(left_out)
            .of(continued)
            .finish();
        let compared = Hasher::default().of(&laid).of(min_depth_mm).of(tolerance_mm).finish();
        let worn = Hasher::default().of(&compared).of(patches).of(gate_mm).of(work).of(lines).of(&bead_mm).finish();
        ScanKeys { read, cleaned, laid, compared, worn }
    }
}

/// The keys of the stages of a weld.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WeldKeys {
    /// Key of its images and their camera.
    pub read: Digest,
    /// Key of the mask.
    pub masked: Digest,
    /// Key of what was measured in it.
    pub measured: Digest,
    /// Key of the part with its areas.
    pub ground: Digest,
}

impl WeldKeys {
    fn new(files: Digest, surfaces: Digest, weld: &JobWeld) -> WeldKeys {
        let JobWeld {
            even_light_px,
            smoothing_px,
            sigmas,
            opening_px,
            closing_px,
            least_area_px,
            pass_depth_mm,
            at_once,
            residual_mm,
            below_mm,
            removal_share,
            lead_deg: _,
            arc_mm: _,
            force_n: _,
            gouge_mm: _,
            acceleration_mm_s2: _,
            threshold,
            strategy: _,
            bead_strategy: _,
            areas,
            images,
            hand_eye,
            tool: _,
            painted,
            history,
            goes_on,
            roughness: _,
        } = weld;
        let read = Hasher::default().of(&files).of(images).of(hand_eye).of(history).finish();
        let mask = Hasher::default().of(&read).of(even_light_px).of(smoothing_px).of(sigmas).of(threshold);
        let masked = mask.of(opening_px).of(closing_px).of(least_area_px).of(painted).finish();
        let measured = Hasher::default().of(&masked).of(&"measured").finish();
        let ground =
            Hasher::default().of(&measured).of(&surfaces).of(areas).of(pass_depth_mm).of(at_once).of(residual_mm);
        let ground = ground.of(below_mm).of(removal_share).of(goes_on).finish();
        WeldKeys { read, masked, measured, ground }
    }
}

/// The keys of everything that is computed from one job.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Keys {
    /// Key of the part: file, unit, welding, placement, turned shells.
    pub part: Digest,
    /// Key of its feature surfaces: the part, and the rules and edits that make them.
    pub surfaces: Digest,
    /// Keys of the scan; `None` where the job has none.
    pub scan: Option<ScanKeys>,
    /// Keys of the weld; `None` where the job grinds none.
    pub weld: Option<WeldKeys>,
    /// Key of what is reported of the weld; `None` where the job grinds none.
    pub weld_report: Option<Digest>,
    /// Key of head, grinding tool and clamps.
    pub tool: Digest,
    /// Key of the cell with the frames of its file.
    pub cell: Digest,
    /// Key of the set-up: robot, cell, head and clamps as the job combines them.
    pub setup: Digest,
    /// Key of lines and plan.
    pub plan: Digest,
    /// Key of the dose: the plan, and the thresholds that judge it.
    pub dose: Digest,
}

impl Keys {
    /// The keys of a job that stands in `job_file`, on a part as read. `reading` counts how often cell, robot,
    /// head and clamps were read: their files may change while their names stay.
    pub fn new(source: &Source, job: &Job, job_file: Option<&Path>, reading: u64) -> Keys {
        let Job { part, scan, weld, surfaces, settings, layers, beam, optics, path, bead, dose, cell, clamps, recipes } =
            job;
        let part = part_key(source, part);
        let surfaces = surfaces_key(part, surfaces, settings);
        let folder = job_file.and_then(Path::parent).map(|f| f.to_string_lossy().into_owned());
        let files = Hasher::default().of(&folder).of(&reading).finish();
        // Patches are cut where beads end.
        let bead_mm = job.section_of_bead().map(|_| bead.height_mm);
        let scan_keys = scan.is_there().then(|| ScanKeys::new(files, part, surfaces, scan, bead_mm));
        let weld_keys = weld.is_there().then(|| WeldKeys::new(files, surfaces, weld));
        let grinding = (weld.is_there(), &weld.tool, weld.lead_deg, weld.arc_mm, weld.force_n, weld.gouge_mm);
        let tool = Hasher::default().of(&files).of(&beam.head).of(clamps).of(&grinding.0).of(grinding.1);
        let chord_error_mm = weld.is_there().then_some(path.chord_error_mm);
        let tool = tool.of(&chord_error_mm).of(&grinding.2).of(&grinding.3).of(&grinding.4).of(&grinding.5).finish();
        let cell_key = Hasher::default().of(&files).of(&cell.file).of(&cell.robot).finish();
        // Whether something stands in the beam's way is asked of beam and optics too.
        let setup = Hasher::default().of(&tool).of(&cell_key).of(cell).of(beam).of(optics);
        // Where the part stands follows from the scan, where it is known where the scanner stands.
        let scanner = (&scan.base_from_scan, &scan.flange_from_scan);
        let placed = scan_keys.filter(|_| scanner != (&None, &None)).map(|k| k.laid);
        // And from the images, where it is known where the camera stood.
        let seen = weld_keys.filter(|_| !weld.hand_eye.is_empty()).map(|k| k.ground);
        let setup = setup.of(&placed).of(scanner.0).of(scanner.1).of(&seen).finish();
        // Strategies are compared by their lines and by how the tool moves; roughness readings are for the report alone.
        let weld_report = weld_keys.map(|keys| {
            let lines = Hasher::default().of(&keys.ground).of(&layers.spacing_mm).of(&weld.arc_mm);
            lines.of(&weld.acceleration_mm_s2).of(&beam.air_speed_mm_s).of(&weld.roughness).finish()
        });
        let plan = Hasher::default()
            .of(&surfaces)
            .of(scan)
            .of(&weld_report)
            .of(&weld.strategy)
            .of(&weld.bead_strategy)
            .of(&setup)
            .of(settings)
            .of(layers)
            .of(path)
            .of(bead)
            .of(recipes)
            .finish();
        let dose = Hasher::default().of(&plan).of(dose).finish();
        Keys { part, surfaces, scan: scan_keys, weld: weld_keys, weld_report, tool, cell: cell_key, setup, plan, dose }
    }
}

/// The key of a part.
pub(super) fn part_key(source: &Source, part: &JobPart) -> Digest {
    // The digest that the job was made for counts only by whether it is the digest of this file.
    let is_other = part.is_of_another_file(&source.sha256);
    let JobPart { file: _, sha256: _, units, weld, placement, flipped_shells, landmarks: _ } = part;
    Hasher::default().of(&source.sha256).of(&is_other).of(units).of(weld).of(placement).of(flipped_shells).finish()
}

fn surfaces_key(part: Digest, surfaces: &SurfaceParameters, settings: &Settings) -> Digest {
    let flipped: Vec<u32> = settings.having(|s| s.flipped).into_iter().map(|id| id.0).collect();
    Hasher::default().of(&part).of(surfaces).of(&flipped).finish()
}
