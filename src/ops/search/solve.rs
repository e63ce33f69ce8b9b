//! `solve`: where a function is zero.

use super::{SearchRange, number_at, system::solved, told};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{RootError, Sample, find_root, find_roots},
    value::{Callback, Ctx, Dimension, IntoValue, Number, Range, Record, Value, op},
};

op! {
    /// Number within a range at which a function is zero: `solve(h => volume(bottle(h)) - 0.75e6, within = 10cm..40cm)`.
    ///
    /// Where the function has different signs at both ends, the root between them is found in some ten
    /// steps, as exactly as numbers tell it. Where it has the same sign, the range is divided until it has
    /// not, and at last the place where it is nearest to zero is looked at, since it may only touch zero
    /// there. A jump over zero, such as a pole, is no root. With `all = true` the answer is a list: every
    /// root that 256 places at equal distances tell apart. Chandrupatla, *A new hybrid
    /// quadratic/bisection algorithm*, Adv. Eng. Software 28 (1997).
    ///
    /// From a `start` instead of a range, the unknowns may be a number, a point, or a list or record of such,
    /// and the function yields as many numbers or more, each of which is to be zero: of more than there are
    /// unknowns the squares are made least. The search may end at another root than the nearest one. Moré,
    /// *The Levenberg-Marquardt algorithm*, LNM 630 (1978).
    solve in Math -> Value {
        /// A function of the unknown that yields what is to be zero; both may have a dimension.
        f: Spanned<Callback>,
        /// The range in which the root is.
        within: Option<Spanned<Range>>,
        /// Where the search begins, instead of a range.
        start: Option<Spanned<Value>>,
        /// Whether all roots are wanted, as a list; without it one is.
        all: bool = false,
        /// Whether a record tells how it was found: `root`, the `residual` there, `evaluations`.
        report: bool = false,
    }
    example "solve(x => x^2 - 2, within = 0..2) ~= sqrt(2)" => "true";
    example "solve(x => sin(x), within = 1..10, all = true)" => "[3.141592653589793, 6.283185307179586, 9.42477796076938]";
    example "\"{solve(r => pi * r^2 - 12cm * 1cm, within = 0mm..10cm):.3mm}\"" => "\"19.544mm\"";
    example "solve(x => x^3 - 8, within = 0..5, report = true).evaluations < 20" => "true";
    example "solve(p => [p.x + p.y - 3, p.x - p.y - 1], start = (0, 0)) ~= (2, 1)" => "true";
    example "solve(u => [u.a * u.b - 6, u.a + u.b - 5], start = {a: 1, b: 4}).a ~= 2" => "true";
    refuses "solve(x => x^2 + 1, within = -1..2)" => "E0504: the function is 0 nowhere that could be found within -1..2";
    refuses "solve(x => 1/(x - 0.3), within = 0..1)" => "E0504: the function changes its sign at 0.3 without being 0 there";
    refuses "solve(x => x, within = 2..1)" => "E0606: an interval needs its start below its end, got 2..1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    match (args.within, args.start) {
        (Some(within), None) => within_range(ctx, &args.f, within, args.all, args.report),
        (None, Some(start)) => {
            let (root, found) = solved(ctx, &args.f, &start)?;
            let residual =
                found.residuals.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
            Ok(if args.report {
                told_as_found(root, Value::number(residual), found.n_evaluations)
            } else {
                root
            })
        }
        (within, _) => {
            let message = match within {
                None => "`solve` needs a range to look in, or a start",
                Some(_) => "`solve` looks within a range or from a start, not both",
            };
            Diagnostic::error(Code::BadCall, ctx.span, message)
                .hint("`within = 0..10` for one number, `start = (1, 2)` for several unknowns")
                .fail()
        }
    }
}

/// The record that tells how a root was found.
fn told_as_found(root: Value, residual: Value, n_asked: usize) -> Value {
    let fields =
        [("root", root), ("residual", residual), ("evaluations", Value::number(n_asked as f64))];
    Record::new(fields.map(|(label, value)| (label.into(), value))).into_value()
}

fn within_range(
    ctx: &mut Ctx<'_>,
    function: &Spanned<Callback>,
    within: Spanned<Range>,
    is_all: bool,
    is_report: bool,
) -> Result<Value> {
    let range = SearchRange::new(within)?;
    let (mut n_asked, mut dim) = (0_usize, None);
    let mut ask = |at| {
        n_asked += 1;
        number_at(ctx, function, &range, (at, &mut dim))
    };
    let found = if is_all {
        find_roots(&mut ask, range.ends)
    } else {
        find_root(&mut ask, range.ends).map(|root| vec![root])
    };
    let roots = found.map_err(|err| refusal(err, function, &range, dim))?;
    let value = |root: &Sample| {
        let place = range.place(root.at).into_value();
        let residual = Number { value: root.value, dim: dim.unwrap_or_default() }.into_value();
        if is_report { told_as_found(place, residual, n_asked) } else { place }
    };
    Ok(match roots.as_slice() {
        [root] if !is_all => value(root),
        roots => Value::List(roots.iter().map(value).collect()),
    })
}

/// Why there is no root, in the words of the script.
fn refusal(
    err: RootError<Box<Diagnostic>>,
    function: &Spanned<Callback>,
    range: &SearchRange,
    dim: Option<Dimension>,
) -> Box<Diagnostic> {
    let at = |sample: Sample| format!("{} at {}", told(sample.value, dim), range.told(sample.at));
    let found = |message| Diagnostic::error(Code::NoAnswer, function.span, message);
    Box::new(match err {
        RootError::Function(found) => return found,
        RootError::NoRoot { nearest, ends: [start, end] } => {
            let message = format!(
                "the function is 0 nowhere that could be found within {}..{}",
                range.told(start.at),
                range.told(end.at)
            );
            let ends = format!("it is {} and {}", at(start), at(end));
            let found = found(message).label(ends);
            found.hint(format!(
                "it is nearest to 0 with {}; a root elsewhere needs another `within`",
                at(nearest)
            ))
        }
        RootError::Jump { sides: [before, behind] } => {
            let place = range.told(before.at);
            let message = format!("the function changes its sign at {place} without being 0 there");
            found(message)
                .label(format!(
                    "it jumps from {} to {}",
                    told(before.value, dim),
                    told(behind.value, dim)
                ))
                .hint("a pole or a step is no root; give a `within` on one side of it")
        }
    })
}
