//! `gordon`: the surface through a network of curves.

use super::{network::NetworkPlaces, sweep_options::tolerated};
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, NetworkBuilder, NurbsSurface},
    value::{Choice, Ctx, Length, op},
};

op! {
    /// Surface through a network of curves, those along u and those along v.
    ///
    /// Where the curves meet is found unless it is given; they may be of any degree, direction,
    /// order and parameters. The first curve of each list gives the direction; others are reversed
    /// and reordered to it, and what stands out beyond the network is cut off. Where all curves of
    /// a direction close, so does the surface, as smooth at its seam as they are, and a curve across
    /// them that comes again, as one at their seam often does, counts once. Curves that meet
    /// the others at one set of parameters stay as they are, and are isocurves exactly, rational
    /// ones of one denominator too; others are run through with another parameter, twice
    /// continuously differentiable, and become splines of their degree, 3 or more, on as few knots
    /// as the tolerance needs. `report` tells what was done, and for each curve a bound of
    /// its distance from the surface, which is within the tolerance. Two and two curves make the
    /// Coons patch.
    /// Gordon (1969); Piegl & Tiller, *The NURBS Book*, §10.5.
    gordon in Surface -> NurbsSurface {
        /// The curves along u, two or more.
        u: Spanned<Vec<Curve>>,
        /// The curves along v, two or more.
        v: Spanned<Vec<Curve>>,
        /// The u of each v-curve.
        at_u: Option<Spanned<Vec<f64>>>,
        /// The v of each u-curve.
        at_v: Option<Spanned<Vec<f64>>>,
        /// Cubic splines between the curves, or one polynomial through all.
        blend: GordonBlend = GordonBlend::Spline,
        /// How far curves may be apart where they meet, and the surface from them; the document's.
        tolerance: Option<Spanned<Length>>,
    }
    example "gordon([line((0, 0), (1, 0)), line((0, 1), (1, 1, 1))], [line((0, 0), (0, 1)), line((1, 0), (1, 1, 1))])(0.5, 0.5)" => "(0.5, 0.5, 0.25)";
    example "gordon(u = [line((0, 0), (2, 0)), line((0, 1), (2, 1))], v = [line((2, 0), (2, 1)), line((0, 1), (0, 0))])(0.5, 1)" => "(1, 1, 0)";
    refuses "gordon(u = [line((0, 0), (1, 0)), line((0, 1), (1, 1))], v = [line((0, 0, 2), (0, 1, 2)), line((1, 0), (1, 1))])" => "E0609: `line((0, 1), (1, 1))` and `v[0]` do not meet: they are 2 apart at (0, 1, 1), more than the tolerance 1e-6; another pair does not meet either";
    refuses "gordon(u = [line((0, 0), (1, 0))], v = [line((0, 0), (0, 1)), line((1, 0), (1, 1))])" => "E0401: a network needs 2 curves `u` or more, found 1";
    derivative affine;
    settling super::moving::NETWORK;
    scene r#"
        curves u = [for y in [0, 2, 4]: bezier((0, y, 0), (2, y, 4 - y/2), (4, y, 0))] with (color = "red")
        curves v = [for x in [0, 4]: line((x, 0), (x, 4))] with (color = "green")
        surface s = gordon(u = u, v = v) with (color = "lightgray")
    "#;
}

/// What is between the curves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum GordonBlend {
    Spline,
    Lagrange,
}

impl Choice for GordonBlend {
    const WORDS: &'static [&'static str] = &["spline", "lagrange"];
    const MEANINGS: &'static [Self] = &[Self::Spline, Self::Lagrange];
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let tolerance = tolerated(ctx, args.tolerance.as_ref())?;
    let mut places = NetworkPlaces {
        ctx,
        spans: [args.u.span, args.v.span],
        at: [&args.at_u, &args.at_v].map(|at| at.as_ref().map(|at| at.span)),
        tolerance,
    };
    let mut builder = NetworkBuilder::new(args.u.value, args.v.value, tolerance);
    if let Some(at_u) = args.at_u {
        builder = builder.at_u(at_u.value);
    }
    if let Some(at_v) = args.at_v {
        builder = builder.at_v(at_v.value);
    }
    if args.blend == GordonBlend::Lagrange {
        builder = builder.lagrange();
    }
    let network = builder.prepare().map_err(|error| places.diagnostic(error))?;
    places.tolerance = network.tolerance();
    network.build().map_err(|error| places.diagnostic(error))
}
