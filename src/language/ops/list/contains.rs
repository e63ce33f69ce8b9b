//! `contains` of a list: whether a value is among its elements.

use crate::{
    diag::Result,
    value::{Ctx, List, Value, equal, op},
};

op! {
    /// Whether a value is among the elements of a list, equal as `==` says.
    contains in List -> bool {
        /// The list; a range of whole numbers counts as one.
        list: List,
        /// The value.
        element: Value,
    }
    example "contains([1, 2, 3], 2)" => "true";
    example "contains(2..5, 7)" => "false";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<bool> {
    Ok(args.list.iter().any(|item| equal(item, &args.element) == Some(true)))
}
