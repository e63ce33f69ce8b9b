//! What an expression is, as far as that is known while it is written: by the last values, by what operations answer,
//! by the form of the expression itself. Nothing of the script is evaluated for it.

use std::ops::Range;

use super::{
    DefinedName, NameRole, Values, completion_spot::CompletionSpot, wanted_types::type_of,
};
use crate::{
    syntax::{
        self,
        ast::{BinaryOp, Element, Expr, ExprKind, StatementKind},
    },
    value::{NoFiles, Op, Type, Value, field},
};

/// Names that stand for names that stand for names are followed so far.
const MOST_NAMES: usize = 8;

/// What an expression is, as far as it is known.
pub(super) enum Owner {
    /// This very value.
    Value(Value),
    /// A value with the same labels.
    Like(Value),
    Type(Type),
    /// A record with these labels.
    Record(Vec<(String, Option<Owner>)>),
    /// A list of such.
    List(Box<Owner>),
    /// A function of these parameters.
    Function(Vec<String>),
}

impl Owner {
    fn field(self, name: &str, values: Option<&Values>) -> Option<Self> {
        let tolerance = || Some(values?.report().document.1);
        match self {
            Self::Value(value) => field(&value, name, tolerance()?).ok().flatten().map(Self::Value),
            Self::Like(value) => field(&value, name, tolerance()?).ok().flatten().map(Self::Like),
            Self::Record(fields) => fields.into_iter().find(|(label, _)| label == name)?.1,
            Self::Type(_) | Self::List(_) | Self::Function(_) => None,
        }
    }

    /// What it is, in a few words; of a value that is only alike its labels.
    pub(super) fn words(&self) -> String {
        let record = |labels: Vec<&str>| format!("record of {}", labels.join(", "));
        match self {
            Self::Value(value) => value.kind().to_owned(),
            Self::Like(Value::Record(fields)) => {
                record(fields.iter().map(|(label, _)| label).collect())
            }
            Self::Like(value) => value.kind().to_owned(),
            Self::Type(ty) => ty.to_string(),
            Self::Record(fields) => record(fields.iter().map(|(label, _)| &**label).collect()),
            Self::List(_) => "list".to_owned(),
            Self::Function(parameters) => format!("function of {}", parameters.join(", ")),
        }
    }

    fn element(self, number: Option<usize>) -> Option<Self> {
        let item = |items: &crate::value::List| {
            // Elements of a list are mostly of one kind.
            items.get(number.unwrap_or(0)).or_else(|| items.get(0))
        };
        match self {
            Self::Value(Value::List(items)) => item(&items).map(Self::Value),
            Self::Like(Value::List(items)) => item(&items).map(Self::Like),
            Self::List(of) => Some(*of),
            Self::Type(Type::List(of, _)) => Some(Self::Type(*of)),
            // A row has the names of the columns.
            Self::Value(table @ Value::Table(_)) => Some(Self::Value(table)),
            _ => None,
        }
    }

    /// What it answers where it is called.
    fn called(&self) -> Option<Self> {
        let is_geometry = match self {
            Self::Value(value) | Self::Like(value) => {
                matches!(value, Value::Curve(_) | Value::Surface(_) | Value::Face(_))
            }
            Self::Type(ty) => matches!(ty, Type::Curve | Type::Surface | Type::Face),
            Self::Record(_) | Self::List(_) | Self::Function(_) => false,
        };
        is_geometry.then_some(Self::Type(Type::Point))
    }

    fn is_point(&self) -> bool {
        matches!(self, Self::Value(Value::Point(_)) | Self::Type(Type::Point))
    }

    /// Whether it may stand where a type is wanted; what is not known may.
    fn may_be(&self, ty: Type) -> bool {
        match self {
            Self::Value(value) | Self::Like(value) => ty.accepts(value),
            Self::Type(of) => *of == ty || !matches!(of, Type::Point | Type::Curve | Type::Surface),
            Self::Record(_) | Self::List(_) | Self::Function(_) => true,
        }
    }
}

