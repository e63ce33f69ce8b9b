//! `transpose`: rows to columns.

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    value::{Ctx, List, Value, op},
};

op! {
    /// The columns of a list of rows of one length.
    transpose in List -> Vec<Value> {
        /// The rows.
        rows: Spanned<Vec<List>>,
    }
    example "transpose([[1, 2, 3], [4, 5, 6]])" => "[[1, 4], [2, 5], [3, 6]]";
    refuses "transpose([[1, 2], [3]])" => "E0605: row 1 has 1 element, row 0 has 2; every row needs the same number";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vec<Value>> {
    let rows = &args.rows.value;
    let n_columns = rows.first().map_or(0, List::len);
    if let Some(i) = rows.iter().position(|row| row.len() != n_columns) {
        let message = format!(
            "row {i} has {} {}, row 0 has {n_columns}; every row needs the same number",
            rows[i].len(),
            if rows[i].len() == 1 { "element" } else { "elements" }
        );
        return Diagnostic::error(Code::RaggedGrid, args.rows.span, message).fail();
    }
    let column = |j: usize| Value::list(rows.iter().map(|row| row[j].clone()).collect());
    Ok((0..n_columns).map(column).collect())
}
