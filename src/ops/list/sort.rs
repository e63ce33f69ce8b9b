//! `sort`: the list in order.

use std::cmp::Ordering;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    value::{Callback, Ctx, List, Value, op},
};

op! {
    /// The same numbers, or strings, in ascending order; equal ones keep their order.
    sort in List -> Vec<Value> {
        /// Numbers of one dimension, or strings.
        list: Spanned<List>,
        /// A function whose value decides the order, instead of the element itself.
        by: Option<Callback>,
    }
    example "sort([3, 1, 2])" => "[1, 2, 3]";
    example "sort([(1, 5), (2, 3)], by = p => p.y)" => "[(2, 3, 0), (1, 5, 0)]";
    refuses "sort([1, \"a\"])" => "E0301: the number 1 and the string \"a\" have no order";
    refuses "sort([(1, 5), (2, 3)])" => "E0301: a point and a point have no order";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Value>> {
    let items = &args.list.value;
    let keys: Vec<Value> = match &args.by {
        Some(by) => {
            let keys = items.iter().map(|item| ctx.call(by, std::slice::from_ref(item)));
            keys.collect::<Result<_>>()?
        }
        None => items.to_vec(),
    };
    let mut places: Vec<usize> = (0..items.len()).collect();
    for pair in keys.windows(2) {
        if ordering(&pair[0], &pair[1]).is_none() {
            let message = format!("{} and {} have no order", pair[0].phrase(), pair[1].phrase());
            return Diagnostic::error(Code::WrongKind, args.list.span, message)
                .hint("numbers of one dimension can be sorted, and strings; else give `by = x => ...`")
                .fail();
        }
    }
    places.sort_by(|&a, &b| ordering(&keys[a], &keys[b]).unwrap_or(Ordering::Equal));
    Ok(places.into_iter().map(|place| items[place].clone()).collect())
}

/// The order of two numbers or two strings.
fn ordering(a: &Value, b: &Value) -> Option<Ordering> {
    match (a, b) {
        (Value::Jet(_), _) | (_, Value::Jet(_)) => ordering(&a.looked_at(), &b.looked_at()),
        (Value::Number(a), Value::Number(b)) => {
            a.dim.common(b.dim)?;
            a.value.partial_cmp(&b.value)
        }
        (Value::Text(a), Value::Text(b)) => Some(a.cmp(b)),
        _ => None,
    }
}
