//! Where a surface of a function is torn: lines of parameters are followed, and a gap that the tangents of
//! its ends do not explain is halved until it is gone, or its ends are neighbours.

use glam::DVec3;

use crate::{
    Bounds, Direction, GeomError, JumpError,
    frame::norm,
    surface::{ParametricSurface, Surface},
    tolerance::{GAP_FADES, GAP_RELATIVE, GAP_WIDTH_RELATIVE},
};

/// Lines that are followed along each parameter, and steps along each.
const LINES: usize = 16;
const STEPS: usize = 33;

/// Where in its share of the domain a line runs, lest it does so along a tear at a round number.
const SHIFT: f64 = 0.618_033_988_749_894_9;

/// Halvings over which a gap must fade.
const FADING: usize = 8;

/// A place on a line, with what the function says of it there; no derivative on a crease.
#[derive(Clone, Copy, Debug)]
struct LinePlace {
    at: f64,
    point: DVec3,
    tangent: Option<DVec3>,
}

impl LinePlace {
    /// How far it is to another place beyond what the tangents at both tell.
    fn gap(&self, other: &Self) -> f64 {
        let way = other.point - self.point;
        match (self.tangent, other.tangent) {
            (Some(a), Some(b)) => norm(way).min(norm(way - 0.5 * (other.at - self.at) * (a + b))),
            _ => norm(way),
        }
    }
}

impl Surface {
    /// That a function does not jump, as far as sixteen lines along each parameter show; a spline tells by its knots.
    ///
    /// # Errors
    /// [`JumpError::FunctionAt`], and as [`Self::point_at`].
    pub fn check_function(&self) -> Result<(), GeomError> {
        match self {
            Self::Nurbs(_) => Ok(()),
            Self::Parametric(surface) => surface.check_lines(),
        }
    }
}

impl ParametricSurface {
    fn check_lines(&self) -> Result<(), GeomError> {
        let mut lines = Vec::with_capacity(2 * LINES);
        for along in Direction::BOTH {
            for line in 0..LINES {
                let other = self.domain(along.other()).at((line as f64 + SHIFT) / LINES as f64);
                let step = |k: usize| self.domain(along).at(k as f64 / STEPS as f64);
                let places: Vec<LinePlace> = (0..=STEPS)
                    .map(|k| self.on_line(along, step(k), other))
                    .collect::<Result<_, _>>()?;
                lines.push((along, other, places));
            }
        }
        let points = lines.iter().flat_map(|(.., places)| places.iter().map(|place| place.point));
        let size = Bounds::of(points).map_or(0.0, Bounds::diagonal);
        for (along, other, places) in lines {
            let widest =
                places.windows(2).max_by(|a, b| a[0].gap(&a[1]).total_cmp(&b[0].gap(&b[1])));
            let Some(&[low, high]) = widest else { continue };
            self.follow(along, other, [low, high], size)?;
        }
        Ok(())
    }

    fn on_line(&self, along: Direction, at: f64, other: f64) -> Result<LinePlace, GeomError> {
        let [u, v] = along.pair(at, other);
        match self.derivatives_at(u, v, 1) {
            Ok(found) => {
                let tangent = if along == Direction::U { found.get(1, 0) } else { found.get(0, 1) };
                Ok(LinePlace { at, point: found.get(0, 0), tangent: Some(tangent) })
            }
            Err(_) => Ok(LinePlace { at, point: self.point_at(u, v)?, tangent: None }),
        }
    }

    /// Halves the step between two places towards the larger gap.
    fn follow(
        &self,
        along: Direction,
        other: f64,
        [mut low, mut high]: [LinePlace; 2],
        size: f64,
    ) -> Result<(), GeomError> {
        let narrow = GAP_WIDTH_RELATIVE * self.domain(along).length();
        let mut gaps = vec![low.gap(&high)];
        while let Some(&gap) = gaps.last().filter(|gap| GAP_RELATIVE * size < **gap) {
            let middle = 0.5 * (low.at + high.at);
            if middle <= low.at || high.at <= middle || high.at - low.at <= narrow {
                let before = gaps[gaps.len().saturating_sub(1 + FADING)];
                if gap <= GAP_FADES * before {
                    break;
                }
                let [u, v] = along.pair(high.at, other);
                return Err(JumpError::FunctionAt { u, v, gap }.into());
            }
            let middle = self.on_line(along, middle, other)?;
            let [left, right] = [low.gap(&middle), middle.gap(&high)];
            if left < right {
                low = middle;
            } else {
                high = middle;
            }
            gaps.push(left.max(right));
        }
        Ok(())
    }
}
