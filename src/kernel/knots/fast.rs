//! The basis without a heap allocation, and without loops for the usual degrees.

use std::array::from_fn;

use super::{KnotVector, reciprocals::UNROLLED_DEGREE};

/// Degrees whose basis fits a small array on the stack.
const SMALL_DEGREE: usize = 7;

/// Derivatives, the values among them, whose rows fit there as well.
const SMALL_ROWS: usize = 4;

impl KnotVector {
    /// [`Self::span_at`], looked for at another span and behind it first: of parameters in order each
    /// is near the one before.
    pub(crate) fn span_from(&self, guess: usize, t: f64) -> usize {
        let holds = |span: usize| self.knots[span] <= t && t < self.knots[span + 1];
        match guess {
            guess if holds(guess) => guess,
            guess if guess + 1 < self.n_points() && holds(guess + 1) => guess + 1,
            _ => self.span_at(t),
        }
    }

    /// Calls `f` with the span of `t` and the basis there; no heap allocation up to degree 7.
    #[inline]
    pub(crate) fn with_basis<R>(&self, t: f64, f: impl FnOnce(usize, &[f64]) -> R) -> R {
        let span = self.span_at(t);
        self.with_basis_on(span, t, |values| f(span, values))
    }

    /// Calls `f` with the basis of a span; no heap allocation up to degree 7.
    #[inline]
    pub(crate) fn with_basis_on<R>(&self, span: usize, t: f64, f: impl FnOnce(&[f64]) -> R) -> R {
        if t < self.knots[span + 1] {
            match self.degree {
                1 => return f(&self.nearby::<2>(span, t).basis().0),
                2 => return f(&self.nearby::<3>(span, t).basis().0),
                3 => return f(&self.nearby::<4>(span, t).basis().0),
                _ => {}
            }
        }
        // At the end of the domain too, which a product with a rounded reciprocal would miss.
        match self.degree {
            degree @ ..=SMALL_DEGREE => {
                let mut values = [0.0; SMALL_DEGREE + 1];
                self.basis_at(span, t, &mut values);
                f(&values[..=degree])
            }
            degree => {
                let mut values = vec![0.0; degree + 1];
                self.basis_at(span, t, &mut values);
                f(&values)
            }
        }
    }

    /// Calls `f` with the basis on a span and its first derivatives; no heap allocation up to
    /// degree 7.
    #[inline]
    pub(crate) fn with_slopes<R>(
        &self,
        span: usize,
        t: f64,
        f: impl FnOnce(&[f64], &[f64]) -> R,
    ) -> R {
        if t < self.knots[span + 1] {
            match self.degree {
                1 => {
                    let (values, slopes) = self.nearby::<2>(span, t).basis();
                    return f(&values, &slopes);
                }
                2 => {
                    let (values, slopes) = self.nearby::<3>(span, t).basis();
                    return f(&values, &slopes);
                }
                3 => {
                    let (values, slopes) = self.nearby::<4>(span, t).basis();
                    return f(&values, &slopes);
                }
                _ => {}
            }
        }
        match self.degree {
            degree @ ..=SMALL_DEGREE => {
                let (mut values, mut slopes) = ([0.0; SMALL_DEGREE + 1], [0.0; SMALL_DEGREE + 1]);
                self.slopes_at(span, t, &mut values, &mut slopes);
                f(&values[..=degree], &slopes[..=degree])
            }
            degree => {
                let (mut values, mut slopes) = (vec![0.0; degree + 1], vec![0.0; degree + 1]);
                self.slopes_at(span, t, &mut values, &mut slopes);
                f(&values, &slopes)
            }
        }
    }

