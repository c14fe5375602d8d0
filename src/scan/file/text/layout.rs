//! What the columns of a text are, told by its beginning: a line or a comment that names them, or else how many there
//! are and what numbers stand in them.

use super::row::{MOST, Row, is_comment};
use super::{places, scale};
use crate::scan::file::decimal::Comma;
use crate::scan::file::gather::ColourScale;
use crate::scan::file::role::{Role, Roles};
use crate::scan::file::stream::Lines;
use crate::scan::file::{Assumed, ScanFileError};

/// The columns of a text.
#[derive(Debug)]
pub(super) struct Layout {
    pub comma: Comma,
    /// Cells of the first row.
    pub width: usize,
    pub roles: Roles,
    /// Those that are read.
    pub columns: Vec<(usize, Role)>,
    /// Those of x, y and z.
    pub places: [usize; 3],
    pub scale: ColourScale,
    /// What was taken because nothing names the columns, where it is more than x, y and z.
    pub assumed: Option<Assumed>,
    pub has_decimal_commas: bool,
    /// The line that names the columns, from 1; 0: none does.
    pub names_line: u64,
    /// Lines of the beginning.
    pub lines_seen: u64,
}

/// So many rows tell what their numbers are.
const LOOKED_AT: usize = 1000;

/// A cell more or less that a line of names may have than the rows: some begin with a mark of their own, or end early.
const SLACK: usize = 1;

/// Normals of text files are rounded to few digits; colours are far off one.
const UNIT: std::ops::RangeInclusive<f64> = 0.98..=1.02;

impl Layout {
    /// Looks at whole lines of the beginning.
    ///
    /// # Errors
    /// [`ScanFileError::Unknown`]: there are no rows; [`ScanFileError::NoCoordinates`], [`ScanFileError::NoPoints`].
    pub fn of(begin: &[u8], name: &str) -> Result<Layout, ScanFileError> {
        let (mut named, mut words): (Option<Named>, Option<Vec<String>>) = (None, None);
        let mut rest = Lines(begin);
        let mut number = 0;
        let first = loop {
            let here = rest.0;
            let Some(line) = rest.next() else {
                let has_said_more = named.is_some();
                return Err(if has_said_more { ScanFileError::NoPoints } else { ScanFileError::Unknown });
            };
            number += 1;
            let comma = comma_of(line);
            let row = Row::of(line, comma);
            let is_row = |of: &[Option<Role>]| row.width > 1 && places(of).iter().all(|p| row.is_number(*p));
            let begins = row.width > 1 && row.words & 0b111 == 0;
            if !is_comment(line) && (begins || named.as_ref().is_some_and(|n| is_row(&n.roles.of))) {
                break (row, comma, here);
            }
            let names = names_of(line);
            match Roles::named(names.iter().map(String::as_str)) {
                Ok(roles) => named = Some(Named { roles, line: number, in_comment: is_comment(line) }),
                Err(_) if !is_comment(line) && row.words != 0 => words = Some(names),
                Err(_) => {}
            }
        };
        let (row, comma, rows) = first;
        let width = row.width;
        let seen = Lines(rows).filter(|l| !is_comment(l)).map(|l| Row::of(l, comma));
        let seen: Vec<Row> = seen.filter(|r| r.width == width).take(LOOKED_AT).collect();
        // A comment that happens to hold these words, among others, names nothing.
        let named = named.filter(|n| !n.in_comment || n.roles.of.len().abs_diff(width) <= SLACK);
        if named.is_none() && words.as_ref().is_some_and(|w| w.len().abs_diff(width) <= SLACK && width >= 3) {
            return Err(ScanFileError::NoCoordinates { columns: words.unwrap_or_default() });
        }
        let has_decimal_commas = comma == Comma::IsPoint && rows.contains(&b',');
        let (roles, names_line, assumed) = match named {
            Some(named) => (named.roles, named.line, None),
            None => {
                let (roles, assumed) = assumed(&seen, width, name)?;
                (roles, 0, assumed)
            }
        };
        let columns: Vec<(usize, Role)> = roles
            .of
            .iter()
            .enumerate()
            .filter_map(|(k, r)| r.map(|r| (k, r)))
            .filter(|(k, _)| *k < width.min(MOST))
            .collect();
        let places = places(&roles.of);
        if places.iter().any(|p| *p >= width.min(MOST)) {
            return Err(ScanFileError::NoCoordinates { columns: (1..=width).map(|k| k.to_string()).collect() });
        }
        let colours = columns.iter().filter(|(_, r)| matches!(r, Role::Colour(_)));
        let has_fractions = colours.clone().any(|(k, _)| seen.iter().any(|r| r.values[*k].fract() != 0.0));
        let scale = scale(has_fractions);
        let lines_seen = Lines(begin).count() as u64;
        Ok(Layout { comma, width, roles, columns, places, scale, assumed, has_decimal_commas, names_line, lines_seen })
    }
}

