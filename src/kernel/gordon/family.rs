//! The curves of one direction of a network: in order, in one direction, on common parameters.

use glam::DVec3;

use super::{
    N_PLACES,
    map::Map,
    network::{Meet, NetworkError},
    refit::refitted,
};
use crate::kernel::{
    GeomError, Interval, NurbsCurve,
    tolerance::{KNOT_RELATIVE, PLACE_RELATIVE},
};

/// Part of the tolerance by which a curve may miss its meetings without a change of parameter.
const NEAR: f64 = 1.0 / 16.0;

/// What was done to one curve of a network.
#[derive(Clone, Debug)]
pub struct Changes {
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
    /// Whether it was replaced by a cubic spline near it.
    pub is_refitted: bool,
    /// A bound of the distance between the surface and the curve.
    pub deviation: f64,
    /// The parameter where the distance was largest among those that were looked at.
    pub worst_at: f64,
}

/// A curve of a network.
#[derive(Clone, Debug)]
pub(super) struct Member {
    pub(super) curve: NurbsCurve,
    /// Where it meets the others, in their order; a ring's first one is its start.
    pub(super) at: Vec<f64>,
    changes: Changes,
}

/// The curves of one direction.
#[derive(Clone, Debug)]
pub(super) struct Family {
    pub(super) members: Vec<Member>,
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
    found: &[Vec<Meet>],
    is_given: [bool; 2],
    tolerance: f64,
) -> Result<[Family; 2], NetworkError> {
    let order = |n: usize, is_kept: bool, place: &dyn Fn(usize) -> f64| {
        let mut order: Vec<usize> = (0..n).collect();
        if !is_kept {
            order.sort_by(|&a, &b| place(a).total_cmp(&place(b)));
        }
        order
    };
    let order_v = order(vs.len(), is_given[0], &|l| found[0][l].t);
    let order_u = order(us.len(), is_given[1], &|k| found[k][0].s);
    let family = |is_u: bool| {
        let (curves, own, others) =
            if is_u { (us, &order_u, &order_v) } else { (vs, &order_v, &order_u) };
        let is_kept = is_given[usize::from(!is_u)];
        let is_ring = curves.iter().all(|curve| curve.is_closed(tolerance));
        let mut members: Vec<Member> = Vec::new();
        for &index in own {
            let at = others
                .iter()
                .map(|&other| if is_u { found[index][other].t } else { found[other][index].s });
            let (curve, at) = (curves[index].clone(), at.collect());
            let mut member = Member::new(curve, at, index);
            let towards = members.first().map(Member::direction);
            if is_ring {
                member.begin_at_first(towards, tolerance)?;
            } else if !is_kept {
                member.turn();
            }
            member.check_order(is_u, others)?;
            if !is_ring {
                member.trim()?;
            }
            members.push(member);
        }
        // Of two families the first curve gives the direction, whatever the order is now.
        Ok::<Family, NetworkError>(Family { members, is_ring })
    };
    Ok([family(true)?, family(false)?])
}

