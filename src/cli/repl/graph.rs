//! `:plot`: functions over a range, curves, lists and tables as drawings in the terminal.

use glam::DVec2;

use super::{super::standard_streams::say, plot, prompt::Prompt, show};
use crate::{
    diag::Severity,
    kernel::{Column, Table},
    syntax::{Highlight, pieces},
    value::{Range, Value},
};

/// Points at which a function is plotted.
const N_SAMPLES: usize = 201;

/// Draws what stands behind `:plot`: functions together, anything else by itself.
pub(super) fn plot(prompt: &mut Prompt, text: &str) {
    if text.is_empty() {
        return prompt.refuse("what? `:plot EXPR`");
    }
    let (exprs, range) = match at_top(text, " in ").last() {
        Some(&at) if text[at..].contains("..") => (&text[..at], Some(text[at + 4..].trim())),
        _ => (text, None),
    };
    let mut exprs: Vec<String> = split(exprs).iter().map(|expr| (*expr).to_owned()).collect();
    for expr in &mut exprs {
        // `curvature(c)` lacks the parameter that it is plotted over.
        let completed = expr.strip_suffix(')').map(|head| format!("{head}, _)"));
        if let Some(completed) = completed.filter(|text| is_function_of_one(prompt, Some(text))) {
            *expr = completed;
        }
    }
    let Some(values) = prompt.asked("plot", &exprs.join(", ")) else { return };
    let is_function = |value: &Value| matches!(value, Value::Function(_));
    if values.len() == exprs.len() && values.iter().all(is_function) {
        if let Some(drawn) = functions(prompt, &exprs, range) {
            say(&drawn);
        }
        return;
    }
    for value in values {
        match drawn(&value, prompt.columns) {
            Some(text) => say(&text),
            None => prompt.refuse(&format!("{} cannot be plotted", value.phrase())),
        }
    }
}

