//! Umbilics: places where a surface bends equally in all directions.
//!
//! The second fundamental tensor less its mean has two entries, (a − c)/2 and b over axes along Su and
//! across. As a plane vector they turn once around where one goes around an umbilic, so that a
//! rectangle of parameters around whose corners they do has one inside, and so has one of its four
//! parts. do Carmo, *Differential Geometry of Curves and Surfaces*, §3-2; Porteous, *Geometric
//! Differentiation*, §11.

use std::f64::consts::{PI, TAU};

use super::{Defects, Edge, Surface};
use crate::kernel::{
    GeomError, Interval, KnotVector, Tolerance,
    tolerance::{LAST_BIT, TOUCH_RELATIVE},
};

/// Places along a direction, in each piece or of all of a function, fewer where the pieces are many.
const PLACES: usize = 64;
const FEWEST: usize = 4;
const MOST: usize = 32;

/// Where rectangles are cut: no half, so that umbilics of symmetric surfaces are not on the cut.
const CUT: f64 = 0.4871;

/// Cuts, to the last bit of a parameter.
const MAX_CUTS: usize = 60;

/// Parameters, with how unequally the surface bends there, along Su and across and in between.
#[derive(Clone, Copy)]
struct Bend {
    at: [f64; 2],
    uneven: [f64; 2],
    /// What rounding leaves of that.
    rounding: f64,
}

