//! The plan of a study: which parameters vary, and the values that each variant gives them.

use std::{
    collections::HashSet,
    sync::atomic::{AtomicBool, Ordering},
};

use serde_json::Value as Json;

use super::{
    checksum::Checksum,
    plan_column::{ColumnRole, ID, PRIME, PlanColumn, TEXT},
    plan_file::{PlanFile, PlanRow},
    vary::{VariedParameter, VariedValues, combinations},
};
use crate::eval::{Schema, Setting};

/// Variants of one study; beyond it nobody waits for the end.
const MOST_VARIANTS: u64 = 1_000_000_000;

/// What is told of a study that somebody ended.
pub const STOPPED: &str = "the study was stopped";

/// Which parameters vary, and where their values come from.
#[derive(Debug)]
pub struct Plan {
    columns: Vec<PlanColumn>,
    source: PlanSource,
    /// How many rows there were when they were read first, and their sum.
    read: Option<(u64, Checksum)>,
    /// Whether they were others when they were read again.
    is_changed: AtomicBool,
}

#[derive(Debug)]
enum PlanSource {
    /// All combinations; the last parameter varies fastest.
    Grid(Vec<VariedValues>),
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
        let mut counts = varied.iter().map(|one| one.values.count());
        let n_variants = counts.try_fold(1_u64, u64::checked_mul);
        if n_variants.is_none_or(|n| MOST_VARIANTS < n) {
            return Err(format!("the grid has more than {MOST_VARIANTS} variants"));
        }
        Ok(Self {
            columns: varied.iter().map(|one| PlanColumn::new(&one.name)).collect(),
            source: PlanSource::Grid(varied.iter().map(|one| one.values.clone()).collect()),
            read: None,
            is_changed: AtomicBool::new(false),
        })
    }

    /// The rows of a CSV or Parquet file.
    ///
    /// # Errors
    /// What keeps its header from being read.
    pub fn file(path: &std::path::Path) -> Result<Self, String> {
        let file = PlanFile::open(path)?;
        let columns = file.titles().iter().map(|title| PlanColumn::titled(title)).collect();
        let (source, is_changed) = (PlanSource::File(file), AtomicBool::new(false));
        Ok(Self { columns, source, read: None, is_changed })
    }

    /// Compares the plan with what the script takes, and reads all of it once; how many variants it has,
    /// and a sum that changes with it. `each` is told how many rows are read, and whether to go on.
    ///
    /// # Errors
    /// The first mistake: a column that is no parameter, a unit that does not fit or is missing, a row
    /// that is too short; that `each` ended it.
    pub fn check(
        &mut self,
        schema: &Schema,
        each: &mut dyn FnMut(u64) -> bool,
    ) -> Result<(u64, String), String> {
        self.fit(schema)?;
        let has_ids = self.columns.iter().any(|column| column.role == ColumnRole::Id);
        let (n_variants, mut sum) = match &self.source {
            PlanSource::Grid(values) if !has_ids => self.check_grid(values)?,
            _ => self.check_rows(has_ids, each)?,
        };
        if n_variants == 0 {
            return Err("the plan has no rows: nothing is to be evaluated".to_owned());
        }
        for column in &self.columns {
            column.add_to(&mut sum);
        }
        Ok((n_variants, sum.text()))
    }

    /// Compares the columns with the parameters.
    fn fit(&mut self, schema: &Schema) -> Result<(), String> {
        let mut titles: Vec<String> = Vec::new();
        // As results have them where a parameter is called like the names of variants.
        let has_both = self.columns.iter().any(|column| column.name == format!("{ID}{PRIME}"));
        for column in &mut self.columns {
            if titles.contains(&column.name) {
                return Err(format!("two columns of the plan are called `{}`", column.name));
            }
            titles.push(column.name.clone());
            if !has_both || column.name != ID {
                column.fit(schema)?;
            }
        }
        Ok(())
    }

    /// Looks at values and not at their combinations, of which there may be very many.
    fn check_grid(&self, values: &[VariedValues]) -> Result<(u64, Checksum), String> {
        let mut sum = Checksum::default();
        for (column, values) in self.columns.iter().zip(values) {
            values.kinds().try_for_each(|cell| column.check(&cell))?;
            values.add_to(&mut sum);
        }
        Ok((values.iter().map(VariedValues::count).product(), sum))
    }

    fn check_rows(
        &mut self,
        has_ids: bool,
        each: &mut dyn FnMut(u64) -> bool,
    ) -> Result<(u64, Checksum), String> {
        let (mut n_variants, mut sum) = (0, Checksum::default());
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
                let checked = cell.as_ref().map_or(Ok(()), |cell| column.check(cell));
                checked.map_err(|message| format!("{}{message}", row.place))?;
            }
            add_row(&row, &mut sum);
            if MOST_VARIANTS < n_variants {
                return Err(format!("the plan has more than {MOST_VARIANTS} rows"));
            }
            if !each(n_variants) {
                return Err(STOPPED.to_owned());
            }
        }
        self.read = Some((n_variants, sum));
        Ok((n_variants, sum))
    }

    /// The variants in their order. In the place of the last one stands that the plan was changed, where it was
    /// since it was checked.
    pub fn variants(&self) -> impl Iterator<Item = Result<Variant, String>> + Send {
        let mut rows = self.rows();
        let (mut number, mut sum) = (0, Checksum::default());
        std::iter::from_fn(move || {
            let row = rows.next();
            let Some((n_read, sum_read)) = self.read else {
                number += 1;
                return row.map(|row| row.map(|row| self.variant(number, &row)));
            };
            if number == n_read {
                return None;
            }
            let changed = |why: &str| {
                self.is_changed.store(true, Ordering::Relaxed);
                Err(format!("the plan was changed while the study ran{why}"))
            };
            let row = match row {
                Some(Ok(row)) => row,
                Some(Err(message)) => return Some(changed(&format!(": {message}"))),
                None => return Some(changed(&format!(": it had {n_read} rows, and has {number}"))),
            };
            number += 1;
            add_row(&row, &mut sum);
            let is_changed = number == n_read && sum != sum_read;
            Some(if is_changed { changed("") } else { Ok(self.variant(number, &row)) })
        })
    }

    /// Whether the plan was changed since it was checked, as far as it was read again: variants may have been of
    /// either.
    #[must_use]
    pub fn was_changed(&self) -> bool {
        self.is_changed.load(Ordering::Relaxed)
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

/// Adds the cells of a row to a sum.
fn add_row(row: &PlanRow, sum: &mut Checksum) {
    for cell in &row.cells {
        // An empty text is not what is missing.
        match cell {
            None => sum.add(b"-"),
            Some(cell) => sum.add_text(cell),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Plan, VariedParameter, VariedValues};

    #[test]
    fn grids_without_end_are_refused() {
        let one = |name: &str| VariedParameter {
            name: name.to_owned(),
            values: VariedValues::List(vec![String::new(); 10_000]),
        };
        let all: Vec<VariedParameter> = ["a", "b", "c", "d", "e"].map(one).into();
        assert!(Plan::grid(&all[..2]).is_ok());
        let err = Plan::grid(&all).err().unwrap_or_default();
        assert!(err.contains("more than 1000000000 variants"), "{err}");
    }
}
