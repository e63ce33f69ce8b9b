//! `table` of a list of records.

use std::sync::Arc;

use super::table_columns::columns_of;
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::Table,
    value::{At, AtLeast, Ctx, Record, Value, op},
};

op! {
    /// Table of records, a row each; all have the labels of the first.
    table in Table -> Table {
        /// The rows: `[{x: 0, y: 2}, {x: 1, y: 3}]`.
        rows: Spanned<AtLeast<1, Arc<Record>>>,
    }
    example "table([for i in 1..3: {i, square: i^2}]).square" => "[1, 4, 9]";
    refuses "table([{x: 0, y: 2}, {x: 1}])" => "E0301: row 1 has the labels x, row 0 has x, y";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Table> {
    let span = args.rows.span;
    let AtLeast(rows) = &args.rows.value;
    let labels: Vec<&str> = rows[0].iter().map(|(label, _)| label).collect();
    if let Some(i) =
        rows.iter().position(|row| !row.iter().map(|(label, _)| label).eq(labels.iter().copied()))
    {
        let found: Vec<&str> = rows[i].iter().map(|(label, _)| label).collect();
        let message =
            format!("row {i} has the labels {}, row 0 has {}", found.join(", "), labels.join(", "));
        return Diagnostic::error(Code::WrongKind, span, message)
            .hint("every row needs the same labels in the same order")
            .fail();
    }
    let mut columns = Vec::new();
    for label in labels {
        let cells: Vec<Value> = rows.iter().filter_map(|row| row.get(label).cloned()).collect();
        columns.extend(columns_of(label, &cells, ctx.unit, span)?);
    }
    Table::new(columns).at(span)
}
