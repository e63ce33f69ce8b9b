//! `curvature_table` of a curve.

use glam::DVec3;

use super::sample_parameters;
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, GeomError, LocalError, LocalGeometry, Side, Table},
    ops::measure::measured_column,
    value::{At, Ctx, op},
};

/// The columns in their order, each with the power of length that it holds, where that is known.
const COLUMNS: [(&str, Option<i8>); 10] = [
    ("t", None),
    ("x", None),
    ("y", None),
    ("z", None),
    ("tx", None),
    ("ty", None),
    ("tz", None),
    ("curvature", Some(-1)),
    ("radius", Some(1)),
    ("torsion", Some(-1)),
];

op! {
    /// Table of points, unit tangents, curvature, radius of curvature and torsion along a curve.
    ///
    /// Its columns are `t x y z tx ty tz curvature radius torsion`. Samples are evenly spaced in
    /// the parameter, both ends among them. A cell is empty, `none` in a script, where the curve
    /// has no such value: the radius and the torsion of a straight place, the curvature of a cusp.
    curvature_table in Measure -> Table {
        /// The curve.
        c: Spanned<Curve>,
        /// How many rows, two or more.
        samples: Spanned<usize> = Spanned::unplaced(100),
    }
    example "curvature_table(bezier((0, 0), (1, 2), (2, 0)), samples = 3).curvature[1]" => "2";
    example "curvature_table(line((0, 0), (1, 0)), samples = 2).radius" => "[none, none]";
    refuses "curvature_table(bezier((0, 0), (1, 2), (2, 0)), samples = 1)" => "E0601: a curve is sampled at 2 places or more, found 1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Table> {
    let parameters = sample_parameters(&args.c.value, args.samples, ctx)?;
    let mut columns: [Vec<f64>; 10] = std::array::from_fn(|_| Vec::with_capacity(parameters.len()));
    for t in parameters {
        let cells = row(&args.c.value, t).at(args.c.span)?;
        for (column, cell) in columns.iter_mut().zip(cells) {
            column.push(cell);
        }
    }
    let columns = COLUMNS.into_iter().zip(columns);
    let column = |((name, power), cells)| measured_column(name, power, cells, ctx.unit);
    Table::new(columns.map(column).collect()).at(ctx.span)
}

/// The cells at a parameter; NaN stands for an empty one.
fn row(curve: &Curve, t: f64) -> std::result::Result<[f64; 10], GeomError> {
    let none = f64::NAN;
    let point = curve.point_at(t)?;
    let local = match curve.local_at(t, Side::Right) {
        Err(GeomError::Local(LocalError::VanishingTangent { .. })) => None,
        local => Some(local?),
    };
    let tangent = local.map_or(DVec3::NAN, |local| local.tangent());
    let cell = |value: fn(&LocalGeometry) -> std::result::Result<f64, GeomError>| {
        local.as_ref().and_then(|local| value(local).ok()).unwrap_or(none)
    };
    Ok([
        t,
        point.x,
        point.y,
        point.z,
        tangent.x,
        tangent.y,
        tangent.z,
        cell(LocalGeometry::curvature),
        cell(LocalGeometry::radius_of_curvature),
        cell(LocalGeometry::torsion),
    ])
}
