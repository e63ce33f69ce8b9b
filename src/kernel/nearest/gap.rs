//! The polynomial |A|² − λw² of a patch by its Bernstein coefficients, and of parts of it.
//!
//! Products of Bernstein polynomials by Farouki & Rajan, *Algorithms for polynomials in Bernstein
//! form*, CAGD 5 (1988), (44); a polynomial is convex where the coefficients of its second
//! derivatives make a positive matrix.

use glam::DVec4;

use crate::{Direction, bernstein::binomials, tolerance::LAST_BIT};

/// Roundings in a coefficient, for each coefficient along a side.
const ROUNDINGS: f64 = 4.0;

/// What makes plain products of Bernstein coefficients, and the other way round.
#[derive(Debug)]
pub(super) struct ProductFactors {
    scale: Vec<f64>,
    per: Vec<f64>,
}

/// Coefficients of |A|² and of w² for a part of a patch, and of more parts that wait.
pub(super) struct DistanceBounds<'a> {
    /// Coefficients along each direction.
    n: [usize; 2],
    n_points: [usize; 2],
    factors: &'a ProductFactors,
    scaled: Vec<DVec4>,
    squares: Vec<f64>,
    weights: Vec<f64>,
    largest: f64,
    /// |A|² − λw² as it was asked for last.
    gap: Vec<f64>,
    /// Those of waiting parts, squares and weights, one part behind another.
    waiting: Vec<f64>,
}

impl ProductFactors {
    /// For patches of these degrees.
    pub(super) fn new(degrees: [usize; 2]) -> Self {
        let products = |degrees: [usize; 2]| -> Vec<f64> {
            let [of_u, of_v] = degrees.map(binomials);
            of_u.iter().flat_map(|u| of_v.iter().map(move |v| u * v)).collect()
        };
        let per = products(degrees.map(|degree| 2 * degree)).iter().map(|x| 1.0 / x).collect();
        Self { scale: products(degrees), per }
    }
}

impl<'a> DistanceBounds<'a> {
    /// For patches of these degrees, with their factors.
    pub(super) fn new(degrees: [usize; 2], factors: &'a ProductFactors) -> Self {
        let n = degrees.map(|degree| 2 * degree + 1);
        let size = n[0] * n[1];
        Self {
            n,
            n_points: degrees.map(|degree| degree + 1),
            factors,
            scaled: Vec::new(),
            squares: vec![0.0; size],
            weights: vec![0.0; size],
            largest: 0.0,
            gap: vec![0.0; size],
            waiting: Vec::new(),
        }
    }

    /// The whole of a patch waits; its net is seen from the place that is asked for.
    pub(super) fn start(&mut self, net: &[DVec4]) {
        self.scaled.clear();
        self.scaled
            .extend(net.iter().zip(&self.factors.scale).map(|(&point, &scale)| point * scale));
        let (n_rows, n_columns) = (self.n_points[0], self.n_points[1]);
        self.squares.fill(0.0);
        self.weights.fill(0.0);
        for i in 0..n_rows {
            for j in 0..n_columns {
                let a = self.scaled[i * n_columns + j];
                for k in 0..n_rows {
                    let to = (i + k) * self.n[1] + j;
                    let row = &self.scaled[k * n_columns..][..n_columns];
                    let squares = &mut self.squares[to..][..n_columns];
                    let weights = &mut self.weights[to..][..n_columns];
                    for ((b, square), weight) in row.iter().zip(squares).zip(weights) {
                        *square += a.x * b.x + a.y * b.y + a.z * b.z;
                        *weight += a.w * b.w;
                    }
                }
            }
        }
        let per = self.squares.iter_mut().zip(&mut self.weights).zip(&self.factors.per);
        for ((square, weight), per) in per {
            *square *= per;
            *weight *= per;
        }
        self.waiting.clear();
        self.waiting.extend_from_slice(&self.squares);
        self.waiting.extend_from_slice(&self.weights);
    }

    /// The part that waits last is the one that is spoken of.
    pub(super) fn next(&mut self) {
        let size = self.squares.len();
        let rest = self.waiting.len() - 2 * size;
        self.squares.copy_from_slice(&self.waiting[rest..][..size]);
        self.weights.copy_from_slice(&self.waiting[rest + size..]);
        self.waiting.truncate(rest);
        self.largest = self.squares.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    }

    /// Both halves wait, last the one that comes nearer; tells whether that is the first one.
    pub(super) fn halve(&mut self, along: Direction) -> bool {
        let size = self.squares.len();
        let from = self.waiting.len();
        self.waiting.resize(from + 4 * size, 0.0);
        let (left, right) = self.waiting[from..].split_at_mut(2 * size);
        for (layer, values) in [&self.squares, &self.weights].into_iter().enumerate() {
            let (left, right) =
                (&mut left[layer * size..][..size], &mut right[layer * size..][..size]);
            right.copy_from_slice(values);
            match along {
                Direction::U => halve_columns(self.n, left, right),
                Direction::V => halve_rows(self.n[1], left, right),
            }
        }
        let least = |half: &[f64]| half[..size].iter().copied().fold(f64::INFINITY, f64::min);
        let is_left_nearer = least(left) < least(right);
        if is_left_nearer {
            left.swap_with_slice(right);
        }
        is_left_nearer
    }

    /// Whether a corner, zeros and ones, may be nearer than √λ for all that rounding leaves of coefficients.
    pub(super) fn may_be_below(&self, corner: [f64; 2], lambda: f64) -> bool {
        let at = |i: usize| if corner[i] > 0.0 { self.n[i] - 1 } else { 0 };
        let index = at(0) * self.n[1] + at(1);
        self.squares[index] - lambda * self.weights[index] < self.slack()
    }

