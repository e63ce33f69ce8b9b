//! `planar_mesh`: the region within a closed curve.

use crate::{
    diag::{Result, Span, Spanned},
    kernel::{
        self, Bounds, Curve, GeomError, Mesh, PictureError, tessellate_curve_any,
        tolerance::DEFAULT_CHORD_RELATIVE,
    },
    ops::positive,
    value::{At, Ctx, FromValue, Length, Mismatch, Type, Value, op},
};

op! {
    /// Mesh of the plane region within a closed curve, or within the first of a list and outside of
    /// the others, which are holes.
    ///
    /// The normals are on the side from which the (outer) curve runs counter-clockwise. All vertices
    /// are on the borders, whose polygons are nowhere further from the curves than the tolerance;
    /// their triangles are as far from slivers as that allows.
    /// Chew, *Constrained Delaunay triangulations*, Algorithmica 4 (1989).
    planar_mesh in Mesh -> Mesh {
        /// The closed curve, or a list of the outer one and the holes.
        curve: Spanned<Borders>,
        /// The tolerance; when left out a thousandth of the size of the region.
        tolerance: Option<Spanned<Length>>,
    }
    example "planar_mesh(polyline([(0, 0), (4, 0), (4, 3), (0, 3)], closed = true))" => "mesh of 4 vertices and 2 triangles";
    example "planar_mesh([polyline([(0, 0), (4, 0), (4, 4), (0, 4)], closed = true), polyline([(1, 1), (3, 1), (3, 3), (1, 3)], closed = true)])" => "mesh of 8 vertices and 8 triangles";
    refuses "planar_mesh(line((0, 0), (1, 0)))" => "E0607: the curve is not closed: its ends are 1 apart";
    refuses "planar_mesh([circle((0, 0), 1), circle((5, 0), 1)])" => "E0607: `curves[1]` is no hole: it does not lie within `curves[0]`";
    refuses "planar_mesh(helix((0, 0), 2, 3, 1))" => "E0607: the curve is not closed: its ends are 3 apart";
    picture "planar_mesh([circle((0, 0), 3), circle((1, 0), 1)], tolerance = 0.02)";
}

/// One curve or several.
#[derive(Clone)]
struct Borders(Vec<Curve>);

impl FromValue for Borders {
    const TYPE: Type = Type::OneOf(&[Type::Curve, Type::List(&Type::Curve, 1)]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Curve(curve) => Ok(Self(vec![curve.clone()])),
            Value::List(items) if !items.is_empty() => Vec::from_value(value, span).map(Self),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Mesh> {
    let (span, curves) = (args.curve.span, &args.curve.value.0);
    let mut whole: Option<Bounds> = None;
    for curve in curves {
        let bounds = curve.bounds().at(span)?;
        whole = Some(whole.map_or(bounds, |whole| whole.union(bounds)));
    }
    let size = whole.map_or(0.0, Bounds::diagonal);
    let tolerance = match args.tolerance {
        Some(tolerance) => positive("the tolerance", tolerance)?,
        None => DEFAULT_CHORD_RELATIVE * if 0.0 < size { size } else { 1.0 },
    };
    let distance = ctx.tolerance.distance_for(size);
    let mut polygons = Vec::with_capacity(curves.len());
    for (index, curve) in curves.iter().enumerate() {
        let mut points =
            tessellate_curve_any(curve, tolerance, ctx.limits.mesh_vertices).at(span)?;
        let gap = match points[..] {
            [first, .., last] => first.distance(last),
            _ => f64::INFINITY,
        };
        if distance < gap {
            let error = PictureError::Open { index, of: curves.len(), gap };
            return Err(GeomError::from(error)).at(span);
        }
        points.pop();
        polygons.push(points);
    }
    kernel::planar_mesh(&polygons, distance).at(span)
}
