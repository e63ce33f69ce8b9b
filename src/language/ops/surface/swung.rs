//! `swung`: a profile swung along a trajectory about the z axis.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{Axis, AxisContact, Curve, GeomError, NurbsCurve, NurbsSurface},
    value::{At, Ctx, op, rounded},
};

op! {
    /// Surface of a profile in the xz-plane, swung about z along a trajectory in the xy-plane.
    ///
    /// Its point at (u, v) is (s·x·X, s·x·Y, z) of the profile's point (x, 0, z) at u and the
    /// trajectory's (X, Y, 0) at v, where s is the scale; exact. With the unit circle as its
    /// trajectory it is a surface of revolution. Parametric curves are followed
    /// within the document's tolerance. Piegl & Tiller, *The NURBS Book*, (10.1) to (10.6).
    swung in Surface -> NurbsSurface {
        /// The profile, in the xz-plane; u runs along it.
        profile: Spanned<Curve>,
        /// The trajectory, in the xy-plane; v runs along it.
        trajectory: Spanned<Curve>,
        /// Factor of x and y.
        scale: Spanned<f64> = Spanned::unplaced(1.0),
    }
    example "swung(line((1, 0), (2, 0, 4)), circle((0, 0), 1))(0.5, 0.25) ~= (0, 1.5, 2)" => "true";
    example "swung(line((1, 0), (1, 0, 4)), line((1, 0), (0, 2)), scale = 3)(0, 1)" => "(0, 6, 0)";
    refuses "swung(line((1, 1), (2, 0, 4)), circle((0, 0), 1))" => "E0607: the profile must lie in the xz-plane, but at t = 0 its y is 1";
    refuses "swung(line((1, 0), (2, 0, 4)), circle((0, 0, 1), 1))" => "E0607: the trajectory must lie in the xy-plane, but at t = 0 its z is 1";
    derivative shape;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    if args.scale.value == 0.0 {
        let message = "a scale of zero would flatten the surface to a line";
        return Diagnostic::error(Code::Degenerate, args.scale.span, message).fail();
    }
    let allowed = ctx.tolerance.distance;
    let [profile, trajectory] = [&args.profile, &args.trajectory]
        .map(|curve| curve.value.nurbs_within(allowed).at(curve.span));
    let (profile, trajectory) = (profile?, trajectory?);
    check_plane((&profile, args.profile.span), "profile", ("xz", "y", 1), allowed)?;
    check_plane((&trajectory, args.trajectory.span), "trajectory", ("xy", "z", 2), allowed)?;
    let surface = NurbsSurface::swung(&profile, &trajectory, args.scale.value).at(ctx.span)?;
    for (code, message) in at_the_axis(&profile, &trajectory, allowed).at(args.profile.span)? {
        let warning = Diagnostic::warning(code, ctx.span, message);
        ctx.warn(warning.hint("`trim` the curve there, and swing one side of it"));
    }
    Ok(surface)
}

/// What it means for the surface that one of its curves comes to the z axis.
///
/// # Errors
/// `ConstructionError::OnAxis` for a profile that lies on it.
fn at_the_axis(
    profile: &NurbsCurve,
    trajectory: &NurbsCurve,
    allowed: f64,
) -> std::result::Result<Vec<(Code, String)>, GeomError> {
    let axis = Axis::new(DVec3::ZERO, DVec3::Z)?;
    let told = |contact: AxisContact| match contact {
        AxisContact::Place { parameter, is_crossing: true } => {
            let message = format!(
                "the profile crosses the z axis at t = {}, where the surface passes through one point",
                rounded(parameter)
            );
            Some((Code::SelfIntersecting, message))
        }
        AxisContact::Place { .. } => None,
        AxisContact::Stretch { start, end } => {
            let message = format!(
                "the profile runs along the z axis from t = {} to {}, where the surface has no area",
                rounded(start),
                rounded(end)
            );
            Some((Code::Unclean, message))
        }
    };
    let mut found: Vec<(Code, String)> =
        axis.contacts(profile, allowed)?.into_iter().filter_map(told).collect();
    let foot = trajectory.closest(DVec3::ZERO, allowed);
    if foot.distance <= allowed {
        let message = format!(
            "the trajectory comes to the z axis at t = {}, where the surface shrinks to a line",
            rounded(foot.parameter)
        );
        found.push((Code::Unclean, message));
    }
    Ok(found)
}

/// Fails where a curve leaves its plane, in which a coordinate is zero.
fn check_plane(
    (curve, span): (&NurbsCurve, Span),
    what: &str,
    (plane, coordinate, index): (&str, &str, usize),
    allowed: f64,
) -> Result<()> {
    let (t, off) = farthest(curve, index);
    if off.abs() <= allowed {
        return Ok(());
    }
    let message = format!(
        "the {what} must lie in the {plane}-plane, but at t = {} its {coordinate} is {}",
        rounded(t),
        rounded(off)
    );
    let hint = match index {
        1 => "the profile has the points (x, 0, z): `rotate` or `project` it",
        _ => "the trajectory has the points (x, y): `rotate` or `project` it",
    };
    Diagnostic::error(Code::Degenerate, span, message).hint(hint).fail()
}

/// Where the curve is furthest from zero in a coordinate, and that coordinate; more places than a
/// polynomial of the degree has zeros are looked at in each span.
fn farthest(curve: &NurbsCurve, index: usize) -> (f64, f64) {
    let n_steps = 2 * curve.degree() + 4;
    let knots = curve.knots();
    let places = knots.spans().flat_map(|span| knots.span_interval(span).steps(n_steps));
    let values = places.map(|t| (t, curve.point_at(t)[index]));
    values.fold((curve.domain().start(), 0.0), |most: (f64, f64), (t, value)| {
        if most.1.abs() < value.abs() { (t, value) } else { most }
    })
}
