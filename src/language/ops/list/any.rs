//! `any`: whether some element passes.

use super::first_that;
use crate::{
    diag::Result,
    value::{Callback, Ctx, List, Maybe, op},
};

op! {
    /// Whether the test holds for some element; of an empty list it is false.
    any in List -> bool {
        /// The list; a range of whole numbers counts as one.
        list: List,
        /// The test; left out where the elements are true or false themselves.
        f: Maybe<Callback>,
    }
    example "any([1, 2, 3], x => x > 2)" => "true";
    example "any([false, false])" => "false";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<bool> {
    Ok(first_that(ctx, args.list, args.f.0, true)?.is_some())
}
