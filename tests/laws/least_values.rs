//! Searches for least values from starts of all sizes: whatever they answer is right, or they refuse.

use std::ops::{Add, Div, Mul, Neg, Sub};

use virote_kernel::{Answers, ConstrainedLeast, LeastEnd, LeastProblem, Wanted};

/// A number with its slopes by two unknowns.
#[derive(Clone, Copy)]
struct Sloped {
    value: f64,
    slopes: [f64; 2],
}

impl Sloped {
    fn constant(value: f64) -> Self {
        Self { value, slopes: [0.0; 2] }
    }

    /// A function of the number, by its value and its slope there.
    fn through(self, value: f64, slope: f64) -> Self {
        Self { value, slopes: self.slopes.map(|own| own * slope) }
    }

    fn exp(self) -> Self {
        let value = libm::exp(self.value);
        self.through(value, value)
    }

    fn ln(self) -> Self {
        self.through(libm::log(self.value), 1.0 / self.value)
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.through(root, 0.5 / root)
    }

    fn abs(self) -> Self {
        self.through(self.value.abs(), if self.value == 0.0 { 0.0 } else { self.value.signum() })
    }

    fn atan(self) -> Self {
        self.through(libm::atan(self.value), 1.0 / (1.0 + self.value * self.value))
    }

    fn sin(self) -> Self {
        self.through(libm::sin(self.value), libm::cos(self.value))
    }

    fn cosh(self) -> Self {
        self.through(libm::cosh(self.value), libm::sinh(self.value))
    }

    fn pow(self, power: f64) -> Self {
        let slope = power * libm::pow(self.value, power - 1.0);
        self.through(libm::pow(self.value, power), slope)
    }

    fn max(self, other: f64) -> Self {
        if self.value < other { Self::constant(other) } else { self }
    }
}

impl Add for Sloped {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let [a, b] = [self.slopes, other.slopes];
        Self { value: self.value + other.value, slopes: [a[0] + b[0], a[1] + b[1]] }
    }
}

impl Mul for Sloped {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let rule = |k: usize| [self.slopes[k] * other.value, self.value * other.slopes[k]];
        let slope = |k: usize| rule(k).iter().sum();
        Self { value: self.value * other.value, slopes: [slope(0), slope(1)] }
    }
}

impl Neg for Sloped {
    type Output = Self;
    fn neg(self) -> Self {
        self * -1.0
    }
}