/// Columns by their names.
struct Named {
    roles: Roles,
    line: u64,
    in_comment: bool,
}

/// What a comma is in a row. With semicolons, or with words of digits around one comma and no point among blanks, it
/// stands for a decimal point: `1,5 2,5 3,5` is three numbers, `1,2,3` too.
fn comma_of(line: &[u8]) -> Comma {
    if line.contains(&b';') {
        return Comma::IsPoint;
    }
    let words: Vec<&[u8]> = line.split(u8::is_ascii_whitespace).filter(|w| !w.is_empty()).collect();
    let commas = |w: &&[u8]| w.iter().filter(|b| **b == b',').count();
    let is_decimal = |w: &&[u8]| {
        w.iter().position(|b| *b == b',').is_some_and(|at| at > 0 && w.get(at + 1).is_some_and(u8::is_ascii_digit))
    };
    let all_fit = words.iter().all(|w| commas(w) == 0 || (commas(w) == 1 && is_decimal(w)));
    let is_point = words.len() >= 3 && all_fit && words.iter().any(is_decimal) && !line.contains(&b'.');
    if is_point { Comma::IsPoint } else { Comma::Delimits }
}

/// The cells of a line of words, without the mark of a comment.
fn names_of(line: &[u8]) -> Vec<String> {
    let text = String::from_utf8_lossy(line);
    let text = text.trim().trim_start_matches(['#', '%', '!', '/']).trim();
    let divides = |c: char| matches!(c, ',' | ';' | '\t');
    let words: Vec<&str> =
        if text.contains(divides) { text.split(divides).collect() } else { text.split_ascii_whitespace().collect() };
    words.into_iter().map(|w| w.trim().trim_matches('"').to_owned()).collect()
}

/// Columns by their number: 3 are x y z, 4 with intensity, 6 with a normal or a colour, 7 with intensity and colour
/// (PTS). The endings .xyzn and .xyzrgb say which of the two six are.
fn assumed(seen: &[Row], width: usize, name: &str) -> Result<(Roles, Option<Assumed>), ScanFileError> {
    let has_ending = |e: &str| name.to_ascii_lowercase().ends_with(e);
    let three = |row: &Row| [row.values[3], row.values[4], row.values[5]];
    let all = |is: fn([f64; 3]) -> bool| seen.iter().map(three).all(is);
    let colour = [Role::Colour(0), Role::Colour(1), Role::Colour(2)].map(Some);
    let normal = [Role::Normal(0), Role::Normal(1), Role::Normal(2)].map(Some);
    let mut of = [Role::Place(0), Role::Place(1), Role::Place(2)].map(Some).to_vec();
    let assumed = match width {
        0..=2 => return Err(ScanFileError::NoCoordinates { columns: (1..=width).map(|k| k.to_string()).collect() }),
        4 if seen.iter().any(|r| r.is_number(3)) => {
            of.push(Some(Role::Intensity));
            Some(Assumed::XyzIntensity)
        }
        6 if has_ending(".xyzn") || (!has_ending(".xyzrgb") && all(|v| UNIT.contains(&length(v)))) => {
            of.extend(normal);
            Some(Assumed::XyzNormal)
        }
        6 if has_ending(".xyzrgb") || all(|v| v.iter().all(|c| c.fract() == 0.0 && (0.0..=255.0).contains(c))) => {
            of.extend(colour);
            Some(Assumed::XyzRgb)
        }
        7 => {
            of.push(Some(Role::Intensity));
            of.extend(colour);
            Some(Assumed::XyzIntensityRgb)
        }
        3 => None,
        _ => Some(Assumed::Xyz),
    };
    let unread = (of.len() + 1..=width).map(|k| k.to_string()).collect();
    Ok((Roles { of, unread }, assumed))
}

fn length([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}
