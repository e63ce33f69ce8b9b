//! Slopes of control points as lists.

use std::ops::Range;

use glam::DVec4;

/// Slopes by variables.
#[derive(Clone, Debug, Default)]
pub(super) struct ListedSlopes {
    /// Those that are not all zero, with the index of the variable, in order.
    pub(super) by_variable: Vec<(usize, Vec<DVec4>)>,
    /// For each of these, from which point on up to which one they are not zero.
    moving: Vec<Range<usize>>,
}

impl ListedSlopes {
    pub(super) fn new(by_variable: Vec<(usize, Vec<DVec4>)>) -> Self {
        let (by_variable, moving) = by_variable
            .into_iter()
            .filter_map(|own| nonzero(&own.1).map(|range| (own, range)))
            .unzip();
        Self { by_variable, moving }
    }

    /// Each variable with the points that it moves, and their slopes.
    pub(super) fn moving(&self) -> impl Iterator<Item = (usize, Range<usize>, &[DVec4])> {
        let pairs = self.by_variable.iter().zip(&self.moving);
        pairs.map(|((variable, slopes), moving)| (*variable, moving.clone(), &slopes[..]))
    }

    /// The same of one variable; none if it moves none.
    pub(super) fn moving_with(&self, variable: usize) -> Option<(Range<usize>, &[DVec4])> {
        let idx = self.by_variable.binary_search_by_key(&variable, |own| own.0).ok()?;
        Some((self.moving[idx].clone(), &self.by_variable[idx].1))
    }
}

/// From which slope on up to which one they are not zero; none where all are.
fn nonzero(slopes: &[DVec4]) -> Option<Range<usize>> {
    let moves = |slope: &DVec4| *slope != DVec4::ZERO;
    let first = slopes.iter().position(moves)?;
    Some(first..1 + slopes.iter().rposition(moves)?)
}
