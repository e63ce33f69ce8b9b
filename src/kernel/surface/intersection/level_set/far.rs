//! Lines on surfaces whose parameters are far from zero, such as seconds of an epoch.
//!
//! They are looked for on the same surface from zero on, where parameters have all their digits.

use std::sync::Arc;

use super::{error::PictureError, results::CurveSurfaceIntersection};
use crate::{Curve, Direction, GeomError, Interval, NurbsCurve, NurbsSurface, Surface, Tolerance};

impl NurbsSurface {
    /// The surface over 0 to the lengths of its domains, if one of them is far from zero.
    pub(super) fn near_zero(&self) -> Option<Self> {
        let along = |surface: &Self, direction: Direction| {
            let domain = surface.domain(direction).near_zero()?;
            Some(surface.reparametrized(direction, domain))
        };
        let by_u = along(self, Direction::U);
        let by_v = along(by_u.as_ref().unwrap_or(self), Direction::V);
        by_v.or(by_u)
    }

    /// What was found on the surface of [`Self::near_zero`], a refusal with the parameters of this.
    pub(super) fn told_here<T>(&self, found: Result<T, GeomError>) -> Result<T, GeomError> {
        let [by_u, by_v] = [self.domain_u(), self.domain_v()];
        found.map_err(|error| match error {
            GeomError::Picture(PictureError::Unresolved { u, v }) => {
                let (u, v) = (by_u.far_from_zero(u), by_v.far_from_zero(v));
                PictureError::Unresolved { u, v }.into()
            }
            other => other,
        })
    }
}

impl Surface {
    /// A spline and that over 0 to the lengths of its domains, if one of them is far from zero.
    pub(super) fn near_zero(&self) -> Option<(&NurbsSurface, Self)> {
        match self {
            Self::Nurbs(surface) => Some((surface, surface.near_zero()?.into())),
            Self::Parametric(_) => None,
        }
    }
}

/// Places that a curve and a surface have in common, of which one is far from zero; none where neither is.
pub(super) fn piercings_near_zero(
    curve: &NurbsCurve,
    surface: &NurbsSurface,
    tolerance: Tolerance,
) -> Option<Result<Vec<CurveSurfaceIntersection>, GeomError>> {
    let (near, near_surface) = (curve.near_zero(), surface.near_zero());
    if near.is_none() && near_surface.is_none() {
        return None;
    }
    let domains: [Interval; 3] = [curve.domain(), surface.domain_u(), surface.domain_v()];
    let near = Curve::from(near.unwrap_or_else(|| curve.clone()));
    let near_surface = near_surface.unwrap_or_else(|| surface.clone());
    let found = Surface::Nurbs(Arc::new(near_surface)).piercings(&near, tolerance);
    let told = |place: CurveSurfaceIntersection| CurveSurfaceIntersection {
        t: domains[0].far_from_zero(place.t),
        uv: [0, 1].map(|i| domains[i + 1].far_from_zero(place.uv[i])),
        ..place
    };
    let found = found.map(|found| found.into_iter().map(told).collect());
    Some(found.map_err(|error| match error {
        GeomError::Picture(PictureError::RunsAlong { start, end }) => {
            let [start, end] = [start, end].map(|t| domains[0].far_from_zero(t));
            PictureError::RunsAlong { start, end }.into()
        }
        other => other,
    }))
}
