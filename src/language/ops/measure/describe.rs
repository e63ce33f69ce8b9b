//! `describe`: all data of a value as a record.

use std::{f64::consts::TAU, sync::Arc};

use glam::DVec3;

use crate::{
    diag::{Result, Span, Spanned},
    kernel::{
        AnalyticCurve, AnalyticForm, Edge, FormError, GeomError, NurbsCurve, NurbsSurface,
        SurfaceDefects, Tolerance,
    },
    value::{At, Ctx, FromValue, IntoValue, Mismatch, Record, Type, Value, field, field_names, op},
};

op! {
    /// All data of geometry, of a mesh or of a table, under the names of its fields and after its
    /// `kind`; a list element by element.
    ///
    /// A curve also tells its `order`, degree + 1, the `count` of its control points, and the class of
    /// its knots as `knot_class` does; a table
    /// the `count` of its rows. `form` is what a curve or surface is whatever made it or was done to it
    /// since, as far as its coefficients prove it: `"line"`, `"circle"`, `"arc"`; of a surface the quadric
    /// that it lies on, `"plane"`, `"sphere"`, `"cylinder"`, `"cone"`, `"ellipsoid"`, `"elliptic paraboloid"`,
    /// `"hyperbolic paraboloid"`, `"hyperboloid of one sheet"`, `"hyperboloid of two sheets"`,
    /// `"elliptic cylinder"`, `"hyperbolic cylinder"`, `"parabolic cylinder"`, `"elliptic cone"`, or a
    /// `"torus"` of which it covers a part once; otherwise `none`. The equation is proven to hold at all
    /// points, up to rounding; where several kinds are as near, the one with the fewest terms is told. A parametric curve or surface has no control points to tell.
    ///
    /// A surface tells both numbers for u and for v, and where it is not regular: the edges that are
    /// `collapsed` to a point, the other corners that are `singular` because Su × Sv vanishes there,
    /// and the first `folds`, where the normal turns over, each as a point of parameters (u, v): those
    /// that a grid of places shows, or else, of a NURBS surface, those that the coefficients of its
    /// normals tell, however narrow. So are its isolated `umbilics`, as far as a search from that grid comes to them:
    /// there it bends equally in all directions.
    describe in Measure -> Value {
        /// A point, curve, surface, mesh, plane or table, or a list of them.
        g: Spanned<Described>,
    }
    example "describe(line((0, 0), (1, 2))).knots" => "[0, 0, 1, 1]";
    example "describe(bilinear((0, 0), (0, 0), (1, 0), (1, 1))).collapsed" => "[\"u0\"]";
    example "describe(elevate(circle((0, 0), 2), 4)).form" => "\"circle\"";
    example "describe(revolve(line((1, 0), (2, 0, 3)))).form" => "\"cone\"";
    example "describe(bilinear((0, 0, 0), (0, 1, 1), (1, 0, 1), (1, 1, 0))).form" => "\"hyperbolic paraboloid\"";
    example "describe(scale(sphere((0, 0, 0), 1), (1, 2, 3))).form" => "\"ellipsoid\"";
    example "describe((1, 2))" => "{kind: \"point\", x: 1, y: 2, z: 0}";
}

/// Whatever has data to list.
struct Described(Value);

impl FromValue for Described {
    const TYPE: Type = Type::OneOf(&[Type::Geometry, Type::Table]);

    #[expect(clippy::only_used_in_recursion, reason = "the trait hands in the place")]
    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::List(items) => {
                for (idx, item) in items.iter().enumerate() {
                    Self::from_value(item, span).map_err(|mismatch| mismatch.inside(idx))?;
                }
            }
            _ if Self::TYPE.accepts(value) => {}
            _ => return Err(Mismatch::kind(Self::TYPE, value)),
        }
        Ok(Self(value.clone()))
    }
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    described(&args.g.value.0, ctx.tolerance, args.g.span)
}

fn described(value: &Value, tolerance: Tolerance, span: Span) -> Result<Value> {
    if let Value::List(items) = value {
        let items = items.iter().map(|item| described(item, tolerance, span));
        return Ok(Value::list(items.collect::<Result<_>>()?));
    }
    let mut fields = vec![(Arc::from("kind"), Value::text(value.kind()))];
    let names = field_names(value);
    let mut data = Vec::with_capacity(names.len());
    for name in names {
        match field(value, name, tolerance) {
            Err(GeomError::Form(FormError::NotNurbs { .. })) => {}
            datum => data.extend(datum.at(span)?.map(|datum| (Arc::from(name), datum))),
        }
    }
    match value {
        Value::Table(table) => {
            fields.push((Arc::from("count"), Value::number(table.n_rows() as f64)));
            // Columns may have any name, so they stand in a record of their own.
            fields.push((Arc::from("columns"), Value::Record(Arc::new(Record::new(data)))));
        }
        Value::Curve(curve) => {
            if let Ok(curve) = curve.nurbs() {
                let (order, count) = (curve.degree() + 1, curve.control_points().len());
                fields.push((Arc::from("order"), Value::number(order as f64)));
                fields.push((Arc::from("count"), Value::number(count as f64)));
                let class = curve.knots().class().word();
                fields.push((Arc::from("knot_class"), Value::text(class)));
                fields.push((
                    Arc::from("form"),
                    form_of_curve(curve).map_or(Value::None, Value::text),
                ));
            }
            fields.extend(data);
        }
        Value::Surface(surface) => {
            if let Ok(nurbs) = surface.nurbs() {
                let (net, degrees) = (nurbs.control_points(), [nurbs.degree_u(), nurbs.degree_v()]);
                let counts = vec![net.n_rows(), net.n_columns()];
                let orders = degrees.map(|degree| degree + 1).to_vec();
                fields.push((Arc::from("order"), orders.into_value()));
                fields.push((Arc::from("count"), counts.into_value()));
                let form = form_of_surface(nurbs, tolerance);
                fields.push((Arc::from("form"), form.map_or(Value::None, Value::text)));
            }
            fields.extend(data);
            let defects = surface.defects(tolerance).at(span)?;
            let umbilics = surface.umbilics(&defects, tolerance).at(span)?;
            let SurfaceDefects { collapsed, corners, folds } = defects;
            let places = |places: Vec<[f64; 2]>| -> Vec<DVec3> {
                places.into_iter().map(|[u, v]| DVec3::new(u, v, 0.0)).collect()
            };
            let words: Vec<&str> = collapsed.into_iter().map(Edge::word).collect();
            fields.push((Arc::from("collapsed"), words.into_value()));
            fields.push((Arc::from("singular"), places(corners).into_value()));
            fields.push((Arc::from("folds"), places(folds).into_value()));
            fields.push((Arc::from("umbilics"), places(umbilics).into_value()));
        }
        _ => fields.extend(data),
    }
    Ok(Value::Record(Arc::new(Record::new(fields))))
}

/// The line or circle that a curve is, by name.
fn form_of_curve(curve: &NurbsCurve) -> Option<&'static str> {
    curve.analytic().map(|found| match found {
        AnalyticCurve::Line { .. } => "line",
        AnalyticCurve::Circle { turn, .. } if TAU <= turn => "circle",
        AnalyticCurve::Circle { .. } => "arc",
    })
}

/// The torus or quadric that a surface is on, by name.
fn form_of_surface(surface: &NurbsSurface, tolerance: Tolerance) -> Option<&'static str> {
    match surface.quadric() {
        Some(kind) => Some(kind.word()),
        None => {
            let found = surface.analytic(tolerance.distance)?;
            matches!(found.form, AnalyticForm::Torus { .. }).then_some("torus")
        }
    }
}
