//! `argmax`: where the greatest element stands.

use std::cmp::Ordering;

use super::extreme_index;
use crate::{
    diag::{Result, Spanned},
    value::{Callback, Ctx, List, op},
};

op! {
    /// Index of the greatest number of a list, the first of equal ones.
    argmax in List -> usize {
        /// Numbers of one dimension, or strings.
        list: Spanned<List>,
        /// A function whose value decides, instead of the element itself.
        by: Option<Callback>,
    }
    example "argmax([3, 1, 4, 1])" => "2";
    example "argmax([(1, 5), (2, 3)], by = p => p.y)" => "0";
    refuses "argmax([])" => "E0502: an empty list has no `argmax`";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<usize> {
    extreme_index(ctx, &args.list, args.by.as_ref(), Ordering::Greater, "argmax")
}
