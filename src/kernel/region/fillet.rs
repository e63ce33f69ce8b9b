//! Corners rounded by arcs.
//!
//! The centre of such an arc is where the offsets of both sides by its radius meet, nearest to the corner;
//! its ends are the feet there. Newton's method on both sides themselves takes them to the last bits.

use glam::DVec3;

use super::{PlaneLoop, Region, RegionError, corner::corner_turn, offset::arc_about};
use crate::{
    ConstructionError, GeomError, InputError, Interval, NurbsCurve, PictureError, Tolerance,
    ceiling::{NEWTON_STEPS, RADIUS_BISECTIONS},
    frame::norm,
    numeric::{
        bisection::try_bisected,
        newton::{NewtonStep, within_limits},
    },
    tolerance::LAST_BIT,
};

/// A circle that touches the end of one arc and the start of the next.
#[derive(Clone, Copy)]
struct CornerCircle {
    center: DVec3,
    /// Where it touches, by the parameters of both.
    places: [f64; 2],
    /// Positive where the border turns left.
    turn: f64,
}

impl Region {
    /// The region with its corners, or with those at the points, rounded by arcs of a radius: outer ones lose
    /// what is beyond, inner ones gain it.
    ///
    /// # Errors
    /// [`InputError::NotPositive`]; [`RegionError::NoCorner`] at a point; [`RegionError::Thin`] of a radius within the
    /// tolerance; [`RegionError::NoRoom`] where a circle of that radius touches not both sides, or the rounded
    /// corners overlap.
    pub fn filleted(
        &self,
        radius: f64,
        at: Option<&[DVec3]>,
        tolerance: Tolerance,
    ) -> Result<Self, GeomError> {
        if !(0.0 < radius && radius.is_finite()) {
            return Err(InputError::NotFinite { what: "the radius", index: 0 }.into());
        }
        let size = super::bounds_of(&self.loops).map_or(0.0, crate::Bounds::diagonal);
        let tolerance = tolerance.with_distance(tolerance.distance_for(size));
        let chosen = at.map(|points| self.corners_at(points, tolerance)).transpose()?;
        let chosen = chosen.as_deref();
        match self.with_rounded(chosen, radius, tolerance) {
            Err(GeomError::Region(RegionError::NoRoom { point, .. })) => {
                let most = self.largest_radius(chosen, radius, tolerance)?;
                Err(RegionError::NoRoom { point, radius, most }.into())
            }
            found => found,
        }
    }

    /// A radius below one that is too large for which the corners are rounded, nearly the largest.
    ///
    /// # Errors
    /// Where the work is ended.
    fn largest_radius(
        &self,
        chosen: Option<&[(usize, usize)]>,
        radius: f64,
        tolerance: Tolerance,
    ) -> Result<Option<f64>, GeomError> {
        let fits = |found: Result<(), GeomError>| match found {
            Err(GeomError::Ended) => Err(GeomError::Ended),
            other => Ok(other.is_ok()),
        };
        // Whether rounded corners meet others elsewhere is looked at once, in the end.
        let corner_by_corner =
            |radius: f64| fits(self.rounded_loops(chosen, radius, tolerance).map(|_| ()));
        let most = try_bisected([0.0, radius], RADIUS_BISECTIONS, corner_by_corner)?[0];
        let is_some = 0.0 < most && fits(self.with_rounded(chosen, most, tolerance).map(|_| ()))?;
        Ok(is_some.then_some(most))
    }

    /// The region with those corners rounded that are chosen; all where nothing is said.
    ///
    /// # Errors
    /// [`RegionError::NoRoom`], which does not tell for which radius there is some.
    fn with_rounded(
        &self,
        chosen: Option<&[(usize, usize)]>,
        radius: f64,
        tolerance: Tolerance,
    ) -> Result<Self, GeomError> {
        let loops = self.rounded_loops(chosen, radius, tolerance)?;
        let region = Self { frame: self.frame, loops };
        region.check_borders(tolerance.distance).map_err(|error| match error {
            GeomError::Picture(PictureError::Crossing { point, .. }) => {
                RegionError::NoRoom { point, radius, most: None }.into()
            }
            other => other,
        })?;
        Ok(region)
    }

