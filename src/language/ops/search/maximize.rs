//! `maximize`: where a function is greatest.

use super::{
    Within,
    best::{BestSearch, Extreme},
};
use crate::{
    diag::{Result, Spanned},
    value::{Callback, Ctx, Value, op},
};

op! {
    /// Unknowns at which a function is greatest: a number within a range, or several unknowns within bounds,
    /// from a start, and under conditions.
    ///
    /// Of one number in a range, which may be an end of it: seventeen places at nearly equal distances, and up to 257
    /// where the function turns often, tell near which the greatest value is; from there on the search goes by
    /// parabolas and golden sections. Where derivatives pass through the function they tell the last digits of the place,
    /// which has half of those that numbers have without; the value there has all. Brent, *Algorithms for Minimization
    /// without Derivatives*, ch. 5.
    ///
    /// Several unknowns are a point, or a list or record of numbers and points. The search begins at `start`,
    /// or at the best of 32 places that are spread over the bounds, and ends at the nearest valley's floor,
    /// which need not be the greatest of all. Its steps are those of sequential quadratic programming; gradients
    /// are exact where derivatives pass through all that the function does (see `gradient`), else central
    /// differences. What would be higher a little beside the answer is looked at before it is given: along each unknown, and
    /// of up to 200 along the ways that the conditions leave free and the function bends up, so that no saddle, nor
    /// the least value on a circle, is taken for the greatest. What does not settle in 5000 steps is refused. Nocedal &
    /// Wright, *Numerical Optimization*, ch. 18, §12.5.
    maximize in Math -> Value {
        /// A function of the unknowns that yields a number; all may have a dimension.
        f: Spanned<Callback>,
        /// The range of one number, or a list or record of ranges for several; one range serves all of them.
        /// Unknowns of a record that it does not name are free, and so is what is left out of a point.
        within: Option<Spanned<Within>>,
        /// Where the search begins; inside the bounds where there are any.
        start: Option<Spanned<Value>>,
        /// Conditions: a function of the unknowns that compares, `u => u.a + u.b <= 5 and u.a == 2*u.b`, or a
        /// list of such. They hold to eight digits of the unknowns; `<` is taken for `<=`.
        subject: Option<Spanned<Value>>,
        /// Whether a record tells how it was found: `at`, the `value` there, `evaluations`, and whether
        /// `derivatives` were `"exact"`, `"differences"` or `"none"`.
        report: bool = false,
    }
    example "maximize(x => 3 - (x - 1)^2, within = 0..4)" => "1";
    example "maximize(t => sin(t), within = 0deg..180deg) ~= 90deg" => "true";
    example "maximize(u => u.a * u.b, start = {a: 1, b: 1}, subject = u => u.a + 2*u.b <= 8).a ~= 4" => "true";
    refuses "maximize(p => p.x, start = (0, 0))" => "E0504: the function grows without bound";
    refuses "maximize(x => x, within = 0..<5)" => "E0502: a search looks at both ends of its range, and 0..<5 leaves one out";
    refuses "maximize(x => x, within = 2..1)" => "E0606: an interval needs its start below its end, got 2..1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let Args { f, within, start, subject, report } = args;
    let within = within.map(|within| within.map(|within| within.0));
    BestSearch { f, within, start, subject, is_report: report }.run(ctx, Extreme::Higher)
}
