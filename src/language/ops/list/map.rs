//! `map`: a function of each element.

use crate::{
    diag::Result,
    value::{Callback, Ctx, List, Value, op},
};

op! {
    /// List of what `f` makes of each element.
    map in List -> Vec<Value> {
        /// The list; a range of whole numbers counts as one.
        list: List,
        /// The function; a curve or surface is one too.
        f: Callback,
    }
    example "map([1, 2, 3], x => x^2)" => "[1, 4, 9]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Value>> {
    args.list.iter().map(|item| ctx.call(&args.f, std::slice::from_ref(item))).collect()
}
