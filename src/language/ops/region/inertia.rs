//! `inertia` of a region.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use crate::{
    diag::Result,
    kernel::principal_axes,
    ops::measure::{MassOf, varying_inertia},
    value::{At, Ctx, IntoValue, LengthPower, Real, RealRegion, Record, op, with_slopes},
};

op! {
    /// Inertia of a region about its centroid, of a skin with density one: `{tensor, moments, axes}` as
    /// for surfaces. The moments in the plane are those by which a beam of this section resists
    /// bending.
    inertia in Region -> Record {
        /// The region.
        r: RealRegion,
    }
    example "inertia(region(circle((0, 0), 2))).moments ~= [4*pi, 4*pi, 8*pi] within 1e-10" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let tensor = args.r.plain().mass().inertia;
    let Some(varied) = args.r.varied() else { return Ok(of_skin(tensor)) };
    let second = |d: DVec3, e: DVec3| -> Result<Real> {
        with_slopes(0.0, Some(varied.second_moment_slopes([d, e]))).at(ctx.span)
    };
    varying_inertia(tensor, second, MassOf::Area, ctx.span)
}

/// What the inertia of a skin about its centroid is told as.
pub(in crate::ops) fn of_skin(tensor: DMat3) -> Record {
    let axes = principal_axes(tensor);
    let told = |numbers: [f64; 3]| numbers.map(LengthPower::<4>).to_vec();
    let rows: Vec<Vec<LengthPower<4>>> = (0..3).map(|i| told(tensor.row(i).to_array())).collect();
    Record::new([
        (Arc::from("tensor"), rows.into_value()),
        (Arc::from("moments"), told(axes.map(|(moment, _)| moment)).into_value()),
        (Arc::from("axes"), axes.map(|(_, axis)| axis).to_vec().into_value()),
    ])
}
