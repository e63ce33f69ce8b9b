//! Numbers within bounds, and how fast they may change.
//!
//! Every operation answers with bounds that hold for all numbers within those that it is given, rounding
//! included: each end is moved outward by the last bits that it may be wrong in. Moore, Kearfott & Cloud,
//! *Introduction to Interval Analysis*, ch. 2 and §6.4.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::tolerance::TURN_ROOM;

/// A function of one number over an interval: bounds of its values and of its slopes.
///
/// ```
/// use virote_kernel::Enclosure;
///
/// let x = Enclosure::variable([1.0, 2.0]);
/// let square = x.times(&x);
/// assert!(square.value()[0] <= 1.0 && 4.0 <= square.value()[1] && !square.may_rest());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure {
    value: [f64; 2],
    slope: [f64; 2],
}

const LINE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// Bounds with room for the rounding of one operation; of what is no number, of all.
pub(crate) fn outward([low, high]: [f64; 2]) -> [f64; 2] {
    if low.is_nan() || high.is_nan() { LINE } else { [low.next_down(), high.next_up()] }
}

/// Bounds with room for the errors of elementary functions, which are below a last bit.
fn outward_twice(bounds: [f64; 2]) -> [f64; 2] {
    outward(outward(bounds))
}

pub(crate) fn sum(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    outward([a[0] + b[0], a[1] + b[1]])
}

fn negated([low, high]: [f64; 2]) -> [f64; 2] {
    [-high, -low]
}

pub(crate) fn product(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    if a == [0.0, 0.0] || b == [0.0, 0.0] {
        return [0.0, 0.0];
    }
    let products = [a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1]];
    if products.iter().any(|product| product.is_nan()) {
        return LINE;
    }
    outward(hull(products))
}

fn hull<const N: usize>(values: [f64; N]) -> [f64; 2] {
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    [least, values.iter().copied().fold(f64::NEG_INFINITY, f64::max)]
}

pub(crate) fn quotient(a: [f64; 2], b: [f64; 2]) -> Option<[f64; 2]> {
    if holds(b, 0.0) {
        return None;
    }
    let quotients = [a[0] / b[0], a[0] / b[1], a[1] / b[0], a[1] / b[1]];
    Some(if quotients.iter().any(|quotient| quotient.is_nan()) {
        LINE
    } else {
        outward(hull(quotients))
    })
}

fn holds([low, high]: [f64; 2], value: f64) -> bool {
    low <= value && value <= high
}

/// Bounds of a function that grows.
fn growing([low, high]: [f64; 2], f: impl Fn(f64) -> f64) -> [f64; 2] {
    outward_twice([f(low), f(high)])
}

/// Bounds of a power with a constant exponent; none where it has no value or no derivative.
fn power(x: [f64; 2], exponent: f64) -> Option<[f64; 2]> {
    let is_whole = exponent.fract() == 0.0;
    if exponent == 0.0 {
        return Some([1.0, 1.0]);
    }
    if x[0] <= 0.0 && !is_whole || exponent < 0.0 && holds(x, 0.0) {
        return None;
    }
    let ends = x.map(|x| libm::pow(x, exponent));
    let is_even = is_whole && exponent % 2.0 == 0.0;
    let bounds = outward_twice(hull(ends));
    Some(if is_even && holds(x, 0.0) { [0.0, bounds[1]] } else { bounds })
}

/// Bounds of the cosine.
fn cosine(x: [f64; 2]) -> [f64; 2] {
    /// Beyond it angles have too few digits to tell where they are in a turn.
    const FAR: f64 = 1e6;
    if FAR < x[0].abs().max(x[1].abs()) {
        return [-1.0, 1.0];
    }
    let passes = |peak: f64| {
        let [low, high] = x.map(|x| (x - peak) / TAU);
        (low - TURN_ROOM).ceil() <= (high + TURN_ROOM).floor()
    };
    let [low, high] = outward_twice(hull(x.map(libm::cos)));
    [if passes(PI) { -1.0 } else { low.max(-1.0) }, if passes(0.0) { 1.0 } else { high.min(1.0) }]
}

fn sine(x: [f64; 2]) -> [f64; 2] {
    cosine(sum(x, [-FRAC_PI_2.next_up(), -FRAC_PI_2]))
}

impl Enclosure {
    /// The variable itself over an interval.
    #[must_use]
    pub fn variable(interval: [f64; 2]) -> Self {
        Self { value: interval, slope: [1.0, 1.0] }
    }