/// Where a separator stands outside of brackets and strings.
fn at_top(text: &str, separator: &str) -> Vec<usize> {
    let (mut depth, mut is_text, mut found) = (0_usize, false, Vec::new());
    for (at, character) in text.char_indices() {
        match character {
            '"' => is_text = !is_text,
            _ if is_text => {}
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 && !is_text && text[at..].starts_with(separator) {
            found.push(at);
        }
    }
    found
}

/// The expressions of a list with commas between them.
fn split(text: &str) -> Vec<&str> {
    let (mut parts, mut from) = (Vec::new(), 0);
    for at in at_top(text, ",") {
        parts.push(text[from..at].trim());
        from = at + 1;
    }
    parts.push(text[from..].trim());
    parts.retain(|part| !part.is_empty());
    parts
}

/// Whether this text is a function while the call without its `_` has no value: asked quietly.
fn is_function_of_one(prompt: &mut Prompt, completed: Option<&str>) -> bool {
    let Some(completed) = completed else { return false };
    let plain = completed.replace(", _)", ")");
    let base = prompt.document.definitions() + "print";
    let mut has_value = |text: &str| {
        let ran = prompt.engine.run(&base, ' ', text, ["document", "input"])?;
        (ran.report.count(Severity::Error) == 0).then_some(())
    };
    has_value(&plain).is_none() && has_value(completed).is_some()
}

/// Functions of one number over a range: the given one, else the domain of the first curve that
/// they name, else 0..1.
fn functions(prompt: &mut Prompt, exprs: &[String], range: Option<&str>) -> Option<String> {
    let all = exprs.join(", ");
    let names: Vec<&str> = pieces(&all)
        .into_iter()
        .filter(|(paint, _)| *paint == Highlight::Name)
        .filter_map(|(_, place)| all.get(place))
        .collect();
    let domain = names.iter().find_map(|name| {
        let value = prompt.values.value(name)?;
        matches!(value, Value::Curve(_)).then(|| format!("{name}.domain"))
    });
    let range = range.map(str::to_owned).or(domain).unwrap_or_else(|| "0..1".to_owned());
    let (printed, _) = prompt.question(&range)?;
    let Some(Value::Range(ends)) = printed.into_iter().next().map(|printed| printed.value) else {
        prompt.refuse(&format!("behind `in` stands a range, as `0..1`; found `{range}`"));
        return None;
    };
    let mut paths = Vec::with_capacity(exprs.len());
    for expr in exprs {
        paths.push(samples(prompt, expr, &range, &ends)?);
    }
    let chart = plot::chart(&paths, prompt.columns);
    Some(if exprs.len() == 1 { chart } else { format!("{chart}({all})\n") })
}

/// A function at even places of a range; where it has no value its path is broken.
fn samples(prompt: &mut Prompt, expr: &str, range: &str, ends: &Range) -> Option<Vec<DVec2>> {
    let question = format!(
        "{{ let range_ = ({range}) let function_ = ({expr}); [for t in linspace(range_.start, range_.end, {N_SAMPLES}): [t, function_(t)]] }}"
    );
    let points: Vec<DVec2> = match quietly(prompt, &question) {
        Some(Value::List(pairs)) => pairs.iter().filter_map(point).collect(),
        _ => one_by_one(prompt, expr, ends)?,
    };
    if points.iter().all(|point| !point.is_finite()) {
        prompt.refuse("only functions with numbers as their values can be plotted");
        return None;
    }
    Some(points)
}

/// The same where the function fails at some places, which are counted; where it fails at all of
/// them it is told why.
fn one_by_one(prompt: &mut Prompt, expr: &str, ends: &Range) -> Option<Vec<DVec2>> {
    let (start, end) = (ends.start.value, ends.end.value);
    let place = |i: usize| start + (end - start) * i as f64 / (N_SAMPLES - 1) as f64;
    let call = |t: f64| {
        let number = crate::value::Number { value: t, ..ends.start };
        format!("({expr})({})", Value::Number(number))
    };
    let mut points = Vec::with_capacity(N_SAMPLES);
    let mut missing: Vec<f64> = Vec::new();
    for t in (0..N_SAMPLES).map(place) {
        match quietly(prompt, &call(t)) {
            Some(Value::Number(y)) => points.push(DVec2::new(t, y.value)),
            _ => {
                missing.push(t);
                points.push(DVec2::new(t, f64::NAN));
            }
        }
    }
    if missing.len() == N_SAMPLES {
        // Asked aloud, it says what is wrong.
        prompt.question(&call(start))?;
        return Some(points);
    }
    let first = plot::short(*missing.first()?, 5);
    prompt.voice.remark(&format!(
        "(no value at {} of {N_SAMPLES} places, the first at {first})",
        missing.len()
    ));
    Some(points)
}

/// The value of an expression, if it has one; nothing is told.
fn quietly(prompt: &mut Prompt, text: &str) -> Option<Value> {
    let base = prompt.document.definitions() + "print";
    let ran = prompt.engine.run(&base, ' ', text, ["document", "input"])?;
    if ran.report.count(Severity::Error) > 0 {
        return None;
    }
    ran.report.events.into_iter().find_map(|event| match event {
        crate::session::Event::Printed(printed) => Some(printed.value),
        _ => None,
    })
}

/// A pair of numbers as a point.
fn point(pair: &Value) -> Option<DVec2> {
    let Value::List(pair) = pair else { return None };
    match (pair.get(0), pair.get(1)) {
        (Some(Value::Number(x)), Some(Value::Number(y))) => Some(DVec2::new(x.value, y.value)),
        _ => None,
    }
}

/// Numbers one after the other.
fn in_a_row(numbers: &[f64], columns: usize) -> String {
    let points = numbers.iter().enumerate().map(|(i, &y)| DVec2::new(i as f64, y));
    plot::chart(&[points.collect()], columns)
}

/// The columns of a table over its first one; an only column in a row.
fn charted(table: &Table, columns: usize) -> Option<String> {
    let numbers: Vec<(&str, &[f64])> = table
        .columns()
        .iter()
        .filter_map(|column| match &column.column {
            Column::Numbers(numbers) => Some((column.name.as_str(), numbers.as_slice())),
            Column::Texts(_) => None,
        })
        .collect();
    let ((over, x), others) = numbers.split_first()?;
    if others.is_empty() {
        return Some(in_a_row(x, columns));
    }
    let path = |y: &[f64]| x.iter().zip(y).map(|(&x, &y)| DVec2::new(x, y)).collect();
    let paths: Vec<Vec<DVec2>> = others.iter().map(|(_, y)| path(y)).collect();
    let names: Vec<&str> = others.iter().map(|&(name, _)| name).collect();
    Some(format!("{}({} over {over})\n", plot::chart(&paths, columns), names.join(", ")))
}

/// A curve, points, numbers in a row, a table.
fn drawn(value: &Value, columns: usize) -> Option<String> {
    match value {
        Value::Table(table) => charted(table, columns),
        Value::List(items) if items.iter().all(|item| matches!(item, Value::Number(_))) => {
            let numbers: Vec<f64> = items
                .iter()
                .filter_map(|item| match item {
                    Value::Number(number) => Some(number.value),
                    _ => None,
                })
                .collect();
            (!numbers.is_empty()).then(|| in_a_row(&numbers, columns))
        }
        value => {
            let (paths, axes) = plot::flat(&show::shapes(value), None);
            let picture = plot::drawing(&paths, columns);
            (!picture.is_empty()).then(|| format!("{picture}({axes})\n"))
        }
    }
}
