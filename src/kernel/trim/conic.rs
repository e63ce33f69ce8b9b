//! Arcs of parameters that are conics in space.
//!
//! A rational curve of degree 2 with the ends P and Q, c(t) = ((1−t)²P + 2t(1−t)Y + t²w₂Q) / ((1−t)² + 2t(1−t)w₁ + t²w₂),
//! is known by two more of its places with their parameters: equations in the plane of all of them that are linear in
//! Y, w₁ and w₂. The places are some that the arc was made through (`pull`), which are exact where those between are not.
//! Whether the arc is that curve tell others. Piegl & Tiller, *The NURBS Book*, §7.3.

use glam::{DVec2, DVec3, DVec4};

use super::pull::chebyshev_fraction;
use crate::{
    Frame, KnotVector, NurbsCurve, NurbsSurface,
    ceiling::{CONIC_PLACES, CONIC_SPANS},
    numeric::linear::solved,
    tolerance::{CONIC_PART, CONIC_RELATIVE, CONIC_SHARE},
};

/// About where on a piece the conic goes through places.
const THROUGH: [f64; 3] = [0.25, 0.75, 0.5];

/// Weights in the middle and at the end of a piece, where that at its start is one.
const WEIGHTS: [f64; 2] = [0.2, 5.0];

/// The curve in space along an arc of parameters at its own parameters, where that is made of conics up to rounding.
pub(super) fn conic_of(surface: &NurbsSurface, arc: &NurbsCurve) -> Option<NurbsCurve> {
    let breaks = arc.knots().breaks();
    if CONIC_SPANS < breaks.len() {
        return None;
    }
    let (u, v) = (surface.domain_u(), surface.domain_v());
    let at = |t: f64| {
        let place = arc.point_at(t);
        surface.point_at(place.x.clamp(u.start(), u.end()), place.y.clamp(v.start(), v.end()))
    };
    let allowed = CONIC_RELATIVE * surface.bounds().magnitude();
    // What is left of the difference from a conic vanishes in no more places of a span than its degree.
    let degree = arc.degree() * (surface.degree_u() + surface.degree_v()) + 2;
    let n_compared = CONIC_PLACES.min(degree + 1);
    let mut pieces: Vec<(f64, [DVec4; 3])> = Vec::new();
    let mut from = 0;
    while from + 1 < breaks.len() {
        // The first piece tells whether there is a conic at all; then each goes as far as it can.
        let mut piece = None;
        let wide = breaks[from] + CONIC_PART * (breaks[breaks.len() - 1] - breaks[0]);
        let first = breaks.partition_point(|&t| t < wide).clamp(from + 1, breaks.len() - 1);
        let (mut low, mut high) = (first, breaks.len());
        let mut to = low;
        while low < high {
            let spans = (&breaks[from..=to], arc.degree());
            match conic_between(&at, spans, n_compared, allowed) {
                Some(found) => (piece, low) = (Some((breaks[to], found)), to + 1),
                None => high = to,
            }
            to = low + (high - low) / 2;
        }
        let (end, mut points) = piece?;
        from = low - 1;
        if let Some((_, last)) = pieces.last() {
            let weight = last[2].w;
            points = points.map(|point| point * weight);
            points[0] = last[2];
        }
        pieces.push((end, points));
    }
    let (first, last) = (pieces.first()?, pieces.last()?);
    let mut knots = vec![breaks[0]; 3];
    let mut points = vec![first.1[0]];
    for (end, own) in &pieces {
        points.extend_from_slice(&own[1..]);
        knots.extend([*end; 2]);
    }
    knots.push(last.0);
    NurbsCurve::new(KnotVector::new(2, knots).ok()?, points).ok()
}

/// The parameters at which pieces of a degree between breaks go through exact places.
fn nodes(breaks: &[f64], degree: usize) -> Vec<f64> {
    let mut nodes = vec![breaks[0]];
    for pair in breaks.windows(2) {
        let inner = (1..degree.max(4)).map(|k| chebyshev_fraction(k, degree.max(4)));
        nodes.extend(inner.map(|fraction| pair[0] + (pair[1] - pair[0]) * fraction));
        nodes.push(pair[1]);
    }
    nodes
}

/// The Bézier points of the conic that a curve is over some spans of a degree, by exact places within them, where in
/// every span so many places are on it; of weight one at the first.
fn conic_between(
    at: &impl Fn(f64) -> DVec3,
    (breaks, degree): (&[f64], usize),
    n_compared: usize,
    allowed: f64,
) -> Option<[DVec4; 3]> {
    let nodes = nodes(breaks, degree);
    let (from, to) = (*nodes.first()?, *nodes.last()?);
    let place = |fraction: f64| at(from + (to - from) * fraction);
    let node = |fraction: f64| {
        let wanted = from + (to - from) * fraction;
        let after = nodes.partition_point(|&t| t < wanted).clamp(1, nodes.len() - 1);
        let (low, high) = (nodes[after - 1], nodes[after]);
        if wanted - low < high - wanted && from < low || to <= high { low } else { high }
    };
    let through = THROUGH.map(node);
    let [first, second, middle] = through.map(at);
    let (start, end) = (at(from), at(to));
    let chord = end - start;
    let frame = Frame::from_axes(start, chord, middle - start).ok()?;
    let size = chord.length();
    // In the plane of all of them, the chord from the origin to (1, 0).
    let local = |point: DVec3| {
        let out = (point - start) / size;
        DVec2::new(out.dot(frame.x()), out.dot(frame.y()))
    };
    if local(middle).y < CONIC_SHARE {
        return None;
    }
    let mut rows = Vec::with_capacity(4);
    for (t, point) in through.into_iter().zip([first, second]) {
        let (t, place) = ((t - from) / (to - from), local(point));
        let s = 1.0 - t;
        let both = 2.0 * t * s;
        rows.push(([both, 0.0, -both * place.x, t * t * (1.0 - place.x)], s * s * place.x));
        rows.push(([0.0, both, -both * place.y, -t * t * place.y], s * s * place.y));
    }
    let matrix = std::array::from_fn(|i| rows[i].0);
    let [x, y, middle, last] = solved::<4>(matrix, std::array::from_fn(|i| rows[i].1))?;
    let [least, most] = WEIGHTS;
    if [middle, last].iter().any(|weight| !(least..=most).contains(weight)) {
        return None;
    }
    let pole = frame.x() * x + frame.y() * y;
    let points = [
        start.extend(1.0),
        (start * middle + pole * size).extend(middle),
        (end * last).extend(last),
    ];
    let misses = |t: f64| {
        let s = 1.0 - t;
        let sum = points[0] * (s * s) + points[1] * (2.0 * t * s) + points[2] * (t * t);
        (sum.truncate() / sum.w).distance(place(t))
    };
    let is_on = |span: &[f64]| {
        (0..n_compared).all(|k| {
            let t = span[0] + (span[1] - span[0]) * (k as f64 + 0.5) / n_compared as f64;
            misses((t - from) / (to - from)) <= allowed
        })
    };
    breaks.windows(2).all(is_on).then_some(points)
}
