//! The parameters of a surface as a plane in which lengths are no shorter than on the surface.

use std::sync::Arc;

use glam::{DAffine3, DVec3};

use crate::{
    Bounds, Direction, GeomError, Interval, NurbsCurve, NurbsSurface, frame::norm,
    tolerance::LAST_BIT,
};

/// Even parts of each span at whose ends first derivatives are looked at.
const PARTS: usize = 3;

/// What the largest first derivative may exceed those that were looked at by.
const ROOM: f64 = 1.25;

/// A surface, and its plane of parameters.
#[derive(Clone, Debug)]
pub(crate) struct ParameterPlane {
    pub(crate) surface: Arc<NurbsSurface>,
    /// What u and v are multiplied by: powers of two, so that nothing is rounded.
    pub(crate) scales: [f64; 2],
    /// Whether the edges at both ends of u, and of v, are one.
    pub(crate) is_closed: [bool; 2],
    /// Values of u, and of v, along which the surface is bent.
    pub(super) creases: Arc<[Vec<f64>; 2]>,
}

impl PartialEq for ParameterPlane {
    fn eq(&self, other: &Self) -> bool {
        self.surface == other.surface
    }
}

impl ParameterPlane {
    pub(crate) fn of(surface: Arc<NurbsSurface>, tolerance: f64) -> Self {
        let places = [surface.knots_u(), surface.knots_v()].map(|knots| {
            let spans = knots.spans().flat_map(|span| knots.span_interval(span).steps(PARTS));
            let mut places: Vec<f64> = spans.collect();
            places.dedup();
            places
        });
        let mut most = [0.0_f64; 2];
        for &u in &places[0] {
            for &v in &places[1] {
                let [_, along_u, along_v] = surface.tangents_at(u, v);
                most = [most[0].max(norm(along_u)), most[1].max(norm(along_v))];
            }
        }
        let scales = most.map(|most| {
            let (_, exponent) = libm::frexp(ROOM * most);
            let scale = libm::ldexp(1.0, exponent);
            if scale.is_normal() { scale } else { 1.0 }
        });
        let is_closed = [surface.is_closed_u(tolerance), surface.is_closed_v(tolerance)];
        let creases = Arc::new(Direction::BOTH.map(|along| surface.creases(along)));
        Self { surface, scales, is_closed, creases }
    }

    /// The last bit of the surface's size, and of its coordinates and parameters, which may be far larger:
    /// parameters far from 0 for their width have fewer digits than places.
    pub(super) fn last_bit(&self) -> f64 {
        let bounds = self.surface.bounds();
        let widths_from_zero =
            |domain: Interval| domain.start().abs().max(domain.end().abs()) / domain.length();
        let [u, v] = self.domains().map(widths_from_zero);
        LAST_BIT * (bounds.diagonal() * u.max(v).max(1.0)).max(bounds.magnitude())
    }

    pub(crate) fn domains(&self) -> [Interval; 2] {
        [self.surface.domain_u(), self.surface.domain_v()]
    }

    /// The place of parameters.
    pub(crate) fn place(&self, [u, v]: [f64; 2]) -> DVec3 {
        DVec3::new(self.scales[0] * u, self.scales[1] * v, 0.0)
    }

    /// The parameters of a place, within the domain.
    pub(crate) fn parameters(&self, place: DVec3) -> [f64; 2] {
        let [u, v] = self.domains();
        let at =
            |x: f64, scale: f64, domain: Interval| (x / scale).clamp(domain.start(), domain.end());
        [at(place.x, self.scales[0], u), at(place.y, self.scales[1], v)]
    }

    /// The point of the surface at a place.
    pub(crate) fn point(&self, place: DVec3) -> DVec3 {
        let [u, v] = self.parameters(place);
        self.surface.point_at(u, v)
    }

    /// A curve of parameters, in the plane.
    pub(crate) fn to_plane(&self, curve: &NurbsCurve) -> NurbsCurve {
        curve.transformed(&DAffine3::from_scale(DVec3::new(self.scales[0], self.scales[1], 0.0)))
    }

    /// A curve in the plane, as one of parameters.
    pub(crate) fn to_parameters(&self, curve: &NurbsCurve) -> NurbsCurve {
        let [a, b] = self.scales.map(f64::recip);
        curve.transformed(&DAffine3::from_scale(DVec3::new(a, b, 0.0)))
    }

    /// The border of the domain, counter-clockwise: along u at the start of v, along v at the end of u,
    /// and back.
    ///
    /// # Errors
    /// Those of [`NurbsCurve::line`].
    pub(crate) fn border(&self) -> Result<Vec<NurbsCurve>, GeomError> {
        let [u, v] = self.domains();
        let corners = [
            [u.start(), v.start()],
            [u.end(), v.start()],
            [u.end(), v.end()],
            [u.start(), v.end()],
        ]
        .map(|corner| self.place(corner));
        (0..4).map(|i| NurbsCurve::line(corners[i], corners[(i + 1) % 4])).collect()
    }

    /// The box of the domain.
    pub(crate) fn bounds(&self) -> Bounds {
        let [u, v] = self.domains();
        Bounds { min: self.place([u.start(), v.start()]), max: self.place([u.end(), v.end()]) }
    }
}
