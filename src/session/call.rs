//! Built-ins and functions of scripts, called by a program.

use std::sync::Arc;

use super::{HeldValue, Report, Session};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned, nearest},
    eval::{self, KeptGlobals},
    kernel::Tolerance,
    syntax::ast::Unit,
    value::{Call, Files, Function, Value},
};

/// The arguments of a call by a program.
#[derive(Clone, Debug, Default)]
pub struct Arguments {
    /// Those without a label.
    pub positional: Vec<HeldValue>,
    /// Those with one.
    pub named: Vec<(String, HeldValue)>,
}

impl Report {
    /// A value of this run, such as one that it printed, with what it needs to answer.
    #[must_use]
    pub fn held(&self, value: Value) -> HeldValue {
        HeldValue { value, kept: self.kept.clone() }
    }
}

impl Session {
    /// The built-in of this name, as a value that can be called.
    ///
    /// # Errors
    /// E0201, with the name that was meant.
    pub fn builtin(&self, name: &str) -> Result<HeldValue> {
        if let Some((name, ops)) = self.registry.get(name) {
            return Ok(Value::Function(Function::Builtin(name, Arc::clone(ops))).into());
        }
        let message = format!("nothing built in is called `{name}`");
        let found = Diagnostic::error(Code::UnknownName, Span::default(), message);
        match nearest(name, self.registry.names()) {
            Some(near) => found.hint(format!("did you mean `{near}`?")),
            None => found,
        }
        .fail()
    }

    /// Calls a function, a curve or a surface, as a script whose document has this unit and tolerance
    /// would; the answer, and what it warns of.
    ///
    /// ```
    /// use virote::{
    ///     kernel::{Tolerance, glam::DVec3},
    ///     session::{Arguments, Session},
    ///     syntax::ast::Unit,
    ///     value::{NoFiles, Value},
    /// };
    ///
    /// let session = Session::default();
    /// let line = session.builtin("line")?;
    /// let ends = [DVec3::ZERO, DVec3::new(3.0, 4.0, 0.0)].map(|end| Value::Point(end).into());
    /// let arguments = Arguments { positional: ends.into(), named: Vec::new() };
    /// let document = (Unit::Mm, Tolerance::DEFAULT);
    /// let (answer, warnings) = session.call(&line, arguments, document, &NoFiles);
    /// let Value::Curve(curve) = &*answer? else { panic!("it is a curve") };
    /// assert_eq!(curve.end(), DVec3::new(3.0, 4.0, 0.0));
    /// assert!(warnings.is_empty());
    /// # Ok::<(), Box<virote::diag::Diagnostic>>(())
    /// ```
    ///
    /// # Errors
    /// What a script would be told.
    pub fn call(
        &self,
        function: &HeldValue,
        arguments: Arguments,
        document: (Unit, Tolerance),
        files: &dyn Files,
    ) -> (Result<HeldValue>, Vec<Diagnostic>) {
        let Arguments { positional, named } = arguments;
        let mut kept = function.clone();
        positional.iter().chain(named.iter().map(|(_, value)| value)).for_each(|value| {
            kept.keep(value);
        });
        let unplaced = |value: &HeldValue| Spanned::unplaced(value.value.clone());
        let call = Call {
            span: Span::default(),
            positional: positional.iter().map(unplaced).collect(),
            named: named
                .iter()
                .map(|(label, value)| {
                    (Spanned::unplaced(Arc::from(label.as_str())), unplaced(value))
                })
                .collect(),
        };
        let (answer, warnings, home) = self.on_stack(|limits| {
            let settings = self.settings(files, limits);
            let settings = eval::Settings { n_threads: self.n_threads, ..settings };
            eval::invoke(&function.value, call.clone(), document, settings)
        });
        let held = |value: Value| {
            // A curve of a function asks it in the file that made it.
            if value.extent().holds_functions {
                kept.kept.keep(&home);
            }
            kept.with(value)
        };
        (answer.map(held), warnings)
    }
}

/// A value that needs nothing else to answer.
impl From<Value> for HeldValue {
    fn from(value: Value) -> Self {
        Self { value, kept: KeptGlobals::default() }
    }
}

impl HeldValue {
    /// Another value, a part of this one or made from it, that needs the same to answer.
    #[must_use]
    pub fn with(&self, value: Value) -> Self {
        Self { value, kept: self.kept.clone() }
    }

    /// Keeps what another value needs as well.
    pub fn keep(&mut self, other: &Self) {
        self.kept.keep(&other.kept);
    }
}
