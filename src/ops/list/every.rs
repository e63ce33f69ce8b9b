//! `every`: whether all elements pass.

use super::{as_truth, truth};
use crate::{
    diag::Result,
    value::{Callback, Ctx, List, Maybe, Witness, op},
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
    for (idx, item) in args.list.iter().enumerate() {
        let holds = match &args.f.0 {
            Some(test) => truth(ctx, test, item)?,
            None => as_truth(item, ctx.span)?,
        };
        if !holds {
            ctx.decided(Witness::Element(idx, item.clone()));
            return Ok(false);
        }
    }
    ctx.decided(Witness::All(args.list.len()));
    Ok(true)
}
