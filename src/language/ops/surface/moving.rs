//! Derivatives of surfaces whose parameters a rule finds: they move with the points or sections.
//!
//! With the parameters listed the surface grows evenly with what it is made of; what it does when the
//! parameters move comes on top.

use std::sync::Arc;

use super::{PerDirection, section::SectionPlaces};
use crate::{
    diag::{Span, Spanned},
    kernel::{
        Curve, Ends, GeomError, Grid, GridLines, NurbsSurface, Parametrization, PointSlopes,
        SectionParameters, VariedCurve, VariedSurface,
    },
    ops::curve::fit::Parameters,
    value::{Call, FromValue, Record, Settling, Value, Vector, slopes_by_variable, varies},
};

/// Of a skin by a rule.
pub(super) static SKIN: Settling = Settling {
    parameter: "parameters",
    known: Some(skin_through_sections),
    held: Some(held_alignment),
    moving: Some((is_skin_by_rule, moving_skin)),
};

/// Of a surface through a grid of points.
pub(super) static GRID: Settling = Settling {
    parameter: "parameters",
    known: Some(grid_through_points),
    held: None,
    moving: None,
};

/// Of a network of curves.
pub(super) static NETWORK: Settling =
    Settling { parameter: "at_u", known: None, held: Some(held_meetings), moving: None };

/// Curves of a network that are run through as they are go on to meet at the parameters where they do, where they move
/// and meet at all.
fn held_meetings(report: &Record) -> Vec<(&'static str, Value)> {
    let is_as_given = |curve: &Value| {
        let Value::Record(curve) = curve else { return false };
        ["reversed", "trimmed", "reparametrized", "refitted"]
            .into_iter()
            .all(|change| matches!(curve.get(change), Some(Value::Bool(false))))
    };
    let are_as_given = ["u", "v"].into_iter().all(
        |family| matches!(report.get(family), Some(Value::List(all)) if all.iter().all(is_as_given)),
    );
    let is_whole = ["repeated_u", "repeated_v"]
        .into_iter()
        .all(|entry| matches!(report.get(entry), Some(Value::List(all)) if all.is_empty()));
    let found = |entry: &'static str| report.get(entry).map(|found| (entry, found.clone()));
    match (found("at_u"), found("at_v")) {
        (Some(at_u), Some(at_v)) if are_as_given && is_whole => vec![at_u, at_v],
        _ => Vec::new(),
    }
}

/// Sections that run beside one another as they are go on to do so where they move a little.
fn held_alignment(report: &Record) -> Vec<(&'static str, Value)> {
    match is_as_given(report) {
        true => vec![("align", Value::Bool(false))],
        false => Vec::new(),
    }
}

/// Whether a skin's sections are as they were given: none was turned around, and no seam or corner was moved.
pub(in crate::ops) fn is_as_given(report: &Record) -> bool {
    ["reversed", "moved_seams", "moved_corners"].into_iter().all(|entry| {
        report.get(entry).is_none_or(|found| matches!(found, Value::List(all) if all.is_empty()))
    })
}

fn has_only(call: &Call, names: &[&str]) -> bool {
    call.named.iter().all(|(name, _)| names.contains(&&*name.value))
}

/// An argument that has a name; its default where it is left out, none where it is something else.
fn named<T: FromValue>(call: &Call, name: &str, default: T) -> Option<T> {
    match call.named.iter().find(|(own, _)| &*own.value == name) {
        None => Some(default),
        Some((_, given)) => T::from_value(&given.value, given.span).ok(),
    }
}

fn is_skin_by_rule(call: &Call) -> bool {
    let rule = named(call, "parameters", SectionParameters::Average);
    rule.is_some_and(moves) && has_only(call, &["sections", "degree", "parameters", "align"])
}

/// Whether the parameters that a rule finds move with the sections.
pub(super) fn moves(rule: SectionParameters) -> bool {
    rule != SectionParameters::Uniform
}

/// A skin of sections as they are given, which tell the slopes of its control points.
fn skin_through_sections(
    call: &Call,
    skin: &Arc<NurbsSurface>,
    report: &Record,
) -> Result<Option<VariedSurface>, GeomError> {
    if !is_as_given(report) || !has_only(call, &["sections", "degree", "parameters", "align"]) {
        return Ok(None);
    }
    let rule = match named(call, "parameters", SectionPlaces::By(SectionParameters::Average)) {
        Some(SectionPlaces::By(rule)) => moves(rule).then_some(rule),
        Some(SectionPlaces::Listed(_)) => None,
        None => return Ok(None),
    };
    let degree = named(call, "degree", 3_usize);
    let found = report.get("parameters").map(|found| Vec::from_value(found, Span::default()));
    let (Some(degree), Some(Ok(found)), Some(sections)) = (degree, found, sections_of(call)?)
    else {
        return Ok(None);
    };
    VariedSurface::through_sections(skin, (degree, &found, rule), &sections)
}

