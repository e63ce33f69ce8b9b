//! Values in words: a line about a definition, and everything about one that somebody asks for.

use std::{sync::Arc, time::Duration};

use glam::DVec3;

use super::{
    super::reporter::{first_of, pretty},
    plot::{self, PlotSubject},
};
use crate::{
    export::View,
    ide::sized,
    kernel::{Column, Curve, Face, Mesh, Surface, Table, Tolerance},
    syntax::ast::Unit,
    value::{Dimension, Value, shortest},
};

/// Characters of a value that stand on one line.
const MOST_CHARS: usize = 100;
/// Rows of a table, points of a curve that are shown.
const MOST_ROWS: usize = 20;
/// Digits of a number in a table.
const DIGITS: usize = 8;
/// Points of a plotted curve.
const N_POINTS: usize = 300;
/// Isocurves of a plotted surface in each direction.
const N_ISOCURVES: usize = 7;

/// A definition on one line: its name with its value, or with its kind and size.
pub(super) fn line(name: &str, value: &Value, unit: Unit) -> String {
    match (brief(value, unit), value) {
        (Some(text), _) => format!("{name} = {text}"),
        (None, Value::Function(_)) => format!("{name}: function {}", sized(value)),
        (None, _) => format!("{name}: {}", sized(value)),
    }
}

/// The value itself where it is small and can be written.
fn brief(value: &Value, unit: Unit) -> Option<String> {
    let is_written = match value {
        Value::None | Value::Bool(_) | Value::Number(_) | Value::Point(_) | Value::Range(_) => true,
        Value::Text(text) => text.len() <= MOST_CHARS,
        Value::List(items) => {
            items.len() <= 12 && items.iter().all(|item| brief(item, unit).is_some())
        }
        Value::Record(record) => record.iter().all(|(_, value)| brief(value, unit).is_some()),
        _ => false,
    };
    let text = is_written.then(|| value.in_unit(unit.name()).to_string())?;
    (text.chars().count() <= MOST_CHARS).then_some(text)
}

/// All of a value, with a plot no wider than `columns` where there is something to draw.
pub(super) fn whole(value: &Value, unit: Unit, columns: usize, view: Option<View>) -> String {
    let mut text = match value {
        Value::Curve(curve) => of_curve(curve),
        Value::Surface(surface) => of_surface(surface),
        Value::Mesh(mesh) => of_mesh(mesh),
        Value::Table(table) => return of_table(table, columns),
        Value::Function(function) => function.signatures().join("\n") + "\n",
        _ => format!("{}\n", brief(value, unit).unwrap_or_else(|| sized(value))),
    };
    let shapes = shapes(value);
    let is_more_than_a_point = |shape: &PlotSubject| match shape {
        PlotSubject::Path(points) => 1 < points.len(),
        PlotSubject::Mesh(mesh) => 0 < mesh.n_triangles(),
    };
    if shapes.iter().any(is_more_than_a_point) {
        let (flat, axes) = plot::flat(&shapes, view);
        text.push_str(&format!("{}({axes})\n", plot::drawing(&flat, columns)));
    }
    text
}

fn of_curve(curve: &Curve) -> String {
    let mut text = format!("{}\n", Value::Curve(curve.clone()));
    let Ok(nurbs) = curve.nurbs() else { return text };
    text.push_str(&format!("knots: {}\n", numbers(nurbs.knots().as_slice())));
    let (points, weights) = (nurbs.points(), nurbs.weights());
    text.push_str("control points:\n");
    for (i, (point, weight)) in points.iter().zip(&weights).enumerate().take(MOST_ROWS) {
        text.push_str(&format!("  {i:>3}  {}", Value::Point(*point)));
        if nurbs.is_rational() {
            text.push_str(&format!("  weight {}", shortest(*weight)));
        }
        text.push('\n');
    }
    more(&mut text, points.len());
    text
}

fn of_surface(surface: &Surface) -> String {
    let mut text = format!("{}\n", Value::Surface(surface.clone()));
    if let Ok(nurbs) = surface.nurbs() {
        text.push_str(&format!("knots of u: {}\n", numbers(nurbs.knots_u().as_slice())));
        text.push_str(&format!("knots of v: {}\n", numbers(nurbs.knots_v().as_slice())));
        let net = nurbs.points();
        text.push_str("control points, a row for each index along u:\n");
        for i in 0..net.n_rows().min(MOST_ROWS) {
            let row = net.row(i).iter().map(|point| Value::Point(*point).to_string());
            let row: Vec<String> = row.collect();
            text.push_str(&format!("  {i:>3}  {}\n", cut(&row.join(" "), MOST_CHARS)));
        }
        more(&mut text, net.n_rows());
    }
    text
}

fn of_mesh(mesh: &Mesh) -> String {
    let mut text =
        format!("mesh of {} vertices and {} triangles\n", mesh.n_vertices(), mesh.n_triangles());
    if let Some(bounds) = mesh.bounds() {
        let [low, high] = [bounds.min, bounds.max].map(Value::Point);
        text.push_str(&format!("from {low} to {high}\n"));
    }
    text.push_str(&format!("area {}, volume {}\n", shortest(mesh.area()), shortest(mesh.volume())));
    text
}

fn numbers(numbers: &[f64]) -> String {
    let shown: Vec<String> = numbers.iter().take(4 * MOST_ROWS).map(|&n| shortest(n)).collect();
    let rest = numbers.len().saturating_sub(shown.len());
    let more = if rest == 0 { String::new() } else { format!(" ... and {rest} more") };
    shown.join(" ") + &more
}

