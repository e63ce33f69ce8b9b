//! `curvature_table` of a surface.

use glam::DVec3;

use super::grid_parameters;
use crate::{
    diag::{Result, Spanned},
    kernel::{GeomError, LocalError, Surface, Table},
    ops::measure::measured_column,
    value::{At, Ctx, op},
};

/// The columns in their order, each with the power of length that it holds, where that is known.
const COLUMNS: [(&str, Option<i8>); 12] = [
    ("u", None),
    ("v", None),
    ("x", None),
    ("y", None),
    ("z", None),
    ("nx", None),
    ("ny", None),
    ("nz", None),
    ("k1", Some(-1)),
    ("k2", Some(-1)),
    ("gaussian", Some(-2)),
    ("mean", Some(-1)),
];

op! {
    /// Table of points, unit normals, principal, Gaussian and mean curvatures over a surface.
    ///
    /// Its columns are `u v x y z nx ny nz k1 k2 gaussian mean`. Samples are evenly spaced in both
    /// parameters, the edges among them, row after row along v. A cell is empty, `none` in a
    /// script, where the surface has no such value, as at the apex of a cone.
    curvature_table in Measure -> Table {
        /// The surface.
        s: Spanned<Surface>,
        /// How many samples along u, two or more.
        u: Spanned<usize> = Spanned::unplaced(20),
        /// How many samples along v, two or more.
        v: Spanned<usize> = Spanned::unplaced(20),
    }
    example "curvature_table(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), u = 2, v = 3).v" => "[0, 0.5, 1, 0, 0.5, 1]";
    example "curvature_table(cylinder((0, 0), 2, 1), v = 2).mean[0] ~= -1/4" => "true";
    refuses "curvature_table(plane_patch((0, 0), (1, 0), (0, 1)), u = 1)" => "E0601: a surface is sampled at 2 places or more in each direction, found 1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Table> {
    let surface = &args.s.value;
    let (us, vs) = grid_parameters(surface, [args.u, args.v], ctx)?;
    let mut columns: [Vec<f64>; 12] =
        std::array::from_fn(|_| Vec::with_capacity(us.len() * vs.len()));
    for &u in &us {
        for &v in &vs {
            let cells = row(surface, u, v).at(args.s.span)?;
            for (column, cell) in columns.iter_mut().zip(cells) {
                column.push(cell);
            }
        }
    }
    let columns = COLUMNS.into_iter().zip(columns);
    let column = |((name, power), cells)| measured_column(name, power, cells, ctx.unit);
    Table::new(columns.map(column).collect()).at(ctx.span)
}

/// The cells at a place; NaN stands for an empty one.
fn row(surface: &Surface, u: f64, v: f64) -> std::result::Result<[f64; 12], GeomError> {
    let point = surface.point_at(u, v)?;
    let shape = match surface.shape_at(u, v) {
        Err(GeomError::Local(LocalError::NoNormal { .. } | LocalError::NoCurvature { .. })) => None,
        shape => Some(shape?),
    };
    let normal = match (&shape, surface.normal_at(u, v)) {
        (Some(shape), _) => shape.normal(),
        (None, Err(GeomError::Local(LocalError::NoNormal { .. }))) => DVec3::NAN,
        (None, normal) => normal?,
    };
    let [k1, k2, gaussian, mean] = shape.map_or([f64::NAN; 4], |shape| {
        let [k1, k2] = shape.curvatures();
        [k1, k2, shape.gaussian(), shape.mean()]
    });
    let (p, n) = (point, normal);
    Ok([u, v, p.x, p.y, p.z, n.x, n.y, n.z, k1, k2, gaussian, mean])
}
