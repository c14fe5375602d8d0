//! The tools for a scan, and what each has gathered so far. Nothing here knows of the window.

use crate::document::model::{PickedPair, ScanRegion};
use crate::fit::{PlacedPair, rigid};
use crate::scan::cleaning::{Keep, Step};
use nalgebra::{Isometry3, Point3, Vector3};

/// Middles of a stroke lie at least this share of the brush's radius apart: the balls leave no gap, and a stroke across a
/// part is some dozens of them.
const STROKE_STEP: f64 = 0.5;

/// A tool for a scan, while it is in the hand.
#[derive(Clone, Debug, PartialEq)]
pub enum ScanTool {
    /// Points of the scan, and the same places on the model.
    Pairs(PairsDraft),
    /// What of the model does not count when the scan is laid.
    LeaveOut(LeaveOutDraft),
    /// A cut through the points, with what it would take out.
    Cut(CutDraft),
    /// The next clicks set labels.
    Label,
}

/// Pairs, in the order in which they were picked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PairsDraft {
    /// Whole ones.
    pub pairs: Vec<PickedPair>,
    /// The half of the next one on the scan, scan frame, mm.
    pub scan_mm: Option<[f64; 3]>,
    /// The half of the next one on the model, part frame, mm.
    pub model_mm: Option<[f64; 3]>,
}

/// Regions that are painted, or taken off.
#[derive(Clone, Debug, PartialEq)]
pub struct LeaveOutDraft {
    /// What the hand does.
    pub hand: LeaveOutHand,
    /// Radius of brush and rubber, mm.
    pub radius_mm: f64,
    /// Middles of the stroke that is being painted, part frame, mm.
    pub stroke: Vec<[f64; 3]>,
    /// The first corner of a box, part frame, mm.
    pub corner: Option<[f64; 3]>,
}

/// What the hand does on the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeaveOutHand {
    /// Paints.
    Brush,
    /// Takes regions off.
    Rubber,
    /// Sets two corners of a box.
    Corners,
}

/// A cleaning step that is being made.
#[derive(Clone, Debug, PartialEq)]
pub struct CutDraft {
    /// What cuts.
    pub shape: CutShape,
}

/// What cuts the points. Scan frame, mm.
#[derive(Clone, Debug, PartialEq)]
pub enum CutShape {
    /// A box along the axes of the scan.
    Box {
        /// Lowest corner.
        min: [f64; 3],
        /// Highest corner.
        max: [f64; 3],
        /// Which points stay.
        keep: Keep,
        /// The corner that was clicked first.
        corner: Option<[f64; 3]>,
    },
    /// A plane.
    Plane {
        /// A point of it before it was shifted.
        through: [f64; 3],
        /// Points to the side that stays; of any length.
        normal: [f64; 3],
        /// How far it is shifted along its normal, mm.
        shift_mm: f64,
        /// Points that were clicked: one, or two on the way to three.
        clicked: Vec<[f64; 3]>,
    },
    /// A brush.
    Brush {
        /// Middles of its strokes.
        centres: Vec<[f64; 3]>,
        /// Its radius, mm.
        radius_mm: f64,
    },
}

impl ScanTool {
    /// Whether a left drag paints.
    pub fn paints(&self) -> bool {
        match self {
            ScanTool::LeaveOut(draft) => draft.hand != LeaveOutHand::Corners,
            ScanTool::Cut(draft) => matches!(draft.shape, CutShape::Brush { .. }),
            ScanTool::Pairs(_) | ScanTool::Label => false,
        }
    }

    /// Whether the scan is shown in another place than on the part, or alone.
    pub fn moves_scan(&self) -> bool {
        matches!(self, ScanTool::Pairs(_) | ScanTool::Cut(_))
    }
}

impl PairsDraft {
    /// Takes the half on the scan.
    pub fn pick_scan(&mut self, at: Point3<f64>) {
        self.scan_mm = Some(at.coords.into());
        self.join();
    }

    /// Takes the half on the model.
    pub fn pick_model(&mut self, at: Point3<f64>) {
        self.model_mm = Some(at.coords.into());
        self.join();
    }

    fn join(&mut self) {
        if let (Some(scan_mm), Some(model_mm)) = (self.scan_mm, self.model_mm) {
            self.pairs.push(PickedPair { model_mm, scan_mm });
            (self.scan_mm, self.model_mm) = (None, None);
        }
    }

