//! A function of one number of which roots are sought.

use super::{
    root_error::RootError,
    sample::{Sample, is_zero},
};
use crate::tolerance::ROOT_BESIDE_RELATIVE;

/// Parts of the interval at whose ends a function is asked that is zero along a stretch.
const FLAT_LOOKS: usize = 16;

/// The second place beside a root, as a share of the way to the first: one of them alone may be another root.
const NEARER: f64 = 0.377;

/// A function that keeps how large it was.
pub(super) struct AskedFunction<F> {
    function: F,
    /// Where roots are sought.
    pub(super) ends: [f64; 2],
    /// The greatest value so far, without its sign.
    pub(super) size: f64,
}

impl<F> AskedFunction<F> {
    pub(super) fn new(function: F, ends: [f64; 2]) -> Self {
        Self { function, ends, size: 0.0 }
    }

    pub(super) fn at<E>(&mut self, at: f64) -> Result<Sample, E>
    where
        F: FnMut(f64) -> Result<f64, E>,
    {
        let value = (self.function)(at)?;
        self.size = self.size.max(value.abs());
        Ok(Sample { at, value })
    }

    /// A place at which the function is exactly zero, if it is not so beside it too.
    pub(super) fn single<E>(&mut self, root: Sample) -> Result<Sample, RootError<E>>
    where
        F: FnMut(f64) -> Result<f64, E>,
    {
        let [start, end] = self.ends;
        for reach in [-1.0, 1.0].map(|side| side * ROOT_BESIDE_RELATIVE * (end - start)) {
            let far = root.at + reach;
            let is_zero_beside = |at: f64| (at < root.at || root.at < at) && self.is_zero_at(at);
            if [far, root.at + NEARER * reach].into_iter().all(is_zero_beside) {
                let looks = (0..=FLAT_LOOKS).map(|k| k as f64 / FLAT_LOOKS as f64);
                let is_everywhere =
                    looks.map(|k| start + k * (end - start)).all(|at| self.is_zero_at(at));
                let stretch =
                    if is_everywhere { self.ends } else { [root.at.min(far), root.at.max(far)] };
                return Err(RootError::Flat { stretch });
            }
        }
        Ok(root)
    }

    /// Whether the function is zero at a place of the interval; where it fails it is not.
    fn is_zero_at<E>(&mut self, at: f64) -> bool
    where
        F: FnMut(f64) -> Result<f64, E>,
    {
        let [start, end] = self.ends;
        start <= at && at <= end && self.at(at).is_ok_and(|sample| is_zero(sample.value))
    }
}
