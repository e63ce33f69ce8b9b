//! `solve`: where a function is zero.

use super::{SearchRange, number_at, told};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{RootError, Sample, find_root, find_roots},
    value::{Callback, Ctx, Dimension, IntoValue, Range, Record, Value, op},
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
    solve in Math -> Value {
        /// A function of one number that yields a number; both may have a dimension.
        f: Spanned<Callback>,
        /// The range in which the root is.
        within: Spanned<Range>,
        /// Whether all roots are wanted, as a list; without it one is.
        all: bool = false,
        /// Whether a record tells how it was found: `root`, the `residual` there, `evaluations`.
        report: bool = false,
    }
    example "solve(x => x^2 - 2, within = 0..2) ~= sqrt(2)" => "true";
    example "solve(x => sin(x), within = 1..10, all = true)" => "[3.141592653589793, 6.283185307179586, 9.42477796076938]";
    example "\"{solve(r => pi * r^2 - 12cm * 1cm, within = 0mm..10cm):.3mm}\"" => "\"19.544mm\"";
    example "solve(x => x^3 - 8, within = 0..5, report = true).evaluations < 20" => "true";
    refuses "solve(x => x^2 + 1, within = -1..2)" => "E0504: the function is 0 nowhere that could be found within -1..2";
    refuses "solve(x => 1/(x - 0.3), within = 0..1)" => "E0504: the function changes its sign at 0.3 without being 0 there";
    refuses "solve(x => x, within = 2..1)" => "E0606: an interval needs its start below its end, got 2..1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let range = SearchRange::new(args.within)?;
    let (mut n_asked, mut dim) = (0_usize, None);
    let mut ask = |at| {
        n_asked += 1;
        number_at(ctx, &args.f, &range, (at, &mut dim))
    };
    let found = if args.all {
        find_roots(&mut ask, range.ends)
    } else {
        find_root(&mut ask, range.ends).map(|root| vec![root])
    };
    let roots = found.map_err(|err| refusal(err, &args.f, &range, dim))?;
    let value = |root: &Sample| {
        let place = range.place(root.at).into_value();
        if !args.report {
            return place;
        }
        let residual = crate::value::Number { value: root.value, dim: dim.unwrap_or_default() };
        Value::Record(
            Record::new([
                ("root".into(), place),
                ("residual".into(), residual.into_value()),
                ("evaluations".into(), Value::number(n_asked as f64)),
            ])
            .into(),
        )
    };
    Ok(match roots.as_slice() {
        [root] if !args.all => value(root),
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
