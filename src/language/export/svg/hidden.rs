//! What of a line is seen: the rest lies behind triangles.
//!
//! A segment is hidden by a triangle where its picture is inside the triangle's and it lies
//! behind the triangle's plane by more than a margin, so that lines on a surface are not hidden
//! by the triangles near it. Both conditions are linear along the segment, so each triangle hides
//! one interval of it. A grid over the picture finds the triangles. Appel, *The notion of
//! quantitative invisibility and the machine rendering of solids*, ACM 1967, in its simplest form.

use glam::{DVec2, DVec3};

use crate::{
    kernel::{Interval, NurbsCurve, sorting::sort_by, tolerance::DRAWING_DIGIT},
    limits::work,
};

/// Margin in tolerances of the triangles: theirs, that of the polygon of a curve, and some.
const MARGIN: f64 = 2.5;

/// Halvings of a span where a curve is looked at.
const MAX_HALVINGS: usize = 10;

/// Cells of the grid along a segment that are looked at together.
const STEP: f64 = 4.0;

/// Cells of the grid.
const MOST_CELLS: usize = 4_000_000;

/// A triangle with its plane's normal toward the viewer.
struct HidingTriangle {
    corners: [DVec3; 3],
    normal: DVec3,
}

/// The triangles that hide, by their place in the picture.
pub(super) struct HidingScene {
    triangles: Vec<HidingTriangle>,
    corner: DVec2,
    /// Width and height of a cell.
    cell: DVec2,
    n_cells: [usize; 2],
    /// Where the members of each cell begin, and where the last end.
    firsts: Vec<usize>,
    members: Vec<u32>,
    margin: f64,
    near: f64,
}

impl HidingScene {
    /// Triangles in the view's coordinates, within `near` of their surfaces.
    pub(super) fn new(corners: impl Iterator<Item = [DVec3; 3]>, near: f64) -> Self {
        let watched = corners.take_while(|_| work::goes_on(1));
        let triangles: Vec<HidingTriangle> = watched.filter_map(HidingTriangle::new).collect();
        let all = || triangles.iter().flat_map(|triangle| triangle.corners);
        let low = all().fold(DVec3::INFINITY, DVec3::min).truncate();
        let high = all().fold(DVec3::NEG_INFINITY, DVec3::max).truncate();
        let size = (high - low).max(DVec2::ZERO);
        let cell = cell_size(&triangles, size);
        let n_cells = (size / cell).to_array().map(|n| n as usize + 1);
        let corner = if triangles.is_empty() { DVec2::ZERO } else { low };
        let (firsts, members) = (vec![0; n_cells[0] * n_cells[1] + 1], Vec::new());
        let margin = MARGIN * near;
        let mut scene = Self { triangles, corner, cell, n_cells, firsts, members, margin, near };
        scene.sort_in();
        scene
    }

    /// Notes for each cell the triangles that may reach into it.
    fn sort_in(&mut self) {
        let mut counts = vec![0_usize; self.firsts.len()];
        for triangle in &self.triangles {
            let mut n_cells = 0;
            self.each_cell(&triangle.corners, |cell| {
                counts[cell + 1] += 1;
                n_cells += 1;
            });
            if !work::goes_on(n_cells) {
                return;
            }
        }
        for i in 1..counts.len() {
            counts[i] += counts[i - 1];
        }
        let mut members = vec![0; counts[counts.len() - 1]];
        let mut next = counts.clone();
        for (idx, triangle) in self.triangles.iter().enumerate() {
            self.each_cell(&triangle.corners, |cell| {
                members[next[cell]] = idx as u32;
                next[cell] += 1;
            });
        }
        (self.firsts, self.members) = (counts, members);
    }

