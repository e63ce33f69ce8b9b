//! Reader of aerofoils: points around a profile, below its name.
//!
//! Selig's form goes from the trailing edge along the upper side and back along the lower one. The
//! form of Lednicer tells how many points each side has, and both go from the leading edge; they are
//! brought to the order of Selig.

use glam::DVec3;

use crate::value::{Ctx, IntoValue, Value};

/// The points of a file, around the profile from the trailing edge over the upper side.
pub(super) fn read(bytes: &[u8], ctx: &Ctx<'_>) -> Result<Value, String> {
    let text = super::text(bytes)?;
    let lines = text.lines().enumerate().map(|(i, line)| (i + 1, line.trim()));
    let mut lines = lines.filter(|(_, line)| !line.is_empty()).peekable();
    // The name, which is left out of some files.
    if lines.next_if(|&(_, line)| pair(line).is_none()).is_none() && lines.peek().is_none() {
        return Err("line 1: the file is empty, or holds a name alone".to_owned());
    }
    let mut pairs = Vec::new();
    for (line, text) in lines {
        let wrong = || format!("line {line}: two coordinates are needed, found `{}`", short(text));
        pairs.push((line, pair(text).ok_or_else(wrong)?));
        if ctx.limits.list_length < pairs.len() {
            let most = ctx.limits.list_length;
            return Err(format!("the file has more than the {most} points that are allowed"));
        }
    }
    let points: Vec<DVec3> = pairs.iter().map(|&(_, [x, y])| DVec3::new(x, y, 0.0)).collect();
    // No coordinate of a profile of unit chord is beyond two.
    let points = match pairs.first() {
        Some(&(line, counts))
            if counts.iter().all(|count| 2.0 <= *count && count.fract() <= 0.0) =>
        {
            around(line, counts, &points[1..])?
        }
        _ => points,
    };
    if points.len() < 3 {
        let line = text.lines().count().max(1);
        let found = points.len();
        return Err(format!(
            "line {line}: the file ends, and a profile needs 3 points or more, found {found}"
        ));
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