    /// Whether no point of the part is nearer than √λ, by more than rounding.
    pub(super) fn is_never_below(&mut self, lambda: f64) -> bool {
        self.fill(lambda);
        let slack = self.slack();
        self.gap.iter().all(|&value| -slack <= value)
    }

    /// Whether all points of the part are √λ away, up to rounding and that of the squares of distances.
    pub(super) fn is_nothing(&mut self, lambda: f64, of_square: f64) -> bool {
        self.fill(lambda);
        let most = self.weights.iter().fold(0.0, |most: f64, weight| most.max(weight.abs()));
        let slack = self.slack() + of_square * most;
        self.gap.iter().all(|value| value.abs() <= slack)
    }

    /// Where the least coefficient stands, as fractions of the part.
    pub(super) fn place_of_least(&self) -> [f64; 2] {
        let least = (0..self.gap.len())
            .fold(0, |least, i| if self.gap[i] < self.gap[least] { i } else { least });
        let fraction = |i: usize, n: usize| if n == 1 { 0.0 } else { i as f64 / (n - 1) as f64 };
        [fraction(least / self.n[1], self.n[0]), fraction(least % self.n[1], self.n[1])]
    }

    /// Whether the polynomial is convex on the part.
    pub(super) fn is_convex(&mut self, lambda: f64) -> bool {
        self.fill(lambda);
        let [n_u, n_v] = self.n;
        let lesser = |least: f64, bend: f64| if bend < least { bend } else { least };
        let along_u = self.bends_u().fold(f64::INFINITY, lesser);
        let along_v = self.bends_v().fold(f64::INFINITY, lesser);
        let mut mixed = 0.0;
        for (this, next) in self.gap.chunks_exact(n_v).zip(self.gap[n_v..].chunks_exact(n_v)) {
            let mut before = next[0] - this[0];
            for (this, next) in this.iter().zip(next).skip(1) {
                let rise = next - this;
                let twist = (rise - before).abs();
                (before, mixed) = (rise, if mixed < twist { twist } else { mixed });
            }
        }
        let [p, q] = self.n.map(|n| n as f64 - 1.0);
        let slack = self.slack();
        if n_u == 1 || n_v == 1 {
            return -slack <= along_u.min(along_v);
        }
        let (along_u, along_v, mixed) =
            (along_u * p * (p - 1.0), along_v * q * (q - 1.0), mixed * p * q);
        0.0 <= along_u && 0.0 <= along_v && mixed * mixed <= along_u * along_v
    }

    /// Along which direction the polynomial bends more, of those that were not halved too often;
    /// none if both were.
    pub(super) fn direction_to_halve(&self, n_halvings: [u8; 2], most: u8) -> Option<Direction> {
        let along =
            [self.bends_u().map(f64::abs).sum::<f64>(), self.bends_v().map(f64::abs).sum::<f64>()];
        let can = [0, 1].map(|direction| self.n[direction] > 1 && n_halvings[direction] < most);
        match can {
            [false, false] => None,
            [true, false] => Some(Direction::U),
            [false, true] => Some(Direction::V),
            [true, true] if along[0] < along[1] => Some(Direction::V),
            [true, true] => Some(Direction::U),
        }
    }

    /// Second differences of the polynomial's coefficients along u.
    fn bends_u(&self) -> impl Iterator<Item = f64> {
        let n = self.n[1];
        let rows = |from: usize| self.gap.get(from * n..).unwrap_or_default();
        second_differences(rows(0), rows(1), rows(2))
    }

    /// Those along v.
    fn bends_v(&self) -> impl Iterator<Item = f64> {
        self.gap.chunks_exact(self.n[1]).flat_map(|row| {
            let from = |place: usize| row.get(place..).unwrap_or_default();
            second_differences(row, from(1), from(2))
        })
    }

    fn fill(&mut self, lambda: f64) {
        if lambda.is_finite() {
            let both = self.squares.iter().zip(&self.weights);
            for (gap, (square, weight)) in self.gap.iter_mut().zip(both) {
                *gap = square - lambda * weight;
            }
        } else {
            // Anything is nearer than that, where no number is.
            self.gap.copy_from_slice(&self.squares);
            for gap in &mut self.gap {
                *gap -= 2.0 * self.largest;
            }
        }
    }

    fn slack(&self) -> f64 {
        ROUNDINGS * (self.n[0] + self.n[1]) as f64 * LAST_BIT * self.largest
    }
}

fn second_differences(a: &[f64], b: &[f64], c: &[f64]) -> impl Iterator<Item = f64> {
    a.iter().zip(b).zip(c).map(|((a, b), c)| (c - b) - (b - a))
}

/// De Casteljau at the middle of every row of `n` values: the first halves, and in place the
/// second ones.
fn halve_rows(n: usize, left: &mut [f64], right: &mut [f64]) {
    for (left, right) in left.chunks_exact_mut(n).zip(right.chunks_exact_mut(n)) {
        for (k, first) in left.iter_mut().enumerate() {
            *first = right[0];
            for i in 0..n - 1 - k {
                right[i] = 0.5 * (right[i] + right[i + 1]);
            }
        }
    }
}

/// [`halve_rows`] of the columns.
fn halve_columns([n_rows, n_columns]: [usize; 2], left: &mut [f64], right: &mut [f64]) {
    for k in 0..n_rows {
        left[k * n_columns..][..n_columns].copy_from_slice(&right[..n_columns]);
        for i in 0..n_rows - 1 - k {
            let (this, next) = right[i * n_columns..].split_at_mut(n_columns);
            for (value, next) in this.iter_mut().zip(next) {
                *value = 0.5 * (*value + *next);
            }
        }
    }
}
