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

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::DVec4;

    use super::*;
    use crate::{
        NurbsCurve, PointSlopes, Region, Solid, Tolerance, VariedCurve, VariedRegion, VariedSolid,
    };

    /// The rectangle `from`..`to` along one direction and 0..2 along another one, whose side at `to` moves with the variable, and
    /// what it passes.
    fn passed(
        [across, up]: [DVec3; 2],
        [from, to]: [f64; 2],
        way: RegionWay,
        solid: impl Fn(&Region) -> Result<Solid, GeomError>,
    ) -> VariedSolid {
        let corners = [[from, 0.0], [to, 0.0], [to, 2.0], [from, 2.0], [from, 0.0]];
        let corners = corners.map(|[x, y]| across * x + up * y);
        let border = NurbsCurve::polyline(&corners).expect("a rectangle");
        let region = Region::new(&border, &[], Tolerance::DEFAULT).expect("a region");
        let aside = across.extend(0.0);
        let slopes = vec![(0, vec![DVec4::ZERO, aside, aside, DVec4::ZERO, DVec4::ZERO])];
        let slopes = PointSlopes::new(1, 5, slopes).expect("slopes");
        let border = VariedCurve::new(Arc::new(border), slopes).expect("slopes");
        let solid = solid(&region).expect("a solid");
        let region = VariedRegion::new(Arc::new(region), vec![vec![border]]).expect("slopes");
        VariedSolid::new(Arc::new(solid), Arc::new(region), way)
    }

    #[track_caller]
    fn check(found: Result<Vec<f64>, GeomError>, expected: f64) {
        let found = found.expect("slopes");
        assert_eq!(found.len(), 1);
        assert!(
            (found[0] - expected).abs() < 1e-7 * expected.abs().max(1.0),
            "{found:?}, not {expected}"
        );
    }

    /// Of a block of the sides a, b and c: a³bc/12, and so on; moved aslant also what its slant adds.
    #[test]
    fn a_block_grows_as_its_side_and_its_height_do() {
        let (a, b, c) = (3.0, 2.0, 5.0);
        let way = |speed: f64, aslant: f64| {
            let way = DVec3::new(aslant, 0.0, c);
            let solid = move |region: &Region| Solid::extruded(region, way, Tolerance::DEFAULT);
            passed(
                [DVec3::X, DVec3::Y],
                [0.0, a],
                RegionWay::Along(way, vec![DVec3::Z * speed]),
                solid,
            )
        };
        for speed in [0.0, 2.0] {
            let block = way(speed, 0.0);
            let of = |d: DVec3, e: DVec3| block.second_moment_slopes([d, e]);
            check(block.volume_slopes(), b * c + speed * a * b);
            check(of(DVec3::X, DVec3::X), a * a * b * c / 4.0 + speed * a * a * a * b / 12.0);
            check(of(DVec3::Y, DVec3::Y), b * b * b * (c + speed * a) / 12.0);
            check(of(DVec3::Z, DVec3::Z), b * c * c * c / 12.0 + speed * a * b * c * c / 4.0);
            check(of(DVec3::X, DVec3::Y), 0.0);
        }
        // x goes as a s/c, so that the products are those along z times the slant, and a³bc/12 stays.
        let (slant, s) = (way(0.0, 1.5), 1.5);
        check(
            slant.second_moment_slopes([DVec3::X, DVec3::X]),
            b * c * (a * a / 4.0 + s * s / 12.0),
        );
        check(slant.second_moment_slopes([DVec3::X, DVec3::Z]), b * c * s * c / 12.0);
    }

    /// A sector of a ring about z, its outer radius moving: its moments are integrals of powers of the radius times
    /// those of the circle's functions.
    #[test]
    fn a_sector_grows_with_its_outer_radius() {
        let (inner, outer, height) = (1.0, 2.5, 2.0);
        let axis = Axis::new(DVec3::new(0.0, 0.0, -4.0), DVec3::Z).expect("an axis");
        for angle in [1.2_f64, -2.0] {
            let solid =
                move |region: &Region| Solid::revolved(region, axis, angle, Tolerance::DEFAULT);
            let way = RegionWay::About(axis, angle, vec![0.0]);
            let sector = passed([DVec3::X, DVec3::Z], [inner, outer], way, solid);
            let (turn, side) = (angle.abs(), angle.signum());
            let (sin, cos) = (libm::sin(turn), libm::cos(turn));
            let moments = |outer: f64| {
                let power = |k: f64| height * (libm::pow(outer, k) - libm::pow(inner, k)) / k;
                let volume = turn * power(2.0);
                let [x, y] = [sin * power(3.0), side * (1.0 - cos) * power(3.0)];
                let xx = 0.5 * (turn + sin * cos) * power(4.0);
                let yy = 0.5 * (turn - sin * cos) * power(4.0);
                let xy = 0.5 * side * sin * sin * power(4.0);
                let zz = volume * height * height / 12.0;
                [xx - x * x / volume, yy - y * y / volume, xy - x * y / volume, zz]
            };
            let h = 1e-4;
            let (before, behind) = (moments(outer - h), moments(outer + h));
            let pairs = [[DVec3::X; 2], [DVec3::Y; 2], [DVec3::X, DVec3::Y], [DVec3::Z; 2]];
            for (k, along) in pairs.into_iter().enumerate() {
                check(sector.second_moment_slopes(along), (behind[k] - before[k]) / (2.0 * h));
            }
        }
    }
}
