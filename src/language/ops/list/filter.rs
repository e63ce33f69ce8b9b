//! `filter`: the elements that pass a test.

use super::truth;
use crate::{
    diag::Result,
    value::{Callback, Ctx, List, Value, op},
};

op! {
    /// List of the elements of which `f` is true, in their order.
    filter in List -> Vec<Value> {
        /// The list; a range of whole numbers counts as one.
        list: List,
        /// The test.
        f: Callback,
    }
    example "filter(1..6, n => n % 2 == 0)" => "[2, 4, 6]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Value>> {
    let mut kept = Vec::new();
    for item in args.list.iter() {
        if truth(ctx, &args.f, item)? {
            kept.push(item.clone());
        }
    }
    Ok(kept)
}
