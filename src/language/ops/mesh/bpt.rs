//! Reader of `.bpt`: Bézier patches as text.
//!
//! A count; then for each patch its two degrees, then its points row by row, three coordinates
//! each. White space separates; lines matter only in messages.

use glam::DVec3;

use super::lines::lines;
use crate::{
    kernel::{Grid, NurbsSurface},
    limits::work,
    value::{Ctx, ENDED, IntoValue, Value},
};

/// The patches of a file as a list of surfaces.
pub(super) fn read(text: &str, ctx: &Ctx<'_>) -> Result<Value, String> {
    let mut words = WordReader::new(text);
    let n_patches = words.count("the number of patches", ctx.limits.control_points)?;
    let mut patches = Vec::new();
    for i in 0..n_patches {
        let what = format!("patch {i} of {n_patches}");
        let degree_u = words.count(&format!("the first degree of {what}"), ctx.limits.degree)?;
        let degree_v = words.count(&format!("the second degree of {what}"), ctx.limits.degree)?;
        let mut points = Vec::with_capacity((degree_u + 1) * (degree_v + 1));
        for _ in 0..(degree_u + 1) * (degree_v + 1) {
            let mut point = DVec3::ZERO;
            for axis in 0..3 {
                point[axis] = words.number(&format!("a coordinate of {what}"))?;
            }
            if !work::push(&mut points, point) {
                return Err(ENDED.to_owned());
            }
        }
        let grid = Grid::new(degree_u + 1, degree_v + 1, points)
            .map_err(|err| format!("{what}: {err}"))?;
        let patch = NurbsSurface::bezier(&grid).map_err(|err| format!("{what}: {err}"))?;
        if !work::push(&mut patches, patch.into_value()) {
            return Err(ENDED.to_owned());
        }
    }
    match words.next() {
        None => Ok(Value::list(patches)),
        Some((line, word)) => {
            Err(format!("line {line}: `{word}` follows the last of {n_patches} patches"))
        }
    }
}

/// The words of a text with their lines.
struct WordReader<'t> {
    words: Box<dyn Iterator<Item = (usize, &'t str)> + 't>,
    last_line: usize,
}

impl<'t> WordReader<'t> {
    fn new(text: &'t str) -> Self {
        let words = lines(text).enumerate();
        let words =
            words.flat_map(|(i, line)| line.split_whitespace().map(move |word| (i + 1, word)));
        Self { words: Box::new(words), last_line: lines(text).count().max(1) }
    }

    fn next(&mut self) -> Option<(usize, &'t str)> {
        self.words.next()
    }

    fn word(&mut self, what: &str) -> Result<(usize, &'t str), String> {
        let last = self.last_line;
        self.next().ok_or_else(|| format!("line {last}: the file ends before {what}"))
    }

    fn count(&mut self, what: &str, most: usize) -> Result<usize, String> {
        let (line, word) = self.word(what)?;
        let count = word.parse().ok().filter(|count| *count <= most);
        count.ok_or_else(|| {
            format!("line {line}: {what} must be a whole number up to {most}, found `{word}`")
        })
    }

    fn number(&mut self, what: &str) -> Result<f64, String> {
        let (line, word) = self.word(what)?;
        let number = word.parse::<f64>().ok().filter(|number| number.is_finite());
        number.ok_or_else(|| format!("line {line}: {what} must be a number, found `{word}`"))
    }
}
