//! Splines one behind another as one, with no more knots at a joint than its continuity needs.

use glam::DVec4;

use super::{
    GeomError, KnotVector,
    refine::ControlLines,
    removal::removal,
    tolerance::{EXACT_RELATIVE, KNOT_RELATIVE, LAST_BIT},
};

/// Clamped splines of one degree that grow at their end; many lines share the knots.
pub(crate) struct Joined {
    degree: usize,
    knots: Vec<f64>,
    lines: Vec<Vec<DVec4>>,
}

impl Joined {
    /// The first splines, which are clamped.
    pub(crate) fn new(first: ControlLines) -> Self {
        let ControlLines { knots, lines } = first;
        Self { degree: knots.degree(), knots: knots.as_slice().to_vec(), lines }
    }

    /// The last control point of each line.
    pub(crate) fn ends(&self) -> Vec<DVec4> {
        self.lines.iter().map(|line| line[line.len() - 1]).collect()
    }

    /// Puts clamped splines of the same degree behind, their homogeneous points times a factor.
    /// Where a point differs from the one before they meet halfway. Of the joint's knots those go
    /// without which no line moves further than the accuracy.
    pub(crate) fn append(&mut self, next: &ControlLines, scale: f64, accuracy: f64) {
        let degree = self.degree;
        let joint = self.knots[self.knots.len() - 1];
        let shift = joint - next.knots.domain().start();
        self.knots.pop();
        let behind = &next.knots.as_slice()[degree + 1..];
        self.knots.extend(behind.iter().map(|knot| (knot + shift).max(joint)));
        let n_before = self.lines.first().map_or(0, Vec::len);
        for (line, next) in self.lines.iter_mut().zip(&next.lines) {
            line[n_before - 1] = (line[n_before - 1] + next[0] * scale) * 0.5;
            line.extend(next[1..].iter().map(|&point| point * scale));
        }

        // Take out what the joint does not need.
        for times in (1..=degree).rev() {
            let index = n_before + times - 1;
            let without = |line: &Vec<DVec4>| removal(degree, &self.knots, line, index);
            let removals: Vec<_> = self.lines.iter().map(without).collect();
            if removals.iter().any(|removal| accuracy < removal.displacement) {
                break;
            }
            for (line, removal) in self.lines.iter_mut().zip(removals) {
                line.splice(removal.range, removal.points);
            }
            self.knots.remove(index);
        }
    }

    /// # Errors
    /// Those of [`KnotVector::new`].
    pub(crate) fn finish(self) -> Result<ControlLines, GeomError> {
        Ok(ControlLines { knots: KnotVector::new(self.degree, self.knots)?, lines: self.lines })
    }
}

/// Last bits of a coordinate that pieces of one curve are apart when a knot between them is taken out.
const REMOVAL_ROUNDINGS: f64 = 64.0;

/// How far taking out a knot of a joint may move what has coordinates of that magnitude, and at most by `most`: what is
/// exact near the origin is much beside a tolerance far from it.
pub(crate) fn joint_accuracy(magnitude: f64, most: f64) -> f64 {
    let exact = EXACT_RELATIVE * magnitude;
    exact.min(most.max(REMOVAL_ROUNDINGS * LAST_BIT * magnitude))
}

/// The narrowest span of splines if it vanishes beside a domain of a length.
pub(crate) fn vanishing_span(knots: &KnotVector, total: f64) -> Option<f64> {
    let spans = knots.spans().map(|span| knots.span_interval(span).length());
    let length = spans.fold(f64::INFINITY, f64::min);
    // Twice, because the sum of the domains rounds.
    (length <= 2.0 * KNOT_RELATIVE * total).then_some(length)
}
