//! The area of a face and the flux through it by one integral, for those who ask for several of these.

use glam::DVec3;

use super::{
    Face,
    measure::{amid, arm, flux},
};
use crate::{
    GeomError,
    surface::{Density, IntegralValues, QuantityKinds},
    tolerance::LAST_BIT,
};

/// Area, the three coordinates of the normal, and flux: the normal has one size.
const KINDS: QuantityKinds<5> = QuantityKinds { numbers: [0, 1, 1, 1, 2], are_moments: true };

/// The area of a face, and what tells the flux of the way from any point through it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AreaAndFlux {
    area: f64,
    /// The integral of the normal, and how far each coordinate may be off.
    normal: [DVec3; 2],
    /// The flux of the way from a point, how far it may be off, and the point.
    flux: [f64; 2],
    about: DVec3,
}

impl AreaAndFlux {
    /// That of a face.
    ///
    /// # Errors
    /// Those of a search that was ended.
    pub(crate) fn of(face: &Face) -> Result<Self, GeomError> {
        if let Some((about, normal)) = face.plane_area() {
            let (normal, flux) = ([normal, DVec3::ZERO], [0.0; 2]);
            return Ok(Self { area: normal[0].length(), normal, flux, about });
        }
        let about = amid(std::slice::from_ref(face));
        let found = match face.round_area_and_flux(about)? {
            Some(found) => found,
            None => Self::by_areas(face, about)?,
        };
        let [area, x, y, z, flux] = found.values;
        let [_, off_x, off_y, off_z, off] = found.errors;
        let normal = [DVec3::new(x, y, z), DVec3::new(off_x, off_y, off_z)];
        Ok(Self { area, normal, flux: [flux, off], about })
    }

    /// Area, normal and flux of a face of any surface.
    fn by_areas(face: &Face, about: DVec3) -> Result<IntegralValues<5>, GeomError> {
        face.integral(KINDS, |point, normal| {
            let Density { values: [own], parts: [made_of] } = flux(arm(point, about), normal);
            let DVec3 { x, y, z } = normal;
            let values = [normal.length(), x, y, z, own];
            Density { values, parts: [0.0, 0.0, 0.0, 0.0, made_of] }
        })
    }

    /// The area.
    pub(crate) fn area(&self) -> f64 {
        self.area
    }

    /// The same of the face turned over.
    pub(crate) fn reversed(&self) -> Self {
        let ([normal, normal_off], [flux, off]) = (self.normal, self.flux);
        Self { normal: [-normal, normal_off], flux: [-flux, off], ..*self }
    }

    /// The flux of the way from a point.
    pub(crate) fn flux_from(&self, point: DVec3) -> IntegralValues<1> {
        let ([normal, normal_off], [flux, off]) = (self.normal, self.flux);
        let way = arm(self.about, point);
        let value = flux + way.dot(normal);
        IntegralValues {
            values: [value],
            errors: [off + way.abs().dot(normal_off) + LAST_BIT * way.abs().dot(normal.abs())],
            // It is larger where parts of it cancel.
            sizes: [value.abs()],
        }
    }
}

#[cfg(test)]
mod tests {
    use std::{f64::consts::PI, sync::Arc};

    use glam::DVec3;

    use super::AreaAndFlux;
    use crate::{Cutter, Face, Frame, NurbsSurface, Tolerance};

    #[test]
    fn a_cap_has_its_area_and_the_flux_from_any_point() {
        let ball = Arc::new(NurbsSurface::sphere(Frame::XY, 2.0).expect("a sphere"));
        let ball = Face::whole(ball, Tolerance::DEFAULT).expect("a face");
        let above = Cutter::Plane(Frame::XY.at(DVec3::Z));
        let cap = ball.part_at(&[above], DVec3::Z * 2.0, Tolerance::DEFAULT).expect("a cap");
        let known = AreaAndFlux::of(&cap).expect("an integral");
        assert!((known.area() - 4.0 * PI).abs() < 1e-12);
        // From the centre r times the area; from elsewhere less by what passes through the disc of its rim.
        for about in [DVec3::ZERO, DVec3::new(3.0, -1.0, 0.5), DVec3::new(0.0, 100.0, -70.0)] {
            let told = 8.0 * PI - 3.0 * PI * about.z;
            for (found, sign) in [(known, 1.0), (known.reversed(), -1.0)] {
                let found = found.flux_from(about);
                assert!((found.values[0] - sign * told).abs() < 1e-11, "{about}");
                // As a share of what the flux is made of.
                assert!(found.errors[0] < 1e-10 * 4.0 * PI * (2.0 + about.length()));
            }
            let direct = cap.flux_from(about).expect("an integral").values[0];
            assert!((direct - told).abs() < 1e-11);
        }
    }

    #[test]
    fn parts_of_round_surfaces_have_the_integrals_of_any_surface() {
        let frame = Frame::from_normal(DVec3::new(0.3, -0.2, 0.5), DVec3::new(1.0, 2.0, 3.0), None);
        let frame = frame.expect("a frame");
        let surfaces = [
            NurbsSurface::sphere(frame, 2.0),
            NurbsSurface::cone(frame, [1.0, 1.0], 3.0),
            NurbsSurface::cone(frame, [2.0, 0.5], 3.0),
            NurbsSurface::torus(frame, 3.0, 1.0),
        ];
        let plane =
            Frame::from_normal(frame.point(DVec3::Z * 0.7), DVec3::new(1.0, 0.5, 0.7), None);
        let cutter = Cutter::Plane(plane.expect("a plane"));
        let about = DVec3::new(1.0, -2.0, 0.5);
        for surface in surfaces {
            let whole = Face::whole(Arc::new(surface.expect("a surface")), Tolerance::DEFAULT);
            let parts = whole
                .and_then(|whole| whole.split(std::slice::from_ref(&cutter), Tolerance::DEFAULT));
            for part in parts.expect("parts") {
                let by_areas = AreaAndFlux::by_areas(&part, about).expect("an integral").values;
                let round =
                    part.round_area_and_flux(about).expect("an integral").expect("it is round");
                for (found, told) in round.values.into_iter().zip(by_areas) {
                    assert!((found - told).abs() < 1e-11 * by_areas[0], "{round:?} {by_areas:?}");
                }
            }
        }
    }

    #[test]
    fn a_plane_face_has_the_flux_of_its_height() {
        let plate = NurbsSurface::bilinear(
            DVec3::Z,
            DVec3::new(0.0, 3.0, 1.0),
            DVec3::new(2.0, 0.0, 1.0),
            DVec3::new(2.0, 3.0, 1.0),
        );
        let plate =
            Face::whole(Arc::new(plate.expect("a plate")), Tolerance::DEFAULT).expect("a face");
        let known = AreaAndFlux::of(&plate).expect("an integral");
        assert!((known.area() - 6.0).abs() < 1e-15);
        let along = known.flux_from(DVec3::ZERO).values[0];
        assert!((along.abs() - 6.0).abs() < 1e-14);
        assert!(known.flux_from(DVec3::new(5.0, -2.0, 1.0)).values[0].abs() < 1e-14);
    }
}
