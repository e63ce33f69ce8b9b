//! What evaluation may consult.

use std::{fmt, sync::Arc};

use super::imported::ImportInstance;
use crate::{
    diag::{Result, Sources, Span, Spanned},
    kernel::Tolerance,
    limits::{
        Limits,
        work::{MemoryGauge, StopToken},
    },
    syntax::ast::Unit,
    value::{Files, Registry, Value},
};

/// The parameters that an import gives, by name.
pub(super) type GivenParameters = Vec<(Spanned<Arc<str>>, Spanned<Value>)>;

/// The files that a script imports.
pub(crate) trait ImportedFiles: fmt::Debug + Sync {
    /// A file with these parameters, evaluated for a statement; what went wrong in it is told once.
    ///
    /// # Errors
    /// What is wrong with the parameters; the file is at fault in the instance.
    fn value(
        &self,
        file: usize,
        parameters: GivenParameters,
        env: Env<'_>,
    ) -> Result<Arc<ImportInstance>>;

    /// A file with these parameters, evaluated, for a call at `span` under so many expressions.
    ///
    /// # Errors
    /// What is wrong with the parameters; the file is at fault in the instance.
    fn instance(
        &self,
        file: usize,
        parameters: GivenParameters,
        env: Env<'_>,
        place: (Span, usize),
    ) -> Result<Arc<ImportInstance>>;

    /// The identity of all that follows from a file's text, where results are remembered.
    fn identity(&self, file: usize) -> u64;
}

/// What evaluation may consult.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Env<'a> {
    pub(crate) limits: &'a Limits,
    /// How many threads a call of a built-in may use.
    pub(crate) n_threads: usize,
    pub(crate) files: &'a dyn Files,
    pub(crate) tolerance: Tolerance,
    pub(crate) unit: Unit,
    /// Every built-in, for advice.
    pub(crate) registry: Option<&'a Registry>,
    /// The files that the script imports.
    pub(crate) library: Option<&'a dyn ImportedFiles>,
    /// The texts of the script and of what it imports.
    pub(crate) sources: Option<&'a Sources>,
    /// How many bytes of memory are held.
    pub(crate) gauge: &'a MemoryGauge,
    /// Set by whoever no longer wants the answer.
    pub(crate) stop: &'a StopToken,
}
