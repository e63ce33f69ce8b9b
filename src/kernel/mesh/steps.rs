//! Lines of a grid along one direction of a surface.

use crate::{
    CountError, GeomError,
    ceiling::WIDTH_BISECTIONS,
    numeric::bisection::bisected,
    work::{self, PARTS_A_STEP},
};

/// Widths that cells may have over parts of an interval.
#[derive(Debug)]
pub(super) struct CellWidths<'a> {
    /// Where the parts begin and end.
    pub(super) ends: &'a [f64],
    pub(super) widths: &'a [f64],
}

impl CellWidths<'_> {
    /// Lines from one break to the next, of which any two neighbours are no further apart than is
    /// allowed in all parts that they touch, and as few as that takes.
    ///
    /// # Errors
    /// [`CountError::TooManyVertices`] for more than `most` of them.
    pub(super) fn lines(&self, breaks: &[f64], most: usize) -> Result<Vec<f64>, GeomError> {
        let parts = self.ends.windows(2).zip(self.widths);
        let about: f64 = parts.map(|(ends, width)| (ends[1] - ends[0]) / width).sum();
        if (most as f64) < about || about.is_nan() {
            return Err(CountError::TooManyVertices { got: about as usize, most }.into());
        }
        let mut lines = vec![breaks[0]];
        for pair in breaks.windows(2) {
            self.section([pair[0], pair[1]], &mut lines);
            GeomError::go_on(1)?;
        }
        Ok(lines)
    }

    /// Adds lines behind the start of a section up to its end: as many as steps of the whole width
    /// take, with steps that much narrower that the last is about as wide.
    fn section(&self, section: [f64; 2], lines: &mut Vec<f64>) {
        let n = self.count(section, 1.0);
        let narrow = if 2 * n < self.count(section, 0.5) || n < 2 { 0.0 } else { 0.5 };
        let is_enough = |factor: f64| self.count(section, factor) <= n;
        let [widest, _] = bisected([1.0, narrow], WIDTH_BISECTIONS, is_enough);
        self.walk(section, widest, |t| lines.push(t));
    }

    fn count(&self, section: [f64; 2], factor: f64) -> usize {
        let mut n = 0;
        self.walk(section, factor, |_| n += 1);
        n
    }

    /// Goes through a section by steps of a factor of the widths; not to its end when the work was ended.
    fn walk(&self, [start, end]: [f64; 2], factor: f64, mut each: impl FnMut(f64)) {
        let last = self.widths.len() - 1;
        let mut part = self.ends.partition_point(|&t| t <= start).saturating_sub(1).min(last);
        let (mut t, mut n_walked) = (start, 0);
        loop {
            n_walked += 1;
            if n_walked % PARTS_A_STEP == 0 && !work::goes_on(1) {
                break;
            }
            let next = self.step(t, &mut part, end, factor);
            // A step that rounding swallows would go on for ever.
            if end <= next || next <= t {
                break;
            }
            each(next);
            t = next;
        }
        each(end);
    }

    /// The end of a step from `t`, which is in a part; that of the step's end behind it.
    fn step(&self, t: f64, part: &mut usize, end: f64, factor: f64) -> f64 {
        let mut width = factor * self.widths[*part];
        while self.ends[*part + 1] < t + width && self.ends[*part + 1] < end {
            let border = self.ends[*part + 1];
            *part += 1;
            width = width.min(factor * self.widths[*part]).max(border - t);
            if width <= border - t {
                return border;
            }
        }
        t + width
    }
}
