//! Quadratic equations xᵀAx + 2b·x + k = 0, and what kinds of quadrics they can be.
//!
//! By the principal axes an equation is a sum of squares, a linear part along the axes without one, and a
//! constant. A `QuadricTerms` says which of these there are; an equation that was found up to rounding is brought
//! to one by leaving the others out. Korn & Korn, *Mathematical Handbook*, §3.5.

use glam::{DMat3, DVec3};

use super::QuadricKind;
use crate::{numeric::symmetric_eigen::principal_axes, sorting::sort_by};

/// The left side of a quadratic equation.
#[derive(Clone, Copy, Debug)]
pub(super) struct QuadricEquation {
    /// The symmetric A.
    pub(super) squares: DMat3,
    /// b.
    pub(super) linear: DVec3,
    /// k.
    pub(super) constant: f64,
}

/// What an equation has.
#[derive(Clone, Copy, Debug)]
pub(super) struct QuadricTerms {
    /// How many squares.
    n_squares: usize,
    /// How many of these, of the largest, have the same factor.
    n_alike: usize,
    has_linear: bool,
    has_constant: bool,
}

const fn terms(n_squares: usize, has_linear: bool, has_constant: bool) -> QuadricTerms {
    QuadricTerms { n_squares, n_alike: 1, has_linear, has_constant }
}

/// What is round: a sphere, a cylinder, a cone.
pub(super) const ROUND: [QuadricTerms; 3] = [
    QuadricTerms { n_alike: 3, ..terms(3, false, true) },
    QuadricTerms { n_alike: 2, ..terms(2, false, true) },
    QuadricTerms { n_alike: 2, ..terms(3, false, false) },
];

/// All others, what has less first.
pub(super) const OTHERS: [QuadricTerms; 7] = [
    terms(1, false, true),
    terms(2, false, false),
    terms(1, true, true),
    terms(2, false, true),
    terms(2, true, true),
    terms(3, false, false),
    terms(3, false, true),
];

impl QuadricEquation {
    /// The equation in coordinates that are these times `factors`.
    pub(super) fn scaled(&self, factors: DVec3) -> Self {
        let diagonal = DMat3::from_diagonal(factors.recip());
        Self {
            squares: diagonal * self.squares * diagonal,
            linear: diagonal * self.linear,
            constant: self.constant,
        }
    }

    /// The size of its coefficients.
    pub(super) fn norm(&self) -> f64 {
        let squares = self.squares.to_cols_array().map(|x| x * x).iter().sum::<f64>();
        (squares + 2.0 * self.linear.length_squared() + self.constant * self.constant).sqrt()
    }

    /// The nearest equation with such terms, and which kind it is; none where that is no quadric, but
    /// planes, a line or a point. None where the factors that are to be alike have two signs.
    pub(super) fn with_terms(&self, terms: QuadricTerms) -> Option<(Self, Option<QuadricKind>)> {
        let mut axes = principal_axes(self.squares);
        sort_by(&mut axes, |a, b| b.0.abs().total_cmp(&a.0.abs()));
        if terms.n_alike == 2 && terms.n_squares == 3 {
            // The one that differs from the others comes last.
            let gap = |i: usize, j: usize| (axes[i].0 - axes[j].0).abs();
            let odd = if gap(1, 2) < gap(0, 1).min(gap(0, 2)) { 0 } else { 2 };
            let odd = if gap(0, 2) < gap(0, 1).min(gap(1, 2)) { 1 } else { odd };
            axes.swap(odd, 2);
        }
        let mean =
            axes[..terms.n_alike].iter().map(|axis| axis.0).sum::<f64>() / terms.n_alike as f64;
        if axes[..terms.n_alike].iter().any(|axis| axis.0 * mean <= 0.0) {
            return None;
        }
        let (mut squares, mut linear, mut constant) = (DMat3::ZERO, DVec3::ZERO, self.constant);
        let mut at_center = 0.0;
        let mut factors = Vec::with_capacity(3);
        for (i, &(factor, axis)) in axes.iter().enumerate() {
            let along = self.linear.dot(axis);
            if terms.n_squares <= i {
                linear += if terms.has_linear { axis * along } else { DVec3::ZERO };
                continue;
            }
            let new = if i < terms.n_alike { mean } else { factor };
            let center = -along / factor;
            squares += new * DMat3::from_cols(axis * axis.x, axis * axis.y, axis * axis.z);
            linear -= axis * (new * center);
            constant -= factor * center * center;
            at_center += new * center * center;
            factors.push(new);
        }
        let level = if terms.has_constant { constant } else { 0.0 };
        let equation = Self { squares, linear, constant: level + at_center };
        Some((equation, terms.kind(&factors, level)))
    }
}

impl QuadricTerms {
    /// The kind with these factors of the squares, and this constant about the centre.
    fn kind(self, factors: &[f64], level: f64) -> Option<QuadricKind> {
        let n_positive = factors.iter().filter(|factor| 0.0 < **factor).count();
        let is_definite = n_positive == 0 || n_positive == self.n_squares;
        let is_round = 1 < self.n_alike;
        Some(match (self.n_squares, self.has_linear, self.has_constant) {
            (1, true, _) => QuadricKind::ParabolicCylinder,
            (2, true, _) if is_definite => QuadricKind::EllipticParaboloid,
            (2, true, _) => QuadricKind::HyperbolicParaboloid,
            (2, false, true) if is_definite && is_round => QuadricKind::Cylinder,
            (2, false, true) if is_definite => QuadricKind::EllipticCylinder,
            (2, false, true) if !is_round => QuadricKind::HyperbolicCylinder,
            (3, _, false) if !is_definite && is_round => QuadricKind::Cone,
            (3, _, false) if !is_definite => QuadricKind::EllipticCone,
            (3, _, true) if is_definite && is_round => QuadricKind::Sphere,
            (3, _, true) if is_definite => QuadricKind::Ellipsoid,
            // Two squares of the sign that three have together with the constant's other side.
            (3, _, true) if (n_positive == 2) == (level < 0.0) => {
                QuadricKind::HyperboloidOfOneSheet
            }
            (3, _, true) => QuadricKind::HyperboloidOfTwoSheets,
            _ => return None,
        })
    }
}
