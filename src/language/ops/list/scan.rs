//! `scan`: every value of a fold.

use crate::{
    diag::Result,
    value::{Callback, Ctx, List, Value, op},
};

op! {
    /// List of all values of `fold` on its way, without the start: as many as there are elements.
    scan in List -> Vec<Value> {
        /// The list; a range of whole numbers counts as one.
        list: List,
        /// The value before the first element.
        start: Value,
        /// The function of the value so far and the element.
        f: Callback,
    }
    example "scan([1, 2, 3], 0, (total, x) => total + x)" => "[1, 3, 6]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Value>> {
    let (mut value, mut all) = (args.start, Vec::with_capacity(args.list.len()));
    for item in args.list.iter() {
        value = ctx.call(&args.f, &[value, item.clone()])?;
        all.push(value.clone());
    }
    Ok(all)
}