    /// The loops with those corners rounded, which may cross.
    fn rounded_loops(
        &self,
        chosen: Option<&[(usize, usize)]>,
        radius: f64,
        tolerance: Tolerance,
    ) -> Result<Vec<PlaneLoop>, GeomError> {
        let is_chosen =
            |corner: (usize, usize)| chosen.is_none_or(|chosen| chosen.contains(&corner));
        let loops = self.loops.iter().enumerate().map(|(number, border)| {
            self.rounded(border, |arc| is_chosen((number, arc)), radius, tolerance)
        });
        loops.collect()
    }

    /// The corners nearest to points: the number of the loop and of the arc before.
    fn corners_at(
        &self,
        points: &[DVec3],
        tolerance: Tolerance,
    ) -> Result<Vec<(usize, usize)>, GeomError> {
        let mut corners = Vec::new();
        for (number, border) in self.loops.iter().enumerate() {
            for arc in 0..border.arcs.len() {
                let (before, next) = border.around(arc);
                if corner_turn(before, next, tolerance)?.abs() > tolerance.angle {
                    corners.push(((number, arc), self.frame.point(next.start())));
                }
            }
        }
        let nearest = |&point: &DVec3| {
            let apart = |corner: &((usize, usize), DVec3)| norm(corner.1 - point);
            let found = corners.iter().min_by(|a, b| apart(a).total_cmp(&apart(b)));
            let distance = found.map_or(f64::INFINITY, apart);
            match found {
                Some(&(corner, _)) if distance <= tolerance.distance => Ok(corner),
                _ => Err(RegionError::NoCorner { point, distance }.into()),
            }
        };
        points.iter().map(nearest).collect()
    }

    /// A loop with its chosen corners rounded, by the number of the arc before each.
    fn rounded(
        &self,
        border: &PlaneLoop,
        is_chosen: impl Fn(usize) -> bool,
        radius: f64,
        tolerance: Tolerance,
    ) -> Result<PlaneLoop, GeomError> {
        let n = border.arcs.len();
        let no_room = |corner: DVec3| {
            let point = self.frame.point(corner);
            RegionError::NoRoom { point, radius, most: None }
        };
        let mut circles: Vec<Option<CornerCircle>> = vec![None; n];
        for (arc, circle) in circles.iter_mut().enumerate() {
            let (before, next) = border.around(arc);
            let angle = corner_turn(before, next, tolerance)?;
            if angle.abs() <= tolerance.angle || !is_chosen(arc) {
                continue;
            }
            // Such an arc is one place, and neither beside nor on the sides that it touches.
            if radius < tolerance.distance {
                let point = self.frame.point(next.start());
                let tolerance = tolerance.distance;
                return Err(RegionError::Thin { point, width: radius, tolerance }.into());
            }
            let found = corner_circle([before, next], angle, radius, tolerance)?;
            *circle = Some(found.ok_or_else(|| no_room(next.start()))?);
        }
        let mut arcs = Vec::with_capacity(2 * n);
        for (i, arc) in border.arcs.iter().enumerate() {
            let domain = arc.domain();
            let start = circles[(i + n - 1) % n].map_or(domain.start(), |circle| circle.places[1]);
            let end = circles[i].map_or(domain.end(), |circle| circle.places[0]);
            let dust = LAST_BIT.sqrt() * domain.length();
            match Interval::new(start, end) {
                Ok(interval) if interval == domain => arcs.push(arc.clone()),
                Ok(interval) if dust < interval.length() => arcs.push(arc.trimmed(interval)?),
                _ if (end - start).abs() <= dust => {}
                _ => return Err(no_room(arc.start()).into()),
            }
            if let Some(circle) = circles[i] {
                let next = border.around(i).1;
                let ends = [arc.point_at(circle.places[0]), next.point_at(circle.places[1])];
                let arc = arc_about(circle.center, ends[0], ends[1], circle.turn);
                arcs.push(arc.map_err(|_| no_room(next.start()))?);
            }
        }
        Ok(PlaneLoop { arcs })
    }
}

impl PlaneLoop {
    /// An arc and the next one.
    fn around(&self, arc: usize) -> (&NurbsCurve, &NurbsCurve) {
        (&self.arcs[arc], &self.arcs[(arc + 1) % self.arcs.len()])
    }
}

