//! `contains` of a text: whether a part occurs.

use std::sync::Arc;

use crate::{
    diag::Result,
    value::{Ctx, op},
};

op! {
    /// Whether a part occurs in a text.
    contains in Text -> bool {
        /// The text.
        text: Arc<str>,
        /// The part.
        part: Arc<str>,
    }
    example "contains(\"hull.geo\", \".geo\")" => "true";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<bool> {
    Ok(args.text.contains(&*args.part))
}