    /// Calls `f` with the rows of [`Self::basis_derivatives_on`]; no heap allocation up to degree 7 and order 3.
    #[inline]
    pub(crate) fn with_derivatives<R>(
        &self,
        span: usize,
        t: f64,
        order: usize,
        f: impl FnOnce(&[f64]) -> R,
    ) -> R {
        let n = (order + 1) * (self.degree + 1);
        let mut few = [0.0; SMALL_ROWS * (SMALL_DEGREE + 1)];
        match few.get_mut(..n) {
            Some(rows) => {
                self.fill_derivatives(span, t, rows);
                f(rows)
            }
            None => {
                let mut rows = vec![0.0; n];
                self.fill_derivatives(span, t, &mut rows);
                f(&rows)
            }
        }
    }

    /// The rows of [`Self::basis_derivatives_on`], as many as there is room for, which is zero before.
    pub(super) fn fill_derivatives(&self, span: usize, t: f64, rows: &mut [f64]) {
        let p = self.degree;
        let (values, rest) = rows.split_at_mut(p + 1);
        // The values of each lower degree are met on the way to those of degree p.
        values[0] = 1.0;
        for q in 1..=p {
            if let Some(row) = rest.chunks_exact_mut(p + 1).nth(p - q) {
                row.copy_from_slice(values);
            }
            self.raise(q, span, t, values);
        }
        for (k, row) in rest.chunks_exact_mut(p + 1).enumerate().take(p) {
            for q in p - k..=p {
                self.differentiate(q, span, row);
            }
        }
    }

    /// As [`Self::with_derivatives`], of orders below `N`, each row by itself.
    #[inline]
    pub(crate) fn with_derivative_rows<const N: usize, R>(
        &self,
        span: usize,
        t: f64,
        f: impl FnOnce([&[f64]; N]) -> R,
    ) -> R {
        match self.degree {
            1 => f(self.derivative_rows::<2, N>(span, t).each_ref().map(|row| &row[..])),
            2 => f(self.derivative_rows::<3, N>(span, t).each_ref().map(|row| &row[..])),
            3 => f(self.derivative_rows::<4, N>(span, t).each_ref().map(|row| &row[..])),
            degree => {
                let n = degree + 1;
                self.with_derivatives(span, t, N - 1, |rows| f(from_fn(|k| &rows[k * n..][..n])))
            }
        }
    }

    /// The rows of [`Self::fill_derivatives`] for degree M - 1, to the last bit, in loops whose length the compiler knows.
    #[inline]
    fn derivative_rows<const M: usize, const N: usize>(
        &self,
        span: usize,
        t: f64,
    ) -> [[f64; M]; N] {
        let p = M - 1;
        let around = &self.knots[span + 1 - p..=span + p];
        let mut rows = [[0.0; M]; N];
        let mut values = [0.0; M];
        values[0] = 1.0;
        for q in 1..=p {
            if p - q + 1 < N {
                rows[p - q + 1] = values;
            }
            let mut carried = 0.0;
            for i in 0..q {
                let (left, right) = (around[p - q + i], around[p + i]);
                let alpha = (t - left) / (right - left);
                let to_next = alpha * values[i];
                values[i] = carried + (1.0 - alpha) * values[i];
                carried = to_next;
            }
            values[q] = carried;
        }
        rows[0] = values;
        for (k, row) in rows.iter_mut().enumerate().skip(1).take(p) {
            for q in p + 1 - k..=p {
                let mut carried = 0.0;
                for i in 0..q {
                    let (left, right) = (around[p - q + i], around[p + i]);
                    let slope = q as f64 * row[i] / (right - left);
                    row[i] = carried - slope;
                    carried = slope;
                }
                row[q] = carried;
            }
        }
        rows
    }

    fn slopes_at(&self, span: usize, t: f64, values: &mut [f64], slopes: &mut [f64]) {
        values[0] = 1.0;
        if self.degree > 0 {
            self.basis_of_degree(self.degree - 1, span, t, values);
            slopes.copy_from_slice(values);
            self.differentiate(self.degree, span, slopes);
            self.raise(self.degree, span, t, values);
        }
    }