/// The circle of a radius that touches both arcs on the side to which the border turns, nearest to the
/// corner along the first; none where there is none.
fn corner_circle(
    arcs: [&NurbsCurve; 2],
    turn: f64,
    radius: f64,
    tolerance: Tolerance,
) -> Result<Option<CornerCircle>, GeomError> {
    let side = if 0.0 < turn { radius } else { -radius };
    let offset = |arc: &NurbsCurve| match arc.offset(-side, DVec3::Z, tolerance) {
        Ok(offset) => Ok(Some(offset.curve)),
        Err(GeomError::Construction(ConstructionError::VanishingOffset { .. })) => Ok(None),
        Err(error) => Err(error),
    };
    let [Some(first), Some(second)] = [offset(arcs[0])?, offset(arcs[1])?] else { return Ok(None) };
    let mut starts = match first.intersections(&second, tolerance.distance) {
        Ok(meetings) => {
            let foot = |arc: &NurbsCurve, point| arc.closest(point, tolerance.distance).parameter;
            let feet = |point: DVec3| arcs.map(|arc| foot(arc, point));
            meetings.iter().map(|meeting| feet(meeting.point)).collect()
        }
        // Beside a corner that is nearly straight both run together.
        Err(GeomError::Intersection(_)) => Vec::new(),
        Err(other) => return Err(other),
    };
    starts.push(beside_corner(arcs, radius * libm::tan(0.5 * turn.abs())));
    let circle = |start: [f64; 2]| {
        let places = polished(arcs, side, start)?;
        let center = beside(arcs[0], places[0], side)?.0;
        let touches = |i: usize| {
            (norm(arcs[i].point_at(places[i]) - center) - radius).abs() <= tolerance.distance
        };
        (touches(0) && touches(1)).then_some(CornerCircle { center, places, turn })
    };
    let circles = starts.into_iter().filter_map(circle);
    Ok(circles.max_by(|a, b| a.places[0].total_cmp(&b.places[0])))
}

/// The parameters at which arcs are a way from the corner between them, as far as they go straight there.
fn beside_corner(arcs: [&NurbsCurve; 2], way: f64) -> [f64; 2] {
    let [before, next] = arcs.map(NurbsCurve::domain);
    let speeds =
        [norm(arcs[0].velocity_at(before.end())[1]), norm(arcs[1].velocity_at(next.start())[1])];
    [
        (before.end() - way / speeds[0]).max(before.start()),
        (next.start() + way / speeds[1]).min(next.end()),
    ]
}

/// The point at a distance to the left of a place on an arc, and how it moves with the parameter.
fn beside(arc: &NurbsCurve, t: f64, side: f64) -> Option<(DVec3, DVec3)> {
    let d = arc.derivatives_at(t, 2);
    let speed = norm(d[1]);
    let tangent = d[1].try_normalize()?;
    let normal = DVec3::Z.cross(tangent);
    let curvature = d[1].cross(d[2]).z / (speed * speed * speed);
    Some((d[0] + normal * side, d[1] * (1.0 - curvature * side)))
}

/// The parameters at which the points beside both arcs are one.
fn polished(arcs: [&NurbsCurve; 2], side: f64, start: [f64; 2]) -> Option<[f64; 2]> {
    let limits = arcs.map(|arc| [arc.domain().start(), arc.domain().end()]);
    let is_still = |last: [f64; 2], next: [f64; 2]| {
        (0..2).all(|i| (next[i] - last[i]).abs() <= LAST_BIT * next[i].abs())
    };
    let found = within_limits(limits, start, NEWTON_STEPS, is_still, |[t, s]| {
        let both = [beside(arcs[0], t, side), beside(arcs[1], s, side)];
        let [Some((p, dp)), Some((q, dq))] = both else { return NewtonStep::Stay };
        let (gap, det) = (q - p, dq.cross(dp).z);
        let step = [dq.cross(gap).z / det, dp.cross(gap).z / det];
        NewtonStep::perhaps(step.iter().all(|step| step.is_finite()).then_some(step))
    });
    found.unless_stuck()
}
