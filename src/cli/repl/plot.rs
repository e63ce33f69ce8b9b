//! Plots in a terminal: lines of braille signs, each with two by four dots.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use crate::{
    export::View,
    kernel::{Mesh, Tolerance},
    value::shortest,
};

/// Columns of a plot where the terminal has more.
const MOST_COLUMNS: usize = 240;
/// Dots from one of an axis to the next.
const AXIS_STEP: usize = 4;
/// Lines of a plot.
const MOST_LINES: usize = 20;
/// Digits of a label.
const DIGITS: usize = 5;
/// Lines of a chart.
const CHART_LINES: usize = 12;

/// Triangles of a mesh that are drawn each; with more their edges would fill the picture.
const MOST_TRIANGLES: usize = 200;
/// The angle, in radians, between triangles from which on the edge between them is an outline.
const CREASE: f64 = 0.5;

/// What is drawn.
pub(super) enum PlotSubject {
    Path(Vec<DVec3>),
    Mesh(Arc<Mesh>),
}

/// Dots in cells of two by four.
struct Canvas {
    columns: usize,
    lines: usize,
    cells: Vec<u8>,
}

impl Canvas {
    fn new(columns: usize, lines: usize) -> Self {
        Self { columns, lines, cells: vec![0; columns * lines] }
    }

    /// The largest dot.
    fn size(&self) -> DVec2 {
        DVec2::new((2 * self.columns) as f64 - 1.0, (4 * self.lines) as f64 - 1.0)
    }

    /// Sets the dot at a place, counted from the lower left.
    fn dot(&mut self, at: DVec2) {
        // A cast stops at the ends of the range.
        let (x, y) = (at.x.round() as usize, (self.size().y - at.y).round() as usize);
        /// The bit of each dot of a cell, by column and line.
        const BITS: [[u8; 4]; 2] = [[0, 1, 2, 6], [3, 4, 5, 7]];
        if x / 2 < self.columns && y / 4 < self.lines {
            self.cells[y / 4 * self.columns + x / 2] |= 1 << BITS[x % 2][y % 4];
        }
    }

    fn line(&mut self, from: DVec2, to: DVec2) {
        let n_steps = (to - from).abs().max_element().ceil().clamp(1.0, 1000.0) as usize;
        (0..=n_steps).for_each(|i| self.dot(from.lerp(to, i as f64 / n_steps as f64)));
    }

    /// Draws the line of height zero where it lies between `low` and `high`.
    fn axis(&mut self, low: f64, high: f64) {
        if !(low < 0.0 && 0.0 < high) {
            return;
        }
        let size = self.size();
        let y = -low / (high - low) * size.y;
        (0..=size.x as usize).step_by(AXIS_STEP).for_each(|x| self.dot(DVec2::new(x as f64, y)));
    }

    /// Draws paths that lie between `low` and `high` over the whole canvas.
    fn paths(&mut self, paths: &[Vec<DVec2>], (low, high): (DVec2, DVec2)) {
        let span = (high - low).max(DVec2::splat(f64::MIN_POSITIVE));
        let size = self.size();
        let place = |p: DVec2| {
            let at = ((p - low) / span).clamp(DVec2::ZERO, DVec2::ONE) * size;
            DVec2::select((high - low).cmpgt(DVec2::ZERO), at, 0.5 * size)
        };
        for path in paths {
            match path.as_slice() {
                [one] => self.dot(place(*one)),
                path => path
                    .windows(2)
                    .filter(|leg| leg.iter().all(|end| end.is_finite()))
                    .for_each(|leg| self.line(place(leg[0]), place(leg[1]))),
            }
        }
    }

    /// A line of text for each line of cells.
    fn text(&self) -> Vec<String> {
        let sign = |&cell: &u8| char::from_u32(0x2800 + u32::from(cell)).unwrap_or(' ');
        self.cells.chunks(self.columns).map(|line| line.iter().map(sign).collect()).collect()
    }
}

