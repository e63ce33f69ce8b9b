//! `principal` of a surface: the principal curvatures.

use std::sync::Arc;

use super::shape;
use crate::{
    diag::{Result, Spanned},
    kernel::{Principal, Surface},
    value::{Ctx, Record, Value, op},
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
        /// The surface.
        s: Surface,
        /// The first parameter, inside the surface's domain.
        u: Spanned<f64>,
        /// The second parameter.
        v: Spanned<f64>,
    }
    example "principal(cylinder((0, 0), 2, 1), 0, 0.5).d1" => "(0, 1, 0)";
    example "principal(parametric((u, v) => (2*cos(u), 2*sin(u), v), 0..tau, 0..1), 0, 0.5)" => "{k1: -0.5, k2: 0, d1: (0, 1, 0), d2: (0, 0, 1)}";
    refuses "principal(cone((0, 0), 3, 0, 4), 0, 1)" => "E0607: there is no curvature at (0, 1): Su × Sv vanishes there, and the curvatures around have no common limit";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let tolerance = ctx.tolerance;
    let Principal { k1, k2, d1, d2 } = shape(&args.s, args.u, args.v, ctx)?.principal(tolerance);
    Ok(Record::new([
        (Arc::from("k1"), Value::number(k1)),
        (Arc::from("k2"), Value::number(k2)),
        (Arc::from("d1"), Value::Point(d1)),
        (Arc::from("d2"), Value::Point(d2)),
    ]))
}
