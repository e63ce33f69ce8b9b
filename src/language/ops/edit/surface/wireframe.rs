//! `wireframe`: isocurves of a surface.

use crate::{
    diag::{Result, Span, Spanned},
    kernel::{Curve, Direction, Surface},
    ops::list::check_length,
    value::{At, Ctx, FromValue, Mismatch, Type, Value, op},
};

op! {
    /// Isocurves of a surface: those of constant u, which run along v, then those of constant v.
    ///
    /// A number of curves is spread evenly over the domain, both ends among them; one alone stands
    /// in the middle. A list has the parameters themselves.
    wireframe in Edit -> Vec<Curve> {
        /// The surface.
        s: Surface,
        /// How many curves of constant u, or at which u.
        u: Spanned<IsocurveChoice>,
        /// How many curves of constant v, or at which v.
        v: Spanned<IsocurveChoice>,
    }
    example "len(wireframe(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), 3, 2))" => "5";
    example "wireframe(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), [0.25], 0)[0].points" => "[(0.5, 0, 0), (0.5, 1, 0)]";
    refuses "wireframe(plane_patch((0, 0), (1, 0), (0, 1)), [2], 0)" => "E0606: parameter 2 is outside the domain 0..1";
    refuses "wireframe(plane_patch((0, 0), (1, 0), (0, 1)), -1, 2)" => "E0301: `wireframe`: `u` must be a whole number of zero or more, found the number -1";
    derivative affine;
    picture "wireframe(torus((0, 0, 0), 3, 1), 8, 12)";
}

/// Parameters: evenly spread, or listed.
#[derive(Clone)]
enum IsocurveChoice {
    Even(usize),
    Listed(Vec<f64>),
}

impl FromValue for IsocurveChoice {
    const TYPE: Type = Type::OneOf(&[Type::Count, Type::List(&Type::Ratio, 0)]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Number(_) => usize::from_value(value, span).map(Self::Even),
            Value::List(_) => Vec::from_value(value, span).map(Self::Listed),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Curve>> {
    let (mut curves, mut places) = (Vec::new(), Vec::new());
    for (across, wanted) in [(Direction::U, args.u), (Direction::V, args.v)] {
        let domain = args.s.domain(across);
        let parameters = match wanted.value {
            IsocurveChoice::Even(n) => {
                check_length(n as f64, ctx)?;
                match n {
                    0 => Vec::new(),
                    1 => vec![domain.at(0.5)],
                    n => domain.steps(n - 1),
                }
            }
            IsocurveChoice::Listed(parameters) => parameters,
        };
        for t in parameters {
            let t = domain.clamp_inside(t).at(wanted.span)?;
            places.push((across.other(), t));
            curves.push(args.s.isocurve(across.other(), t).at(wanted.span)?);
        }
    }
    ctx.made_by(&|| {
        let (surface, mut entries, mut n_made) = (args.s.nurbs().ok()?, Vec::new(), 0);
        for &(along, t) in &places {
            let own = surface.factors_of_isocurve(along, t).into_iter();
            entries.extend(own.map(|(made, given, factor)| (n_made + made, given, factor)));
            n_made += surface.knots(along).n_points();
        }
        Some(entries)
    });
    Ok(curves)
}