/// The smallest box around points; `None` without any that is finite.
fn bounds(paths: &[Vec<DVec2>]) -> Option<(DVec2, DVec2)> {
    let mut points = paths.iter().flatten().copied().filter(|point| point.is_finite());
    let first = points.next()?;
    Some(points.fold((first, first), |(low, high), p| (low.min(p), high.max(p))))
}

/// Paths in their own proportions, no wider than `columns`.
pub(super) fn drawing(paths: &[Vec<DVec2>], columns: usize) -> String {
    let Some((low, high)) = bounds(paths) else { return String::new() };
    let most = columns.clamp(4, MOST_COLUMNS);
    let span = high - low;
    // Dots are square: a cell is as wide as two and as high as four.
    let lines = (most as f64 * 0.5 * span.y / span.x.max(f64::MIN_POSITIVE)).ceil();
    let (columns, lines) = if lines <= MOST_LINES as f64 {
        (most, lines.max(1.0) as usize)
    } else {
        let columns = (MOST_LINES as f64 * 2.0 * span.x / span.y).ceil();
        (columns.clamp(1.0, most as f64) as usize, MOST_LINES)
    };
    let mut canvas = Canvas::new(columns, lines);
    canvas.paths(paths, (low, high));
    canvas.text().join("\n") + "\n"
}

/// Functions by their values, each axis in its own measure, no wider than `columns`. Values that
/// are not finite are left out.
pub(super) fn chart(paths: &[Vec<DVec2>], columns: usize) -> String {
    let Some((mut low, mut high)) = bounds(paths) else { return String::new() };
    let mut labels = [high.y, low.y].map(|value| short(value, DIGITS));
    // What differs in no digit of the labels is a constant with its rounding.
    let is_constant = labels[0] == labels[1];
    if is_constant {
        let middle = f64::midpoint(low.y, high.y);
        (low.y, high.y) = (middle, middle);
        labels[1].clear();
    }
    let top = if is_constant { CHART_LINES / 2 } else { 0 };
    let margin = labels.iter().map(|label| label.chars().count()).max().unwrap_or(0);
    let width = columns.min(MOST_COLUMNS).saturating_sub(margin + 2).max(4);
    let mut canvas = Canvas::new(width, CHART_LINES);
    canvas.axis(low.y, high.y);
    canvas.paths(paths, (low, high));
    let mut text = String::new();
    for (i, line) in canvas.text().into_iter().enumerate() {
        let label = match i {
            _ if i == top => &labels[0],
            _ if i + 1 == CHART_LINES => &labels[1],
            _ => "",
        };
        text.push_str(&format!("{label:>margin$} ┤{line}\n"));
    }
    let (from, to) = (short(low.x, DIGITS), short(high.x, DIGITS));
    let gap = width.saturating_sub(from.chars().count() + to.chars().count()).max(1);
    text.push_str(&format!("{:margin$}  {from}{:gap$}{to}\n", "", ""));
    text
}

/// A number in so many digits.
pub(super) fn short(value: f64, n_digits: usize) -> String {
    let rounded: f64 = format!("{value:.*e}", n_digits - 1).parse().unwrap_or(value);
    shortest(rounded)
}

/// Shapes of space in a view, else seen along the axis in which they reach least far, as paths, and
/// the axes of the picture. Of a mesh of many triangles only the outlines are drawn.
pub(super) fn flat(shapes: &[PlotSubject], view: Option<View>) -> (Vec<Vec<DVec2>>, &'static str) {
    let (view, axes) = match view {
        Some(view) => (view, axes_of(view)),
        None => least_deep(shapes),
    };
    let toward = view.toward();
    let paths = shapes.iter().flat_map(|shape| match shape {
        PlotSubject::Path(points) => vec![points.clone()],
        PlotSubject::Mesh(mesh) if mesh.n_triangles() <= MOST_TRIANGLES => {
            mesh.corners().map(|[a, b, c]| vec![a, b, c, a]).collect()
        }
        PlotSubject::Mesh(mesh) => {
            let lines = mesh.outlines(toward, CREASE, Tolerance::default());
            lines.into_iter().map(Vec::from).collect()
        }
    });
    let see = |path: Vec<DVec3>| path.into_iter().map(|point| view.on_paper(point)).collect();
    (paths.map(see).collect(), axes)
}

