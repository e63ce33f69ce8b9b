//! Seams of closed sections at their corners.
//!
//! Where sections have corners, such as the tails of aerofoils, an edge of the surface runs through
//! them. It does if the seams of all sections stand at corners that belong together, and what
//! corners there are beside at common parameters.

use glam::DVec3;

use super::{
    aligned_section::{AlignedSection, N_PLACES},
    passage::passes_back,
};
use crate::{
    GeomError, Interval, NurbsCurve, Side,
    frame::angle_between,
    join,
    tolerance::{PLACE_RELATIVE, TURN_RELATIVE},
};

/// The least turn of a corner, in radians: a sixteenth of a turn. Less is the side of a polygon
/// that stands for a smooth curve.
const LEAST_TURN: f64 = std::f64::consts::FRAC_PI_8;

/// Corners up to which each is tried as the partner of each other; sections of more are polygons
/// whose corners say little.
const MOST: usize = 64;

/// The fractions of the domain of a closed curve at which it has corners, in order: 0 for its
/// seam. None of more than 64.
#[must_use]
pub fn corners_of_ring(curve: &NurbsCurve) -> Vec<f64> {
    let domain = curve.domain();
    let turns = |before: f64, behind: f64| {
        let into = curve.tangent_at(before, Side::Left);
        let out = curve.tangent_at(behind, Side::Right);
        into.ok().zip(out.ok()).map_or(0.0, |(a, b)| angle_between(a, b))
    };
    let breaks = curve.knots().breaks();
    let can_turn = |t: &f64| curve.degree() <= curve.knots().exact_multiplicity(*t);
    let is_corner = |t: &f64| LEAST_TURN < turns(*t, *t);
    let seam = LEAST_TURN < turns(domain.end(), domain.start());
    let inner = breaks[1..breaks.len() - 1].iter().copied().filter(can_turn).filter(is_corner);
    let found: Vec<f64> =
        seam.then_some(0.0).into_iter().chain(inner.map(|t| domain.fraction_of(t))).collect();
    if found.len() <= MOST { found } else { Vec::new() }
}

/// A way to run around a closed curve: from a corner, forwards or backwards, with the corners on
/// the way as fractions of the domain from there.
struct RunDirection {
    from: f64,
    is_reversed: bool,
    corners: Vec<f64>,
}

impl RunDirection {
    /// All ways from the corners, that of the curve as it is first.
    fn all(corners: &[f64]) -> Vec<Self> {
        let from = |&from: &f64, is_reversed: bool| {
            let sign = if is_reversed { -1.0 } else { 1.0 };
            let mut on_the_way: Vec<f64> =
                corners.iter().map(|&corner| around(sign * (corner - from))).collect();
            on_the_way.sort_by(f64::total_cmp);
            Self { from, is_reversed, corners: on_the_way }
        };
        [false, true].into_iter().flat_map(|r| corners.iter().map(move |c| from(c, r))).collect()
    }

    /// Where on the curve that is which lies at a fraction of this way.
    fn place(&self, fraction: f64) -> f64 {
        around(if self.is_reversed { self.from - fraction } else { self.from + fraction })
    }

    /// The curve run this way.
    fn run(&self, curve: &NurbsCurve, distance: f64) -> Result<NurbsCurve, GeomError> {
        let (curve, from) = match self.is_reversed {
            true => (curve.reversed(), around(1.0 - self.from)),
            false => (curve.clone(), self.from),
        };
        if from <= 0.0 { Ok(curve) } else { curve.with_seam_at(curve.domain().at(from), distance) }
    }
}

