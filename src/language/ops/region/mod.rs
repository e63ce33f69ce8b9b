//! Plane regions.

mod area;
mod centroid;
mod closest;
mod contains;
mod difference;
mod fillet;
pub(super) mod inertia;
mod intersection;
mod length;
mod of_curves;
mod offset;
mod planar_mesh;
mod regions;
mod union;

use std::sync::Arc;

use super::combined::ListedMembers;
use crate::{
    diag::{Result, Span},
    kernel::{Curve, NurbsCurve, Region, VariedCurve, join},
    value::{At, Ctx, FromValue, List, Mismatch, Op, RealCurve, Type, Value},
};

pub(super) static OPS: &[&Op] = &[
    &of_curves::OP,
    &regions::OP,
    &union::OP,
    &intersection::OP,
    &difference::OP,
    &offset::OP,
    &fillet::OP,
    &planar_mesh::OP,
    &area::OP,
    &length::OP,
    &centroid::OP,
    &inertia::OP,
    &contains::OP,
    &closest::OP,
];

/// Regions, given as a list or as the arguments themselves; lists among them count as their members.
struct Regions {
    all: Vec<Region>,
    listed: ListedMembers,
}

impl FromValue for Regions {
    const TYPE: Type = Type::List(&Type::OneOf(&[Type::Region, Type::List(&Type::Region, 0)]), 1);
    const SPREADS: bool = true;

    fn from_value(value: &Value, _: Span) -> std::result::Result<Self, Mismatch> {
        let mut found = Vec::new();
        match value {
            Value::List(items) if !items.is_empty() && gather(items, &mut found) => {
                Ok(Self { all: found, listed: ListedMembers::of(items) })
            }
            _ => {
                let mismatch = Mismatch::kind(Self::TYPE, value);
                let has = |kind: &str| match value {
                    Value::List(items) => items.iter().any(|item| item.kind() == kind),
                    _ => value.kind() == kind,
                };
                Err(match (has("curve"), has("surface")) {
                    (true, _) => mismatch.hint("`region(c)` is what lies within a closed curve"),
                    (_, true) => mismatch.hint(
                        "surfaces are not combined as solids; `intersect(a, b)` tells where two of them cross",
                    ),
                    _ => mismatch,
                })
            }
        }
    }
}

/// Adds the regions of a list; false where there is something else in it.
fn gather(items: &List, found: &mut Vec<Region>) -> bool {
    items.iter().all(|item| match item {
        Value::Region(region) => {
            found.push((**region).clone());
            true
        }
        Value::List(items) => gather(items, found),
        _ => false,
    })
}

/// A border: a closed curve, or curves that are joined to one.
#[derive(Clone)]
pub(super) struct Border(Vec<Curve>);

impl FromValue for Border {
    const TYPE: Type = Type::OneOf(&[Type::Curve, Type::List(&Type::Curve, 1)]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Curve(curve) => Ok(Self(vec![curve.clone()])),
            Value::List(items) if !items.is_empty() => Vec::from_value(value, span).map(Self),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

impl Border {
    /// The curve along it; a parametric one as the spline within 1e-13 of its size.
    pub(super) fn curve(&self, span: Span, ctx: &Ctx<'_>) -> Result<NurbsCurve> {
        let curves = nurbs(&self.0, span)?;
        match &curves[..] {
            [curve] => Ok(curve.clone()),
            _ => join(&curves, ctx.tolerance.distance).at(span),
        }
    }
}

/// A border as [`Border`], the curves of which may carry derivatives.
#[derive(Clone)]
struct RealBorder {
    plain: Border,
    real: Vec<RealCurve>,
}

impl FromValue for RealBorder {
    const TYPE: Type = Border::TYPE;

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        let real = match value {
            Value::List(items) if !items.is_empty() => Vec::from_value(value, span)?,
            _ if Border::TYPE.accepts(value) => vec![RealCurve::from_value(value, span)?],
            _ => return Err(Mismatch::kind(Self::TYPE, value)),
        };
        let plain = Border(real.iter().map(|curve| Curve::clone(curve)).collect());
        Ok(Self { plain, real })
    }
}

impl RealBorder {
    /// How many variables it depends on; none where it does on none.
    fn n_variables(&self) -> Option<usize> {
        let varied = self.real.iter().find_map(RealCurve::varied)?;
        Some(varied.slopes().n_variables())
    }

    /// Its curves with their slopes, those of fixed ones zero.
    fn varied(&self, n_variables: usize, span: Span) -> Result<Vec<VariedCurve>> {
        let curve = |curve: &RealCurve| match curve.varied() {
            Some(varied) => Ok(varied.clone()),
            None => VariedCurve::fixed(curve.spline()?, n_variables),
        };
        self.real.iter().map(curve).collect::<std::result::Result<_, _>>().at(span)
    }
}

fn nurbs(curves: &[Curve], span: Span) -> Result<Vec<NurbsCurve>> {
    let spline = |curve: &Curve| curve.spline().map(|spline| (*spline).clone());
    curves.iter().map(spline).collect::<std::result::Result<_, _>>().at(span)
}

/// The region that is asked about or changed.
type Given = Arc<Region>;
