//! `ode`: the curve along which a point moves that changes at a known rate.

mod moving_jumps;
mod state;

use moving_jumps::{ScriptRate, Stop};
use state::{Search, State};

use super::{SearchRange, no_derivatives, six_digits};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        Jet, Trajectory, TrajectoryError, ceiling::TRAJECTORY_STEPS, find_branched_trajectory,
    },
    ops::positive,
    value::{At, Callback, Ctx, Length, Range, Value, op},
};

op! {
    /// Curve of a point that starts somewhere and changes at the rate that a function tells: the solution of an
    /// ordinary differential equation, such as a streamline or a curve of given curvature.
    ///
    /// Its parameter is the variable of the function, over the range. Several points that depend on one
    /// another, such as a place and a velocity, are a list: the function is given a list and yields one, and the
    /// result is a list of curves. Numbers are coordinates of points.
    ///
    /// The curve is a spline of degree 5 with two continuous derivatives. It is followed again with smaller
    /// errors in each step until it stays the same within the tolerance, so that the last one is nearer still;
    /// `report` tells by how much they differ as `error`, and has `steps` and `evaluations`. The rate is looked at
    /// between the places of its steps as well, so that what acts on a hundredth of the range is seen; what acts on less
    /// may lie between them: let ranges end where it begins and ends. Where the point
    /// grows without bound, or more than 50000 steps are needed, as for stiff equations, that is refused with
    /// the place. Derivatives pass through, by what the function and the start depend on, within the tolerance.
    /// Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, §II.4-II.6.
    ode in Math -> Value {
        /// A function of the variable and the point, or the list of points, that yields the derivative.
        f: Spanned<Callback>,
        /// Where the point is at the start of the range, or a list of points.
        start: Spanned<Value>,
        /// The range of the variable.
        range: Spanned<Range>,
        /// How far the curve may be off, 1e-12 of its size at least; the document's tolerance unless given.
        tolerance: Option<Spanned<Length>>,
    }
    example "ode((t, p) => (-p.y, p.x), start = (1, 0), range = 0..pi).end ~= (-1, 0)" => "true";
    example "ode((t, p) => p, start = (1, 0), range = 0..1, tolerance = 1e-10)(1).x ~= e within 1e-10" => "true";
    example "ode((s, p) => (cos(p.z), sin(p.z), s), start = (0, 0), range = 0..2).end.z ~= 2" => "true";
    example "[for c in ode((t, s) => [s[1], -s[0]], start = [(1, 0), (0, 1)], range = 0..pi): c.end] ~= [(-1, 0), (0, -1)]" => "true";
    example "gradient(k => ode((t, p) => (k * p.x, 0), start = (1, 0), range = 0..1, tolerance = 1e-10).end.x, 2) ~= e^2 within 1e-8" => "true";
    refuses "ode((t, p) => (p.x^2, 0), start = (1, 0), range = 0..2)" => "E0504: the trajectory ends at 1";
    refuses "ode((t, p) => 1, start = (0, 0), range = 0..1)" => "E0301: the function must yield a point, but it yields the number 1";
    refuses "ode((t, p) => p, start = 1, range = 0..1)" => "E0301: a trajectory starts from a point or a list of points, found the number 1";
    refuses "ode((t, p) => p, start = (1, 0), range = 1..0)" => "E0606: an interval needs its start below its end, got 1..0";
    scene r#"
        curve clothoid = ode((s, p) => (cos(p.z), sin(p.z), s), start = (0, 0), range = 0..6)
          |> project(plane((0, 0), (0, 0, 1)))
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let state = State::new(&args.start)?;
    let range = SearchRange::new(args.range)?;
    let tolerance = match args.tolerance {
        Some(tolerance) => positive("the tolerance", tolerance)?,
        None => ctx.tolerance.distance,
    };
    let varies = ctx.caller.is_varying(&args.f.value.0);
    let search = Search { f: &args.f, range: &range, tolerance, varies };
    let (found, seen) = search.followed(ctx, &state)?;
    // What a function yields that took something with derivatives tells what these are by.
    let Some(like) = seen.filter(|_| state.like.is_none()) else {
        return state.curves(&found, OP.name).at(ctx.span);
    };
    let state = state.varying_as(like);
    let (found, _) = search.followed(ctx, &state)?;
    state.curves(&found, OP.name).at(ctx.span)
}

impl Search<'_> {
    /// The trajectory from a state; with the shape of derivatives that were seen on the way.
    fn followed(&self, ctx: &mut Ctx<'_>, state: &State) -> Result<(Trajectory, Option<Jet>)> {
        if state.like.as_ref().is_some_and(|like| like.n_variables().is_none()) {
            return no_derivatives(self.f.span);
        }
        let mut rate = ScriptRate::new(ctx, self, state);
        let found =
            find_branched_trajectory(&mut rate, &state.start(), self.range.ends, self.tolerance)
                .map_err(|err| refusal(err, self.f.span, self.range, state))?;
        rate.check_ends(&found)?;
        Ok((found, rate.seen))
    }
}

/// Why there is no trajectory.
fn refusal(
    err: TrajectoryError<Stop>,
    span: Span,
    range: &SearchRange,
    state: &State,
) -> Box<Diagnostic> {
    let refused = |message, label, hint: &str| {
        Box::new(Diagnostic::error(Code::NoAnswer, span, message).label(label).hint(hint))
    };
    match err {
        TrajectoryError::Function(Stop::Failed(found)) => found,
        TrajectoryError::Function(Stop::Branch) => {
            unreachable!("the end of a branch is followed by the next one")
        }
        TrajectoryError::Ends { at, state: parts } => {
            let reached = state.rounded(&parts);
            refused(
                format!("the trajectory ends at {}", range.place_text(at)),
                format!("it has come to {reached} there, and changes faster than can be followed"),
                "it may grow without bound, or the function jumps there; end the range before",
            )
        }
        TrajectoryError::Long { at, is_stiff } => {
            let message = format!(
                "the trajectory takes more than {TRAJECTORY_STEPS} steps to come beyond {}",
                range.place_text(at)
            );
            match is_stiff {
                true => refused(
                    message,
                    "the equation is stiff: something in it changes far faster than the trajectory"
                        .to_owned(),
                    "leave out what fades at once, so that its equilibrium holds from the start; or shorten the range",
                ),
                false => refused(
                    message,
                    "it turns or jumps too often".to_owned(),
                    "shorten the range, or give a larger `tolerance`",
                ),
            }
        }
        TrajectoryError::Unsettled { at, error } => refused(
            format!("the trajectory does not settle near {}", range.place_text(at)),
            match error.is_finite() {
                true => format!("with shorter steps it is {} away still", six_digits(error, None)),
                false => "with shorter steps it is elsewhere".to_owned(),
            },
            "the smallest errors grow on the way; shorten the range, or give a larger `tolerance`",
        ),
    }
}
