//! `any`: whether some element passes.

use super::{as_truth, truth};
use crate::{
    diag::Result,
    value::{Callback, Ctx, List, Maybe, Witness, op},
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
    for (idx, item) in args.list.iter().enumerate() {
        let holds = match &args.f.0 {
            Some(test) => truth(ctx, test, item)?,
            None => as_truth(item, ctx.span)?,
        };
        if holds {
            ctx.decided(Witness::Element(idx, item.clone()));
            return Ok(true);
        }
    }
    ctx.decided(Witness::All(args.list.len()));
    Ok(false)
}
