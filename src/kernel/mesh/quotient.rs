//! The hulls of second derivatives of a Bézier patch.
//!
//! The derivatives of A/w are quotients of polynomials, over w³ those of second order. Where numerator
//! and denominator have one degree and the coefficients of the latter are positive, the quotients of
//! coefficients are points of which the quotient is a mean everywhere: nothing is lost by bounding
//! numerator and denominator apart. Where weights are products of one along u and one along v, as those of
//! all surfaces of revolution, w = a·b, the denominators are a³·b, a²·b² and a·b³, of lower degrees.
//! Farouki & Rajan, *Algorithms for polynomials in Bernstein form*, CAGD 5 (1988).

use std::ops::{Add, Mul, Sub};

use glam::{DVec3, DVec4};

use crate::{Direction, Grid, bernstein::binomials, homogeneous};

/// Vectors in whose hulls Suu, Suv and Svv are over all of a patch with positive weights, by
/// fractions of the patch; and the room that finding them takes, for one patch after another.
#[derive(Debug, Default)]
pub(super) struct SecondHulls {
    hulls: [Vec<DVec3>; 3],
    /// The numerator of the patch, whose fourth coordinate is nothing: four at once are as fast as three.
    places: Polynomial<DVec4>,
    /// What the patch is divided by along u and along v: the whole weight, or its factors there.
    weights: [Polynomial<f64>; 2],
    /// The derivative of each along its parameter.
    weights_by: [Polynomial<f64>; 2],
    squares: [Polynomial<f64>; 2],
    denominator: Polynomial<f64>,
    cube: Polynomial<f64>,
    /// The numerators of Su and Sv, over the squares of what they are divided by.
    first: [Polynomial<DVec4>; 2],
    derivative: Polynomial<DVec4>,
    products: [Polynomial<DVec4>; 2],
    raised: Polynomial<DVec4>,
}

impl SecondHulls {
    /// Those of a patch, seen from a place near it.
    pub(super) fn of(&mut self, net: &Grid<DVec4>, center: DVec3) -> &[Vec<DVec3>; 3] {
        self.hulls.iter_mut().for_each(Vec::clear);
        if !homogeneous::have_different_weights(net.as_slice()) {
            self.find_polynomial(net, center);
        } else if let Some(factors) = homogeneous::weight_factors(net) {
            self.find_separable(net, center, &factors);
        } else {
            self.find_rational(net, center);
        }
        &self.hulls
    }

    /// Second differences, all over one weight.
    fn find_polynomial(&mut self, net: &Grid<DVec4>, center: DVec3) {
        let (n, m) = (net.n_rows(), net.n_columns());
        let weight = net.get(0, 0).w;
        let place = |i: usize, j: usize| {
            let point = net.get(i, j);
            point.truncate() - center * point.w
        };
        let by_u = |i: usize, j: usize| (place(i + 1, j) - place(i, j)) * (n - 1) as f64;
        let by_v = |i: usize, j: usize| (place(i, j + 1) - place(i, j)) * (m - 1) as f64;
        let [uu, uv, vv] = &mut self.hulls;
        for i in 0..n.saturating_sub(2) {
            let bend = |j| (by_u(i + 1, j) - by_u(i, j)) * (n - 2) as f64 / weight;
            uu.extend((0..m).map(bend));
        }
        for i in 0..n - 1 {
            let twist = |j| (by_u(i, j + 1) - by_u(i, j)) * (m - 1) as f64 / weight;
            uv.extend((0..m - 1).map(twist));
        }
        for i in 0..n {
            let bend = |j| (by_v(i, j + 1) - by_v(i, j)) * (m - 2) as f64 / weight;
            vv.extend((0..m.saturating_sub(2)).map(bend));
        }
        for hull in self.hulls.iter_mut().filter(|hull| hull.is_empty()) {
            hull.push(DVec3::ZERO);
        }
    }

    /// Quotients of the coefficients of numerators and of the cube of the weight.
    fn find_rational(&mut self, net: &Grid<DVec4>, center: DVec3) {
        for weight in &mut self.weights {
            weight.set(net, |point| point.w);
        }
        self.find_first(net, center);
        let [square, _] = &self.squares;
        square.multiply(&self.weights[0], &mut self.denominator);
        let (u, v) = (Direction::U, Direction::V);
        for (i, (first, by)) in [(u, u), (u, v), (v, v)].into_iter().enumerate() {
            self.find_second(i, first, by, 2.0);
        }
    }

