//! `inertia` of surfaces, or of what they enclose.

use std::sync::Arc;

use glam::DMat3;

use super::{MassOf, Surfaces, Together, mass};
use crate::{
    diag::{Result, Spanned},
    kernel::principal_axes,
    value::{Ctx, IntoValue, LengthPower, Record, Value, op},
};

op! {
    /// Inertia about the centroid of what closed surfaces enclose, or of the surfaces themselves.
    ///
    /// `tensor` is the matrix of three rows about axes through the centroid, with density one;
    /// `moments` are its principal values in ascending order, and `axes` their directions, which are
    /// unit vectors and right-handed. Of the volume the surfaces must close, as for `volume`.
    /// Mirtich, *Fast and accurate computation of polyhedral mass properties*, JGT 1 (1996).
    inertia in Measure -> Record {
        /// The surface, or a list of surfaces.
        s: Spanned<Together<Surfaces>>,
        /// What is heavy: the inside or the skin.
        of: MassOf = MassOf::Volume,
    }
    example "inertia(bilinear((0, 0), (0, 2), (3, 0), (3, 2)), of = \"area\").moments ~= [2, 4.5, 6.5] within 1e-12" => "true";
    refuses "inertia(plane_patch((0, 0), (1, 0), (0, 1)))" => "E0612: the surfaces do not close: edge \"u0\" is 0.4896 from the nearest other edge, at (0, 0.5104, 0)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let Spanned { value: Together(surfaces), span } = &args.s;
    Ok(inertia_told(mass(surfaces, *span, (args.of, "inertia"), ctx)?.inertia, args.of))
}

/// A tensor with its principal moments and axes.
pub(in crate::ops) fn inertia_told(tensor: DMat3, of: MassOf) -> Record {
    let axes = principal_axes(tensor);
    let told = |numbers: [f64; 3]| -> Value {
        let number = |moment| match of {
            MassOf::Volume => LengthPower::<5>(moment).into_value(),
            MassOf::Area => LengthPower::<4>(moment).into_value(),
        };
        Value::list(numbers.map(number).to_vec())
    };
    let rows: Vec<Value> = (0..3).map(|i| told(tensor.row(i).to_array())).collect();
    Record::new([
        (Arc::from("tensor"), rows.into_value()),
        (Arc::from("moments"), told(axes.map(|(moment, _)| moment))),
        (Arc::from("axes"), axes.map(|(_, axis)| axis).to_vec().into_value()),
    ])
}
