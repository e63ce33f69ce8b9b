//! A closed interval of the number line: the domain of a curve.

use std::fmt;

use super::{
    DomainError, GeomError,
    digits::plain,
    tolerance::{KNOT_RELATIVE, LAST_BIT},
};

/// Parameters that are larger than the interval is long by this factor are far from zero: their last bits are
/// those of a thousandth of the length.
const FAR_FACTOR: f64 = 1024.0;

/// Last bits of its length by which a parameter of an interval misses zero.
const MOST_DUST: f64 = 4.0;

/// The interval from `start` to `end`. Invariant: both finite, `start < end`, finite length.
///
/// ```
/// use virote_kernel::Interval;
///
/// let domain = Interval::new(2.0, 6.0)?;
/// assert_eq!((domain.at(0.25), domain.fraction_of(5.0)), (3.0, 0.75));
/// assert_eq!(domain.steps(4), [2.0, 3.0, 4.0, 5.0, 6.0]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    start: f64,
    end: f64,
}

impl Interval {
    /// The interval 0..1.
    pub const UNIT: Self = Self { start: 0.0, end: 1.0 };

    /// The interval from `start` to `end`.
    ///
    /// # Errors
    /// [`DomainError::EmptyInterval`] unless `start < end` and their distance is a number.
    pub fn new(start: f64, end: f64) -> Result<Self, GeomError> {
        if start < end && (end - start).is_finite() {
            Ok(Self { start, end })
        } else {
            Err(GeomError::Domain(DomainError::EmptyInterval { start, end }))
        }
    }

    /// Where it begins.
    #[must_use]
    pub fn start(self) -> f64 {
        self.start
    }

    /// Where it ends.
    #[must_use]
    pub fn end(self) -> f64 {
        self.end
    }

    /// `end - start`, positive.
    #[must_use]
    pub fn length(self) -> f64 {
        self.end - self.start
    }

    /// The place a fraction of the way along, exactly the ends at 0 and 1.
    #[must_use]
    pub fn at(self, fraction: f64) -> f64 {
        self.start * (1.0 - fraction) + self.end * fraction
    }

    /// How far along `t` is: 0 at the start, 1 at the end. The inverse of [`Self::at`].
    #[must_use]
    pub fn fraction_of(self, t: f64) -> f64 {
        (t - self.start) / (self.end - self.start)
    }

    /// Whether `t` is between the ends or one of them.
    #[must_use]
    pub fn contains(self, t: f64) -> bool {
        self.start <= t && t <= self.end
    }

    /// `t`, where a parameter outside by rounding counts as the end.
    ///
    /// # Errors
    /// [`DomainError::ParameterOutside`] further out than [`KNOT_RELATIVE`] of the length.
    pub fn clamp_inside(self, t: f64) -> Result<f64, GeomError> {
        let slack = KNOT_RELATIVE * self.length();
        if self.start - slack <= t && t <= self.end + slack {
            Ok(t.clamp(self.start, self.end))
        } else {
            Err(GeomError::Domain(DomainError::ParameterOutside { parameter: t, domain: self }))
        }
    }

    /// `t`; 0 where it is that but for the rounding of the interval's ends.
    pub(crate) fn without_dust(self, t: f64) -> f64 {
        let is_dust = t.abs() <= MOST_DUST * LAST_BIT * self.length();
        if is_dust && self.contains(0.0) { 0.0 } else { t }
    }

    /// 0 to the length, of an interval so far from zero that the last bit of a parameter counts. There
    /// what is searched by parameters is searched, and [`Self::far_from_zero`] tells where it is.
    pub(crate) fn near_zero(self) -> Option<Self> {
        let (length, largest) = (self.length(), self.start.abs().max(self.end.abs()));
        (FAR_FACTOR * length < largest).then_some(Self { start: 0.0, end: length })
    }

    /// The parameter here for one of [`Self::near_zero`]; where that is none, the same.
    pub(crate) fn far_from_zero(self, t: f64) -> f64 {
        match self.near_zero() {
            None => t,
            Some(near) if near.end <= t => self.end,
            Some(_) => (self.start + t).clamp(self.start, self.end),
        }
    }

    /// The sign of steps from `t` that stay inside; none where both do.
    pub(crate) fn inward(self, t: f64) -> Option<f64> {
        if t <= self.start {
            Some(1.0)
        } else if self.end <= t {
            Some(-1.0)
        } else {
            None
        }
    }

    /// The left and the right half.
    pub(crate) fn halves(self) -> [Self; 2] {
        let middle = self.at(0.5);
        [Self { start: self.start, end: middle }, Self { start: middle, end: self.end }]
    }

    /// `n_cells + 1` evenly spaced parameters, both ends among them; no cells give the start.
    #[must_use]
    pub fn steps(self, n_cells: usize) -> Vec<f64> {
        (0..=n_cells).map(|i| self.at(i as f64 / n_cells.max(1) as f64)).collect()
    }
}

impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}..{}", plain(self.start), plain(self.end))
    }
}
