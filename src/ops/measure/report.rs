//! `report`: what a construction did.

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{ConstructionReport, Curve, Surface},
    value::{Ctx, Geometry, IntoValue, Value, op},
};

op! {
    /// What was done to make a curve or surface, as a record: the `operation`, and what its result
    /// does not show, such as deviations with their places, parameters, gaps and whatever was
    /// reversed, reordered or refitted.
    ///
    /// Fits leave a report (`interpolate`, `approximate`), constructions through curves (networks,
    /// skins, sweeps), offsets, and edits within a tolerance. It belongs to the result of that one
    /// operation: whatever is made of the result has no report, or its own.
    /// A `deviation` is `{max, mean, at}` with `at` the parameter where it is largest; of one that
    /// is proven instead of measured only its bound is told.
    report in Measure -> Value {
        /// A curve or surface as a construction returned it, or a list of them.
        g: Spanned<Geometry>,
    }
    example "report(interpolate((0, 0), (1, 1), (2, 0))).parameters" => "[0, 0.5, 1]";
    example "report(reduce(bezier((0, 0), (1, 0.02), (2, 0)), 0.02)).degree" => "1";
    refuses "report(line((0, 0), (1, 2)))" => "E0306: this is a curve that no construction with a report returned";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let place = |mistake: MissingReport| mistake.diagnostic(args.g.span);
    reported(&args.g.value.0).map_err(place)
}

/// A value without a report.
struct MissingReport(Value);

impl MissingReport {
    fn diagnostic(self, span: Span) -> Box<Diagnostic> {
        let what = self.0.phrase();
        let message = match self.0 {
            Value::Curve(_) | Value::Surface(_) => {
                format!("this is {what} that no construction with a report returned")
            }
            _ => format!("{what} has no report: only curves and surfaces do"),
        };
        let hint = "fits, networks, skins, sweeps, offsets and edits within a tolerance leave one; \
                    what is made of their result does not have it";
        Box::new(
            Diagnostic::error(Code::NoField, span, message).label("without a report").hint(hint),
        )
    }
}

fn reported(value: &Value) -> std::result::Result<Value, MissingReport> {
    let report: Option<&ConstructionReport> = match value {
        Value::List(items) => {
            return Ok(Value::list(
                items.iter().map(reported).collect::<std::result::Result<_, _>>()?,
            ));
        }
        Value::Curve(Curve::Nurbs(curve)) => curve.report(),
        Value::Surface(Surface::Nurbs(surface)) => surface.report(),
        _ => None,
    };
    report.map(IntoValue::into_value).ok_or_else(|| MissingReport(value.clone()))
}
