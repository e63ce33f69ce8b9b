//! Places that stand out on the curve of a function.
//!
//! What is asked for is where a number changes its sign that is computed from derivatives. They are
//! exact, and so is the number's own Taylor series: between nodes it is followed as a polynomial
//! through them, and its zeros are told without samples. Each is then found on the function itself,
//! to the last digits; one that the function does not confirm is none.

use glam::DVec3;

use crate::{
    Bounds, GeomError, Interval, Tolerance,
    ceiling::{BISECTIONS, FOLLOWING_HALVINGS},
    curve::{
        NurbsCurve, ParametricCurve, construction::hermite::blossom_weights, evaluation::series,
        measurement::same_places::SamePlaces,
    },
    frame::norm,
    numeric::{newton::within_bracket, polynomial_roots::Signs},
    tolerance::{FOLLOWED_RELATIVE, LAST_BIT, SIDE_STEP, SIGN_RELATIVE, TOUCH_RELATIVE},
    work,
};

/// Order of the Taylor series that polynomials are made of.
const ORDER: usize = 3;

/// Places of a piece at which a polynomial is compared.
const PLACES: [f64; 3] = [0.2, 0.5, 0.8];

/// Pieces of a function of less than so many roundings of their parameters are not looked into.
const LEAST_PIECE_ROUNDINGS: f64 = 8.0;

/// A number at a parameter as a Taylor series, with the size of what it is the sum of.
#[derive(Clone)]
pub(in crate::curve) struct MeasuredSeries {
    terms: Vec<f64>,
    size: f64,
}

/// A number that derivatives tell.
pub(in crate::curve) struct DerivativeQuestion<F> {
    /// How many orders it takes from the series of the curve.
    orders: usize,
    /// Computes its series of the curve's.
    of: F,
}

/// How fast the curve goes along a direction.
pub(in crate::curve) fn along(
    direction: DVec3,
) -> DerivativeQuestion<impl Fn(&[DVec3]) -> MeasuredSeries> {
    let of = move |curve: &[DVec3]| {
        let velocity = series::derivative(curve);
        let terms = velocity.iter().map(|term| term.dot(direction)).collect();
        MeasuredSeries { terms, size: longest(&velocity) }
    };
    DerivativeQuestion { orders: 1, of }
}

/// The bend about a normal, (V × V')·n; less than a turn over the `reach` is rounding.
pub(in crate::curve) fn bend_about(
    normal: DVec3,
    reach: f64,
) -> DerivativeQuestion<impl Fn(&[DVec3]) -> MeasuredSeries> {
    let of = move |curve: &[DVec3]| {
        let velocity = series::derivative(curve);
        let change = series::derivative(&velocity);
        let terms = series::cross_derivative(&velocity).iter().map(|b| b.dot(normal)).collect();
        let (v, a) = (longest(&velocity), longest(&change));
        MeasuredSeries { terms, size: v * (a + v / reach) }
    };
    DerivativeQuestion { orders: 2, of }
}

/// A positive multiple of the slope of the curvature, signed about a normal where there is one:
/// b'·V² − 3b·V·V' with the bend b = (V × V')·n, or with the square of V × V' and half of its
/// derivative.
pub(in crate::curve) fn curvature_slope(
    normal: Option<DVec3>,
    reach: f64,
) -> DerivativeQuestion<impl Fn(&[DVec3]) -> MeasuredSeries> {
    let of = move |curve: &[DVec3]| {
        let velocity = series::derivative(curve);
        let change = series::derivative(&velocity);
        let jerk = series::derivative(&change);
        let bend = series::cross_derivative(&velocity);
        let slope = series::derivative(&bend);
        let v = longest(&velocity);
        let a = longest(&change) + v / reach;
        let j = longest(&jerk) + a / reach;
        let (b, change_of_b, size_of_b) = match normal {
            Some(normal) => {
                let along = |of: &[DVec3]| of.iter().map(|b| b.dot(normal)).collect::<Vec<f64>>();
                (along(&bend), along(&slope), 1.0)
            }
            None => (dot(&bend, &bend), dot(&bend, &slope), v * a),
        };
        let rise = series_product(&change_of_b, &dot(&velocity, &velocity));
        let fall = series_product(&b, &dot(&velocity, &change));
        let terms = rise.iter().zip(&fall).map(|(rise, fall)| rise - 3.0 * fall).collect();
        MeasuredSeries { terms, size: size_of_b * v * v * (v * j + 3.0 * a * a) }
    };
    DerivativeQuestion { orders: 3, of }
}

