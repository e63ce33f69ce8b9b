//! `principal` of a surface: the principal curvatures.

use std::sync::Arc;

use super::varying::{self, Varying};
use crate::{
    diag::{Result, Spanned},
    kernel::Principal,
    ops::{face::RealSurfaceOrFace, measure::Measured},
    value::{At, Ctx, IntoValue, LengthPower, Real, Record, Vector, op},
};

op! {
    /// Principal curvatures of a surface, `k1` ≤ `k2`, and their directions `d1`, `d2`, unit vectors of
    /// the tangent plane.
    ///
    /// A curvature is positive where its centre lies on the side of Su × Sv. The directions are at right angles,
    /// d1 to the side of Su and d2 = normal × d1. At an umbilic both curvatures are equal and every
    /// direction is a principal one: d1 is then that of Su.
    ///
    /// do Carmo, *Differential Geometry of Curves and Surfaces*, §3-2.
    principal in Measure -> Record {
        /// The surface, or a part of one.
        s: RealSurfaceOrFace,
        /// The first parameter, inside its domain.
        u: Spanned<Real>,
        /// The second parameter.
        v: Spanned<Real>,
    }
    example "principal(cylinder((0, 0), 2, 1), 0, 0.5).d1" => "(0, 1, 0)";
    example "principal(parametric((u, v) => (2*cos(u), 2*sin(u), v), 0..tau, 0..1), 0, 0.5)" => "{k1: -0.5, k2: 0, d1: (0, 1, 0), d2: (0, 0, 1)}";
    refuses "principal(cone((0, 0), 3, 0, 4), 0, 1)" => "E0607: there is no curvature at (0, 1): Su × Sv vanishes there, and the curvatures around have no common limit";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let ([u, v], varying) = varying::place(&args.s, [&args.u, &args.v], 2, None, ctx.span)?;
    let plain = args.s.shape_at(u, v).at(ctx.span)?.principal(ctx.tolerance);
    let Principal { k1, k2, d1, d2 } = plain;
    let mut found = ([k1, k2].map(Real::Plain), [d1, d2].map(Vector::Plain));
    if let Some(at) = varying {
        found = with_derivatives(&at, plain).at(ctx.span)?;
    }
    let ([k1, k2], [d1, d2]) = found;
    Ok(Record::new([
        (Arc::from("k1"), LengthPower::<-1, _>(k1).into_value()),
        (Arc::from("k2"), LengthPower::<-1, _>(k2).into_value()),
        (Arc::from("d1"), d1.into_value()),
        (Arc::from("d2"), d2.into_value()),
    ]))
}

fn with_derivatives(
    at: &Varying,
    Principal { k1, k2, d1, d2 }: Principal,
) -> Measured<([Real; 2], [Vector; 2])> {
    let forms = at.forms()?;
    let [first, second] = forms.principal()?;
    let one = forms.principal_direction(at, &first, d1)?.with_value(d1);
    let other = forms.principal_direction(at, &second, d2)?.with_value(d2);
    Ok(([first.with_value(k1), second.with_value(k2)], [one, other]))
}
