//! Parameters of a file: kinds, ranges, steps, choices, and values from outside.

use std::sync::Arc;

use super::{
    autodiff::no_derivative,
    ir::{Definition, ParamKind, ParamRules},
    machine::Machine,
    param_dimension::{check_choices, check_range, check_step},
    param_text::read,
    settings::Setting,
};
use crate::{
    diag::{Code, Diagnostic, Fix, Result, Span, Spanned, nearest},
    kernel::tolerance::STEP_RELATIVE,
    syntax::ast::Unit,
    value::{Dimension, Number, Range, Real, Registry, Value},
};

/// A value for a parameter on its way in: from the command line, or from the file that imports.
#[derive(Clone, Copy, Debug)]
pub(super) enum GivenValue<'a> {
    Text(&'a Setting),
    Value(&'a str, &'a Spanned<Value>),
}

impl GivenValue<'_> {
    /// The parameter.
    pub(super) fn name(&self) -> &str {
        match self {
            Self::Text(setting) => &setting.name,
            Self::Value(name, _) => name,
        }
    }
}

/// Evaluates the parameter `definition`, replaced by `setting` if there is one.
pub(super) fn evaluate(
    machine: &mut Machine<'_>,
    definition: &Definition,
    rules: &ParamRules,
    given: Option<&GivenValue<'_>>,
    registry: &Registry,
) -> Result<Value> {
    let (rules, default) = self::rules(machine, definition, rules)?;
    match given {
        None => Ok(default),
        Some(GivenValue::Value(name, given)) => {
            rules.admit(given.value.clone(), given.span, &format!("`{name}`"))
        }
        Some(GivenValue::Text(setting)) => {
            let value = read(machine.env, rules.kind, setting, definition.name_span, registry)?;
            rules.admit(value, definition.name_span, &setting.to_string())
        }
    }
}

/// What the parameter `definition` allows, and its default.
pub(super) fn rules(
    machine: &mut Machine<'_>,
    definition: &Definition,
    rules: &ParamRules,
) -> Result<(ParameterRules, Value)> {
    let default = machine.run(&definition.value, definition.n_slots)?;
    let kind = match rules.kind {
        Some(kind) => kind,
        None => inferred(&default).ok_or_else(|| {
            let message = format!(
                "a parameter is a number, a truth value or a string, found {}",
                default.phrase()
            );
            Box::new(
                Diagnostic::error(Code::BadParameterValue, definition.value.span, message)
                    .hint("use `let` for other values"),
            )
        })?,
    };
    let kind_span = rules.kind_span;
    let of_number = |value| if let Value::Number(number) = value { Some(number.dim) } else { None };
    let said = of_number(default.looked_at()).filter(|dim| !dim.is_bare());
    let rules = ParameterRules {
        kind,
        dim: said.unwrap_or(Dimension::NONE),
        allowed: match &rules.allowed {
            Some(expr) => Some((machine.run(expr, definition.n_slots)?, expr.span)),
            None => None,
        },
        step: match &rules.step {
            Some(expr) => {
                Some((step(machine.run(expr, definition.n_slots)?, expr.span)?, expr.span))
            }
            None => None,
        },
        label: match &rules.label {
            Some(expr) => Some(label(machine.run(expr, definition.n_slots)?, expr.span)?),
            None => None,
        },
        unit: machine.env.unit,
    };
    let meant = inferred(&default).filter(|_| rules.of_kind(&default).is_none());
    let default =
        rules.admit(default, definition.value.span, "the default").map_err(|found| {
            match (meant, kind_span) {
                (Some(kind), Some(place)) => Box::new(
                    found.also(place, "promised here").fix(Fix::replace(place, kind.word())),
                ),
                _ => found,
            }
        })?;
    Ok((rules, default))
}

fn label(value: Value, span: Span) -> Result<String> {
    match value {
        Value::Text(text) => Ok(text.to_string()),
        other => {
            let message = format!("the label of a parameter is a string, found {}", other.phrase());
            Diagnostic::error(Code::WrongKind, span, message).fail()
        }
    }
}

/// The word for the kind of parameter that a value is one of.
pub fn param_kind(value: &Value) -> Option<&'static str> {
    inferred(value).map(ParamKind::word)
}

fn inferred(value: &Value) -> Option<ParamKind> {
    Some(match value {
        Value::Bool(_) => ParamKind::Bool,
        Value::Text(_) => ParamKind::Text,
        Value::Number(number) if number.dim == Dimension::LENGTH => ParamKind::Length,
        Value::Number(number) if number.dim.is_angle() => ParamKind::Angle,
        Value::Number(_) => ParamKind::Number,
        _ => return None,
    })
}

