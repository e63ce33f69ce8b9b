//! `zip`: two lists side by side.

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    value::{Ctx, List, Value, op},
};

op! {
    /// List of pairs `[a, b]` of the elements of two lists of one length.
    zip in List -> Vec<Value> {
        /// The first list.
        a: List,
        /// The second list.
        b: Spanned<List>,
    }
    example "zip([1, 2], [\"a\", \"b\"])" => "[[1, \"a\"], [2, \"b\"]]";
    refuses "zip([1, 2], [3])" => "E0301: the lists have 2 and 1 elements; pairs need as many of each";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vec<Value>> {
    let (a, b) = (args.a, args.b.value);
    if a.len() != b.len() {
        let message = format!(
            "the lists have {} and {} elements; pairs need as many of each",
            a.len(),
            b.len()
        );
        return Diagnostic::error(Code::WrongKind, args.b.span, message).fail();
    }
    Ok(a.iter().zip(b.iter()).map(|(a, b)| Value::list(vec![a.clone(), b.clone()])).collect())
}
