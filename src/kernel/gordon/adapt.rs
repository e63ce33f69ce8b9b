//! The curves of one direction of a network on common parameters.

use super::{
    family::{CurveFamily, NetworkCurve},
    map::NetworkParameterMap,
    refit::{RefitRequest, refitted},
};
use crate::{
    GeomError, Interval, KnotVector, NurbsCurve, curve::on_one_denominator,
    tolerance::UNCHANGED_SHARE,
};

/// The degree of curves that become splines, if none has a higher one.
const DEGREE: usize = 3;

/// The parameters of the surface at which a family meets the other, on the domain of the curve
/// that was given first: those given; else the means of the fractions at which its curves do, or,
/// where not all do there but the first and the last do at one set of parameters, at these,
/// as they are boundaries. A ring has one more, its end.
pub(super) fn common(family: &CurveFamily, given: Option<&[f64]>, tolerance: f64) -> Vec<f64> {
    let members = &family.members;
    let first = members.iter().min_by_key(|member| member.changes.index).unwrap_or(&members[0]);
    let domain = first.curve.domain();
    let n = first.at.len();
    let mean = |members: &[NetworkCurve]| {
        let mean = |j: usize| {
            let sum: f64 = members.iter().map(|m| m.curve.domain().fraction_of(m.at[j])).sum();
            domain.at(sum / members.len() as f64)
        };
        let mut at: Vec<f64> = (0..n).map(mean).collect();
        at[0] = domain.start();
        if family.is_ring {
            at.push(domain.end());
        } else {
            at[n - 1] = domain.end();
        }
        at
    };
    if let Some(given) = given {
        let mut at = given.to_vec();
        if family.is_ring {
            at.push(domain.end());
            at[0] = domain.start();
        }
        return at;
    }
    let of_all = mean(members);
    let (start, end) = (&members[0], &members[members.len() - 1]);
    let of_ends = mean(&[start.clone(), end.clone()]);
    let are_there = |at: &[f64], members: &[&NetworkCurve]| {
        members.iter().all(|member| member.is_there(domain, at, tolerance))
    };
    let all: Vec<&NetworkCurve> = members.iter().collect();
    if !are_there(&of_all, &all) && are_there(&of_ends, &[start, end]) { of_ends } else { of_all }
}

/// Brings the curves of a family to a common domain on which all meet the others at `at`: as they
/// are where they do, else with another parameter and as splines within the tolerance, of
/// the degree and with the knots that the surface has anyway.
///
/// # Errors
/// `FitError::ToleranceNotKept`.
pub(super) fn adapt(
    family: &mut CurveFamily,
    at: &[f64],
    blend: &KnotVector,
    [near, tolerance]: [f64; 2],
) -> Result<(), GeomError> {
    let domain = Interval::new(at[0], at[at.len() - 1])?;
    let is_ring = family.is_ring;
    let staying = staying(family, domain, at, near);
    let mut degree = DEGREE.max(blend.degree());
    let mut waiting: Vec<(usize, NurbsCurve)> = Vec::new();
    let mut rough: Vec<(f64, usize)> = Vec::new();
    for (k, member) in family.members.iter_mut().enumerate() {
        degree = degree.max(member.curve.degree());
        if staying.contains(&k) {
            member.curve = member.curve.reparametrized(domain);
            continue;
        }
        let mut own = member.at.clone();
        if is_ring {
            own.push(member.curve.domain().end());
        }
        let is_there = member.is_there(domain, at, near);
        let map = match is_there {
            true => NetworkParameterMap::new(
                &[domain.start(), domain.end()],
                &[own[0], own[own.len() - 1]],
                false,
            )?,
            false => NetworkParameterMap::new(at, &own, is_ring)?,
        };
        let (curve, own_rough) =
            map.applied(&member.curve.without_needless_knots(), UNCHANGED_SHARE * near)?;
        rough.extend(own_rough);
        member.changes.is_reparametrized = !is_there;
        member.changes.is_refitted = true;
        waiting.push((k, curve));
    }
    if waiting.is_empty() {
        return Ok(());
    }

    let mut held: Vec<(f64, usize)> = rough.iter().map(|&(t, k)| (t, degree - k)).collect();
    let stay = staying.iter().map(|&k| family.members[k].curve.knots());
    for knots in stay.chain([blend]) {
        let more = degree - knots.degree();
        held.extend(knots.distinct().into_iter().map(|(t, times)| (t, times + more)));
    }
    let (indices, curves): (Vec<usize>, Vec<NurbsCurve>) = waiting.into_iter().unzip();
    let wanted = RefitRequest { degree, at: at.to_vec(), held, is_ring };
    let (fits, bounds) = refitted(&curves, &wanted, tolerance)?;
    for ((k, fit), bound) in indices.into_iter().zip(fits).zip(bounds) {
        let member = &mut family.members[k];
        member.curve = fit;
        member.changes.deviation = bound;
    }
    Ok(())
}

/// The curves that may stay as they are: those that meet the others at `at`; of rational ones only
/// if they have one denominator, as over many the degree would be too high.
fn staying(family: &CurveFamily, domain: Interval, at: &[f64], tolerance: f64) -> Vec<usize> {
    let members = &family.members;
    let is_there = |&k: &usize| members[k].is_there(domain, at, tolerance);
    let mut staying: Vec<usize> = (0..members.len()).filter(is_there).collect();
    let curves = || staying.iter().map(|&k| &members[k].curve);
    let rational: Vec<NurbsCurve> = curves().filter(|curve| curve.is_rational()).cloned().collect();
    if 1 < rational.len() {
        let degree = rational.iter().map(NurbsCurve::degree).max();
        let common = on_one_denominator(&rational);
        if !common.is_ok_and(|common| Some(common[0].degree()) == degree) {
            staying.retain(|&k| !members[k].curve.is_rational());
        }
    }
    staying
}
