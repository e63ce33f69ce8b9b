//! A rectangular array: the control net of a surface, points over a grid of parameters.

use super::{CountError, GeomError};

/// `n_rows` × `n_columns` values in row-major order; row `i` runs along u, column `j` along v.
///
/// Invariant: every row has `n_columns` values.
///
/// ```
/// use virote_kernel::Grid;
///
/// let table = Grid::from_fn(2, 3, |i, j| 10 * i + j);
/// assert_eq!(table.get(1, 2), 12);
/// assert_eq!(table.row(1), [10, 11, 12]);
/// assert_eq!(table.transposed().row(2), [2, 12]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Grid<T> {
    n_rows: usize,
    n_columns: usize,
    values: Vec<T>,
}

impl<T> Grid<T> {
    /// The values laid out row after row.
    ///
    /// # Errors
    /// [`CountError::GridSize`] unless there are `n_rows * n_columns` of them.
    pub fn new(n_rows: usize, n_columns: usize, values: Vec<T>) -> Result<Self, GeomError> {
        let needed = n_rows.saturating_mul(n_columns);
        if values.len() == needed {
            Ok(Self { n_rows, n_columns, values })
        } else {
            let got = values.len();
            Err(GeomError::Count(CountError::GridSize {
                rows: n_rows,
                columns: n_columns,
                needed,
                got,
            }))
        }
    }

    /// The rows under one another.
    ///
    /// # Errors
    /// [`CountError::RaggedGrid`] for the first row that is not as long as row 0.
    pub fn from_rows(rows: Vec<Vec<T>>) -> Result<Self, GeomError> {
        let n_rows = rows.len();
        let n_columns = rows.first().map_or(0, Vec::len);
        if let Some((row, got)) =
            rows.iter().map(Vec::len).enumerate().find(|&(_, length)| length != n_columns)
        {
            return Err(CountError::RaggedGrid { row, got, expected: n_columns }.into());
        }
        Ok(Self { n_rows, n_columns, values: rows.into_iter().flatten().collect() })
    }

    /// The value of `f(i, j)` at every place.
    #[must_use]
    pub fn from_fn(n_rows: usize, n_columns: usize, mut f: impl FnMut(usize, usize) -> T) -> Self {
        let mut values = Vec::with_capacity(n_rows * n_columns);
        for i in 0..n_rows {
            values.extend((0..n_columns).map(|j| f(i, j)));
        }
        Self { n_rows, n_columns, values }
    }

    /// Whole rows of a known width laid out row after row.
    pub(crate) fn from_rows_of(n_columns: usize, values: Vec<T>) -> Self {
        let n_rows = values.len().checked_div(n_columns).unwrap_or(0);
        Self { n_rows, n_columns, values }
    }

    /// The values, row after row.
    #[must_use]
    pub fn into_values(self) -> Vec<T> {
        self.values
    }

    /// How many rows: values along u.
    #[must_use]
    pub fn n_rows(&self) -> usize {
        self.n_rows
    }

    /// How many columns: values along v.
    #[must_use]
    pub fn n_columns(&self) -> usize {
        self.n_columns
    }

    /// Row `i`, the values along v at one place along u.
    #[inline]
    #[must_use]
    pub fn row(&self, i: usize) -> &[T] {
        &self.values[i * self.n_columns..][..self.n_columns]
    }

    /// All values, row after row.
    #[must_use]
    pub fn as_slice(&self) -> &[T] {
        &self.values
    }

    /// The values, row after row.
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.values.iter()
    }

    /// The grid of `f(value)`.
    #[must_use]
    pub fn map<U>(&self, f: impl FnMut(&T) -> U) -> Grid<U> {
        let values = self.values.iter().map(f).collect();
        Grid { n_rows: self.n_rows, n_columns: self.n_columns, values }
    }
}

impl<T: Copy> Grid<T> {
    /// The value in row `i` and column `j`.
    #[inline]
    #[must_use]
    pub fn get(&self, i: usize, j: usize) -> T {
        self.row(i)[j]
    }

    /// Column `j`, the values along u at one place along v.
    #[must_use]
    pub fn column(&self, j: usize) -> Vec<T> {
        (0..self.n_rows).map(|i| self.get(i, j)).collect()
    }

    /// Rows and columns exchanged.
    #[must_use]
    pub fn transposed(&self) -> Self {
        Self::from_fn(self.n_columns, self.n_rows, |i, j| self.get(j, i))
    }
}

impl<'a, T> IntoIterator for &'a Grid<T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}
