//! What decides which way a function of the script goes, while derivatives are carried along.

use super::Real;
use crate::diag::Span;

/// A comparison, or a number that stays the same between jumps, of what carries derivatives.
#[derive(Clone, Debug)]
pub struct Switch {
    /// Where it stands.
    pub span: Span,
    /// Which way it went.
    pub state: f64,
    /// What is the same number wherever it goes over from one way to the next; none where that is not known.
    pub margin: Option<Real>,
}

impl Switch {
    /// Whether two went the same way.
    #[must_use]
    pub fn is_like(&self, other: &Self) -> bool {
        self.span == other.span && self.state.to_bits() == other.state.to_bits()
    }
}

/// Whether all went the same way.
#[must_use]
pub fn is_like(a: &[Switch], b: &[Switch]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.is_like(b))
}
