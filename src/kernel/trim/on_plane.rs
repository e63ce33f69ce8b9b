//! Curves on plane patches as curves of their parameters: by the map of the patch turned around, which keeps what they are.

use glam::{DAffine3, DVec3};

use super::{
    lift::parameters_map,
    pull::{ArcParameters, COMPARED, PulledCurve},
};
use crate::{GeomError, NurbsCurve, frame::norm, tolerance::PULL_SHARE};

impl PulledCurve<'_> {
    /// The arc of a curve that is within the tolerance of a plane patch and nowhere beyond its border; with a height, of
    /// one along which that vanishes wherever it is looked at. None of others, which may lie there too, and of
    /// rational ones where the arc is to have their parameters, as a polynomial.
    pub(super) fn arc_on_plane(&self) -> Result<Option<NurbsCurve>, GeomError> {
        if self.parameters == ArcParameters::OfCurve && self.curve.is_rational() {
            return Ok(None);
        }
        let Some(map) = parameters_map(&self.plane.surface) else { return Ok(None) };
        let [u, v] = self.plane.scales;
        let place = DAffine3::from_scale(DVec3::new(u, v, 1.0)) * map;
        let (reach, domain) = (self.curve.transformed(&place).bounds(), self.plane.bounds());
        let beyond = (domain.min - reach.min).max(reach.max - domain.max).truncate().max_element();
        let aside = reach.min.z.abs().max(reach.max.z.abs());
        let is_there = beyond <= self.accuracy && aside <= self.tolerance;
        if !is_there {
            return Ok(None);
        }
        let flat = DAffine3::from_scale(DVec3::new(1.0, 1.0, 0.0));
        let arc = self.curve.transformed(&(flat * place));
        if !self.is_along_height(&arc)? {
            return Ok(None);
        }
        Ok(Some(match self.parameters {
            ArcParameters::Any => self.straightened(&arc)?.unwrap_or(arc),
            ArcParameters::OfCurve => arc,
        }))
    }

    /// Whether the height vanishes along an arc, wherever it is looked at in each span.
    fn is_along_height(&self, arc: &NurbsCurve) -> Result<bool, GeomError> {
        if self.height.is_none() {
            return Ok(true);
        }
        for span in arc.knots().spans() {
            let span = arc.knots().span_interval(span);
            for t in COMPARED.map(|fraction| span.at(fraction)) {
                let place = arc.point_at(t);
                let (found, rounding) = self.place_between(t, place)?;
                if self.accuracy.max(rounding) < norm(found - place) {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }

    /// The line between the ends of an arc whose control points lie along it one behind the other.
    fn straightened(&self, arc: &NurbsCurve) -> Result<Option<NurbsCurve>, GeomError> {
        let (first, way) = (arc.start(), arc.end() - arc.start());
        let length = norm(way);
        if length <= PULL_SHARE * self.tolerance {
            return Ok(None);
        }
        let points = arc.points();
        let is_beside = |&point: &DVec3| norm((point - first).cross(way)) <= self.accuracy * length;
        let is_ahead = |pair: &[DVec3]| 0.0 <= (pair[1] - pair[0]).dot(way);
        let is_straight = points.iter().all(is_beside) && points.windows(2).all(is_ahead);
        is_straight.then(|| self.line_between([first, arc.end()])).transpose()
    }
}
