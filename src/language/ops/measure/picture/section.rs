//! `section` of a surface by a plane.

use std::sync::Arc;

use super::{reported, section_curves};
use crate::{
    diag::Result,
    kernel::{Frame, NurbsCurve},
    ops::face::SurfaceOrFace,
    value::{Ctx, op},
};

op! {
    /// Curves in which a plane cuts a surface or touches it.
    ///
    /// Found completely, by the signs of Bernstein coefficients and not by samples: no loop is too small.
    /// Where the surface is a plane, sphere, cylinder or cone they are exact lines and conics, and the circles
    /// of a torus are exact; others are cubic splines in the plane, within the document's tolerance, parametrized
    /// about by their length. To their left, seen from the side of the surface's normal, the surface is above the
    /// plane. They end at the surface's boundary, and where several cross. A patch that lies in the plane is
    /// told by its border; of a touch in a single point a warning tells. A plane that misses gives an
    /// empty list. A parametric surface is cut as a spline within a quarter of the tolerance. `report` of a curve tells
    /// whether it is proven, and how far from the surface and the plane it may be.
    /// Sederberg & Meyers, *Loop detection in surface patch intersections*, CAGD 5 (1988).
    section in Measure -> Vec<NurbsCurve> {
        /// The surface, or a part of one.
        g: SurfaceOrFace,
        /// The plane.
        plane: Arc<Frame>,
    }
    example "len(section(torus((0, 0), 3, 1), XY))" => "2";
    example "length(section(sphere((0, 0), 5), plane((0, 0, 3), (0, 0, 1)))[0]) ~= 8 * pi within 1e-6" => "true";
    example "section(sphere((0, 0), 5), plane((0, 0, 6), (0, 0, 1)))" => "[]";
    scene r#"
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
        let cuts = [for y in linspace(0.5, 3.5, 7): section(s, plane((0, y, 0), (0, 1, 0)))] with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    let curves = section_curves(ctx, &args.g, *args.plane)?;
    let curves = args.g.clipped(curves, ctx)?;
    Ok(curves.into_iter().map(|curve| reported(curve, &args.g, *args.plane, ctx)).collect())
}
