//! `solve`: where a function is zero.

use super::{
    SearchRange, Within, number_at, six_digits,
    system::solved,
    unknowns::{asked, number, single},
};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{
        GeomError, LocalError, RootError, RootProof, Sample, find_crossing, find_root, find_roots,
        tolerance::DIFFERENCE_RELATIVE,
    },
    value::{
        At, Callback, CommonDimension, Ctx, Dimension, IntoValue, Number, Range, Real, Record,
        Value, op,
    },
};

op! {
    /// Number within a range at which a function is zero: `solve(h => volume(bottle(h)) - 0.75e6, within = 10cm..40cm)`.
    ///
    /// Where the function has different signs at both ends, the root between them is found in some ten steps, as
    /// exactly as numbers tell it. Where it has the same sign, the range is divided until it has not, and at last the
    /// place where it is nearest to zero is looked at, since it may only touch zero there; of such a place half of the digits are known.
    /// What a bare unknown measures stays open where the function's values are open, as of coordinates. A jump over zero, such as
    /// a pole, is no root, and a stretch along which the function is 0 is refused. With `all = true` the answer is a
    /// list. Of a function of arithmetic, `if` and the functions of one number the range is divided until bounds of
    /// its values and slopes prove where its roots are and that there are no others; where roots coincide, lie at the
    /// border or only touch zero it is looked at closely what that proof leaves open: what is zero as far as rounding
    /// tells is a root, and a pole or a step is passed over. Of any other function the list holds every root that 256
    /// places at equal distances tell apart, a clear jump over zero is passed over as well, and it is refused where more than
    /// every fourth part between them holds one.
    /// Chandrupatla, *A new hybrid quadratic/bisection algorithm*, Adv. Eng. Software 28 (1997); Moore, Kearfott & Cloud,
    /// *Introduction to Interval Analysis*, §8.1.
    ///
    /// Derivatives pass through roots by the theorem of implicit functions, where the functions cross zero and are
    /// as many as the unknowns.
    ///
    /// From a `start` instead of a range, the unknowns may be a number, a point, or a list or record of such,
    /// and the function yields as many numbers or more, each of which is to be zero: of more than there are
    /// unknowns the squares are made least. Steps to where the function has no value are taken shorter. The search may
    /// end at another root than the nearest one; with `within` beside the start the unknowns stay between those bounds.
    /// Moré, *The Levenberg-Marquardt algorithm*, LNM 630 (1978).
    solve in Math -> Value {
        /// A function of the unknown that yields what is to be zero; both may have a dimension.
        f: Spanned<Callback>,
        /// The range in which the root is; beside a start also a list or record of ranges for several unknowns, or one
        /// for all of them. Unknowns of a record that it does not name are free, and so is what is left out of a point.
        within: Option<Spanned<Within>>,
        /// Where the search begins, inside of `within` where there is that; of one number in a range there is none.
        start: Option<Spanned<Value>>,
        /// Whether all roots are wanted, as a list; without it one is.
        all: bool = false,
        /// Whether a record tells how it was found: `root`, the `residual` there, of several numbers the largest, with a
        /// unit where they have one together, `evaluations`, and whether it is `proven`: that a root is there, and
        /// with `all` that there is no other.
        report: bool = false,
    }
    example "solve(x => x^2 - 2, within = 0..2) ~= sqrt(2)" => "true";
    example "solve(x => sin(x), within = 1..10, all = true)" => "[3.141592653589793, 6.283185307179586, 9.42477796076938]";
    example "solve(x => (x^2 - 2)^2, within = 0..3, all = true) ~= [sqrt(2)]" => "true";
    example "solve(x => if x < 1 then -1 - norm((x, 0))^2 else 3 - x, within = 0..5, all = true)" => "[3]";
    example "\"{solve(r => pi * r^2 - 12cm * 1cm, within = 0mm..10cm):.3mm}\"" => "\"19.544mm\"";
    example "solve(x => x^3 - 8, within = 0..5, report = true).evaluations < 20" => "true";
    example "[for r in solve(x => x^3 - 2*x + sin(x) - 0.2, within = -2..2, all = true, report = true): r.proven]" => "[true, true, true]";
    example "solve(p => [p.x + p.y - 3, p.x - p.y - 1], start = (0, 0)) ~= (2, 1)" => "true";
    example "solve(u => [u.a * u.b - 6, u.a + u.b - 5], start = {a: 1, b: 4}).a ~= 2" => "true";
    example "solve(u => [exp(u[0]) - 1000], start = [0])[0] ~= ln(1000)" => "true";
    example "solve(u => [u.a * u.b - 6, u.a + u.b - 5], start = {a: 4, b: 4}, within = {a: 2.5..9}).a ~= 3" => "true";
    example "gradient(a => solve(x => x^2 - a, within = 0..5), 4) ~= 0.25" => "true";
    example "gradient(r => solve(p => [norm(p) - r, p.y - 2*p.x], start = (1, 1)).x, 5) ~= 1/sqrt(5) within 1e-9" => "true";
    refuses "solve(x => x^2 + 1, within = -1..2)" => "E0504: the function is 0 nowhere within -1..2";
    refuses "solve(x => 1/(x - 0.3), within = 0..1)" => "E0504: the function changes its sign at 0.3 without being 0 there";
    refuses "solve(x => max(x, 1) - 1, within = 0..2)" => "E0504: the function is 0 all along 0..0.02, not at one place";
    refuses "solve(x => x^2 - 1, start = 2, all = true)" => "E0401: `solve` finds one root from a start; all of them are found within a range";
    refuses "solve(x => x - 5, within = 0..<5)" => "E0502: a search looks at both ends of its range, and 0..<5 leaves one out";
    refuses "solve(x => x, within = 2..1)" => "E0606: an interval needs its start below its end, got 2..1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let within = args.within.map(|within| within.map(|within| within.0));
    match (within, args.start) {
        (_, Some(_)) if args.all => {
            let message =
                "`solve` finds one root from a start; all of them are found within a range";
            Diagnostic::error(Code::BadCall, ctx.span, message)
                .hint("`within = 0..10, all = true` for the roots of one number")
                .fail()
        }
        (within, Some(start)) => {
            let (root, found, dim) = solved(ctx, &args.f, &start, within.as_ref())?;
            let value = found.residuals.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
            let residual = Number { value, dim }.into_value();
            Ok(if args.report {
                told_as_found(root, residual, found.n_evaluations, false)
            } else {
                root
            })
        }
        (Some(within), None) => match single(&within) {
            Some(range) => within_range(ctx, &args.f, range, args.all, args.report),
            None => {
                let message = "`solve` looks for several unknowns from a start";
                Diagnostic::error(Code::BadCall, within.span, message)
                    .hint("give `start = {a: 1, b: 2}` beside these bounds")
                    .fail()
            }
        },
        (None, None) => {
            let message = "`solve` needs a range to look in, or a start";
            Diagnostic::error(Code::BadCall, ctx.span, message)
                .hint("`within = 0..10` for one number, `start = (1, 2)` for several unknowns")
                .fail()
        }
    }
}

