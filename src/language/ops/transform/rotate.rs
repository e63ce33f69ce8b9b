//! `rotate`: geometry turned about an axis.

use glam::{DAffine3, DMat3, DVec3};

use super::{about, apply, no_derivative, transformed};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{GeomError, unit},
    value::{
        Angle, At, Ctx, FromValue, Geometry, IntoValue, Real, RealGeometry, Value, Vector, op,
        through_shape, varies,
    },
};

op! {
    /// Geometry turned about an axis, counter-clockwise seen from the axis's tip.
    rotate in Transform -> RealGeometry {
        /// What is turned.
        g: RealGeometry,
        /// By how much.
        angle: Angle<Real>,
        /// The direction of the axis.
        axis: Spanned<DVec3> = Spanned::unplaced(DVec3::Z),
        /// A point of the axis.
        about: Vector = Vector::Plain(DVec3::ZERO),
    }
    example "rotate((1, 0), 180deg, about = (2, 0)) ~= (3, 0)" => "true";
    example "gradient(a => rotate(line((0, 0), (2, 0)), a).end.y * 1rad, 60deg) ~= 1" => "true";
    refuses "rotate((1, 0), 90)" => "E0304: `rotate`: `angle` must be an angle, found the number 90";
    refuses "rotate((1, 0), 90deg, axis = (0, 0, 0))" => "E0607: an axis of length zero has no direction";
    picture "[for i in 0..<8: rotate(bezier((1, 0), (2, 1), (3, 0)), i*45deg)]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<RealGeometry> {
    let Some(axis) = unit(args.axis.value) else {
        return Diagnostic::error(
            Code::Degenerate,
            args.axis.span,
            "an axis of length zero has no direction",
        )
        .fail();
    };
    let (angle, about) = (args.angle.0, args.about);
    if let (Real::Plain(angle), Vector::Plain(about), false) = (&angle, &about, varies(&args.g.0)) {
        let map = self::about(DAffine3::from_mat3(DMat3::from_axis_angle(axis, *angle)), *about);
        return apply(&Geometry(args.g.0), &map, ctx.span).map(|moved| RealGeometry(moved.0));
    }
    let columns = turned_axes(axis, &angle).at(ctx.span)?;
    let fixed = about.coordinates();
    let held = [0, 1, 2].map(|i| columns[i].times(&fixed[i]));
    let origin = about.minus(&held[0].plus(&held[1]).plus(&held[2]));
    if let Ok(point) = Vector::from_value(&args.g.0, ctx.span) {
        let parts = point.coordinates();
        let moved = [0, 1, 2].map(|i| columns[i].times(&parts[i]));
        let moved = moved[0].plus(&moved[1]).plus(&moved[2]).plus(&origin);
        return Ok(RealGeometry(moved.into_value()));
    }
    let [x, y, z] = columns.map(IntoValue::into_value);
    let parts = [args.g.0, x, y, z, origin.into_value()];
    // The result is linear in the map, and the map in the sine and cosine.
    let moved = through_shape(&parts, &mut |parts| {
        let column = |value: &Value| DVec3::from_value(value, ctx.span).unwrap_or(DVec3::ZERO);
        let [g, x, y, z, origin] = parts else { return Ok(Value::None) };
        let [x, y, z] = [x, y, z].map(column);
        let map = DAffine3 { matrix3: DMat3::from_cols(x, y, z), translation: column(origin) };
        transformed(g, &map, ctx.span)
    })?;
    moved.map(RealGeometry).or_else(|reason| no_derivative(reason, ctx.span))
}

/// Where the axes of space are turned to: the columns of cos·1 + sin·[a]× + (1 − cos)·a aᵀ.
fn turned_axes(axis: DVec3, angle: &Real) -> std::result::Result<[Vector; 3], GeomError> {
    let (sine, cosine) = (angle.sin()?, angle.cos()?);
    let rest = Real::Plain(1.0).minus(&cosine);
    Ok([DVec3::X, DVec3::Y, DVec3::Z].map(|unit| {
        let along = Vector::Plain(axis * axis.dot(unit)).times(&rest);
        let across = Vector::Plain(axis.cross(unit)).times(&sine);
        Vector::Plain(unit).times(&cosine).plus(&across).plus(&along)
    }))
}