/// The closed curve with its seam at that of its corners, and in that direction, in which it runs
/// nearest beside the other one; where that has as many corners, with its own at their
/// parameters. `None` if it has no corners.
///
/// What is compared is how far points of equal parameter are apart about their centres, and first the sides
/// that they turn to one another, as in [`super::aligned`]. Equal ones
/// change nothing, and what is linear between the corners stays so: the curve is the same in space.
///
/// # Errors
/// Those of [`join`].
pub(super) fn cornered(
    curve: &NurbsCurve,
    beside: &NurbsCurve,
    distance: f64,
) -> Result<Option<AlignedSection>, GeomError> {
    let (own, others) = (corners_of_ring(curve), corners_of_ring(beside));
    let are_paired = own.len() == others.len() && others.first().is_some_and(|&at| at <= 0.0);
    let (here, there) = (CentredCurve::new(curve), CentredCurve::new(beside));
    let apart = |way: &RunDirection| -> f64 {
        let place = |i: usize| {
            let fraction = i as f64 / N_PLACES as f64;
            way.place(if are_paired { carried(fraction, &others, &way.corners) } else { fraction })
        };
        let miss =
            |i: usize| there.at(i as f64 / N_PLACES as f64).distance_squared(here.at(place(i)));
        (0..N_PLACES).map(miss).sum()
    };
    let direction = passes_back(curve, beside);
    let may_run = |way: &RunDirection| direction.is_none_or(|back| way.is_reversed == back);
    let mut best: Option<(f64, RunDirection)> = None;
    for way in RunDirection::all(&own).into_iter().filter(may_run) {
        let found = apart(&way);
        if best.as_ref().is_none_or(|(least, _)| found < least * (1.0 - TURN_RELATIVE)) {
            best = Some((found, way));
        }
    }
    let Some((_, way)) = best else { return Ok(None) };
    let run = way.run(curve, distance)?;
    let differs = |(a, b): (&f64, &f64)| PLACE_RELATIVE < (a - b).abs();
    let moves = are_paired && way.corners.iter().zip(&others).any(differs);
    let curve_there =
        if moves { with_corners_at(&run, &way.corners, &others, distance)? } else { run };
    let seam = (0.0 < way.from).then(|| curve.domain().at(way.from));
    let lost = if are_paired || others.is_empty() { None } else { Some([own.len(), others.len()]) };
    Ok(Some(AlignedSection {
        curve: curve_there,
        is_reversed: way.is_reversed,
        seam,
        has_moved_corners: moves,
        unpaired: lost,
    }))
}

/// The closed curve with its seam at the sharpest of its corners, and the parameter that it had;
/// `None` where the seam is at a corner, or there is none.
///
/// # Errors
/// Those of [`join`].
pub fn with_seam_at_corner(
    curve: &NurbsCurve,
    distance: f64,
) -> Result<Option<(NurbsCurve, f64)>, GeomError> {
    let domain = curve.domain();
    let turn = |&fraction: &f64| {
        let t = domain.at(fraction);
        let both = [Side::Left, Side::Right].map(|side| curve.tangent_at(t, side).ok());
        both[0].zip(both[1]).map_or(0.0, |(a, b)| angle_between(a, b))
    };
    let corners = corners_of_ring(curve);
    if corners.first().is_none_or(|&first| first <= 0.0) {
        return Ok(None);
    }
    let sharpest = corners.iter().fold((0.0, 0.0), |most, at| {
        let found = turn(at);
        if most.0 * (1.0 + TURN_RELATIVE) < found { (found, *at) } else { most }
    });
    let t = domain.at(sharpest.1);
    Ok(Some((curve.with_seam_at(t, distance)?, t)))
}

/// A fraction of a turn.
fn around(fraction: f64) -> f64 {
    let rest = fraction - fraction.floor();
    if rest < 1.0 - PLACE_RELATIVE { rest } else { 0.0 }
}

/// The fraction between two corners of `to` that lies as the given one between those of `from`; both
/// begin with 0.
fn carried(fraction: f64, from: &[f64], to: &[f64]) -> f64 {
    let k = from.partition_point(|&at| at <= fraction).saturating_sub(1);
    let end = |corners: &[f64]| corners.get(k + 1).copied().unwrap_or(1.0);
    to[k] + (fraction - from[k]) / (end(from) - from[k]) * (end(to) - to[k])
}

/// The curve with its corners, of which the first is the seam, at other fractions of its domain.
fn with_corners_at(
    curve: &NurbsCurve,
    from: &[f64],
    to: &[f64],
    distance: f64,
) -> Result<NurbsCurve, GeomError> {
    let domain = curve.domain();
    let mut pieces = Vec::with_capacity(from.len());
    for k in 0..from.len() {
        let stretch = |corners: &[f64]| {
            let end = corners.get(k + 1).copied().unwrap_or(1.0);
            Interval::new(domain.at(corners[k]), domain.at(end))
        };
        pieces.push(curve.trimmed(stretch(from)?)?.reparametrized(stretch(to)?));
    }
    match &pieces[..] {
        [only] => Ok(only.clone()),
        _ => Ok(join(&pieces, distance)?.reparametrized(domain)),
    }
}

