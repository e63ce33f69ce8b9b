//! Lowering of tests: each is a program of its own that sees the definitions of the file.
//!
//! Names of a test belong to it alone, and may hide those of the file.

use std::{collections::BTreeMap, sync::Arc};

use super::{
    super::ir::{EffectKind, Test},
    Lowerer,
};
use crate::{
    diag::{Code, Diagnostic, Fix, RETIRED, Severity, Span, nearest},
    syntax::ast::{self, Statement, StatementKind},
};

impl<'s> Lowerer<'_, 's> {
    /// Lowers the tests among the statements of a file with `n_definitions`, all of them known.
    pub(super) fn tests(
        &mut self,
        statements: &[Statement<'s>],
        n_definitions: usize,
    ) -> Vec<Test> {
        let mut tests = Vec::new();
        self.first = n_definitions;
        for statement in statements {
            if let StatementKind::Test { name, body } = &statement.kind {
                self.tested = Some(BTreeMap::new());
                tests.push(self.test(name, body, statement));
            }
        }
        tests
    }

    fn test(
        &mut self,
        name: &ast::Expr<'s>,
        body: &[Statement<'s>],
        statement: &Statement<'s>,
    ) -> Test {
        let n_found = self.diagnostics.len();
        self.begin(statement.span);
        let name_text = self.plain(name, "the name of a test");
        let mut is_poisoned = self.is_poisoned;
        let program = self.program(body);
        is_poisoned |= n_found < self.diagnostics.len();
        is_poisoned |= program.definitions.iter().any(|definition| definition.is_poisoned);
        is_poisoned |= program.effects.iter().any(|effect| effect.is_poisoned);
        Test {
            name: Arc::from(name_text.unwrap_or_default()),
            span: self.at(name.span),
            program,
            is_poisoned,
        }
    }

    /// The text of a string that must be known before anything is evaluated.
    fn plain<'t>(&mut self, expr: &'t ast::Expr<'s>, subject: &str) -> Option<&'t str> {
        match &expr.kind {
            ast::ExprKind::Text(text) => return Some(text),
            // The parser has told.
            ast::ExprKind::Error => self.is_poisoned = true,
            _ => {
                let message = format!("{subject} is a plain string");
                let place = self.at(expr.span);
                self.report(
                    Diagnostic::error(Code::NotConstant, place, message)
                        .hint("it is needed before anything is evaluated"),
                );
            }
        }
        None
    }

    /// `expect error CODE SUBJECT`: what is wrong with the subject is no mistake of the script.
    pub(super) fn expectation(
        &mut self,
        code: &ast::Expr<'s>,
        subject: &ast::Expr<'s>,
    ) -> Option<EffectKind> {
        let place = self.at(code.span);
        let code = self.plain(code, "the code of an expected error").and_then(|id| {
            let code = Code::from_id(id).filter(|code| code.is_error());
            if code.is_none() {
                self.report(unknown_code(id, place));
            }
            code
        });
        let (n_found, was_poisoned) = (self.diagnostics.len(), self.is_poisoned);
        let n_scripts = self.scripts.len();
        let subject = self.expr(subject);
        // That a file cannot be had may be what is expected.
        self.scripts[n_scripts..].iter_mut().for_each(|script| script.is_expected = true);
        let code = code?;
        let mut found = self.diagnostics.split_off(n_found);
        found.retain(|found| found.severity == Severity::Error);
        if !found.is_empty() {
            // The answer needs no values.
            self.is_poisoned = was_poisoned;
            self.uses.clear();
        }
        // Of several mistakes one of another kind is what happened instead.
        let other = found.iter().position(|found| found.code != code).unwrap_or(0);
        let found = found.into_iter().nth(other).map(Box::new);
        Some(EffectKind::Expect { code, subject, found })
    }
}

/// `expect error` with something that is no code of an error.
fn unknown_code(id: &str, place: Span) -> Diagnostic {
    let codes = || Code::ALL.iter().filter(|code| code.is_error()).map(|code| code.id());
    let (message, near) = match Code::from_id(id) {
        Some(warning) => (
            format!("`{}` is the code of a warning; no expression fails with it", warning.id()),
            None,
        ),
        None if RETIRED.iter().any(|(retired, ..)| retired.eq_ignore_ascii_case(id)) => (
            format!("no mistake has the code {id} any more; `virote explain {id}` tells why"),
            None,
        ),
        None => (format!("no error has the code \"{id}\""), nearest(id, codes())),
    };
    let diagnostic = Diagnostic::error(Code::UnknownCode, place, message);
    match near {
        Some(near) => diagnostic
            .label(format!("did you mean \"{near}\"?"))
            .fix(Fix::replace(place, format!("\"{near}\""))),
        None => diagnostic.hint("`virote explain` lists the codes"),
    }
}