fn step(value: Value, span: Span) -> Result<Number> {
    match value {
        Value::Number(number) if 0.0 < number.value => Ok(number),
        other => {
            let message = format!("a step is a positive number, found {}", other.phrase());
            Diagnostic::error(Code::BadParameterValue, span, message).fail()
        }
    }
}

/// What a parameter allows, evaluated.
pub(super) struct ParameterRules {
    pub(super) kind: ParamKind,
    /// What a number measures, by its default.
    dim: Dimension,
    pub(super) allowed: Option<(Value, Span)>,
    pub(super) step: Option<(Number, Span)>,
    pub(super) label: Option<String>,
    /// The document's unit, for messages.
    unit: Unit,
}

impl ParameterRules {
    /// `value` in the parameter's kind, if the rules allow it; `subject` names it in messages.
    fn admit(&self, value: Value, span: Span, subject: &str) -> Result<Value> {
        if let Value::Jet(varying) = &value {
            return self.admit_varying(varying, span, subject);
        }
        let value = self.of_kind(&value).ok_or_else(|| {
            let wanted = match self.kind {
                ParamKind::Integer | ParamKind::Angle => format!("an {}", self.kind.word()),
                ParamKind::Number if !self.dim.is_bare() => self.dim.to_string(),
                kind => format!("a {}", kind.word()),
            };
            let message = format!("{subject} must be {wanted}, found {}", self.phrase(&value));
            let diagnostic = Diagnostic::error(Code::BadParameterValue, span, message);
            Box::new(match self.kind {
                ParamKind::Angle => diagnostic.hint("angles take a unit: `30deg`"),
                _ => diagnostic,
            })
        })?;
        if let Some((allowed, place)) = &self.allowed {
            self.inside(&value, allowed, span, *place, subject)?;
        }
        Ok(value)
    }

    /// The same of a number that carries derivatives.
    fn admit_varying(&self, number: &Number<Real>, span: Span, subject: &str) -> Result<Value> {
        let admitted = self.admit(Value::Number(number.looked_at()), span, subject)?;
        if self.kind == ParamKind::Integer || self.step.is_some() {
            return no_derivative(&format!("{subject}, which goes in steps,"), span);
        }
        Ok(match admitted {
            Value::Number(plain) => {
                Value::Jet(Arc::new(Number { dim: plain.dim, ..number.clone() }))
            }
            other => other,
        })
    }

    /// Whether a number may measure this: what the default does, or where that is a plain number anything but a length
    /// or an angle, which have kinds of their own.
    fn takes(&self, dim: Dimension) -> bool {
        match self.dim.is_bare() {
            true => !dim.is_angle() && dim != Dimension::LENGTH,
            false => dim == self.dim || dim.is_bare() && self.dim.angle_power() == 0,
        }
    }

    fn of_kind(&self, value: &Value) -> Option<Value> {
        Some(match (self.kind, value) {
            (ParamKind::Bool, Value::Bool(_)) | (ParamKind::Text, Value::Text(_)) => value.clone(),
            (ParamKind::Integer, Value::Number(number)) => {
                number.as_integer()?;
                value.clone()
            }
            (ParamKind::Number, Value::Number(number)) if self.takes(number.dim) => {
                // A bare number counts in units of the document, as a length does.
                let dim = if self.dim.is_bare() { number.dim } else { self.dim };
                Value::Number(Number { dim, ..*number })
            }
            (ParamKind::Length, Value::Number(number)) if number.dim.is_as_length() => {
                Value::Number(Number { dim: Dimension::LENGTH, ..*number })
            }
            (ParamKind::Angle, Value::Number(number)) if number.dim.is_angle() => value.clone(),
            _ => return None,
        })
    }