    /// The motion that the pairs tell by themselves; `None`: there are fewer than three.
    pub fn motion(&self) -> Option<Isometry3<f64>> {
        let placed = |p: &PickedPair| PlacedPair { from: p.scan_mm.into(), onto: p.model_mm.into(), weight: 1.0 };
        let pairs: Vec<PlacedPair> = self.pairs.iter().map(placed).collect();
        if pairs.len() < 3 { None } else { rigid(&pairs) }
    }

    /// How far the point of the scan is from its place on the model, of each pair, mm.
    pub fn residuals_mm(&self, model_from_scan: &Isometry3<f64>) -> Vec<f64> {
        let off = |p: &PickedPair| (model_from_scan * Point3::from(p.scan_mm) - Point3::from(p.model_mm)).norm();
        self.pairs.iter().map(off).collect()
    }
}

impl LeaveOutDraft {
    /// A brush with this radius, mm.
    pub fn new(radius_mm: f64) -> LeaveOutDraft {
        LeaveOutDraft { hand: LeaveOutHand::Brush, radius_mm, stroke: Vec::new(), corner: None }
    }

    /// Goes on with the stroke.
    pub fn paint(&mut self, at: Point3<f64>) {
        paint(&mut self.stroke, at, self.radius_mm);
    }

    /// The regions of the job with what the stroke does to them.
    pub fn regions(&self, of_job: &[ScanRegion]) -> Vec<ScanRegion> {
        let mut regions = of_job.to_vec();
        match self.hand {
            LeaveOutHand::Brush => {
                let ball =
                    |centre_mm: &[f64; 3]| ScanRegion::Sphere { centre_mm: *centre_mm, radius_mm: self.radius_mm };
                regions.extend(self.stroke.iter().map(ball));
            }
            LeaveOutHand::Rubber => {
                let is_touched =
                    |region: &ScanRegion| self.stroke.iter().any(|at| is_touched(region, at, self.radius_mm));
                regions.retain(|region| !is_touched(region));
            }
            LeaveOutHand::Corners => {}
        }
        regions
    }
}

/// Whether a rubber takes a region off: its middle goes over a ball's middle, or it stands in the region.
fn is_touched(region: &ScanRegion, at: &[f64; 3], radius_mm: f64) -> bool {
    let at = Point3::from(*at);
    let is_near = match region {
        ScanRegion::Sphere { centre_mm, .. } => (at - Point3::from(*centre_mm)).norm() <= radius_mm,
        ScanRegion::Box { .. } => false,
    };
    is_near || region.contains(&at)
}

impl CutDraft {
    /// The step that it makes.
    pub fn step(&self) -> Step {
        match &self.shape {
            CutShape::Box { min, max, keep, .. } => Step::CutBox { min: *min, max: *max, keep: *keep },
            CutShape::Plane { through, normal, shift_mm, .. } => {
                let along = Vector3::from(*normal).try_normalize(0.0).unwrap_or_else(Vector3::z);
                Step::CutPlane { point: (Point3::from(*through) + along * *shift_mm).coords.into(), normal: *normal }
            }
            CutShape::Brush { centres, radius_mm } => Step::Erase { centres: centres.clone(), radius_mm: *radius_mm },
        }
    }

    /// Takes a point that was clicked: a corner of the box; a point of the plane, or the third of three that it goes
    /// through. The side where `middle` is stays.
    pub fn click(&mut self, at: Point3<f64>, middle: &Point3<f64>) {
        let place: [f64; 3] = at.coords.into();
        match &mut self.shape {
            CutShape::Box { min, max, corner, .. } => match corner.take() {
                Some(first) => {
                    let [a, b] = [first, place].map(Point3::from);
                    (*min, *max) = (a.inf(&b).coords.into(), a.sup(&b).coords.into());
                }
                None => *corner = Some(place),
            },
            CutShape::Plane { through, normal, shift_mm, clicked } => {
                if clicked.len() == 3 {
                    clicked.clear();
                }
                clicked.push(place);
                (*through, *shift_mm) = (clicked[0], 0.0);
                if let [a, b, c] = clicked.as_slice() {
                    let [a, b, c] = [*a, *b, *c].map(Point3::from);
                    if let Some(across) = (b - a).cross(&(c - a)).try_normalize(1e-9) {
                        let sign = if (middle - a).dot(&across) < 0.0 { -1.0 } else { 1.0 };
                        *normal = (across * sign).into();
                    }
                }
            }
            CutShape::Brush { .. } => self.paint(at),
        }
    }

