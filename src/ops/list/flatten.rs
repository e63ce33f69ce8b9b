//! `flatten`: one list of several.

use crate::{
    diag::Result,
    value::{Ctx, List, Value, op},
};

op! {
    /// The elements of the lists in a list, one level down; other elements stay.
    flatten in List -> Vec<Value> {
        /// The list; a range of whole numbers counts as one.
        list: List,
    }
    example "flatten([[1, 2], [3], 4])" => "[1, 2, 3, 4]";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vec<Value>> {
    let mut flat = Vec::new();
    for item in args.list.iter() {
        match item {
            Value::List(inner) => flat.extend(inner.iter().cloned()),
            other => flat.push(other.clone()),
        }
    }
    Ok(flat)
}
