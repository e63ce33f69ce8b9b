//! What operations on numbers alone do to many of them at a time.

use super::Dimension;

/// The dimension of a result, where only that of the arguments is known; `None` where they do not fit.
type OfTwo = fn(Dimension, Dimension) -> Option<Dimension>;

/// The same of one argument.
type OfOne = fn(Dimension) -> Option<Dimension>;

/// An operation on plain numbers: what its `run` yields for them, to the bit. A result that is infinite or no
/// number tells that there is none: `run` says what is wrong.
#[derive(Clone, Copy, Debug)]
pub enum OnNumbers {
    /// Of one number.
    One(OfOne, fn(f64) -> f64),
    /// Of an angle, or of a bare number of radians, which is looked at where it is written: it may be meant in
    /// degrees.
    OfAngle(fn(f64) -> f64),
    /// Of two.
    Two(OfTwo, fn(f64, f64) -> f64),
    /// Of one, or of two.
    OneOrTwo {
        /// What it does to one alone.
        one: (OfOne, fn(f64) -> f64),
        /// What it does to two.
        two: (OfTwo, fn(f64, f64) -> f64),
    },
    /// Of two or more, one after the other.
    Fold(OfTwo, fn(f64, f64) -> f64),
    /// Of three.
    Three(fn([Dimension; 3]) -> Option<Dimension>, fn([f64; 3]) -> f64),
}

impl OnNumbers {
    /// The dimension of the result; `None` where the arguments are too few or too many, or do not fit.
    #[must_use]
    pub fn dimension(&self, dims: &[Dimension]) -> Option<Dimension> {
        match (self, dims) {
            (Self::One(of, _) | Self::OneOrTwo { one: (of, _), .. }, &[dim]) => of(dim),
            (Self::OfAngle(_), &[dim]) => {
                (dim.is_bare() || dim.is_angle()).then_some(Dimension::NONE)
            }
            (Self::Two(of, _) | Self::OneOrTwo { two: (of, _), .. }, &[a, b]) => of(a, b),
            (Self::Fold(of, _), &[first, _, ..]) => {
                dims[1..].iter().try_fold(first, |dim, &next| of(dim, next))
            }
            (Self::Three(of, _), &[a, b, c]) => of([a, b, c]),
            _ => None,
        }
    }

    /// The result for arguments whose dimension it takes.
    #[must_use]
    pub fn of(&self, args: &[f64]) -> f64 {
        match (self, args) {
            (Self::One(_, of) | Self::OfAngle(of), &[x])
            | (Self::OneOrTwo { one: (_, of), .. }, &[x]) => of(x),
            (
                Self::Two(_, of) | Self::Fold(_, of) | Self::OneOrTwo { two: (_, of), .. },
                &[first, ref rest @ ..],
            ) => rest.iter().fold(first, |x, y| of(x, *y)),
            (Self::Three(_, of), &[a, b, c]) => of([a, b, c]),
            _ => unreachable!("its dimension is that of as many"),
        }
    }

    /// Replaces each of the first arguments by the result; `others` has a lane for each further one.
    pub fn apply(&self, first: &mut [f64], others: &[Vec<f64>]) {
        match (self, others) {
            (Self::One(_, of) | Self::OfAngle(of), _)
            | (Self::OneOrTwo { one: (_, of), .. }, []) => {
                first.iter_mut().for_each(|x| *x = of(*x));
            }
            (Self::Two(_, of) | Self::Fold(_, of) | Self::OneOrTwo { two: (_, of), .. }, _) => {
                for lane in others {
                    first.iter_mut().zip(lane).for_each(|(x, y)| *x = of(*x, *y));
                }
            }
            (Self::Three(_, of), [second, third]) => {
                let pairs = second.iter().zip(third);
                first.iter_mut().zip(pairs).for_each(|(x, (y, z))| *x = of([*x, *y, *z]));
            }
            (Self::Three(..), _) => unreachable!("its dimension is that of three"),
        }
    }
}