    /// Goes on with the stroke of a brush.
    pub fn paint(&mut self, at: Point3<f64>) {
        if let CutShape::Brush { centres, radius_mm } = &mut self.shape {
            paint(centres, at, *radius_mm);
        }
    }
}

fn paint(stroke: &mut Vec<[f64; 3]>, at: Point3<f64>, radius_mm: f64) {
    if stroke.iter().all(|p| (at - Point3::from(*p)).norm() > STROKE_STEP * radius_mm) {
        stroke.push(at.coords.into());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_become_a_pair_in_either_order_and_three_pairs_tell_a_motion() {
        let motion = Isometry3::new(Vector3::new(5.0, -2.0, 1.0), Vector3::new(0.3, 0.2, -0.4));
        let mut draft = PairsDraft::default();
        for (i, p) in [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [0.0, 8.0, 1.0]].map(Point3::from).into_iter().enumerate() {
            assert_eq!(draft.motion(), None);
            if i == 1 {
                draft.pick_model(motion * p);
                draft.pick_scan(p);
            } else {
                draft.pick_scan(Point3::new(99.0, 0.0, 0.0));
                draft.pick_scan(p);
                draft.pick_model(motion * p);
            }
            assert_eq!((draft.pairs.len(), draft.scan_mm, draft.model_mm), (i + 1, None, None));
        }
        let found = draft.motion().expect("three pairs");
        assert!(draft.residuals_mm(&found).iter().all(|mm| *mm < 1e-9));
        assert!(draft.residuals_mm(&Isometry3::identity()).iter().all(|mm| *mm > 1.0));
    }

    #[test]
    fn a_stroke_paints_balls_and_the_rubber_takes_off_what_it_touches() {
        let mut draft = LeaveOutDraft::new(2.0);
        for x in 0..=40 {
            draft.paint(Point3::new(0.1 * f64::from(x), 0.0, 0.0));
        }
        let painted = draft.regions(&[]);
        assert_eq!(painted.len(), 4, "one for more than every millimetre");
        assert!((0..=40).all(|x| painted.iter().any(|r| r.contains(&Point3::new(0.1 * f64::from(x), 0.0, 0.0)))));
        let cuboid = ScanRegion::Box { min_mm: [10.0; 3], max_mm: [20.0; 3] };
        let all = [painted.as_slice(), &[cuboid]].concat();
        let rubbed = |at: [f64; 3]| {
            LeaveOutDraft { hand: LeaveOutHand::Rubber, stroke: vec![at], ..LeaveOutDraft::new(0.5) }.regions(&all)
        };
        assert_eq!(rubbed([15.0; 3]), painted, "the box goes as a whole");
        assert!(rubbed([0.0; 3]).len() < all.len());
        assert_eq!(rubbed([-9.0; 3]), all);
    }

    #[test]
    fn three_clicks_lay_a_plane_and_the_part_stays() {
        let shape = CutShape::Plane { through: [0.0; 3], normal: [1.0, 0.0, 0.0], shift_mm: 3.0, clicked: Vec::new() };
        let mut draft = CutDraft { shape };
        let middle = Point3::new(0.0, 0.0, 50.0);
        for at in [[0.0, 0.0, 1.0], [0.0, 10.0, 1.0], [10.0, 0.0, 1.0]].map(Point3::from) {
            draft.click(at, &middle);
        }
        let Step::CutPlane { point, normal } = draft.step() else { panic!("a plane") };
        assert_eq!(point, [0.0, 0.0, 1.0]);
        assert!((Vector3::from(normal) - Vector3::z()).norm() < 1e-12);
        if let CutShape::Plane { shift_mm, .. } = &mut draft.shape {
            *shift_mm = 2.0;
        }
        assert!(matches!(draft.step(), Step::CutPlane { point: [0.0, 0.0, z], .. } if (z - 3.0).abs() < 1e-12));
    }

    #[test]
    fn two_clicks_make_a_box_whichever_comes_first() {
        let shape = CutShape::Box { min: [0.0; 3], max: [1.0; 3], keep: Keep::Inside, corner: None };
        let mut draft = CutDraft { shape };
        draft.click(Point3::new(5.0, -1.0, 2.0), &Point3::origin());
        assert_eq!(draft.step(), Step::CutBox { min: [0.0; 3], max: [1.0; 3], keep: Keep::Inside });
        draft.click(Point3::new(1.0, 4.0, 3.0), &Point3::origin());
        assert_eq!(draft.step(), Step::CutBox { min: [1.0, -1.0, 2.0], max: [5.0, 4.0, 3.0], keep: Keep::Inside });
    }
}
