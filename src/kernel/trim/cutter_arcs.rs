//! Where cutters run over a face, in its plane of parameters.

use std::{cell::Cell, sync::Arc};

use glam::DVec3;

use super::{
    Cutter, Face, FaceError,
    loops::place_of,
    pull::{ArcParameters, Height, MOST_BESIDE, arcs_on_surface},
};
use crate::{
    Frame, GeomError, IntersectionError, NurbsCurve, NurbsSurface, PictureError, Surface,
    SurfaceClosestPoint, Tolerance,
};

/// How many times larger than a face a cutter may be whose equation tells how far places are from it.
const SIMILAR_SIZE: f64 = 8.0;

impl Face {
    /// The arcs of a cutter in the plane of parameters, over the whole surface.
    pub(super) fn arcs_of(
        &self,
        cutter: &Cutter,
        index: usize,
        tolerance: Tolerance,
    ) -> Result<Vec<NurbsCurve>, GeomError> {
        let limits = [self.distance(tolerance), tolerance.angle];
        match cutter {
            Cutter::Curve(curve) => {
                let arcs = self.pulled(std::slice::from_ref(curve), None, index, limits)?;
                let is_on = |p: DVec3| curve.closest(p, limits[0]).distance <= limits[0];
                self.with_pinches(arcs, limits[0], is_on)
            }
            Cutter::Plane(plane) => Ok(self.plane_arcs(*plane, index, tolerance)?.0),
            Cutter::Faces(faces) => {
                let of_face = |face: &Self| {
                    self.arcs_of(&Cutter::Face(Arc::new(face.clone())), index, tolerance)
                };
                Ok(faces.iter().map(of_face).collect::<Result<Vec<_>, _>>()?.concat())
            }
            Cutter::Surface(other) => self.arcs_of_surface(other, None, index, tolerance),
            Cutter::Face(face) => {
                self.arcs_of_surface(face.surface(), Some(face), index, tolerance)
            }
        }
    }

    /// The arcs of a surface, or of a face on it.
    fn arcs_of_surface(
        &self,
        other: &Arc<NurbsSurface>,
        face: Option<&Self>,
        index: usize,
        tolerance: Tolerance,
    ) -> Result<Vec<NurbsCurve>, GeomError> {
        let limits = [self.distance(tolerance), tolerance.angle];
        let is_on = |p: DVec3| {
            let foot = other.closest(p);
            foot.distance <= limits[0]
                && face.is_none_or(|face| face.has(foot.parameters, tolerance))
        };
        if self.lies_along(other, tolerance) {
            let whole = match face {
                Some(_) => None,
                None => Some(Self::whole(Arc::clone(other), tolerance)?),
            };
            let arcs = match face.or(whole.as_ref()) {
                Some(face) => self.overlaid_arcs(face, index, tolerance)?,
                None => Vec::new(),
            };
            return self.with_pinches(arcs, limits[0], is_on);
        }
        let surface = Surface::Nurbs(Arc::clone(&self.plane.surface));
        let found = surface
            .intersections(&Surface::Nurbs(Arc::clone(other)), tolerance)
            .map_err(self.runs_together(index))?;
        let curves = match face {
            Some(face) => face.clipped(&found.curves, tolerance)?,
            None => found.curves,
        };
        let last_foot = Cell::new(None);
        // Of what is many times larger an equation has fewer digits than the face.
        let most = SIMILAR_SIZE * self.plane.surface.bounds().magnitude();
        let form = other
            .analytic(limits[0])
            .filter(|form| form.radius().max(other.bounds().magnitude()) <= most);
        let height = |p: DVec3| {
            if let Some(form) = form {
                return form.height(p);
            }
            let foot = foot_beside(other, p, last_foot.get(), limits[0]);
            last_foot.set(Some(foot.parameters));
            let [u, v] = foot.parameters;
            // Without a normal there is no height, and the place stays as it was found.
            other
                .normal_at(u, v)
                .map_or((f64::NAN, DVec3::ZERO), |normal| ((p - foot.point).dot(normal), normal))
        };
        let arcs = self.pulled(&curves, Some(&height), index, limits)?;
        self.with_pinches(arcs, limits[0], is_on)
    }

    /// The arcs of a plane, and places that it has in common with the surface, one of each curve among them.
    pub(super) fn plane_arcs(
        &self,
        plane: Frame,
        index: usize,
        tolerance: Tolerance,
    ) -> Result<(Vec<NurbsCurve>, Vec<DVec3>), GeomError> {
        let surface = Surface::Nurbs(Arc::clone(&self.plane.surface));
        let found = surface.section(plane, tolerance).map_err(self.runs_along(index))?;
        let height = |p: DVec3| ((p - plane.origin()).dot(plane.z()), plane.z());
        let limits = [self.distance(tolerance), tolerance.angle];
        let arcs = self.pulled(&found.curves, Some(&height), index, limits)?;
        let arcs = self.with_pinches(arcs, limits[0], |p| height(p).0.abs() <= limits[0])?;
        let middle = |curve: &NurbsCurve| curve.point_at(curve.domain().at(0.5));
        let on_curves: Vec<DVec3> = found.curves.iter().map(middle).collect();
        Ok((arcs, [found.touches, found.contacts, found.uncertain, on_curves].concat()))
    }

    pub(super) fn pulled(
        &self,
        curves: &[NurbsCurve],
        height: Option<&Height<'_>>,
        index: usize,
        limits: [f64; 2],
    ) -> Result<Vec<NurbsCurve>, GeomError> {
        let mut arcs = Vec::new();
        for curve in curves {
            let (named, parameters) = (("cutter", index), ArcParameters::Any);
            arcs.extend(arcs_on_surface(&self.plane, curve, height, named, limits, parameters)?);
        }
        Ok(arcs)
    }

    /// What a plane in which the surface lies is told as.
    fn runs_along(&self, index: usize) -> impl Fn(GeomError) -> GeomError {
        move |error| match self.shared_place(&error) {
            Some(point) => FaceError::RunsAlong { index, point }.into(),
            None => error,
        }
    }

    /// What another surface that has an area in common with it without being the same is told as.
    fn runs_together(&self, index: usize) -> impl Fn(GeomError) -> GeomError {
        move |error| match self.shared_place(&error) {
            Some(point) => FaceError::RunsTogether { index, point }.into(),
            None => error,
        }
    }

    /// A place of what a cutter shares with it, if an error says that it does.
    fn shared_place(&self, error: &GeomError) -> Option<DVec3> {
        match error {
            GeomError::Picture(PictureError::SurfacesRunTogether { point }) => Some(*point),
            GeomError::Intersection(IntersectionError::RunTogether { .. }) => {
                Some(self.plane.point(place_of(&self.parts)))
            }
            _ => None,
        }
    }
}

/// The nearest point of a surface on which a curve is followed from place to place: where a descent from the last
/// one goes, unless that ends at an edge or further away than such places are.
fn foot_beside(
    surface: &NurbsSurface,
    point: DVec3,
    last: Option<[f64; 2]>,
    tolerance: f64,
) -> SurfaceClosestPoint {
    let domains = [surface.domain_u(), surface.domain_v()];
    let is_inside = |foot: &SurfaceClosestPoint| {
        let is_between = |i: usize| {
            domains[i].start() < foot.parameters[i] && foot.parameters[i] < domains[i].end()
        };
        foot.distance <= MOST_BESIDE * tolerance && is_between(0) && is_between(1)
    };
    let beside = last.map(|start| surface.foot_from(start, point)).filter(is_inside);
    beside.unwrap_or_else(|| surface.closest(point))
}
