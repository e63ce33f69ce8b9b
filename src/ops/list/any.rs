//! `any`: whether some element passes.

use super::{as_truth, truth};
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
    for item in args.list.iter() {
        let holds = match &args.f.0 {
            Some(test) => truth(ctx, test, item)?,
            None => as_truth(item, ctx.span)?,
        };
        if holds {
            return Ok(true);
        }
    }
    Ok(false)
}
