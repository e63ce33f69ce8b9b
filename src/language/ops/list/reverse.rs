//! `reverse`: the list backwards.

use crate::{
    diag::Result,
    value::{Ctx, List, Value, op},
};

op! {
    /// The same elements from the last to the first.
    reverse in List -> Vec<Value> {
        /// The list; a range of whole numbers counts as one.
        list: List,
    }
    example "reverse([1, 2, 3])" => "[3, 2, 1]";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vec<Value>> {
    Ok(args.list.iter().rev().cloned().collect())
}
