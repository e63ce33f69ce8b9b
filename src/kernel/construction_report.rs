//! What was done to make a piece of geometry, for whoever asks.

use std::sync::Arc;

use glam::DVec3;

/// What a construction did that its result does not show: facts under names, in order.
///
/// It travels with the geometry that the construction returns ([`crate::NurbsCurve::with_report`],
/// [`crate::NurbsSurface::with_report`]); whatever is made of that geometry has none, or its own.
/// Two reports are always equal: none is a part of the geometry.
///
/// ```
/// use virote_kernel::ConstructionReport;
///
/// let report = ConstructionReport::of("offset").with("pieces", 12).with("cusps", vec![0.25, 0.75]);
/// assert_eq!(report.facts().count(), 3);
/// ```
#[derive(Clone, Debug, Default)]
pub struct ConstructionReport {
    /// Behind one pointer, as most geometry has none.
    facts: Option<Arc<Vec<(&'static str, ReportEntry)>>>,
}

/// A fact of a [`ConstructionReport`].
///
/// ```
/// use virote_kernel::{ConstructionReport, ReportEntry};
///
/// let report = ConstructionReport::of("offset").with("cusps", vec![0.25, 0.75]);
/// let fact = |name: &str| report.facts().find(|&(own, _)| own == name).map(|(_, fact)| fact);
/// assert!(matches!(fact("cusps"), Some(ReportEntry::List(both)) if both.len() == 2));
/// assert!(matches!(fact("operation"), Some(ReportEntry::Text(word)) if &**word == "offset"));
/// ```
#[derive(Clone, Debug)]
pub enum ReportEntry {
    /// Not known, or not there.
    None,
    /// Whether something was so.
    Truth(bool),
    /// A number without a unit: a count, a parameter.
    Number(f64),
    /// A distance in model units.
    Length(f64),
    /// An angle in radians.
    Angle(f64),
    /// A place or a direction.
    Point(DVec3),
    /// A word.
    Text(Arc<str>),
    /// Several facts of a kind.
    List(Vec<Self>),
    /// Many numbers without a unit.
    Numbers(Arc<[f64]>),
    /// Facts about a part.
    Record(ConstructionReport),
}

impl ConstructionReport {
    /// The one without facts.
    pub(crate) const NONE: Self = Self { facts: None };

    /// The report of an operation, as scripts call it: the first fact is its name.
    #[must_use]
    pub fn of(operation: &str) -> Self {
        Self::default().with("operation", operation)
    }

    /// The same with one more fact.
    #[must_use]
    pub fn with(mut self, name: &'static str, fact: impl Into<ReportEntry>) -> Self {
        Arc::make_mut(self.facts.get_or_insert_default()).push((name, fact.into()));
        self
    }

    /// The report, if it has facts.
    pub(crate) fn if_any(&self) -> Option<&Self> {
        self.facts.as_ref().map(|_| self)
    }

    /// The facts in order.
    pub fn facts(&self) -> impl Iterator<Item = (&'static str, &ReportEntry)> {
        self.facts.iter().flat_map(|facts| facts.iter()).map(|(name, fact)| (*name, fact))
    }
}

impl PartialEq for ConstructionReport {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl From<bool> for ReportEntry {
    fn from(truth: bool) -> Self {
        Self::Truth(truth)
    }
}

impl From<f64> for ReportEntry {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<usize> for ReportEntry {
    fn from(count: usize) -> Self {
        Self::Number(count as f64)
    }
}

impl From<DVec3> for ReportEntry {
    fn from(point: DVec3) -> Self {
        Self::Point(point)
    }
}

impl From<&str> for ReportEntry {
    fn from(text: &str) -> Self {
        Self::Text(Arc::from(text))
    }
}

impl From<ConstructionReport> for ReportEntry {
    fn from(report: ConstructionReport) -> Self {
        Self::Record(report)
    }
}

impl<T: Into<Self>> From<Option<T>> for ReportEntry {
    fn from(fact: Option<T>) -> Self {
        fact.map_or(Self::None, Into::into)
    }
}

impl<T: Into<Self>> From<Vec<T>> for ReportEntry {
    fn from(facts: Vec<T>) -> Self {
        Self::List(facts.into_iter().map(Into::into).collect())
    }
}
