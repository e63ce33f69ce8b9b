//! `report`: what a construction did, and what a solid is made of.

use std::sync::Arc;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{ConstructionReport, Curve, Solid, Surface},
    value::{Angle, At, Ctx, Geometry, IntoValue, Length, LengthPower, Record, Value, op},
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
    ///
    /// Of the curves that `intersect` gives of two surfaces, `section` of one, and `edges`, it tells what they are on
    /// them: the `kind` (`"crossing"`, `"border"` where a surface ends or `"contact"` where they only touch), a bound of
    /// the `deviation` from both (`none` where nothing is known), whether it is `proven` that they cross in one smooth
    /// arc within `radius` of it (of a border that the deviation is within the tolerance), its curves of parameters
    /// `on` both, over the parameter of the curve, in the plane of u and v, and what it is `between` (`"border"`,
    /// `"junction"`, `"closed"`, `"seam"`). It is found when somebody asks.
    ///
    /// Of any solid it tells what it is made of: the numbers of its `faces`, `edges`, `vertices`, `shells`, `bodies`
    /// and handles (`genus`), its `volume` and `area`, the length of its shortest edge (`least_edge`, `none` without
    /// edges), the sharpest angle between faces along an edge, inside or outside, by what 24 places of each show
    /// (`least_angle`), a bound of how far an edge is from its faces (`deviation`), how far ends of edges are apart that
    /// became one vertex (`welded`), and that it is `closed`. `volume_error` bounds what the volume may be off by: by what is known of the
    /// integral, and by what faces may miss one another within the document's tolerance along their edges.
    report in Measure -> Value {
        /// A curve or surface as a construction returned it, a solid, or a list of them.
        g: Spanned<Geometry>,
    }
    example "report(interpolate((0, 0), (1, 1), (2, 0))).parameters" => "[0, 0.5, 1]";
    example "report(reduce(bezier((0, 0), (1, 0.02), (2, 0)), 0.02)).degree" => "1";
    example "report(intersect(sphere((0, 0), 2), cylinder((1, 0, -3), 1.2, 6))[0]).proven" => "true";
    example "report(solid(box((0, 0, 0), (1, 2, 3)))).edges" => "12";
    example "report(solid([sphere((0, 0), 2), sphere((0, 0), 1)])).shells" => "2";
    refuses "report(line((0, 0), (1, 2)))" => "E0306: this is a curve that no construction with a report returned";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    reported(&args.g.value.0, args.g.span, ctx)
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
            _ => format!("{what} has no report: only curves, surfaces and solids do"),
        };
        let hint = "fits, networks, skins, sweeps, offsets and edits within a tolerance leave one; \
                    so do curves of `intersect`, `section` and `edges`; what is made of their result does not have it";
        Box::new(
            Diagnostic::error(Code::NoField, span, message).label("without a report").hint(hint),
        )
    }
}

fn reported(value: &Value, span: Span, ctx: &Ctx<'_>) -> Result<Value> {
    let report: Option<&ConstructionReport> = match value {
        Value::List(items) => {
            let reports = items.iter().map(|item| reported(item, span, ctx));
            return Ok(Value::list(reports.collect::<Result<_>>()?));
        }
        Value::Solid(solid) => return made_of(solid, span, ctx),
        Value::Curve(Curve::Nurbs(curve)) => curve.report(),
        Value::Surface(Surface::Nurbs(surface)) => surface.report(),
        _ => None,
    };
    let missing = || MissingReport(value.clone()).diagnostic(span);
    report.map(IntoValue::into_value).ok_or_else(missing)
}

/// What a solid is made of.
fn made_of(solid: &Solid, span: Span, ctx: &Ctx<'_>) -> Result<Value> {
    let found = solid.contents(ctx.tolerance).at(span)?;
    let count = |n: usize| Value::number(n as f64);
    let entries = [
        ("faces", count(found.n_faces)),
        ("edges", count(found.n_edges)),
        ("vertices", count(found.n_vertices)),
        ("shells", count(found.n_shells)),
        ("bodies", count(found.n_bodies)),
        ("genus", Value::number(found.genus as f64)),
        ("closed", Value::Bool(true)),
        ("volume", LengthPower::<3>(found.volume).into_value()),
        ("volume_error", LengthPower::<3>(found.volume_error).into_value()),
        ("area", LengthPower::<2>(found.area).into_value()),
        ("least_edge", found.least_edge.map_or(Value::None, |length| Length(length).into_value())),
        ("least_angle", found.least_angle.map_or(Value::None, |angle| Angle(angle).into_value())),
        ("deviation", found.deviation.map_or(Value::None, |length| Length(length).into_value())),
        ("welded", Length(found.welded).into_value()),
    ];
    Ok(Record::new(entries.map(|(name, value)| (Arc::from(name), value))).into_value())
}
