//! Vectors by some of several variables, as many by each.

/// Vectors by variables, one row for each of them.
#[derive(Clone, Debug)]
pub(super) struct VariableRows<T> {
    variables: Vec<usize>,
    n_columns: usize,
    vectors: Vec<T>,
}

impl<T: Copy> VariableRows<T> {
    /// Rows of so many, none yet.
    pub(super) fn new(n_columns: usize) -> Self {
        Self { variables: Vec::new(), n_columns, vectors: Vec::new() }
    }

    /// Rows by some variables, filled with one vector.
    pub(super) fn filled(variables: Vec<usize>, n_columns: usize, vector: T) -> Self {
        let vectors = vec![vector; variables.len() * n_columns];
        Self { variables, n_columns, vectors }
    }

    /// The row of a variable behind all others, to be filled.
    pub(super) fn push(&mut self, variable: usize, vector: T) -> &mut [T] {
        let from = self.vectors.len();
        self.variables.push(variable);
        self.vectors.resize(from + self.n_columns, vector);
        &mut self.vectors[from..]
    }

    /// Each row, with its variable.
    pub(super) fn rows(&self) -> impl Iterator<Item = (usize, &[T])> + Clone {
        self.variables.iter().copied().zip(self.vectors.chunks_exact(self.n_columns))
    }

    /// Each row.
    pub(super) fn rows_mut(&mut self) -> impl Iterator<Item = &mut [T]> {
        self.vectors.chunks_exact_mut(self.n_columns)
    }

    /// The vectors of a column, each with its variable.
    pub(super) fn column(&self, k: usize) -> impl Iterator<Item = (usize, T)> + Clone {
        self.rows().map(move |(variable, row)| (variable, row[k]))
    }

    /// All of them.
    pub(super) fn vectors(&self) -> &[T] {
        &self.vectors
    }

    /// The row of a variable; none where it has none.
    pub(super) fn row_of(&self, variable: usize) -> Option<&[T]> {
        self.rows().find(|(own, _)| *own == variable).map(|(_, row)| row)
    }
}
