//! `flatten`: one list of several.

use super::check_length;
use crate::{
    diag::Result,
    value::{Ctx, List, Maybe, Value, op},
};

op! {
    /// The elements of the lists in a list, one level down or more; other elements stay.
    flatten in List -> Vec<Value> {
        /// The list; a range of whole numbers counts as one.
        list: List,
        /// How many levels down.
        depth: Maybe<usize>,
    }
    example "flatten([[1, 2], [3], 4])" => "[1, 2, 3, 4]";
    example "flatten([[[1], 2], [3]], 2)" => "[1, 2, 3]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Value>> {
    let mut flat: Vec<Value> = args.list.iter().cloned().collect();
    for _ in 0..args.depth.0.unwrap_or(1) {
        if !flat.iter().any(|item| matches!(item, Value::List(_))) {
            break;
        }
        let mut flatter = Vec::with_capacity(flat.len());
        for item in &flat {
            match item {
                Value::List(inner) => flatter.extend(inner.iter().cloned()),
                other => flatter.push(other.clone()),
            }
            check_length(flatter.len() as f64, ctx)?;
        }
        flat = flatter;
    }
    Ok(flat)
}