impl Surface {
    /// The parameters of the isolated umbilics, poles among them, as far as a grid of some thousand
    /// places shows them. Of a sphere and a plane none is isolated.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn umbilics(
        &self,
        defects: &Defects,
        tolerance: Tolerance,
    ) -> Result<Vec<[f64; 2]>, GeomError> {
        let [us, vs] = self.umbilic_grid(&defects.collapsed, tolerance)?;
        let rows = us.iter().map(|&u| {
            let bends = vs.iter().map(|&v| self.bend_at([u, v], tolerance));
            bends.collect::<Vec<_>>()
        });
        let bends: Vec<Vec<Option<Bend>>> = rows.collect();
        let mut found = Vec::new();
        for (below, above) in bends.iter().zip(bends.iter().skip(1)) {
            for (low, high) in below.windows(2).zip(above.windows(2)) {
                let corners = [low[0], high[0], high[1], low[1]];
                if let [Some(a), Some(b), Some(c), Some(d)] = corners {
                    found.extend(self.umbilic_within([a, b, c, d], tolerance));
                }
            }
        }
        let has_others = bends.iter().flatten().flatten().any(|bend| !bend.is_even());
        for edge in defects.collapsed.iter().filter(|_| has_others) {
            let [u, v] = [self.domain_u(), self.domain_v()].map(Interval::start);
            let at = match edge {
                Edge::U0 | Edge::V0 => [u, v],
                Edge::U1 => [self.domain_u().end(), v],
                Edge::V1 => [u, self.domain_v().end()],
            };
            found.extend(self.bend_at(at, tolerance).filter(Bend::is_even).map(|bend| bend.at));
        }
        Ok(found)
    }

    /// Places inside of the pieces, and the ends that are no poles; where the surface closes the first
    /// again instead, beyond the end.
    fn umbilic_grid(
        &self,
        poles: &[Edge],
        tolerance: Tolerance,
    ) -> Result<[Vec<f64>; 2], GeomError> {
        let inside = |piece: Interval, n: usize| {
            (0..n).map(move |i| piece.at((i as f64 + 0.5) / n as f64)).collect::<Vec<_>>()
        };
        let of_knots = |knots: &KnotVector| -> Vec<f64> {
            let pieces: Vec<usize> = knots.spans().collect();
            let n = (PLACES / pieces.len()).clamp(FEWEST, MOST);
            pieces.into_iter().flat_map(|span| inside(knots.span_interval(span), n)).collect()
        };
        let mut all = match self {
            Self::Nurbs(surface) => [of_knots(surface.knots_u()), of_knots(surface.knots_v())],
            Self::Parametric(_) => {
                [self.domain_u(), self.domain_v()].map(|domain| inside(domain, PLACES))
            }
        };
        let distance = tolerance.distance;
        let is_closed = [self.is_closed_u(distance)?, self.is_closed_v(distance)?];
        for (i, domain) in [self.domain_u(), self.domain_v()].into_iter().enumerate() {
            if is_closed[i] {
                let first = all[i][0] + domain.length();
                all[i].push(first);
                continue;
            }
            let [start, end] = if i == 0 { [Edge::U0, Edge::U1] } else { [Edge::V0, Edge::V1] };
            if !poles.contains(&start) {
                all[i].insert(0, domain.start());
            }
            if !poles.contains(&end) {
                all[i].push(domain.end());
            }
        }
        Ok(all)
    }

    /// `None` where the surface has no curvatures.
    fn bend_at(&self, at: [f64; 2], tolerance: Tolerance) -> Option<Bend> {
        let domains = [self.domain_u(), self.domain_v()];
        let [u, v] = [0, 1].map(|i| {
            let beyond = domains[i].end() < at[i];
            if beyond { at[i] - domains[i].length() } else { at[i] }
        });
        let shape = self.shape_at(u, v).ok()?;
        let [a, b, c] = shape.tensor;
        let largest = a.abs().max(b.abs()).max(c.abs());
        let rounding = shape.flat_below(tolerance).max(tolerance.angle * largest);
        Some(Bend { at, uneven: [0.5 * (a - c), b], rounding })
    }

    /// The umbilic between four corners, counterclockwise, if there is one.
    fn umbilic_within(&self, corners: [Bend; 4], tolerance: Tolerance) -> Option<[f64; 2]> {
        if corners.iter().any(Bend::is_even) || !turns_around(&corners) {
            return None;
        }
        let size = corners.iter().map(Bend::size).fold(0.0, f64::max);
        let mut inside = corners;
        for _ in 0..MAX_CUTS {
            let [a, b, c, d] = inside;
            let cut = [0, 1].map(|i| a.at[i] * (1.0 - CUT) + c.at[i] * CUT);
            let look = |u: f64, v: f64| self.bend_at([u, v], tolerance);
            let middle = look(cut[0], cut[1])?;
            let [low, right] = [look(cut[0], a.at[1])?, look(c.at[0], cut[1])?];
            let [high, left] = [look(cut[0], c.at[1])?, look(a.at[0], cut[1])?];
            let parts = [
                [a, low, middle, left],
                [low, b, right, middle],
                [middle, right, c, high],
                [left, middle, high, d],
            ];
            let Some(part) = parts.into_iter().find(turns_around) else { break };
            inside = part;
            let is_last = |i: usize| {
                (inside[2].at[i] - inside[0].at[i]).abs() <= 4.0 * LAST_BIT * inside[2].at[i].abs()
            };
            if is_last(0) && is_last(1) {
                break;
            }
        }
        // Where second derivatives jump they may turn around without an umbilic.
        let least = inside.iter().min_by(|a, b| a.size().total_cmp(&b.size()))?;
        (least.size() <= TOUCH_RELATIVE * size).then(|| {
            let domains = [self.domain_u(), self.domain_v()];
            [0, 1].map(|i| {
                let t = 0.5 * (inside[0].at[i] + inside[2].at[i]);
                if domains[i].end() < t { t - domains[i].length() } else { t }
            })
        })
    }
}

impl Bend {
    fn size(&self) -> f64 {
        libm::hypot(self.uneven[0], self.uneven[1])
    }

    fn is_even(&self) -> bool {
        self.size() <= self.rounding
    }
}

/// Whether the entries turn around once where one goes around the corners.
fn turns_around(corners: &[Bend; 4]) -> bool {
    let angles = corners.map(|bend| libm::atan2(bend.uneven[1], bend.uneven[0]));
    let turn = |i: usize| {
        let turn = angles[(i + 1) % 4] - angles[i];
        turn - TAU * (turn / TAU).round()
    };
    PI < (0..4).map(turn).sum::<f64>().abs()
}
