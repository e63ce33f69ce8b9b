//! `every`: whether all elements pass.

use super::first_that;
use crate::{
    diag::Result,
    value::{Callback, Ctx, List, Maybe, op},
};

op! {
    /// Whether the test holds for every element; of an empty list it is true.
    every in List -> bool {
        /// The list; a range of whole numbers counts as one.
        list: List,
        /// The test; left out where the elements are true or false themselves.
        f: Maybe<Callback>,
    }
    example "every([1, 2, 3], x => x > 0)" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<bool> {
    Ok(first_that(ctx, args.list, args.f.0, false)?.is_none())
}
