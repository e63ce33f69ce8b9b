//! Which curves are lines and circles, whatever form they are in.
//!
//! A line or circle is proposed from three points, and proven: what a homogeneous Bézier piece
//! makes of its implicit equation is a polynomial whose coefficients must vanish, up to rounding.
//! So must be that the curve never turns back, and that it runs around once at most.

use std::f64::consts::{PI, TAU};

use glam::{DVec3, DVec4};

use crate::{
    Frame, Tolerance,
    bernstein::{derivative, product},
    bezier,
    ceiling::HALF_TURN_HALVINGS,
    curve::NurbsCurve,
    frame::{norm, unit},
    homogeneous,
    tolerance::{ANALYTIC_RELATIVE, LAST_BIT, SIGN_RELATIVE},
};

/// Last bits of the radius that the equation of a circle may lose.
const ROUNDINGS: f64 = 4.0;

/// A curve with an equation, run through once from one end to the other.
///
/// A rational curve of degree 2 may be a circle, and is told as one:
///
/// ```
/// use virote_kernel::{AnalyticCurve, Frame, NurbsCurve};
///
/// let quarter = NurbsCurve::arc(Frame::XY, 2.0, 0.0, std::f64::consts::FRAC_PI_2)?;
/// let Some(AnalyticCurve::Circle { radius, turn, .. }) = quarter.analytic() else {
///     unreachable!("it is a circle");
/// };
/// assert!((radius - 2.0).abs() < 1e-14 && (turn - std::f64::consts::FRAC_PI_2).abs() < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnalyticCurve {
    /// A straight line.
    Line {
        /// The first point.
        start: DVec3,
        /// The unit vector toward the last.
        direction: DVec3,
        /// The distance of both, model units.
        length: f64,
    },
    /// An arc of a circle.
    Circle {
        /// About the centre, with x toward the first point and the arc counter-clockwise about z.
        frame: Frame,
        /// The radius, model units.
        radius: f64,
        /// The angle from the first point to the last, radians; of all of a circle a full turn.
        turn: f64,
    },
}

impl NurbsCurve {
    /// The line or circle that it is up to rounding; none for any other curve, for one with
    /// weights of zero or below, and for one that turns back or goes around more than once.
    #[must_use]
    pub fn analytic(&self) -> Option<AnalyticCurve> {
        self.analytic_within(ANALYTIC_RELATIVE * self.bounds().magnitude())
    }

    /// The line or circle that it is up to a distance, which is that of rounding.
    pub(crate) fn analytic_within(&self, allowed: f64) -> Option<AnalyticCurve> {
        if self.degree() == 0 || self.control_points.iter().any(|point| point.w <= 0.0) {
            return None;
        }
        self.line_form(allowed).or_else(|| self.circle_form(allowed))
    }

    fn line_form(&self, allowed: f64) -> Option<AnalyticCurve> {
        let (start, end) = (self.start(), self.end());
        let (direction, length) = (unit(end - start)?, norm(end - start));
        let is_near = |point: &DVec4| {
            let out = homogeneous::project(*point) - start;
            norm(out - direction * out.dot(direction)) <= allowed
        };
        if !self.control_points.iter().all(is_near) || length <= allowed {
            return None;
        }
        let never_turns_back = self.knots.spans().all(|span| {
            let piece = bezier::piece(&self.knots, &self.control_points, span);
            // Places along the line with their weights: w²·x′ is the product of both.
            let local: Vec<DVec4> = piece
                .iter()
                .map(|p| DVec4::new(p.w, (p.truncate() - start * p.w).dot(direction), 0.0, p.w))
                .collect();
            sense(&local) == Some(1.0)
        });
        never_turns_back.then_some(AnalyticCurve::Line { start, direction, length })
    }

    fn circle_form(&self, allowed: f64) -> Option<AnalyticCurve> {
        // As far apart as they are to be had.
        let is_closed = self.start().distance(self.end()) <= allowed;
        let last = if is_closed { 2.0 / 3.0 } else { 1.0 };
        let points = [0.0, 0.5 * last, last].map(|part| self.point_at(self.domain().at(part)));
        let (center, normal) = circle_through(points)?;
        self.arc_about(rounded_place(center, allowed), normal, allowed)
    }

