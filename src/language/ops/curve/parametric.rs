//! `parametric` of one parameter: the curve of any function.

use crate::{
    diag::{Code, Diagnostic, Result},
    kernel::{Curve, Interval, ParametricCurve},
    value::{At, Callback, Ctx, op},
};

op! {
    /// Curve of any function that yields a point for a parameter.
    ///
    /// It is the function itself and no approximation. Its derivatives are exact, not differences:
    /// they are carried through everything that the function computes, through `if`, blocks, calls
    /// and lists too. The function is tried at some places when the curve is made, and refused where
    /// it has no derivative at any of them, because an operation in it passes none: such a curve could
    /// not be drawn, measured or exported. Griewank & Walther, *Evaluating Derivatives*, ch. 13.
    parametric in Curve -> Curve {
        /// The function, of one parameter without a unit.
        f: Callback,
        /// The range of the parameter.
        domain: Interval,
    }
    example "parametric(t => (t, t^2), 0..2)(1.5)" => "(1.5, 2.25, 0)";
    example "derivative(parametric(t => (t, t^2), 0..2), 1.5)" => "(1, 3, 0)";
    example "curvature(parametric(t => (2*cos(t), 2*sin(t), t), 0..tau), 1) ~= 0.4" => "true";
    refuses "parametric(t => (t, 1/t), 0..1)" => "E0501: division by zero";
    refuses "parametric(t => t, 0..1)" => "E0301: the function must yield a point, but it yields the number 0";
    refuses "parametric(t => (t, t^2), 1..1)" => "E0606: `parametric`: `domain`: an interval needs its start below its end, got 1..1";
    picture "parametric(t => ((1 + t/4)*cos(t), (1 + t/4)*sin(t)), 0..12)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Curve> {
    let function = ctx.caller.curve_function(&args.f.0, ctx.span)?;
    let curve = ParametricCurve::new(args.domain, function).at(ctx.span);
    let hint =
        "a curve has a function of one parameter; one of two, and a second range, make a surface";
    let curve = curve.map_err(|found| if_misfit(found, hint))?;
    has_derivatives(|share| curve.derivatives_at(args.domain.at(share), 1).at(ctx.span))?;
    Ok(Curve::from(curve))
}

/// Shares of a domain at which derivatives are looked for: none that a round number would be.
const SHARES: [f64; 2] = [0.382, 0.708];

/// Fails where a function has derivatives at none of some places: an operation in it has none. At a
/// single place there may be none for all that, as of `abs(t)` at 0.
pub(in crate::ops) fn has_derivatives<T>(at: impl Fn(f64) -> Result<T>) -> Result<()> {
    let mut refused = None;
    for share in SHARES {
        match at(share) {
            Err(found) if found.code == Code::NoDerivative => refused = refused.or(Some(found)),
            _ => return Ok(()),
        }
    }
    refused.map_or(Ok(()), Err)
}

/// Adds a hint where a function does not take the parameters that it is given.
pub(in crate::ops) fn if_misfit(mut found: Box<Diagnostic>, hint: &str) -> Box<Diagnostic> {
    if found.code == Code::BadCall {
        found.hints.insert(0, hint.to_owned());
    }
    found
}
