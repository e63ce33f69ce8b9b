//! `sweep`: the surface that a section leaves behind along a path.

use glam::DVec3;

use super::{
    motion::{Rails, Scale, Twist},
    sweep_options::{CornerOption, FrameOption, SweepMethod, SweepOptions},
};
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, NurbsSurface},
    value::{Ctx, Length, op},
};

op! {
    /// Surface that a section leaves behind along a path: u along the section, v along the path,
    /// with the path's parameter.
    ///
    /// The section's x lies along the path, its y and z across it, its origin on it. Its z is up
    /// and its y to the left of the way: z starts as near to `up` as can be, and goes on as `frame`
    /// says. "translate"
    /// only moves it: exact. "fixed" keeps z as near to `up` as can be; "frenet" takes the path's
    /// binormal for z; "rotation_minimizing" never turns it about the path; "projection" carries z
    /// on by projecting it from place to place, as the places come ever closer: in that limit it
    /// does not turn about the path either, and both are one. Along a closed path the angle by
    /// which these miss their start is spread over the length. With `keep_path` the path is met
    /// exactly (the isocurve of a section's point at the origin); without it the surface is a cubic
    /// skin through placements of the section, and has weights only where the section does. The rest
    /// is within the tolerance of the true surface, measured at 36 places between two knots after half
    /// of the tolerance is kept at fewer; a number of `sections` is kept instead, and `report` tells
    /// the deviation. Where the section reaches beyond the centre of curvature, shrinks to
    /// nothing between the ends, or lies along the path and covers a strip twice, a warning says so.
    /// Piegl & Tiller, *The NURBS Book*, §10.4, A10.1, A10.2; Wang, Jüttler, Zheng & Liu,
    /// *Computation of rotation minimizing frames* (2008); Bloomenthal & Riesenfeld,
    /// *Approximation of sweep surfaces by tensor product NURBS* (1991).
    sweep in Surface -> NurbsSurface {
        /// The section.
        section: Spanned<Curve>,
        /// The path, without cusps.
        path: Spanned<Curve>,
        /// How the section turns with the path.
        frame: Spanned<FrameOption> = Spanned::unplaced(FrameOption::RotationMinimizing),
        /// The size along the way: a factor, one for each axis as a point, a list of these at even
        /// parameters with straight lines between, or a function of v.
        scale: Option<Spanned<Scale>>,
        /// The turn about the path: an angle that is reached at the end, or a function of v.
        twist: Option<Spanned<Twist>>,
        /// Where z points at the start; (0, 0, 1), or (1, 0, 0) where the path starts along it.
        up: Option<Spanned<DVec3>>,
        /// A curve that z points to, at the same fraction of its domain; or two, along which both
        /// ends of the section run, which is turned and sized for that.
        rail: Option<Spanned<Rails>>,
        /// What happens at corners of the path: an error, or both sides meet in the plane that
        /// halves the angle; straight legs stay prisms, bent ones are sheared near the corner.
        corner: CornerOption = CornerOption::Error,
        /// Whether the path itself is met exactly.
        keep_path: bool = true,
        /// How many placements of the section make the surface, instead of a tolerance; with
        /// `keep_path` no fewer than the path has control points, without it at even parameters.
        sections: Option<Spanned<usize>>,
        /// What the surface is made of: it passes through "placements" of the section; or
        /// "offsets" of the path's control points by those of the section, which take more columns
        /// and never swing out.
        method: Spanned<SweepMethod> = Spanned::unplaced(SweepMethod::Placements),
        /// How far the surface may be from the true one; the document's tolerance.
        tolerance: Option<Spanned<Length>>,
    }
    example "sweep(circle((0, 0, 0), 1, normal = (1, 0, 0)), line((0, 0), (5, 0)))(0, 0.5)" => "(2.5, 1, 0)";
    example "sweep(bezier((0, 0), (1, 1), (2, 0)), line((0, 0), (0, 0, 3)), frame = \"translate\")(0.5, 1)" => "(1, 0.5, 3)";
    example "norm(sweep(circle((0, 0), 1, normal = (1, 0, 0)), circle((0, 0), 4))(0, 0.25) - (0, 3, 0)) < 1e-14" => "true";
    refuses "sweep(circle((0, 0), 1, normal = (1, 0, 0)), polyline((0, 0), (5, 0), (5, 5)))" => "E0607: the path has a corner at parameter 1";
    refuses "sweep(circle((0, 0), 1, normal = (1, 0, 0)), line((0, 0), (5, 0)), frame = \"frenet\")" => "E0607: the curve is straight at parameter 0: there is no frenet frame";
    refuses "sweep(circle((0, 0), 1, normal = (1, 0, 0)), line((0, 0), (5, 0)), scale = 0)" => "E0607: the section is scaled to a point all along the path";
    refuses "sweep(circle((0, 0), 1, normal = (1, 0, 0)), circle((0, 0), 4), keep_path = false, method = \"offsets\")" => "E0401: \"offsets\" of the path's control points meet the path, which `keep_path = false` gives up";
    scene r#"
        // The section stands in the plane of y (green, to the left of the way) and z (blue, up);
        // its x (red) lies along the path. Blue marks along the way show where its z went.
        let flag = polyline((0, 0, 0), (0, 0, 2), (0, 1, 1.5), (0, 0, 1))
        curve path = bezier((0, 0, 0), (4, 0, 0), (6, 3, 0), (6, 8, 2)) with (color = "black")
        surface s = sweep(flag, path, tolerance = 1e-3) with (color = "lightgray")
        curves up = [for v in linspace(0.25, 1, 4): line(s(0, v), s(1, v))] with (color = "blue")
        curve section = flag with (color = "orange")
        curve x = line((0, 0, 0), (2.5, 0, 0)) with (color = "red")
        curve y = line((0, 0, 0), (0, 2.5, 0)) with (color = "green")
        curve z = line((0, 0, 0), (0, 0, 2.5)) with (color = "blue")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let options = SweepOptions {
        path: args.path,
        frame: args.frame.value,
        scale: args.scale,
        twist: args.twist,
        up: args.up,
        rail: args.rail,
        corner: args.corner,
        keeps_path: args.keep_path,
        sections: args.sections,
        method: args.method,
        tolerance: args.tolerance,
    };
    options.surface(ctx, &args.section)
}
