//! Which parameter is meant by the name of an argument that none has.

use std::collections::HashMap;

use super::{FormalParameter, Value};
use crate::diag::{Spanned, nearest};

/// Names that a misspelt one is compared with.
const MOST_NAMES: usize = 1000;

/// Parameters by name.
pub(super) struct ParameterPlaces<'f>(Option<HashMap<&'f str, usize>>);

impl<'f> ParameterPlaces<'f> {
    /// An index where it pays: with many parameters and many arguments by name.
    pub(super) fn of(formals: &[FormalParameter<'f>], n_named: usize) -> Self {
        /// Arguments up to which one looks through the parameters for each.
        const FEW: usize = 16;
        let places = || formals.iter().enumerate().rev().map(|(idx, formal)| (formal.name, idx));
        Self((FEW < n_named).then(|| places().collect()))
    }

    pub(super) fn find(&self, formals: &[FormalParameter<'_>], name: &str) -> Option<usize> {
        match &self.0 {
            Some(places) => places.get(name).copied(),
            None => formals.iter().position(|formal| *formal.name == *name),
        }
    }
}

/// The required parameter that a value may be meant for, where it is the only one that nothing is given for.
pub(super) fn only_missing(
    formals: &[FormalParameter<'_>],
    slots: &[Option<Spanned<Value>>],
    n_positional: usize,
    value: &Spanned<Value>,
) -> Option<usize> {
    let open = (0..formals.len()).filter(|&idx| !formals[idx].optional && slots[idx].is_none());
    let mut missing = open.skip(n_positional);
    let only = missing.next().filter(|_| missing.next().is_none())?;
    formals[only].ty.is_none_or(|ty| ty.accepts(&value.value)).then_some(only)
}

/// The open parameter that is meant by a name that none has: a near one, or the only one that
/// begins so, among those that are required first.
pub(super) fn meant_by(
    formals: &[FormalParameter<'_>],
    slots: &[Option<Spanned<Value>>],
    name: &str,
) -> Option<usize> {
    let open = || (0..formals.len()).take(MOST_NAMES).filter(|&idx| slots[idx].is_none());
    if let Some(near) = nearest(name, open().map(|idx| formals[idx].name)) {
        return open().find(|&idx| formals[idx].name == near);
    }
    let only = |is_optional: bool| {
        let begins = |idx: &usize| {
            formals[*idx].optional == is_optional && formals[*idx].name.starts_with(name)
        };
        let mut found = open().filter(begins);
        found.next().filter(|_| found.next().is_none())
    };
    only(false).or_else(|| only(true))
}

/// What to write for a diameter, where a radius is asked for.
pub(super) fn half_of(formals: &[FormalParameter<'_>], name: &str) -> Option<String> {
    let has_radius = formals.iter().any(|formal| formal.name == "radius");
    let is_diameter = matches!(name, "d" | "diameter" | "dia");
    (has_radius && is_diameter).then(|| "`radius` is half the diameter".to_owned())
}