impl Sub for Sloped {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Add<f64> for Sloped {
    type Output = Self;
    fn add(self, other: f64) -> Self {
        self + Self::constant(other)
    }
}

impl Sub<f64> for Sloped {
    type Output = Self;
    fn sub(self, other: f64) -> Self {
        self + -other
    }
}

impl Mul<f64> for Sloped {
    type Output = Self;
    fn mul(self, other: f64) -> Self {
        self * Self::constant(other)
    }
}

impl Mul<Sloped> for f64 {
    type Output = Sloped;
    fn mul(self, other: Sloped) -> Sloped {
        other * self
    }
}

impl Div<Sloped> for f64 {
    type Output = Sloped;
    fn div(self, other: Sloped) -> Sloped {
        let value = self / other.value;
        other.through(value, -value / other.value)
    }
}

/// What is known of a function.
#[derive(Clone, Copy, PartialEq)]
enum Known {
    /// The places of its least values, or that of the only one that it has near by.
    At(&'static [[f64; 2]]),
    /// Its least value, wherever that is.
    Value(f64),
    /// As before, and that it falls on beyond a hill or a pole.
    AtOrBeyond(&'static [[f64; 2]]),
    /// The places of its least values, and that it only tends to another one elsewhere.
    AtOrTends(&'static [[f64; 2]]),
    /// That it has valleys.
    Valleys,
    /// It falls without bound.
    Unbounded,
    /// It only tends to its least value, which numbers attain where it is that exactly.
    Tends(f64),
    /// It has a pole.
    Pole,
}

use Known::{At, AtOrBeyond, AtOrTends, Pole, Tends, Unbounded, Valleys, Value};

type Function = fn(Sloped, Sloped) -> Sloped;

const FREE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

fn search(function: Function, start: &[f64]) -> ConstrainedLeast {
    let answers = |x: &[f64], wanted: Wanted| {
        let second = x.get(1).copied().unwrap_or(0.0);
        let found = function(
            Sloped { value: x[0], slopes: [1.0, 0.0] },
            Sloped { value: second, slopes: [0.0, 1.0] },
        );
        if !found.value.is_finite() {
            return Ok(Answers::from(vec![f64::INFINITY]));
        }
        let slopes = found.slopes[..x.len()].to_vec();
        let gradients = (wanted == Wanted::Gradients).then(|| vec![slopes]);
        Ok::<_, ()>(Answers { values: vec![found.value], gradients })
    };
    let bounds = vec![FREE; start.len()];
    LeastProblem { start, bounds: &bounds, n_equations: 0 }.find(answers).expect("no failure")
}

fn value(function: Function, place: &[f64]) -> f64 {
    let second = place.get(1).copied().unwrap_or(0.0);
    function(Sloped::constant(place[0]), Sloped::constant(second)).value
}

/// Whether the place answered is one of those known, or as low as numbers tell; of a level one the value is asked.
fn is_at(function: Function, found: &[f64], places: &[[f64; 2]], start: &[f64]) -> bool {
    let [here, first] = [value(function, found), value(function, start)];
    places.iter().any(|place| {
        let least = value(function, &place[..found.len()]);
        let size = place.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let began = start.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let slack = (1e-3 * size).max(1e-11 * began);
        let is_near = |(x, there): (&f64, &f64)| (x - there).abs() <= slack;
        found.iter().zip(place).all(is_near)
            || here - least <= 1e-11 * least.abs()
            || size <= 0.0 && here - least <= 1e-9 * (first - least).min(1.0 + least.abs())
    })
}

/// Whether the function is no lower a little beside.
fn is_valley(function: Function, found: &[f64]) -> bool {
    let here = value(function, found);
    let slack = 1e-9 * here.abs() + 1e-12;
    (0..found.len()).all(|k| {
        [-1e-2, -1e-3, -1e-4, 1e-4, 1e-3, 1e-2].into_iter().all(|step| {
            let mut beside = found.to_vec();
            beside[k] += step;
            here <= value(function, &beside) + slack
        })
    })
}

/// Why an answer is wrong; none where it is right, or refused.
fn mistake(function: Function, known: Known, start: &[f64]) -> (Option<String>, LeastEnd, usize) {
    let found = search(function, start);
    let at = &found.unknowns;
    let is_right = match (found.end, known) {
        (LeastEnd::Unsettled | LeastEnd::Flat, _) => true,
        (LeastEnd::Settled, At(places) | AtOrBeyond(places) | AtOrTends(places)) => {
            is_at(function, at, places, start)
        }
        (LeastEnd::Settled, Value(least)) => {
            found.values[0] - least <= 1e-12 + 1e-9 * (value(function, start) - least).min(1.0)
        }
        (LeastEnd::Settled, Valleys) => is_valley(function, at),
        // As far off as numbers reach nothing is known but that it lies level.
        (LeastEnd::Settled, Tends(least)) => found.values[0] <= least && at.last() == start.last(),
        (LeastEnd::Unbounded, Unbounded | AtOrBeyond(_)) => true,
        (LeastEnd::Unattained, Tends(_) | AtOrTends(_)) => true,
        (LeastEnd::Pole, Pole | AtOrBeyond(_)) => true,
        _ => false,
    };
    let told = (!is_right).then(|| format!("{:?} at {at:?}: {:?}", found.end, found.values));
    (told, found.end, found.n_evaluations)
}

const SIZES: [f64; 11] = [1e-12, 1e-9, 1e-6, 1e-4, 1e-3, 0.1, 1.0, 2.0, 30.0, 1e3, 1e6];

const PAIRS: [[f64; 2]; 14] = [
    [1e-9, 1e-9],
    [1e-9, 1.0],
    [1.0, 1e-9],
    [-1e-9, 2e-9],
    [1e-6, 1e-3],
    [0.1, 0.2],
    [1.0, 2.0],
    [-3.0, 4.0],
    [30.0, -7.0],
    [1e3, 1e-3],
    [-1e3, 2e3],
    [1e6, 1.0],
    [1e6, 1e6],
    [1e-12, -1e6],
];

const OF_ONE: [(Function, Known); 74] = [
    (|a, _| (a - 3.0) * (a - 3.0), At(&[[3.0, 0.0]])),
    (|a, _| (a - 1e-6) * (a - 1e-6), At(&[[1e-6, 0.0]])),
    (|a, _| (a - 1e-9) * (a - 1e-9) + 1.0, At(&[[1e-9, 0.0]])),
    (|a, _| (a - 2.0).pow(4.0), At(&[[2.0, 0.0]])),
    (|a, _| (a - 2.0).pow(6.0) + 1.0, At(&[[2.0, 0.0]])),
    (|a, _| a * a, At(&[[0.0; 2]])),
    (|a, _| a.pow(4.0), At(&[[0.0; 2]])),
    (|a, _| (a - 3.0).cosh(), At(&[[3.0, 0.0]])),
    (|a, _| (0.01 * a).cosh(), At(&[[0.0; 2]])),
    (|a, _| a.exp() - 5.0 * a, At(&[[1.609_437_912_434_1, 0.0]])),
    (|a, _| a + 1.0 / a, AtOrBeyond(&[[1.0, 0.0]])),
    (|a, _| 1.0 / a + 1e-10 * a, AtOrBeyond(&[[1e5, 0.0]])),
    (|a, _| 1e-3 * (1.0 / a) + a, AtOrBeyond(&[[0.031_622_776_601_683_8, 0.0]])),
    (|a, _| 1.0 / (a * a) + a * a, At(&[[1.0, 0.0], [-1.0, 0.0]])),
    (|a, _| 1.0 / (a * a) + 1e-12 * a * a, At(&[[1e3, 0.0], [-1e3, 0.0]])),
    (|a, _| a - a.ln(), At(&[[1.0, 0.0]])),
    (|a, _| a * a.ln(), At(&[[0.367_879_441_171_442, 0.0]])),
    (|a, _| -a * (-a).exp(), AtOrTends(&[[1.0, 0.0]])),
    (|a, _| -(-(a - 3.0) * (a - 3.0)).exp(), At(&[[3.0, 0.0]])),
    (|a, _| -1.0 / ((a - 3.0) * (a - 3.0) + 1.0), At(&[[3.0, 0.0]])),
    (|a, _| ((a - 3.0) * (a - 3.0) + 1.0).sqrt(), At(&[[3.0, 0.0]])),
    (|a, _| (a - 3.0).abs(), At(&[[3.0, 0.0]])),
    (|a, _| (a - 3.0).abs().sqrt(), At(&[[3.0, 0.0]])),
    (
        |a, _| 1e-9 * a.pow(4.0) - 1e-7 * a * a + 1.0,
        At(&[[7.071_067_811_865_475, 0.0], [-7.071_067_811_865_475, 0.0]]),
    ),
    (
        |a, _| 1e-20 * a.pow(4.0) - 1e-12 * a * a + 1.0,
        At(&[[7_071.067_811_865_475, 0.0], [-7_071.067_811_865_475, 0.0]]),
    ),
    (|a, _| a.pow(4.0) - 2.0 * a * a, At(&[[1.0, 0.0], [-1.0, 0.0]])),
    (
        |a, _| 1e-12 * a.pow(4.0) - a * a + 7.0,
        At(&[[707_106.781_186_547_5, 0.0], [-707_106.781_186_547_5, 0.0]]),
    ),
    (|a, _| 1e-10 * a * a - a, At(&[[5e9, 0.0]])),
    (|a, _| 1e-10 * a * a + a, At(&[[-5e9, 0.0]])),
    (|a, _| 1e-20 * a * a - a, At(&[[5e19, 0.0]])),
    (|a, _| 1e-10 * a.exp() - a, At(&[[23.025_850_929_940_457, 0.0]])),
    (|a, _| (a - 3.0) * (a - 3.0) + 1e6, At(&[[3.0, 0.0]])),
    (|a, _| 1e-9 * (a - 5.0) * (a - 5.0) + 1.0, At(&[[5.0, 0.0]])),
    (|a, _| 1e-20 * (a - 3.0) * (a - 3.0), At(&[[3.0, 0.0]])),
    (|a, _| 1e-200 * (a - 3.0) * (a - 3.0), At(&[[3.0, 0.0]])),
    (|a, _| 1e20 * (a - 3.0) * (a - 3.0), At(&[[3.0, 0.0]])),
    (|a, _| a.sin(), Valleys),
    (|a, _| a.sin() + 0.01 * a * a, Valleys),
    (|a, _| (a - 1.0).pow(2.0) * (a - 2.0).pow(2.0) + 0.1 * a, Valleys),
    (|a, _| (a * a + 1.0).ln(), At(&[[0.0; 2]])),
    (|a, _| ((a - 1.0) * (a - 1.0) + 1e-12).ln(), At(&[[1.0, 0.0]])),
    (|a, _| -1.0 / (a * a + 1.0) * a, AtOrTends(&[[1.0, 0.0]])),
    (|a, _| a.pow(3.0) - 3.0 * a, AtOrBeyond(&[[1.0, 0.0]])),
    (|a, _| (a - 3.0).max(0.0), Value(0.0)),
    (|a, _| (-a + 1e4).max(0.0), Value(0.0)),
    (|a, _| (-a + 1e4).max(0.0).pow(2.0) + 1.0, Value(1.0)),
    (|a, _| (a - 1e5).abs(), At(&[[1e5, 0.0]])),
    (|a, _| 1e12 * (a - 3e-8) * (a - 3e-8), At(&[[3e-8, 0.0]])),
    (|a, _| 1e18 * (a - 1e-9) * (a - 1e-9) + 1.0, At(&[[1e-9, 0.0]])),
    (|a, _| a * a.atan(), At(&[[0.0; 2]])),
    (|a, _| -a, Unbounded),
    (|a, _| -a * a, Unbounded),
    (|a, _| a.pow(3.0), Unbounded),
    (|a, _| -(a * a + 1.0).ln(), Unbounded),
    (|a, _| -a.abs().sqrt(), Unbounded),
    (|a, _| -1e-20 * a, Unbounded),
    (|a, _| (-a).exp() - a.exp(), Unbounded),
    (|a, _| -1e-20 * a * a + 1.0, Unbounded),
    (|a, _| 1.0 / (a * a + 1.0), Tends(0.0)),
    (|a, _| (-a).exp(), Tends(0.0)),
    (|a, _| (-a).exp() + 1.0, Tends(1.0)),
    (|a, _| (-a).exp() + 1e3, Tends(1e3)),
    (|a, _| (-a * a).exp() + 1.0, Tends(1.0)),
    (|a, _| (a * a + 1.0).sqrt() - a, Tends(0.0)),
    (|a, _| (a * a + 1.0).sqrt() + a, Tends(0.0)),
    (|a, _| -a.atan(), Tends(-std::f64::consts::FRAC_PI_2)),
    (|a, _| 1.0 / (a * a + 2.0).ln(), Tends(0.0)),
    (|a, _| 1.0 / (a * a) + 5.0, Tends(5.0)),
    (|a, _| 1e-6 / (a * a + 1.0) + 1.0, Tends(1.0)),
    (|a, _| ((-a).exp() + 1.0).ln(), Tends(0.0)),
    (|a, _| -1.0 / (a * a), Pole),
    (|a, _| -1.0 / ((a - 3.0) * (a - 3.0)), Pole),
    (|a, _| (a - 3.0).max(0.0).pow(8.0) + 2.0, Value(2.0)),
    (|a, _| (a - 3.0).max(0.0).pow(1.5) + 1.0, Value(1.0)),
];

const OF_TWO: [(Function, Known); 33] = [
    (|a, b| (a - 3.0) * (a - 3.0) + (b - 2.0) * (b - 2.0), At(&[[3.0, 2.0]])),
    (|a, b| (a - 1e6) * (a - 1e6) + (b - 2.0) * (b - 2.0), At(&[[1e6, 2.0]])),
    (|a, b| 100.0 * (b - a * a).pow(2.0) + (a - 1.0).pow(2.0), At(&[[1.0, 1.0]])),
    (|a, b| (a * a + b - 11.0).pow(2.0) + (b * b + a - 7.0).pow(2.0), Valleys),
    (|a, b| (a + 2.0 * b - 7.0).pow(2.0) + (2.0 * a + b - 5.0).pow(2.0), At(&[[1.0, 3.0]])),
    (|a, b| 0.26 * (a * a + b * b) - 0.48 * a * b, At(&[[0.0; 2]])),
    (|a, b| a * a - b * b, Unbounded),
    (|a, b| a * a + (-b).exp(), Tends(0.0)),
    (|a, b| (a * b - 1.0).pow(2.0) + a * a, Tends(0.0)),
    (|a, b| (a * a + b * b + 1.0).sqrt() - a, Tends(0.0)),
    (|a, b| (a * a + 1.0).sqrt() - a + (b - 2.0).pow(2.0), Tends(0.0)),
    (|a, b| (a - 3.0).pow(2.0) + (-b).exp() + 100.0, Tends(100.0)),
    (|a, b| 1e-10 * (a * a + b * b) - a, At(&[[5e9, 0.0]])),
    (|a, b| 1e-10 * (a * a + b * b) - a - b, At(&[[5e9, 5e9]])),
    (|a, b| 1e-10 * a * a - a + (b - 2.0).pow(2.0), At(&[[5e9, 2.0]])),
    (|a, b| 1e-9 * (a * a + b * b).pow(2.0) - 1e-7 * (a * a + b * b) + 1.0, Value(1.0 - 2.5e-6)),
    (|a, b| 1e-9 * a.pow(4.0) - 1e-7 * a * a + (b - 1.0).pow(2.0) + 1.0, Value(1.0 - 2.5e-6)),
    (|a, b| 1.0 / (a * a) + a * a + (b - 2.0).pow(2.0), At(&[[1.0, 2.0], [-1.0, 2.0]])),
    (|a, b| 1.0 / (a * b) + a + b, AtOrBeyond(&[[1.0, 1.0]])),
    (|a, b| 1.0 / (a * a + b * b) + a * a + b * b, Value(2.0)),
    (|a, b| a * a + (b - 3.0).pow(4.0), At(&[[0.0, 3.0]])),
    (|a, b| (a - 1.0).abs() + (b + 2.0).abs(), At(&[[1.0, -2.0]])),
    (|a, b| ((a - 3.0).pow(2.0) + (b - 1.0).pow(2.0) + 1.0).ln(), At(&[[3.0, 1.0]])),
    (|a, b| (a - b).pow(2.0) + 1e-6 * (a + b - 1e3).pow(2.0), At(&[[500.0, 500.0]])),
    (|a, b| (a - 3.0).pow(2.0) + 0.0 * b + 1.0, Value(1.0)),
    (|a, b| -1.0 / (a * a + b * b), Pole),
    (|a, b| (a * a + b * b).ln(), Pole),
    (|a, b| a + (-a).exp() + b * b, At(&[[0.0; 2]])),
    (
        |a, b| a.pow(4.0) + b.pow(4.0) - 2.0 * a * b,
        At(&[[0.707_106_781_186_547_5; 2], [-0.707_106_781_186_547_5; 2]]),
    ),
    (|a, b| a.pow(4.0) + ((b - 2.0).pow(2.0) + 1.0).ln(), At(&[[0.0, 2.0]])),
    (|a, b| a.pow(4.0) + b.pow(6.0), At(&[[0.0; 2]])),
    (|a, b| 1e-6 * a * a + (b * b + 1.0).ln(), At(&[[0.0; 2]])),
    (|a, b| 1e12 * (a - 3e-8).pow(2.0) + (b - 1.0).pow(2.0), At(&[[3e-8, 1.0]])),
];

/// What is wrong of all cases, how many are settled of those that have a least value, and how many evaluations they took.
#[track_caller]
fn check(cases: &[(Function, Known)], starts: &[Vec<f64>], least_settled: usize) {
    let (mut wrong, mut n_settled) = (Vec::new(), 0);
    for (idx, (function, known)) in cases.iter().enumerate() {
        for start in starts.iter().filter(|start| value(*function, start).is_finite()) {
            let (told, end, _) = mistake(*function, *known, start);
            n_settled += usize::from(end == LeastEnd::Settled);
            wrong.extend(told.map(|told| format!("{idx} from {start:?}: {told}")));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(least_settled <= n_settled, "{n_settled}");
}

#[test]
fn least_values_of_one_unknown_are_right_or_refused_from_starts_of_all_sizes() {
    let starts: Vec<Vec<f64>> = SIZES.iter().flat_map(|size| [vec![*size], vec![-size]]).collect();
    check(&OF_ONE, &starts, 985);
}

#[test]
fn least_values_of_two_unknowns_are_right_or_refused_from_starts_of_all_sizes() {
    let starts: Vec<Vec<f64>> = PAIRS.iter().map(|pair| pair.to_vec()).collect();
    check(&OF_TWO, &starts, 340);
}
