//! `polynomial`: the curve of power-basis coefficients.

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::{Interval, NurbsCurve},
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// Polynomial curve of its coefficients, the lowest power first.
    ///
    /// The point at t is c0 + c1·t + c2·t² + …; the curve is held as a Bézier curve over the
    /// domain. Piegl & Tiller, *The NURBS Book*, §1.2.
    polynomial in Curve -> NurbsCurve {
        /// The coefficients, as a list or as the arguments themselves.
        coefficients: Spanned<AtLeast<1, DVec3>>,
        /// The parameters that have a point.
        domain: Spanned<Interval> = Spanned::unplaced(Interval::UNIT),
    }
    example "polynomial([(1, 0), (-1, 3), (9, 2), (-5, -3)])(0.5)" => "(2.125, 1.625, 0)";
    example "polynomial([(0, 0), (1, 0), (0, 1)], domain = -2..2).points" => "[(-2, 4, 0), (0, -4, 0), (2, 4, 0)]";
    refuses "polynomial([])" => "E0601: `polynomial`: `coefficients` must be a list of 1 or more points, found an empty list";
    refuses "polynomial([(0, 0), (1, 1)], domain = 1..1)" => "E0606: `polynomial`: `domain`: an interval needs its start below its end, got 1..1";
    derivative affine;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let (AtLeast(coefficients), domain) = (&args.coefficients.value, args.domain.value);
    ctx.made_by(&|| Some(NurbsCurve::factors_of_power_form(coefficients.len(), domain)));
    NurbsCurve::power_form(coefficients, domain).at(args.coefficients.span)
}