/// The height over a plane, for a curve with coordinates of a size.
pub(in crate::curve) fn height(
    origin: DVec3,
    normal: DVec3,
    size: f64,
) -> DerivativeQuestion<impl Fn(&[DVec3]) -> MeasuredSeries> {
    let of = move |curve: &[DVec3]| {
        let mut terms: Vec<f64> = curve.iter().map(|term| term.dot(normal)).collect();
        terms[0] = (curve[0] - origin).dot(normal);
        MeasuredSeries { terms, size }
    };
    DerivativeQuestion { orders: 0, of }
}

/// Half of the slope of the squared speed.
pub(in crate::curve) fn speeding() -> DerivativeQuestion<impl Fn(&[DVec3]) -> MeasuredSeries> {
    let of = |curve: &[DVec3]| {
        let velocity = series::derivative(curve);
        let change = series::derivative(&velocity);
        MeasuredSeries {
            terms: dot(&velocity, &change),
            size: longest(&velocity) * longest(&change),
        }
    };
    DerivativeQuestion { orders: 2, of }
}

impl ParametricCurve {
    /// Parameters where the number changes its sign, in order, at the seam of a closed curve too.
    pub(in crate::curve) fn sign_changes<F: Fn(&[DVec3]) -> MeasuredSeries>(
        &self,
        spline: &NurbsCurve,
        question: &DerivativeQuestion<F>,
        is_closed: bool,
    ) -> Result<Vec<f64>, GeomError> {
        let mut signs = Signs::default();
        for span in spline.knots().spans() {
            let piece = spline.knots().span_interval(span);
            // Nothing happens inside of what is as narrow as parameters are rounded.
            if self.least_piece() < piece.length() {
                self.follow(piece, question, &mut signs)?;
            }
        }
        let domain = self.domain();
        let mut found = Vec::new();
        if is_closed && signs.changes_at_seam() {
            found.push(domain.start());
        }
        for &(t, _) in signs.changes() {
            let span = spline.knots().span_interval(spline.knots().span_at(t));
            let step = (SIDE_STEP * span.length()).max(self.parameter_rounding());
            found.extend(self.confirmed(t, step, question)?);
        }
        let same = SamePlaces::of(spline);
        if is_closed && found.first().is_some_and(|&t| t <= domain.start()) {
            found.retain(|&t| t <= domain.start() || !same.is_end(t));
        }
        Ok(same.once(found))
    }

    /// What a parameter is rounded by.
    fn parameter_rounding(&self) -> f64 {
        let domain = self.domain();
        2.0 * LAST_BIT * domain.start().abs().max(domain.end().abs()).max(domain.length())
    }

    /// Pieces up to this length are too narrow to have an inside.
    fn least_piece(&self) -> f64 {
        LEAST_PIECE_ROUNDINGS * self.parameter_rounding()
    }

