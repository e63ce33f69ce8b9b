//! Lowering of statements: the header, the definitions, the effects.

use std::sync::Arc;

use super::{
    super::ir::{
        ALL, Arg, Definition, DefinitionRole, Effect, EffectKind, ExportedSubjects, Expr, ExprKind,
        Group, Kind, ParamKind, ParamRules, PrintedExpr, REPORT,
    },
    Lowerer,
    block::duplicate,
    scope::Captures,
};
use crate::{
    diag::{Code, Diagnostic, Span, nearest},
    kernel::Tolerance,
    syntax::ast::{self, Pattern, Statement, StatementKind, Unit},
    value::Dimension,
};

impl<'s> Lowerer<'_, 's> {
    /// Reads `geo`, `unit` and `tolerance`, which must be known before anything else.
    pub(super) fn header(&mut self, statements: &[Statement<'s>]) {
        let mut seen: [Option<Span>; 3] = [None; 3];
        self.scopes.enter_definition();
        for (idx, statement) in statements.iter().enumerate() {
            let (which, word) = match &statement.kind {
                StatementKind::Edition(_) => (0, "geo"),
                StatementKind::Unit(_) => (1, "unit"),
                StatementKind::Tolerance(_) => (2, "tolerance"),
                _ => continue,
            };
            let span = self.at(statement.span);
            self.begin(statement.span);
            if let Some(first) = seen[which] {
                let message = format!("`{word}` stands twice; once is enough");
                self.report(
                    Diagnostic::error(Code::Misplaced, span, message).also(first, "the first one"),
                );
                continue;
            }
            seen[which] = Some(span);
            match &statement.kind {
                StatementKind::Edition(edition) => self.edition(edition, idx, span),
                StatementKind::Unit(name) => self.set_unit(name),
                _ => {}
            }
        }
        // The unit must be known before a tolerance in another unit can be read.
        for statement in statements {
            if let StatementKind::Tolerance(value) = &statement.kind {
                self.begin(statement.span);
                self.set_tolerance(value);
            }
        }
        self.scopes.leave();
    }

    fn edition(&mut self, edition: &ast::Expr<'s>, idx: usize, span: Span) {
        if idx != 0 {
            self.report(
                Diagnostic::error(Code::Misplaced, span, "`geo` is not the first statement")
                    .hint("the edition stands before everything else"),
            );
        }
        let known =
            self.literal(edition).is_some_and(|number| number.value.as_integer() == Some(1));
        if !known {
            let place = self.at(edition.span);
            self.report(
                Diagnostic::error(
                    Code::WrongEdition,
                    place,
                    "this edition of the language is not known",
                )
                .hint("write `geo 1`"),
            );
        }
    }

    fn set_unit(&mut self, name: &ast::Name<'s>) {
        match Unit::from_name(name.text).filter(|unit| unit.millimetres().is_some()) {
            Some(unit) => self.unit = unit,
            None => {
                let lengths = Unit::ALL.iter().filter(|(_, unit)| unit.millimetres().is_some());
                let names: Vec<&str> = lengths.map(|&(name, _)| name).collect();
                let message = format!("`{}` is not a unit of length", name.text);
                let diagnostic = Diagnostic::error(Code::UnknownUnit, self.at(name.span), message);
                let list = format!("units of length are {}", names.join(", "));
                self.report(match nearest(name.text, names.iter().copied()) {
                    Some(near) => diagnostic.meant(near).hint(list),
                    None => diagnostic.hint(list),
                });
            }
        }
    }

    fn set_tolerance(&mut self, value: &ast::Expr<'s>) {
        let number = self.literal(value).map(|number| number.value);
        let fits = |dim: Dimension| dim.is_as_length();
        match number.filter(|number| 0.0 < number.value && fits(number.dim)) {
            Some(number) => self.tolerance = Tolerance::DEFAULT.with_distance(number.value),
            None => {
                let place = self.at(value.span);
                self.report(
                    Diagnostic::error(
                        Code::NotConstant,
                        place,
                        "the tolerance must be a plain positive length",
                    )
                    .hint("write `tolerance 1e-6` or `tolerance 0.01mm`"),
                );
            }
        }
    }

    /// Lowers all statements: first the names, then what stands under them.
    pub(super) fn statements(
        &mut self,
        statements: &[Statement<'s>],
    ) -> (Vec<Definition>, Vec<Effect>) {
        let (mut definitions, mut effects) = (self.known(), Vec::new());
        let mut next = self.first + definitions.len();
        for statement in statements {
            self.declare(statement, &mut next);
        }
        definitions.reserve(next - self.first - definitions.len());
        for statement in statements {
            self.scopes.enter_definition();
            self.uses.clear();
            self.begin(statement.span);
            match &statement.kind {
                StatementKind::Param(param) => {
                    self.param(param, statement.docs.as_deref(), &mut definitions);
                }
                StatementKind::Function(function) => {
                    self.global_function(function, &mut definitions);
                }
                StatementKind::Import(import) => self.import(import, &mut definitions),
                StatementKind::Definition(definition) => {
                    self.definition(definition, statement.span, &mut definitions);
                }
                StatementKind::Check { .. }
                | StatementKind::Print(_)
                | StatementKind::Export(_)
                | StatementKind::ExpectError { .. } => {
                    let kind = self.effect(&statement.kind);
                    let (n_slots, _) = self.scopes.leave();
                    effects.extend(kind.map(|kind| Effect {
                        span: self.at(statement.span),
                        kind,
                        n_slots,
                        dependencies: self.uses.dependencies(),
                        is_poisoned: self.is_poisoned,
                    }));
                    continue;
                }
                _ => {}
            }
            self.scopes.leave();
        }
        (definitions, effects)
    }

    /// Notes the names that a statement defines, in the order in which `statements` lowers them.
    fn declare(&mut self, statement: &Statement<'s>, next: &mut usize) {
        let names: Vec<ast::Name<'s>> = match &statement.kind {
            StatementKind::Param(param) => vec![param.name],
            StatementKind::Function(function) => vec![function.name],
            StatementKind::Import(import) => {
                let names = self.import_names(import);
                self.imports.insert(*next);
                // The whole comes first, and stands also where no name could be found.
                *next += usize::from(import.names.is_some() || names.is_empty());
                names
            }
            StatementKind::Definition(definition) => match &definition.pattern {
                Pattern::Name(name) => vec![*name],
                Pattern::Anonymous => {
                    *next += 1;
                    Vec::new()
                }
                // The whole comes first, without a name.
                Pattern::List(names, _) | Pattern::Record(names, _) => {
                    *next += 1;
                    names.clone()
                }
            },
            _ => Vec::new(),
        };
        for name in names {
            let span = self.at(name.span);
            match self.global(name.text) {
                // A test may hide names of its file.
                Some((idx, first)) if self.first <= idx => {
                    self.diagnostics.push(duplicate(name.text, span, first));
                }
                _ => {
                    let scope = self.tested.as_mut().unwrap_or(&mut self.globals);
                    scope.insert(name.text, (*next, span));
                }
            }
            *next += 1;
        }
    }

    /// Finishes the definition under way.
    pub(super) fn finish(
        &mut self,
        name: &str,
        name_span: Span,
        role: DefinitionRole,
        value: Expr,
    ) -> Definition {
        let (n_slots, _) = self.scopes.leave();
        self.scopes.enter_definition();
        Definition {
            name: Arc::from(name),
            name_span,
            role,
            value,
            n_slots,
            dependencies: std::mem::take(&mut self.uses).dependencies(),
            is_poisoned: std::mem::take(&mut self.is_poisoned),
            with: Vec::new(),
        }
    }

    fn param(
        &mut self,
        param: &ast::Param<'s>,
        docs: Option<&str>,
        definitions: &mut Vec<Definition>,
    ) {
        let kind = param.kind.and_then(|name| {
            let kind =
                ParamKind::ALL.iter().find(|(word, _)| *word == name.text).map(|&(_, kind)| kind);
            if kind.is_none() {
                let words: Vec<&str> = ParamKind::ALL.iter().map(|&(word, _)| word).collect();
                let message = format!("`{}` is not a kind of parameter", name.text);
                let diagnostic = Diagnostic::error(Code::WrongKind, self.at(name.span), message)
                    .hint(format!("kinds of parameters are {}", words.join(", ")));
                self.report(match nearest(name.text, words.iter().copied()) {
                    Some(near) => diagnostic.meant(near),
                    None => diagnostic,
                });
            }
            kind
        });
        let value = self.expr(&param.default);
        let rules = ParamRules {
            kind,
            kind_span: param.kind.map(|name| self.at(name.span)),
            allowed: param.allowed.as_ref().map(|allowed| self.expr(allowed)),
            step: param.step.as_ref().map(|step| self.expr(step)),
            label: param.label.as_ref().map(|label| self.expr(label)),
            docs: docs.map(str::to_owned),
        };
        let span = self.at(param.name.span);
        definitions.push(self.finish(
            param.name.text,
            span,
            DefinitionRole::Param(Box::new(rules)),
            value,
        ));
    }

    fn global_function(&mut self, function: &ast::Function<'s>, definitions: &mut Vec<Definition>) {
        let (lambda, captures) = self.function(function, Arc::default(), Captures::default());
        let span = self.at(function.name.span);
        let kind =
            ExprKind::Lambda(Arc::new(Group { lambdas: vec![lambda] }), 0, captures.sources());
        definitions.push(self.finish(
            function.name.text,
            span,
            DefinitionRole::Function,
            Expr { kind, span },
        ));
    }

    /// The value of a definition, under its promise.
    pub(super) fn promised(&mut self, definition: &ast::Definition<'s>) -> Expr {
        let value = self.expr(&definition.value);
        self.note_script(&definition.pattern, &value);
        if definition.kind == Kind::Let {
            return value;
        }
        let span = value.span;
        let promise = match &definition.pattern {
            Pattern::Name(name) => self.at(name.span),
            _ => span,
        };
        Expr { kind: ExprKind::Promise(Box::new(value), definition.kind, promise), span }
    }

    fn definition(
        &mut self,
        definition: &ast::Definition<'s>,
        statement: Span,
        definitions: &mut Vec<Definition>,
    ) {
        let value = self.promised(definition);
        let with = self.args(&definition.with);
        let role = || DefinitionRole::Value(definition.kind);
        match &definition.pattern {
            Pattern::Name(name) => {
                let span = self.at(name.span);
                let finished = self.finish(name.text, span, role(), value);
                definitions.push(Definition { with, ..finished });
            }
            Pattern::Anonymous => {
                let span = self.at(Span { end: definition.value.span.start, ..statement });
                let finished = self.finish("", span, role(), value);
                definitions.push(Definition { with, ..finished });
            }
            pattern @ (Pattern::List(_, span) | Pattern::Record(_, span)) => {
                let whole = self.first + definitions.len();
                let span = self.at(*span);
                definitions.push(self.finish(
                    "the value taken apart",
                    span,
                    DefinitionRole::Hidden,
                    value,
                ));
                let parts =
                    self.take_apart(pattern, |span| Expr { kind: ExprKind::Global(whole), span });
                for (name, part) in parts {
                    self.uses.add(whole);
                    let span = self.at(name.span);
                    definitions.push(self.finish(name.text, span, role(), part));
                }
            }
        }
    }

    /// What an export writes.
    fn subjects(&mut self, subjects: &[ast::Expr<'s>]) -> ExportedSubjects {
        match subjects {
            [ast::Expr { kind: ast::ExprKind::Name(ALL), .. }] if self.global(ALL).is_none() => {
                ExportedSubjects::All
            }
            [ast::Expr { kind: ast::ExprKind::Name(REPORT), .. }]
                if self.global(REPORT).is_none() =>
            {
                ExportedSubjects::Report
            }
            these => {
                ExportedSubjects::These(these.iter().map(|subject| self.expr(subject)).collect())
            }
        }
    }

    /// An expression of a print, which may be broken as a whole, with what it depends on by itself.
    fn printed(&mut self, expr: &ast::Expr<'s>, is_broken: bool) -> PrintedExpr {
        let others = std::mem::take(&mut self.uses);
        let was_poisoned = std::mem::replace(&mut self.is_poisoned, is_broken);
        let expr = self.expr(expr);
        let dependencies = self.uses.dependencies();
        let is_poisoned = self.is_poisoned;
        self.uses.append(others);
        self.is_poisoned |= was_poisoned;
        PrintedExpr { expr, dependencies, is_poisoned }
    }

    fn effect(&mut self, kind: &StatementKind<'s>) -> Option<EffectKind> {
        Some(match kind {
            StatementKind::Check { claim, message } => EffectKind::Check {
                claim: self.expr(claim),
                message: message.as_ref().map(|message| self.expr(message)),
            },
            StatementKind::Print(exprs) => {
                let is_broken = self.is_poisoned;
                EffectKind::Print(exprs.iter().map(|expr| self.printed(expr, is_broken)).collect())
            }
            StatementKind::Export(export) => {
                let subjects = self.subjects(&export.subjects);
                // Of a text with mistakes nobody knows all.
                self.is_poisoned |= subjects.is_of_whole_file() && !self.origin.faults.is_empty();
                let named = self.uses.definitions();
                let path = self.expr(&export.path);
                let options: Vec<Arg> = self.args(&export.options);
                EffectKind::Export { subjects, named, path, options }
            }
            StatementKind::ExpectError { code, subject } => self.expectation(code, subject)?,
            _ => return None,
        })
    }
}
