//! What evaluation is given besides the script.

use std::fmt;

use super::{memory::CacheRun, outcome::Defined};
use crate::{
    diag::nearest,
    limits::{
        Limits,
        work::{MemoryGauge, StopToken},
    },
    value::{Files, Registry},
};

/// A value for a parameter from outside.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setting {
    /// The parameter.
    pub name: String,
    /// Its value as text; strings without quotes.
    pub text: String,
    /// How messages call it: what stands where it was given.
    pub called: String,
}

/// As messages call it.
impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.called)
    }
}

/// What a script is evaluated for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose<'a> {
    /// Its effects.
    Run,
    /// Its effects, and then its tests.
    Test,
    /// Some of its tests.
    SomeTests(TestFilter<'a>),
}

/// Which tests of a script are run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TestFilter<'a> {
    /// Those whose names contain this.
    Containing(&'a str),
    /// Those that are called exactly this.
    Named(&'a str),
}

impl TestFilter<'_> {
    /// Whether a test of this name is run.
    #[must_use]
    pub fn takes(self, name: &str) -> bool {
        match self {
            Self::Containing(part) => name.contains(part),
            Self::Named(whole) => name == whole,
        }
    }
}

/// What evaluation is given besides the script.
#[derive(Clone, Copy, Debug)]
pub struct Settings<'a> {
    /// The built-ins.
    pub registry: &'a Registry,
    /// The ceilings.
    pub limits: &'a Limits,
    /// Reads files that the script names.
    pub files: &'a dyn Files,
    /// Values for parameters.
    pub overrides: &'a [Setting],
    /// How many threads may evaluate.
    pub n_threads: usize,
    /// What of the script acts.
    pub purpose: Purpose<'a>,
    /// What earlier runs gave, if they are to be remembered.
    pub recall: Option<&'a CacheRun<'a>>,
    /// Definitions that stand beside the text, which may use them, with their results of earlier runs.
    pub known: &'a [Defined],
    /// How many bytes of memory are held.
    pub gauge: &'a MemoryGauge,
    /// Set by whoever no longer wants the answer.
    pub stop: &'a StopToken,
}

/// That the script has no parameter of a name: with the nearest one, or all that there are.
///
/// ```
/// use virote_language::eval::unknown_parameter;
///
/// assert_eq!(unknown_parameter("x", &["size", "n"]), "the script has no parameter `x`; it has size, n");
/// ```
#[must_use]
pub fn unknown_parameter(name: &str, names: &[&str]) -> String {
    match (nearest(name, names.iter().copied()), names) {
        (Some(near), _) => {
            format!("the script has no parameter `{name}`; did you mean `{near}`?")
        }
        (None, []) => format!("the script has no parameter `{name}`, nor any other"),
        (None, _) => format!("the script has no parameter `{name}`; it has {}", names.join(", ")),
    }
}
