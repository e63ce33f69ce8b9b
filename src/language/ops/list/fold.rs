//! `fold`: one value from a list.

use crate::{
    diag::Result,
    value::{Callback, Ctx, List, Value, op},
};

op! {
    /// Value that grows from `start` by `f(value, element)` through the list.
    fold in List -> Value {
        /// The list; a range of whole numbers counts as one.
        list: List,
        /// The value before the first element.
        start: Value,
        /// The function of the value so far and the element.
        f: Callback,
    }
    example "fold([1, 2, 3], 10, (total, x) => total + x)" => "16";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let mut value = args.start;
    for item in args.list.iter() {
        value = ctx.call(&args.f, [value, item.clone()])?;
    }
    Ok(value)
}
