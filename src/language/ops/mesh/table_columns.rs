//! `table` of a record of columns.

use std::sync::Arc;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{NamedColumn, Table},
    value::{
        At, BARE_AND_ANGLE, CARRIES_DERIVATIVES, CommonDimension, Ctx, Number, Record, Value, op,
    },
};

op! {
    /// Table of named columns, each a list of numbers or of strings, all of one length.
    ///
    /// A column of points becomes three, `name_x`, `name_y` and `name_z`. The unit of lengths and
    /// angles, the document's and `rad`, goes along into files.
    table in Table -> Table {
        /// The columns: `{x: [0, 1], y: [2, 3]}`.
        columns: Spanned<Arc<Record>>,
    }
    example "table({x: [0, 1], y: [2, 3]}).y" => "[2, 3]";
    refuses "table({x: [1mm, 30deg]})" => "E0301: column `x` holds numbers, strings or points, but of one kind; found a length beside an angle";
    refuses "table({x: [30deg, 45]})" => "E0303: column `x` holds an angle beside a number without a unit";
    refuses "table({x: 1})" => "E0301: column `x` must be a list, found the number 1";
    refuses "table({x: [0, 1], y: [2]})" => "E0301: column \"y\" has 1 row, the first has 2";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Table> {
    let span = args.columns.span;
    let mut columns = Vec::new();
    for (name, value) in args.columns.value.iter() {
        let Value::List(items) = value else {
            let message = format!("column `{name}` must be a list, found {}", value.phrase());
            return Diagnostic::error(Code::WrongKind, span, message).fail();
        };
        columns.extend(columns_of(name, items, ctx.unit, span)?);
    }
    Table::new(columns).at(span)
}

/// The columns that a list of cells makes.
///
/// # Errors
/// Cells of other kinds, or of several; cells that carry derivatives.
pub(super) fn columns_of(
    name: &str,
    items: &[Value],
    unit: &str,
    span: Span,
) -> Result<Vec<NamedColumn>> {
    if items.iter().any(Value::is_jet) {
        let message = "no derivative passes through a table, and derivatives are wanted";
        return Diagnostic::error(Code::NoDerivative, span, message)
            .hint(CARRIES_DERIVATIVES)
            .fail();
    }
    of_one_kind(name, items, unit).map_err(|odd| {
        Box::new(match odd {
            ColumnFault::Cell(found) => {
                let message = format!(
                    "column `{name}` holds numbers, strings or points, but of one kind; found {found}"
                );
                Diagnostic::error(Code::WrongKind, span, message)
            }
            ColumnFault::BareAngle(found) => {
                let message = format!("column `{name}` holds {found}");
                Diagnostic::error(Code::UnitMismatch, span, message).hint(BARE_AND_ANGLE)
            }
        })
    })
}

/// Why cells make no column.
enum ColumnFault {
    /// A cell, or two, in words.
    Cell(String),
    /// A number without a unit and an angle, in words.
    BareAngle(String),
}

/// The columns of cells of one kind; else the cell that does not fit.
fn of_one_kind(
    name: &str,
    items: &[Value],
    unit: &str,
) -> std::result::Result<Vec<NamedColumn>, ColumnFault> {
    let odd = |wanted: &str| {
        let found = items.iter().find(|item| item.kind() != wanted);
        ColumnFault::Cell(found.map_or_else(String::new, Value::phrase))
    };
    let numbers: Option<Vec<Number>> = items
        .iter()
        .map(|item| match item {
            Value::Number(number) => Some(*number),
            _ => None,
        })
        .collect();
    if let Some(numbers) = numbers {
        return numbers_column(name, &numbers, unit).map(|column| vec![column]);
    }
    match items.first() {
        Some(Value::Text(_)) => {
            let texts: Option<Vec<String>> = items
                .iter()
                .map(|item| match item {
                    Value::Text(text) => Some(text.to_string()),
                    _ => None,
                })
                .collect();
            let values = texts.ok_or_else(|| odd("string"))?;
            Ok(vec![NamedColumn::texts(name, values)])
        }
        Some(Value::Point(_)) => {
            let points: Option<Vec<glam::DVec3>> = items
                .iter()
                .map(|item| match item {
                    Value::Point(point) => Some(*point),
                    _ => None,
                })
                .collect();
            let points = points.ok_or_else(|| odd("point"))?;
            let axis = |letter: char, idx: usize| {
                NamedColumn::numbers(
                    format!("{name}_{letter}"),
                    points.iter().map(|point| point[idx]).collect(),
                )
            };
            Ok(vec![axis('x', 0), axis('y', 1), axis('z', 2)])
        }
        Some(Value::Number(_)) => Err(odd("number")),
        Some(other) => Err(ColumnFault::Cell(other.phrase())),
        None => Ok(vec![NamedColumn::numbers(name, Vec::new())]),
    }
}

/// A column of numbers of one dimension; else the two that do not fit.
fn numbers_column(
    name: &str,
    numbers: &[Number],
    unit: &str,
) -> std::result::Result<NamedColumn, ColumnFault> {
    let mut common = CommonDimension::default();
    for &number in numbers {
        common.take(number).map_err(|[a, b]| {
            let odd =
                if a.is_bare() || b.is_bare() { ColumnFault::BareAngle } else { ColumnFault::Cell };
            odd(format!("{a} beside {b}"))
        })?;
    }
    let dim = common.dimension();
    let column = NamedColumn::numbers(name, numbers.iter().map(|number| number.value).collect());
    Ok(match dim.unit(unit) {
        Some(unit) => column.with_unit(unit),
        None => column,
    })
}
