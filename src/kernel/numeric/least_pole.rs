//! Whether what a search for a least value found is a pole.

use super::{
    answers::{Answers, Wanted},
    least_beside::{axis, free_ways},
    least_model::{Terms, magnitude},
    least_search::LeastSearch,
    pole_search::PoleSearch,
    sample::Sample,
};
use crate::tolerance::CONDITION_RELATIVE;

/// The place near that of the least value found in an interval near which the function falls without bound; none where
/// it does not. The function has no value where it answers none.
///
/// ```
/// use virote_kernel::{Sample, find_pole};
///
/// let logarithm = |x: f64| Ok::<_, ()>((x != 1.0).then(|| (x - 1.0).abs().ln()));
/// let near = Sample { at: 1.0 + 1e-9, value: 1e-9_f64.ln() };
/// assert!((find_pole(logarithm, [0.0, 5.0], near)?.expect("a pole") - 1.0).abs() < 1e-12);
/// let root = |x: f64| Ok::<_, ()>(Some((x - 1.0).abs().sqrt()));
/// assert_eq!(find_pole(root, [0.0, 5.0], Sample { at: 1.0, value: 0.0 })?, None);
/// // Where the interval ends it has a value, however low.
/// let steep = |x: f64| Ok::<_, ()>(Some(-1e300 * x * x));
/// assert_eq!(find_pole(steep, [0.0, 1.0], Sample { at: 1.0, value: -1e300 })?, None);
/// # Ok::<(), ()>(())
/// ```
///
/// # Errors
/// Those of the function.
pub fn find_pole<E>(
    mut function: impl FnMut(f64) -> Result<Option<f64>, E>,
    [start, end]: [f64; 2],
    least: Sample,
) -> Result<Option<f64>, E> {
    let width = end - start;
    let search = PoleSearch {
        best: (vec![least.at], least.value),
        n_ways: 1,
        go: |from: &[f64], _, reach: f64| {
            let at = (from[0] + reach * width).clamp(start, end);
            Ok(function(at)?.map(|value| (vec![at], value)))
        },
        spacing: |place: &[f64], _| spacing(place[0]) / width,
    };
    Ok(search.pole(&[0])?.map(|place| place[0]))
}

impl<F, E> LeastSearch<'_, F>
where
    F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
{
    /// Whether the function falls without bound near where the search ended; it goes there.
    pub(super) fn is_at_pole(&mut self) -> Result<bool, E> {
        let n = self.place.len();
        let terms = Terms {
            gradients: &self.slopes,
            values: &self.weighted(&self.values),
            limits: &self.limits(&self.place),
            n_equations: self.problem.n_equations,
        };
        let holding = terms.holding().unwrap_or_default();
        let held: Vec<usize> = holding.iter().map(|condition| condition.idx).collect();
        // Oblique ways first, which cross whatever has a pole.
        let mut ways = vec![oblique(&(0..n).map(|k| axis(n, k)).collect::<Vec<_>>())];
        let mut first_ways = vec![0];
        ways.extend((0..n).map(|k| axis(n, k)));
        let n_straight = ways.len();
        let free = if held.is_empty() { Vec::new() } else { free_ways(&holding, n) };
        if !free.is_empty() {
            first_ways.push(n_straight);
            ways.push(oblique(&free));
            ways.extend(free);
        }
        let ended = (self.place.clone(), self.values.clone());
        // Of what is flat by itself no value counts for more than it is.
        let share = self.weights[0].min(1.0);
        let best = (self.place.clone(), share * self.values[0]);
        let allowed = self.most_broken().max(CONDITION_RELATIVE);
        let units = self.units.clone();
        let search = PoleSearch {
            best,
            n_ways: ways.len(),
            go: |from: &[f64], way: usize, reach| {
                self.place = from.to_vec();
                let along = if way < n_straight { &[][..] } else { &held };
                let (place, values) = self.led_along(&ways[way], reach, along)?;
                let weighted = self.weighted(&values);
                let is_there = weighted.iter().all(|value| value.is_finite())
                    && self.problem.broken(&weighted).all(|broken| broken <= allowed);
                Ok(is_there.then(|| (place, share * values[0])))
            },
            spacing: |place: &[f64], way: usize| {
                let parts = place.iter().zip(&units).zip(&ways[way]);
                let moved = parts.filter(|(_, part)| MOVED_SHARE < part.abs());
                moved.map(|((x, unit), part)| spacing(*x) / (unit * part.abs())).fold(0.0, f64::max)
            },
        };
        let pole = search.pole(&first_ways)?;
        let is_pole = pole.is_some();
        (self.place, self.values) = ended;
        if let Some(place) = pole {
            self.values = self.asked.values(&place)?;
            self.place = place;
        }
        Ok(is_pole)
    }
}

/// The part of a way along an unknown that counts for how far along it places are apart.
const MOVED_SHARE: f64 = 0.1;

/// A way between some of length one, of length one, along all of them by different parts.
fn oblique(ways: &[Vec<f64>]) -> Vec<f64> {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let share = |k: usize| 1.0 + (golden * k as f64).fract();
    let part =
        |i: usize| -> f64 { ways.iter().enumerate().map(|(k, way)| share(k) * way[i]).sum() };
    let sum: Vec<f64> = (0..ways.first().map_or(0, Vec::len)).map(part).collect();
    let length = magnitude(&sum);
    sum.into_iter().map(|part| part / length).collect()
}

/// How far numbers are apart at one.
fn spacing(at: f64) -> f64 {
    at.abs().next_up() - at.abs()
}
