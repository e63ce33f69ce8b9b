//! `deviation` of points, of a mesh or of a surface from a surface or a mesh.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{Deviation, DeviationReference, Mesh, MeshDistance, Surface},
    value::{At, Ctx, FromValue, IntoValue, Length, Mismatch, Record, Type, Value, op},
};

op! {
    /// How far a surface, a mesh, or points are from a surface or a mesh: `{max, mean, at}`.
    ///
    /// Of each place the distance to the nearest of `b` counts, whatever the parameters are; `at` is
    /// the place that is farthest. Of a surface places are taken evenly in its parameters, and from
    /// the farthest of them a search goes on uphill. What is missing of `b` on the other side shows in
    /// `deviation(b, a)`. Of a mesh the vertices, the middles of edges and triangles are places; from
    /// the farthest triangles the search goes on inside of them, and the mean is that of the area.
    /// From a mesh the distance is that to its nearest triangle.
    deviation in Measure -> Record {
        /// The surface, the mesh, or the points.
        a: Spanned<MeasuredGeometry>,
        /// The surface or the mesh from which they are measured.
        b: Spanned<DeviationBase>,
    }
    example "deviation(bilinear((0, 0, 1), (0, 1, 1), (1, 0, 1), (1, 1, 2)), bilinear((0, 0), (0, 1), (1, 0), (1, 1))).max" => "2";
    example "deviation(bilinear((0, 0, 1), (0, 1, 1), (1, 0, 1), (1, 1, 2)), tessellate(bilinear((0, 0), (0, 1), (1, 0), (1, 1)))).max" => "2";
    example "deviation([(0, 0, 1), (1, 1, 3)], bilinear((0, 0), (0, 1), (1, 0), (1, 1)))" => "{max: 3, mean: 2, at: (1, 1, 3)}";
}

/// What can be measured from a surface.
enum MeasuredGeometry {
    Surface(Surface),
    Mesh(Arc<Mesh>),
    Points(Vec<DVec3>),
}

impl FromValue for MeasuredGeometry {
    const TYPE: Type = Type::OneOf(&[Type::Surface, Type::Mesh, Type::List(&Type::Point, 1)]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Surface(surface) => Ok(Self::Surface(surface.clone())),
            Value::Mesh(mesh) => Ok(Self::Mesh(Arc::clone(mesh))),
            Value::List(items) if !items.is_empty() => {
                Vec::from_value(value, span).map(Self::Points)
            }
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

/// What can be measured from.
enum DeviationBase {
    Surface(Surface),
    Mesh(Arc<Mesh>),
}

impl FromValue for DeviationBase {
    const TYPE: Type = Type::OneOf(&[Type::Surface, Type::Mesh]);

    fn from_value(value: &Value, _: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Surface(surface) => Ok(Self::Surface(surface.clone())),
            Value::Mesh(mesh) => Ok(Self::Mesh(Arc::clone(mesh))),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let nothing = |span: Span| {
        let message =
            "there is nothing to measure: expected one point or triangle at least, found none";
        Diagnostic::error(Code::TooFewPoints, span, message).fail()
    };
    let datum = match &args.b.value {
        DeviationBase::Surface(surface) => {
            DeviationReference::of_surface(surface).at(args.b.span)?
        }
        DeviationBase::Mesh(mesh) => match MeshDistance::new(mesh) {
            Some(nearest) => DeviationReference::Mesh(nearest),
            None => return nothing(args.b.span),
        },
    };
    let found = match &args.a.value {
        MeasuredGeometry::Surface(a) => a.deviation_from(&datum).map(Some),
        MeasuredGeometry::Mesh(mesh) => mesh.deviation_from(&datum),
        MeasuredGeometry::Points(points) => datum.deviation_of(points),
    };
    let Some(Deviation { max, mean, at }) = found.at(ctx.span)? else {
        return nothing(args.a.span);
    };
    Ok(Record::new([
        (Arc::from("max"), Length(max).into_value()),
        (Arc::from("mean"), Length(mean).into_value()),
        (Arc::from("at"), Value::Point(at)),
    ]))
}
