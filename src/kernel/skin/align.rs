//! Sections that run beside one another: in one direction, with their seams side by side.

use glam::DVec3;

use super::{
    aligned_section::{AlignedSection, N_PLACES},
    corner::{cornered, corners_of_ring, with_seam_at_corner},
    passage::passes_back,
};
use crate::{
    ConstructionError, GeomError, NurbsCurve,
    ceiling::BISECTIONS,
    join,
    numeric::bisection::bisected,
    sorting::sort_by_key,
    tolerance::{PLACE_RELATIVE, TURN_RELATIVE},
};

/// A seam stays where it is when it is this near to its best place, as a fraction of the turn:
/// whoever placed it may have meant that.
const NEAR_SEAM: usize = 16;

/// The curve, reversed where it runs against the other one; if both are closed also with its seam
/// moved to the place nearest to the other one's, where that is far away. The seam of a closed one
/// that has corners goes to one of these, and with as many corners as the other one it has them at
/// the same parameters.
///
/// What is compared is how far points of equal parameter are apart; of open ones also their
/// chords, so that only what both speak for is reversed. Closed ones that are flat enough to have two
/// sides run alike if the way from one to the other leads to the same side of both, however far they
/// turn from one another. Equal ones change nothing.
///
/// # Errors
/// Those of [`join`] where the seam was.
pub fn aligned(
    curve: &NurbsCurve,
    beside: &NurbsCurve,
    is_closed: bool,
    distance: f64,
) -> Result<AlignedSection, GeomError> {
    let as_it_is = AlignedSection::of(curve.clone(), false, None);
    if curve.is_point() || beside.is_point() {
        return Ok(as_it_is);
    }
    if is_closed && let Some(found) = cornered(curve, beside, distance)? {
        return Ok(found);
    }
    let (own, others) = (places(curve, is_closed), places(beside, is_closed));
    let n = own.len();
    let size = |points: &[DVec3]| points.iter().map(|p| p.length_squared()).sum::<f64>().sqrt();
    let margin = TURN_RELATIVE * size(&own) * size(&others);
    // The nearer two sets of points with their centres in one place, the larger this sum.
    let together = |partner: &dyn Fn(usize) -> usize| {
        others.iter().enumerate().map(|(i, p)| p.dot(own[partner(i)])).sum::<f64>()
    };
    if !is_closed {
        let against = |a: f64, b: f64| a + margin < b;
        let chords = (own[n - 1] - own[0]).dot(others[n - 1] - others[0]);
        let is_reversed =
            against(together(&|i| i), together(&|i| n - 1 - i)) && against(chords, -chords);
        let curve = if is_reversed { curve.reversed() } else { curve.clone() };
        return Ok(AlignedSection::of(curve, is_reversed, None));
    }

    let forwards: Vec<f64> = (0..n).map(|m| together(&|i| (i + m) % n)).collect();
    let backwards: Vec<f64> = (0..n).map(|m| together(&|i| (2 * n - i - m) % n)).collect();
    let best = |sums: &[f64]| sums.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let is_reversed =
        passes_back(curve, beside).unwrap_or_else(|| best(&forwards) + margin < best(&backwards));
    let (sums, curve) =
        if is_reversed { (backwards, curve.reversed()) } else { (forwards, curve.clone()) };
    let most = best(&sums);
    let shift = sums.iter().position(|&sum| most - margin <= sum).unwrap_or(0);
    let from_start = shift.min(n - shift);
    if most - margin <= sums[0] || from_start * NEAR_SEAM <= n {
        return Ok(AlignedSection::of(curve, is_reversed, None));
    }
    let seam = nearest_place(&curve, shift, beside);
    let seam_before =
        if is_reversed { curve.domain().start() + (curve.domain().end() - seam) } else { seam };
    let curve = curve.with_seam_at(seam, distance)?;
    Ok(AlignedSection::of(curve, is_reversed, Some(seam_before)))
}

/// What was done to sections so that they run beside one another.
#[derive(Clone, Debug, Default)]
pub(super) struct Alignment {
    /// Sections that were reversed.
    pub(super) reversed: Vec<usize>,
    /// Sections whose seam was moved, and the parameter where it is now.
    pub(super) seams: Vec<(usize, f64)>,
    /// Sections whose corners were brought to the parameters of their neighbour's.
    pub(super) corners: Vec<usize>,
    /// Neighbours whose corners cannot be paired, with how many these are.
    pub(super) unpaired: Vec<[(usize, usize); 2]>,
}

