//! The parameters of a file as data: what each takes, what it is by default, what it is for.
//!
//! Only the parameters are evaluated, and what their defaults and ranges use.

use super::{
    globals::Globals,
    ir::{Definition, DefinitionRole, Program},
    load::load,
    machine::Machine,
    outcome::in_order,
    param::rules,
    settings::Settings,
    worker::{Inputs, Worker},
};
use crate::{
    diag::{Diagnostic, Severity, Sources},
    syntax::ast::Unit,
    value::{Dimension, Number, Value},
};

/// An input of a file.
#[derive(Clone, Debug)]
pub struct SchemaParameter {
    /// Its name.
    pub name: String,
    /// The word of its kind, stated or taken from the default.
    pub kind: &'static str,
    /// Its value unless another is given.
    pub default: Value,
    /// A range of numbers or a list of choices.
    pub allowed: Option<Value>,
    /// Between neighbouring values, from the start of the range.
    pub step: Option<Number>,
    /// The text behind it.
    pub label: Option<String>,
    /// The `///` lines before it.
    pub docs: Option<String>,
}

impl Schema {
    /// The names of the parameters, in order.
    #[must_use]
    pub fn names(&self) -> Vec<&str> {
        self.parameters.iter().map(|parameter| parameter.name.as_str()).collect()
    }
}

impl SchemaParameter {
    /// Whether it is a length.
    #[must_use]
    pub fn is_length(&self) -> bool {
        matches!(&self.default, Value::Number(number) if number.dim == Dimension::LENGTH)
    }

    /// The dimension that its default has for certain; none of other kinds than numbers.
    #[must_use]
    pub fn dimension(&self) -> Option<Dimension> {
        match &self.default {
            Value::Number(number) if !number.dim.is_bare() => Some(number.dim),
            _ => None,
        }
    }

    /// What stands behind its numbers where lengths are in `unit`: `mm`, `mm^2`, `deg`; nothing without a dimension.
    #[must_use]
    pub fn unit_text(&self, unit: &str) -> Option<String> {
        let dim = self.dimension()?;
        if dim.is_angle() { Some("deg".to_owned()) } else { dim.suffix(unit) }
    }

    /// A value of it, or what it allows, as the script could write it: lengths in the document's unit.
    #[must_use]
    pub fn written(&self, value: &Value, unit: &str) -> String {
        let suffix =
            self.dimension().filter(|dim| !dim.is_angle()).and_then(|dim| dim.suffix(unit));
        let number = |number: Number| match &suffix {
            Some(suffix) => format!("{number}{suffix}"),
            None => number.to_string(),
        };
        match value {
            Value::Number(one) => number(*one),
            Value::Range(range) => {
                let dots = if range.closed { ".." } else { "..<" };
                format!("{}{dots}{}", number(range.start), number(range.end))
            }
            Value::List(choices) => {
                let choices = choices.iter().map(|choice| self.written(choice, unit));
                choices.collect::<Vec<_>>().join(", ")
            }
            other => other.to_string(),
        }
    }
}

/// The inputs of a file.
#[derive(Debug)]
pub struct Schema {
    /// In the order of the source; those that could not be evaluated are left out.
    pub parameters: Vec<SchemaParameter>,
    /// The unit of length.
    pub unit: Unit,
    /// What is wrong with the text, its names, or its parameters.
    pub diagnostics: Vec<Diagnostic>,
}

/// The parameters of the script `text`, which messages call `name`.
#[must_use]
pub fn parameters(name: &str, text: &str, sources: &mut Sources, settings: Settings<'_>) -> Schema {
    let mut loaded = load(name, text, sources, settings);
    let mut diagnostics = std::mem::take(&mut loaded.diagnostics);
    let (program, home) = (&loaded.program, Globals::new(&loaded.program, "", settings.recall));
    let mut worker = Worker::new(Machine::new(loaded.env(settings), home), settings.recall);
    let inputs = Inputs { given: &[], registry: settings.registry };

    // Evaluate what the parameters use.
    let is_used = used_by_parameters(program);
    for component in program.components.iter().filter(|component| is_used[component[0]]) {
        worker.component(program, component, inputs);
    }

    // Ask the parameters that have a value for what they allow.
    let mut parameters = Vec::new();
    for (idx, definition) in program.definitions.iter().enumerate() {
        let DefinitionRole::Param(stated) = &definition.role else { continue };
        if worker.machine.home.value(idx).is_none() {
            continue;
        }
        // A mistake was told when the parameter was evaluated.
        let Ok((rules, default)) = rules(&mut worker.machine, definition, stated) else { continue };
        parameters.push(SchemaParameter {
            name: definition.name.to_string(),
            kind: rules.kind.word(),
            default,
            allowed: rules.allowed.map(|(value, _)| value),
            step: rules.step.map(|(step, _)| step),
            label: rules.label,
            docs: stated.docs.clone(),
        });
    }
    diagnostics.append(&mut worker.diagnostics);
    diagnostics.append(&mut worker.machine.warnings);
    diagnostics.extend(loaded.library.take_findings());
    // Mistakes of imported files that take no parameter away do not concern them.
    let is_param = |definition: &&Definition| matches!(definition.role, DefinitionRole::Param(_));
    if parameters.len() == program.definitions.iter().filter(is_param).count() {
        let is_own = |found: &Diagnostic| loaded.document.holds(found.primary.span);
        diagnostics.retain(|found| found.severity != Severity::Error || is_own(found));
    }
    in_order(&mut diagnostics);
    Schema { parameters, unit: loaded.unit, diagnostics }
}

/// Which definitions are parameters, or are used by one.
fn used_by_parameters(program: &Program) -> Vec<bool> {
    let definitions = &program.definitions;
    let is_param = |&idx: &usize| matches!(definitions[idx].role, DefinitionRole::Param(_));
    let mut left: Vec<usize> = (0..definitions.len()).filter(is_param).collect();
    let mut is_used = vec![false; definitions.len()];
    while let Some(idx) = left.pop() {
        if !is_used[idx] {
            is_used[idx] = true;
            left.extend(definitions[idx].dependencies.iter().map(|used| used.definition));
        }
    }
    is_used
}
