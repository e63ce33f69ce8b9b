//! Reader of aerofoils: points around a profile, below its name.
//!
//! Selig's form goes from the trailing edge along the upper side and back along the lower one. The
//! form of Lednicer tells how many points each side has, and both go from the leading edge; they are
//! brought to the order of Selig.

use glam::DVec3;

use super::lines::lines;
use crate::{
    limits::work,
    value::{Ctx, ENDED, IntoValue, Value},
};

/// The points of a file, around the profile from the trailing edge over the upper side.
pub(super) fn read(text: &str, ctx: &Ctx<'_>) -> Result<Value, String> {
    let lines = lines(text).enumerate().map(|(i, line)| (i + 1, line.trim()));
    let mut lines = lines.filter(|(_, line)| !line.is_empty()).peekable();
    // The name, which is left out of some files.
    if lines.next_if(|&(_, line)| pair(line).is_none()).is_none() && lines.peek().is_none() {
        return Err("line 1: the file is empty, or holds a name alone".to_owned());
    }
    let mut first = None;
    let mut points = Vec::new();
    for (line, text) in lines {
        let wrong = || format!("line {line}: two coordinates are needed, found `{}`", short(text));
        let [x, y] = pair(text).ok_or_else(wrong)?;
        first = first.or(Some((line, [x, y])));
        if !work::push(&mut points, DVec3::new(x, y, 0.0)) {
            return Err(ENDED.to_owned());
        }
        if ctx.limits.list_length < points.len() {
            let most = ctx.limits.list_length;
            return Err(format!("the file has more than the {most} points that are allowed"));
        }
    }
    // No coordinate of a profile of unit chord is beyond two.
    let is_count = |count: &f64| 2.0 <= *count && count.fract() <= 0.0;
    let points = match first {
        Some((line, counts)) if counts.iter().all(is_count) => around(line, counts, &points[1..])?,
        _ => points,
    };
    if points.len() < 3 {
        let line = super::lines::lines(text).count().max(1);
        let found = points.len();
        return Err(format!(
            "line {line}: the file ends, and a profile needs 3 points or more, found {found}"
        ));
    }
    if !work::has_room(points.len() * size_of::<Value>()) {
        return Err(ENDED.to_owned());
    }
    Ok(points.into_value())
}

/// Both sides from the leading edge, as one way around.
fn around(line: usize, counts: [f64; 2], points: &[DVec3]) -> Result<Vec<DVec3>, String> {
    let [n_upper, n_lower] = counts.map(|count| count as usize);
    if n_upper.saturating_add(n_lower) != points.len() {
        let got = points.len();
        return Err(format!(
            "line {line} tells {n_upper} points above and {n_lower} below, but {got} follow"
        ));
    }
    let (upper, lower) = points.split_at(n_upper);
    let mut around: Vec<DVec3> = upper.iter().rev().copied().collect();
    // The leading edge belongs to both sides.
    let is_shared = upper.first() == lower.first();
    around.extend(lower.iter().skip(usize::from(is_shared)));
    Ok(around)
}

fn pair(line: &str) -> Option<[f64; 2]> {
    let separate = |c: char| c.is_whitespace() || c == ',';
    let mut words = line.split(separate).filter(|word| !word.is_empty());
    let mut next = || words.next()?.parse().ok().filter(|number: &f64| number.is_finite());
    let pair = [next()?, next()?];
    words.next().is_none().then_some(pair)
}

/// The beginning of a line, for a message.
fn short(line: &str) -> String {
    line.chars().take(40).collect()
}
