//! Curves as paths: lines, quadratic and cubic Bézier curves, which hold polynomials up to degree 3
//! exactly; others are cut until a cubic with their end points and tangents is near enough.

use glam::{DVec2, DVec3, DVec4};

use super::super::text::TextBuffer;
use crate::kernel::NurbsCurve;

/// Halvings of a piece. The error falls by sixteen with each, and by less than two at a cusp.
const MAX_HALVINGS: usize = 16;

/// Newton's steps to the foot of a point.
const N_STEPS: usize = 4;

/// Where a piece is compared with its cubic, in parts of it.
const PROBES: [f64; 5] = [0.15, 0.35, 0.5, 0.65, 0.85];

/// Writes path data. Points are in the view's coordinates, y upward; on paper it is downward.
pub(super) struct Pen {
    pub(super) text: TextBuffer,
    at: Option<DVec2>,
}

impl Pen {
    pub(super) fn new(decimals: usize) -> Self {
        Self { text: TextBuffer::rounded(Some(decimals)), at: None }
    }

    /// Draws a curve.
    pub(super) fn curve(&mut self, curve: &NurbsCurve, tolerance: f64) {
        let first = curve.start().truncate();
        self.at = None;
        let mut is_whole = true;
        for (i, piece) in curve.decompose().iter().enumerate() {
            let start = piece.start().truncate();
            let jumps = self.at.is_none_or(|at| tolerance < at.distance(start));
            is_whole &= i == 0 || !jumps;
            if jumps {
                self.command("M", &[start]);
            }
            self.piece(piece, tolerance);
        }
        let is_closed = self.at.is_some_and(|at| at.distance(first) <= tolerance);
        if is_whole && is_closed && 1 < curve.n_segments() * curve.degree() {
            self.text.push("Z");
        }
    }

    /// Draws a polygon.
    pub(super) fn polygon(&mut self, points: &[DVec3]) {
        for (i, point) in points.iter().enumerate() {
            self.command(if i == 0 { "M" } else { "L" }, &[point.truncate()]);
        }
    }

    /// Goes on along a Bézier piece.
    fn piece(&mut self, piece: &NurbsCurve, tolerance: f64) {
        if piece.is_rational() || 3 < piece.degree() {
            return self.approximated(piece, tolerance);
        }
        let points: Vec<DVec2> = piece.points().iter().map(|point| point.truncate()).collect();
        match points.len() {
            0 | 1 => {}
            2 => self.command("L", &points[1..]),
            3 => self.command("Q", &points[1..]),
            _ => self.command("C", &points[1..]),
        }
    }

    fn approximated(&mut self, piece: &NurbsCurve, tolerance: f64) {
        let mut todo = vec![(piece.clone(), 0)];
        while let Some((part, n_halvings)) = todo.pop() {
            let cubic = cubic(&part);
            let is_far = n_halvings < MAX_HALVINGS && tolerance < deviation(&part, &cubic);
            match part.split(part.domain().at(0.5)) {
                Ok([left, right]) if is_far => {
                    todo.extend([(right, n_halvings + 1), (left, n_halvings + 1)]);
                }
                _ => self.command("C", &cubic[1..]),
            }
        }
    }

    fn command(&mut self, letter: &str, points: &[DVec2]) {
        self.text.push(letter);
        for (i, point) in points.iter().enumerate() {
            self.text.push(if i == 0 { "" } else { " " });
            self.text.number(point.x).push(" ").number(-point.y);
        }
        self.at = points.last().copied();
    }
}

/// The cubic with the ends of a Bézier piece and their tangents. Of a conic it also has the point
/// in the middle, whose error falls by 64 with each halving.
///
/// Floater, *An O(h⁶) approximation of conic sections by quadratic and cubic curves*, §3.
fn cubic(piece: &NurbsCurve) -> [DVec2; 4] {
    let points = piece.control_points();
    let n = points.len();
    let end = |at: DVec4, next: DVec4| {
        let point = at.truncate() / at.w;
        let leg = (next.truncate() - point * next.w) / at.w;
        (point.truncate(), leg.truncate())
    };
    let ((a, ab), (d, dc)) = (end(points[0], points[1]), end(points[n - 1], points[n - 2]));
    let conic = points[1].w / (points[0].w * points[n - 1].w).sqrt();
    if n == 3 && 0.0 < conic {
        let length = |of: f64| 4.0 * conic / (3.0 * (1.0 + conic)) * of / points[1].w;
        return [a, a + ab * length(points[0].w), d + dc * length(points[2].w), d];
    }
    let degree = piece.degree() as f64;
    [a, a + ab * (degree / 3.0), d + dc * (degree / 3.0), d]
}

/// How far a piece is from its cubic where it is asked.
fn deviation(piece: &NurbsCurve, [a, b, c, d]: &[DVec2; 4]) -> f64 {
    let domain = piece.domain();
    let at = |s: f64| {
        let r = 1.0 - s;
        let point = r * r * (r * *a + 3.0 * s * *b) + s * s * (3.0 * r * *c + s * *d);
        // The foot of the point on the piece, by a few of Newton's steps.
        let mut t = domain.at(s);
        let mut nearest = f64::INFINITY;
        for _ in 0..N_STEPS {
            let derivatives = piece.derivatives_at(t, 1);
            let (gap, speed) = (point - derivatives[0].truncate(), derivatives[1].truncate());
            nearest = nearest.min(gap.length());
            let step = gap.dot(speed) / speed.length_squared();
            if !step.is_finite() {
                break;
            }
            t = (t + step).clamp(domain.start(), domain.end());
        }
        nearest
    };
    PROBES.into_iter().map(at).fold(0.0, f64::max)
}