    /// The cells that the box around some points touches.
    fn each_cell(&self, points: &[DVec3], mut visit: impl FnMut(usize)) {
        let low = points.iter().copied().fold(DVec3::INFINITY, DVec3::min).truncate();
        let high = points.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max).truncate();
        let place = |p: DVec2| {
            let q = (p - self.corner) / self.cell;
            // Whatever is outside by rounding, or far, belongs to the cell at the border.
            [q.x as usize, q.y as usize]
        };
        let (from, to) = (place(low), place(high));
        for i in from[0].min(self.n_cells[0] - 1)..=to[0].min(self.n_cells[0] - 1) {
            for j in from[1].min(self.n_cells[1] - 1)..=to[1].min(self.n_cells[1] - 1) {
                visit(i * self.n_cells[1] + j);
            }
        }
    }

    /// Whether nothing hides a point.
    pub(super) fn is_seen(&self, point: DVec3) -> bool {
        self.hidden(point, point).is_empty()
    }

    /// The parts of a curve that are seen.
    pub(super) fn seen_parts(&self, curve: &NurbsCurve) -> Vec<NurbsCurve> {
        if self.triangles.is_empty() {
            return vec![curve.clone()];
        }
        curve.connected_parts().iter().flat_map(|part| self.seen_of_part(part)).collect()
    }

    /// [`Self::seen_parts`] of a curve that does not jump.
    fn seen_of_part(&self, curve: &NurbsCurve) -> Vec<NurbsCurve> {
        let (parameters, points) = polygon(curve, self.near);
        let seen = self.seen(&points);
        let at = |place: f64| {
            let idx = (place as usize).min(parameters.len() - 2);
            let (a, b) = (parameters[idx], parameters[idx + 1]);
            a + (b - a) * (place - idx as f64)
        };
        let last = (points.len() - 1) as f64;
        if matches!(seen[..], [[from, to]] if from <= 0.0 && last <= to) {
            return vec![curve.clone()];
        }
        let part = |[from, to]: [f64; 2]| curve.trimmed(Interval::new(at(from), at(to)).ok()?).ok();
        seen.into_iter().filter_map(part).collect()
    }

    /// The parts of a polygon that are seen.
    pub(super) fn seen_pieces(&self, points: &[DVec3]) -> Vec<Vec<DVec3>> {
        let place = |at: f64| {
            let idx = (at as usize).min(points.len() - 2);
            points[idx].lerp(points[idx + 1], at - idx as f64)
        };
        let piece = |[from, to]: [f64; 2]| {
            let inner = (from.floor() as usize + 1)..(to.ceil() as usize);
            let mut piece = vec![place(from)];
            piece.extend_from_slice(&points[inner]);
            piece.push(place(to));
            piece
        };
        self.seen(points).into_iter().map(piece).collect()
    }

    /// The seen intervals of a polygon, one unit a leg.
    fn seen(&self, points: &[DVec3]) -> Vec<[f64; 2]> {
        let mut seen: Vec<[f64; 2]> = Vec::new();
        for (i, leg) in points.windows(2).enumerate() {
            let mut from = 0.0;
            let hidden = self.hidden(leg[0], leg[1]);
            for [start, end] in hidden.into_iter().chain([[1.0, 1.0]]) {
                if DRAWING_DIGIT < start - from {
                    let part = [i as f64 + from, i as f64 + start];
                    match seen.last_mut() {
                        Some(last) if part[0] <= last[1] => last[1] = part[1],
                        _ => seen.push(part),
                    }
                }
                from = end;
            }
        }
        seen
    }

    /// The hidden intervals of a segment on 0..1, in order and apart.
    fn hidden(&self, a: DVec3, b: DVec3) -> Vec<[f64; 2]> {
        let mut hidden: Vec<[f64; 2]> = Vec::new();
        if self.triangles.is_empty() {
            return hidden;
        }
        let n_cells = ((b - a).truncate() / self.cell).length();
        let n_steps = (n_cells / STEP).ceil().clamp(1.0, MOST_CELLS as f64) as usize;
        for step in 0..n_steps {
            let ends = [step, step + 1].map(|i| a.lerp(b, i as f64 / n_steps as f64));
            self.each_cell(&ends, |cell| {
                let members = &self.members[self.firsts[cell]..self.firsts[cell + 1]];
                if !work::goes_on(1 + members.len() as u64) {
                    return;
                }
                for &idx in members {
                    hidden.extend(self.triangles[idx as usize].hides(a, b, self.margin));
                }
            });
        }
        sort_by(&mut hidden, |a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        let mut merged: Vec<[f64; 2]> = Vec::new();
        for [start, end] in hidden {
            match merged.last_mut() {
                Some(last) if start <= last[1] + DRAWING_DIGIT => last[1] = last[1].max(end),
                _ => merged.push([start, end]),
            }
        }
        merged
    }
}

