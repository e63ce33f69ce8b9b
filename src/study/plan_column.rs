//! A column of a plan: the parameter that it gives values, its unit, and what its cells may hold.

use super::{
    checksum::Checksum,
    vary::{number_and_power, number_and_unit},
};
use crate::{
    eval::{Schema, SchemaParameter, unknown_parameter},
    syntax::ast::Unit,
    value::{Dimension, shortest},
};

/// The column of a plan that names its variants.
pub(super) const ID: &str = "id";

/// The kind of parameters that are texts.
pub(super) const TEXT: &str = "string";

/// What results put behind the name of a parameter that is called like a column of every study.
pub(super) const PRIME: char = '\'';

/// What gives a parameter its values, or variants their names.
#[derive(Debug)]
pub(super) struct PlanColumn {
    pub(super) name: String,
    /// As the header of a file gives it.
    unit: Option<String>,
    pub(super) role: ColumnRole,
    /// Whether blanks around a cell count: of a text that may be any.
    pub(super) keeps_blanks: bool,
}

/// What the cells of a column are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ColumnRole {
    /// Names of variants.
    Id,
    /// Values of a parameter of this kind.
    Parameter(&'static str),
}

impl PlanColumn {
    /// The one of a name, before it is compared with a script.
    pub(super) fn new(name: &str) -> Self {
        Self { name: name.to_owned(), unit: None, role: ColumnRole::Id, keeps_blanks: false }
    }

    /// The one of a title with a unit, as files have it.
    pub(super) fn titled(title: &str) -> Self {
        let (name, unit) = name_and_unit(title);
        Self { unit: unit.map(str::to_owned), ..Self::new(name) }
    }

    /// Finds the parameter, and whether the unit suits it.
    pub(super) fn fit(&mut self, schema: &Schema) -> Result<(), String> {
        if let Some(name) = self.name.strip_suffix(PRIME) {
            self.name = name.to_owned();
        }
        let name = &self.name;
        let found = schema.parameters.iter().find(|parameter| parameter.name == *name);
        let Some(parameter) = found else {
            if name == ID && self.unit.is_none() {
                self.role = ColumnRole::Id;
                return Ok(());
            }
            return Err(unknown_parameter(name, &schema.names()));
        };
        self.role = ColumnRole::Parameter(parameter.kind);
        self.keeps_blanks = parameter.kind == TEXT && parameter.allowed.is_none();
        let Some(unit) = &mut self.unit else { return Ok(()) };
        if unit == "°" {
            "deg".clone_into(unit);
        }
        let wanted = wanted(parameter.kind);
        if is_power(unit, parameter) {
            return Ok(());
        }
        let Some(known) = Unit::from_name(unit) else {
            return Err(match wanted {
                Some((_, units)) => format!(
                    "column `{name}` of the plan has the unit `{unit}`, which is not known; write one of {units}"
                ),
                None => match parameter.unit_text(schema.unit.name()) {
                    Some(own) => format!(
                        "column `{name}` of the plan is in {unit}, but the parameter is in {own}"
                    ),
                    None => {
                        format!("column `{name}` has a unit, `{unit}`, but the parameter has none")
                    }
                },
            });
        };
        match (parameter.kind, known.millimetres().is_some()) {
            ("length", true) | ("angle", false) => Ok(()),
            (kind, _) => Err(format!(
                "column `{name}` of the plan is in {unit}, but the parameter is of the kind {kind}"
            )),
        }
    }

    /// Adds to a sum what its cells mean: under another header the same ones are other values.
    pub(super) fn add_to(&self, sum: &mut Checksum) {
        sum.add_text(&self.name);
        sum.add_text(self.unit.as_deref().unwrap_or_default());
        match self.role {
            ColumnRole::Id => sum.add_text("the id of a variant"),
            ColumnRole::Parameter(kind) => sum.add_text(kind),
        }
        sum.add_text(if self.keeps_blanks { "blanks count" } else { "" });
    }

    /// What is wrong with a cell wherever it stands; a value that the script refuses is a result.
    pub(super) fn check(&self, cell: &str) -> Result<(), String> {
        let is_bare = cell.trim().parse::<f64>().is_ok();
        if self.role == ColumnRole::Parameter("angle") && self.unit.is_none() && is_bare {
            let name = &self.name;
            return Err(format!(
                "`{name}` is an angle, and {} has no unit: call the column `{name} [deg]`, or write `{}deg`",
                cell.trim(),
                cell.trim()
            ));
        }
        if let Some(meant) = self.with_point(cell) {
            let (name, found) = (&self.name, cell.trim());
            return Err(format!(
                "`{name}` holds `{found}`, a number with a decimal comma; write `{meant}`"
            ));
        }
        Ok(())
    }

    /// What a cell means that is a number but for its decimal comma.
    fn with_point(&self, cell: &str) -> Option<String> {
        let ColumnRole::Parameter(kind) = self.role else { return None };
        let meant = cell.trim().replacen(',', ".", 1);
        let is_meant = kind != TEXT && cell.contains(',') && number_and_power(&meant).0.is_some();
        is_meant.then_some(meant)
    }

    /// A cell as a setting of a parameter of a kind.
    pub(super) fn setting(&self, kind: &str, cell: &str) -> String {
        match kind {
            TEXT => cell.to_owned(),
            "bool" => cell.to_lowercase(),
            _ => match number_and_unit(cell) {
                (Some(number), "") => {
                    format!("{}{}", shortest(number), self.unit.as_deref().unwrap_or_default())
                }
                (Some(number), unit) => format!("{}{unit}", shortest(number)),
                (None, _) => cell.to_owned(),
            },
        }
    }
}

/// What a kind measures, and its units.
fn wanted(kind: &str) -> Option<(&'static str, &'static str)> {
    match kind {
        "length" => Some(("a length", "um, mm, cm, m, km, in, ft")),
        "angle" => Some(("an angle", "deg, rad, turn")),
        _ => None,
    }
}

/// Whether a unit such as `mm^2` or `m^-1` is one of what a parameter measures.
fn is_power(unit: &str, parameter: &SchemaParameter) -> bool {
    let Some((base, power)) = unit.split_once('^') else { return false };
    let is_length = Unit::from_name(base).is_some_and(|base| base.millimetres().is_some());
    let of = |dim: Dimension| dim.suffix(base).is_some_and(|own| own == unit);
    is_length && power.parse::<i8>().is_ok() && parameter.dimension().is_some_and(of)
}

/// `x [mm]` is `x` in `mm`.
fn name_and_unit(title: &str) -> (&str, Option<&str>) {
    let title = title.trim();
    match title.strip_suffix(']').and_then(|title| title.rsplit_once('[')) {
        Some((name, unit)) if !unit.trim().is_empty() => (name.trim(), Some(unit.trim())),
        _ => (title, None),
    }
}