/// The axes of a view in words.
fn axes_of(view: View) -> &'static str {
    match view {
        View::Top => "x to the right, y up",
        View::Front => "x to the right, z up",
        View::Right => "y to the right, z up",
        View::Bottom => "x to the right, y down",
        View::Back => "x to the left, z up",
        View::Left => "y to the left, z up",
        View::Isometric => "x down to the right, y up to the right, z up",
        View::Oblique => "x to the right, z up, y into the depth",
    }
}

/// The view along the axis in which shapes reach least far.
fn least_deep(shapes: &[PlotSubject]) -> (View, &'static str) {
    let of = |shape: &PlotSubject| match shape {
        PlotSubject::Path(points) => points.clone(),
        PlotSubject::Mesh(mesh) => {
            mesh.bounds().map_or(Vec::new(), |bounds| vec![bounds.min, bounds.max])
        }
    };
    let ends: Vec<DVec3> = shapes.iter().flat_map(of).collect();
    let points = || ends.iter().copied().filter(|point| point.is_finite());
    let low = points().fold(DVec3::INFINITY, DVec3::min);
    let high = points().fold(DVec3::NEG_INFINITY, DVec3::max);
    let span = high - low;
    let view = if span.z <= span.x && span.z <= span.y {
        View::Top
    } else if span.y <= span.x {
        View::Front
    } else {
        View::Right
    };
    (view, axes_of(view))
}

#[cfg(test)]
mod tests {
    use super::{chart, drawing};
    use glam::DVec2;

    #[test]
    fn a_diagonal_goes_from_corner_to_corner() {
        let path = vec![DVec2::ZERO, DVec2::ONE];
        assert_eq!(drawing(&[path], 4), "⠀⠀⡠⠊\n⡠⠊⠀⠀\n");
        assert_eq!(drawing(&[], 4), "");
        let flat = drawing(&[vec![DVec2::ZERO, DVec2::X]], 6);
        assert_eq!(flat.lines().count(), 1);
    }

    #[test]
    fn a_chart_tells_its_measures() {
        let chart = chart(&[vec![DVec2::new(0.0, -1.0), DVec2::new(2.0, 3.0)]], 20);
        let lines: Vec<&str> = chart.lines().collect();
        assert!(lines[0].starts_with(" 3 ┤") && lines[11].starts_with("-1 ┤"), "{chart}");
        assert!(lines[12].trim().starts_with('0') && lines[12].ends_with('2'), "{chart}");
        assert!(lines.iter().all(|line| line.chars().count() <= 20), "{chart}");
    }

    #[test]
    fn a_chart_of_a_constant_is_a_line_and_not_its_rounding() {
        let waves = (0..50).map(|i| DVec2::new(f64::from(i), 1.0 + 1e-15 * f64::from(i % 3)));
        let chart = chart(&[waves.collect()], 20);
        let is_dot = |c: char| matches!(c, '\u{2801}'..='\u{28ff}');
        let drawn: Vec<&str> = chart.lines().filter(|line| line.contains(is_dot)).collect();
        assert_eq!(drawn.len(), 1, "{chart}");
        assert!(drawn[0].starts_with("1 ┤") && chart.matches("1 ┤").count() == 1, "{chart}");
    }

    #[test]
    fn a_chart_leaves_out_what_is_not_finite() {
        let gap = vec![DVec2::ZERO, DVec2::new(1.0, f64::NAN), DVec2::new(2.0, 1.0)];
        let ends = [vec![DVec2::ZERO], vec![DVec2::new(2.0, 1.0)]];
        let empty = |c: char| matches!(c, '\u{2801}'..='\u{28ff}');
        assert!(!chart(&[gap], 20).contains(empty));
        assert_eq!(chart(&ends, 20).chars().filter(|&c| empty(c)).count(), 2);
    }
}