fn more(text: &mut String, n: usize) {
    if n > MOST_ROWS {
        text.push_str(&format!("  ... and {} more\n", n - MOST_ROWS));
    }
}

/// The first rows of a table, as many columns as fit.
fn of_table(table: &Table, width: usize) -> String {
    let n_shown = table.n_rows().min(MOST_ROWS);
    let mut lines = vec![String::new(); n_shown + 1];
    let mut left_out = Vec::new();
    for column in table.columns() {
        let cell = |i: usize| match &column.column {
            Column::Numbers(numbers) => {
                let number = numbers.get(i).filter(|number| number.is_finite());
                number.map(|&number| plot::short(number, DIGITS)).unwrap_or_default()
            }
            Column::Texts(texts) => texts.get(i).cloned().unwrap_or_default(),
        };
        let head = match &column.unit {
            Some(unit) => format!("{} [{unit}]", column.name),
            None => column.name.clone(),
        };
        let cells: Vec<String> = std::iter::once(head)
            .chain((0..n_shown).map(cell))
            .map(|cell| cut(&cell, 24))
            .collect();
        let most = cells.iter().map(|cell| cell.chars().count()).max().unwrap_or(0);
        let used = lines[0].chars().count();
        if used > 0 && used + most + 2 > width.max(20) {
            left_out.push(column.name.as_str());
            continue;
        }
        for (line, cell) in lines.iter_mut().zip(cells) {
            line.push_str(&format!("{cell:>most$}  "));
        }
    }
    let mut text: String = lines.iter().map(|line| format!("{}\n", line.trim_end())).collect();
    more(&mut text, table.n_rows());
    if !left_out.is_empty() {
        text.push_str(&format!("  columns left out: {}\n", left_out.join(", ")));
    }
    text
}

/// A text, shortened where it is longer than `most` characters.
pub(super) fn cut(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        None => text.to_owned(),
        Some((end, _)) => format!("{} ...", &text[..end]),
    }
}

/// The edges of a face, and the isocurves of one that is a whole surface.
fn lines_of_face(face: &Face) -> Vec<PlotSubject> {
    let edges = face.edges(Tolerance::DEFAULT).unwrap_or_default();
    let mut lines: Vec<PlotSubject> = edges
        .into_iter()
        .flat_map(|edge| Curve::from(edge).sample(N_POINTS))
        .map(PlotSubject::Path)
        .collect();
    let surface = Surface::Nurbs(Arc::clone(face.surface()));
    if face.is_whole() {
        lines.extend(isocurves(&surface).into_iter().map(PlotSubject::Path));
    }
    lines
}

/// What can be drawn of a value.
pub(super) fn shapes(value: &Value) -> Vec<PlotSubject> {
    match value {
        Value::Curve(curve) => curve.sample(N_POINTS).into_iter().map(PlotSubject::Path).collect(),
        Value::Surface(surface) => isocurves(surface).into_iter().map(PlotSubject::Path).collect(),
        Value::Region(region) => {
            let borders = region.borders().unwrap_or_default().into_iter().map(Curve::from);
            borders.flat_map(|curve| curve.sample(N_POINTS)).map(PlotSubject::Path).collect()
        }
        Value::Face(face) => lines_of_face(face),
        Value::Solid(solid) => solid.faces().iter().flat_map(lines_of_face).collect(),
        Value::Mesh(mesh) => vec![PlotSubject::Mesh(mesh.clone())],
        Value::List(items) => {
            let points: Vec<DVec3> = items
                .iter()
                .filter_map(|item| match item {
                    Value::Point(point) => Some(*point),
                    _ => None,
                })
                .collect();
            let others = items.iter().filter(|item| !matches!(item, Value::Point(_)));
            let mut found: Vec<PlotSubject> = others.take(500).flat_map(shapes).collect();
            found.extend(Some(points).filter(|points| !points.is_empty()).map(PlotSubject::Path));
            found
        }
        Value::Record(record) => record.iter().flat_map(|(_, value)| shapes(value)).collect(),
        _ => Vec::new(),
    }
}

fn isocurves(surface: &Surface) -> Vec<Vec<DVec3>> {
    let (fine, coarse) = (N_POINTS / 4, N_ISOCURVES - 1);
    let along = |u: &[f64], v: &[f64], across: bool| -> Vec<Vec<DVec3>> {
        let at = |&a: &f64, &b: &f64| {
            let (u, v) = if across { (b, a) } else { (a, b) };
            surface.point_at(u, v).ok()
        };
        u.iter().map(|a| v.iter().filter_map(|b| at(a, b)).collect()).collect()
    };
    let (u, v) = (surface.domain_u(), surface.domain_v());
    let mut found = along(&u.steps(coarse), &v.steps(fine), false);
    found.extend(along(&v.steps(coarse), &u.steps(fine), true));
    found
}

/// Whether a value written as text reads back as itself.
pub(super) fn is_written(value: &Value) -> bool {
    match value {
        Value::None | Value::Bool(_) | Value::Text(_) | Value::Point(_) => true,
        Value::Number(number) => number.dim == Dimension::NONE,
        Value::List(items) => items.len() <= 1000 && items.iter().all(is_written),
        Value::Record(record) => record.iter().all(|(_, value)| is_written(value)),
        _ => false,
    }
}

/// What a new definition made evaluate again.
pub(super) fn evaluated(names: &[&str], n_reused: usize, time: Duration) -> String {
    let kept = if n_reused == 0 { String::new() } else { format!(", kept {n_reused}") };
    let time = pretty(time);
    if names.is_empty() {
        return format!("(nothing else depends on it{kept}; {time})");
    }
    format!("(evaluated {} again: {}{kept}; {time})", names.len(), first_of(names))
}