/// The sections of a call; none where one of them is no spline, or none varies.
fn sections_of(call: &Call) -> Result<Option<Vec<Arc<VariedCurve>>>, GeomError> {
    let Some(Value::List(items)) = first_argument(call, "sections") else { return Ok(None) };
    let n_variables = items.iter().find_map(|item| match item {
        Value::JetCurve(varied) => Some(varied.slopes().n_variables()),
        _ => None,
    });
    let Some(n_variables) = n_variables else { return Ok(None) };
    let mut sections = Vec::with_capacity(items.len());
    for item in items.iter() {
        sections.push(match item {
            Value::JetCurve(varied) => Arc::clone(varied),
            Value::Curve(Curve::Nurbs(curve)) => {
                Arc::new(VariedCurve::fixed(Arc::clone(curve), n_variables)?)
            }
            _ => return Ok(None),
        });
    }
    Ok(Some(sections))
}

/// The first argument, by position or by its name.
fn first_argument<'c>(call: &'c Call, name: &str) -> Option<&'c Value> {
    let named = || call.named.iter().find(|(own, _)| &*own.value == name).map(|(_, given)| given);
    call.positional.first().or_else(named).map(|given| &given.value)
}

fn moving_skin(
    call: &Call,
    fixed: &VariedSurface,
    parameters: &Value,
) -> Result<Option<VariedSurface>, GeomError> {
    let rule = named(call, "parameters", SectionParameters::Average);
    let degree = named(call, "degree", 3_usize);
    let listed = Vec::<f64>::from_value(parameters, Span::default());
    let (Some(rule), Some(degree), Ok(listed)) = (rule, degree, listed) else { return Ok(None) };
    fixed.with_moving_sections(rule, degree, &listed)
}

/// A surface through points, which tell the slopes of its control points.
fn grid_through_points(
    call: &Call,
    surface: &Arc<NurbsSurface>,
    report: &Record,
) -> Result<Option<VariedSurface>, GeomError> {
    let others = ["degree", "parameters", "ends"];
    let is_still = |(name, given): &(Spanned<Arc<str>>, Spanned<Value>)| {
        &*name.value == "points" || others.contains(&&*name.value) && !varies(&given.value)
    };
    if !call.named.iter().all(is_still) {
        return Ok(None);
    }
    let rows = first_argument(call, "points")
        .and_then(|points| Vec::<Vec<Vector>>::from_value(points, Span::default()).ok());
    let by_chord = Parameters::By(Parametrization::Chord);
    let rules = named(call, "parameters", PerDirection { u: by_chord.clone(), v: by_chord });
    let degree = named(call, "degree", PerDirection { u: 3_usize, v: 3 });
    let ends = named(call, "ends", PerDirection { u: Ends::Bessel, v: Ends::Bessel });
    let found =
        report.get("parameters").map(|found| PerDirection::from_value(found, Span::default()));
    let (Some(rows), Some(rules), Some(degree), Some(ends), Some(Ok(found))) =
        (rows, rules, degree, ends, found)
    else {
        return Ok(None);
    };
    let found: PerDirection<Vec<f64>> = found;
    let vectors = Grid::from_rows(rows)?;
    let jets = |vector: &Vector| match vector {
        Vector::Jets(jets) => Some(jets[0].n_variables()),
        Vector::Plain(_) => None,
    };
    let Some(Some(n_variables)) = vectors.iter().find_map(jets) else { return Ok(None) };
    let moving = vectors.iter().enumerate().filter_map(|(idx, vector)| match vector {
        Vector::Jets(jets) => Some((idx, &**jets, 1.0)),
        Vector::Plain(_) => None,
    });
    let n_points = vectors.as_slice().len();
    let by_variable = slopes_by_variable([n_variables, n_points], moving);
    let slopes = PointSlopes::new(n_variables, n_points, by_variable)?;
    let lines = |rule: &Parameters, degree: usize, ends: Ends, parameters| GridLines {
        degree,
        ends,
        parameters,
        rule: match rule {
            Parameters::By(rule) => Some(*rule),
            Parameters::Listed(_) => None,
        },
    };
    let u = lines(&rules.u, degree.u, ends.u, &found.u);
    let v = lines(&rules.v, degree.v, ends.v, &found.v);
    VariedSurface::through_grid(surface, [u, v], &vectors.map(Vector::value), &slopes)
}
