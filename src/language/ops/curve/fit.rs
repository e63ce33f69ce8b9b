//! What the operations that fit curves to points have in common.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{Ends, Parametrization, PointSlopes, check_parameters},
    value::{
        At, Call, Choice, FromValue, IntoValue, Mismatch, NoDerivative, Type, Value, Vector,
        rounded, slopes_by_variable,
    },
};

impl Choice for Parametrization {
    const WORDS: &'static [&'static str] = &["uniform", "chord", "centripetal", "foley"];
    const MEANINGS: &'static [Self] = &[Self::Uniform, Self::Chord, Self::Centripetal, Self::Foley];
}

impl Choice for Ends {
    const WORDS: &'static [&'static str] =
        &["bessel", "natural", "quadratic", "clamped", "not-a-knot", "averaged"];
    const MEANINGS: &'static [Self] = &[
        Self::Bessel,
        Self::Natural,
        Self::Quadratic,
        Self::Clamped,
        Self::NotAKnot,
        Self::Averaged,
    ];
}

/// Where points are to lie on a curve: a rule, or the parameters themselves.
#[derive(Clone, Debug)]
pub(in crate::ops) enum Parameters {
    By(Parametrization),
    Listed(Vec<f64>),
}

impl FromValue for Parameters {
    const TYPE: Type = Type::OneOf(&[Parametrization::TYPE, Type::List(&Type::Ratio, 0)]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Text(_) => Parametrization::from_value(value, span).map(Self::By),
            Value::List(_) | Value::Range(_) => Vec::from_value(value, span).map(Self::Listed),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

impl IntoValue for Parameters {
    const RETURNS: Type = Self::TYPE;

    fn into_value(self) -> Value {
        match self {
            Self::By(spacing) => spacing.into_value(),
            Self::Listed(parameters) => parameters.into_value(),
        }
    }
}

/// The default of curves that are fitted: by the distance of the points.
pub(super) fn chord() -> Spanned<Parameters> {
    Spanned::unplaced(Parameters::By(Parametrization::Chord))
}

/// Whether a call leaves it to a rule of smooth functions where points lie, so that parameters move with them.
pub(in crate::ops) fn moves_knots(call: &Call) -> bool {
    let parameters = call.named.iter().find(|(name, _)| &*name.value == "parameters");
    parameters.is_none_or(|(_, given)| match &given.value {
        Value::Text(rule) => matches!(&**rule, "chord" | "centripetal"),
        _ => false,
    })
}

/// The slopes of points, where these carry derivatives.
pub(in crate::ops) fn slopes_of(points: &[Vector], span: Span) -> Result<Option<PointSlopes>> {
    let jets = |vector: &Vector| match vector {
        Vector::Jets(jets) => Some(jets[0].clone()),
        Vector::Plain(_) => None,
    };
    let Some(first) = points.iter().find_map(jets) else { return Ok(None) };
    let Some(n_variables) = first.n_variables() else {
        let reason = NoDerivative::HigherOrder;
        let message = format!("`interpolate`: {}", reason.message());
        let error = Diagnostic::error(Code::NoDerivative, span, message);
        return error.hint(reason.hint()).fail();
    };
    let moving = points.iter().enumerate().filter_map(|(idx, point)| match point {
        Vector::Jets(jets) => Some((idx, &**jets, 1.0)),
        Vector::Plain(_) => None,
    });
    let by_variable = slopes_by_variable([n_variables, points.len()], moving);
    PointSlopes::new(n_variables, points.len(), by_variable).at(span).map(Some)
}

/// One parameter a point, different ones for neighbours.
pub(super) fn distinct_parameters(
    parameters: Spanned<Parameters>,
    points: Spanned<&[DVec3]>,
) -> Result<Vec<f64>> {
    match parameters.value {
        Parameters::Listed(listed) => {
            check_parameters(&listed, points.value.len()).at(parameters.span)?;
            Ok(listed)
        }
        Parameters::By(spacing) => {
            let found = spacing.parameters(points.value).at(points.span);
            found.map_err(|mistake| {
                let is_same = mistake.code == Code::Degenerate;
                let hint = "leave one of them out, or write `parameters = \"uniform\"`";
                if is_same { Box::new(mistake.hint(hint)) } else { mistake }
            })
        }
    }
}

/// One parameter a point, where neighbours at one place share theirs unless they are listed.
pub(super) fn loose_parameters(
    parameters: Spanned<Parameters>,
    points: Spanned<&[DVec3]>,
) -> Result<Vec<f64>> {
    match parameters.value {
        Parameters::Listed(_) => distinct_parameters(parameters, points),
        Parameters::By(spacing) => spacing.loose_parameters(points.value).at(points.span),
    }
}

/// The derivatives at both ends, neither of them zero.
pub(super) fn two_tangents(tangents: &Spanned<Vec<DVec3>>) -> Result<[DVec3; 2]> {
    let [start, end] = tangents.value[..] else {
        let message = format!(
            "`tangents` are two, at the start and at the end, found {}",
            tangents.value.len()
        );
        return Diagnostic::error(Code::BadCall, tangents.span, message).fail();
    };
    for (tangent, place) in [(start, "start"), (end, "end")] {
        if tangent.length() <= 0.0 {
            let message =
                format!("the tangent at the {place} has length 0, so that it has no direction");
            return Diagnostic::error(Code::Degenerate, tangents.span, message)
                .hint("a tangent is the derivative by the parameter: its length counts")
                .fail();
        }
    }
    Ok([start, end])
}

/// Warns where the curve swings out between two neighbouring points by more than their distance.
pub(super) fn swing(
    curve: &crate::kernel::NurbsCurve,
    points: &[DVec3],
    parameters: &[f64],
) -> Option<String> {
    let stray = |i: usize| {
        let middle = points[i].midpoint(points[i + 1]);
        let halfway = 0.5 * (parameters[i] + parameters[i + 1]);
        (curve.point_at(halfway).distance(middle), points[i].distance(points[i + 1]), i)
    };
    let worst = (0..points.len() - 1)
        .map(stray)
        .filter(|&(stray, leg, _)| leg < stray)
        .max_by(|a, b| a.0.total_cmp(&b.0))?;
    let (stray, leg, i) = worst;
    Some(format!(
        "between points {i} and {} the curve strays {} from their midpoint, although they are only {} apart",
        i + 1,
        rounded(stray),
        rounded(leg)
    ))
}