/// Width and height of the cells: those of a triangle of the middle size, so that few are in a cell
/// and few cells in a triangle, also where all are long and thin; no more cells than triangles.
fn cell_size(triangles: &[HidingTriangle], size: DVec2) -> DVec2 {
    let wanted = triangles.len().clamp(1, MOST_CELLS) as f64;
    let middle = |axis: usize| {
        let extent = |triangle: &HidingTriangle| {
            let places = triangle.corners.map(|corner| corner[axis]);
            places.into_iter().fold(f64::NEG_INFINITY, f64::max)
                - places.into_iter().fold(f64::INFINITY, f64::min)
        };
        let mut extents: Vec<f64> = triangles.iter().map(extent).collect();
        let half = extents.len() / 2;
        if extents.is_empty() {
            0.0
        } else {
            *extents.select_nth_unstable_by(half, f64::total_cmp).1
        }
    };
    let least = DVec2::new(middle(0), middle(1)).max(size / wanted);
    let n_cells = (size / least).max(DVec2::ONE);
    let cell = least * (n_cells.x * n_cells.y / wanted).sqrt().max(1.0);
    let usable = |cell: f64| if 0.0 < cell && cell.is_finite() { cell } else { 1.0 };
    DVec2::new(usable(cell.x), usable(cell.y))
}

impl HidingTriangle {
    /// None for what is seen from the edge, and hides nothing.
    fn new([a, b, c]: [DVec3; 3]) -> Option<Self> {
        let sides = [b - a, c - a];
        // Of sides of any size the product is one.
        let scale = 1.0 / sides[0].abs().max(sides[1].abs()).max_element();
        let normal = (sides[0] * scale).cross(sides[1] * scale).try_normalize()?;
        if normal.z < 0.0 {
            Some(Self { corners: [a, c, b], normal: -normal })
        } else {
            (0.0 < normal.z).then_some(Self { corners: [a, b, c], normal })
        }
    }

    /// The part of a segment on 0..1 that it hides.
    fn hides(&self, a: DVec3, b: DVec3, margin: f64) -> Option<[f64; 2]> {
        let mut part = [0.0_f64, 1.0_f64];
        let depth = |point: DVec3| -self.normal.dot(point - self.corners[0]) - margin;
        keep_positive(depth(a), depth(b), &mut part)?;
        for i in 0..3 {
            let (from, to) = (self.corners[i].truncate(), self.corners[(i + 1) % 3].truncate());
            let inside = |point: DVec3| (to - from).perp_dot(point.truncate() - from);
            keep_positive(inside(a), inside(b), &mut part)?;
        }
        Some(part)
    }
}

/// Cuts off of an interval where a function is negative that is linear between `a` at 0 and `b`
/// at 1; none where nothing is left.
fn keep_positive(a: f64, b: f64, part: &mut [f64; 2]) -> Option<()> {
    if a < 0.0 && b < 0.0 {
        return None;
    }
    if a < 0.0 {
        part[0] = part[0].max(a / (a - b));
    } else if b < 0.0 {
        part[1] = part[1].min(a / (a - b));
    }
    (part[0] <= part[1]).then_some(())
}

/// Parameters and points of a polygon near a curve.
fn polygon(curve: &NurbsCurve, near: f64) -> (Vec<f64>, Vec<DVec3>) {
    let start = curve.domain().start();
    let (mut parameters, mut points) = (vec![start], vec![curve.point_at(start)]);
    let is_straight = curve.degree() <= 1 && !curve.is_rational();
    for span in curve.knots().spans() {
        let mut todo = vec![(curve.knots().span_interval(span), 0)];
        while work::goes_on(1)
            && let Some((part, n_halvings)) = todo.pop()
        {
            let [a, b] = [part.start(), part.end()].map(|t| curve.point_at(t));
            let bend = |s: f64| curve.point_at(part.at(s)).distance(a.lerp(b, s));
            let is_bent = || n_halvings < 2 || near < bend(0.5).max(bend(0.25)).max(bend(0.75));
            let middle = part.at(0.5);
            let halves = (Interval::new(part.start(), middle), Interval::new(middle, part.end()));
            match halves {
                (Ok(left), Ok(right)) if !is_straight && n_halvings < MAX_HALVINGS && is_bent() => {
                    todo.extend([(right, n_halvings + 1), (left, n_halvings + 1)]);
                }
                _ => {
                    parameters.push(part.end());
                    points.push(b);
                }
            }
        }
    }
    (parameters, points)
}
