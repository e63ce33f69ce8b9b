//! Pairs of parts of two surfaces, sorted by what they may share.
//!
//! Pairs whose boxes or slabs are apart are dropped, the others halved, until their cones of normals
//! tell that they cross in at most one arc, or all is known about a contact that they are within, or
//! they are flat: such pairs touch.

use std::sync::Arc;

use glam::DVec3;

use super::{
    PictureError, chain,
    pair::{SurfacePart, SurfacePatches},
    parallel_pair::ParameterRegion,
    sample::{BranchSamples, VanishingPlace},
    seam::EdgeOverlap,
    surface_pair::SurfacePair,
    tangential_contact::TangentialContact,
    trace::CurveEnds,
};
use crate::{
    Bounds, GeomError, NurbsSurface,
    ceiling::{CONTACT_LOOKS, CONTACTS, SURFACE_PAIRS},
    tolerance::{CONTACT_SHARE, FLAT_SHARE},
};

/// Parts of the tolerance within which surfaces touch whose normals are parallel, if with less it
/// cannot be told where they cross.
const SHARES: [f64; 3] = [CONTACT_SHARE, 0.1, 0.5];

/// A touch this many times longer than its parts is no point.
const LONGEST_TOUCH: f64 = 24.0;

/// What two surfaces share, before it is followed.
#[derive(Default)]
pub(super) struct SharedParts {
    /// Pairs of parts that cross in one arc if they do.
    pub(super) clear: Vec<[Arc<SurfacePart>; 2]>,
    pub(super) ends: CurveEnds,
    /// Places where the surfaces only touch, and lines.
    pub(super) touches: Vec<VanishingPlace>,
    pub(super) lines: Vec<BranchSamples>,
    /// How far the surfaces are apart, or reach through one another, on each of the lines.
    pub(super) gaps: Vec<f64>,
    /// Small closed curves about places where the surfaces all but touch.
    pub(super) loops: Vec<BranchSamples>,
    /// Where all is known.
    reaches: Vec<ParameterRegion>,
    /// How often a contact was looked for.
    n_looks: usize,
    /// Whether there are contacts by more of the tolerance.
    has_looser: bool,
}

/// What two surfaces share, told with as little of the tolerance as that takes.
pub(super) fn found<'s>(
    surfaces: [&'s NurbsSurface; 2],
    seams: &[EdgeOverlap],
    tolerance: f64,
    size: f64,
) -> Result<(SurfacePair<'s>, SharedParts), GeomError> {
    let with_share = |share: f64| {
        let crossing = SurfacePair::new(surfaces, [tolerance, share], size);
        let mut found = SharedParts::default();
        let sorted = found.sort_pairs(&crossing, seams);
        let is_tangled = matches!(sorted, Err(GeomError::Picture(PictureError::TooTangled { .. })));
        let needs_more = is_tangled && found.has_looser;
        (sorted.map(|()| (crossing, found)), needs_more, is_tangled)
    };
    let [least, middle, most] = SHARES;
    let (found, needs_more, _) = with_share(least);
    if !needs_more {
        return found;
    }
    // What the most of it does not tell, less of it does not either.
    let (loosest, _, is_tangled) = with_share(most);
    if is_tangled {
        return loosest;
    }
    let (found, needs_more, _) = with_share(middle);
    if needs_more { loosest } else { found }
}

impl SharedParts {
    /// Sorts pairs of parts until each is apart, clear, or within what is known about a contact.
    fn sort_pairs(
        &mut self,
        crossing: &SurfacePair<'_>,
        seams: &[EdgeOverlap],
    ) -> Result<(), GeomError> {
        let near = FLAT_SHARE * crossing.tolerance;
        let [mut firsts, mut seconds] = crossing.surfaces.map(SurfacePatches::new);
        let mut todo = firsts.pairs(&mut seconds, near);
        let mut contacts: Vec<(Bounds, [f64; 4])> = Vec::new();
        let (mut n_pairs, mut n_kept) = (0, 0);
        while let Some([a, b]) = todo.pop() {
            GeomError::go_on(1)?;
            n_pairs += 1;
            if SURFACE_PAIRS < n_pairs {
                return Err(PictureError::TooTangled { point: a.bounds.center() }.into());
            }
            let beside = || seams.iter().filter(|seam| seam.is_beside(&a, &b));
            if self.holds(&a, &b) || beside().any(|seam| seam.is_all_of(&a, &b)) {
                continue;
            }
            if beside().next().is_some()
                && crossing.touch_size() < a.bounds.union(b.bounds).diagonal()
            {
                todo.extend(halved([a, b], near, &mut n_kept));
            } else if a.crosses_clearly(&b) {
                self.clear.push([a, b]);
            } else if a.may_touch(&b) && self.add_contact(crossing, &a, &b, seams)? {
                todo.push([a, b]);
            } else if a.thickness().max(b.thickness()) <= near
                && a.bounds.diagonal().max(b.bounds.diagonal()) <= crossing.touch_size()
            {
                contacts.push((a.bounds.union(b.bounds), middle(&a, &b)));
            } else {
                todo.extend(halved([a, b], near, &mut n_kept));
            }
        }
        self.ends.spots = spots(crossing, contacts)?;
        Ok(())
    }

    /// Whether all is known that two parts share.
    fn holds(&self, a: &SurfacePart, b: &SurfacePart) -> bool {
        let low = [a.low[0], a.low[1], b.low[0], b.low[1]];
        let high = [a.high[0], a.high[1], b.high[0], b.high[1]];
        self.reaches.iter().any(|reach| reach.holds(low, high))
    }

