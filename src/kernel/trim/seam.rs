//! Curves on a surface where they go over a seam of it, or touch one.

use glam::DVec3;

use super::pull::{PulledCurve, Section};
use crate::{
    GeomError, RegionError,
    ceiling::BISECTIONS,
    frame::norm,
    tolerance::{JUMP_SHARE, LAST_BIT},
};

/// Tolerances from a seam within which a stretch beyond it cannot be told from the seam.
const SHALLOW: f64 = 8.0;

/// Where a stretch is looked at for how far it goes from a seam.
const DEPTH_LOOKS: [f64; 3] = [0.25, 0.5, 0.75];

/// A parameter with its place on either side of a jump.
pub(super) type Jump = ((f64, DVec3), (f64, DVec3));

impl PulledCurve<'_> {
    /// A place on a seam, at the end of the domain where another is.
    pub(super) fn on_side_of(&self, mut place: DVec3, near: DVec3) -> DVec3 {
        let bounds = self.plane.bounds();
        for i in (0..2).filter(|&i| self.plane.is_closed[i]) {
            let (low, high) = (bounds.min[i], bounds.max[i]);
            // The foot of what is on a seam may be at either end; what is beside it is not.
            let other = if place[i] - low <= self.accuracy {
                high
            } else if high - place[i] <= self.accuracy {
                low
            } else {
                continue;
            };
            if 0.5 * (high - low) < (place[i] - near[i]).abs() {
                place[i] = other;
            }
        }
        place
    }

    /// The place between those of a stretch without jumps, and how far rounding may move it. Where the curve
    /// touches a seam it may pass it by as much as the tolerance: it stays there.
    pub(super) fn place_between(&self, t: f64, near: DVec3) -> Result<(DVec3, f64), GeomError> {
        let (mut place, rounding) = self.place_and_rounding(t, near)?;
        if let Some((on_seam, depth)) = self.on_seam_beside(place, near)
            && depth <= self.tolerance
        {
            place = on_seam;
        }
        Ok((place, rounding))
    }

    /// The place on the seam between a place and another one on its other side, and how far it is from the first
    /// in space; none where no seam is between them.
    pub(super) fn on_seam_beside(&self, place: DVec3, near: DVec3) -> Option<(DVec3, f64)> {
        let bounds = self.plane.bounds();
        let mut on_seam = place;
        for i in (0..2).filter(|&i| self.plane.is_closed[i]) {
            let (low, high) = (bounds.min[i], bounds.max[i]);
            if 0.5 * (high - low) < (place[i] - near[i]).abs() {
                on_seam[i] = if place[i] < near[i] { high } else { low };
            }
        }
        let depth = norm(self.plane.point(on_seam) - self.plane.point(place));
        (on_seam != place).then_some((on_seam, depth))
    }

    /// A parameter between two neighbours on one side of a seam at which the curve is beyond it by more than the
    /// tolerance; none where it comes no nearer than that, or is far from one.
    pub(super) fn dip_between(
        &self,
        before: (f64, DVec3),
        here: (f64, DVec3),
    ) -> Result<Option<f64>, GeomError> {
        let bounds = self.plane.bounds();
        for i in (0..2).filter(|&i| self.plane.is_closed[i]) {
            let (low, high) = (bounds.min[i], bounds.max[i]);
            let from_low = before.1[i] - low < high - before.1[i];
            let height = |place: DVec3| if from_low { place[i] - low } else { high - place[i] };
            let way = norm(here.1 - before.1);
            if way < height(before.1).min(height(here.1)) {
                continue;
            }
            // What is on the seam wherever it is looked at runs along it.
            let is_on = |place: DVec3| height(place) <= self.accuracy;
            let mut is_along = is_on(before.1) && is_on(here.1);
            for share in DEPTH_LOOKS {
                let t = before.0 + share * (here.0 - before.0);
                is_along = is_along && is_on(self.place(t, before.1)?);
            }
            // Between both it is least in one place.
            let (mut ends, mut near, mut is_first) = ([before.0, here.0], before.1, true);
            // In what is left of the stretch it gets no farther beyond the seam than the tolerance.
            let rounding = 8.0 * LAST_BIT * before.0.abs().max(here.0.abs());
            let shortest = (0.5 * self.tolerance * (here.0 - before.0) / way).max(rounding);
            while !is_along && shortest < ends[1] - ends[0] {
                let mut heights = [0.0; 2];
                for (height_at, share) in heights.iter_mut().zip([0.45, 0.55]) {
                    let t = ends[0] + share * (ends[1] - ends[0]);
                    let place = self.place(t, near)?;
                    match self.on_seam_beside(place, before.1) {
                        Some((_, depth)) if self.tolerance < depth => return Ok(Some(t)),
                        Some((_, depth)) => *height_at = -depth,
                        None => (*height_at, near) = (height(place), place),
                    }
                }
                let at = |share: f64| ends[0] + share * (ends[1] - ends[0]);
                let is_early = heights[0] < heights[1];
                ends = if is_early { [ends[0], at(0.55)] } else { [at(0.45), ends[1]] };
                if std::mem::take(&mut is_first) {
                    // From an end where it is least it goes away from the seam at once.
                    let (end, inward) =
                        if is_early { (before, shortest) } else { (here, -shortest) };
                    let place = self.place(end.0 + inward, end.1)?;
                    if self.on_seam_beside(place, before.1).is_none()
                        && height(end.1) + self.accuracy < height(place)
                    {
                        break;
                    }
                }
            }
        }
        Ok(None)
    }

    /// Fails of a stretch from a seam and back to it that is nowhere clearly away from it: what it cuts off there
    /// is narrower than can be told.
    pub(super) fn check_beyond_seam(&self, section: Section) -> Result<(), GeomError> {
        let bounds = self.plane.bounds();
        let [(from, first), (to, last)] = section;
        let near = SHALLOW * self.tolerance;
        for i in (0..2).filter(|&i| self.plane.is_closed[i]) {
            for end in [bounds.min[i], bounds.max[i]] {
                let is_near = |place: DVec3| {
                    let mut on_seam = place;
                    on_seam[i] = end;
                    norm(self.plane.point(on_seam) - self.plane.point(place)) <= near
                        && (place[i] - end).abs() < 0.5 * (bounds.max[i] - bounds.min[i])
                };
                let mut is_shallow = is_near(first) && is_near(last);
                for share in DEPTH_LOOKS {
                    let t = from + share * (to - from);
                    is_shallow = is_shallow && is_near(self.place_between(t, first)?.0);
                }
                // What runs along the seam is on it.
                let is_on = |place: DVec3| (place[i] - end).abs() <= self.accuracy;
                let middle = self.place_between(0.5 * (from + to), first)?.0;
                if is_shallow && !is_on(middle) {
                    return Err(RegionError::Unclear { point: self.plane.point(middle) }.into());
                }
            }
        }
        Ok(())
    }

    /// The places on both sides of the first jump between two places; none where there is no jump.
    pub(super) fn jump_between(
        &self,
        mut low: (f64, DVec3),
        last: (f64, DVec3),
    ) -> Result<Option<Jump>, GeomError> {
        let mut high = last;
        for _ in 0..4 * BISECTIONS {
            if !self.is_jump(low.1, high.1) {
                if last.0 <= high.0 {
                    return Ok(None);
                }
                (low, high) = (high, last);
                continue;
            }
            if high.0 - low.0 <= 2.0 * LAST_BIT * high.0.abs().max(low.0.abs()) {
                break;
            }
            let middle = 0.5 * (low.0 + high.0);
            let place = self.place(middle, low.1)?;
            if self.is_jump(low.1, place) {
                high = (middle, place);
            } else {
                low = (middle, place);
            }
        }
        Ok(Some((low, high)))
    }

    /// Whether parameters jump from one place to another, which are neighbours on the curve.
    pub(super) fn is_jump(&self, from: DVec3, to: DVec3) -> bool {
        let bounds = self.plane.bounds();
        let (way, size) = ((to - from).abs(), bounds.max - bounds.min);
        (0..2).any(|i| JUMP_SHARE * size[i] < way[i])
    }

    /// The place on the border of the domain, where it is within the tolerance of that.
    pub(super) fn at_border(&self, mut place: DVec3) -> DVec3 {
        let bounds = self.plane.bounds();
        for i in 0..2 {
            for end in [bounds.min[i], bounds.max[i]] {
                if (place[i] - end).abs() <= self.tolerance {
                    place[i] = end;
                }
            }
        }
        place
    }
}
