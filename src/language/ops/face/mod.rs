//! Parts of surfaces.

mod centroid;
mod closest;
mod contains;
mod continuity;
mod edges;
mod flip;
mod inertia;
mod length;
mod of_region;
mod of_surface;
mod offset;
mod split;
mod trim;

use std::{ops::Deref, sync::Arc};

use super::region::Border;
use crate::{
    diag::{Result, Span},
    kernel::{
        Cutter, Direction, Face, GeomError, NurbsCurve, Solid, Surface, SurfacePiece, Tolerance,
    },
    value::{At, Ctx, FromValue, IntoValue, Mismatch, Op, RealSurface, Type, Value},
};

pub(super) static OPS: &[&Op] = &[
    &of_surface::OP,
    &of_region::OP,
    &split::OP,
    &trim::OP,
    &edges::OP,
    &length::OP,
    &centroid::OP,
    &inertia::OP,
    &closest::OP,
    &contains::OP,
    &flip::OP,
    &offset::OP,
    &continuity::OP,
];

/// A surface, or a part of one: what is asked at parameters.
#[derive(Clone)]
pub(super) struct SurfaceOrFace {
    surface: Surface,
    face: Option<Arc<Face>>,
}

/// All that is asked of a surface is asked of that of a face.
impl Deref for SurfaceOrFace {
    type Target = Surface;

    fn deref(&self) -> &Surface {
        &self.surface
    }
}

impl FromValue for SurfaceOrFace {
    const TYPE: Type = Type::OneOf(&[Type::Surface, Type::Face]);

    fn from_value(value: &Value, _: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Surface(surface) => Ok(Self { surface: surface.clone(), face: None }),
            Value::Face(face) => {
                let surface = Surface::Nurbs(Arc::clone(face.surface()));
                Ok(Self { surface, face: Some(Arc::clone(face)) })
            }
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

impl IntoValue for SurfaceOrFace {
    const RETURNS: Type = Self::TYPE;

    fn into_value(self) -> Value {
        match self.face {
            Some(face) => Value::Face(face),
            None => Value::Surface(self.surface),
        }
    }
}

impl SurfaceOrFace {
    /// It as what the kernel takes in its place.
    pub(super) fn piece(&self) -> SurfacePiece<'_> {
        match &self.face {
            Some(face) => SurfacePiece::Part(face),
            None => SurfacePiece::Whole(&self.surface),
        }
    }

    /// The same with its normal turned around.
    ///
    /// # Errors
    /// Those of [`Surface::reversed`].
    pub(super) fn flipped(&self) -> std::result::Result<Self, GeomError> {
        match &self.face {
            Some(face) => {
                let face = face.reversed();
                let surface = Surface::Nurbs(Arc::clone(face.surface()));
                Ok(Self { surface, face: Some(Arc::new(face)) })
            }
            None => Ok(Self { surface: self.surface.reversed(Direction::V)?, face: None }),
        }
    }

    /// # Errors
    /// Parameters outside of the face, by more than the usual tolerance.
    pub(super) fn check_inside(&self, parameters: [f64; 2], span: Span) -> Result<()> {
        let Some(face) = &self.face else { return Ok(()) };
        face.check_inside(parameters, Tolerance::DEFAULT.distance).at(span)
    }

    /// Whether it is a part of a surface.
    pub(super) fn is_face(&self) -> bool {
        self.face.is_some()
    }

    /// It as a face.
    ///
    /// # Errors
    /// A parametric surface.
    pub(super) fn face(&self, span: Span, tolerance: Tolerance) -> Result<Arc<Face>> {
        match &self.face {
            Some(face) => Ok(Arc::clone(face)),
            None => {
                let surface = self.surface.nurbs().at(span)?;
                Face::whole(Arc::clone(surface), tolerance).map(Arc::new).at(span)
            }
        }
    }

    /// What of curves on the surface is on the face.
    pub(super) fn clipped(
        &self,
        curves: Vec<NurbsCurve>,
        ctx: &Ctx<'_>,
    ) -> Result<Vec<NurbsCurve>> {
        match &self.face {
            Some(face) => face.clipped(&curves, ctx.tolerance).at(ctx.span),
            None => Ok(curves),
        }
    }

    /// Whether a place of the surface is on the face.
    pub(super) fn has(&self, parameters: [f64; 2], tolerance: Tolerance) -> bool {
        self.face.as_ref().is_none_or(|face| face.has(parameters, tolerance))
    }
}

/// A surface or a part of one, as [`SurfaceOrFace`]; a surface may carry derivatives.
#[derive(Clone)]
pub(super) struct RealSurfaceOrFace {
    plain: SurfaceOrFace,
    real: RealSurface,
}

/// It without derivatives.
impl Deref for RealSurfaceOrFace {
    type Target = SurfaceOrFace;

