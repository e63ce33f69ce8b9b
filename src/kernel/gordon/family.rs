//! The curves of one direction of a network: in order, in one direction, on common parameters.

use glam::DVec3;

use super::network::{NetworkCrossing, NetworkError};
use crate::{
    Direction, GeomError, IntersectionError, Interval, NurbsCurve,
    sorting::sort_by,
    tolerance::{KNOT_RELATIVE, PLACE_RELATIVE, UNCHANGED_SHARE},
};

/// Places of a seam, and of a curve, that are looked at.
pub(super) const N_PLACES: usize = 65;

/// What was done to one curve of a network.
///
/// A curve that runs against the first of its direction is turned around:
///
/// ```
/// use virote_kernel::{Network, NurbsCurve, glam::DVec3, gordon};
///
/// let line = |a, b| NurbsCurve::line(a, b);
/// let [o, x, y] = [DVec3::ZERO, DVec3::X, DVec3::Y];
/// let curves = [&[line(o, x)?, line(x + y, y)?][..], &[line(o, y)?, line(x, x + y)?][..]];
/// let network = Network { curves, at: [None, None], is_lagrange: false, tolerance: 1e-6 };
/// let made = gordon(network).map_err(|error| format!("{error:?}"))?;
/// assert_eq!(made.changes[0].iter().map(|own| own.is_reversed).collect::<Vec<_>>(), [false, true]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct CurveAdjustment {
    /// Its index among those given.
    pub index: usize,
    /// Whether it runs the other way now.
    pub is_reversed: bool,
    /// Whether what stood out beyond the others was cut off.
    pub is_trimmed: bool,
    /// The parameter where its seam is now, if that was moved.
    pub seam: Option<f64>,
    /// Whether its parameter was changed, so that it meets the others at the common ones.
    pub is_reparametrized: bool,
    /// Whether it was replaced by a spline near it.
    pub is_refitted: bool,
    /// A bound of the distance between the surface and the curve.
    pub deviation: f64,
    /// The parameter where the distance was largest among those that were looked at.
    pub worst_at: f64,
}

/// A curve of a network.
#[derive(Clone, Debug)]
pub(super) struct NetworkCurve {
    pub(super) curve: NurbsCurve,
    /// Where it meets the others, in their order; a ring's first one is its start.
    pub(super) at: Vec<f64>,
    pub(super) changes: CurveAdjustment,
}

/// The curves of one direction.
#[derive(Clone, Debug)]
pub(super) struct CurveFamily {
    pub(super) members: Vec<NetworkCurve>,
    /// Whether all of them close.
    pub(super) is_ring: bool,
}

/// Both families, in the order in which the first curve of each meets the other family, all run
/// through in the direction of the first one.
///
/// # Errors
/// [`NetworkError::Order`].
pub(super) fn in_order(
    us: &[NurbsCurve],
    vs: &[NurbsCurve],
    found: &[Vec<NetworkCrossing>],
    is_given: [bool; 2],
    tolerance: f64,
) -> Result<[CurveFamily; 2], NetworkError> {
    let order = |n: usize, is_kept: bool, place: &dyn Fn(usize) -> f64| {
        let mut order: Vec<usize> = (0..n).collect();
        if !is_kept {
            sort_by(&mut order, |&a, &b| place(a).total_cmp(&place(b)));
        }
        order
    };
    let order_v = order(vs.len(), is_given[0], &|l| found[0][l].t);
    let order_u = order(us.len(), is_given[1], &|k| found[k][0].s);
    let family = |along: Direction| {
        let orders = [&order_u, &order_v];
        let (curves, own, others) = ([us, vs][along], orders[along], orders[along.other()]);
        let is_kept = is_given[along];
        let is_ring = curves.iter().all(|curve| curve.is_closed(tolerance));
        let mut members: Vec<NetworkCurve> = Vec::new();
        for &index in own {
            let at = others.iter().map(|&other| match along {
                Direction::U => found[index][other].t,
                Direction::V => found[other][index].s,
            });
            let (curve, at) = (curves[index].clone(), at.collect());
            let mut member = NetworkCurve::new(curve, at, index);
            let towards = members.first().map(NetworkCurve::direction);
            if is_ring {
                member.begin_at_first(towards, tolerance)?;
            } else if !is_kept {
                member.turn();
            }
            let others_curves = [us, vs][along.other()];
            member.check_order(along, others, others_curves, tolerance)?;
            if !is_ring {
                member.trim(tolerance)?;
            }
            members.push(member);
        }
        // Of two families the first curve gives the direction, whatever the order is now.
        Ok::<CurveFamily, NetworkError>(CurveFamily { members, is_ring })
    };
    Ok([family(Direction::U)?, family(Direction::V)?])
}