    /// Follows a number along a piece that has no break inside.
    fn follow<F: Fn(&[DVec3]) -> MeasuredSeries>(
        &self,
        piece: Interval,
        question: &DerivativeQuestion<F>,
        signs: &mut Signs,
    ) -> Result<(), GeomError> {
        let ends = [self.inside(piece, 0.0, question)?, self.inside(piece, 1.0, question)?];
        let [start, end] = ends;
        let mut todo = vec![(piece, start, end, 0)];
        while work::goes_on(1)
            && let Some((part, start, end, n_halvings)) = todo.pop()
        {
            let size = start.size.max(end.size);
            let coefficients = coefficients([&start, &end], part.length());
            let middle = self.inside(part, 0.5, question)?;
            let is_near = || -> Result<bool, GeomError> {
                for fraction in PLACES {
                    let value = self.inside(part, fraction, question)?.terms[0];
                    let guess = crate::bernstein::value(&coefficients, fraction);
                    if FOLLOWED_RELATIVE * size < (value - guess).abs() {
                        return Ok(false);
                    }
                }
                Ok(true)
            };
            let is_least = part.length() <= 2.0 * self.least_piece();
            if FOLLOWING_HALVINGS <= n_halvings || is_least || is_near()? {
                signs.follow(part, &coefficients, SIGN_RELATIVE * size.max(middle.size));
            } else {
                let [before, behind] = part.halves();
                todo.push((behind, middle.clone(), end, n_halvings + 1));
                todo.push((before, start, middle, n_halvings + 1));
            }
        }
        Ok(())
    }

    /// The number at a fraction of a piece; at an end that has none, beside it.
    fn inside<F: Fn(&[DVec3]) -> MeasuredSeries>(
        &self,
        piece: Interval,
        fraction: f64,
        question: &DerivativeQuestion<F>,
    ) -> Result<MeasuredSeries, GeomError> {
        let step = (self.parameter_rounding() / piece.length()).min(0.5);
        let beside = |step: f64| fraction.clamp(step, 1.0 - step);
        let is_end = fraction <= 0.0 || 1.0 <= fraction;
        let at = |fraction: f64| self.asked(piece.at(fraction), question, ORDER);
        // The ends of pieces may be corners.
        at(beside(step)).or_else(|error| if is_end { at(beside(SIDE_STEP)) } else { Err(error) })
    }

    /// The number at a parameter, with its Taylor series up to an order.
    fn asked<F: Fn(&[DVec3]) -> MeasuredSeries>(
        &self,
        t: f64,
        question: &DerivativeQuestion<F>,
        order: usize,
    ) -> Result<MeasuredSeries, GeomError> {
        let derivatives = self.derivatives_at(t, question.orders + order)?;
        let terms: Vec<DVec3> =
            derivatives.iter().zip(series::powers(1.0)).map(|(&d, power)| d * power).collect();
        Ok((question.of)(&terms))
    }

    /// The zero within a step of a parameter, unless the number has one sign there.
    fn confirmed<F: Fn(&[DVec3]) -> MeasuredSeries>(
        &self,
        t: f64,
        step: f64,
        question: &DerivativeQuestion<F>,
    ) -> Result<Option<f64>, GeomError> {
        let domain = self.domain();
        let sides = [(t - step).max(domain.start()), (t + step).min(domain.end())];
        let [Ok(before), Ok(behind)] = sides.map(|side| self.asked(side, question, 0)) else {
            return Ok(Some(t));
        };
        let is_clear =
            |number: &MeasuredSeries| SIGN_RELATIVE * number.size < number.terms[0].abs();
        match (is_clear(&before), is_clear(&behind)) {
            (false, false) => Ok(Some(t)),
            (true, true) if 0.0 < before.terms[0] * behind.terms[0] => Ok(None),
            _ => self.polished(t, sides, question).map(Some),
        }
    }

    /// Newton's method from `t`, kept between parameters of different signs.
    pub(in crate::curve) fn polished<F: Fn(&[DVec3]) -> MeasuredSeries>(
        &self,
        t: f64,
        bracket: [f64; 2],
        question: &DerivativeQuestion<F>,
    ) -> Result<f64, GeomError> {
        let first = self.asked(bracket[0], question, 0)?.terms[0];
        let resolution = LAST_BIT * bracket[0].abs().max(bracket[1].abs());
        let is_still = |t: f64, next: f64| (next - t).abs() <= resolution;
        Ok(within_bracket(bracket, t, BISECTIONS, is_still, |t| {
            // Where there is no slope the middle is as good.
            let number = self.asked(t, question, 1).or_else(|_| self.asked(t, question, 0));
            // Without derivatives it is the place where they jump.
            let terms = number.ok()?.terms;
            let (value, slope) = (terms[0], terms.get(1).copied().unwrap_or_default());
            let sign = if 0.0 < value * first { -value.signum() } else { value.signum() };
            (value != 0.0).then_some([sign * value, sign * slope])
        }))
    }

