//! The point of a curve that is nearest to a given one.

use glam::{DAffine3, DVec3};

use crate::{
    Interval, Side,
    curve::NurbsCurve,
    frame::norm,
    nearest::{ClosestPointTree, SearchTarget},
    scale::needed_scale,
    sorting::sort_by,
    tolerance::{LAST_BIT, PLACE_RELATIVE},
};

/// The nearest point of a curve.
///
/// ```
/// use virote_kernel::{NurbsCurve, glam::DVec3};
///
/// let line = NurbsCurve::line(DVec3::ZERO, DVec3::new(4.0, 0.0, 0.0))?;
/// let foot = line.closest(DVec3::new(1.0, 3.0, 0.0), 1e-6);
/// assert!((foot.distance - 3.0).abs() < 1e-15 && (foot.parameter - 0.25).abs() < 1e-15);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosestPoint {
    /// Where it is; the least parameter among equals.
    pub parameter: f64,
    /// The point.
    pub point: DVec3,
    /// How far away it is.
    pub distance: f64,
    /// Places that are as near as that, within the tolerance; a stretch that is all as near, which
    /// has infinitely many, counts once.
    pub count: usize,
    /// The first stretch that is all as near.
    pub stretch: Option<Interval>,
}

impl NurbsCurve {
    /// The nearest point to `p`, of the whole curve. Places of the curve whose distances differ by
    /// less than `tolerance` count as equally near.
    #[must_use]
    pub fn closest(&self, p: DVec3, tolerance: f64) -> ClosestPoint {
        if let Some(scale) = needed_scale(self.bounds().magnitude()) {
            let plain = self.transformed(&DAffine3::from_scale(DVec3::splat(scale.recip())));
            let foot = plain.closest(p / scale, tolerance / scale);
            let point = self.point_at(foot.parameter);
            return ClosestPoint { point, distance: scale * foot.distance, ..foot };
        }
        let parts = self.connected_parts();
        if let [_] = parts[..] {
            return self.closest_of_part(p, tolerance);
        }
        let feet: Vec<ClosestPoint> = parts
            .iter()
            .map(|part| {
                let foot = part.closest_of_part(p, tolerance);
                ClosestPoint { parameter: self.on_whole(part, foot.parameter), ..foot }
            })
            .collect();
        let best = feet.iter().map(|foot| foot.distance).fold(f64::INFINITY, f64::min);
        let rounding = LAST_BIT * (p.abs().max_element() + self.magnitude());
        let is_as_near = |foot: &&ClosestPoint| foot.distance <= best + tolerance;
        let count = feet.iter().filter(is_as_near).map(|foot| foot.count).sum();
        let stretch = feet.iter().filter(is_as_near).find_map(|foot| foot.stretch);
        let nearest = feet.iter().find(|foot| foot.distance <= best + rounding);
        ClosestPoint { count, stretch, ..*nearest.unwrap_or(&feet[0]) }
    }

    /// One of the nearest places to `p`, with its distance, if that is no more than `distance`: faster than
    /// [`Self::closest`] for those who ask for nothing else.
    pub(crate) fn foot_within(&self, p: DVec3, distance: f64) -> Option<(f64, f64)> {
        let is_plain =
            !self.knots.has_inner_full_break() && needed_scale(self.bounds().magnitude()).is_none();
        let (parameter, found) = if is_plain {
            let wanted = SearchTarget::OneWithin(distance);
            let near = self.piece_boxes().places(&self.control_points, p, wanted);
            let t = self.domain().without_dust(near.single.first()?[1]);
            (t, norm(self.point_at(t) - p))
        } else {
            let foot = self.closest(p, distance);
            (foot.parameter, foot.distance)
        };
        (found <= distance).then_some((parameter, found))
    }

    /// The pieces in their boxes, made once: where the nearest point is looked for, and what else
    /// lies in space.
    pub(crate) fn piece_boxes(&self) -> &ClosestPointTree {
        let prepare = || ClosestPointTree::of_curve(&self.knots, &self.control_points);
        self.nearest.get_or_make(prepare)
    }

