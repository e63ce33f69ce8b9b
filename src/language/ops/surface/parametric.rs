//! `parametric` of two parameters: the surface of any function.

use crate::{
    diag::Result,
    kernel::{Interval, ParametricSurface, Surface},
    ops::curve::parametric::{has_derivatives, if_misfit},
    value::{At, Callback, Ctx, op},
};

op! {
    /// Surface of any function that yields a point for two parameters.
    ///
    /// It is the function itself and no approximation, and its derivatives are exact, as those of
    /// a parametric curve are. Griewank & Walther, *Evaluating Derivatives*, ch. 13.
    parametric in Surface -> Surface {
        /// The function, of two parameters without a unit.
        f: Callback,
        /// The range of the first parameter.
        domain_u: Interval,
        /// The range of the second parameter.
        domain_v: Interval,
    }
    example "parametric((u, v) => (u, v, u*v), 0..1, 0..2)(0.5, 2)" => "(0.5, 2, 1)";
    example "derivative(parametric((u, v) => (u, v, u*v), 0..1, 0..2), 0.5, 2)" => "(1, 0, 2)";
    example "parametric((u, v) => (u, v, max(u, v)), 0..1, 0..1)(0.5, 0.25)" => "(0.5, 0.25, 0.5)";
    refuses "parametric((u, v) => (u, v, 1/u), 0..1, 0..1)" => "E0501: division by zero";
    picture "parametric((u, v) => ((3 + v*cos(u/2))*cos(u), (3 + v*cos(u/2))*sin(u), v*sin(u/2)), 0..2*pi, -1..1)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Surface> {
    let function = ctx.caller.surface_function(&args.f.0, ctx.span)?;
    let surface = ParametricSurface::new(args.domain_u, args.domain_v, function);
    let hint = "a surface has a function of two parameters: `(u, v) => ...`";
    let surface = surface.at(ctx.span).map_err(|found| if_misfit(found, hint))?;
    has_derivatives(|share| {
        // Not on a diagonal, along which there may be a crease.
        let [u, v] = [args.domain_u.at(share), args.domain_v.at(1.0 - share * share)];
        surface.derivatives_at(u, v, 1).at(ctx.span)
    })?;
    Ok(Surface::from(surface))
}
