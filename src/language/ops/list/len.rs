//! `len`: how many elements.

use crate::{
    diag::{Code, Diagnostic, Result},
    value::{Ctx, Range, Value, op},
};

op! {
    /// How many elements a list has, how many rows a table, or how many characters a string.
    len in List -> usize {
        /// A list, range of whole numbers, table or string.
        of: Value,
    }
    example "len([1, 2, 3])" => "3";
    example "len(\"größe\")" => "5";
    refuses "len(3)" => "E0301: `len` takes a list, a table or a string, found the number 3";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<usize> {
    match &args.of {
        Value::List(items) => Ok(items.len()),
        Value::Table(table) => Ok(table.n_rows()),
        Value::Text(text) => Ok(text.chars().count()),
        Value::Range(Range { start, end, .. })
            if start.as_integer().is_some() && end.as_integer().is_some() =>
        {
            Ok(args.of_range())
        }
        other => {
            let message =
                format!("`len` takes a list, a table or a string, found {}", other.phrase());
            Diagnostic::error(Code::WrongKind, ctx.span, message).fail()
        }
    }
}

impl Args {
    /// Elements of a range of whole numbers.
    fn of_range(&self) -> usize {
        match &self.of {
            Value::Range(range) => range.integers().map_or(0, |(_, count)| count),
            _ => 0,
        }
    }
}
