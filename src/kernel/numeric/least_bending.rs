//! How a function bends where a search for its least value settled.

use super::quadratic_program::dot;
use crate::tolerance::LEAST_BEND_RELATIVE;

/// How a function bends.
pub(super) struct Bending {
    /// Ways that are left free, so long that it bends by one along each.
    pub(super) ways: Vec<Vec<f64>>,
    /// By how much longer than one they are.
    pub(super) stretch: Vec<f64>,
    /// The axes of its curvature by those ways, each with how it bends along it.
    pub(super) axes: Vec<(f64, Vec<f64>)>,
    /// The conditions that hold the place.
    pub(super) held: Vec<usize>,
    /// What each function counts for in it: those that hold the place by how much they do.
    pub(super) shares: Vec<f64>,
}

impl Bending {
    /// The step of Newton's method by the slopes along the ways; none where the function does not clearly bend up along
    /// all of them.
    pub(super) fn newton_step(&self, slopes: &[f64]) -> Option<Vec<f64>> {
        let most = self.axes.iter().map(|(bend, _)| *bend).fold(0.0, f64::max);
        let mut step = vec![0.0; self.ways.first()?.len()];
        for (bend, axis) in &self.axes {
            if *bend <= LEAST_BEND_RELATIVE * most {
                return None;
            }
            let share = -dot(slopes, axis) / bend;
            for (way, part) in self.ways.iter().zip(axis) {
                step.iter_mut().zip(way).for_each(|(step, along)| *step += share * part * along);
            }
        }
        Some(step)
    }
}

/// How functions change together along ways, by their gradients and what each counts for.
pub(super) fn slopes_along(ways: &[Vec<f64>], gradients: &[Vec<f64>], shares: &[f64]) -> Vec<f64> {
    let slope = |way: &Vec<f64>| {
        gradients.iter().zip(shares).map(|(slopes, share)| share * dot(slopes, way)).sum()
    };
    ways.iter().map(slope).collect()
}
