//! `unique`: each element once.

use std::collections::BTreeSet;

use crate::{
    diag::Result,
    value::{Ctx, List, Value, equal, op},
};

op! {
    /// The elements without those that are equal to an earlier one.
    unique in List -> Vec<Value> {
        /// The list; a range of whole numbers counts as one.
        list: List,
    }
    example "unique([1, 2, 1, 3, 2])" => "[1, 2, 3]";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vec<Value>> {
    let (mut seen, mut others) = (BTreeSet::new(), Vec::<Value>::new());
    let mut is_new = |item: &Value| match plain_text(item) {
        Some(text) => seen.insert(text),
        None => {
            let is_new = !others.iter().any(|known| equal(known, item) == Some(true));
            if is_new {
                others.push(item.clone());
            }
            is_new
        }
    };
    Ok(args.list.iter().filter(|item| is_new(item)).cloned().collect())
}

/// Text that equal values have in common and others do not, where there is one.
fn plain_text(value: &Value) -> Option<String> {
    match value {
        Value::Number(number) if number.dim.is_none() => Some(value.to_string()),
        Value::Text(_) | Value::Bool(_) | Value::Point(_) => Some(value.to_string()),
        _ => None,
    }
}
