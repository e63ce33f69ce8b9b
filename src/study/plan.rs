//! The plan of a study: which parameters vary, and the values that each variant gives them.

use std::collections::HashSet;

use serde_json::Value as Json;

use super::{
    checksum::Checksum,
    plan_file::{PlanFile, PlanRow},
    vary::{VariedParameter, number_and_unit},
};
use crate::{
    diag::nearest,
    eval::{Schema, SchemaParameter, Setting},
    syntax::ast::Unit,
    value::{Dimension, shortest},
};

/// Variants of one study; beyond it nobody waits for the end.
const MOST_VARIANTS: u64 = 1_000_000_000;

/// The column of a plan that names its variants.
const ID: &str = "id";

/// The kind of parameters that are texts.
const TEXT: &str = "string";

/// What results put behind the name of a parameter that is called like a column of every study.
pub(super) const PRIME: char = '\'';

/// Which parameters vary, and where their values come from.
#[derive(Debug)]
pub struct Plan {
    columns: Vec<PlanColumn>,
    source: PlanSource,
}

#[derive(Debug)]
struct PlanColumn {
    name: String,
    /// As the header of a file gives it.
    unit: Option<String>,
    role: ColumnRole,
    /// Whether blanks around a cell count: of a text that may be any.
    keeps_blanks: bool,
}

/// What the cells of a column are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ColumnRole {
    /// Names of variants.
    Id,
    /// Values of a parameter of this kind.
    Parameter(&'static str),
}

#[derive(Debug)]
enum PlanSource {
    /// All combinations; the last parameter varies fastest.
    Grid(Vec<Vec<String>>),
    File(PlanFile),
}

/// One row of a plan.
#[derive(Clone, Debug)]
pub struct Variant {
    /// From 1, in the order of the plan.
    pub number: u64,
    /// What the plan calls it, or its number.
    pub id: Json,
    /// The parameters that it gives a value.
    pub settings: Vec<Setting>,
}

impl Plan {
    /// All combinations of values; that of a plan without any parameter is one variant.
    ///
    /// # Errors
    /// A parameter that varies twice, and grids that are too large.
    pub fn grid(varied: &[VariedParameter]) -> Result<Self, String> {
        for (idx, one) in varied.iter().enumerate() {
            if varied[..idx].iter().any(|earlier| earlier.name == one.name) {
                return Err(format!("`{}` varies twice", one.name));
            }
        }
        let mut counts = varied.iter().map(|one| one.values.len() as u64);
        let n_variants = counts.try_fold(1_u64, u64::checked_mul);
        if n_variants.is_none_or(|n| MOST_VARIANTS < n) {
            return Err(format!("the grid has more than {MOST_VARIANTS} variants"));
        }
        let column = |one: &VariedParameter| PlanColumn {
            name: one.name.clone(),
            unit: None,
            role: ColumnRole::Id,
            keeps_blanks: false,
        };
        Ok(Self {
            columns: varied.iter().map(column).collect(),
            source: PlanSource::Grid(varied.iter().map(|one| one.values.clone()).collect()),
        })
    }

    /// The rows of a CSV or Parquet file.
    ///
    /// # Errors
    /// What keeps its header from being read.
    pub fn file(path: &std::path::Path) -> Result<Self, String> {
        let (file, titles) = PlanFile::open(path)?;
        let column = |title: &String| {
            let (name, unit) = name_and_unit(title);
            PlanColumn {
                name: name.to_owned(),
                unit: unit.map(str::to_owned),
                role: ColumnRole::Id,
                keeps_blanks: false,
            }
        };
        Ok(Self { columns: titles.iter().map(column).collect(), source: PlanSource::File(file) })
    }

    /// Compares the plan with what the script takes, and reads all of it once; how many variants it has,
    /// and a sum that changes with it.
    ///
    /// # Errors
    /// The first mistake: a column that is no parameter, a unit that does not fit or is missing, a row
    /// that is too short.
    pub fn check(&mut self, schema: &Schema) -> Result<(u64, String), String> {
        let mut titles: Vec<String> = Vec::new();
        // As results have them where a parameter is called like the names of variants.
        let has_both = self.columns.iter().any(|column| column.name == format!("{ID}{PRIME}"));
        for column in &mut self.columns {
            if titles.contains(&column.name) {
                return Err(format!("two columns of the plan are called `{}`", column.name));
            }
            titles.push(column.name.clone());
            if has_both && column.name == ID {
                continue;
            }
            column.fit(schema)?;
        }
        let (mut n_variants, mut sum) = (0, Checksum::default());
        let has_ids = self.columns.iter().any(|column| column.role == ColumnRole::Id);
        let mut ids = HashSet::new();
        for row in self.rows() {
            let row = row?;
            n_variants += 1;
            // Of ids only sums are kept: a plan may be longer than memory.
            if has_ids {
                let (id, mut sum) = (self.variant(n_variants, &row).id, Checksum::default());
                sum.add(id.to_string().as_bytes());
                if !ids.insert(sum) {
                    return Err(format!(
                        "{}two variants are called {id}; an id names one, and where it is left out the number of the row does",
                        row.place
                    ));
                }
            }
            for (column, cell) in self.columns.iter().zip(&row.cells) {
                // With its length, so that no two rows are one; an empty text is not what is missing.
                let Some(cell) = cell else {
                    sum.add(b"-");
                    continue;
                };
                column.check(cell).map_err(|message| format!("{}{message}", row.place))?;
                sum.add(format!("{}:", cell.len()).as_bytes());
                sum.add(cell.as_bytes());
            }
            if MOST_VARIANTS < n_variants {
                return Err(format!("the plan has more than {MOST_VARIANTS} rows"));
            }
        }
        if n_variants == 0 {
            return Err("the plan has no rows: nothing is to be evaluated".to_owned());
        }
        for title in &titles {
            sum.add(title.as_bytes());
        }
        Ok((n_variants, sum.text()))
    }

