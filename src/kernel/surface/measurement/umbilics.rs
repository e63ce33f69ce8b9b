//! Umbilics: places where a surface bends equally in all directions.
//!
//! The second fundamental tensor less its mean has two entries, (a − c)/2 and b over axes along Su and
//! across. Newton's method finds where both vanish, from each rectangle of a grid of parameters in
//! and beside which they may. do Carmo, *Differential Geometry of Curves and Surfaces*, §3-2; Porteous,
//! *Geometric Differentiation*, §11.

use std::{convert::Infallible, f64::consts::TAU, ops::ControlFlow};

use glam::{DMat2, DVec2};

use crate::{
    GeomError, Interval, KnotVector, Tolerance,
    ceiling::{SLOW_UMBILIC_STEPS, UMBILIC_STEP_HALVINGS, UMBILIC_STEPS},
    numeric::newton::shortened,
    surface::{Edge, Surface, SurfaceDefects},
    tolerance::{
        LAST_BIT, TOUCH_RELATIVE, UMBILIC_CIRCLE, UMBILIC_CLEAR, UMBILIC_DIFFERENCE, UMBILIC_SHARE,
    },
};

/// Places along a direction, in each piece or of all of a function, fewer where the pieces are many.
const PLACES: usize = 64;
const FEWEST: usize = 4;
const MOST: usize = 32;

/// A step is slow where it leaves more than this share.
const SLOW: f64 = 0.9;

/// Rectangles beyond its own that a search may go to.
const BEYOND: f64 = 1.0;

/// Looks on a circle around a place at which the slopes of both entries are nearly parallel.
const N_LOOKS: usize = 32;

/// Parameters, with how unequally the surface bends there, along Su and across and in between.
#[derive(Clone, Copy)]
struct CurvatureDifference {
    at: DVec2,
    uneven: DVec2,
    /// What rounding leaves of that.
    rounding: f64,
}

