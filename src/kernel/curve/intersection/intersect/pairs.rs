//! Pieces of two curves that are near to one another.

use std::sync::Arc;

use super::{meeting::IntersectionSearch, newton::nearest_step};
use crate::{
    Bounds, GeomError,
    curve::representation::part::{CurvePart, parts},
    homogeneous,
    nearest::BoxedPiece,
    sorting::sort_by,
};

/// A piece of each curve.
pub(super) type PartPair = (Arc<CurvePart>, Arc<CurvePart>);

/// Chords that cross no further than this beyond their ends, in their lengths, may be of pieces that
/// cross.
const BESIDE: f64 = 0.5;

impl BoxedPiece for CurvePart {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn halves(&self) -> [Self; 2] {
        Self::halves(self)
    }
}

impl IntersectionSearch<'_> {
    /// The pieces of both curves that may meet, in order. Those of the curve with fewer are halved
    /// until they are no larger than what they are near to, lest a long one is near to all that its
    /// box holds.
    ///
    /// # Errors
    /// `IntersectionError::RunTogether` where two pieces are the same curve.
    pub(super) fn near_pairs(&self) -> Result<Vec<PartPair>, GeomError> {
        let is_turned = self.second.n_segments() < self.first.n_segments();
        let both = [self.first, self.second];
        let [few, many] = if is_turned { [both[1], both[0]] } else { both };
        let wholes: [Vec<Arc<CurvePart>>; 2] =
            [few, many].map(|curve| parts(curve).into_iter().map(Arc::new).collect());
        let starts: Vec<f64> = wholes[0].iter().map(|part| part.interval.start()).collect();
        let mut near = Vec::new();
        for (piece, [_, j]) in many.piece_boxes().near_pieces(wholes[0].clone(), self.tolerance) {
            if piece.may_meet(&wholes[1][j], self.tolerance) {
                let middle = piece.interval.at(0.5);
                let i = starts.partition_point(|&start| start <= middle).saturating_sub(1);
                near.push((if is_turned { [j, i] } else { [i, j] }, piece));
            }
        }
        sort_by(&mut near, |(a, first), (b, second)| {
            a.cmp(b).then(first.interval.start().total_cmp(&second.interval.start()))
        });
        let mut pairs = Vec::with_capacity(near.len());
        let mut last = None;
        for (spans, piece) in near {
            let [i, j] = if is_turned { [spans[1], spans[0]] } else { spans };
            let whole = &wholes[1][j];
            let in_order = |few: &Arc<CurvePart>| match is_turned {
                true => (Arc::clone(whole), Arc::clone(few)),
                false => (Arc::clone(few), Arc::clone(whole)),
            };
            if last != Some(spans) {
                let (first, second) = in_order(&wholes[0][i]);
                self.check_shared(&first, &second)?;
                last = Some(spans);
            }
            pairs.push(in_order(&piece));
        }
        Ok(pairs)
    }
}

/// Parameters near where two pieces cross, if they do: where their chords come nearest to one another.
/// `None` where that is far beyond their ends, or the chords are parallel.
pub(super) fn near_crossing(a: &CurvePart, b: &CurvePart) -> Option<[f64; 2]> {
    let ends = |part: &CurvePart| {
        [part.points[0], part.points[part.points.len() - 1]].map(homogeneous::project)
    };
    let ([from, to], [start, end]) = (ends(a), ends(b));
    let fractions = nearest_step(from - start, to - from, end - start)?;
    let is_beside = |fraction: &f64| (-BESIDE..=1.0 + BESIDE).contains(fraction);
    let at = [a, b].map(|part| part.interval);
    fractions.iter().all(is_beside).then(|| [0, 1].map(|i| at[i].at(fractions[i].clamp(0.0, 1.0))))
}