    /// A number that does not change.
    #[must_use]
    pub fn constant(value: f64) -> Self {
        Self { value: [value, value], slope: [0.0, 0.0] }
    }

    /// Bounds of the values.
    #[must_use]
    pub fn value(&self) -> [f64; 2] {
        self.value
    }

    /// Bounds of the slopes.
    #[must_use]
    pub fn slope(&self) -> [f64; 2] {
        self.slope
    }

    /// Whether it may be zero somewhere.
    #[must_use]
    pub fn may_vanish(&self) -> bool {
        !(0.0 < self.value[0] || self.value[1] < 0.0)
    }

    /// Whether it may stop growing or falling somewhere.
    #[must_use]
    pub fn may_rest(&self) -> bool {
        !(0.0 < self.slope[0] || self.slope[1] < 0.0)
    }

    /// Whether its slope is nowhere negative.
    #[must_use]
    pub fn is_growing(&self) -> bool {
        0.0 <= self.slope[0]
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self { value: sum(self.value, other.value), slope: sum(self.slope, other.slope) }
    }

    /// The same with the other sign.
    #[must_use]
    pub fn negated(&self) -> Self {
        Self { value: negated(self.value), slope: negated(self.slope) }
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let slope = sum(product(self.slope, other.value), product(self.value, other.slope));
        Self { value: product(self.value, other.value), slope }
    }

    /// The quotient; none where the divisor may vanish.
    #[must_use]
    pub fn over(&self, other: &Self) -> Option<Self> {
        let value = quotient(self.value, other.value)?;
        let slope = sum(self.slope, negated(product(value, other.slope)));
        Some(Self { value, slope: quotient(slope, other.value)? })
    }

    /// A power with a constant exponent; none where it has no value or no derivative.
    #[must_use]
    pub fn power(&self, exponent: f64) -> Option<Self> {
        let rate = product([exponent, exponent], power(self.value, exponent - 1.0)?);
        Some(Self { value: power(self.value, exponent)?, slope: product(rate, self.slope) })
    }

    /// A power; none where it has no value or no derivative, or may have none.
    #[must_use]
    pub fn power_of(&self, exponent: &Self) -> Option<Self> {
        #[expect(clippy::float_cmp, reason = "bounds of one number are that number")]
        if exponent.value[0] == exponent.value[1] && exponent.slope == [0.0, 0.0] {
            return self.power(exponent.value[0]);
        }
        exponent.times(&self.ln()?).exp()
    }

    fn applied(&self, value: [f64; 2], rate: [f64; 2]) -> Option<Self> {
        Some(Self { value, slope: product(rate, self.slope) })
    }

    /// The square root; none where it has no derivative.
    #[must_use]
    pub fn sqrt(&self) -> Option<Self> {
        self.power(0.5)
    }

    /// The cube root; none where it has no derivative.
    #[must_use]
    pub fn cbrt(&self) -> Option<Self> {
        let value = growing(self.value, libm::cbrt);
        let rate = quotient([1.0, 1.0], product([3.0, 3.0], power(value, 2.0)?))?;
        self.applied(value, rate)
    }

    /// The exponential function.
    #[must_use]
    pub fn exp(&self) -> Option<Self> {
        let value = growing(self.value, libm::exp);
        self.applied(value, value)
    }

    /// The natural logarithm; none where it has no value.
    #[must_use]
    pub fn ln(&self) -> Option<Self> {
        let is_in = 0.0 < self.value[0];
        let rate = quotient([1.0, 1.0], self.value)?;
        is_in.then(|| self.applied(growing(self.value, libm::log), rate))?
    }

    /// The sine of radians.
    #[must_use]
    pub fn sin(&self) -> Option<Self> {
        self.applied(sine(self.value), cosine(self.value))
    }

    /// The cosine of radians.
    #[must_use]
    pub fn cos(&self) -> Option<Self> {
        self.applied(cosine(self.value), negated(sine(self.value)))
    }

    /// The tangent of radians; none where it may have a pole.
    #[must_use]
    pub fn tan(&self) -> Option<Self> {
        self.sin()?.over(&self.cos()?)
    }

    /// The angle with this tangent.
    #[must_use]
    pub fn atan(&self) -> Option<Self> {
        let rate = quotient([1.0, 1.0], sum([1.0, 1.0], power(self.value, 2.0)?))?;
        self.applied(growing(self.value, libm::atan), rate)
    }

