//! The parameters of a surface with the lines of its grid one unit apart.

use glam::DVec2;

use super::triangulation::BorderPolygon;
use crate::{CountError, Direction, GeomError, tolerance::CELL_HAIR};

/// How many cells a corner of the grid keeps away from the border at least.
const CLEARANCE: f64 = 0.4;

/// Parameters with the lines of a grid one unit apart.
pub(super) struct EvenPlane<'a> {
    pub(super) lines: &'a [Vec<f64>; 2],
}

impl EvenPlane<'_> {
    pub(super) fn place(&self, parameters: DVec2) -> DVec2 {
        let along = |along: Direction, t: f64| {
            let lines = &self.lines[along];
            let cell = lines.partition_point(|&line| line <= t).clamp(1, lines.len() - 1) - 1;
            cell as f64 + (t - lines[cell]) / (lines[cell + 1] - lines[cell])
        };
        DVec2::new(along(Direction::U, parameters.x), along(Direction::V, parameters.y))
    }

    pub(super) fn parameters(&self, place: DVec2) -> DVec2 {
        let along = |along: Direction, x: f64| {
            let lines = &self.lines[along];
            let cell = (x.max(0.0) as usize).min(lines.len() - 2);
            let fraction = x - cell as f64;
            // A line itself is met exactly.
            if fraction <= 0.0 {
                lines[cell]
            } else if 1.0 <= fraction {
                lines[cell + 1]
            } else {
                lines[cell] + fraction * (lines[cell + 1] - lines[cell])
            }
        };
        DVec2::new(along(Direction::U, place.x), along(Direction::V, place.y))
    }

    /// The crossings of lines within polygons and not near their sides.
    ///
    /// # Errors
    /// [`CountError::TooManyVertices`]; `GeomError::Ended`.
    pub(super) fn corners_inside(
        &self,
        rings: &[BorderPolygon],
        most: usize,
    ) -> Result<Vec<DVec2>, GeomError> {
        let sides: Vec<[DVec2; 2]> = rings
            .iter()
            .flat_map(|ring| {
                let n = ring.places.len();
                (0..n).map(move |i| [ring.places[i], ring.places[(i + 1) % n]])
            })
            .collect();
        let [n_u, n_v] = [self.lines[0].len(), self.lines[1].len()];
        let mut crossings: Vec<Vec<f64>> = vec![Vec::new(); n_u];
        let mut near: Vec<Vec<usize>> = vec![Vec::new(); n_u];
        let range = |low: f64, high: f64, n: usize| {
            (low.max(0.0).ceil() as usize)..((high.max(-1.0) + 1.0).floor() as usize).min(n)
        };
        for &[a, b] in &sides {
            GeomError::go_on(1)?;
            let (low, high) = (a.min(b), a.max(b));
            for i in range(low.x, high.x, n_u) {
                let x = i as f64;
                if (a.x <= x) != (b.x <= x) {
                    crossings[i].push(a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x)));
                }
            }
            for i in range(low.x - CLEARANCE, high.x + CLEARANCE, n_u) {
                for j in range(low.y - CLEARANCE, high.y + CLEARANCE, n_v) {
                    if distance(DVec2::new(i as f64, j as f64), [a, b]) < CLEARANCE {
                        near[i].push(j);
                    }
                }
            }
        }
        let mut inside = Vec::new();
        for (i, (mut crossings, mut near)) in crossings.into_iter().zip(near).enumerate() {
            GeomError::go_on(1)?;
            crossings.sort_by(f64::total_cmp);
            near.sort_unstable();
            let mut near = near.into_iter().peekable();
            for pair in crossings.chunks_exact(2) {
                for j in range(pair[0], pair[1], n_v) {
                    while near.next_if(|&at| at < j).is_some() {}
                    if near.peek() != Some(&j) {
                        inside.push(DVec2::new(i as f64, j as f64));
                    }
                }
            }
            if most < inside.len() {
                return Err(CountError::TooManyVertices { got: inside.len(), most }.into());
            }
        }
        Ok(inside)
    }
}

/// The numbers of the lines of constant u and of constant v that cross in a place with whole coordinates.
pub(super) fn lines_through(crossing: DVec2) -> [usize; 2] {
    [crossing.x as usize, crossing.y as usize]
}

/// The cells of `n` that come within a hair of what is between two coordinates.
pub(super) fn cells_along(low: f64, high: f64, n: usize) -> std::ops::Range<usize> {
    let first = (low - CELL_HAIR).max(0.0).floor() as usize;
    let end = (high + CELL_HAIR).max(-1.0).floor() + 1.0;
    first..(end as usize).min(n)
}

/// How far a place is from a side.
fn distance(place: DVec2, [a, b]: [DVec2; 2]) -> f64 {
    let leg = b - a;
    let along = (place - a).dot(leg) / leg.length_squared();
    let along = if along.is_finite() { along.clamp(0.0, 1.0) } else { 0.0 };
    place.distance(a + leg * along)
}