    fn inside(
        &self,
        value: &Value,
        allowed: &Value,
        span: Span,
        place: Span,
        subject: &str,
    ) -> Result<()> {
        let outside = |what: String| {
            let message = format!("{subject} is {}, {what}", self.shown(value));
            Diagnostic::error(Code::BadParameterValue, span, message).also(place, "what is allowed")
        };
        match (allowed, value) {
            (Value::Range(range), Value::Number(number)) => {
                self.in_range(*number, range, place, outside)
            }
            (Value::List(choices), _) => {
                if let Value::Number(number) = value {
                    check_choices(*number, choices, place, self.unit.name())?;
                }
                let is_allowed = |choice: &Value| crate::value::equal(choice, value) == Some(true);
                if choices.iter().any(is_allowed) {
                    return Ok(());
                }
                let told = choices.iter().map(|choice| self.shown(&like(choice, value)));
                let told = told.collect::<Vec<_>>().join(", ");
                let diagnostic = outside(format!("none of [{told}]"));
                let quoted = match value {
                    Value::Text(text) => text.strip_prefix('"').and_then(|t| t.strip_suffix('"')),
                    _ => None,
                };
                match nearest_choice(value, choices) {
                    _ if let Some(bare) = quoted
                        && choices.iter().any(
                            |choice| matches!(choice, Value::Text(text) if **text == *bare),
                        ) =>
                    {
                        diagnostic.hint(format!("a text is given without quotes: {bare}"))
                    }
                    Some(near) => diagnostic.hint(format!("did you mean \"{near}\"?")),
                    None => diagnostic,
                }
                .fail()
            }
            _ => {
                let message = format!(
                    "after `in` stands a range of numbers or a list of choices, found {}",
                    self.phrase(allowed)
                );
                Diagnostic::error(Code::BadParameterValue, place, message).fail()
            }
        }
    }

    fn in_range(
        &self,
        number: Number,
        range: &Range,
        place: Span,
        outside: impl Fn(String) -> Diagnostic,
    ) -> Result<()> {
        check_range(number, range, place)?;
        if let Some((step, step_place)) = self.step {
            check_step(number, step, step_place)?;
        }
        if range.end.value < range.start.value {
            return self.backwards(range, place).fail();
        }
        let in_dim = |end: Number| self.shown(&like(&Value::Number(end), &Value::Number(number)));
        let (start, end) = (in_dim(range.start), in_dim(range.end));
        let is_below = if range.closed {
            number.value <= range.end.value
        } else {
            number.value < range.end.value
        };
        if number.value < range.start.value || !is_below {
            let dots = if range.closed { ".." } else { "..<" };
            return outside(format!("outside {start}{dots}{end}")).fail();
        }
        match self.step {
            Some((step, step_place)) if !is_on_step(number, *range, step) => {
                outside(format!("not a whole number of steps of {} from {start}", in_dim(step)))
                    .also(step_place, "the step")
                    .fail()
            }
            _ => Ok(()),
        }
    }

    /// That a range runs down.
    fn backwards(&self, range: &Range, place: Span) -> Diagnostic {
        let [start, end] = [range.start, range.end].map(|end| self.shown(&Value::Number(end)));
        let dots = if range.closed { ".." } else { "..<" };
        let message = format!("the range {start}{dots}{end} is backwards: it allows nothing");
        Diagnostic::error(Code::BadParameterValue, place, message)
            .hint(format!("a range runs up: write `{end}{dots}{start}`"))
            .fix(Fix::replace(place, format!("{end}{dots}{start}")))
    }

    /// A value as a script would write it, with the document's unit of length.
    fn shown(&self, value: &Value) -> String {
        value.in_unit(self.unit.name()).to_string()
    }

    /// What a value is, in words.
    fn phrase(&self, value: &Value) -> String {
        match value {
            Value::Number(number) if !number.dim.is_bare() => {
                format!("{} ({})", number.dim, self.shown(value))
            }
            Value::Range(_) => format!("the range {}", self.shown(value)),
            other => other.phrase(),
        }
    }
}

/// What a parameter allows, as what its value is: a number without a unit counts in that of the value.
fn like(allowed: &Value, value: &Value) -> Value {
    match (allowed, value) {
        (Value::Number(allowed), Value::Number(value)) if allowed.dim.is_bare() => {
            Value::Number(Number { dim: value.dim, ..*allowed })
        }
        _ => allowed.clone(),
    }
}

/// The choice nearest to a string that is none.
fn nearest_choice<'c>(value: &Value, choices: &'c [Value]) -> Option<&'c str> {
    let Value::Text(text) = value else { return None };
    let words = choices.iter().filter_map(|choice| match choice {
        Value::Text(word) => Some(&**word),
        _ => None,
    });
    nearest(text, words)
}

fn is_on_step(number: Number, range: Range, step: Number) -> bool {
    let steps = (number.value - range.start.value) / step.value;
    (steps - steps.round()).abs() <= STEP_RELATIVE * steps.abs().max(1.0)
}
