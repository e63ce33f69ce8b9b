//! Completion behind a dot: fields of records and geometry, names of imported files.

use std::ops::Range;

use super::{
    Completion, CompletionKind, NameRole, Outline, Values,
    completion::CompletionSpot,
    wanted_types::{WantedTypes, type_of},
};
use crate::{
    kernel::Curve,
    syntax::{self, Highlight},
    value::{Type, Value, field, field_names, field_names_of},
};

/// Control points up to which what a curve is made of is told beside its fields.
const MOST_TOLD: usize = 100;

/// What stands before a dot, as far as it is known.
enum Owner {
    Value(Value),
    Type(Type),
}

impl Owner {
    fn field(self, name: &str, values: Option<&Values>) -> Option<Self> {
        let Self::Value(value) = self else { return None };
        let tolerance = values?.report().document.1;
        field(&value, name, tolerance).ok().flatten().map(Self::Value)
    }

    fn element(self, number: Option<usize>) -> Option<Self> {
        match self {
            // Elements of a list are mostly of one kind.
            Self::Value(Value::List(items)) => {
                items.get(number.unwrap_or(0)).or_else(|| items.get(0)).map(Self::Value)
            }
            Self::Type(Type::List(of, _)) => Some(Self::Type(*of)),
            // A row has the names of the columns.
            Self::Value(Value::Table(table)) => Some(Self::Value(Value::Table(table))),
            _ => None,
        }
    }

    /// What it answers where it is called.
    fn called(&self) -> Option<Self> {
        let is_geometry = match self {
            Self::Value(value) => {
                matches!(value, Value::Curve(_) | Value::Surface(_) | Value::Face(_))
            }
            Self::Type(ty) => matches!(ty, Type::Curve | Type::Surface | Type::Face),
        };
        is_geometry.then_some(Self::Type(Type::Point))
    }
}

impl CompletionSpot<'_> {
    /// Members of what stands before the dot.
    pub(super) fn fields(&self, of: &str, range: &Range<usize>) -> Vec<Completion> {
        let one = |name: &str| Completion::new(name, CompletionKind::Field, range);
        match self.owner(of) {
            Some(Owner::Value(value)) => {
                let told =
                    |name: &str| one(name).detail(self.told(&value, name).unwrap_or_default());
                field_names(&value).into_iter().map(told).collect()
            }
            Some(Owner::Type(ty)) => field_names_of(ty).into_iter().map(one).collect(),
            None => self.names_of_import(of, range),
        }
    }

    /// What a field holds, where that is quickly known.
    fn told(&self, value: &Value, name: &str) -> Option<String> {
        let values = self.values?;
        let is_small = match value {
            Value::Record(_) | Value::Point(_) | Value::Range(_) | Value::Frame(_) => true,
            Value::Curve(Curve::Nurbs(curve)) => curve.control_points().len() <= MOST_TOLD,
            _ => false,
        };
        if !is_small {
            return None;
        }
        let tolerance = values.report().document.1;
        let held = field(value, name, tolerance).ok().flatten()?;
        Some(values.brief(&held).unwrap_or_else(|| held.kind().to_owned()))
    }

    /// What an expression before a dot stands for: `a.b[0]`, `circle(p, 1)`, `c(0.5)`.
    fn owner(&self, of: &str) -> Option<Owner> {
        let pieces: Vec<&str> = syntax::pieces(of)
            .into_iter()
            .filter(|(paint, _)| *paint != Highlight::Comment)
            .map(|(_, range)| &of[range])
            .collect();
        let (&head, mut rest) = pieces.split_first()?;
        let mut owner = match rest.first() {
            Some(&"(") if self.registry.get(head).is_some() && !self.is_defined(head) => {
                rest = behind_brackets(rest);
                let (_, ops) = self.registry.get(head)?;
                Owner::Type(ops.first()?.returns)
            }
            _ => self.named(head)?,
        };
        while let Some(&piece) = rest.first() {
            let next = rest.get(1).copied().unwrap_or_default();
            owner = match piece {
                "." => owner.field(next, self.values)?,
                "[" => owner.element(next.parse().ok())?,
                "(" => owner.called()?,
                _ => return None,
            };
            rest = if piece == "." { &rest[rest.len().min(2)..] } else { behind_brackets(rest) };
        }
        Some(owner)
    }

    /// Whether the script itself says what a name stands for here, also where there is an operation of that name.
    fn is_defined(&self, name: &str) -> bool {
        let is_known = |known: &super::DefinedName| {
            known.name == name && (known.is_of_file || known.scope.contains(&self.at))
        };
        self.document.outline.names.iter().any(is_known)
    }

    /// What a name stands for: its value, or what it promises.
    fn named(&self, name: &str) -> Option<Owner> {
        let names = &self.document.outline.names;
        let is_local = |known: &&super::DefinedName| {
            known.name == name && !known.is_of_file && known.scope.contains(&self.at)
        };
        let local = names.iter().rev().find(is_local);
        if local.is_none()
            && let Some(value) = self.values.and_then(|values| values.value(name))
        {
            return Some(Owner::Value(value.clone()));
        }
        let known =
            local.or_else(|| names.iter().find(|known| known.is_of_file && known.name == name));
        let Some(known) = known else {
            let constant = self.registry.constant(name)?;
            return Some(Owner::Value((constant.value)()));
        };
        match known.role {
            NameRole::Definition(kind) => type_of(kind).map(Owner::Type),
            _ => None,
        }
    }

    /// What an imported file defines, also where nothing could be evaluated.
    fn names_of_import(&self, of: &str, range: &Range<usize>) -> Vec<Completion> {
        let alias = self
            .document
            .outline
            .of_file()
            .find(|name| name.role == NameRole::Import && name.name == of);
        let Some(alias) = alias else { return Vec::new() };
        let imports = self.document.imports();
        let path = imports
            .iter()
            .find(|(place, _)| alias.whole.start <= place.start && place.end <= alias.whole.end);
        let file = path.and_then(|(_, path)| {
            self.document.sources.iter().skip(1).position(|source| source.name == *path)
        });
        let outline = file.and_then(|idx| self.document.imported.get(idx));
        let names = outline
            .into_iter()
            .flat_map(Outline::of_file)
            .filter(|name| !name.name.starts_with('_'));
        let anything = WantedTypes::default();
        names
            .map(|name| {
                let found = self.definition(name, range, &anything);
                Completion { kind: CompletionKind::Field, ..found }
            })
            .collect()
    }
}

/// What stands behind the brackets that pieces begin with.
fn behind_brackets<'p, 't>(pieces: &'p [&'t str]) -> &'p [&'t str] {
    let mut depth = 0_usize;
    for (idx, piece) in pieces.iter().enumerate() {
        match *piece {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return &pieces[idx + 1..];
        }
    }
    &[]
}
