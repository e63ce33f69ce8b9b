//! What was done to make a piece of geometry, for whoever asks.

use std::sync::Arc;

use glam::DVec3;

/// What a construction did that its result does not show: facts under names, in order.
///
/// It travels with the geometry that the construction returns ([`crate::NurbsCurve::with_receipt`],
/// [`crate::NurbsSurface::with_receipt`]); whatever is made of that geometry has none, or its own.
/// Two receipts are always equal: none is a part of the geometry.
///
/// ```
/// use virote_kernel::Receipt;
///
/// let receipt = Receipt::of("offset").with("pieces", 12).with("cusps", vec![0.25, 0.75]);
/// assert_eq!(receipt.facts().count(), 3);
/// ```
#[derive(Clone, Debug, Default)]
pub struct Receipt {
    /// Behind one pointer, as most geometry has none.
    facts: Option<Arc<Vec<(&'static str, Fact)>>>,
}

/// A fact of a [`Receipt`].
#[derive(Clone, Debug)]
pub enum Fact {
    /// Not known, or not there.
    None,
    /// Whether something was so.
    Truth(bool),
    /// A number without a unit: a count, a parameter, a distance in model units.
    Number(f64),
    /// An angle in radians.
    Angle(f64),
    /// A place or a direction.
    Point(DVec3),
    /// A word.
    Text(Arc<str>),
    /// Several facts of a kind.
    List(Vec<Self>),
    /// Facts about a part.
    Record(Receipt),
}

impl Receipt {
    /// The one without facts.
    pub(crate) const NONE: Self = Self { facts: None };

    /// The receipt of an operation, as scripts call it: the first fact is its name.
    #[must_use]
    pub fn of(operation: &str) -> Self {
        Self::default().with("operation", operation)
    }

    /// The same with one more fact.
    #[must_use]
    pub fn with(mut self, name: &'static str, fact: impl Into<Fact>) -> Self {
        Arc::make_mut(self.facts.get_or_insert_default()).push((name, fact.into()));
        self
    }

    /// The receipt, if it has facts.
    pub(crate) fn if_any(&self) -> Option<&Self> {
        self.facts.as_ref().map(|_| self)
    }

    /// The facts in order.
    pub fn facts(&self) -> impl Iterator<Item = (&'static str, &Fact)> {
        self.facts.iter().flat_map(|facts| facts.iter()).map(|(name, fact)| (*name, fact))
    }
}

impl PartialEq for Receipt {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl From<bool> for Fact {
    fn from(truth: bool) -> Self {
        Self::Truth(truth)
    }
}

impl From<f64> for Fact {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<usize> for Fact {
    fn from(count: usize) -> Self {
        Self::Number(count as f64)
    }
}

impl From<DVec3> for Fact {
    fn from(point: DVec3) -> Self {
        Self::Point(point)
    }
}

impl From<&str> for Fact {
    fn from(text: &str) -> Self {
        Self::Text(Arc::from(text))
    }
}

impl From<Receipt> for Fact {
    fn from(receipt: Receipt) -> Self {
        Self::Record(receipt)
    }
}

impl<T: Into<Self>> From<Option<T>> for Fact {
    fn from(fact: Option<T>) -> Self {
        fact.map_or(Self::None, Into::into)
    }
}

impl<T: Into<Self>> From<Vec<T>> for Fact {
    fn from(facts: Vec<T>) -> Self {
        Self::List(facts.into_iter().map(Into::into).collect())
    }
}
