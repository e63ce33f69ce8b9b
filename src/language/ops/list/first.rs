//! `first`: the first element.

use crate::{
    diag::{Result, Spanned},
    ops::math::empty,
    value::{Ctx, List, Value, op},
};

op! {
    /// First element of a list.
    first in List -> Value {
        /// The list; one element or more.
        list: Spanned<List>,
    }
    example "first([3, 4])" => "3";
    refuses "first([])" => "E0502: an empty list has no `first`";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Value> {
    match args.list.value.first() {
        Some(item) => Ok(item.clone()),
        None => empty(args.list.span, "first"),
    }
}
