//! `minimize`: where a function is least.

use super::{SearchRange, number_at};
use crate::{
    diag::{Result, Spanned},
    kernel::find_least,
    value::{Callback, Ctx, Number, Range, op},
};

op! {
    /// Number within a range at which a function is least, which may be an end of the range.
    ///
    /// Seventeen places at equal distances tell near which the least value is; from there on the search
    /// goes by parabolas and golden sections. The place has half of the digits that numbers have, the value
    /// there all of them. Brent, *Algorithms for Minimization without Derivatives*, ch. 5.
    minimize in Math -> Number {
        /// A function of one number that yields a number; both may have a dimension.
        f: Spanned<Callback>,
        /// The range.
        within: Spanned<Range>,
    }
    example "abs(minimize(x => (x - 1)^2 + 3, within = 0..4) - 1) < 1e-6" => "true";
    example "minimize(t => -sin(t), within = 0deg..180deg) ~= 90deg within 1e-6" => "true";
    refuses "minimize(x => x, within = 2..1)" => "E0606: an interval needs its start below its end, got 2..1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Number> {
    let range = SearchRange::new(args.within)?;
    let mut dim = None;
    let mut ask = |at| number_at(ctx, &args.f, &range, (at, &mut dim));
    let found = find_least(&mut ask, range.ends)?;
    Ok(range.place(found.at))
}