impl CurveFamily {
    /// Fails where neighbours cross between their ends.
    ///
    /// # Errors
    /// [`NetworkError::Crossing`].
    pub(super) fn check_apart(&self, along: Direction, tolerance: f64) -> Result<(), NetworkError> {
        for pair in self.members.windows(2) {
            let (a, b) = (&pair[0].curve, &pair[1].curve);
            let curves = [0, 1].map(|i| pair[i].changes.index);
            let is_end = |curve: &NurbsCurve, t: f64| {
                let f = curve.domain().fraction_of(t);
                f <= PLACE_RELATIVE.sqrt() || 1.0 - PLACE_RELATIVE.sqrt() <= f
            };
            let point = match a.intersections(b, tolerance) {
                Ok(found) => found
                    .into_iter()
                    .find(|m| !is_end(a, m.first) && !is_end(b, m.second))
                    .map(|m| m.point),
                Err(GeomError::Intersection(IntersectionError::RunTogether { start, .. })) => {
                    Some(a.point_at(start))
                }
                Err(error) => return Err(error.into()),
            };
            if let Some(point) = point {
                return Err(NetworkError::Crossing { along, curves, point });
            }
        }
        Ok(())
    }
}

impl NetworkCurve {
    fn new(curve: NurbsCurve, at: Vec<f64>, index: usize) -> Self {
        let changes = CurveAdjustment {
            index,
            is_reversed: false,
            is_trimmed: false,
            seam: None,
            is_reparametrized: false,
            is_refitted: false,
            deviation: 0.0,
            worst_at: curve.domain().start(),
        };
        Self { curve, at, changes }
    }

    pub(super) fn changes(self) -> CurveAdjustment {
        self.changes
    }

    /// The tangent at the first meeting.
    fn direction(&self) -> DVec3 {
        self.curve.derivatives_at(self.at[0], 1)[1]
    }

    /// Whether it meets the others at these parameters of a domain, within a part of the tolerance.
    pub(super) fn is_there(&self, domain: Interval, at: &[f64], tolerance: f64) -> bool {
        let own = self.curve.domain();
        let misses = |(&t, &own_t): (&f64, &f64)| {
            let straight = own.at(domain.fraction_of(t));
            let (a, b) = (self.curve.point_at(straight), self.curve.point_at(own_t));
            UNCHANGED_SHARE * tolerance < a.distance(b)
        };
        !at.iter().zip(&self.at).any(misses)
    }

    fn reverse(&mut self) {
        let domain = self.curve.domain();
        self.curve = self.curve.reversed();
        self.at.iter_mut().for_each(|t| *t = domain.start() + (domain.end() - *t));
        self.changes.is_reversed = !self.changes.is_reversed;
    }

    /// Reverses a curve that meets the others from the last to the first.
    fn turn(&mut self) {
        if self.at[self.at.len() - 1] < self.at[0] {
            self.reverse();
        }
    }

