//! Points and derivatives of one curve at many parameters.
//!
//! Each piece is brought to Bézier form once; after that the knots cost a look into a table, and a
//! point a sum of products of t and 1 − t. The Bézier form is as accurate as the recurrence over
//! the knots, at any degree: nothing cancels, and the ends of a piece are control points. Farin,
//! *Curves and Surfaces for CAGD*, §5.8; conversion by Ramshaw's blossoms, *Blossoming: a
//! connect-the-dots approach to splines*.

use glam::{DVec3, DVec4};

use super::NurbsCurve;
use crate::kernel::{KnotVector, homogeneous};

/// From here on every `f64` is a whole number.
const WHOLE: f64 = (1_u64 << 52) as f64;

/// A curve prepared to be evaluated at many parameters.
///
/// Its points are those of the curve up to rounding. It holds p + 1 points and four numbers for
/// each piece; to make it takes as long as some points of each piece by [`NurbsCurve::point_at`].
///
/// ```
/// use glam::DVec3;
/// use virote::kernel::NurbsCurve;
///
/// let peak = [DVec3::ZERO, DVec3::new(1.0, 2.0, 0.0), DVec3::new(2.0, 0.0, 0.0)];
/// let parabola = NurbsCurve::bezier(&peak)?.evaluator();
/// assert_eq!(parabola.point_at(0.5), DVec3::new(1.0, 1.0, 0.0));
/// let [_, velocity, acceleration] = parabola.second_order_at(0.5);
/// assert_eq!([velocity, acceleration], [DVec3::new(2.0, 0.0, 0.0), DVec3::new(0.0, -8.0, 0.0)]);
/// # Ok::<(), virote::kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct CurveEvaluator {
    degree: usize,
    is_rational: bool,
    pieces: Vec<Piece>,
    /// Homogeneous Bézier points, p + 1 of each piece.
    points: Vec<DVec4>,
    /// First piece that a parameter of each equal part of the domain can lie in.
    first_of_part: Vec<usize>,
    /// Start of the domain.
    start: f64,
    /// Parts over the length of the domain.
    per_part: f64,
    /// The number of the last part.
    last_part: f64,
}

/// The parameters of a piece.
#[derive(Clone, Copy, Debug)]
struct Piece {
    start: f64,
    end: f64,
    /// `1 / (end − start)`.
    per_width: f64,
}

/// A parameter within its piece, from both ends: `s` from the start, `r = 1 − s` from the end.
#[derive(Clone, Copy, Debug)]
struct Place {
    piece: usize,
    s: f64,
    r: f64,
}

impl NurbsCurve {
    /// The same curve, prepared to be evaluated at many parameters. O(p²) for each piece.
    #[must_use]
    pub fn evaluator(&self) -> CurveEvaluator {
        let piece = |span: usize| {
            let interval = self.knots.span_interval(span);
            let (start, end) = (interval.start(), interval.end());
            Piece { start, end, per_width: 1.0 / (end - start) }
        };
        let pieces: Vec<Piece> = self.knots.spans().map(piece).collect();
        let mut points = Vec::with_capacity(pieces.len() * (self.degree() + 1));
        for span in self.knots.spans() {
            points.extend_from_slice(&self.control_points[self.knots.support(span)]);
            let first = points.len() - (self.degree() + 1);
            convert_to_bezier(&self.knots, span, &mut points[first..]);
        }

        let (domain, n_pieces) = (self.domain(), pieces.len());
        let mut evaluator = CurveEvaluator {
            degree: self.degree(),
            is_rational: self.is_rational,
            pieces,
            points,
            first_of_part: Vec::with_capacity(n_pieces + 1),
            start: domain.start(),
            per_part: n_pieces as f64 / domain.length(),
            last_part: n_pieces as f64,
        };
        let mut piece = 0;
        for part in 0..=n_pieces {
            while piece + 1 < n_pieces && evaluator.part_at(evaluator.pieces[piece].end) < part {
                piece += 1;
            }
            evaluator.first_of_part.push(piece);
        }
        evaluator
    }
}

impl CurveEvaluator {
    /// Point at parameter `t`; outside the domain the first and the last piece go on.
    ///
    /// O(p), without allocation; a search only where knots crowd.
    #[must_use]
    #[inline]
    pub fn point_at(&self, t: f64) -> DVec3 {
        let place = self.place_at(t);
        homogeneous::project(match self.degree {
            1 => blend(self.bezier::<2>(place), place),
            2 => blend(self.bezier::<3>(place), place),
            3 => blend(self.bezier::<4>(place), place),
            _ => blend(self.bezier_points(place), place),
        })
    }

    /// Point, first and second derivative at `t`; at a knot those of the piece to its right, at
    /// the end of the domain those from the left.
    ///
    /// O(p), without allocation. Of the derivatives by the place in the piece, which are
    /// differences, to those in space by Piegl & Tiller, *The NURBS Book*, (4.8).
    #[must_use]
    #[inline]
    pub fn second_order_at(&self, t: f64) -> [DVec3; 3] {
        let place = self.place_at(t);
        let [value, slope, bend] = match self.degree {
            2 => second_order(self.bezier::<3>(place), place),
            3 => second_order(self.bezier::<4>(place), place),
            0 => [self.points[place.piece], DVec4::ZERO, DVec4::ZERO],
            1 => {
                let [a, b] = *self.bezier::<2>(place);
                [a * place.r + b * place.s, b - a, DVec4::ZERO]
            }
            _ => second_order(self.bezier_points(place), place),
        };
        let per_weight = 1.0 / value.w;
        let per_width = self.pieces[place.piece].per_width;
        let point = value.truncate() * per_weight;
        let [first, second] = if self.is_rational {
            let first = (slope.truncate() - point * slope.w) * per_weight;
            [first, (bend.truncate() - first * (2.0 * slope.w) - point * bend.w) * per_weight]
        } else {
            [slope, bend].map(|derivative| derivative.truncate() * per_weight)
        };
        [point, first * per_width, second * (per_width * per_width)]
    }

