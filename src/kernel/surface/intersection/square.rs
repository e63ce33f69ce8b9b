//! Polynomials of two parameters on the unit square, by their Bernstein coefficients.

use std::ops::{Add, Mul, Sub};

use crate::{Grid, bernstein};

/// The derivative along u; that along v is the transpose of the transpose's.
pub(crate) fn slope_u<T>(field: &Grid<T>) -> Grid<T>
where
    T: Copy + Default + Sub<Output = T> + Mul<f64, Output = T>,
{
    let degree = field.n_rows() - 1;
    if degree == 0 {
        return field.map(|_| T::default());
    }
    Grid::from_fn(degree, field.n_columns(), |i, j| {
        (field.get(i + 1, j) - field.get(i, j)) * degree as f64
    })
}

/// The derivative along v.
pub(in crate::surface) fn slope_v<T>(field: &Grid<T>) -> Grid<T>
where
    T: Copy + Default + Sub<Output = T> + Mul<f64, Output = T>,
{
    slope_u(&field.transposed()).transposed()
}

/// The coefficients over both sides of a cut across v at a fraction.
pub(in crate::surface) fn cut_v<T>(field: &Grid<T>, fraction: f64) -> [Grid<T>; 2]
where
    T: Copy + Add<Output = T> + Mul<f64, Output = T>,
{
    let n_columns = field.n_columns();
    let mut right = field.as_slice().to_vec();
    let mut left = right.clone();
    for (left, right) in left.chunks_exact_mut(n_columns).zip(right.chunks_exact_mut(n_columns)) {
        for (j, value) in left.iter_mut().enumerate() {
            *value = right[0];
            for i in 0..n_columns - 1 - j {
                right[i] = right[i] * (1.0 - fraction) + right[i + 1] * fraction;
            }
        }
    }
    [left, right].map(|values| Grid::from_rows_of(n_columns, values))
}

/// The least and the largest coefficient, between which all values are.
pub(crate) fn range(field: &Grid<f64>) -> [f64; 2] {
    // Comparing is an instruction everywhere; `f64::min` is a call where processors have another one.
    field.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], &value| {
        [if value < least { value } else { least }, if value > most { value } else { most }]
    })
}

/// The coefficients along v at a fraction of u.
pub(in crate::surface) fn along_v(field: &Grid<f64>, u: f64) -> Vec<f64> {
    let mut sums = vec![0.0; field.n_columns()];
    for (i, share) in bernstein::basis(field.n_rows() - 1, u).into_iter().enumerate() {
        sums.iter_mut().zip(field.row(i)).for_each(|(sum, value)| *sum += share * value);
    }
    sums
}

/// The value at a place.
pub(in crate::surface) fn value(field: &Grid<f64>, [u, v]: [f64; 2]) -> f64 {
    bernstein::value(&along_v(field, u), v)
}

/// The product; `times` multiplies two values. As [`bernstein::product`], along both parameters.
pub(crate) fn product<A: Copy, B: Copy, C>(
    a: &Grid<A>,
    b: &Grid<B>,
    times: impl Fn(A, B) -> C,
) -> Grid<C>
where
    C: Copy + Default + Add<Output = C> + Mul<f64, Output = C>,
{
    let (rows, columns) = (shares(a.n_rows(), b.n_rows()), shares(a.n_columns(), b.n_columns()));
    let (n_rows, n_columns) = (a.n_rows() + b.n_rows() - 1, a.n_columns() + b.n_columns() - 1);
    let mut sums = vec![C::default(); n_rows * n_columns];
    for i in 0..a.n_rows() {
        for k in 0..b.n_rows() {
            let row = rows.get(i, k);
            let sums = &mut sums[(i + k) * n_columns..][..n_columns];
            for (j, &x) in a.row(i).iter().enumerate() {
                for (l, &y) in b.row(k).iter().enumerate() {
                    sums[j + l] = sums[j + l] + times(x, y) * (row * columns.get(j, l));
                }
            }
        }
    }
    Grid::from_rows_of(n_columns, sums)
}

/// What the product of two Bernstein polynomials is of another one.
fn shares(n: usize, m: usize) -> Grid<f64> {
    let [of_a, of_b, of_both] = [n - 1, m - 1, n + m - 2].map(bernstein::binomials);
    Grid::from_fn(n, m, |i, j| of_a[i] * of_b[j] / of_both[i + j])
}

/// What `join` makes of the coefficients of two polynomials of the same degrees.
pub(in crate::surface) fn joined<A: Copy, B: Copy, C>(
    a: &Grid<A>,
    b: &Grid<B>,
    join: impl Fn(A, B) -> C,
) -> Grid<C> {
    Grid::from_fn(a.n_rows(), a.n_columns(), |i, j| join(a.get(i, j), b.get(i, j)))
}

/// The largest coefficient by absolute value.
pub(in crate::surface) fn largest(field: &Grid<f64>) -> f64 {
    bernstein::largest(field.as_slice())
}

/// What is left of a polynomial that vanishes at u = 0 when it is divided by u.
pub(in crate::surface) fn over_u<T: Copy + Mul<f64, Output = T>>(field: &Grid<T>) -> Grid<T> {
    let degree = field.n_rows() - 1;
    Grid::from_fn(degree, field.n_columns(), |i, j| {
        field.get(i + 1, j) * (degree as f64 / (i + 1) as f64)
    })
}

/// The polynomial of 1 − u instead of u.
pub(in crate::surface) fn turned_u<T: Copy>(field: &Grid<T>) -> Grid<T> {
    let last = field.n_rows() - 1;
    Grid::from_fn(last + 1, field.n_columns(), |i, j| field.get(last - i, j))
}

#[cfg(test)]
mod tests {
    use super::{cut_v, over_u, product, slope_v, value};
    use crate::Grid;

    #[test]
    fn slopes_and_parts_are_those_of_the_polynomials() {
        // u²v²: the last coefficient alone.
        let square = Grid::from_fn(3, 3, |i, j| if i + j == 4 { 1.0 } else { 0.0 });
        assert!((value(&square, [0.5, 0.25]) - 1.0 / 64.0).abs() < 1e-16);
        // ∂(u²v²)/∂v = 2u²v.
        assert!((value(&slope_v(&square), [0.5, 0.25]) - 0.125).abs() < 1e-16);
        let [before, behind] = cut_v(&square, 0.25);
        assert!((value(&before, [1.0, 1.0]) - 1.0 / 16.0).abs() < 1e-16);
        assert!((value(&behind, [0.5, 1.0]) - 0.25).abs() < 1e-16);
        // u²v²·(1 − u)v.
        let other = Grid::from_fn(2, 2, |i, j| if (i, j) == (0, 1) { 1.0 } else { 0.0 });
        let both = product(&square, &other, |a, b| a * b);
        assert_eq!((both.n_rows(), both.n_columns()), (4, 4));
        assert!((value(&both, [0.5, 0.25]) - 1.0 / 512.0).abs() < 1e-18);
        // u²v² / u = uv².
        assert!((value(&over_u(&square), [0.5, 0.5]) - 0.125).abs() < 1e-16);
    }
}
