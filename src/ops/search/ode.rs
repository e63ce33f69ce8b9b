//! `ode`: the curve along which a point moves that changes at a known rate.

use std::sync::Arc;

use super::{MOST_LABELS, SearchRange, no_derivatives, six_digits, unknowns::numbers};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        ConstructionReport, GeomError, Jet, NurbsCurve, PointSlopes, ReportEntry, Trajectory,
        TrajectoryError, VariedCurve, ceiling::TRAJECTORY_STEPS, find_trajectory,
    },
    ops::positive,
    value::{At, Callback, Ctx, FromValue, IntoValue, Length, Range, Real, Value, Vector, op},
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
        /// How far the curve may be off; the document's tolerance unless given.
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
    let state = match ctx.caller.is_varying(&args.f.value.0) && state.like.is_none() {
        true => state.varying_as(ctx, &args.f, &range)?,
        false => state,
    };
    let is_known = state.like.as_ref().is_none_or(|like| like.n_variables().is_some());
    if !is_known {
        return no_derivatives(args.f.span);
    }
    let start = state.start();
    let rate = |place, parts: &[f64]| state.rate(ctx, &args.f, &range, (place, parts));
    let found = find_trajectory(rate, &start, range.ends, tolerance)
        .map_err(|err| refusal(err, args.f.span, &range, &state))?;
    state.curves(&found).at(ctx.span)
}

/// What changes: one point, or several, with their slopes where derivatives are carried along. These follow the
/// equation that the derivative of the trajectory by a variable fulfils. Hairer, Nørsett & Wanner, §I.14.
struct State {
    points: Vec<Vector>,
    is_list: bool,
    /// The shape of what is carried along.
    like: Option<Jet>,
}

impl State {
    fn new(start: &Spanned<Value>) -> Result<Self> {
        let refused = |value: &Value| {
            let message = format!(
                "a trajectory starts from a point or a list of points, found {}",
                value.phrase()
            );
            Diagnostic::error(Code::WrongKind, start.span, message)
                .hint("numbers are written as coordinates: `(0, 1)` for two of them")
        };
        let point = |value: &Value| match value {
            Value::Point(_) | Value::JetPoint(_) => {
                Vector::from_value(value, start.span).or_else(|_| refused(value).fail())
            }
            other => refused(other).fail(),
        };
        let like = |points: &[Vector]| points.iter().find_map(carried);
        match &start.value {
            Value::List(items) if items.is_empty() => refused(&start.value).fail(),
            Value::List(items) => {
                let points = items.iter().map(&point).collect::<Result<Vec<Vector>>>()?;
                Ok(Self { like: like(&points), points, is_list: true })
            }
            value => {
                let points = vec![point(value)?];
                Ok(Self { like: like(&points), points, is_list: false })
            }
        }
    }

    /// The same with what a function that varies yields at the start.
    fn varying_as(
        mut self,
        ctx: &mut Ctx<'_>,
        f: &Spanned<Callback>,
        range: &SearchRange,
    ) -> Result<Self> {
        let found = self.asked(ctx, f, range, (range.ends[0], &self.start()))?;
        self.like = found.into_iter().find_map(|part| match part {
            Real::Jet(jet) => Some(jet),
            Real::Plain(_) => None,
        });
        Ok(self)
    }

    /// The coordinates of all points, then their slopes by each variable in turn.
    fn start(&self) -> Vec<f64> {
        self.flat(self.points.iter().flat_map(Vector::coordinates).collect())
    }

    fn flat(&self, parts: Vec<Real>) -> Vec<f64> {
        let mut all: Vec<f64> = parts.iter().map(Real::value).collect();
        if let Some(like) = &self.like {
            let jets: Vec<Jet> = parts.iter().map(|part| part.like(like)).collect();
            for variable in 0..like.slopes().len() {
                all.extend(jets.iter().map(|jet| jet.slopes()[variable]));
            }
        }
        all
    }

    /// The state of these numbers.
    fn value(&self, parts: &[f64]) -> Value {
        let n = 3 * self.points.len();
        let real = |idx: usize| match &self.like {
            Some(like) => {
                let slopes = (1..=like.slopes().len()).map(|variable| parts[variable * n + idx]);
                let all: Vec<f64> = std::iter::once(parts[idx]).chain(slopes).collect();
                Real::Jet(like.with_coefficients(&all))
            }
            None => Real::Plain(parts[idx]),
        };
        let point = |first: usize| Vector::new([0, 1, 2].map(|axis| real(first + axis)));
        let mut points = (0..n).step_by(3).map(|first| point(first).into_value());
        match self.is_list {
            true => Value::list(points.collect()),
            false => points.next().unwrap_or(Value::None),
        }
    }

    /// The state of these numbers as messages tell it.
    fn rounded(&self, parts: &[f64]) -> Value {
        let six = |part: &f64| six_digits(*part, None).parse().unwrap_or(*part);
        self.value(&parts.iter().map(six).collect::<Vec<f64>>()).looked_at()
    }