    /// The arc about a centre in the plane of a normal that it is up to a distance.
    pub(crate) fn arc_about(
        &self,
        center: DVec3,
        normal: DVec3,
        allowed: f64,
    ) -> Option<AnalyticCurve> {
        let start = self.start();
        let digits = |direction: DVec3| Some(rounded_place(unit(direction)?, ANALYTIC_RELATIVE));
        let (normal, x) = (digits(normal)?, digits(start - center)?);
        let frame = Frame::from_normal(center, normal, Some(x)).ok()?;
        let radius = rounded(norm(start - center), allowed);
        // So wide a circle that its centre is not known well enough, or its equation.
        if allowed < ROUNDINGS * LAST_BIT * radius {
            return None;
        }
        let map = frame.from_space();
        let mut turn = 0.0;
        for span in self.knots.spans() {
            let mut local = bezier::piece(&self.knots, &self.control_points, span);
            local.iter_mut().for_each(|point| *point = homogeneous::transformed(*point, &map));
            let is_flat = local.iter().all(|point| point.z.abs() <= allowed * point.w);
            if !is_flat || !is_round(&local, radius, allowed) {
                return None;
            }
            let part = turn_of(&local, HALF_TURN_HALVINGS)?;
            if part * turn < 0.0 {
                return None;
            }
            turn += part;
        }
        let (normal, turn) = if turn < 0.0 { (-normal, -turn) } else { (normal, turn) };
        let frame = Frame::from_normal(center, normal, Some(x)).ok()?;
        let is_closed = PI < turn && start.distance(self.end()) <= allowed;
        let slack = Tolerance::DEFAULT.angle;
        match (turn - TAU).abs() <= slack {
            true => is_closed.then_some(AnalyticCurve::Circle { frame, radius, turn: TAU }),
            false if is_closed || TAU < turn => None,
            false => Some(AnalyticCurve::Circle { frame, radius, turn }),
        }
    }
}

/// A number without the digits that are rounding: what is proposed is rounded, so that files have
/// the numbers of scripts, before it is proven.
pub(crate) fn rounded(x: f64, allowed: f64) -> f64 {
    let most = f64::from(f64::MAX_10_EXP);
    let n_digits = libm::ceil(1.0 - libm::log10(allowed)).clamp(0.0, most) as usize;
    // Adding zero takes the sign from a zero.
    format!("{x:.n_digits$}").parse().unwrap_or(x) + 0.0
}

/// [`rounded`] coordinates.
pub(crate) fn rounded_place(place: DVec3, allowed: f64) -> DVec3 {
    DVec3::from_array(place.to_array().map(|x| rounded(x, allowed)))
}

/// The centre of the circle through three points, and a normal of its plane.
fn circle_through([a, b, c]: [DVec3; 3]) -> Option<(DVec3, DVec3)> {
    let (to_b, to_c) = (b - a, c - a);
    let normal = to_b.cross(to_c);
    let squared = normal.length_squared();
    let out = (to_b * to_c.length_squared() - to_c * to_b.length_squared()).cross(normal);
    let center = a - out / (2.0 * squared);
    Some((center, unit(normal)?)).filter(|(center, _)| center.is_finite())
}

/// Whether a Bézier piece keeps a distance from the z axis: the quotient of x² + y² − r²w² and
/// w², which is twice the radius times how far it misses, lies between those of the coefficients.
fn is_round(piece: &[DVec4], radius: f64, allowed: f64) -> bool {
    let equation = |a: DVec4, b: DVec4| a.x * b.x + a.y * b.y - radius * radius * a.w * b.w;
    let misses = product(piece, piece, equation);
    let weights = product(piece, piece, |a, b| a.w * b.w);
    let most = 2.0 * radius * allowed;
    misses.iter().zip(weights).all(|(miss, w)| miss.is_finite() && miss.abs() <= most * w)
}

/// The angle by which (x, y) of a piece turns about the origin, if it never turns back.
fn turn_of(piece: &[DVec4], n_left: usize) -> Option<f64> {
    let (first, last) = (piece[0], piece[piece.len() - 1]);
    let middle = first / libm::hypot(first.x, first.y) + last / libm::hypot(last.x, last.y);
    let is_within_half_a_turn = piece.iter().all(|p| 0.0 < p.x * middle.x + p.y * middle.y);
    if is_within_half_a_turn && sense(piece).is_some() {
        let across = first.x * last.y - first.y * last.x;
        return Some(libm::atan2(across, first.x * last.x + first.y * last.y));
    }
    if n_left == 0 {
        return None;
    }
    let (before, behind) = bezier::cut_at(piece, 0.5);
    let [before, behind] = [before, behind].map(|half| turn_of(&half, n_left - 1));
    let (before, behind) = (before?, behind?);
    (0.0 <= before * behind).then_some(before + behind)
}

/// Which way (x, y) of a piece turns about the origin all along: the sign of xy′ − yx′.
fn sense(piece: &[DVec4]) -> Option<f64> {
    let turning = product(piece, &derivative(piece), |p, slope| p.x * slope.y - p.y * slope.x);
    let least = turning.iter().copied().fold(f64::INFINITY, f64::min);
    let most = turning.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let rounding = SIGN_RELATIVE * most.max(-least);
    if -rounding <= least && rounding < most {
        return Some(1.0);
    }
    (most <= rounding && least < -rounding).then_some(-1.0)
}