/// The record that tells how a root was found.
fn told_as_found(root: Value, residual: Value, n_asked: usize, is_proven: bool) -> Value {
    let fields = [
        ("root", root),
        ("residual", residual),
        ("evaluations", Value::number(n_asked as f64)),
        ("proven", Value::Bool(is_proven)),
    ];
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
    // Bounds are computed where they are asked for, so that a search for one root costs no more.
    let bounded = ctx.caller.bounded(&function.value.0);
    let bounds = |interval| bounded.as_ref()?.over(interval);
    let mut proof = (is_all || is_report).then(|| RootProof::of(bounds, range.ends));
    let (mut n_asked, mut dim) = (0_usize, CommonDimension::default());
    let mut ask = |at| {
        n_asked += 1;
        number_at(ctx, function, &range, (at, &mut dim))
    };
    let mut found = match &proof {
        Some(proof) if is_all && proof.open.is_some() => proof.roots(bounds, &mut ask, range.ends),
        _ if is_all => find_roots(&mut ask, range.ends),
        _ if bounded.is_some() => find_crossing(&mut ask, range.ends).map(|root| vec![root]),
        _ => find_root(&mut ask, range.ends).map(|root| vec![root]),
    };
    let may_tell = matches!(found, Err(RootError::NoRoot { .. } | RootError::Function(_)));
    if may_tell && !is_all && bounded.is_some() {
        // Where it touches zero, or has a pole, bounds tell better than samples, unless they are left open.
        let proof = proof.get_or_insert_with(|| RootProof::of(bounds, range.ends));
        let all = proof.roots(bounds, &mut ask, range.ends);
        found = match all.ok().and_then(|all| all.first().copied()) {
            Some(root) => Ok(vec![root]),
            None if proof.open.is_none() => find_root(&mut ask, range.ends).map(|root| vec![root]),
            None => found,
        };
    }
    let roots = match found {
        Ok(roots) => roots,
        Err(err) => {
            let is_nowhere = matches!(err, RootError::NoRoot { .. })
                && proof.is_some_and(|it| it.is_whole() && it.brackets.is_empty());
            return Err(refusal(err, function, &range, (dim.known(), is_nowhere)));
        }
    };
    let is_proven = |root: &Sample| {
        proof.as_ref().is_some_and(|proof| {
            let is_in = |[low, high]: &[f64; 2]| *low <= root.at && root.at <= *high;
            if is_all { proof.is_whole() } else { proof.brackets.iter().any(is_in) }
        })
    };
    let found_range = range.found_by(dim.known());
    let mut places = Vec::with_capacity(roots.len());
    for root in &roots {
        places.push(match ctx.caller.is_varying(&function.value.0) {
            true => varying(ctx, function, &range, (root.at, found_range.dim))?,
            false => found_range.place(root.at).into_value(),
        });
    }
    let value = |(root, place): (&Sample, Value)| {
        let residual = Number { value: root.value, dim: dim.dimension() }.into_value();
        match is_report {
            true => told_as_found(place, residual, n_asked, is_proven(root)),
            false => place,
        }
    };
    let mut found = roots.iter().zip(places).map(value);
    match is_all {
        true => Ok(Value::List(found.collect())),
        false => Ok(found.next().unwrap_or(Value::None)),
    }
}