    /// The hyperbolic sine.
    #[must_use]
    pub fn sinh(&self) -> Option<Self> {
        self.applied(growing(self.value, libm::sinh), hyperbolic(self.value))
    }

    /// The hyperbolic cosine.
    #[must_use]
    pub fn cosh(&self) -> Option<Self> {
        self.applied(hyperbolic(self.value), growing(self.value, libm::sinh))
    }

    /// The hyperbolic tangent.
    #[must_use]
    pub fn tanh(&self) -> Option<Self> {
        let value = growing(self.value, libm::tanh);
        self.applied(value, sum([1.0, 1.0], negated(power(value, 2.0)?)))
    }

    /// The magnitude; where it may vanish, its slope is one of both sides.
    #[must_use]
    pub fn abs(&self) -> Option<Self> {
        let [low, high] = self.value;
        Some(if 0.0 <= low {
            *self
        } else if high <= 0.0 {
            self.negated()
        } else {
            let slopes = hull([self.slope[0], self.slope[1], -self.slope[0], -self.slope[1]]);
            Self { value: [0.0, high.max(-low)], slope: slopes }
        })
    }
}

/// Bounds of the hyperbolic cosine.
fn hyperbolic(x: [f64; 2]) -> [f64; 2] {
    let [low, high] = outward_twice(hull(x.map(libm::cosh)));
    [if holds(x, 0.0) { 1.0 } else { low.max(1.0) }, high]
}

#[cfg(test)]
mod tests {
    use super::Enclosure;
    use crate::Jet;

    type Enclosed = fn(&Enclosure) -> Option<Enclosure>;
    type Plain = fn(&Jet) -> Jet;

    #[test]
    fn values_and_slopes_lie_within_their_bounds() {
        let functions: [(Enclosed, Plain); 14] = [
            (Enclosure::sqrt, |x| x.sqrt().expect("positive")),
            (Enclosure::cbrt, |x| x.cbrt().expect("positive")),
            (Enclosure::exp, |x| x.exp().expect("small")),
            (Enclosure::ln, |x| x.ln().expect("positive")),
            (Enclosure::sin, |x| x.sin().expect("smooth")),
            (Enclosure::cos, |x| x.cos().expect("smooth")),
            (Enclosure::tan, |x| x.tan().expect("no pole")),
            (Enclosure::atan, |x| x.atan().expect("smooth")),
            (Enclosure::sinh, |x| x.sinh().expect("small")),
            (Enclosure::cosh, |x| x.cosh().expect("small")),
            (Enclosure::tanh, |x| x.tanh().expect("smooth")),
            (|x| x.power(3.0), |x| x.power(3.0).expect("whole")),
            (
                |x| Some(x.times(&x.plus(&Enclosure::constant(-2.0)))),
                |x| x.times(&x.minus(&x.same(2.0))),
            ),
            (|x| x.sin()?.over(x), |x| x.sin().expect("smooth").over(x).expect("not zero")),
        ];
        for (idx, (enclosed, plain)) in functions.into_iter().enumerate() {
            let mut n_enclosed = 0;
            for k in 1..60 {
                let [low, high] = [f64::from(k) * 0.1, f64::from(k) * 0.1 + 0.07];
                let Some(bounds) = enclosed(&Enclosure::variable([low, high])) else { continue };
                n_enclosed += 1;
                for step in 0..=8 {
                    let jet = plain(&Jet::variable(low + f64::from(step) / 8.0 * (high - low), 1));
                    let [value, slope] = [jet.value(), jet.derivative(1, 0)];
                    assert!(bounds.value[0] <= value && value <= bounds.value[1], "{idx} {k}");
                    let room = 1e-14 * slope.abs();
                    let is_in = bounds.slope[0] - room <= slope && slope <= bounds.slope[1] + room;
                    assert!(is_in, "{idx} at {low}: {slope} {bounds:?}");
                }
            }
            assert!(50 < n_enclosed, "{idx}");
        }
    }

    #[test]
    fn what_has_a_pole_or_no_value_has_no_bounds() {
        let around = Enclosure::variable([-0.1, 0.1]);
        assert!(Enclosure::constant(1.0).over(&around).is_none() && around.sqrt().is_none());
        assert!(around.ln().is_none() && around.power(-2.0).is_none());
        assert!(Enclosure::variable([1.5, 1.6]).tan().is_none());
        assert_eq!(around.abs().map(|bounds| bounds.may_rest()), Some(true));
    }
}