    /// A function that fits, for hints.
    fn example(&self) -> &'static str {
        match self.is_list {
            true => "for example `(t, s) => [s[1], -s[0]]`",
            false => "for example `(t, p) => (-p.y, p.x)`",
        }
    }

    /// What the function yields at a place.
    fn rate(
        &self,
        ctx: &mut Ctx<'_>,
        f: &Spanned<Callback>,
        range: &SearchRange,
        (place, parts): (f64, &[f64]),
    ) -> Result<Vec<f64>> {
        self.asked(ctx, f, range, (place, parts)).map(|parts| self.flat(parts))
    }

    fn asked(
        &self,
        ctx: &mut Ctx<'_>,
        f: &Spanned<Callback>,
        range: &SearchRange,
        (place, parts): (f64, &[f64]),
    ) -> Result<Vec<Real>> {
        let args = [range.place(place).into_value(), self.value(parts)];
        let value = ctx.call(&f.value, &args).map_err(|mut found| {
            if found.code == Code::BadCall && found.primary.span == ctx.span {
                let hint =
                    format!("the function takes the variable and what changes, {}", self.example());
                found.hints.insert(0, hint);
            }
            found.others.retain(|other| other.span != ctx.span);
            if found.others.len() < MOST_LABELS {
                let (place, state) = (range.place_text(place), self.rounded(parts));
                found =
                    Box::new(found.also(ctx.span, format!("asked at {place}, {state} from here")));
            }
            found
        })?;
        let is_fit = match (&value, self.is_list) {
            (Value::Point(_) | Value::JetPoint(_), false) => true,
            (Value::List(items), true) => {
                let is_point = |item: &Value| matches!(item, Value::Point(_) | Value::JetPoint(_));
                items.len() == self.points.len() && items.iter().all(is_point)
            }
            _ => false,
        };
        if !is_fit {
            return self.misfit(&value, f.span);
        }
        let mut all = Vec::with_capacity(parts.len());
        numbers(&value, f.span, &mut all)?;
        Ok(all.into_iter().map(|part| part.value).collect())
    }

    fn misfit(&self, value: &Value, span: Span) -> Result<Vec<Real>> {
        let n = self.points.len();
        let wanted = match self.is_list {
            true => format!(
                "a list of {n} {}, as the start is",
                if n == 1 { "point" } else { "points" }
            ),
            false => "a point".to_owned(),
        };
        let found = match value {
            Value::List(items) if self.is_list && items.len() != n => {
                format!("a list of {}", items.len())
            }
            Value::List(items) if self.is_list => {
                let other = items.iter().find(|item| !matches!(item, Value::Point(_)));
                format!("a list with {}", other.map_or_else(|| value.phrase(), Value::phrase))
            }
            other => other.phrase(),
        };
        let message = format!("the function must yield {wanted}, but it yields {found}");
        Diagnostic::error(Code::WrongKind, span, message).hint(self.example()).fail()
    }

    /// The curves along which the points move.
    fn curves(&self, found: &Trajectory) -> std::result::Result<Value, GeomError> {
        let report = ConstructionReport::of(OP.name)
            .with("error", ReportEntry::Length(found.error))
            .with("steps", found.nodes.len() - 1)
            .with("evaluations", found.n_evaluations);
        let curve = |idx: usize| {
            let curve = NurbsCurve::of_trajectory(found, 3 * idx)?.with_report(report.clone());
            let Some(like) = &self.like else { return Ok(curve.into_value()) };
            let (n, n_variables) = (self.points.len(), like.slopes().len());
            let slopes = |variable: usize| -> std::result::Result<_, GeomError> {
                let slopes = NurbsCurve::of_trajectory(found, 3 * ((variable + 1) * n + idx))?;
                let points = slopes.control_points().iter();
                Ok((variable, points.map(|point| point.truncate().extend(0.0)).collect()))
            };
            let by_variable =
                (0..n_variables).map(slopes).collect::<std::result::Result<_, _>>()?;
            let slopes = PointSlopes::new(n_variables, curve.control_points().len(), by_variable)?;
            Ok(Value::JetCurve(Arc::new(VariedCurve::new(Arc::new(curve), slopes)?)))
        };
        match self.is_list {
            true => Ok(Value::list(
                (0..self.points.len()).map(curve).collect::<std::result::Result<_, _>>()?,
            )),
            false => curve(0),
        }
    }
}

/// The jet of a point that carries derivatives.
fn carried(point: &Vector) -> Option<Jet> {
    match point {
        Vector::Jets(jets) => Some(jets[0].clone()),
        Vector::Plain(_) => None,
    }
}

/// Why there is no trajectory.
fn refusal(
    err: TrajectoryError<Box<Diagnostic>>,
    span: Span,
    range: &SearchRange,
    state: &State,
) -> Box<Diagnostic> {
    let refused = |message, label, hint: &str| {
        Box::new(Diagnostic::error(Code::NoAnswer, span, message).label(label).hint(hint))
    };
    match err {
        TrajectoryError::Function(found) => found,
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