    /// What the basis of degree N − 1, which is 1, 2 or 3, depends on at a parameter before the end of its span.
    #[inline]
    fn nearby<const N: usize>(&self, span: usize, t: f64) -> NearbyKnots<'_, N> {
        let first = span + 2 - N;
        let (Some(lefts), Some(widths)) =
            (self.knots[first..].first_chunk(), self.reciprocals.widths[first..].first_chunk())
        else {
            unreachable!("a span of the domain has p knots on either side")
        };
        NearbyKnots { t, lefts, widths }
    }

    /// `made` of the basis of degree p = N − 1 on a span and its first derivatives, at each of many parameters before
    /// the span's end; whether they all are. The compiler computes several of them at once.
    #[inline]
    pub(crate) fn make_of_slopes<const N: usize>(
        &self,
        span: usize,
        parameters: &[f64],
        made: &mut [f64],
        make: impl Fn(&[f64; N], &[f64; N]) -> f64,
    ) -> bool {
        let nearby = self.nearby::<N>(span, self.knots[span]);
        for (made, &t) in made.iter_mut().zip(parameters) {
            let (values, slopes) = NearbyKnots { t, ..nearby }.basis();
            *made = make(&values, &slopes);
        }
        parameters.iter().all(|&t| t < self.knots[span + 1])
    }
}

/// A parameter with the knots around it from p − 1 before its span, and the reciprocals of the
/// widths from these knots on.
#[derive(Clone, Copy)]
struct NearbyKnots<'a, const N: usize> {
    t: f64,
    lefts: &'a [f64; N],
    widths: &'a [[f64; UNROLLED_DEGREE]; N],
}

impl<const N: usize> NearbyKnots<'_, N> {
    /// Values of degree Q from those of degree Q − 1.
    ///
    /// Whole arrays follow one another, so that they stay in registers: written entry by entry
    /// they would be read back in pairs, which waits for the memory.
    #[inline]
    fn raised<const Q: usize>(self, values: [f64; N]) -> [f64; N] {
        let alpha = |i: usize| ((self.t - self.lefts[i]) * self.widths[i][Q - 1]).min(1.0);
        let alphas: [f64; N] = from_fn(|r| if r < Q { alpha(N - 1 + r - Q) } else { 0.0 });
        let stays = |r: usize| (1.0 - alphas[r]) * values[r];
        let moves = |r: usize| alphas[r] * values[r];
        from_fn(|r| match r {
            0 => stays(0),
            r if r < Q => moves(r - 1) + stays(r),
            r if r == Q => moves(r - 1),
            _ => 0.0,
        })
    }

    /// Values and first derivatives for degree N − 1, before the end of the span.
    #[inline]
    fn basis(self) -> ([f64; N], [f64; N]) {
        let mut values: [f64; N] = from_fn(|r| if r == 0 { 1.0 } else { 0.0 });
        if 2 < N {
            values = self.raised::<1>(values);
        }
        if 3 < N {
            values = self.raised::<2>(values);
        }
        let slopes = self.slopes(values);
        let values = match N {
            2 => self.raised::<1>(values),
            3 => self.raised::<2>(values),
            _ => self.raised::<3>(values),
        };
        (values, slopes)
    }

    /// First derivatives for degree N − 1 from values of degree N − 2.
    #[inline]
    fn slopes(self, values: [f64; N]) -> [f64; N] {
        let degree = N - 1;
        let own: [f64; N] = from_fn(|r| {
            if r < degree { degree as f64 * values[r] * self.widths[r][degree - 1] } else { 0.0 }
        });
        from_fn(|r| if r == 0 { -own[0] } else { own[r - 1] - own[r] })
    }
}

/// The values that the functions of a span act on: as many as there are functions, in a number
/// that the compiler knows where it knows theirs.
#[inline]
pub(crate) fn acting<'a, T>(values: &'a [T], span: usize, basis: &[f64]) -> &'a [T] {
    &values[span + 1 - basis.len()..][..basis.len()]
}
