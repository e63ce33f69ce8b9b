//! `argmin`: where the least element stands.

use std::cmp::Ordering;

use super::extreme_index;
use crate::{
    diag::{Result, Spanned},
    value::{Callback, Ctx, List, op},
};

op! {
    /// Index of the least number of a list, the first of equal ones.
    argmin in List -> usize {
        /// Numbers of one dimension, or strings.
        list: Spanned<List>,
        /// A function whose value decides, instead of the element itself.
        by: Option<Callback>,
    }
    example "argmin([3, 1, 4, 1])" => "1";
    example "argmin([(1, 5), (2, 3)], by = p => p.y)" => "1";
    refuses "argmin([])" => "E0502: an empty list has no `argmin`";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<usize> {
    extreme_index(ctx, &args.list, args.by.as_ref(), Ordering::Less, "argmin")
}
