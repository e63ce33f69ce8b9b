//! `index_of` in a list: where a value first stands.

use crate::{
    diag::Result,
    value::{Ctx, List, Value, equal, op},
};

op! {
    /// Index of the first element that is equal to a value as `==` says; none where there is none.
    index_of in List -> Value {
        /// The list; a range of whole numbers counts as one.
        list: List,
        /// The value.
        element: Value,
    }
    example "index_of([5, 7, 9], 7)" => "1";
    example "index_of([5, 7, 9], 8)" => "none";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let found = args.list.iter().position(|item| equal(item, &args.element) == Some(true));
    Ok(found.map_or(Value::None, |idx| Value::number(idx as f64)))
}
