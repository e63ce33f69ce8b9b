//! `inertia` of surfaces, or of what they enclose.

use std::sync::Arc;

use glam::DMat3;

use super::{MassOf, RealSurfaces, Together, mass, volume::varying_volume};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{VariedSurface, glam::DVec3, principal_axes, tolerance::EXACT_RELATIVE},
    value::{Ctx, IntoValue, LengthPower, Real, Record, Value, Vector, op},
};

op! {
    /// Inertia about the centroid of what closed surfaces enclose, or of the surfaces themselves.
    ///
    /// `tensor` is the matrix of three rows about axes through the centroid, with density one;
    /// `moments` are its principal values in ascending order, and `axes` their directions, which are
    /// unit vectors and right-handed. Derivatives pass through. Of the volume the surfaces must close, as for `volume`.
    /// Mirtich, *Fast and accurate computation of polyhedral mass properties*, JGT 1 (1996).
    inertia in Measure -> Record {
        /// The surface, or a list of surfaces.
        s: Spanned<Together<RealSurfaces>>,
        /// What is heavy: the inside or the skin.
        of: MassOf = MassOf::Volume,
    }
    example "inertia(bilinear((0, 0), (0, 2), (3, 0), (3, 2)), of = \"area\").moments ~= [2, 4.5, 6.5] within 1e-12" => "true";
    example "gradient(h => inertia(box((0, 0, 0), (1, 2, h))).moments[0], 3) ~= 5/6 within 1e-10" => "true";
    refuses "inertia(plane_patch((0, 0), (1, 0), (0, 1)))" => "E0612: the surfaces do not close: edge \"u0\" is 0.4896 from the nearest other edge, at (0, 0.5104, 0)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let Spanned { value: Together(surfaces), span } = &args.s;
    let mass = mass(&surfaces.plain, *span, (args.of, "inertia"), ctx)?;
    if !surfaces.vary() {
        return Ok(inertia_told(mass.inertia, args.of));
    }
    let volume = match args.of {
        MassOf::Area => None,
        MassOf::Volume => Some(varying_volume(surfaces, *span, "inertia", ctx)?),
    };
    // As the centroid moves the second moments about it stay, since the first ones are zero.
    let second = |d: DVec3, e: DVec3| {
        let slopes = |idx: usize, varied: &VariedSurface| match &volume {
            None => varied.area_second_moment_slopes(mass.centroid, [d, e]),
            Some(volume) => {
                let about = [volume.about, mass.centroid];
                let mut found = varied.volume_second_moment_slopes(about, [d, e])?;
                found.slopes.iter_mut().for_each(|slope| *slope *= volume.signs[idx]);
                Ok(found)
            }
        };
        surfaces.with_slopes(0.0, "inertia", ctx, slopes)
    };
    varying_inertia(mass.inertia, second, args.of, *span)
}

/// An inertia that varies, by the slopes of second moments about the centroid along two directions.
pub(in crate::ops) fn varying_inertia(
    tensor: DMat3,
    mut second: impl FnMut(DVec3, DVec3) -> Result<Real>,
    of: MassOf,
    span: Span,
) -> Result<Record> {
    let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z];
    let [xx, yy, zz] = [second(x, x)?, second(y, y)?, second(z, z)?];
    let [xy, xz, yz] = [second(x, y)?, second(x, z)?, second(y, z)?].map(|part| part.scaled(-1.0));
    let slopes = [
        [yy.plus(&zz), xy.clone(), xz.clone()],
        [xy, xx.plus(&zz), yz.clone()],
        [xz, yz, xx.plus(&yy)],
    ];
    varying_told(tensor, &slopes, of, span)
}

/// A tensor that varies with its principal moments and axes. Magnus, *On differentiating eigenvalues and
/// eigenvectors*, Econometric Theory 1 (1985).
fn varying_told(tensor: DMat3, slopes: &[[Real; 3]; 3], of: MassOf, span: Span) -> Result<Record> {
    let axes = principal_axes(tensor);
    let about = |a: DVec3, b: DVec3| {
        let parts = (0..3).flat_map(|i| (0..3).map(move |k| (i, k)));
        parts.fold(Real::Plain(0.0), |sum, (i, k)| sum.plus(&slopes[i][k].scaled(a[i] * b[k])))
    };
    let (mut moments, mut directions) = (Vec::new(), Vec::new());
    for (i, (moment, axis)) in axes.iter().enumerate() {
        moments.push(about(*axis, *axis).with_value(*moment));
        let mut turned = axis.to_array().map(Real::Plain);
        for (k, (other, beside)) in axes.iter().enumerate().filter(|(k, _)| *k != i) {
            let turn = about(*beside, *axis);
            let apart = moment - other;
            let most = axes[2].0.abs();
            let turns = matches!(&turn, Real::Jet(jet) if jet.slopes().iter().any(|slope| EXACT_RELATIVE * most < slope.abs()));
            if apart.abs() <= EXACT_RELATIVE * most {
                if turns {
                    return no_axes([i, k], span);
                }
                continue;
            }
            for (axis, part) in turned.iter_mut().enumerate() {
                *part = part.plus(&turn.scaled(beside[axis] / apart));
            }
        }
        let value = axis.to_array();
        let coordinates = [0, 1, 2].map(|k| turned[k].clone().with_value(value[k]));
        directions.push(Vector::new(coordinates).into_value());
    }
    let told = |number: Real| match of {
        MassOf::Volume => LengthPower::<5, Real>(number).into_value(),
        MassOf::Area => LengthPower::<4, Real>(number).into_value(),
    };
    let entry = |i: usize, k: usize| told(slopes[i][k].clone().with_value(tensor.row(i)[k]));
    let row = |i: usize| Value::list((0..3).map(|k| entry(i, k)).collect());
    Ok(Record::new([
        (Arc::from("tensor"), Value::list((0..3).map(row).collect())),
        (Arc::from("moments"), Value::list(moments.into_iter().map(told).collect())),
        (Arc::from("axes"), Value::list(directions)),
    ]))
}

fn no_axes<T>([i, k]: [usize; 2], span: Span) -> Result<T> {
    let message = format!(
        "the principal axes [{}] and [{}] have no derivative: their moments are equal",
        i.min(k),
        i.max(k)
    );
    Diagnostic::error(Code::NoDerivative, span, message)
        .hint("turned by any angle they are principal axes as well; where the moments differ they have one")
        .fail()
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