    /// Moves the seam of a closed curve to its first meeting, and lets it run on to the second.
    fn begin_at_first(&mut self, towards: Option<DVec3>, tolerance: f64) -> Result<(), GeomError> {
        let n = self.at.len();
        let cyclic = |at: &[f64], domain: Interval| -> Vec<f64> {
            let length = domain.length();
            let from = |t: f64| if t < at[0] { t - at[0] + length } else { t - at[0] };
            at.iter().map(|&t| domain.start() + from(t)).collect()
        };
        let increases = |at: &[f64]| at.windows(2).all(|pair| pair[0] < pair[1]);
        let is_against = match towards {
            Some(direction) if n < 3 => self.direction().dot(direction) < 0.0,
            _ => !increases(&cyclic(&self.at, self.curve.domain())),
        };
        if is_against {
            self.reverse();
        }
        let domain = self.curve.domain();
        let start = self.at[0];
        let ends = [domain.start(), domain.end()];
        let is_at_seam = ends.into_iter().any(|end| self.is_one_place([start, end], tolerance));
        self.at = cyclic(&self.at, domain);
        if !is_at_seam {
            self.curve = self.curve.with_seam_at(start, tolerance)?;
            self.changes.seam = Some(start);
        }
        Ok(())
    }

    fn check_order(
        &self,
        along: Direction,
        others: &[usize],
        curves: &[NurbsCurve],
        tolerance: f64,
    ) -> Result<(), NetworkError> {
        let same = KNOT_RELATIVE.sqrt() * self.curve.domain().length();
        let Some(i) = self.at.windows(2).position(|pair| pair[1] - pair[0] <= same) else {
            return Ok(());
        };
        let others = [others[i], others[i + 1]];
        let crossings = curves[others[0]].intersections(&curves[others[1]], tolerance);
        let crossing = crossings.ok().and_then(|found| found.first().map(|meeting| meeting.point));
        let at = [self.at[i], self.at[i + 1]];
        Err(NetworkError::Order { along, curve: self.changes.index, others, at, crossing })
    }

    /// Whether two parameters are one, and the curve goes nowhere between them.
    fn is_one_place(&self, [a, b]: [f64; 2], tolerance: f64) -> bool {
        let is_one = (a - b).abs() <= PLACE_RELATIVE * self.curve.domain().length();
        let points = [a, b].map(|t| self.curve.point_at(t));
        is_one && points[0].distance(points[1]) <= UNCHANGED_SHARE * tolerance
    }

    /// Cuts off what stands out beyond the first and the last meeting.
    fn trim(&mut self, tolerance: f64) -> Result<(), GeomError> {
        let (domain, last) = (self.curve.domain(), self.at.len() - 1);
        let from = |t: f64, end: f64| {
            if self.is_one_place([t, end], tolerance) { end } else { t }
        };
        let start = from(self.at[0], domain.start());
        let end = from(self.at[last], domain.end());
        if domain.start() < start || end < domain.end() {
            self.curve = self.curve.trimmed(Interval::new(start, end)?)?;
            self.changes.is_trimmed = true;
        }
        (self.at[0], self.at[last]) = (start, end);
        Ok(())
    }

    /// A bound of how far the surface is.
    pub(super) fn deviation(&self) -> f64 {
        self.changes.deviation
    }

    pub(super) fn is_refitted(&self) -> bool {
        self.changes.is_refitted
    }

    /// Notes how far the surface's isocurve is from what the curve became.
    pub(super) fn miss(&mut self, iso: &NurbsCurve) {
        let curve = &self.curve;
        let apart = |t: f64| curve.point_at(t).distance(iso.point_at(t));
        let places = curve.domain().steps(N_PLACES - 1);
        let worst = places
            .into_iter()
            .map(|t| (apart(t), t))
            .fold((0.0, 0.0), |best, next| if best.0 < next.0 { next } else { best });
        self.changes.deviation += curve.deviation_from(iso);
        self.changes.worst_at = worst.1;
    }
}
