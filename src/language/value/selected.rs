//! The matrix of an answer each of whose points moves with one given point: from few steps of all points at once.

use glam::{DMat3, DVec3};

use super::{
    affine::{Differences, HALVINGS},
    given_points::GivenPoint,
    mapped::{FEWEST, Question},
    numbers::{NumberPlaces, OTHER_NUMBER},
};
use crate::kernel::{PointFactors, tolerance::LAST_BIT};

/// What one of the given points reaches.
#[derive(Clone, Copy, Debug)]
enum OwnReach {
    /// No point of the answer, as what is inside of a net does not move its corners.
    Nothing,
    /// So few that each point may have its own; and whether it moves them along other coordinates than its own.
    Own { is_mixed: bool },
}

/// Which given points move.
type IsMoving<'m> = &'m dyn Fn(&GivenPoint) -> bool;

impl Differences<'_> {
    /// The matrix of an answer each of whose points moves with one given point, or with one of each set.
    pub(super) fn selected(&mut self, question: &Question<'_>) -> Option<PointFactors> {
        let reach = self.reach_of_one(question)?;
        let is_mixed = matches!(reach, OwnReach::Own { is_mixed: true });
        if !is_mixed && let Some(found) = self.selected_alike(question, &|_| true) {
            return Some(PointFactors::Alike(found));
        }
        if matches!(reach, OwnReach::Nothing) {
            return None;
        }
        let n_sets = question.given.sets.len();
        let by_set = (n_sets <= question.n_moving / FEWEST).then_some(0..n_sets)?;
        let mut all = Vec::new();
        for set in by_set {
            let is_own: IsMoving<'_> = &|own| own.set == set;
            if !question.given.moving.iter().any(is_own) {
                continue;
            }
            match is_mixed {
                true => all.extend(self.selected_mixed(question, is_own)?),
                false => all.extend(self.selected_alike(question, is_own)?.into_iter().map(
                    |(made, point, own)| (made, point, DMat3::from_diagonal(DVec3::splat(own))),
                )),
            }
        }
        Some(PointFactors::Mixed(all))
    }

    /// What a point in the midst of the first set reaches; none where that is so much that not each has its own.
    fn reach_of_one(&mut self, Question { given, answer, .. }: &Question<'_>) -> Option<OwnReach> {
        let set = given.moving.first()?.set;
        let own: Vec<&GivenPoint> = given.moving.iter().filter(|own| own.set == set).collect();
        let middle = own[own.len() / 2];
        let axis = middle.is_along.iter().position(|is_along| *is_along)?;
        let unit = DVec3::AXES[axis];
        let step =
            |_, other: &GivenPoint| if other.point == middle.point { unit } else { DVec3::ZERO };
        let (direction, _) = given.at_once(step);
        let (_, growth) = self.grown_along(&given.held, &direction, (1.0, &HALVINGS[..1]))?;
        let grown: Vec<DVec3> = vectors(&growth, answer)
            .map(|(_, own)| own)
            .filter(|own| *own != DVec3::ZERO)
            .collect();
        if grown.is_empty() {
            return Some(OwnReach::Nothing);
        }
        let is_mixed = grown.iter().any(|own| own - *own * unit != DVec3::ZERO);
        let has_each_its_own = grown.len() * own.len() <= answer.points.len();
        has_each_its_own.then_some(OwnReach::Own { is_mixed })
    }

    /// Of what does the same to each coordinate: all points are moved along the first coordinate alike, and along the
    /// second as far as their index says.
    fn selected_alike(
        &mut self,
        Question { given, answer, .. }: &Question<'_>,
        is_moving: IsMoving<'_>,
    ) -> Option<Vec<(usize, usize, f64)>> {
        let n = given.moving.len() as f64;
        let step = |idx: usize, own: &GivenPoint| {
            if is_moving(own) { DVec3::new(1.0, (idx + 1) as f64 / n, 0.0) } else { DVec3::ZERO }
        };
        let (direction, _) = given.at_once(step);
        let (step, growth) = self.grown_along(&given.held, &direction, (1.0, &HALVINGS[..1]))?;
        let mut factors = Vec::new();
        for (made, own) in vectors(&growth, answer).filter(|(_, own)| 0.0 < own.x.abs()) {
            let point = selected_point(given.moving.as_slice(), own.y / own.x)?;
            factors.push((made, point, own.x / step));
        }
        Some(factors)
    }

    /// Of what mixes coordinates: all points are moved along each coordinate alike, and then along all as far as their
    /// index says.
    fn selected_mixed(
        &mut self,
        Question { given, answer, .. }: &Question<'_>,
        is_moving: IsMoving<'_>,
    ) -> Option<Vec<(usize, usize, DMat3)>> {
        let n = given.moving.len() as f64;
        let along = |own: &GivenPoint, axis: usize| {
            if is_moving(own) && own.is_along[axis] { DVec3::AXES[axis] } else { DVec3::ZERO }
        };
        let n_made = answer.points.len();
        let (mut matrices, mut sums) = (vec![DMat3::ZERO; n_made], vec![DVec3::ZERO; n_made]);
        for axis in 0..3 {
            if !given.moving.iter().any(|own| along(own, axis) != DVec3::ZERO) {
                continue;
            }
            let (direction, _) = given.at_once(|_, own| along(own, axis));
            let (step, growth) =
                self.grown_along(&given.held, &direction, (1.0, &HALVINGS[..1]))?;
            for (made, own) in vectors(&growth, answer) {
                *matrices[made].col_mut(axis) = own / step;
                sums[made] += own / step;
            }
        }
        let (direction, _) = given.at_once(|idx, own| {
            let all: DVec3 = (0..3).map(|axis| along(own, axis)).sum();
            all * ((idx + 1) as f64 / n)
        });
        let (step, growth) = self.grown_along(&given.held, &direction, (1.0, &HALVINGS[..1]))?;
        let mut factors = Vec::new();
        for (made, own) in vectors(&growth, answer).filter(|(made, _)| sums[*made] != DVec3::ZERO) {
            let share = (own / step).dot(sums[made]) / sums[made].length_squared();
            let point = selected_point(given.moving.as_slice(), share)?;
            factors.push((made, point, matrices[made]));
        }
        Some(factors)
    }
}

/// The given point whose index is this share of all.
fn selected_point(moving: &[GivenPoint], share: f64) -> Option<usize> {
    let place = share * moving.len() as f64;
    let is_whole = (place - place.round()).abs() <= LAST_BIT.sqrt();
    let idx = is_whole.then_some(place.round() as usize)?;
    Some(moving.get(idx.checked_sub(1)?)?.point)
}

/// By how much each point of an answer grows, with its place among all points and other numbers.
fn vectors<'g>(
    growth: &'g [f64],
    answer: &'g NumberPlaces,
) -> impl Iterator<Item = (usize, DVec3)> + 'g {
    let of = |(made, &first): (usize, &usize)| {
        let is_point = answer.numbers[first].0 != OTHER_NUMBER;
        is_point.then(|| (made, DVec3::from_slice(&growth[first..])))
    };
    answer.points.iter().enumerate().filter_map(of)
}