impl CompletionSpot<'_> {
    /// What an expression is: `a.b[0]`, `circle(p, 1)`, `c(0.5)`, `{p: 1}`.
    pub(super) fn owner(&self, of: &str) -> Option<Owner> {
        self.owner_of_text(of, 0)
    }

    fn owner_of_text(&self, of: &str, n_names: usize) -> Option<Owner> {
        if MOST_NAMES < n_names {
            return None;
        }
        self.session.tree(&format!("let _ = {of}"), |tree, _| {
            match &tree.statements.first()?.kind {
                StatementKind::Definition(definition) => self.owner_of(&definition.value, n_names),
                _ => None,
            }
        })
    }

    fn owner_of(&self, expr: &Expr<'_>, n_names: usize) -> Option<Owner> {
        let of = |expr: &Expr<'_>| self.owner_of(expr, n_names);
        match &expr.kind {
            ExprKind::Group(inner) | ExprKind::Unary(_, inner) => of(inner),
            ExprKind::Point(_) => Some(Owner::Type(Type::Point)),
            ExprKind::Name(name) => self.owner_of_name(name, n_names),
            ExprKind::Field(inner, name) => of(inner)?.field(name.text, self.values),
            ExprKind::Index(parts) => {
                let number = match parts[1].kind {
                    ExprKind::Number(number, None) => Some(number as usize),
                    _ => None,
                };
                of(&parts[0])?.element(number)
            }
            ExprKind::List(elements) => match elements.first()? {
                Element::Item(item) => Some(Owner::List(Box::new(of(item)?))),
                Element::Spread(list) => of(list),
            },
            ExprKind::Record(fields) => {
                let owner = |field: &crate::syntax::ast::Field<'_>| match &field.value {
                    Some(value) => of(value),
                    None => self.owner_of_name(field.name.text, n_names),
                };
                let fields = fields.iter().map(|field| (field.name.text.to_owned(), owner(field)));
                Some(Owner::Record(fields.collect()))
            }
            ExprKind::Lambda(names, _) => {
                Some(Owner::Function(names.iter().map(|name| name.text.to_owned()).collect()))
            }
            ExprKind::Interpolation(_) | ExprKind::Text(_) => Some(Owner::Type(Type::Text)),
            ExprKind::Bool(_) => Some(Owner::Type(Type::Bool)),
            ExprKind::Block(block) => of(&block.value),
            ExprKind::If(parts) => of(&parts[1]).or_else(|| of(&parts[2])),
            ExprKind::Binary(
                BinaryOp::Add | BinaryOp::Subtract | BinaryOp::Multiply | BinaryOp::Divide,
                parts,
            ) => parts.iter().filter_map(of).find(Owner::is_point),
            ExprKind::Call(callee, args) => {
                self.owner_of_call(callee, args.first().map(|arg| &arg.value), n_names)
            }
            ExprKind::Pipe(parts) => {
                let callee = match &parts[1].kind {
                    ExprKind::Call(callee, _) => callee,
                    _ => &parts[1],
                };
                self.owner_of_call(callee, Some(&parts[0]), n_names)
            }
            _ => None,
        }
    }

    /// What a call answers.
    fn owner_of_call(
        &self,
        callee: &Expr<'_>,
        first: Option<&Expr<'_>>,
        n_names: usize,
    ) -> Option<Owner> {
        let ExprKind::Name(name) = callee.kind else {
            return self.owner_of(callee, n_names)?.called();
        };
        if let Some(known) = self.defined(name) {
            let body = known.value.clone().filter(|_| known.role == NameRole::Function);
            return match body.and_then(|body| self.document.text.get(body)) {
                Some(body) => self.owner_of_text(body, n_names + 1),
                None => self.owner_of_name(name, n_names)?.called(),
            };
        }
        let (_, ops) = self.registry.get(name)?;
        let first = first.and_then(|first| self.owner_of(first, n_names));
        let takes = |op: &&&Op| match (&first, op.params.first()) {
            (Some(first), Some(param)) => first.may_be(param.ty),
            _ => true,
        };
        let op = ops.iter().find(takes).or(ops.first())?;
        match op.returns {
            Type::Record | Type::Any => self.like_example(op),
            returns => Some(Owner::Type(returns)),
        }
    }

    /// A record as an operation answers it, by the first of its documented uses that begins with such a call.
    fn like_example(&self, op: &Op) -> Option<Owner> {
        let call = op.examples.iter().find_map(|example| {
            let rest = example.code.strip_prefix(op.name)?;
            let end = syntax::end_of_brackets(rest)?;
            example.code.get(..op.name.len() + end)
        })?;
        let script = format!("let found = {call}");
        let report = self.session.run(op.name, script.as_bytes(), &NoFiles, &[]);
        let found = report.definitions.first()?.value.clone()?;
        matches!(found, Value::Record(_)).then_some(Owner::Like(found))
    }

    /// The definition that the script itself has of a name here.
    pub(super) fn defined(&self, name: &str) -> Option<&DefinedName> {
        let names = &self.document.outline.names;
        let is_local = |known: &&DefinedName| {
            known.name == name && !known.is_of_file && known.scope.contains(&self.at)
        };
        let local = names.iter().rev().find(is_local);
        local.or_else(|| names.iter().find(|known| known.is_of_file && known.name == name))
    }

    /// What a name stands for: its value, what it promises, or what its definition is.
    fn owner_of_name(&self, name: &str, n_names: usize) -> Option<Owner> {
        let text = &self.document.text;
        let under_way = self.bindings();
        if let Some((_, binding)) = under_way.iter().rev().find(|(bound, _)| *bound == name) {
            let written = |place: &Option<Range<usize>>| text.get(place.clone()?);
            if let Some(source) = written(&binding.source) {
                return self.owner_of_text(source, n_names + 1)?.element(None);
            }
            if let Some(value) = written(&binding.value) {
                return self.owner_of_text(value, n_names + 1);
            }
        }
        let known = self.defined(name);
        let is_local = known.is_some_and(|known| !known.is_of_file);
        if !is_local && let Some(value) = self.values.and_then(|values| values.value(name)) {
            return Some(Owner::Value(value.clone()));
        }
        let Some(known) = known else {
            let constant = self.registry.constant(name)?;
            return Some(Owner::Value((constant.value)()));
        };
        let promised = match known.role {
            NameRole::Definition(kind) => type_of(kind).map(Owner::Type),
            _ => None,
        };
        let is_value = matches!(known.role, NameRole::Definition(_) | NameRole::Param);
        let value = known.value.clone().filter(|_| is_value).and_then(|value| text.get(value));
        promised.or_else(|| self.owner_of_text(value?, n_names + 1))
    }
}
