//! `intersect` a surface with another, or with a curve.

use std::sync::Arc;

use super::lines;
use crate::{
    diag::{Result, Span},
    kernel::{LevelSet, NurbsCurve, Surface, SurfaceCurve},
    ops::{
        face::{RealSurfaceOrFace, SurfaceOrFace},
        measure::{curve::varying::no_derivative, piercing::pierced},
    },
    value::{At, Ctx, FromValue, IntoValue, Mismatch, RealCurve, Type, Value, op},
};

op! {
    /// Curves in which two surfaces cross; or the places of a curve on a surface, as
    /// `[{t, u, v, point}]` in the order of `t`.
    ///
    /// Found completely, by halving pairs of parts until they are apart or cross in one arc at most,
    /// which is then followed: no loop is too small. Curves are exact lines and conics
    /// where a plane or another sphere cuts a plane, sphere, cylinder or cone, and cubic splines within
    /// the document's tolerance of both surfaces elsewhere, parametrized about by their length; they
    /// run along the product of the normal of `a` and that of `b`. They end at boundaries, and where several cross, as surfaces
    /// do where they touch. Neighbours meet in the edge that they share, which is among the curves as it
    /// is. A line along which they only touch is among the curves, and a warning
    /// tells of it, and of a touch in a single point, as of a corner. An edge that comes within the tolerance of
    /// the other surface without reaching it is told by such a warning alone. Surfaces that share an area are an error, and so
    /// is a curve that lies in the surface for a stretch. A parametric surface is taken as a spline
    /// within a part of the tolerance. `report` of a curve tells whether it is proven, and how far from both surfaces it may be.
    /// Where a curve crosses clearly, inside of both, derivatives pass through.
    /// Sederberg & Meyers, *Loop detection in surface patch intersections*, CAGD 5 (1988);
    /// Ye & Maekawa, *Differential geometry of intersection curves of two surfaces*, CAGD 16 (1999).
    intersect in Measure -> Vec<Value> {
        /// A surface or face.
        a: RealSurfaceOrFace,
        /// Another surface or face, or a curve.
        b: SurfacePartner,
    }
    example "[for c in intersect(sphere((0, 0), 5), plane_patch((-9, -9, 3), (18, 0), (0, 18))): length(c)] ~= [8 * pi] within 1e-5" => "true";
    example "len(intersect(cylinder((0, 0, -3), 1, 6), cylinder((-3, 0), 0.5, 6, axis = (1, 0, 0))))" => "2";
    example "intersect(sphere((0, 0), 1), sphere((5, 0), 1))" => "[]";
    example "[for c in intersect(plane_patch((0, 0), (1, 0), (0, 1)), plane_patch((1, 0), (1, 0), (0, 1))): c.points]" => "[[(1, 0, 0), (1, 1, 0)]]";
    refuses "intersect(plane_patch((0, 0), (2, 0), (0, 2)), plane_patch((1, 1), (2, 0), (0, 2)))" => "E0607: the surfaces run together near (1, 1, 0): they share more than curves there";
    scene r#"
        surface a = cylinder((0, 0, -3), 1, 6) with (color = "lightgray")
        surface b = cylinder((-3, 0), 0.8, 6, axis = (1, 0, 0)) with (color = "lightgray")
        curves lines = intersect(a, b) with (color = "red")
    "#;
}

/// What a surface meets.
#[derive(Clone)]
enum SurfacePartner {
    Curve(RealCurve),
    Surface(RealSurfaceOrFace),
}

impl FromValue for SurfacePartner {
    const TYPE: Type = Type::OneOf(&[Type::Surface, Type::Face, Type::Curve]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Curve(_) | Value::JetCurve(_) => {
                RealCurve::from_value(value, span).map(Self::Curve)
            }
            Value::Surface(_) | Value::JetSurface(_) | Value::Face(_) => {
                RealSurfaceOrFace::from_value(value, span).map(Self::Surface)
            }
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

/// A curve with what is known of it as one of both surfaces.
fn reported(curve: NurbsCurve, surfaces: [&Surface; 2], ctx: &Ctx<'_>) -> NurbsCurve {
    const OPERATION: &str = "intersect";
    match surfaces.map(Surface::nurbs) {
        [Ok(a), Ok(b)] => {
            let both = [a, b].map(Arc::clone);
            SurfaceCurve::reported(curve, both, ctx.tolerance, OPERATION)
        }
        _ => SurfaceCurve::reported_without_proof(curve, OPERATION),
    }
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Value>> {
    match &args.b {
        SurfacePartner::Surface(other)
            if args.a.real().varied().is_some() || other.real().varied().is_some() =>
        {
            no_derivative("`intersect` of surfaces", ctx.span)
        }
        SurfacePartner::Surface(other) => {
            let set = args.a.intersections(other, ctx.tolerance).at(ctx.span)?;
            let set = on_faces(set, [&args.a, other], ctx);
            let curves = lines(ctx, set, "the surfaces touch");
            let curves = other.clipped(args.a.clipped(curves, ctx)?, ctx)?;
            let told = |curve| reported(curve, [&args.a, other], ctx);
            Ok(curves.into_iter().map(|curve| told(curve).into_value()).collect())
        }
        SurfacePartner::Curve(curve) => {
            let records = pierced(ctx, curve, &args.a)?;
            Ok(records.into_iter().map(IntoValue::into_value).collect())
        }
    }
}

/// The same without the touches that are on no face.
fn on_faces(mut set: LevelSet, parts: [&SurfaceOrFace; 2], ctx: &Ctx<'_>) -> LevelSet {
    let is_on = |point: &glam::DVec3| {
        parts.iter().all(|part| {
            !part.is_face()
                || part.closest(*point).is_ok_and(|foot| part.has(foot.parameters, ctx.tolerance))
        })
    };
    set.touches.retain(is_on);
    set.contacts.retain(is_on);
    set.uncertain.retain(is_on);
    set
}
