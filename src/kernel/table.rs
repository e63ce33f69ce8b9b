//! Tables: named columns of one length.

use std::collections::HashSet;

use super::{CountError, GeomError};

/// The cells of one column.
///
/// ```
/// use virote_kernel::Column;
///
/// // Cells that are not finite are empty, and empty cells are equal.
/// assert_eq!(Column::Numbers(vec![1.0, f64::NAN]), Column::Numbers(vec![1.0, f64::INFINITY]));
/// assert_eq!(Column::Texts(vec!["a".to_owned()]).len(), 1);
/// ```
#[derive(Clone, Debug)]
pub enum Column {
    /// Numbers; a cell that is not finite is empty.
    Numbers(Vec<f64>),
    /// Any text.
    Texts(Vec<String>),
}

/// Empty cells are equal.
impl PartialEq for Column {
    fn eq(&self, other: &Self) -> bool {
        let same = |(a, b): (&f64, &f64)| a == b || !(a.is_finite() || b.is_finite());
        match (self, other) {
            (Self::Numbers(a), Self::Numbers(b)) => a.len() == b.len() && a.iter().zip(b).all(same),
            (Self::Texts(a), Self::Texts(b)) => a == b,
            _ => false,
        }
    }
}

impl Column {
    /// How many rows.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::Numbers(numbers) => numbers.len(),
            Self::Texts(texts) => texts.len(),
        }
    }

    /// Whether there are no rows.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// A column: its name, its unit where it has one, its cells.
///
/// ```
/// use virote_kernel::NamedColumn;
///
/// let lengths = NamedColumn::numbers("length", vec![1.5, 2.5]).with_unit("mm");
/// assert_eq!((lengths.column.len(), lengths.unit.as_deref()), (2, Some("mm")));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct NamedColumn {
    /// Name, unique within its table.
    pub name: String,
    /// Unit of the numbers, as text for the reader.
    pub unit: Option<String>,
    /// One cell a row.
    pub column: Column,
}

impl NamedColumn {
    /// A column of numbers without a unit.
    #[must_use]
    pub fn numbers(name: impl Into<String>, numbers: Vec<f64>) -> Self {
        Self { name: name.into(), unit: None, column: Column::Numbers(numbers) }
    }

    /// A column of texts.
    #[must_use]
    pub fn texts(name: impl Into<String>, texts: Vec<String>) -> Self {
        Self { name: name.into(), unit: None, column: Column::Texts(texts) }
    }

    /// The same column with a unit.
    #[must_use]
    pub fn with_unit(self, unit: impl Into<String>) -> Self {
        Self { unit: Some(unit.into()), ..self }
    }
}

/// Named columns. Invariants: all of one length, no name twice.
///
/// ```
/// use virote_kernel::{Column, NamedColumn, Table};
///
/// let table = Table::new(vec![
///     NamedColumn::texts("part", vec!["hull".to_owned(), "keel".to_owned()]),
///     NamedColumn::numbers("mass", vec![12.0, 3.0]),
/// ])?;
/// assert_eq!(table.n_rows(), 2);
/// assert_eq!(table.column("mass"), Some(&Column::Numbers(vec![12.0, 3.0])));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Table {
    columns: Vec<NamedColumn>,
}

impl Table {
    /// The table of the columns in their order; without columns it has no rows.
    ///
    /// # Errors
    /// [`CountError::ColumnLength`], [`CountError::DuplicateColumn`].
    pub fn new(columns: Vec<NamedColumn>) -> Result<Self, GeomError> {
        let expected = columns.first().map_or(0, |column| column.column.len());
        let mut names: HashSet<&str> = HashSet::with_capacity(columns.len());
        for column in &columns {
            let got = column.column.len();
            let name = || column.name.clone();
            if got != expected {
                return Err(CountError::ColumnLength { name: name(), got, expected }.into());
            }
            if !names.insert(column.name.as_str()) {
                return Err(CountError::DuplicateColumn { name: name() }.into());
            }
        }
        Ok(Self { columns })
    }

    /// How many rows.
    #[must_use]
    pub fn n_rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.column.len())
    }

    /// The columns in their order.
    #[must_use]
    pub fn columns(&self) -> &[NamedColumn] {
        &self.columns
    }

    /// The cells of the column of that name.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.name == name).map(|found| &found.column)
    }
}
