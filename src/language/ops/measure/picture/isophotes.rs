//! `isophotes`: lines of equal brightness.

use glam::DVec3;

use super::lines;
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{NurbsCurve, Surface},
    value::{Angle, At, Ctx, op, shortest},
};

op! {
    /// Curves on a surface along which its normal stands at one of the angles to the light, in the
    /// order of the angles: lines of equal brightness of a dull surface under a distant lamp.
    ///
    /// At `0deg` the surface faces the light, at `90deg` is the edge of the shade, at `180deg` it
    /// faces away; the lighter side is to the left of a curve, seen from the side of Su × Sv. Where
    /// surfaces meet with one tangent plane isophotes do not jump, with one curvature they
    /// have no kink. Found completely, by the signs of Bernstein coefficients, as `section` does.
    /// A patch that has an angle all over is told by its border, as a plane is. A parametric
    /// surface is taken as a spline within a thousandth of the tolerance.
    /// Poeschl, *Detecting surface irregularities using isophotes*, CAGD 1 (1984).
    isophotes in Measure -> Vec<NurbsCurve> {
        /// The surface.
        s: Surface,
        /// The direction towards the light.
        light: Spanned<DVec3>,
        /// The angles between normal and light.
        angles: Spanned<Vec<Angle>>,
    }
    example "[for c in isophotes(sphere((0, 0), 5), (0, 0, 1), [30deg, 90deg]): length(c)] ~= [5 * pi, 10 * pi] within 1e-5" => "true";
    example "isophotes(plane_patch((0, 0), (1, 0), (0, 1)), (0, 0, 1), [30deg])" => "[]";
    refuses "isophotes(plane_patch((0, 0), (1, 0), (0, 1)), (0, 0), [30deg])" => "E0607: the light has no direction: it is (0, 0, 0)";
    refuses "isophotes(plane_patch((0, 0), (1, 0), (0, 1)), (0, 0, 1), [30])" => "E0304: `isophotes`: `angles` must be a list of angles, but its element [0] is the number 30; an angle is expected there";
    scene r#"
        surface s = torus((0, 0, 0), 3, 1) with (color = "lightgray")
        curves lines = isophotes(s, (1, 1, 2), [30deg, 60deg, 90deg, 120deg]) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    let angles: Vec<f64> = args.angles.value.iter().map(|angle| angle.0).collect();
    let most = std::f64::consts::PI;
    if let Some(idx) = angles.iter().position(|angle| !(0.0..=most).contains(angle)) {
        let got = shortest(angles[idx].to_degrees());
        let message =
            format!("angle [{idx}] is {got}deg; a normal stands at 0deg to 180deg to the light");
        return Diagnostic::error(Code::OutsideDomain, args.angles.span, message).fail();
    }
    let light = args.light.value;
    if light == DVec3::ZERO {
        return Diagnostic::error(Code::Degenerate, args.light.span, super::NO_LIGHT).fail();
    }
    let sets = args.s.isophotes(light, &angles, ctx.tolerance).at(ctx.span)?;
    let mut curves = Vec::new();
    for (set, angle) in sets.into_iter().zip(angles) {
        let what = format!("the normal is at {}deg", shortest(angle.to_degrees()));
        curves.extend(lines(ctx, set, &what));
    }
    Ok(curves)
}
