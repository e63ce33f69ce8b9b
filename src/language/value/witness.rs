//! What decides tests of lists, for claims to tell.

use super::{List, Value};

/// What decided a test of the elements of a list.
#[derive(Clone, Debug)]
pub struct Witness {
    /// Which of them.
    pub of: WitnessOf,
    /// The elements.
    pub list: List,
    /// The test; none where the elements are true or false themselves.
    pub test: Option<Value>,
}

/// Which elements of a list decided a test of all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WitnessOf {
    /// The first, by its index, that passes or fails.
    Element(usize),
    /// All, alike.
    All,
}