impl Surface {
    /// The parameters of the isolated umbilics, poles among them, as far as a search from a grid of
    /// some thousand places comes to them. Of a sphere and a plane none is isolated.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn umbilics(
        &self,
        defects: &SurfaceDefects,
        tolerance: Tolerance,
    ) -> Result<Vec<[f64; 2]>, GeomError> {
        let [us, vs] = self.umbilic_grid(&defects.collapsed, tolerance)?;
        let rows = us.iter().map(|&u| {
            GeomError::go_on(vs.len())?;
            let bends = vs.iter().map(|&v| self.bend_at(DVec2::new(u, v), tolerance));
            Ok(bends.collect::<Vec<_>>())
        });
        let bends: Vec<Vec<Option<CurvatureDifference>>> =
            rows.collect::<Result<_, GeomError>>()?;
        let last = |places: &[f64]| places[places.len() - 1];
        let ends = [DVec2::new(us[0], vs[0]), DVec2::new(last(&us), last(&vs))];
        let mut found: Vec<[f64; 2]> = Vec::new();
        for (below, above) in bends.iter().zip(bends.iter().skip(1)) {
            for (low, high) in below.windows(2).zip(above.windows(2)) {
                GeomError::go_on(1)?;
                let [Some(a), Some(b), Some(c), Some(d)] = [low[0], high[0], high[1], low[1]]
                else {
                    continue;
                };
                if let Some(at) = self.umbilic_about([a, b, c, d], ends, tolerance) {
                    self.add_place(&mut found, self.inside(at).to_array(), tolerance)?;
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
            let pole =
                self.bend_at(DVec2::from_array(at), tolerance).filter(CurvatureDifference::is_even);
            found.extend(pole.map(|_| at));
        }
        Ok(found)
    }

    /// Adds parameters whose point is not there yet.
    fn add_place(
        &self,
        found: &mut Vec<[f64; 2]>,
        at: [f64; 2],
        tolerance: Tolerance,
    ) -> Result<(), GeomError> {
        let point = self.point_at(at[0], at[1])?;
        for other in &*found {
            GeomError::go_on(1)?;
            if self.point_at(other[0], other[1])?.distance(point) <= tolerance.distance {
                return Ok(());
            }
        }
        found.push(at);
        Ok(())
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

    /// Beyond the end of a domain that closes, its start again.
    fn inside(&self, at: DVec2) -> DVec2 {
        let within = |domain: Interval, t: f64| {
            if domain.end() < t { t - domain.length() } else { t }
        };
        DVec2::new(within(self.domain_u(), at.x), within(self.domain_v(), at.y))
    }

    /// `None` where the surface has no curvatures.
    fn bend_at(&self, at: DVec2, tolerance: Tolerance) -> Option<CurvatureDifference> {
        let inside = self.inside(at);
        let shape = self.shape_at(inside.x, inside.y).ok()?;
        let [a, b, c] = shape.tensor;
        let largest = a.abs().max(b.abs()).max(c.abs());
        let rounding = shape.flat_below(tolerance).max(tolerance.angle * largest);
        Some(CurvatureDifference { at, uneven: DVec2::new(0.5 * (a - c), b), rounding })
    }

    /// The isolated umbilic to which the way down leads from a rectangle between four corners,
    /// counterclockwise, if there is one between the ends of the grid.
    fn umbilic_about(
        &self,
        corners: [CurvatureDifference; 4],
        ends: [DVec2; 2],
        tolerance: Tolerance,
    ) -> Option<DVec2> {
        let [a, _, c, _] = corners;
        if corners.iter().all(CurvatureDifference::is_even) {
            return None;
        }
        let width = c.at - a.at;
        let middle = self.bend_at(0.5 * (a.at + c.at), tolerance)?;
        if !may_vanish(&corners, &middle) {
            return None;
        }
        let all = || corners.iter().chain([&middle]);
        let start = *all().min_by(|a, b| a.size().total_cmp(&b.size()))?;
        let look = |at: DVec2| self.bend_at(at, tolerance);
        let limits = [(a.at - BEYOND * width).max(ends[0]), (c.at + BEYOND * width).min(ends[1])];
        let (last, slopes) = descend(start, middle.at, limits, width * UMBILIC_DIFFERENCE, look)?;
        let size = corners.iter().map(CurvatureDifference::size).fold(0.0, f64::max);
        // Where second derivatives jump there may be a least without an umbilic.
        let is_umbilic = last.is_even() || last.size() <= TOUCH_RELATIVE * size;
        let scaled = slopes * DMat2::from_diagonal(width);
        let is_clear = {
            let [x, y] = [scaled.x_axis, scaled.y_axis];
            UMBILIC_CLEAR * (x.length_squared() + y.length_squared()) < x.perp_dot(y).abs()
        };
        let is_alone = || is_alone(last.at, UMBILIC_CIRCLE * width, look);
        (is_umbilic && (is_clear || is_alone())).then_some(last.at)
    }
}

/// Whether both entries may vanish together in a rectangle between four corners, counterclockwise, or
/// half of its width beside it: whether zero lies in the parallelogram, twice as wide, that they span
/// there were they linear, or as far from it as they are bent.
fn may_vanish(corners: &[CurvatureDifference; 4], middle: &CurvatureDifference) -> bool {
    let [a, b, c, d] = corners.map(|corner| corner.uneven);
    let center = 0.25 * (a + b + c + d);
    let [along_u, along_v] = [0.5 * ((b - a) + (c - d)), 0.5 * ((d - a) + (c - b))];
    let bent = (a - b + c - d).length() + 4.0 * (middle.uneven - center).length();
    [[along_u, along_v], [along_v, along_u]].into_iter().all(|[side, other]| {
        let across = side.perp().normalize_or_zero();
        center.dot(across).abs() <= other.dot(across).abs() + bent
    })
}

/// Whether the surface bends unequally all around a place, and about as much everywhere.
fn is_alone(at: DVec2, radii: DVec2, look: impl Fn(DVec2) -> Option<CurvatureDifference>) -> bool {
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for i in 0..N_LOOKS {
        let (sine, cosine) = libm::sincos(TAU * i as f64 / N_LOOKS as f64);
        match look(at + radii * DVec2::new(cosine, sine)) {
            Some(bend) if !bend.is_even() => {
                (least, most) = (least.min(bend.size()), most.max(bend.size()));
            }
            _ => return false,
        }
    }
    UMBILIC_SHARE * most <= least
}

/// Goes down to where both entries vanish, between limits, as far as that leads; with the slopes
/// there. Slopes are differences towards `inward`, so that they do not look over the edge of a
/// piece.
fn descend(
    start: CurvatureDifference,
    inward: DVec2,
    limits: [DVec2; 2],
    difference: DVec2,
    look: impl Fn(DVec2) -> Option<CurvatureDifference>,
) -> Option<(CurvatureDifference, DMat2)> {
    let slopes_at = |bend: &CurvatureDifference| {
        let slope = |axis: DVec2| {
            let toward = (inward - bend.at).dot(axis);
            let step = difference.dot(axis).copysign(toward);
            Some((look(bend.at + axis * step)?.uneven - bend.uneven) / step)
        };
        Some(DMat2::from_cols(slope(DVec2::X)?, slope(DVec2::Y)?))
    };
    let mut last = start;
    let mut slopes = slopes_at(&last)?;
    let mut n_slow = 0;
    for _ in 0..UMBILIC_STEPS {
        // Along a direction in which nothing changes there is no step.
        let squared = slopes.transpose() * slopes;
        let little = LAST_BIT * (squared.x_axis.x + squared.y_axis.y);
        let damped = squared + DMat2::from_diagonal(DVec2::splat(little));
        let step = -(damped.inverse() * (slopes.transpose() * last.uneven));
        if !step.is_finite() {
            break;
        }
        let Ok(next) = shortened(step.to_array(), UMBILIC_STEP_HALVINGS, |step| {
            let at = (last.at + DVec2::from_array(step)).clamp(limits[0], limits[1]);
            let better = look(at).filter(|bend| bend.size() < last.size());
            Ok::<_, Infallible>(match better.is_some() || at == last.at {
                true => ControlFlow::Break(better),
                false => ControlFlow::Continue(()),
            })
        });
        let Some(better) = next else { break };
        n_slow = if SLOW * last.size() < better.size() { n_slow + 1 } else { 0 };
        last = better;
        if SLOW_UMBILIC_STEPS <= n_slow {
            break;
        }
        slopes = slopes_at(&last)?;
    }
    Some((last, slopes))
}

impl CurvatureDifference {
    fn size(&self) -> f64 {
        self.uneven.length()
    }

    fn is_even(&self) -> bool {
        self.size() <= self.rounding
    }
}
