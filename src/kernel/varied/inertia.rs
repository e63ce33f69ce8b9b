//! The inertia of what varying regions pass.
//!
//! About the centre of gravity C the first moments are zero, so that the second ones grow as if C stood.

use glam::{DMat3, DVec3};

use super::{
    RegionWay,
    body::{MovedRegion, OUT_OF_PLANE, is_fixed, none, sums},
};
use crate::{Axis, GeomError};

impl MovedRegion {
    /// The slopes of the integral of (x − C)·D (x − C)·E over the inside, its centre of gravity C.
    ///
    /// # Errors
    /// [`LocalError::NotDifferentiable`](crate::LocalError::NotDifferentiable) of a turn whose angle varies, and where a
    /// region that is turned leaves the plane of the axis; where the work is ended.
    pub(super) fn second_moment_slopes(&self, along: [DVec3; 2]) -> Result<Vec<f64>, GeomError> {
        match &self.way {
            RegionWay::Along(way, slopes) => self.moved_moment_slopes(*way, slopes, along),
            RegionWay::About(_, angle, slopes) if !is_fixed(slopes) => {
                Err(none("the inertia of a turn by an angle that varies", *angle))
            }
            RegionWay::About(_, angle, _) if self.region.leaves_its_plane() => {
                Err(none(OUT_OF_PLANE, *angle))
            }
            RegionWay::About(axis, angle, _) => self.turned_moment_slopes(*axis, *angle, along),
        }
    }

    /// Along a way w, of a region of area A with the second moment R about its own centre and the normal n:
    /// |w·n| (R + A w·D w·E/12), where |w·n| A is the volume.
    fn moved_moment_slopes(
        &self,
        way: DVec3,
        slopes: &[DVec3],
        [d, e]: [DVec3; 2],
    ) -> Result<Vec<f64>, GeomError> {
        let (mass, height) = (self.region.region().mass(), way.dot(self.region.normal()).abs());
        let (area, spread) = (mass.amount, way.dot(d) * way.dot(e) / 12.0);
        let trace = mass.inertia.x_axis.x + mass.inertia.y_axis.y + mass.inertia.z_axis.z;
        let products = DMat3::from_diagonal(DVec3::splat(0.5 * trace)) - mass.inertia;
        let of_height = d.dot(products * e) + spread * area;
        let (by_volume, by_area) = (self.volume_slopes()?, self.region.area_slopes()?);
        let by_region = self.region.second_moment_slopes([d, e])?;
        let own = by_volume.iter().zip(&by_area).zip(by_region);
        let held: Vec<f64> = own
            .map(|((volume, by_area), second)| {
                let by_height = (volume - height * by_area) / area;
                by_height * of_height + height * (second + spread * by_area)
            })
            .collect();
        Ok(sums(&held, slopes, |slope: &DVec3| {
            height * area * (slope.dot(d) * way.dot(e) + way.dot(d) * slope.dot(e)) / 12.0
        }))
    }

    /// About an axis, by x = foot + z k + ρ (a cos φ + b sin φ): the integrals over φ are those of the circle's
    /// functions, which leaves a density on the region.
    fn turned_moment_slopes(
        &self,
        axis: Axis,
        angle: f64,
        [d, e]: [DVec3; 2],
    ) -> Result<Vec<f64>, GeomError> {
        let center = self.solid().volume_mass()?.centroid;
        let (turn, across, up) = (angle.abs(), self.across(axis), axis.direction());
        let aside = angle.signum() * up.cross(across);
        let (sin, cos) = (libm::sin(turn), libm::cos(turn));
        let (squares, crossed) = ([turn + sin * cos, turn - sin * cos], sin * sin);
        let density = |point: DVec3| {
            let arm = point - axis.foot();
            let (distance, foot) = (arm.dot(across), axis.foot() + up * arm.dot(up) - center);
            let [on, ahead, beside] =
                [foot, across * distance, aside * distance].map(|part| [part.dot(d), part.dot(e)]);
            let mixed = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] + a[1] * b[0];
            let even = mixed(on, on) * turn
                + mixed(ahead, ahead) * 0.5 * squares[0]
                + mixed(beside, beside) * 0.5 * squares[1];
            let odd = mixed(on, ahead) * sin
                + mixed(on, beside) * (1.0 - cos)
                + mixed(ahead, beside) * 0.5 * crossed;
            distance * (0.5 * even + odd)
        };
        self.region.moment_slopes(density)
    }
}
