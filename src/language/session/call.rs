//! Built-ins and functions of scripts, called by a program.

use std::sync::Arc;

use super::Session;
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned, nearest},
    eval,
    kernel::Tolerance,
    syntax::ast::Unit,
    value::{Call, Files, Function, Value},
};

/// The arguments of a call by a program.
#[derive(Clone, Debug, Default)]
pub struct Arguments {
    /// Those without a label.
    pub positional: Vec<Value>,
    /// Those with one.
    pub named: Vec<(String, Value)>,
}

impl Session {
    /// The built-in of this name, as a value that can be called.
    ///
    /// # Errors
    /// E0201, with the name that was meant.
    pub fn builtin(&self, name: &str) -> Result<Value> {
        if let Some((name, ops)) = self.registry.get(name) {
            return Ok(Value::Function(Function::Builtin(name, Arc::clone(ops))));
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
    /// use virote_language::{
    ///     kernel::{Tolerance, glam::DVec3},
    ///     session::{Arguments, Session},
    ///     syntax::ast::Unit,
    ///     value::{NoFiles, Value},
    /// };
    ///
    /// let session = Session::default();
    /// let line = session.builtin("line")?;
    /// let ends = [DVec3::ZERO, DVec3::new(3.0, 4.0, 0.0)].map(|end| Value::Point(end));
    /// let arguments = Arguments { positional: ends.into(), named: Vec::new() };
    /// let document = (Unit::Mm, Tolerance::DEFAULT);
    /// let (answer, warnings) = session.call(&line, arguments, document, &NoFiles);
    /// let Value::Curve(curve) = answer? else { panic!("it is a curve") };
    /// assert_eq!(curve.end(), DVec3::new(3.0, 4.0, 0.0));
    /// assert!(warnings.is_empty());
    /// # Ok::<(), Box<virote_language::diag::Diagnostic>>(())
    /// ```
    ///
    /// # Errors
    /// What a script would be told.
    pub fn call(
        &self,
        function: &Value,
        arguments: Arguments,
        document: (Unit, Tolerance),
        files: &dyn Files,
    ) -> (Result<Value>, Vec<Diagnostic>) {
        let Arguments { positional, named } = arguments;
        let call = Call {
            span: Span::default(),
            positional: positional.into_iter().map(Spanned::unplaced).collect(),
            named: named
                .into_iter()
                .map(|(label, value)| {
                    (Spanned::unplaced(Arc::from(label)), Spanned::unplaced(value))
                })
                .collect(),
        };
        self.on_stack(|limits| {
            let settings = self.settings(files, limits);
            let settings = eval::Settings { n_threads: self.n_threads, ..settings };
            eval::invoke(function, call.clone(), document, settings)
        })
    }
}
