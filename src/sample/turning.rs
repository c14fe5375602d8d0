//! A shaft in the making, from low to high x: outlines joined by walls and shoulders, and a centre hole at either end.
//!
//! Only what turns and mills about one axis; keyways are put in by who knows them.

use super::outline::{Flat, at_x, circle};
use super::shell::{Facing, Point, Shell, Triangles};

/// Rows of facets are about this long, mm.
const ROW_MM: f64 = 3.0;

/// Centre holes: radii at the mouth and of the pilot, depths of cone (60°), pilot and point, mm.
pub(super) const MOUTH: f64 = 3.5;
pub(super) const PILOT: f64 = 1.6;
pub(super) const CONE_DEPTH: f64 = 3.29;
pub(super) const PILOT_DEPTH: f64 = 7.5;
pub(super) const POINT_DEPTH: f64 = 8.4;

/// A shaft of which the skin is closed up to an outline.
pub(super) struct Turning {
    pub shell: Shell,
    /// Where the skin ends as yet, and the outline there.
    pub x: f64,
    pub outline: Vec<Flat>,
}

impl Turning {
    /// Begins at x = 0 with an end face and the centre hole in it.
    pub(super) fn begun(outline: Vec<Flat>) -> Turning {
        let mut shell = Shell::new();
        let ([mouth, throat, bottom], point) = centre_hole(0.0, 1.0);
        shell.fan_from(point, &bottom);
        shell.wall(&bottom, &throat, 2);
        shell.wall(&throat, &mouth, 2);
        shell.face(Facing::MinusX, &at_x(&outline, 0.0), &[&mouth]);
        Turning { shell, x: 0.0, outline }
    }

    /// A wall to another outline of as many points.
    pub(super) fn wall(&mut self, x: f64, outline: Vec<Flat>) {
        let rows = ((x - self.x) / ROW_MM).round().max(1.0) as usize;
        self.shell.wall(&at_x(&self.outline, self.x), &at_x(&outline, x), rows);
        (self.x, self.outline) = (x, outline);
    }

    /// A shoulder to another outline that lies wholly outside or inside of this one.
    pub(super) fn shoulder(&mut self, outline: Vec<Flat>) {
        let (here, next) = (at_x(&self.outline, self.x), at_x(&outline, self.x));
        let reach = |points: &[Flat]| points.iter().map(|p| p[0] * p[0] + p[1] * p[1]).fold(0.0, f64::max);
        if reach(&outline) > reach(&self.outline) {
            self.shell.face(Facing::MinusX, &next, &[&here]);
        } else {
            self.shell.face(Facing::PlusX, &here, &[&next]);
        }
        self.outline = outline;
    }

    /// Ends with an end face and the centre hole in it.
    pub(super) fn ended(mut self) -> Triangles {
        let ([mouth, throat, bottom], point) = centre_hole(self.x, -1.0);
        self.shell.face(Facing::PlusX, &at_x(&self.outline, self.x), &[&mouth]);
        self.shell.wall(&mouth, &throat, 2);
        self.shell.wall(&throat, &bottom, 2);
        self.shell.fan(&bottom, point);
        self.shell.into_triangles()
    }
}

/// Loops of a centre hole from its mouth at `x` inwards, and its point; `inwards` is 1 where x rises into the shaft.
fn centre_hole(x: f64, inwards: f64) -> ([Vec<Point>; 3], Point) {
    let at = |radius: f64, depth: f64| at_x(&circle([0.0, 0.0], radius, 48), x + inwards * depth);
    ([at(MOUTH, 0.0), at(PILOT, CONE_DEPTH), at(PILOT, PILOT_DEPTH)], [x + inwards * POINT_DEPTH, 0.0, 0.0])
}