    /// Looks for a contact in a pair; whether one was found that was not known.
    fn add_contact(
        &mut self,
        crossing: &SurfacePair<'_>,
        a: &SurfacePart,
        b: &SurfacePart,
        seams: &[EdgeOverlap],
    ) -> Result<bool, GeomError> {
        let at = middle(a, b);
        if self.n_looks == CONTACT_LOOKS || self.reaches.iter().any(|reach| reach.holds(at, at)) {
            return Ok(false);
        }
        self.n_looks += 1;
        let loosest = SHARES[SHARES.len() - 1] * crossing.tolerance;
        let seen = crossing.touch_near(at).filter(|seen| {
            let [u, v, s, t] = seen.at;
            self.has_looser |= seen.rise.abs() <= loosest;
            (crossing.is_contact(seen) || crossing.may_loop_about(seen))
                && crossing.is_inside(seen.at)
                && a.is_about([u, v])
                && b.is_about([s, t])
                && !seams.iter().any(|seam| seam.holds(seen.point, crossing.tolerance))
                && !self.reaches.iter().any(|reach| reach.holds(seen.at, seen.at))
        });
        let Some(seen) = seen else { return Ok(false) };
        let contact = crossing.contact(&seen);
        match contact {
            None => return Ok(false),
            Some(TangentialContact::Loop(around)) => {
                let Some(run) = crossing.small_loop(&around, &self.ends) else { return Ok(false) };
                self.loops.push(run);
                self.reaches.push(around.reach);
            }
            Some(_) if !crossing.is_contact(&seen) => return Ok(false),
            Some(TangentialContact::Area) => {
                return Err(PictureError::SurfacesRunTogether { point: seen.point }.into());
            }
            Some(TangentialContact::Point(reach)) => {
                self.touches.push(VanishingPlace {
                    point: reach.point,
                    radius: 0.0,
                    is_exact: true,
                });
                self.reaches.push(reach);
            }
            Some(TangentialContact::Branches(junction)) => {
                self.reaches.push(junction.reach);
                self.ends.junctions.push(*junction);
            }
            Some(TangentialContact::Line) => {
                let Some((run, reaches)) = crossing.tangency(&seen) else { return Ok(false) };
                if !run.is_on(&self.lines, crossing.tolerance) {
                    self.lines.push(run);
                    self.gaps.push(seen.rise.abs());
                }
                self.reaches.extend(reaches);
            }
        }
        Ok(true)
    }
}

/// The parameters in the middle of both parts.
pub(super) fn middle(a: &SurfacePart, b: &SurfacePart) -> [f64; 4] {
    let ([u, v], [s, t]) = (a.middle(), b.middle());
    [u, v, s, t]
}

/// A pair with its larger part in halves, those that are near; so many coefficients of parts are kept.
pub(super) fn halved(
    [a, b]: [Arc<SurfacePart>; 2],
    near: f64,
    n_kept: &mut usize,
) -> impl Iterator<Item = [Arc<SurfacePart>; 2]> {
    let pairs = if b.bounds.diagonal() <= a.bounds.diagonal() {
        a.shared_halves(n_kept).map(|half| [half, Arc::clone(&b)])
    } else {
        b.shared_halves(n_kept).map(|half| [Arc::clone(&a), half])
    };
    pairs.into_iter().filter(move |[a, b]| !a.is_apart(b, near))
}

/// The places of contacts that hang together.
fn spots(
    crossing: &SurfacePair<'_>,
    contacts: Vec<(Bounds, [f64; 4])>,
) -> Result<Vec<VanishingPlace>, GeomError> {
    let places: Vec<(DVec3, f64)> =
        contacts.iter().map(|(bounds, _)| (bounds.center(), 0.5 * bounds.diagonal())).collect();
    if CONTACTS < places.len() {
        return Err(PictureError::SurfacesRunTogether { point: places[0].0 }.into());
    }
    let mut group: Vec<usize> = (0..places.len()).collect();
    for (i, k) in chain::near_pairs(&places, crossing.tolerance) {
        let (old, new) = (group[i].max(group[k]), group[i].min(group[k]));
        group.iter_mut().filter(|number| **number == old).for_each(|number| *number = new);
    }
    let mut spots = Vec::new();
    for number in 0..places.len() {
        let members: Vec<usize> = (0..places.len()).filter(|&i| group[i] == number).collect();
        let Some(&first) = members.first() else { continue };
        let whole = members.iter().fold(contacts[first].0, |all, &i| all.union(contacts[i].0));
        let widest = members.iter().map(|&i| 2.0 * places[i].1).fold(0.0, f64::max);
        if LONGEST_TOUCH * widest < whole.diagonal() {
            return Err(PictureError::SurfacesRunTogether { point: whole.center() }.into());
        }
        let center = whole.center();
        let nearest = members.iter().copied().min_by(|&i, &k| {
            let away = |i: usize| places[i].0.distance(center);
            away(i).total_cmp(&away(k))
        });
        // Where no place is the best one, as at a pole, any is near enough.
        let seen = nearest.and_then(|i| crossing.touch_near(contacts[i].1));
        if let Some(point) = seen.and_then(|seen| crossing.loop_beside(&seen, whole)) {
            return Err(PictureError::SmallLoop { point }.into());
        }
        let is_here = |point: DVec3| whole.contains(point, 0.5 * whole.diagonal());
        let inside = seen.map(|seen| seen.point).filter(|&point| is_here(point));
        let pole = crossing.poles.iter().copied().find(|&pole| is_here(pole));
        let known = pole.or(inside);
        let point = known.unwrap_or(center);
        spots.push(VanishingPlace {
            point,
            radius: point.distance(center) + 0.5 * whole.diagonal(),
            is_exact: known.is_some(),
        });
    }
    Ok(spots)
}
