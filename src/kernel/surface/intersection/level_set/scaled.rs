//! Lines on surfaces so large or small that products of their coordinates are no numbers.
//!
//! They are looked for on surfaces divided by a power of two near their size, which changes no digit,
//! and told multiplied by that power.

use glam::{DAffine3, DVec3};

use super::{
    error::PictureError,
    results::{CurveSurfaceIntersection, LevelSet},
};
use crate::{Curve, Frame, GeomError, MeshError, Surface, Tolerance, scale::needed_scale};

/// A power of two near the size of what is asked about.
#[derive(Clone, Copy, Debug)]
pub(super) struct CommonScale(f64);

impl CommonScale {
    /// That of something whose largest coordinate this is; none of sizes that need none.
    pub(super) fn needed(magnitude: f64) -> Option<Self> {
        needed_scale(magnitude).map(Self)
    }

    /// The surface divided by a power of two near its size, and that power.
    pub(super) fn of(surface: &Surface) -> Option<(Surface, Self)> {
        let (scaled, scale) = surface.scaled()?;
        Some((scaled, Self(scale)))
    }

    pub(super) fn tolerance(self, tolerance: Tolerance) -> Tolerance {
        tolerance.with_distance(tolerance.distance / self.0)
    }

    pub(super) fn place(self, place: DVec3) -> DVec3 {
        place / self.0
    }

    pub(super) fn plane(self, plane: Frame) -> Frame {
        plane.at(self.place(plane.origin()))
    }

    pub(super) fn surface(self, surface: &Surface) -> Result<Surface, GeomError> {
        surface.transformed(&by(self.0.recip()))
    }

    pub(super) fn curve(self, curve: &Curve) -> Curve {
        curve.transformed(&by(self.0.recip()))
    }

    /// Lines as they are on what was not divided.
    pub(super) fn lines(self, found: Result<LevelSet, GeomError>) -> Result<LevelSet, GeomError> {
        found.map(|found| self.multiplied(found)).map_err(|err| self.error(err))
    }

    /// The same of several sets of lines.
    pub(super) fn all_lines(
        self,
        found: Result<Vec<LevelSet>, GeomError>,
    ) -> Result<Vec<LevelSet>, GeomError> {
        let multiplied =
            |found: Vec<_>| found.into_iter().map(|set| self.multiplied(set)).collect();
        found.map(multiplied).map_err(|err| self.error(err))
    }

    fn multiplied(self, found: LevelSet) -> LevelSet {
        let places = |places: Vec<DVec3>| places.into_iter().map(|place| place * self.0).collect();
        let map = by(self.0);
        LevelSet {
            curves: found.curves.iter().map(|curve| curve.transformed(&map)).collect(),
            touches: places(found.touches),
            contacts: places(found.contacts),
            uncertain: places(found.uncertain),
        }
    }

    /// Places of a curve as they are on what was not divided.
    pub(super) fn piercings(
        self,
        found: Result<Vec<CurveSurfaceIntersection>, GeomError>,
    ) -> Result<Vec<CurveSurfaceIntersection>, GeomError> {
        let mut found = found.map_err(|err| self.error(err))?;
        found.iter_mut().for_each(|place| place.point *= self.0);
        Ok(found)
    }

    /// A refusal with the places of what was not divided.
    fn error(self, err: GeomError) -> GeomError {
        match err {
            GeomError::Picture(picture) => self.picture(picture).into(),
            GeomError::Mesh(MeshError::BelowRounding { tolerance, rounding }) => {
                let [tolerance, rounding] = [tolerance, rounding].map(|length| length * self.0);
                MeshError::BelowRounding { tolerance, rounding }.into()
            }
            other => other,
        }
    }

    fn picture(self, mut picture: PictureError) -> PictureError {
        match &mut picture {
            PictureError::SurfacesRunTogether { point }
            | PictureError::TooTangled { point }
            | PictureError::ToldTwice { point }
            | PictureError::EndsInside { point }
            | PictureError::EdgeLost { point }
            | PictureError::SmallLoop { point }
            | PictureError::Crossing { point, .. } => *point *= self.0,
            PictureError::OffSurface { point, distance } => {
                *point *= self.0;
                *distance *= self.0;
            }
            PictureError::Open { gap: length, .. } | PictureError::OffPlane { by: length, .. } => {
                *length *= self.0;
            }
            PictureError::Unresolved { .. }
            | PictureError::RunsAlong { .. }
            | PictureError::NoArea { .. }
            | PictureError::Outside { .. }
            | PictureError::HoleInHole { .. } => {}
        }
        picture
    }
}

/// The map that makes everything larger by a factor.
fn by(factor: f64) -> DAffine3 {
    DAffine3::from_scale(DVec3::splat(factor))
}
