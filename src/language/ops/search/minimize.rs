//! `minimize`: where a function is least.

use super::{
    Within,
    best::{BestSearch, Extreme},
};
use crate::{
    diag::{Result, Spanned},
    value::{Callback, Ctx, Value, op},
};

op! {
    /// Unknowns at which a function is least: a number within a range, or several unknowns within bounds,
    /// from a start, and under conditions.
    ///
    /// Of one number in a range, which may be an end of it: seventeen places at nearly equal distances, and up to 257
    /// where the function turns often, tell near which the least value is; from there on the search goes by parabolas
    /// and golden sections. Where derivatives pass through the function they tell the last digits of the place, which has
    /// half of those that numbers have without; the value there has all. Where a whole stretch is least it is one place of
    /// it; a function that is the same everywhere is refused. Brent, *Algorithms for Minimization without Derivatives*,
    /// ch. 5.
    ///
    /// Several unknowns are a point, or a list or record of numbers and points. The search begins at `start`,
    /// or at the best of 32 places that are spread over the bounds, and ends at the nearest valley's floor,
    /// which need not be the least of all. Its steps are those of sequential quadratic programming; gradients
    /// are exact where derivatives pass through all that the function does (see `gradient`), else central
    /// differences. Exact ones tell the place to its last digits, by steps of Newton's method, but between kinks and on
    /// floors that are flat as that of a fourth power. What would be lower a little beside the answer is looked at before it is given: along each unknown, and
    /// of up to 200 along the ways that the conditions leave free and the function bends down, so that no saddle, nor
    /// the greatest value on a circle, is taken for the least. A start tells sizes that may be far from those over which the
    /// function bends: without conditions it is looked nearer and farther off by the sizes that the answer itself has, down to
    /// a billionth of the start and out by any power of it, and what is lower there is where the search begins anew. A level
    /// that the function only tends to, as far as numbers tell, is refused. What does not settle in 5000 steps is refused. Nocedal &
    /// Wright, *Numerical Optimization*, ch. 18, §12.5.
    ///
    /// Functions and conditions may have kinks, as sums of `abs` and the greatest of several have, which fit the most points
    /// or tolerate the least, straight or bent: the planes of what meets near the answer must hold one another off from
    /// whatever is lower, within a hundredth of the unknowns' sizes down to a hundred-millionth, and it is looked along the
    /// kinks whether they fall there; what is promised without its being found is refused, and kinks of more than 60
    /// unknowns may be. Without derivatives more is refused, and answers have some six digits. Lewis & Overton, *Nonsmooth
    /// optimization via quasi-Newton methods*, Math. Programming 141 (2013); Goldstein, *Optimization of Lipschitz continuous
    /// functions*, Math. Programming 13 (1977); Schramm & Zowe, *A version of the bundle idea*, SIAM J. Optim. 2 (1992).
    minimize in Math -> Value {
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
    example "minimize(x => (x - 1)^2 + 3, within = 0..4)" => "1";
    example "minimize(t => -sin(t), within = 0deg..180deg) ~= 90deg" => "true";
    example "minimize(p => norm(p - (3, 4)), start = (0, 0), subject = p => norm(p) <= 1) ~= (0.6, 0.8)" => "true";
    example "minimize(u => u.a + u.b, within = {a: 0..9, b: 1..9}, subject = u => u.a * u.b >= 9).a ~= 3" => "true";
    example "minimize(p => p.y, start = (0, 1), subject = p => norm(p) == 1) ~= (0, -1)" => "true";
    example "minimize(x => (x[0] - x[1])^2 + x[0]^2, start = [3, 1], report = true).derivatives" => "\"exact\"";
    refuses "minimize(p => p.x, start = (0, 0))" => "E0504: the function falls without bound";
    refuses "minimize(p => p.x, start = (5, 0), subject = p => p.x <= 1 and p.x >= 2)" => "E0504: the conditions do not hold together near the start";
    refuses "minimize(x => 5, within = 0..2)" => "E0504: the function is 5 everywhere within 0..2";
    refuses "minimize(u => u.a^2, start = {a: 9}, within = {a: 2..5})" => "E0502: the start is outside of `within`";
    refuses "minimize(u => u.r/1deg + u.x, start = {r: 10deg, x: 1}, within = {r: 0..45})" => "E0303: a bound is a number without a unit, the unknown is an angle";
    refuses "minimize(x => x, within = 2..1)" => "E0606: an interval needs its start below its end, got 2..1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let Args { f, within, start, subject, report } = args;
    let within = within.map(|within| within.map(|within| within.0));
    BestSearch { f, within, start, subject, is_report: report }.run(ctx, Extreme::Lower)
}
