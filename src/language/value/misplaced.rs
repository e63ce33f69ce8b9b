//! Arguments that stand otherwise than a call takes them: without brackets, or turned around. Each is told
//! with what to write, and read as it is meant.

use glam::DVec3;

use super::{Call, Mistakes, Op, OpParameter, Type, Value};
use crate::diag::{Code, Sources, Span, Spanned};

/// Puts arguments where they are meant, and tells so.
pub(super) fn correct(
    op: &Op,
    call: &mut Call,
    sources: Option<&Sources>,
    mistakes: &mut Mistakes,
) {
    bracket(op, call, sources, mistakes);
    bracket_points(op, call, sources, mistakes);
    turn_around(op, call, mistakes);
}

/// The text at a place, where it is short, on one line and at hand.
fn written(sources: Option<&Sources>, span: Span) -> Option<&str> {
    let source = sources?.at(span)?;
    let is_short = |text: &&str| text.chars().count() <= MOST_REPEATED && !text.contains('\n');
    source.text.get(source.local(span)).filter(is_short)
}

/// Where the first parameters are points, and numbers stand there as their coordinates: tells so, and reads
/// them as those points.
fn bracket_points(op: &Op, call: &mut Call, sources: Option<&Sources>, mistakes: &mut Mistakes) {
    let is_point = |param: &&OpParameter| param.ty == Type::Point && !param.may_be_left_out();
    let n_points = op.params.iter().take_while(is_point).count();
    let n_required = op.params.iter().filter(|param| !param.may_be_left_out()).count();
    let n_given = call.positional.len();
    let dimensions = [2, 3].into_iter().find(|n| n_required + (n - 1) * n_points == n_given);
    let (Some(n), true) = (dimensions, 0 < n_points && call.named.is_empty()) else { return };
    let numbers: Vec<f64> = call.positional[..n * n_points]
        .iter()
        .filter_map(|arg| match &arg.value {
            Value::Number(number) => Some(number.value),
            _ => None,
        })
        .collect();
    if numbers.len() < n * n_points {
        return;
    }
    let groups: Vec<Spanned<Value>> = call.positional.drain(..n * n_points).collect();
    let (mut points, mut texts) = (Vec::new(), Vec::new());
    for (arguments, numbers) in groups.chunks(n).zip(numbers.chunks(n)) {
        let span = arguments[0].span.to(arguments[n - 1].span);
        let point = DVec3::new(numbers[0], numbers[1], numbers.get(2).copied().unwrap_or(0.0));
        points.push(Spanned::new(Value::Point(point), span));
        texts.push(written(sources, span).map(|text| format!("({text})")));
    }
    let span = points[0].span.to(points[n_points - 1].span);
    let rest = call.positional.iter().map(|arg| written(sources, arg.span).map(str::to_owned));
    let texts: Option<Vec<String>> = texts.into_iter().chain(rest).collect();
    let hint = match texts {
        Some(texts) => format!("write `{}({})`", op.name, texts.join(", ")),
        None => "write `(x, y)` or `(x, y, z)`".to_owned(),
    };
    let text = "the coordinates of a point stand in round brackets".to_owned();
    mistakes.add(Code::BadCall, span, text, Some(hint));
    call.positional.splice(0..0, points);
}

/// Where the first parameter is a list, and elements of it stand there without brackets: tells so,
/// and reads them as that list.
fn bracket(op: &Op, call: &mut Call, sources: Option<&Sources>, mistakes: &mut Mistakes) {
    let Some(param) = op.params.first() else { return };
    let is_element = |arg: &Spanned<Value>| param.ty.is_list_of(&arg.value);
    let Some(first) = call.positional.first() else { return };
    if param.ty.accepts(&first.value) || !is_element(first) {
        return;
    }
    // A list further on is the one that was meant.
    if call.positional.iter().any(|arg| param.ty.accepts(&arg.value)) {
        return;
    }
    let is_like = |arg: &Spanned<Value>| arg.value.kind() == first.value.kind() && is_element(arg);
    let n_run = call.positional.iter().take_while(|arg| is_like(arg)).count();
    let rest = call.positional.len() - n_run + call.named.len();
    let run: Vec<Spanned<Value>> = call.positional.drain(..n_run).collect();
    let span = run[0].span.to(run[n_run - 1].span);
    let written = written(sources, span);
    let text = format!("`{}` is one list: its elements stand in brackets", param.name);
    let rest = if rest == 0 { "" } else { ", ..." };
    let hint = format!("write `{}([{}]{rest})`", op.name, written.unwrap_or("a, b, ..."));
    mistakes.add(Code::BadCall, span, text, Some(hint));
    let list = Value::list(run.into_iter().map(|arg| arg.value).collect());
    call.positional.insert(0, Spanned::new(list, span));
}

/// Characters of arguments that a hint repeats.
const MOST_REPEATED: usize = 60;

/// Where the first two arguments fit each in the place of the other, and not so as they stand: where they
/// are, and what to do.
#[must_use]
pub fn turned_around(op: &Op, call: &Call) -> Option<(Span, String)> {
    let ([a, b, ..], [first, second, ..]) = (&call.positional[..], op.params) else { return None };
    let fits = |param: &OpParameter, arg: &Spanned<Value>| param.ty.accepts(&arg.value);
    let is_turned = fits(first, b) && fits(second, a) && !fits(second, b);
    let hint = || format!("`{}` comes first, then `{}`", first.name, second.name);
    is_turned.then(|| (a.span.to(b.span), hint()))
}

/// Where two arguments stand the other way around: tells so, and turns them.
fn turn_around(op: &Op, call: &mut Call, mistakes: &mut Mistakes) {
    if let Some((span, hint)) = turned_around(op, call) {
        let text = "the arguments stand the other way around".to_owned();
        mistakes.add(Code::BadCall, span, text, Some(hint));
        call.positional.swap(0, 1);
    }
}