    /// The variants in their order.
    pub fn variants(&self) -> impl Iterator<Item = Result<Variant, String>> {
        let rows = self.rows().enumerate();
        rows.map(|(i, row)| row.map(|row| self.variant(i as u64 + 1, &row)))
    }

    fn rows(&self) -> Box<dyn Iterator<Item = Result<PlanRow, String>> + Send + '_> {
        match &self.source {
            PlanSource::Grid(values) => Box::new(
                combinations(values).map(|cells| Ok(PlanRow { place: String::new(), cells })),
            ),
            PlanSource::File(file) => file.rows(),
        }
    }

    fn variant(&self, number: u64, row: &PlanRow) -> Variant {
        let (mut id, mut settings) = (Json::from(number), Vec::new());
        for (column, cell) in self.columns.iter().zip(&row.cells) {
            let Some(cell) = cell else { continue };
            // A text is what stands there, blanks and all, unless it is one of a list.
            let is_text = column.role == ColumnRole::Parameter(TEXT);
            let cell = if column.keeps_blanks { cell } else { cell.trim() };
            match column.role {
                _ if cell.is_empty() && !is_text => {}
                ColumnRole::Id => {
                    // Whole numbers stay numbers, unless they would lose a zero in front.
                    let whole = cell.parse::<i64>().ok().filter(|n| n.to_string() == cell);
                    id = whole.map_or_else(|| Json::from(cell), Json::from);
                }
                ColumnRole::Parameter(kind) => {
                    let text = column.setting(kind, cell);
                    let called = format!("{}={text}", column.name);
                    settings.push(Setting { name: column.name.clone(), text, called });
                }
            }
        }
        Variant { number, id, settings }
    }
}

impl PlanColumn {
    /// Finds the parameter, and whether the unit suits it.
    fn fit(&mut self, schema: &Schema) -> Result<(), String> {
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
            return Err(unknown(name, &schema.parameters));
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

    /// What is wrong with a cell wherever it stands; a value that the script refuses is a result.
    fn check(&self, cell: &str) -> Result<(), String> {
        let is_bare = cell.trim().parse::<f64>().is_ok();
        if self.role == ColumnRole::Parameter("angle") && self.unit.is_none() && is_bare {
            let name = &self.name;
            return Err(format!(
                "`{name}` is an angle, and {} has no unit: call the column `{name} [deg]`, or write `{}deg`",
                cell.trim(),
                cell.trim()
            ));
        }
        Ok(())
    }

    /// A cell as a setting of a parameter of a kind.
    fn setting(&self, kind: &str, cell: &str) -> String {
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

fn unknown(name: &str, parameters: &[SchemaParameter]) -> String {
    let names: Vec<&str> = parameters.iter().map(|parameter| parameter.name.as_str()).collect();
    match (nearest(name, names.iter().copied()), &names[..]) {
        (Some(near), _) => {
            format!("the script has no parameter `{name}`; did you mean `{near}`?")
        }
        (None, []) => format!("the script has no parameter `{name}`, nor any other"),
        (None, _) => {
            format!("the script has no parameter `{name}`; it has {}", names.join(", "))
        }
    }
}

/// `x [mm]` is `x` in `mm`.
fn name_and_unit(title: &str) -> (&str, Option<&str>) {
    let title = title.trim();
    match title.strip_suffix(']').and_then(|title| title.rsplit_once('[')) {
        Some((name, unit)) if !unit.trim().is_empty() => (name.trim(), Some(unit.trim())),
        _ => (title, None),
    }
}

/// All combinations; the last list runs fastest.
fn combinations(values: &[Vec<String>]) -> impl Iterator<Item = Vec<Option<String>>> + Send + '_ {
    let n_all: u64 = values.iter().map(|list| list.len() as u64).product();
    (0..n_all).map(move |number| {
        let mut left = number;
        let mut cells: Vec<Option<String>> = Vec::with_capacity(values.len());
        for list in values.iter().rev() {
            cells.push(list.get((left % list.len() as u64) as usize).cloned());
            left /= list.len() as u64;
        }
        cells.reverse();
        cells
    })
}

#[cfg(test)]
mod tests {
    use super::{Plan, VariedParameter, combinations};

    #[test]
    fn the_last_parameter_varies_fastest() {
        let values = [vec!["1".to_owned(), "2".to_owned()], vec!["a".to_owned(), "b".to_owned()]];
        let all: Vec<String> =
            combinations(&values).map(|cells| cells.into_iter().flatten().collect()).collect();
        assert_eq!(all, ["1a", "1b", "2a", "2b"]);
    }

    #[test]
    fn grids_without_end_are_refused() {
        let one = |name: &str| VariedParameter {
            name: name.to_owned(),
            values: vec![String::new(); 10_000],
        };
        let all: Vec<VariedParameter> = ["a", "b", "c", "d", "e"].map(one).into();
        assert!(Plan::grid(&all[..2]).is_ok());
        let err = Plan::grid(&all).err().unwrap_or_default();
        assert!(err.contains("more than 1000000000 variants"), "{err}");
    }
}