    /// The same where the weights are products of factors along u and along v.
    fn find_separable(&mut self, net: &Grid<DVec4>, center: DVec3, factors: &[Vec<f64>; 2]) {
        for (along, weight) in Direction::BOTH.into_iter().zip(&mut self.weights) {
            weight.set_along(along, &factors[along]);
        }
        self.find_first(net, center);
        let (u, v) = (Direction::U, Direction::V);
        for (i, along, across) in [(0, u, v), (2, v, u)] {
            self.squares[along].multiply(&self.weights[along], &mut self.cube);
            self.cube.multiply(&self.weights[across], &mut self.denominator);
            self.find_second(i, along, along, 2.0);
        }
        let [square_u, square_v] = &self.squares;
        square_u.multiply(square_v, &mut self.denominator);
        self.find_second(1, u, v, 1.0);
    }

    /// The numerators of first derivatives, and what they are over.
    fn find_first(&mut self, net: &Grid<DVec4>, center: DVec3) {
        self.places.set(net, |point| (point.truncate() - center * point.w).extend(0.0));
        for along in Direction::BOTH {
            let weight = &self.weights[along];
            weight.multiply(weight, &mut self.squares[along]);
            weight.derive(along, &mut self.weights_by[along]);
            self.places.derive(along, &mut self.derivative);
            let [product, other] = &mut self.products;
            self.derivative.multiply(weight, product);
            self.places.multiply(&self.weights_by[along], other);
            product.subtract(other, 1.0, &mut self.raised);
            std::mem::swap(product, &mut self.first[along]);
        }
    }

    /// The hull of a second derivative, from a first one along `first`; `power` is that of the weight along
    /// `by` beneath it.
    fn find_second(&mut self, i: usize, first: Direction, by: Direction, power: f64) {
        let [product, other] = &mut self.products;
        self.first[first].derive(by, &mut self.derivative);
        self.derivative.multiply(&self.weights[by], product);
        self.first[first].multiply(&self.weights_by[by], other);
        product.subtract(other, power, &mut self.raised);
        product.raise_to(self.denominator.sizes, &mut self.raised);
        let quotients = product.coefficients.iter().zip(&self.denominator.coefficients);
        self.hulls[i].extend(quotients.map(|(&value, &under)| (value * (1.0 / under)).truncate()));
    }
}

/// What the value, the first and the second derivative of a rational curve are hulls of, by fractions of it.
pub(super) type CurveHulls = [Vec<DVec4>; 3];

/// Those of a Bézier curve of four coordinates with positive weights, given by its points times their weights.
pub(super) fn curve_hulls(points: &[DVec4], weights: &[f64]) -> CurveHulls {
    let (mut weight, mut numerator) = (Polynomial::default(), Polynomial::default());
    let (along, mut room) = (Direction::U, Polynomial::default());
    let is_constant = weights.iter().all(|&one| (one - weights[0]).abs() <= 0.0);
    weight.set_along(along, if is_constant { &weights[..1] } else { weights });
    numerator.set_along(along, points);
    let (mut by, mut slope) = (Polynomial::default(), Polynomial::default());
    weight.derive(along, &mut by);
    let (mut denominator, mut other) = (weight.clone(), Polynomial::default());
    let mut hulls = vec![numerator.over(&denominator)];
    // The derivative of N/w^k is (N'·w - k·N·w')/w^(k + 1).
    for power in [1.0, 2.0] {
        numerator.derive(along, &mut slope);
        let mut product = Polynomial::default();
        slope.multiply(&weight, &mut product);
        numerator.multiply(&by, &mut other);
        product.subtract(&mut other, power, &mut room);
        let mut higher = Polynomial::default();
        denominator.multiply(&weight, &mut higher);
        (numerator, denominator) = (product, higher);
        numerator.raise_to(denominator.sizes, &mut room);
        hulls.push(numerator.over(&denominator));
    }
    let [value, first, second] = &mut hulls[..] else { unreachable!("there are three") };
    [value, first, second].map(std::mem::take)
}

/// A polynomial in u and v by its Bernstein coefficients, each times its binomials, so that
/// products are sums of products.
#[derive(Clone, Debug, Default)]
struct Polynomial<T> {
    /// One more than the degrees along u and along v.
    sizes: [usize; 2],
    coefficients: Vec<T>,
}