    fn deref(&self) -> &SurfaceOrFace {
        &self.plain
    }
}

impl FromValue for RealSurfaceOrFace {
    const TYPE: Type = SurfaceOrFace::TYPE;

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        let plain = SurfaceOrFace::from_value(&value.looked_at(), span)?;
        let real = match value {
            Value::JetSurface(varied) => Arc::clone(varied).into(),
            _ => plain.surface.clone().into(),
        };
        Ok(Self { plain, real })
    }
}

impl RealSurfaceOrFace {
    /// The whole surface, with its derivatives.
    pub(super) fn real(&self) -> &RealSurface {
        &self.real
    }
}

/// What divides a face: a curve on it, a plane, a surface or face, or a list of them.
struct Cutters {
    cutters: Vec<Cutter>,
    /// The only one, if it is a solid.
    solid: Option<Arc<Solid>>,
}

impl FromValue for Cutters {
    const TYPE: Type = Type::OneOf(&[
        Type::Plane,
        Type::Surface,
        Type::Face,
        Type::Curve,
        Type::Solid,
        Type::List(
            &Type::OneOf(&[Type::Plane, Type::Surface, Type::Face, Type::Curve, Type::Solid]),
            1,
        ),
    ]);

    fn from_value(value: &Value, _: Span) -> std::result::Result<Self, Mismatch> {
        let failed = |err: crate::kernel::GeomError| {
            Mismatch::new("a curve, plane or surface that can cut", err.to_string())
        };
        let cutter = |value: &Value| {
            Ok(match value {
                Value::Frame(plane) => Cutter::Plane(**plane),
                Value::Face(face) => Cutter::Face(Arc::clone(face)),
                Value::Solid(solid) => Cutter::Faces(solid.faces().into()),
                Value::Surface(surface) => {
                    Cutter::Surface(Arc::clone(surface.nurbs().map_err(failed)?))
                }
                Value::Curve(curve) => Cutter::Curve((*curve.spline().map_err(failed)?).clone()),
                _ => return Err(Mismatch::kind(Self::TYPE, value)),
            })
        };
        match value {
            Value::List(items) if !items.is_empty() => {
                let cutters: Vec<Cutter> =
                    items.iter().map(cutter).collect::<std::result::Result<_, _>>()?;
                let solid = match items.iter().next() {
                    Some(Value::Solid(solid)) if cutters.len() == 1 => Some(Arc::clone(solid)),
                    _ => None,
                };
                Ok(Self { cutters, solid })
            }
            single => {
                let solid = match single {
                    Value::Solid(solid) => Some(Arc::clone(solid)),
                    _ => None,
                };
                Ok(Self { cutters: vec![cutter(single)?], solid })
            }
        }
    }
}

/// The closed curves that bound a part of a surface.
fn loops(borders: &[Border], span: Span, ctx: &Ctx<'_>) -> Result<Vec<NurbsCurve>> {
    borders.iter().map(|border| border.curve(span, ctx)).collect()
}
