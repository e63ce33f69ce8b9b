//! The shortest spelling of a tree, a statement a line. Chains are walked, not recursed over:
//! they are as deep as long.

use crate::syntax::ast::{
    Arg, Block, Comprehension, Definition, Element, Export, Expr, ExprKind, Field, Function,
    Import, Name, Param, Pattern, Statement, StatementKind, StringPart, Tree, UnaryOp, Unit,
};

/// All statements.
pub(super) fn script(tree: &Tree<'_>) -> String {
    let mut out = FlatText(String::new());
    for one in &tree.statements {
        out.documented(one);
    }
    out.0
}

struct FlatText(String);

impl FlatText {
    fn put(&mut self, text: &str) {
        self.0.push_str(text);
    }

    /// A statement with its documentation, on lines of its own.
    fn documented(&mut self, statement: &Statement<'_>) {
        for line in statement.docs.iter().flat_map(|docs| docs.split('\n')) {
            self.put(if line.is_empty() { "///" } else { "/// " });
            self.put(line);
            self.put("\n");
        }
        self.statement(&statement.kind);
        self.put("\n");
    }

    fn statement(&mut self, kind: &StatementKind<'_>) {
        match kind {
            StatementKind::Error => {}
            StatementKind::Edition(edition) => self.keyed("geo ", edition),
            StatementKind::Unit(unit) => {
                self.put("unit ");
                self.put(unit.text);
            }
            StatementKind::Tolerance(tolerance) => self.keyed("tolerance ", tolerance),
            StatementKind::Param(param) => self.param(param),
            StatementKind::Definition(definition) => self.definition(definition),
            StatementKind::Function(function) => self.function(function),
            StatementKind::Check { claim, message } => {
                self.keyed("check ", claim);
                self.optional(" ", message.as_ref());
            }
            StatementKind::Print(items) => {
                self.put("print ");
                self.separated(items, Self::expression);
            }
            StatementKind::Export(export) => self.export(export),
            StatementKind::Import(import) => self.import(import),
            StatementKind::Test { name, body } => {
                self.keyed("test ", name);
                self.put(" {\n");
                for one in body {
                    self.documented(one);
                }
                self.put("}");
            }
            StatementKind::ExpectError { code, subject } => {
                self.keyed("expect error ", code);
                self.keyed(" ", subject);
            }
        }
    }

    fn keyed(&mut self, keyword: &str, value: &Expr<'_>) {
        self.put(keyword);
        self.expression(value);
    }

    fn optional(&mut self, before: &str, value: Option<&Expr<'_>>) {
        if let Some(value) = value {
            self.keyed(before, value);
        }
    }

    fn separated<T>(&mut self, items: &[T], mut item: impl FnMut(&mut Self, &T)) {
        for (index, one) in items.iter().enumerate() {
            if index > 0 {
                self.put(", ");
            }
            item(self, one);
        }
    }

    fn between<T>(
        &mut self,
        [open, close]: [&str; 2],
        items: &[T],
        item: impl FnMut(&mut Self, &T),
    ) {
        self.put(open);
        self.separated(items, item);
        self.put(close);
    }

    fn param(&mut self, param: &Param<'_>) {
        self.put("param ");
        self.put(param.name.text);
        if let Some(kind) = param.kind {
            self.put(": ");
            self.put(kind.text);
        }
        self.keyed(" = ", &param.default);
        self.optional(" in ", param.allowed.as_ref());
        self.optional(" step ", param.step.as_ref());
        self.optional(" ", param.label.as_ref());
    }

    fn definition(&mut self, definition: &Definition<'_>) {
        self.put(definition.kind.word());
        self.put(" ");
        self.pattern(&definition.pattern);
        if definition.pattern != Pattern::Anonymous {
            self.put(" = ");
        }
        self.expression(&definition.value);
        self.options(&definition.with);
    }

    fn function(&mut self, function: &Function<'_>) {
        self.put("fn ");
        self.put(function.name.text);
        self.between(["(", ") = "], &function.parameters, |out, parameter| {
            out.put(parameter.name.text);
            out.optional(" = ", parameter.default.as_ref());
        });
        self.expression(&function.body);
    }

    fn pattern(&mut self, pattern: &Pattern<'_>) {
        match pattern {
            Pattern::Anonymous => {}
            Pattern::Name(name) => self.put(name.text),
            Pattern::List(names, _) => self.names(["[", "]"], names),
            Pattern::Record(names, _) => self.names(["{", "}"], names),
        }
    }

