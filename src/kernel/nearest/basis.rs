//! Bernstein polynomials with their derivatives, and a patch combined by them.

use glam::DVec4;
use smallvec::{SmallVec, smallvec};

/// Coefficients of a cubic: a number that the compiler knows makes loops faster.
const CUBIC: usize = 4;

/// Bernstein polynomials, and their first two derivatives.
pub(super) struct Basis {
    rows: [SmallVec<[f64; CUBIC]>; 3],
}

impl Basis {
    /// Room for those of a degree.
    pub(super) fn new(degree: usize) -> Self {
        Self { rows: [(); 3].map(|()| smallvec![0.0; degree + 1]) }
    }

    fn tabulated(&mut self, s: f64) -> [&[f64]; 3] {
        tabulate(self.rows.each_mut().map(|row| &mut row[..]), s);
        self.rows.each_ref().map(|row| &row[..])
    }
}

/// A patch and its derivatives S, Su, Sv, Suu, Suv, Svv at a place; `bases` is room for those of its degrees.
pub(super) fn sums(net: &[DVec4], bases: &mut [Basis; 2], place: [f64; 2]) -> [DVec4; 6] {
    let [along_u, along_v] = bases;
    let [n_u, n_v] = [&*along_u, along_v].map(|basis| basis.rows[0].len());
    let cubic = |s: f64| {
        let mut rows = [[0.0; CUBIC]; 3];
        tabulate(rows.each_mut().map(|row| &mut row[..]), s);
        rows
    };
    if (n_u, n_v) == (CUBIC, CUBIC)
        && let Some(net) = net.first_chunk::<{ CUBIC * CUBIC }>()
    {
        let bases = place.map(cubic);
        let [u, v] = bases.each_ref().map(|rows| rows.each_ref().map(|row| &row[..]));
        return combined(net, u, v);
    }
    if (n_u, n_v) == (1, CUBIC)
        && let Some(net) = net.first_chunk::<CUBIC>()
    {
        let rows = cubic(place[1]);
        return combined_row(net, rows.each_ref().map(|row| &row[..]));
    }
    let v = along_v.tabulated(place[1]);
    if n_u == 1 { combined_row(net, v) } else { combined(net, along_u.tabulated(place[0]), v) }
}

/// [`combined`] of a single row, which does not change along u.
#[inline(always)]
fn combined_row(row: &[DVec4], [values, slopes, bends]: [&[f64]; 3]) -> [DVec4; 6] {
    let mut sums = [DVec4::ZERO; 6];
    for (j, &point) in row.iter().enumerate() {
        sums[0] += point * values[j];
        sums[2] += point * slopes[j];
        sums[5] += point * bends[j];
    }
    sums
}

#[inline(always)]
fn combined(net: &[DVec4], along_u: [&[f64]; 3], along_v: [&[f64]; 3]) -> [DVec4; 6] {
    let mut sums = [DVec4::ZERO; 6];
    for (i, row) in net.chunks_exact(along_v[0].len()).enumerate() {
        let [mut value, mut slope, mut bend] = [DVec4::ZERO; 3];
        for (j, &point) in row.iter().enumerate() {
            value += point * along_v[0][j];
            slope += point * along_v[1][j];
            bend += point * along_v[2][j];
        }
        let [n, dn, ddn] = along_u.map(|values| values[i]);
        sums[0] += value * n;
        sums[1] += value * dn;
        sums[2] += slope * n;
        sums[3] += value * ddn;
        sums[4] += slope * dn;
        sums[5] += bend * n;
    }
    sums
}

/// Derivatives of as high an order as the degree allows, the others stay zero.
#[inline(always)]
fn tabulate([values, slopes, bends]: [&mut [f64]; 3], s: f64) {
    let p = values.len() - 1;
    values[0] = 1.0;
    for degree in 0..=p {
        if degree + 2 == p {
            let factor = (p * (p - 1)) as f64;
            for (i, bend) in bends.iter_mut().enumerate() {
                let at = |back: usize| match i.checked_sub(back) {
                    Some(i) if i <= degree => values[i],
                    _ => 0.0,
                };
                *bend = factor * ((at(2) - at(1)) - (at(1) - at(0)));
            }
        }
        if degree + 1 == p {
            for (i, slope) in slopes.iter_mut().enumerate() {
                let before = if i == 0 { 0.0 } else { values[i - 1] };
                let this = if i == p { 0.0 } else { values[i] };
                *slope = p as f64 * (before - this);
            }
        }
        if degree < p {
            raise(&mut values[..degree + 2], s);
        }
    }
}

/// The Bernstein polynomials of one degree more.
#[inline(always)]
fn raise(values: &mut [f64], s: f64) {
    let mut passed = 0.0;
    let last = values.len() - 1;
    for value in &mut values[..last] {
        let this = *value;
        *value = passed + this * (1.0 - s);
        passed = this * s;
    }
    values[last] = passed;
}
