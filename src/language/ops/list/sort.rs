//! `sort`: the list in order.

use std::cmp::Ordering;

use super::order::{ordering, sort_keys};
use crate::{
    diag::{Result, Spanned},
    value::{Callback, Ctx, List, Value, op},
};

op! {
    /// The same numbers, or strings, in ascending order; equal ones keep their order.
    sort in List -> Vec<Value> {
        /// Numbers of one dimension, or strings.
        list: Spanned<List>,
        /// A function whose value decides the order, instead of the element itself.
        by: Option<Callback>,
    }
    example "sort([3, 1, 2])" => "[1, 2, 3]";
    example "sort([(1, 5), (2, 3)], by = p => p.y)" => "[(2, 3, 0), (1, 5, 0)]";
    refuses "sort([1, \"a\"])" => "E0301: the number 1 and the string \"a\" have no order";
    refuses "sort([3mm, 1, 2deg])" => "E0301: a length (3) and an angle (2deg) have no order";
    refuses "sort([(1, 5), (2, 3)])" => "E0301: a point and a point have no order";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Value>> {
    let keys = sort_keys(ctx, &args.list, args.by.as_ref())?;
    let items = &args.list.value;
    let mut places: Vec<usize> = (0..items.len()).collect();
    places.sort_by(|&a, &b| ordering(&keys[a], &keys[b]).unwrap_or(Ordering::Equal));
    Ok(places.into_iter().map(|place| items[place].clone()).collect())
}