impl Member {
    fn new(curve: NurbsCurve, at: Vec<f64>, index: usize) -> Self {
        let changes = Changes {
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

    pub(super) fn changes(self) -> Changes {
        self.changes
    }

    /// The tangent at the first meeting.
    fn direction(&self) -> DVec3 {
        self.curve.derivatives_at(self.at[0], 1)[1]
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
        let same = PLACE_RELATIVE * domain.length();
        let start = self.at[0];
        let is_at_seam = start - domain.start() <= same || domain.end() - start <= same;
        self.at = cyclic(&self.at, domain);
        if !is_at_seam {
            self.curve = self.curve.with_seam_at(start, tolerance)?;
            self.changes.seam = Some(start);
        }
        Ok(())
    }

    fn check_order(&self, is_u: bool, others: &[usize]) -> Result<(), NetworkError> {
        let same = KNOT_RELATIVE.sqrt() * self.curve.domain().length();
        match self.at.windows(2).position(|pair| pair[1] - pair[0] <= same) {
            None => Ok(()),
            Some(i) => Err(NetworkError::Order {
                is_u,
                curve: self.changes.index,
                others: [others[i], others[i + 1]],
                at: [self.at[i], self.at[i + 1]],
            }),
        }
    }

    /// Cuts off what stands out beyond the first and the last meeting.
    fn trim(&mut self) -> Result<(), GeomError> {
        let (domain, last) = (self.curve.domain(), self.at.len() - 1);
        let same = PLACE_RELATIVE * domain.length();
        let start = if self.at[0] - domain.start() <= same { domain.start() } else { self.at[0] };
        let end = if domain.end() - self.at[last] <= same { domain.end() } else { self.at[last] };
        if domain.start() < start || end < domain.end() {
            self.curve = self.curve.trimmed(Interval::new(start, end)?)?;
            self.changes.is_trimmed = true;
        }
        (self.at[0], self.at[last]) = (start, end);
        Ok(())
    }

    /// Notes how far the surface's isocurve is from what the curve became.
    pub(super) fn miss(&mut self, curve: &NurbsCurve, iso: &NurbsCurve) {
        let apart = |t: f64| curve.point_at(t).distance(iso.point_at(t));
        let places = curve.domain().steps(N_PLACES - 1);
        let worst = places
            .into_iter()
            .map(|t| (apart(t), t))
            .fold((0.0, 0.0), |best, next| if best.0 < next.0 { next } else { best });
        let bound = curve.deviation_from(iso);
        self.changes.deviation += if bound.is_finite() { bound } else { worst.0 };
        self.changes.worst_at = worst.1;
    }
}

/// The parameters of the surface at which a family meets the other: those given, or the means of
/// the fractions at which its curves do, on the domain of the curve that was given first. A ring
/// has one more, its end.
pub(super) fn common(family: &Family, given: Option<&[f64]>) -> Vec<f64> {
    let members = &family.members;
    let first = members.iter().min_by_key(|member| member.changes.index).unwrap_or(&members[0]);
    let domain = first.curve.domain();
    let n = first.at.len();
    let mean = |j: usize| {
        let sum: f64 = members.iter().map(|m| m.curve.domain().fraction_of(m.at[j])).sum();
        domain.at(sum / members.len() as f64)
    };
    let mut at = match given {
        Some(given) => given.to_vec(),
        None => (0..n).map(mean).collect(),
    };
    if family.is_ring {
        at.push(domain.end());
        at[0] = domain.start();
    } else if given.is_none() {
        (at[0], at[n - 1]) = (domain.start(), domain.end());
    }
    at
}

/// Brings the curves of a family to a common domain on which all meet the others at `at`: as they
/// are where they do, else with another parameter and as cubic splines within the tolerance.
///
/// # Errors
/// [`GeomError::ToleranceNotKept`].
pub(super) fn adapt(
    family: &mut Family,
    at: &[f64],
    node: &dyn Fn(usize, usize) -> DVec3,
    tolerance: f64,
) -> Result<(), GeomError> {
    let domain = Interval::new(at[0], at[at.len() - 1])?;
    let is_ring = family.is_ring;
    let mut waiting: Vec<(usize, NurbsCurve)> = Vec::new();
    let mut corners: Vec<f64> = Vec::new();
    for (k, member) in family.members.iter_mut().enumerate() {
        let straight = member.curve.reparametrized(domain);
        let misses = (0..member.at.len()).map(|l| straight.point_at(at[l]).distance(node(k, l)));
        let is_there = misses.fold(0.0, f64::max) <= NEAR * tolerance;
        if is_there && !straight.is_rational() {
            member.curve = straight;
            continue;
        }
        let mut own = member.at.clone();
        if is_ring {
            own.push(member.curve.domain().end());
        }
        let map = match is_there {
            true => {
                Map::new(&[domain.start(), domain.end()], &[own[0], own[own.len() - 1]], false)?
            }
            false => Map::new(at, &own, is_ring)?,
        };
        let (curve, own_corners) = map.applied(&member.curve)?;
        corners.extend(own_corners);
        member.changes.is_reparametrized = !is_there;
        member.changes.is_refitted = true;
        waiting.push((k, curve));
    }
    if waiting.is_empty() {
        return Ok(());
    }
    let (indices, curves): (Vec<usize>, Vec<NurbsCurve>) = waiting.into_iter().unzip();
    let (fits, bounds) = refitted(&curves, at, &corners, tolerance)?;
    for ((k, fit), bound) in indices.into_iter().zip(fits).zip(bounds) {
        let member = &mut family.members[k];
        member.curve = fit;
        member.changes.deviation = bound;
    }
    Ok(())
}
