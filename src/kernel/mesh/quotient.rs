//! The hulls of second derivatives of a Bézier patch.
//!
//! The derivatives of A/w are quotients of polynomials, over w³ those of second order. Where numerator
//! and denominator have one degree and the coefficients of the latter are positive, the quotients of
//! coefficients are points of which the quotient is a mean everywhere: nothing is lost by bounding
//! numerator and denominator apart.
//! Farouki & Rajan, *Algorithms for polynomials in Bernstein form*, CAGD 5 (1988).

use std::ops::{Add, Mul, Sub};

use glam::{DVec3, DVec4};

use crate::{Grid, bernstein::binomials, homogeneous};

/// Vectors in whose hulls Suu, Suv and Svv are over all of a patch with positive weights; by
/// fractions of the patch.
pub(super) fn second_hulls(net: &Grid<DVec4>, center: DVec3) -> [Vec<DVec3>; 3] {
    let places = net.map(|point| point.truncate() - center * point.w);
    let weight = net.get(0, 0).w;
    if !homogeneous::have_different_weights(net.as_slice()) {
        let (u, v) = (differences(&places), differences(&places.transposed()).transposed());
        let [uu, uv] = [differences(&u), differences(&u.transposed()).transposed()];
        let vv = differences(&v.transposed()).transposed();
        return [uu, uv, vv].map(|net| net.iter().map(|&vector| vector / weight).collect());
    }
    let (a, w) = (Polynomial::new(&places), Polynomial::new(&net.map(|point| point.w)));
    let (w_u, w_v) = (w.by_u(), w.by_v());
    let cube = w.times(&w).times(&w);
    let along_u = a.by_u().times(&w).minus(&a.times(&w_u), 1.0);
    let along_v = a.by_v().times(&w).minus(&a.times(&w_v), 1.0);
    let second = |first: &Polynomial<DVec3>, by: Polynomial<DVec3>, w_by: &Polynomial<f64>| {
        by.times(&w).minus(&first.times(w_by), 2.0).over(&cube)
    };
    [
        second(&along_u, along_u.by_u(), &w_u),
        second(&along_u, along_u.by_v(), &w_v),
        second(&along_v, along_v.by_v(), &w_v),
    ]
}

/// The control vectors of the derivative along u.
fn differences(net: &Grid<DVec3>) -> Grid<DVec3> {
    let (n, m) = (net.n_rows(), net.n_columns());
    if n == 1 {
        return Grid::from_fn(1, m, |_, _| DVec3::ZERO);
    }
    Grid::from_fn(n - 1, m, |i, j| (net.get(i + 1, j) - net.get(i, j)) * (n - 1) as f64)
}

/// A polynomial in u and v by its Bernstein coefficients, each times its binomials, so that
/// products are sums of products.
#[derive(Clone, Debug)]
struct Polynomial<T> {
    /// One more than the degrees along u and along v.
    sizes: [usize; 2],
    coefficients: Vec<T>,
}

impl<T> Polynomial<T>
where
    T: Copy + Default + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>,
{
    fn new(net: &Grid<T>) -> Self {
        let sizes = [net.n_rows(), net.n_columns()];
        let [rows, columns] = sizes.map(|size| binomials(size - 1));
        let scaled =
            Grid::from_fn(sizes[0], sizes[1], |i, j| net.get(i, j) * (rows[i] * columns[j]));
        Self { sizes, coefficients: scaled.into_values() }
    }

    fn times(&self, other: &Polynomial<f64>) -> Self {
        let sizes = [0, 1].map(|i| self.sizes[i] + other.sizes[i] - 1);
        let mut coefficients = vec![T::default(); sizes[0] * sizes[1]];
        for (i, row) in self.coefficients.chunks(self.sizes[1]).enumerate() {
            for (k, other_row) in other.coefficients.chunks(other.sizes[1]).enumerate() {
                let sums = &mut coefficients[(i + k) * sizes[1]..][..sizes[1]];
                for (j, &value) in row.iter().enumerate() {
                    for (sum, &other) in sums[j..].iter_mut().zip(other_row) {
                        *sum = *sum + value * other;
                    }
                }
            }
        }
        Self { sizes, coefficients }
    }

    /// Less another one times a factor, both first brought to one degree.
    fn minus(self, other: &Self, factor: f64) -> Self {
        let other = other.clone().raised_to(self.sizes);
        let mut this = self.raised_to(other.sizes);
        for (value, other) in this.coefficients.iter_mut().zip(other.coefficients) {
            *value = *value - other * factor;
        }
        this
    }

    /// With sizes no smaller than these.
    fn raised_to(self, sizes: [usize; 2]) -> Self {
        let missing = [0, 1].map(|i| sizes[i].saturating_sub(self.sizes[i]));
        if missing == [0, 0] {
            return self;
        }
        self.times(&Polynomial::new(&Grid::from_fn(missing[0] + 1, missing[1] + 1, |_, _| 1.0)))
    }

    /// The derivative along u.
    fn by_u(&self) -> Self {
        let [n, m] = self.sizes;
        if n == 1 {
            return Self { sizes: [1, m], coefficients: vec![T::default(); m] };
        }
        let value = |i: usize, j: usize| {
            let [low, high] = [i, i + 1].map(|i| self.coefficients[i * m + j]);
            high * (i + 1) as f64 - low * (n - 1 - i) as f64
        };
        let coefficients = Grid::from_fn(n - 1, m, value).into_values();
        Self { sizes: [n - 1, m], coefficients }
    }

    /// The derivative along v.
    fn by_v(&self) -> Self {
        let [n, m] = self.sizes;
        if m == 1 {
            return Self { sizes: [n, 1], coefficients: vec![T::default(); n] };
        }
        let value = |i: usize, j: usize| {
            let [low, high] = [j, j + 1].map(|j| self.coefficients[i * m + j]);
            high * (j + 1) as f64 - low * (m - 1 - j) as f64
        };
        let coefficients = Grid::from_fn(n, m - 1, value).into_values();
        Self { sizes: [n, m - 1], coefficients }
    }

    /// The quotients of coefficients, those below being positive and of no smaller degree.
    fn over(self, below: &Polynomial<f64>) -> Vec<T> {
        let pairs = self.raised_to(below.sizes).coefficients.into_iter().zip(&below.coefficients);
        pairs.map(|(value, below)| value * (1.0 / below)).collect()
    }
}
