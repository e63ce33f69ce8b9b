//! What a trajectory is of, as the script holds it and as numbers.

use std::sync::Arc;

use super::super::{MOST_LABELS, SearchRange, six_digits, unknowns::numbers};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        ConstructionReport, GeomError, Jet, NurbsCurve, PointSlopes, ReportEntry, Trajectory,
        VariedCurve,
    },
    value::{Callback, Ctx, FromValue, IntoValue, Real, Value, Vector},
};

/// What is followed, and how exactly.
pub(super) struct Search<'a> {
    pub(super) f: &'a Spanned<Callback>,
    pub(super) range: &'a SearchRange,
    pub(super) tolerance: f64,
    /// Whether the function took something that carries derivatives.
    pub(super) varies: bool,
}

/// What changes: one point, or several, with their slopes where derivatives are carried along. These follow the
/// equation that the derivative of the trajectory by a variable fulfils. Hairer, Nørsett & Wanner, §I.14.
pub(super) struct State {
    points: Vec<Vector>,
    is_list: bool,
    /// The shape of what is carried along.
    pub(super) like: Option<Jet>,
}

impl State {
    pub(super) fn new(start: &Spanned<Value>) -> Result<Self> {
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

    /// The same with derivatives of this shape.
    pub(super) fn varying_as(self, like: Jet) -> Self {
        Self { like: Some(like), ..self }
    }

    /// Of how many numbers it is without its slopes.
    pub(super) fn n_numbers(&self) -> usize {
        3 * self.points.len()
    }

    /// The coordinates of all points, then their slopes by each variable in turn.
    pub(super) fn start(&self) -> Vec<f64> {
        self.flat(&self.points.iter().flat_map(Vector::coordinates).collect::<Vec<Real>>())
    }

    pub(super) fn flat(&self, parts: &[Real]) -> Vec<f64> {
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
    pub(super) fn rounded(&self, parts: &[f64]) -> Value {
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
    pub(super) fn asked(
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

    /// The curves along which the points move, as an operation reports them.
    pub(super) fn curves(
        &self,
        found: &Trajectory,
        operation: &'static str,
    ) -> std::result::Result<Value, GeomError> {
        let report = ConstructionReport::of(operation)
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
