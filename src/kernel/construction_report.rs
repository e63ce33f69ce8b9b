//! What was done to make a piece of geometry, for whoever asks.

use std::{
    fmt,
    sync::{Arc, OnceLock},
};

use glam::DVec3;

use crate::{NurbsCurve, work};

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
    facts: Option<Arc<ReportFacts>>,
}

/// Facts in their order.
type Facts = Vec<(&'static str, ReportEntry)>;

/// Facts that are known, or found when somebody asks.
enum ReportFacts {
    Told(Facts),
    Asked { ask: Box<dyn Fn() -> ConstructionReport + Send + Sync>, found: OnceLock<Facts> },
}

impl ReportFacts {
    fn get(&self) -> &[(&'static str, ReportEntry)] {
        match self {
            Self::Told(facts) => facts,
            Self::Asked { ask, found } => {
                if let Some(found) = found.get() {
                    return found;
                }
                let facts = ask().facts().map(|(name, fact)| (name, fact.clone())).collect();
                // What work that was ended left is no answer.
                if work::ended().is_some() { &[] } else { found.get_or_init(|| facts) }
            }
        }
    }
}

impl fmt::Debug for ReportFacts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Told(facts) => facts.fmt(f),
            Self::Asked { .. } => f.write_str("Asked"),
        }
    }
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
    /// A curve.
    Curve(Box<NurbsCurve>),
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
        let mut facts = match self.facts.take().map(Arc::try_unwrap) {
            None => Vec::new(),
            Some(Ok(ReportFacts::Told(facts))) => facts,
            Some(Ok(facts)) => facts.get().to_vec(),
            Some(Err(shared)) => shared.get().to_vec(),
        };
        facts.push((name, fact.into()));
        Self { facts: Some(Arc::new(ReportFacts::Told(facts))) }
    }

    /// A report whose facts are found when somebody asks for them, each time the same.
    ///
    /// ```
    /// use virote_kernel::ConstructionReport;
    ///
    /// let report = ConstructionReport::later(|| ConstructionReport::of("intersect").with("proven", true));
    /// assert_eq!(report.facts().count(), 2);
    /// ```
    #[must_use]
    pub fn later(ask: impl Fn() -> Self + Send + Sync + 'static) -> Self {
        let facts = ReportFacts::Asked { ask: Box::new(ask), found: OnceLock::new() };
        Self { facts: Some(Arc::new(facts)) }
    }

    /// The report, if it has facts.
    pub(crate) fn if_any(&self) -> Option<&Self> {
        self.facts.as_ref().map(|_| self)
    }

    /// The facts in order.
    pub fn facts(&self) -> impl Iterator<Item = (&'static str, &ReportEntry)> {
        let facts = self.facts.iter().flat_map(|facts| facts.get());
        facts.map(|(name, fact)| (*name, fact))
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

impl From<NurbsCurve> for ReportEntry {
    fn from(curve: NurbsCurve) -> Self {
        Self::Curve(Box::new(curve))
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