/// Turns sections around, and moves seams, to run beside their neighbour: from the first section on
/// that has its seam at a corner, or else a corner anywhere, in both directions.
pub(super) fn align(curves: &mut [NurbsCurve], tolerance: f64) -> Result<Alignment, GeomError> {
    let is_closed = |curve: &NurbsCurve| curve.is_closed(tolerance);
    let real: Vec<usize> = (0..curves.len()).filter(|&i| !curves[i].is_point()).collect();
    let Some(&start) = real.first() else { return Ok(Alignment::default()) };
    let first_closed = is_closed(&curves[start]);
    if let Some(&other) = real.iter().find(|&&i| is_closed(&curves[i]) != first_closed) {
        let (closed, open) = if first_closed { (start, other) } else { (other, start) };
        return Err(ConstructionError::MixedSections { closed, open }.into());
    }
    let mut done = Alignment::default();
    let mut anchor = 0;
    if first_closed {
        let corners: Vec<Vec<f64>> = real.iter().map(|&i| corners_of_ring(&curves[i])).collect();
        let at_seam = |own: &Vec<f64>| own.first().is_some_and(|&first| first <= 0.0);
        let has_any = |own: &Vec<f64>| !own.is_empty();
        anchor = corners.iter().position(at_seam).or(corners.iter().position(has_any)).unwrap_or(0);
        let own = real[anchor];
        if let Some((moved, t)) = with_seam_at_corner(&curves[own], tolerance)? {
            done.seams.push((own, t));
            curves[own] = moved;
        }
    }
    let onwards = real[anchor..].windows(2).map(|pair| (pair[0], pair[1]));
    let backwards = real[..=anchor].windows(2).rev().map(|pair| (pair[1], pair[0]));
    for (before, own) in onwards.chain(backwards) {
        let now = aligned(&curves[own], &curves[before], first_closed, tolerance)?;
        done.reversed.extend(now.is_reversed.then_some(own));
        done.seams.extend(now.seam.map(|t| (own, t)));
        done.corners.extend(now.has_moved_corners.then_some(own));
        done.unpaired.extend(now.unpaired.map(|[n, others]| [(own, n), (before, others)]));
        curves[own] = now.curve;
    }
    done.reversed.sort_unstable();
    sort_by_key(&mut done.seams, |&(section, _)| section);
    done.corners.sort_unstable();
    Ok(done)
}

/// Points at even parameters about their centre; the last one of a closed curve is the first.
fn places(curve: &NurbsCurve, is_closed: bool) -> Vec<DVec3> {
    let n = N_PLACES + usize::from(is_closed);
    let mut points = curve.sample(n);
    points.truncate(N_PLACES);
    let centre = points.iter().sum::<DVec3>() / N_PLACES as f64;
    points.iter_mut().for_each(|point| *point -= centre);
    points
}

/// The parameter near step `shift` of the place nearest to the other curve's start, both about
/// their centres.
fn nearest_place(curve: &NurbsCurve, shift: usize, beside: &NurbsCurve) -> f64 {
    let domain = curve.domain();
    let centre = |curve: &NurbsCurve| {
        let points = curve.sample(N_PLACES + 1);
        points[..N_PLACES].iter().sum::<DVec3>() / N_PLACES as f64
    };
    let own_centre = centre(curve);
    let target = beside.start() - centre(beside) + own_centre;
    // How fast the distance changes, and how fast it could.
    let slope = |t: f64| {
        let derivatives = curve.derivatives_at(t, 1);
        let fastest = target.distance(own_centre) * derivatives[1].length();
        ((derivatives[0] - target).dot(derivatives[1]), TURN_RELATIVE * fastest)
    };
    let falls = |(slope, room): (f64, f64)| slope < -room;
    let rises = |(slope, room): (f64, f64)| room < slope;
    let at = |step: f64| domain.at((step / N_PLACES as f64).clamp(0.0, 1.0));
    let around = [at(shift as f64 - 2.0), at(shift as f64 + 2.0)];
    // Where all places are as near, as those of a circle to a place on its axis, rounding is not to choose.
    let [low, high] = match falls(slope(around[0])) && rises(slope(around[1])) {
        true => bisected(around, BISECTIONS, |t| slope(t).0 < 0.0),
        false => [at(shift as f64); 2],
    };
    let t = 0.5 * (low + high);
    let near = |knot: &f64| (knot - t).abs() <= PLACE_RELATIVE * domain.length();
    curve.knots().breaks().into_iter().find(near).unwrap_or(t)
}

impl NurbsCurve {
    /// The same closed curve begun at another place, on the same domain.
    ///
    /// # Errors
    /// Those of [`Self::split`] and [`join`].
    pub(crate) fn with_seam_at(&self, t: f64, distance: f64) -> Result<Self, GeomError> {
        let [before, behind] = self.split(t)?;
        Ok(join(&[behind, before], distance)?.reparametrized(self.domain()))
    }
}