/// A closed curve about its centre.
struct CentredCurve<'a> {
    curve: &'a NurbsCurve,
    centre: DVec3,
}

impl<'a> CentredCurve<'a> {
    fn new(curve: &'a NurbsCurve) -> Self {
        let points = curve.sample(N_PLACES + 1);
        Self { curve, centre: points[..N_PLACES].iter().sum::<DVec3>() / N_PLACES as f64 }
    }

    fn at(&self, fraction: f64) -> DVec3 {
        self.curve.point_at(self.curve.domain().at(fraction)) - self.centre
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A trapezium, no corner of which is like another one, from one of them on.
    fn trapezium(first: usize, is_reversed: bool, moved: DVec3) -> NurbsCurve {
        let corners = [[0.0, 0.0], [5.0, 0.0], [3.0, 2.0], [1.0, 2.5]];
        let corner = |k: usize| {
            let k = if is_reversed { first + 4 - k } else { first + k };
            let [x, y] = corners[k % 4];
            DVec3::new(x, y, 0.0) + moved
        };
        NurbsCurve::polyline(&(0..5).map(corner).collect::<Vec<_>>()).expect("a polygon")
    }

    #[test]
    fn a_section_begins_at_the_corner_that_the_other_does_wherever_it_stands() {
        let beside = trapezium(0, false, DVec3::new(-3.0, 40.0, 0.0));
        for moved in [DVec3::Z, DVec3::new(120.0, -70.0, 3.0)] {
            for (first, is_reversed) in (0..4).flat_map(|k| [(k, false), (k, true)]) {
                let section = trapezium(first, is_reversed, moved);
                let found = cornered(&section, &beside, 1e-9).expect("a curve").expect("corners");
                assert_eq!(found.is_reversed, is_reversed);
                assert_eq!(found.seam.is_some(), first != 0);
                assert_eq!((found.has_moved_corners, found.unpaired), (false, None));
                for k in 0..=4 {
                    let corner = found.curve.point_at(found.curve.domain().at(0.25 * k as f64));
                    let expected = beside.point_at(k as f64) - beside.start() + moved;
                    assert!(corner.distance(expected) < 1e-9, "{first} {is_reversed} {corner}");
                }
            }
        }
    }

    #[test]
    fn corners_come_to_the_parameters_of_the_other_ones() {
        let uneven = NurbsCurve::polynomial(
            crate::KnotVector::new(1, vec![0.0, 0.0, 0.1, 0.45, 0.8, 1.0, 1.0]).expect("knots"),
            &trapezium(0, false, DVec3::Z).points(),
        )
        .expect("a polygon");
        let beside = trapezium(0, false, DVec3::ZERO);
        let found = cornered(&uneven, &beside, 1e-9).expect("a curve").expect("corners");
        assert!(found.has_moved_corners);
        for k in 0..=16 {
            let (t, at) = (0.0625 * k as f64, 0.25 * k as f64);
            let point = found.curve.point_at(found.curve.domain().at(t));
            assert!(point.distance(beside.point_at(at) + DVec3::Z) < 1e-9, "{t}: {point}");
        }
    }

    #[test]
    fn fractions_between_corners_are_carried_evenly() {
        let (from, to) = ([0.0, 0.2, 0.6], [0.0, 0.5, 0.75]);
        let expected =
            [(0.0, 0.0), (0.1, 0.25), (0.2, 0.5), (0.4, 0.625), (0.6, 0.75), (0.8, 0.875)];
        for (fraction, at) in expected {
            assert!((carried(fraction, &from, &to) - at).abs() < 1e-15, "{fraction}");
        }
    }

    #[test]
    fn the_seam_goes_to_the_sharpest_corner() {
        // From the middle of the longest side.
        let points = [[2.5, 0.0], [5.0, 0.0], [3.0, 2.0], [1.0, 2.5], [0.0, 0.0], [2.5, 0.0]];
        let points = points.map(|[x, y]| DVec3::new(x, y, 0.0));
        let ring = NurbsCurve::polyline(&points).expect("a polygon");
        assert_eq!(corners_of_ring(&ring).len(), 4);
        let (found, t) = with_seam_at_corner(&ring, 1e-9).expect("a ring").expect("corners");
        assert!((t - 1.0).abs() < 1e-12, "{t}");
        assert!(found.start().distance(DVec3::X * 5.0) < 1e-12);
        assert!(with_seam_at_corner(&found, 1e-9).expect("a ring").is_none());
    }
}