    /// [`Self::closest`] of a curve that does not jump.
    fn closest_of_part(&self, p: DVec3, tolerance: f64) -> ClosestPoint {
        let nearest = self.piece_boxes();
        let near = nearest.places(&self.control_points, p, SearchTarget::AllWithin(tolerance));
        let to_foot = |[_, t]: [f64; 2]| {
            let t = self.domain().without_dust(t);
            (t, norm(self.point_at(t) - p))
        };
        let mut feet: Vec<(f64, f64)> = near.single.into_iter().map(to_foot).collect();
        let best = feet.iter().map(|&(_, distance)| distance).fold(f64::INFINITY, f64::min);
        let rounding = LAST_BIT * (p.abs().max_element() + nearest.control_magnitude());
        feet.retain(|&(_, distance)| distance <= best + tolerance);
        // Other places on the way to them are dropped, unless there is nothing else.
        if feet.iter().any(|&(t, distance)| distance <= best + rounding && self.is_foot(t, p)) {
            feet.retain(|&(t, _)| self.is_foot(t, p));
        } else {
            feet.retain(|&(_, distance)| distance <= best + rounding);
        }
        sort_by(&mut feet, |a, b| a.0.total_cmp(&b.0));
        let first = feet.iter().find(|&&(_, distance)| distance <= best + rounding);
        let parameter = first.map_or(self.domain().start(), |&(t, _)| t);
        let point = self.point_at(parameter);
        let is_near = |t: f64| norm(self.point_at(t) - p) <= best + tolerance;
        let pieces = near.stretches.iter().map(|&[[_, start], [_, end]]| (start, end));
        let pieces = pieces.filter(|&(start, end)| is_near(start) && is_near(end)).collect();
        let stretches = self.joined_stretches(pieces, tolerance);
        let count = self.different_places(&feet, &stretches, tolerance).max(1);
        let stretch = stretches.first().copied();
        ClosestPoint { parameter, point, distance: norm(point - p), count, stretch }
    }

    /// Pieces that touch as one; without those that are but a place within the tolerance.
    fn joined_stretches(&self, mut pieces: Vec<(f64, f64)>, tolerance: f64) -> Vec<Interval> {
        sort_by(&mut pieces, |a, b| a.0.total_cmp(&b.0));
        let rounding = LAST_BIT * self.domain().length();
        let mut joined: Vec<(f64, f64)> = Vec::new();
        for (start, end) in pieces {
            match joined.last_mut() {
                Some(last) if start <= last.1 + rounding => last.1 = last.1.max(end),
                _ => joined.push((start, end)),
            }
        }
        let is_wide = |stretch: &Interval| {
            let start = self.point_at(stretch.start());
            let others = [stretch.at(0.5), stretch.end()].map(|t| self.point_at(t));
            others.into_iter().any(|other| tolerance < start.distance(other))
        };
        let stretches =
            joined.into_iter().filter_map(|(start, end)| Interval::new(start, end).ok());
        stretches.filter(is_wide).collect()
    }

    /// Whether neither side of a place leads nearer to `p`; at the seam of a closed curve there
    /// are two.
    fn is_foot(&self, t: f64, p: DVec3) -> bool {
        let domain = self.domain();
        let is_closed = self.start() == self.end();
        // The slope in units of what it may be: a parameter has no more digits than the domain's
        // ends, and where unequal weights crowd the curve each is a way.
        let digit = LAST_BIT * domain.start().abs().max(domain.end().abs());
        let slope = |t: f64, side: Side| {
            let [point, velocity] = self.velocity_on(self.knots.span_beside(t, side), t);
            let away = point - p;
            let (distance, speed) = (norm(away), norm(velocity));
            let allowed = PLACE_RELATIVE.max(digit * speed / distance);
            away.dot(velocity) / (distance * speed) / allowed
        };
        let before = match t <= domain.start() {
            false => slope(t, Side::Left),
            true if is_closed => slope(domain.end(), Side::Left),
            true => 0.0,
        };
        let behind = match domain.end() <= t {
            false => slope(t, Side::Right),
            true if is_closed => slope(domain.start(), Side::Right),
            true => 0.0,
        };
        // Where the curve stands still there is no slope.
        !(1.0 < before || behind < -1.0)
    }

    /// How many of the feet are different places of the curve, each stretch being one.
    fn different_places(
        &self,
        feet: &[(f64, f64)],
        stretches: &[Interval],
        tolerance: f64,
    ) -> usize {
        let ends = stretches.iter().flat_map(|stretch| [stretch.start(), stretch.end()]);
        // Sorted by x, so that few are compared.
        let mut places: Vec<DVec3> = ends.map(|t| self.point_at(t)).collect();
        sort_by(&mut places, |a, b| a.x.total_cmp(&b.x));
        let n_ends = places.len();
        for &(t, _) in feet {
            let point = self.point_at(t);
            let first = places.partition_point(|place| place.x < point.x - tolerance);
            let mut beside =
                places[first..].iter().take_while(|place| place.x <= point.x + tolerance);
            let is_known = stretches.iter().any(|stretch| stretch.contains(t))
                || beside.any(|place| place.distance(point) <= tolerance);
            if !is_known {
                let idx = places.partition_point(|place| place.x < point.x);
                places.insert(idx, point);
            }
        }
        // Stretches on both sides of a seam are one.
        let goes_over_the_seam = match stretches {
            [first, .., last] => {
                let domain = self.domain();
                self.start() == self.end()
                    && first.start() <= domain.start()
                    && domain.end() <= last.end()
            }
            _ => false,
        };
        places.len() - n_ends + stretches.len() - usize::from(goes_over_the_seam)
    }
}