    #[inline(always)]
    fn place_at(&self, t: f64) -> Place {
        let guess = self.first_of_part[self.part_at(t)];
        // Even knots have one in each part, with the guess before it and the next piece behind.
        let piece = guess + usize::from(self.pieces[guess].end <= t);
        let (piece, s) = match self.pieces.get(piece) {
            Some(&Piece { start, end, per_width }) if t < end => (piece, (t - start) * per_width),
            _ => self.found(t),
        };
        Place { piece, s, r: 1.0 - s }
    }

    /// Piece and place where the guess fails: from the end of the domain on, and where knots crowd.
    #[cold]
    #[inline(never)]
    fn found(&self, t: f64) -> (usize, f64) {
        let piece = self.pieces.partition_point(|piece| piece.end <= t).min(self.pieces.len() - 1);
        let Piece { start, end, .. } = self.pieces[piece];
        // A product with a rounded reciprocal would miss the end.
        (piece, (t - start) / (end - start))
    }

    /// Which of the equal parts of the domain holds `t`; beyond the ends the first or the last.
    ///
    /// Rounded to nearest, so that of even knots each lies amid its part: in this sum the last bits
    /// are the whole number, at a fraction of the cost of a conversion that saturates.
    #[inline(always)]
    fn part_at(&self, t: f64) -> usize {
        let part = (t - self.start) * self.per_part;
        let part = if 0.0 < part { part } else { 0.0 };
        let part = if part < self.last_part { part } else { self.last_part };
        ((part + WHOLE).to_bits() - WHOLE.to_bits()) as usize
    }

    #[inline]
    fn bezier_points(&self, place: Place) -> &[DVec4] {
        let n = self.degree + 1;
        &self.points[place.piece * n..][..n]
    }

    /// The Bézier points of degree N − 1, in a number that the compiler knows.
    #[inline]
    fn bezier<const N: usize>(&self, place: Place) -> &[DVec4; N] {
        match self.points[place.piece * N..].first_chunk() {
            Some(points) => points,
            None => unreachable!("a piece has p + 1 points"),
        }
    }
}

/// Turns the control points of a span into those of its Bézier form: the blossoms
/// `f(a, … a, b, … b)` at the ends a and b of the span, by interpolation alone.
fn convert_to_bezier(knots: &KnotVector, span: usize, points: &mut [DVec4]) {
    let (p, u) = (knots.degree(), knots.as_slice());
    let (a, b) = (u[span], u[span + 1]);
    let between = |x: f64, left: f64, right: f64| (x - left) / (right - left);

    // From f(u_{i−p+1+k}, … u_{i+k}) to f(a, … a, u_{i+1}, … u_{i+k}), i the span and k the point.
    for n_at_a in 1..=p {
        for k in 0..=p - n_at_a {
            let alpha = between(a, u[span + k + n_at_a - p], u[span + k + 1]);
            points[k] = points[k] * (1.0 - alpha) + points[k + 1] * alpha;
        }
    }

    // On to f(a, … a, b, … b).
    for n_at_b in 1..p {
        for k in (n_at_b + 1..=p).rev() {
            let alpha = between(b, a, u[span + k - n_at_b + 1]);
            points[k] = points[k - 1] * (1.0 - alpha) + points[k] * alpha;
        }
    }
}

/// The point of Bézier points: `Σ C(p, i) sⁱ r^{p−i} Pᵢ`, without loops for the usual degrees.
#[inline(always)]
fn blend(points: &[DVec4], Place { s, r, .. }: Place) -> DVec4 {
    match *points {
        [a] => a,
        [a, b] => a * r + b * s,
        [a, b, c] => a * (r * r) + b * (2.0 * (r * s)) + c * (s * s),
        [a, b, c, d] => {
            let (rr, ss) = (r * r, s * s);
            (a * (rr * r) + b * (3.0 * (rr * s))) + (c * (3.0 * (r * ss)) + d * (ss * s))
        }
        _ => nested(points, s, r),
    }
}

/// [`blend`] for any degree, nested in r.
#[inline(never)]
fn nested(points: &[DVec4], s: f64, r: f64) -> DVec4 {
    let degree = points.len() - 1;
    let (mut sum, mut binomial, mut power) = (points[0], 1.0, 1.0);
    for (i, &point) in points.iter().enumerate().skip(1) {
        binomial *= (degree + 1 - i) as f64 / i as f64;
        power *= s;
        sum = sum * r + point * (binomial * power);
    }
    sum
}

/// The point of p + 1 ≥ 3 Bézier points and its first two derivatives by the place in the piece:
/// the last two rounds of de Casteljau's corner cutting, and their differences.
#[inline(always)]
fn second_order(points: &[DVec4], Place { s, r, .. }: Place) -> [DVec4; 3] {
    let degree = points.len() - 1;
    let [a, b, c] = match *points {
        [a, b, c] => [a, b, c],
        [a, b, c, d] => [a * r + b * s, b * r + c * s, c * r + d * s],
        _ => [0, 1, 2].map(|corner| nested(&points[corner..][..degree - 1], s, r)),
    };
    let (start, end) = (a * r + b * s, b * r + c * s);
    let value = start * r + end * s;
    let degree = degree as f64;
    [value, (end - start) * degree, ((c - b) - (b - a)) * (degree * (degree - 1.0))]
}
