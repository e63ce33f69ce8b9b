//! Presentation: what stands after `with` at a definition, and where an export finds it.

use std::collections::HashMap;

use super::{
    file_run::FileRun,
    ir::{Definition, Expr, ExprKind},
    outcome::Defined,
};
use crate::{
    diag::{Code, Diagnostic, Fix, Spanned, nearest},
    limits::work,
    value::{Appearance, COLOR_NAMES, Value, color_of},
};

/// The options that a definition has.
/// Each with what it takes, as the end of a sentence.
pub const OPTIONS: [(&str, &str); 3] = [
    ("color", "a colour, `\"#6688aa\"` or a name such as `\"steelblue\"`"),
    ("layer", "the name of a layer"),
    ("hidden", "`true` for what others are only made of: `all` leaves it out"),
];

impl FileRun<'_> {
    /// Reads the presentation after `with`; what does not fit becomes a finding.
    pub(super) fn look(&mut self, definition: &Definition) -> Appearance {
        let mut look = Appearance::default();
        if definition.is_poisoned || !self.is_ready(&definition.dependencies) {
            return look;
        }
        let mut seen: Vec<Spanned<String>> = Vec::new();
        for option in &definition.with {
            let Some((label, value)) = self.option(option, definition.n_slots) else { continue };
            if let Some(first) = seen.iter().find(|known| known.value == label.value) {
                let message = format!("`{}` is given twice", label.value);
                let found = Diagnostic::error(Code::BadCall, label.span, message);
                self.diagnostics.push(found.also(first.span, "the first one"));
                continue;
            }
            seen.push(label.clone());
            if let Err(found) = read(&label, &value, &mut look) {
                self.diagnostics.push(*found);
            }
        }
        look
    }

    /// The presentation of the definition that an exported expression names, or a part of.
    pub(super) fn look_of_subject(&self, expr: &Expr, looks: &Appearances<'_>) -> Appearance {
        let mut root = expr;
        loop {
            root = match &root.kind {
                ExprKind::Index(parts) => &parts[0],
                ExprKind::Field(whole, ..) => whole,
                ExprKind::Global(_) => break,
                _ => return Appearance::default(),
            };
        }
        let name = self.document.excerpt(root.span);
        work::count(1);
        // It is named, so it is meant.
        looks.0.get(&*name).map_or_else(Appearance::default, |&look| Appearance {
            is_hidden: false,
            ..look.clone()
        })
    }
}

/// The presentation of each definition, by its name.
pub(super) struct Appearances<'d>(HashMap<&'d str, &'d Appearance>);

impl<'d> Appearances<'d> {
    pub(super) fn of(definitions: &[&'d [Defined]]) -> Self {
        // Of two with one name the first counts.
        let all = definitions.iter().rev().flat_map(|some| some.iter().rev());
        Self(all.map(|defined| (&*defined.name, &defined.look)).collect())
    }
}

/// Reads one option.
fn read(
    label: &Spanned<String>,
    value: &Spanned<Value>,
    look: &mut Appearance,
) -> Result<(), Box<Diagnostic>> {
    let wrong = |wanted: &str| {
        let message = format!("`{}` must be {wanted}, found {}", label.value, value.value.phrase());
        Box::new(Diagnostic::error(Code::WrongKind, value.span, message))
    };
    match (label.value.as_str(), &value.value) {
        ("hidden", Value::Bool(hidden)) => look.is_hidden = *hidden,
        ("hidden", _) => return Err(wrong("true or false")),
        ("layer", Value::Text(layer)) => look.layer = Some(layer.clone()),
        ("layer", _) => return Err(wrong("a string")),
        ("color", Value::Text(text)) => {
            look.color = Some(color_of(text).ok_or_else(|| Box::new(no_color(text, value)))?);
        }
        ("color", _) => return Err(wrong("a string")),
        (name, _) => {
            let message = format!("a definition has no option `{name}`");
            let diagnostic = Diagnostic::error(Code::BadCall, label.span, message);
            return Err(Box::new(match nearest(name, OPTIONS.map(|(option, _)| option)) {
                Some(near) => diagnostic.meant(near),
                None => diagnostic.hint("its options are `color`, `layer` and `hidden`"),
            }));
        }
    }
    Ok(())
}

fn no_color(text: &str, value: &Spanned<Value>) -> Diagnostic {
    let message = format!("`{text}` is no colour");
    let diagnostic = Diagnostic::error(Code::BadChoice, value.span, message)
        .hint("write `\"#6688aa\"`, or a name such as `\"steelblue\"`");
    match nearest(text, COLOR_NAMES.iter().map(|&(name, _)| name)) {
        Some(near) => diagnostic
            .label(format!("did you mean `{near}`?"))
            .fix(Fix::replace(value.span, format!("\"{near}\""))),
        None => diagnostic,
    }
}
