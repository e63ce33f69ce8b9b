//! `last`: the last element.

use crate::{
    diag::{Result, Spanned},
    ops::math::empty,
    value::{Ctx, List, Value, op},
};

op! {
    /// Last element of a list.
    last in List -> Value {
        /// The list; one element or more.
        list: Spanned<List>,
    }
    example "last([3, 4])" => "4";
    refuses "last([])" => "E0502: an empty list has no `last`";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Value> {
    match args.list.value.last() {
        Some(item) => Ok(item.clone()),
        None => empty(args.list.span, "last"),
    }
}
