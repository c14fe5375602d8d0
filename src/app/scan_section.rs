//! A section through part and scan across an axis: the outline of the model, and the points of the scan beside the plane,
//! with what they are off the model drawn so many times as large. Made again where plane or scan are others.

use crate::part::{Part, Surfaces};
use crate::path::normals::VertexNormals;
use crate::path::section::sections;
use crate::picture::DeviationScale;
use crate::picture::palette::Rgb;
use crate::picture::regions::RegionLines;
use crate::planning::scanned::{ComparedScan, LaidScan};
use crate::scan::deviation::Plane;
use crate::view::LineItem;
use nalgebra::{Isometry3, Point3, Vector3};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Points count that lie so many of their spacings off the plane, at the most: an outline has no holes then.
const BAND: f64 = 1.5;
/// Corners of the model's outline closer than this share of its size are one.
const MERGE_SHARE: f64 = 1e-7;
/// Squared sine of the angle below which a surface counts as lying in the plane: 13°.
const LEAST_STEEP: f64 = 0.05;
const WIDTH_PX: f32 = 2.5;

/// Where the section is, and how it is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionAsked {
    /// Across which axis of the part: 0, 1, 2.
    pub axis: usize,
    /// Where on it, part frame, mm; `None`: in the middle of the part.
    pub at_mm: Option<f64>,
    /// How many times as large what is off the model is drawn.
    pub times: f64,
}

impl Default for SectionAsked {
    fn default() -> Self {
        SectionAsked { axis: 0, at_mm: None, times: 20.0 }
    }
}

impl SectionAsked {
    /// Which axes the drawing has to the right and upwards.
    pub fn across(&self) -> [usize; 2] {
        match self.axis {
            0 => [1, 2],
            1 => [0, 2],
            _ => [0, 1],
        }
    }

    /// Where the plane stands on its axis in a part, mm.
    pub fn at_mm(&self, part: &Part) -> f64 {
        let (min, max) = part.mesh.bounds();
        self.at_mm.unwrap_or(0.5 * (min[self.axis] + max[self.axis])).clamp(min[self.axis], max[self.axis])
    }
}

/// What a section is made from.
pub(super) struct SectionOf<'a> {
    pub part: &'a Arc<Part>,
    pub surfaces: &'a Surfaces,
    /// The part that the scan was compared with.
    pub file_part: &'a Arc<Part>,
    pub laid: &'a LaidScan,
    pub compared: &'a Arc<ComparedScan>,
    pub scale: DeviationScale,
}

/// The section that is shown, kept while it stays.
#[derive(Default)]
pub(super) struct SectionView(Option<Section>);

struct Section {
    asked: SectionAsked,
    part: Arc<Part>,
    compared: Arc<ComparedScan>,
    scale: DeviationScale,
    /// Lines of the model on the plane, mm.
    outline: Vec<Vec<[f64; 2]>>,
    /// Points of the scan on the plane by their colour, mm.
    points: BTreeMap<Rgb, Vec<[f64; 2]>>,
    /// The outline in the view, part frame.
    line: LineItem,
}

impl SectionView {
    /// Makes it anew where something is another; `None`: nothing is to be shown.
    pub fn sync(&mut self, asked: &SectionAsked, of: Option<&SectionOf<'_>>) {
        let Some(of) = of else {
            self.0 = None;
            return;
        };
        let is_known = |s: &Section| {
            s.asked == *asked
                && s.scale == of.scale
                && Arc::ptr_eq(&s.part, of.part)
                && Arc::ptr_eq(&s.compared, of.compared)
        };
        if !self.0.as_ref().is_some_and(is_known) {
            self.0 = Some(Section::new(asked, of));
        }
    }

    /// The outline of the model in the view.
    pub fn line(&self) -> Option<&LineItem> {
        self.0.as_ref().map(|s| &s.line)
    }

    /// The outline of the model as a drawing, mm.
    pub fn outline(&self) -> &[Vec<[f64; 2]>] {
        self.0.as_ref().map_or(&[], |s| &s.outline)
    }

    /// The points of the scan as a drawing by their colours, mm.
    pub fn points(&self) -> impl Iterator<Item = (&Rgb, &Vec<[f64; 2]>)> {
        self.0.iter().flat_map(|s| &s.points)
    }
}

impl Section {
    fn new(asked: &SectionAsked, of: &SectionOf<'_>) -> Section {
        let normal = [Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis()][asked.axis];
        let at_mm = asked.at_mm(of.part);
        let lines = outline(of.part, of.surfaces, &normal, at_mm);
        let [right, up] = asked.across();
        let flat = |p: &Point3<f64>| [p[right], p[up]];
        let plane = Plane { through: Point3::from(normal.into_inner() * at_mm), normal };
        let band_mm = BAND / of.compared.density_per_mm2.max(1e-6).sqrt();
        let (cloud, deviation) = (&of.laid.cloud_in_part, &of.compared.deviation);
        let smoothed_mm = of.compared.smoothed_mm();
        let mut points: BTreeMap<Rgb, Vec<[f64; 2]>> = BTreeMap::new();
        for found in deviation.section(cloud, &plane, band_mm) {
            let Some(foot) = deviation.foot(of.file_part, cloud, found.index) else { continue };
            let off_mm = f64::from(smoothed_mm[found.index as usize]);
            let out = of.file_part.mesh.normals[deviation.facet[found.index as usize] as usize];
            // Along the surface onto the plane; what lies flat in the plane has no outline there.
            let along = normal.into_inner() - out * normal.dot(&out);
            if !off_mm.is_finite() || along.norm_squared() < LEAST_STEEP {
                continue;
            }
            let on_plane = foot - along * ((foot - plane.through).dot(&normal) / along.norm_squared());
            let shown = on_plane + out * (off_mm * asked.times);
            points.entry(of.scale.color(off_mm)).or_default().push(flat(&shown));
        }
        Section {
            asked: *asked,
            part: of.part.clone(),
            compared: of.compared.clone(),
            scale: of.scale,
            outline: lines.iter().map(|line| line.iter().map(flat).collect()).collect(),
            points,
            line: line_item(&lines),
        }
    }
}

/// The lines in which a plane cuts all surfaces.
fn outline(part: &Part, surfaces: &Surfaces, normal: &Vector3<f64>, at_mm: f64) -> Vec<Vec<Point3<f64>>> {
    let merge_mm = MERGE_SHARE * part.mesh.diagonal();
    let mut lines = Vec::new();
    for surface in &surfaces.list {
        let normals = VertexNormals::new(&part.mesh, surfaces, surface);
        for line in sections(&part.mesh, surface, &normals, normal, &[at_mm], merge_mm) {
            let closing = line.points.first().filter(|_| line.closed);
            lines.push(line.points.iter().chain(closing).map(|s| s.p).collect());
        }
    }
    lines
}

fn line_item(lines: &[Vec<Point3<f64>>]) -> LineItem {
    let mut drawn = RegionLines::default();
    lines.iter().for_each(|line| drawn.line(line));
    drawn.item_of_width(WIDTH_PX, Isometry3::identity())
}