impl<T> Polynomial<T>
where
    T: Copy + Default + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>,
{
    fn set(&mut self, net: &Grid<DVec4>, coefficient: impl Fn(DVec4) -> T) {
        self.sizes = [net.n_rows(), net.n_columns()];
        let [rows, columns] = self.sizes.map(|size| binomials(size - 1));
        self.coefficients.clear();
        for (i, row) in rows.iter().enumerate() {
            let values = net.row(i).iter().zip(&columns);
            self.coefficients
                .extend(values.map(|(&point, column)| coefficient(point) * (row * column)));
        }
    }

    /// One of a single parameter.
    fn set_along(&mut self, along: Direction, coefficients: &[T]) {
        let n = coefficients.len();
        self.sizes = if along == Direction::U { [n, 1] } else { [1, n] };
        let scaled = coefficients.iter().zip(binomials(n - 1));
        self.coefficients.clear();
        self.coefficients.extend(scaled.map(|(&value, times)| value * times));
    }

    /// The product with another one.
    fn multiply(&self, other: &Polynomial<f64>, product: &mut Self) {
        let sizes = [0, 1].map(|i| self.sizes[i] + other.sizes[i] - 1);
        product.sizes = sizes;
        product.coefficients.clear();
        product.coefficients.resize(sizes[0] * sizes[1], T::default());
        for (i, row) in self.coefficients.chunks(self.sizes[1]).enumerate() {
            for (k, other_row) in other.coefficients.chunks(other.sizes[1]).enumerate() {
                let sums = &mut product.coefficients[(i + k) * sizes[1]..][..sizes[1]];
                if let &[other] = other_row {
                    for (sum, &value) in sums.iter_mut().zip(row) {
                        *sum = *sum + value * other;
                    }
                    continue;
                }
                for (j, &value) in row.iter().enumerate() {
                    for (sum, &other) in sums[j..].iter_mut().zip(other_row) {
                        *sum = *sum + value * other;
                    }
                }
            }
        }
    }

    /// The quotients of its coefficients and those of another one, of no higher degrees.
    fn over(&self, denominator: &Polynomial<f64>) -> Vec<T> {
        let mut denominator = denominator.clone();
        denominator.raise_to(self.sizes, &mut Polynomial::default());
        let quotients = self.coefficients.iter().zip(&denominator.coefficients);
        quotients.map(|(&value, &under)| value * (1.0 / under)).collect()
    }

    /// Takes another one times a factor away, both first brought to one degree.
    fn subtract(&mut self, other: &mut Self, factor: f64, room: &mut Self) {
        other.raise_to(self.sizes, room);
        self.raise_to(other.sizes, room);
        for (value, &other) in self.coefficients.iter_mut().zip(&other.coefficients) {
            *value = *value - other * factor;
        }
    }

    /// Makes its sizes no smaller than these.
    fn raise_to(&mut self, sizes: [usize; 2], room: &mut Self) {
        let missing = [0, 1].map(|i| sizes[i].saturating_sub(self.sizes[i]));
        if missing == [0, 0] {
            return;
        }
        let [rows, columns] = missing.map(binomials);
        let one = rows.iter().flat_map(|row| columns.iter().map(move |column| row * column));
        let one = Polynomial { sizes: missing.map(|n| n + 1), coefficients: one.collect() };
        self.multiply(&one, room);
        std::mem::swap(self, room);
    }

    /// The derivative along one parameter.
    fn derive(&self, along: Direction, derivative: &mut Self) {
        let [n, m] = self.sizes;
        let values = &self.coefficients;
        let out = &mut derivative.coefficients;
        out.clear();
        match along {
            Direction::U if n == 1 => out.resize(m, T::default()),
            Direction::V if m == 1 => out.resize(n, T::default()),
            Direction::U => {
                for i in 0..n - 1 {
                    let pairs = values[i * m..][..m].iter().zip(&values[(i + 1) * m..][..m]);
                    out.extend(
                        pairs.map(|(&low, &high)| high * (i + 1) as f64 - low * (n - 1 - i) as f64),
                    );
                }
            }
            Direction::V => {
                for row in values.chunks(m) {
                    let pairs = row.windows(2).enumerate();
                    out.extend(
                        pairs.map(|(j, pair)| {
                            pair[1] * (j + 1) as f64 - pair[0] * (m - 1 - j) as f64
                        }),
                    );
                }
            }
        }
        derivative.sizes = match along {
            Direction::U => [(n - 1).max(1), m],
            Direction::V => [n, (m - 1).max(1)],
        };
    }
}
