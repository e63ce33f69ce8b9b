//! Where an offset stands still: where `1 + d·κ` vanishes.
//!
//! With V a positive multiple of the velocity, flat about the normal, and w the denominator, κ is
//! b·w²/|V|³ with b = (V × V')·n. So the roots are those of |V|⁶ − d²b²w⁴ where d·b is negative: a
//! polynomial, whose changes of sign and whose touching minima are isolated by its Bernstein
//! coefficients and not looked for between samples.

use glam::DVec3;

use super::CurveOffsetTarget;
use crate::{
    Interval, Side,
    bernstein::{derivative, halves, largest, product},
    bezier,
    ceiling::CUSP_HALVINGS,
    curve::{
        NurbsCurve,
        intersection::bend::{add, longest},
    },
    numeric::polynomial_roots::Signs,
    tolerance::{CUSP_SLACK, SIGN_RELATIVE},
    work,
};

/// The speed varies by no more than this in a part that is looked at; it enters in the sixth power.
const MOST_VARIATION: f64 = 4.0;

/// Part of a piece: V flat about the normal, and w.
struct PieceRange {
    interval: Interval,
    velocity: Vec<DVec3>,
    weight: Vec<f64>,
    n_halvings: usize,
}

/// Parameters where the offset stands still, in order; of a stretch of them its two ends.
pub(super) fn cusps(curve: &NurbsCurve, aim: CurveOffsetTarget) -> Vec<f64> {
    let (mut crossing, mut turning) = (Signs::default(), Signs::default());
    let mut found = Vec::new();
    for piece in curve.pieces() {
        let flat = |slope: &DVec3| slope.reject_from_normalized(aim.normal);
        let velocity = piece.velocity.iter().map(flat).collect();
        let weight = piece.weight.clone();
        let mut todo =
            vec![PieceRange { interval: piece.interval, velocity, weight, n_halvings: 0 }];
        while work::goes_on(1)
            && let Some(part) = todo.pop()
        {
            let fastest = longest(&part.velocity);
            let along = part.velocity.iter().sum::<DVec3>().normalize_or_zero();
            let slowest = part.velocity.iter().map(|v| v.dot(along)).fold(f64::INFINITY, f64::min);
            if slowest * MOST_VARIATION < fastest && part.n_halvings < CUSP_HALVINGS {
                todo.extend(part.halves());
                continue;
            }
            // Of a part that stands still the curvature tells nothing.
            if 0.0 < slowest {
                let stands = part.follow(aim, fastest, [&mut crossing, &mut turning]);
                found.extend(stands.into_iter().flatten());
            }
        }
    }
    found.extend(crossing.changes().iter().map(|&(t, _)| t));
    let breaks = curve.knots().breaks();
    let speeds = |t: f64| [Side::Left, Side::Right].map(|side| speed(curve, aim, t, side));
    let stands = |t: &f64| speeds(*t).iter().any(|speed| speed.abs() <= CUSP_SLACK);
    let candidates = turning.changes().iter().map(|&(t, _)| t);
    found.extend(candidates.chain(breaks.iter().copied()).filter(stands));
    // A knot at which the curvature leaps past the cusp.
    found.extend(breaks.into_iter().filter(|&t| {
        let [before, behind] = speeds(t);
        before * behind < 0.0
    }));
    // A polynomial in the square of the distance has the cusps of the other side too.
    found.retain(|&t| speeds(t).iter().any(|&speed| speed < 0.5));
    found.sort_by(f64::total_cmp);
    curve.without_repeats(found)
}

impl PieceRange {
    /// In the order in which a stack gives them back.
    fn halves(self) -> [Self; 2] {
        let points: Vec<glam::DVec4> = self.velocity.iter().map(|v| v.extend(0.0)).collect();
        let (before, behind) = bezier::cut_at(&points, 0.5);
        let weights = halves(&self.weight);
        let [first, second] = self.interval.halves();
        let n_halvings = self.n_halvings + 1;
        let flat = |points: Vec<glam::DVec4>| points.iter().map(|v| v.truncate()).collect();
        let [earlier, later] = weights;
        [
            Self { interval: second, velocity: flat(behind), weight: later, n_halvings },
            Self { interval: first, velocity: flat(before), weight: earlier, n_halvings },
        ]
    }

    /// Follows the polynomial and its slope; the ends of the part if it is zero all along.
    fn follow(
        &self,
        aim: CurveOffsetTarget,
        fastest: f64,
        signs: [&mut Signs; 2],
    ) -> Option<[f64; 2]> {
        let times = |a: f64, b: f64| a * b;
        let velocity: Vec<DVec3> = self.velocity.iter().map(|&v| v / fastest).collect();
        let heaviest = largest(&self.weight);
        let weight: Vec<f64> = self.weight.iter().map(|&w| w / heaviest).collect();
        let squared = product(&velocity, &velocity, DVec3::dot);
        let mut excess = product(&product(&squared, &squared, times), &squared, times);
        let bend = product(&velocity, &derivative(&velocity), |a, b| a.cross(b).dot(aim.normal));
        let turn = product(&bend, &product(&weight, &weight, times), times);
        // The slope of V is one by the parameter of the part, as V is by that of the whole piece.
        let halvings = libm::ldexp(1.0, i32::try_from(self.n_halvings).unwrap_or(0));
        let scale = aim.distance * heaviest * heaviest * halvings / fastest;
        let turn: Vec<f64> = turn.iter().map(|b| b * scale).collect();
        let square = product(&turn, &turn, times);
        let rounding = SIGN_RELATIVE * (1.0 + largest(&square));
        add(&mut excess, &square, -1.0);
        let slope = derivative(&excess);
        let [crossing, turning] = signs;
        crossing.follow(self.interval, &excess, rounding);
        turning.follow(self.interval, &slope, rounding);
        let is_zero = largest(&excess) <= rounding;
        is_zero.then(|| [self.interval.start(), self.interval.end()])
    }
}

/// `1 + d·κ`, κ positive for a turn to the left: how fast the offset goes beside the curve. Not a
/// number where the curve stands still.
pub(super) fn speed(curve: &NurbsCurve, aim: CurveOffsetTarget, t: f64, side: Side) -> f64 {
    let derivatives = curve.derivatives_beside(t, side, 2);
    let [first, second] = [1, 2].map(|k| derivatives[k].reject_from_normalized(aim.normal));
    let length = first.length();
    1.0 + aim.distance * first.cross(second).dot(aim.normal) / (length * length * length)
}