    /// Places where the speed has a minimum of nothing, near those of the spline.
    pub(in crate::curve) fn standing(&self, near: Vec<f64>) -> Result<Vec<f64>, GeomError> {
        let step = SIDE_STEP * self.domain().length();
        let mut found = Vec::new();
        for t in near {
            let domain = self.domain();
            let sides = [(t - step).max(domain.start()), (t + step).min(domain.end())];
            let question = speeding();
            // At a joint the speed may have no slope.
            let is_minimum = match self.asked(sides[0], &question, 0) {
                Ok(before) => before.terms[0] < 0.0,
                Err(_) => false,
            };
            found.push(if is_minimum {
                self.polished(t, sides, &question).unwrap_or(t)
            } else {
                t
            });
        }
        Ok(found)
    }

    /// The box around the points at all extrema along the axes, at breaks and at the ends.
    pub(in crate::curve) fn box_around(&self, spline: &NurbsCurve) -> Result<Bounds, GeomError> {
        let mut bounds =
            Bounds { min: self.start().min(self.end()), max: self.start().max(self.end()) };
        for axis in DVec3::AXES {
            for t in self.sign_changes(spline, &along(axis), false)? {
                bounds = bounds.with(self.point_at(t)?);
            }
        }
        for t in spline.breaks() {
            bounds = bounds.with(self.point_at(t)?).with(spline.point_at(t));
        }
        Ok(bounds)
    }

    /// Whether the function bends so little at a parameter that it is straight there.
    pub(in crate::curve) fn is_straight_at(&self, t: f64) -> Result<bool, GeomError> {
        let d = self.derivatives_at(t, 2)?;
        let bend = norm(d[1].cross(d[2])) * self.domain().length();
        Ok(bend <= TOUCH_RELATIVE * norm(d[1]) * norm(d[1]))
    }

    /// Whether the ends are at one place.
    pub(in crate::curve) fn is_closed(&self, distance: f64) -> bool {
        let reach = |&point: &DVec3| norm(point - self.start());
        let size = self.probes().iter().map(reach).fold(0.0, f64::max);
        let tolerance = Tolerance::DEFAULT.with_distance(distance);
        self.start().distance(self.end()) <= tolerance.distance_for(size)
    }
}

/// Bernstein coefficients of the polynomial with these series at both ends of an interval.
fn coefficients([start, end]: [&MeasuredSeries; 2], width: f64) -> Vec<f64> {
    let own = |number: &MeasuredSeries, sides: [f64; 2]| {
        let mut factorial = 1.0;
        let derivatives: Vec<f64> = number
            .terms
            .iter()
            .take(ORDER + 1)
            .enumerate()
            .map(|(k, term)| {
                factorial *= k.max(1) as f64;
                term * factorial
            })
            .collect();
        let value = |weights: Vec<f64>| -> f64 {
            weights.iter().zip(&derivatives).map(|(weight, d)| weight * d).sum()
        };
        blossom_weights(sides[0], sides[1], ORDER).into_iter().map(value).collect::<Vec<f64>>()
    };
    [own(start, [0.0, width]), own(end, [-width, 0.0])].concat()
}

/// The length of the first vector that is not zero.
fn longest(terms: &[DVec3]) -> f64 {
    terms.first().map_or(0.0, |&term| norm(term))
}

/// Cauchy's product, as long as the shorter series.
fn series_product(a: &[f64], b: &[f64]) -> Vec<f64> {
    (0..a.len().min(b.len())).map(|k| (0..=k).map(|i| a[i] * b[k - i]).sum()).collect()
}

fn dot(a: &[DVec3], b: &[DVec3]) -> Vec<f64> {
    (0..a.len().min(b.len())).map(|k| (0..=k).map(|i| a[i].dot(b[k - i])).sum()).collect()
}