    fn names(&mut self, brackets: [&str; 2], names: &[Name<'_>]) {
        self.between(brackets, names, |out, name| out.put(name.text));
    }

    fn options(&mut self, options: &[Arg<'_>]) {
        if !options.is_empty() {
            self.between([" with (", ")"], options, Self::argument);
        }
    }

    fn export(&mut self, export: &Export<'_>) {
        self.put("export ");
        self.separated(&export.subjects, Self::expression);
        self.keyed(" to ", &export.path);
        self.options(&export.options);
    }

    fn import(&mut self, import: &Import<'_>) {
        self.keyed("import ", &import.path);
        if let Some(alias) = import.alias {
            self.put(" as ");
            self.put(alias.text);
        }
        if let Some(names) = &import.names {
            self.names([" (", ")"], names);
        }
        self.options(&import.with);
    }

    fn expression(&mut self, whole: &Expr<'_>) {
        let mut links = Vec::new();
        let mut head = whole;
        while let Some(left) = left_of(head) {
            links.push(head);
            head = left;
        }
        self.primary(head);
        for link in links.into_iter().rev() {
            self.link(&link.kind);
        }
    }

    /// The part of an expression to the right of what it continues.
    fn link(&mut self, kind: &ExprKind<'_>) {
        match kind {
            ExprKind::Binary(op, operands) => {
                self.put(" ");
                self.put(op.symbol());
                self.keyed(" ", &operands[1]);
            }
            ExprKind::Pipe(operands) => self.keyed(" |> ", &operands[1]),
            ExprKind::Within(operands) => {
                self.keyed(" ~= ", &operands[1]);
                self.keyed(" within ", &operands[2]);
            }
            ExprKind::Call(_, args) => self.between(["(", ")"], args, Self::argument),
            ExprKind::Index(operands) => {
                self.keyed("[", &operands[1]);
                self.put("]");
            }
            ExprKind::Field(_, name) => {
                self.put(".");
                self.put(name.text);
            }
            _ => {}
        }
    }

    fn argument(&mut self, arg: &Arg<'_>) {
        if let Some(name) = arg.name {
            self.put(name.text);
            self.put(" = ");
        }
        self.expression(&arg.value);
    }

    /// An expression that continues none.
    fn primary(&mut self, expr: &Expr<'_>) {
        match &expr.kind {
            ExprKind::Number(value, unit) => self.number(*value, *unit),
            ExprKind::Text(text) => self.put(&format!("\"{}\"", escaped(text))),
            ExprKind::Interpolation(pieces) => {
                self.put("\"");
                for piece in pieces {
                    match piece {
                        StringPart::Text(text) => self.put(&escaped(text)),
                        StringPart::Expr(expr, format) => {
                            self.put("{");
                            // A string ends on its line.
                            let mut inner = Self(String::new());
                            inner.expression(expr);
                            self.put(&inner.0.replace('\n', "; "));
                            if let Some(format) = format {
                                let digits = format.digits.map(|digits| format!(".{digits}"));
                                let unit = format.unit.unwrap_or_default();
                                // Digits and `1/m` would run together.
                                let gap = match digits {
                                    Some(_) if unit.starts_with(|c: char| c.is_ascii_digit()) => {
                                        " "
                                    }
                                    _ => "",
                                };
                                self.put(&format!(":{}{gap}{unit}", digits.unwrap_or_default()));
                            }
                            self.put("}");
                        }
                    }
                }
                self.put("\"");
            }
            ExprKind::Bool(value) => self.put(if *value { "true" } else { "false" }),
            ExprKind::None => self.put("none"),
            ExprKind::Name(text) => self.put(text),
            ExprKind::Placeholder => self.put("_"),
            ExprKind::Group(inner) => {
                self.keyed("(", inner);
                self.put(")");
            }
            ExprKind::Point(coordinates) => self.between(["(", ")"], coordinates, Self::expression),
            ExprKind::List(elements) => self.between(["[", "]"], elements, Self::element),
            ExprKind::Record(fields) => self.between(["{", "}"], fields, Self::field),
            ExprKind::Comprehension(comprehension) => self.comprehension(comprehension),
            ExprKind::Block(block) => self.block(block),
            ExprKind::Unary(UnaryOp::Negate, operand) => self.keyed("-", operand),
            ExprKind::Unary(UnaryOp::Not, operand) => self.keyed("not ", operand),
            ExprKind::Lambda(parameters, body) => {
                match parameters.as_slice() {
                    [only] => self.put(only.text),
                    _ => self.names(["(", ")"], parameters),
                }
                self.keyed(" => ", body);
            }
            ExprKind::If(parts) => {
                self.keyed("if ", &parts[0]);
                self.keyed(" then ", &parts[1]);
                self.keyed(" else ", &parts[2]);
            }
            // Not understood, or printed as links.
            _ => {}
        }
    }

    fn number(&mut self, value: f64, unit: Option<Unit>) {
        let mut buffer = ryu::Buffer::new();
        let digits = buffer.format(value);
        self.put(digits.strip_suffix(".0").unwrap_or(digits));
        self.put(unit.map_or("", Unit::name));
    }

    fn element(&mut self, element: &Element<'_>) {
        match element {
            Element::Item(item) => self.expression(item),
            Element::Spread(list) => self.keyed("...", list),
        }
    }

    fn field(&mut self, field: &Field<'_>) {
        self.put(field.name.text);
        self.optional(": ", field.value.as_ref());
    }

    fn comprehension(&mut self, comprehension: &Comprehension<'_>) {
        self.put("[for ");
        self.separated(&comprehension.generators, |out, generator| {
            out.pattern(&generator.pattern);
            out.keyed(" in ", &generator.source);
            out.optional(" if ", generator.condition.as_ref());
        });
        self.keyed(": ", &comprehension.body);
        self.put("]");
    }

    fn block(&mut self, block: &Block<'_>) {
        self.put("{ ");
        for one in &block.statements {
            self.documented(one);
        }
        self.expression(&block.value);
        self.put(" }");
    }
}

/// What an expression continues to the right.
fn left_of<'a, 's>(expr: &'a Expr<'s>) -> Option<&'a Expr<'s>> {
    match &expr.kind {
        ExprKind::Binary(_, operands) | ExprKind::Pipe(operands) | ExprKind::Index(operands) => {
            Some(&operands[0])
        }
        ExprKind::Within(operands) => Some(&operands[0]),
        ExprKind::Call(callee, _) => Some(callee),
        ExprKind::Field(owner, _) => Some(owner),
        _ => None,
    }
}

/// Text as it stands between quotes.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\n' => out.push_str("\\n"),
            '\t' => out.push_str("\\t"),
            '"' | '\\' | '{' => out.extend(['\\', c]),
            c if c.is_control() => out.extend(c.escape_unicode()),
            c => out.push(c),
        }
    }
    out
}
