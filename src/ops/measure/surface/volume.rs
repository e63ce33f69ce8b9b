//! `volume` that surfaces enclose.

use super::{Surfaces, tell_accuracy};
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, LengthPower, Volume, op},
};

op! {
    /// Volume that closed surfaces enclose, or faces whose edges run together.
    ///
    /// The surfaces must close: every edge meets another one within the document's tolerance, or is
    /// collapsed to a point. Which way each of them faces does not matter, and a shell that is turned
    /// inward as a whole is a hole in another.
    ///
    /// The flux of the position through the surfaces by the theorem of Gauss, to some 12 digits.
    /// Mirtich, *Fast and accurate computation of polyhedral mass properties*, JGT 1 (1996).
    volume in Measure -> Volume {
        /// The surface, or a list of surfaces and faces.
        s: Spanned<Surfaces>,
    }
    example "volume(box((0, 0, 0), (1, 2, 3)))" => "6";
    example "volume(parametric((u, v) => (cos(u)*cos(v), sin(u)*cos(v), sin(v)), 0..tau, -pi/2..pi/2))/(4/3*pi) ~= 1 within 1e-12" => "true";
    example "{ let f = trim(sphere((0, 0), 1), by = XY, keep = \"above\")  volume([f, face(region(circle((0, 0), 1)))]) ~= 2*pi/3 within 1e-9 }" => "true";
    refuses "volume(plane_patch((0, 0), (1, 0), (0, 1)))" => "E0612: the surfaces do not close: edge \"u0\" is 0.4896 from the nearest other edge, at (0, 0.5104, 0)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Volume> {
    let mass = args.s.value.volume_mass(args.s.span, ctx)?.at(args.s.span)?;
    tell_accuracy("volume", mass.relative_error, ctx)?;
    Ok(LengthPower(mass.amount))
}
