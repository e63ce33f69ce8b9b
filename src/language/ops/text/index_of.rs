//! `index_of` in a text: where a part begins.

use std::sync::Arc;

use crate::{
    diag::Result,
    value::{Ctx, Value, op},
};

op! {
    /// Letter of a text at which a part first begins, counted from 0; none where it does not occur.
    index_of in Text -> Value {
        /// The text.
        text: Arc<str>,
        /// The part.
        part: Arc<str>,
    }
    example "index_of(\"hull.geo\", \".\")" => "4";
    example "index_of(\"hull.geo\", \"x\")" => "none";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let found = args.text.find(&*args.part);
    Ok(found.map_or(Value::None, |at| Value::number(args.text[..at].chars().count() as f64)))
}
