//! Slopes of derivatives in space from those of the homogeneous ones, of curves and of surfaces.

use glam::{DVec3, DVec4};

use super::{binomials, rows::VariableRows};

/// Orders of derivatives up to a total one: by the parameter of a curve, or by both of a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Orders {
    pub(super) most: usize,
    pub(super) of_surface: bool,
}

impl Orders {
    /// All orders, those by the first parameter together.
    pub(super) fn all(self) -> impl Iterator<Item = (usize, usize)> + Clone {
        let last = move |k: usize| if self.of_surface { self.most - k } else { 0 };
        (0..=self.most).flat_map(move |k| (0..=last(k)).map(move |l| (k, l)))
    }

    pub(super) fn len(self) -> usize {
        self.place(self.most, 0) + 1
    }

    /// Where an order stands among all.
    pub(super) fn place(self, k: usize, l: usize) -> usize {
        match self.of_surface {
            true => k * (2 * self.most + 3 - k) / 2 + l,
            false => k,
        }
    }

    /// The slopes of derivatives in space by each variable, from those of the homogeneous ones: of Leibniz' rule for w·S.
    ///
    /// Piegl & Tiller, *The NURBS Book*, (4.8) and (4.20).
    pub(super) fn in_space(
        self,
        all: &VariableRows<DVec4>,
        (weights, is_rational): (&[f64], bool),
        space: &[DVec3],
    ) -> VariableRows<DVec3> {
        let mut found = VariableRows::new(self.len());
        for (variable, own) in all.rows() {
            let slopes = found.push(variable, DVec3::ZERO);
            // One weight everywhere divides alike.
            if is_rational || own.iter().any(|slope| slope.w != 0.0) {
                self.row_in_space(own, weights, space, slopes);
            } else {
                let pairs = slopes.iter_mut().zip(own);
                pairs.for_each(|(slope, own)| *slope = own.truncate() / weights[0]);
            }
        }
        found
    }

    /// Those by one variable.
    fn row_in_space(self, own: &[DVec4], weights: &[f64], space: &[DVec3], slopes: &mut [DVec3]) {
        for (k, l) in self.all() {
            let mut sum = own[self.place(k, l)].truncate();
            for (i, of_u) in binomials(k).enumerate() {
                for (j, of_v) in binomials(l).enumerate() {
                    let (here, rest) = (self.place(i, j), self.place(k - i, l - j));
                    sum -= space[rest] * (of_u * of_v * own[here].w);
                    if 0 < i + j {
                        sum -= slopes[rest] * (of_u * of_v * weights[here]);
                    }
                }
            }
            slopes[self.place(k, l)] = sum / weights[0];
        }
    }
}