/// How much nearer to a root its slope is looked at again.
const NEARER: f64 = 0.125;

/// A root of a function that takes what carries derivatives from around it: with those that the root has,
/// since the function stays zero there. Griewank & Walther, *Evaluating Derivatives*, §15.1.
fn varying(
    ctx: &mut Ctx<'_>,
    function: &Spanned<Callback>,
    range: &SearchRange,
    (root, dim): (f64, Dimension),
) -> Result<Value> {
    let span = function.span;
    let mut ask = |at: Value| number(&asked(ctx, &function.value, &at)?, span);
    let reach = DIFFERENCE_RELATIVE * (range.ends[1] - range.ends[0]);
    let mut over = |reach: f64| -> Result<(f64, f64, f64)> {
        let [low, high] = [(root - reach).max(range.ends[0]), (root + reach).min(range.ends[1])];
        let [before, behind] =
            [ask(range.place(low).into_value())?, ask(range.place(high).into_value())?];
        let [before, behind] = [before.value.value(), behind.value.value()];
        Ok(((behind - before) / (high - low), high - low, before.abs().max(behind.abs())))
    };
    let (steepness, width, size) = over(reach)?;
    let (nearer, ..) = over(NEARER * reach)?;
    let Real::Jet(like) = ask(range.place(root).into_value())?.value else {
        return Ok(Number { value: root, dim }.into_value());
    };
    let is_touching = steepness.abs() * width <= DIFFERENCE_RELATIVE * size;
    // A slope that goes on to change as it is looked at from nearer by is 0, or has no end.
    if is_touching || 0.5 * steepness.abs() < (nearer - steepness).abs() {
        let what = match is_touching {
            true => "a root where the function only touches 0",
            false => "a root where the function has no slope",
        };
        return Err(GeomError::from(LocalError::NotDifferentiable { what, at: root })).at(span);
    }
    // Each step is right to one order more; the difference is a little beside the slope, so that two more
    // steps bring all orders to their last digits.
    let mut found = like.same(root);
    for _ in 0..like.order() + 2 {
        let place = Number { value: Real::Jet(found.clone()), dim: range.dim };
        let rest = ask(place.into_value())?.value.like(&like);
        found = found.minus(&rest.scaled(1.0 / steepness)).with_value(root);
    }
    Ok(Number { value: Real::Jet(found), dim }.into_value())
}

/// Why there is no root, in the words of the script.
fn refusal(
    err: RootError<Box<Diagnostic>>,
    function: &Spanned<Callback>,
    range: &SearchRange,
    (dim, is_nowhere): (Option<Dimension>, bool),
) -> Box<Diagnostic> {
    let at = |sample: Sample| {
        format!("{} at {}", six_digits(sample.value, dim), range.place_text(sample.at))
    };
    let found = |message| Diagnostic::error(Code::NoAnswer, function.span, message);
    Box::new(match err {
        RootError::Function(found) => return found,
        RootError::NoRoot { nearest, ends: [start, end] } => {
            let where_to = if is_nowhere { "nowhere" } else { "nowhere that could be found" };
            let message = format!(
                "the function is 0 {where_to} within {}..{}",
                range.place_text(start.at),
                range.place_text(end.at)
            );
            let ends = format!("it is {} and {}", at(start), at(end));
            let found = found(message).label(ends);
            found.hint(format!(
                "it is nearest to 0 with {}; a root elsewhere needs another `within`",
                at(nearest)
            ))
        }
        RootError::Jump { sides: [before, behind] } => {
            let place = range.place_text(before.at);
            let message = format!("the function changes its sign at {place} without being 0 there");
            found(message)
                .label(format!(
                    "it jumps from {} to {}",
                    six_digits(before.value, dim),
                    six_digits(behind.value, dim)
                ))
                .hint("a pole or a step is no root; give a `within` on one side of it")
        }
        RootError::Crowded { n_roots: [n_roots, n_parts] } => {
            found(format!("there are too many roots to tell whether these are all: {n_roots} of {n_parts} equal parts hold one"))
                .label("others may lie between them")
                .hint("divide `within` into several ranges, and put their lists together")
        }
        RootError::Flat { stretch } => {
            let along = match stretch.map(f64::to_bits) == range.ends.map(f64::to_bits) {
                true => "everywhere within",
                false => "all along",
            };
            let [from, to] = stretch.map(|at| range.place_text(at));
            found(format!("the function is 0 {along} {from}..{to}, not at one place"))
                .label("so it has no single root")
                .hint("it may not depend on its unknown; else give a `within` beside that stretch")
        }
    })
}
