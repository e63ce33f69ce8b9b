//! Lowering of calls that name a script. What file that is, is found when all names of the text have
//! their meaning, since the text may give the name of the built-in to something of its own.

use std::{collections::BTreeMap, sync::Arc};

use super::{
    super::ir::{Arg, Expr, ExprKind, ScriptFile},
    Lowerer,
};
use crate::{
    diag::{Code, Diagnostic, Span},
    syntax::ast::{self, Pattern},
};

/// A call that names a script.
#[derive(Debug)]
pub(crate) struct ScriptCall {
    pub(crate) file: Arc<ScriptFile>,
    /// The parameters that it gives, with their places.
    pub(crate) labels: Vec<(Arc<str>, Span)>,
    /// The name that it is the value of.
    pub(crate) name: Option<Span>,
    /// Whether the call is expected to fail.
    pub(crate) is_expected: bool,
}

impl<'s> Lowerer<'_, 's> {
    /// Whether what is called here is the built-in that names a script.
    pub(super) fn is_script_call(&mut self, callee: &ast::Expr<'s>) -> bool {
        match callee.kind {
            ast::ExprKind::Name(name) => {
                self.registry.names_script(name) && self.around(name).is_none()
            }
            _ => false,
        }
    }

    /// A call that names a script; a piped value stands before its arguments.
    pub(super) fn script(
        &mut self,
        piped: Option<&ast::Expr<'s>>,
        args: &[ast::Arg<'s>],
        callee: &ast::Expr<'s>,
    ) -> ExprKind {
        let called = called(callee);
        let (path, with) = match (piped, args.split_first()) {
            (Some(piped), _) => (Some(piped), args),
            (None, Some((first, rest))) if first.name.is_none() => (Some(&first.value), rest),
            (None, _) => (None, args),
        };
        let lowered = self.args(with);
        self.check_given(&lowered);
        let Some(path) = path else {
            let place = args
                .first()
                .and_then(|arg| arg.name.as_ref())
                .map_or(callee.span, |name| name.span);
            let found = Diagnostic::error(
                Code::BadCall,
                self.at(place),
                "the path of the script is missing",
            )
            .hint(format!("it stands first, without a name: `{called}(\"hull.geo\", beam = 3m)`"));
            self.report(found);
            return ExprKind::Poison;
        };
        let place = self.at(path.span);
        let text = match &path.kind {
            ast::ExprKind::Text(text) => text,
            // The parser has told.
            ast::ExprKind::Error => return self.poison(place).kind,
            _ => {
                let message = "the path of a script is a plain string";
                let found = Diagnostic::error(Code::NotConstant, place, message).hint(format!(
                    "files are read before anything is evaluated; to choose among several, name each: `if is_draft then {called}(\"draft.geo\") else {called}(\"hull.geo\")`"
                ));
                self.report(found);
                return ExprKind::Poison;
            }
        };
        let file = Arc::new(ScriptFile {
            path: Arc::from(text.as_str()),
            place,
            found: Default::default(),
        });
        if !self.is_faulty {
            let labels = lowered.iter().filter_map(|arg| arg.label.clone()).collect();
            let file = Arc::clone(&file);
            self.scripts.push(ScriptCall { file, labels, name: None, is_expected: false });
        }
        ExprKind::Script(file, lowered)
    }

    /// The built-in where it is not called.
    pub(super) fn script_as_value(&mut self, name: &str, span: Span) -> Expr {
        let message = format!("`{name}` is called with the path of a file; it is no value");
        self.report(Diagnostic::error(Code::NotConstant, span, message).hint(format!(
            "write a function that calls it: `b => {name}(\"hull.geo\", beam = b)`"
        )));
        Expr { kind: ExprKind::Poison, span }
    }

    /// Parameters that a file is given stand by name, each once, with a value.
    pub(super) fn check_given(&mut self, given: &[Arg]) {
        let mut seen: BTreeMap<&str, Span> = BTreeMap::new();
        for arg in given {
            let Some((label, place)) = &arg.label else {
                self.report(
                    Diagnostic::error(Code::BadCall, arg.span, "parameters are given by name")
                        .hint("for example `chord = 120mm`"),
                );
                continue;
            };
            if arg.value.is_none() {
                self.report(
                    Diagnostic::error(
                        Code::BadCall,
                        arg.span,
                        "a parameter of a file cannot be left open",
                    )
                    .hint(format!("write a function of it, with `{label} = x` behind `x =>`")),
                );
            }
            if let Some(&first) = seen.get(&**label) {
                let message = format!("`{label}` is given twice");
                self.report(
                    Diagnostic::error(Code::BadCall, *place, message).also(first, "the first one"),
                );
            }
            seen.entry(label).or_insert(*place);
        }
    }

    /// Notes that a name, or the names of a pattern, stand for what a script defines.
    pub(super) fn note_script(&mut self, pattern: &Pattern<'s>, value: &Expr) {
        let ExprKind::Script(file, _) = &value.kind else { return };
        match pattern {
            Pattern::Name(name) => {
                let place = self.at(name.span);
                let is_it = |call: &&mut ScriptCall| Arc::ptr_eq(&call.file, file);
                if let Some(call) = self.scripts.iter_mut().rfind(is_it) {
                    call.name = Some(place);
                }
            }
            Pattern::Record(names, _) => {
                for name in names {
                    let used = (file.place, Arc::from(name.text), self.at(name.span));
                    self.noted.part_uses.push(used);
                }
            }
            Pattern::Anonymous | Pattern::List(..) => {}
        }
    }

    /// The place that fields of a subject are known by: of a name its own, of a script its path's.
    pub(super) fn whole_of(&self, subject: &ast::Expr<'s>, lowered: &Expr) -> Option<Span> {
        match (&subject.kind, &lowered.kind) {
            (ast::ExprKind::Name(_), _) => Some(self.at(subject.span)),
            (_, ExprKind::Script(file, _)) => Some(file.place),
            _ => None,
        }
    }
}

/// The name that is called.
fn called<'s>(callee: &ast::Expr<'s>) -> &'s str {
    match callee.kind {
        ast::ExprKind::Name(name) => name,
        _ => "",
    }
}
