//! `gradient`: the derivatives of a number by all that it depends on.

use super::{
    six_digits, take,
    unknowns::{Unknowns, asked, number},
};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        Slope, find_slope,
        tolerance::{SLOPE_RELATIVE, SLOPE_STEP_RELATIVE},
    },
    value::{Callback, CommonDimension, Ctx, Dimension, Value, op},
};

op! {
    /// Derivatives of a function's value by each of its unknowns at a place, exact but for rounding: of the
    /// shape of the place.
    ///
    /// The function is run on numbers that carry a derivative by each unknown along, once unless there are
    /// thousands, through operators,
    /// the functions of numbers and points, the making of geometry that grows evenly with what it is made of
    /// (of control points, of points at listed parameters, of curves; moved, scaled, turned, cut), and the
    /// questions about it: places, lengths, areas, volumes, nearest points. The first operation through which
    /// no derivative passes is named in the error; differences do without. Conditions of `if` and other
    /// comparisons decide by the value alone; what does not depend on an unknown has the derivative 0 by it.
    /// Griewank & Walther, *Evaluating Derivatives*, §3.1.
    gradient in Math -> Value {
        /// A function of the unknowns that yields a number.
        f: Spanned<Callback>,
        /// The place: a number, a point, or a list or record of such.
        at: Spanned<Value>,
        /// Whether differences of the function's values are taken instead, some twenty for each unknown, through
        /// whatever it does: to some eight digits of what is computed to all, fewer of what is within a tolerance.
        differences: bool = false,
    }
    example "gradient(u => u.a^2 * u.b, {a: 3, b: 5})" => "{a: 30, b: 9}";
    example "gradient(p => p.x * p.y, (3, 4))" => "(4, 3, 0)";
    example "gradient(x => sum([for k in 1..3: x[0]^k]) * x[1], [2, 5])" => "[85, 14]";
    example "gradient(p => norm(closest(circle((0, 0), 2), p).point - p), (3, 4)) ~= (0.6, 0.8)" => "true";
    example "gradient(r => pi * r^2, 2mm)" => "12.566370614359172";
    example "gradient(h => area(extrude(line((0, 0), (3, 4)), (0, 0, h))), 2mm)" => "5";
    example "gradient(p => volume(scale(box((0, 0), p), 2)), (1, 2, 3)) ~= (48, 24, 16)" => "true";
    example "gradient(a => gradient(x => x^3 * a, a), 2, differences = true) ~= 36 within 1e-6" => "true";
    example "gradient(h => area(offset(region(circle((0, 0), h)), 1)[0]), 2, differences = true) ~= 6*pi within 1e-6" => "true";
    refuses "gradient(x => abs(x), 0)" => "E0503: the magnitude has no derivative at 0";
    refuses "gradient(x => abs(x), 0, differences = true)" => "E0503: the differences do not settle at 0";
    refuses "gradient(a => gradient(x => x^3 * a, a), 2)" => "E0503: no derivative passes through a gradient, and derivatives are wanted";
    refuses "gradient(p => p, (3, 4))" => "E0301: the function must yield a number, but it yields a point";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    if ctx.caller.is_varying(&args.f.value.0) || args.at.value.is_jet() {
        let message = "no derivative passes through a gradient, and derivatives are wanted";
        return Diagnostic::error(Code::NoDerivative, args.f.span, message)
            .label("so of second derivatives there are differences only")
            .hint("let the outer `gradient` take them: `gradient(f, at, differences = true)`")
            .fail();
    }
    let unknowns = Unknowns::new(&args.at)?;
    let (mut dim, span) = (CommonDimension::default(), args.f.span);
    if args.differences {
        let slopes = by_differences(ctx, &args.f, &unknowns, &mut dim)?;
        return quotient(&unknowns, &slopes, dim.dimension(), span);
    }
    let found = unknowns.with_gradients(&unknowns.values, |place| {
        let found = number(&asked(ctx, &args.f.value, place)?, span)?;
        take(&mut dim, found.looked_at(), span, || place.looked_at().to_string())?;
        Ok(vec![found.value])
    })?;
    let slopes = found.gradients.unwrap_or_default().concat();
    quotient(&unknowns, &slopes, dim.dimension(), span)
}

/// The derivatives with their dimensions.
fn quotient(unknowns: &Unknowns, slopes: &[f64], dim: Dimension, span: Span) -> Result<Value> {
    unknowns.over(slopes, dim).ok_or_else(|| {
        let message = "the dimension of a derivative has powers that are too high";
        Box::new(Diagnostic::error(Code::UnitMismatch, span, message))
    })
}

/// The derivatives by differences.
fn by_differences(
    ctx: &mut Ctx<'_>,
    f: &Spanned<Callback>,
    unknowns: &Unknowns,
    dim: &mut CommonDimension,
) -> Result<Vec<f64>> {
    let values = &unknowns.values;
    let largest = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let mut slopes = Vec::with_capacity(values.len());
    for (idx, &at) in values.iter().enumerate() {
        // An unknown that is zero is as large as the others.
        let size = [at.abs(), largest, 1.0].into_iter().find(|size| 0.0 < *size).unwrap_or(1.0);
        let mut most = 0.0_f64;
        let mut ask = |at: f64| -> Result<f64> {
            let mut moved = values.clone();
            moved[idx] = at;
            let place = unknowns.with(&moved);
            let found = number(&asked(ctx, &f.value, &place)?, f.span)?;
            take(dim, found.looked_at(), f.span, || place.to_string())?;
            most = most.max(found.value.value().abs());
            Ok(found.value.value())
        };
        let Slope { value, error } = find_slope(&mut ask, at, SLOPE_STEP_RELATIVE * size)?;
        let is_settled = error <= SLOPE_RELATIVE * value.abs().max(most / size);
        if !is_settled {
            let place = unknowns.rounded(values);
            let message = format!("the differences do not settle at {place}");
            let off = six_digits(error, None);
            return Diagnostic::error(Code::NoDerivative, f.span, message)
                .label(format!("a derivative of {} may be off by {off}", six_digits(value, None)))
                .hint("the function has a kink or a step there, or few digits: what it makes may be within a tolerance")
                .fail();
        }
        slopes.push(value);
    }
    Ok(slopes)
}
