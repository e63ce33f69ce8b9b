//! What varying regions pass where they are moved or turned.

use std::{f64::consts::TAU, sync::Arc};

use glam::DVec3;

use super::VariedRegion;
use crate::{Axis, GeomError, LocalError, Solid, tolerance::KNOT_RELATIVE};

/// There is no solid beside one whose region leaves the plane of the axis.
pub(super) const OUT_OF_PLANE: &str = "the turn of a region that leaves the plane of its axis";

/// What a varying region passes.
#[derive(Clone, Debug)]
pub(super) struct MovedRegion {
    solid: Arc<Solid>,
    pub(super) region: Arc<VariedRegion>,
    pub(super) way: RegionWay,
}

/// Where a region goes.
///
/// The volume of a turned disc of radius 1, whose centre is 3 from the axis, grows by 3π with the angle:
///
/// ```
/// use std::{f64::consts::PI, sync::Arc};
/// use virote_kernel::{
///     Axis, CircleForm, Frame, NurbsCurve, PointSlopes, Region, RegionWay, Solid, Tolerance, VariedCurve, VariedRegion,
///     VariedSolid, glam::DVec3,
/// };
///
/// let circle = NurbsCurve::ellipse(Frame::ZX.at(DVec3::X * 3.0), [1.0, 1.0], CircleForm::NinePoint)?;
/// let disc = Region::new(&circle, &[], Tolerance::DEFAULT)?;
/// let axis = Axis::new(DVec3::ZERO, DVec3::Z)?;
/// let solid = Solid::revolved(&disc, axis, 1.0, Tolerance::DEFAULT)?;
/// let border = VariedCurve::new(circle.into(), PointSlopes::new(1, 9, Vec::new())?)?;
/// let region = VariedRegion::new(Arc::new(disc), vec![vec![border]])?;
/// let way = RegionWay::About(axis, 1.0, vec![1.0]);
/// let varied = VariedSolid::new(solid.into(), region.into(), way);
/// assert!((varied.volume_slopes()?[0] - 3.0 * PI).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub enum RegionWay {
    /// Along a vector, with its slopes by each variable.
    Along(DVec3, Vec<DVec3>),
    /// About an axis in its plane by an angle, with its slopes by each variable.
    About(Axis, f64, Vec<f64>),
}

impl MovedRegion {
    /// The solid that a region makes on its way.
    pub(super) fn new(solid: Arc<Solid>, region: Arc<VariedRegion>, way: RegionWay) -> Self {
        Self { solid, region, way }
    }

    /// The solid itself.
    pub(super) fn solid(&self) -> &Arc<Solid> {
        &self.solid
    }

    /// How many variables there are.
    pub(super) fn n_variables(&self) -> usize {
        match &self.way {
            RegionWay::Along(_, slopes) => slopes.len(),
            RegionWay::About(_, _, slopes) => slopes.len(),
        }
    }

    /// The slopes of the volume: the area as a vector times the way, and by Pappus and Guldin the angle
    /// times the moment about the axis.
    ///
    /// # Errors
    /// [`LocalError::NotDifferentiable`] where a region that is turned leaves the plane of the axis; where the work is
    /// ended.
    pub(super) fn volume_slopes(&self) -> Result<Vec<f64>, GeomError> {
        let (region, normal) = (&self.region, self.region.normal());
        let area = region.region().area();
        match &self.way {
            RegionWay::Along(way, slopes) => {
                let sense = way.dot(normal).signum();
                let by_region = region.flux_slopes(*way * sense)?;
                Ok(sums(&by_region, slopes, |slope: &DVec3| area * sense * slope.dot(normal)))
            }
            RegionWay::About(_, angle, slopes) if is_full(*angle) && !is_fixed(slopes) => {
                Err(none("the volume of a full turn", *angle))
            }
            RegionWay::About(_, angle, _) if self.region.leaves_its_plane() => {
                Err(none(OUT_OF_PLANE, *angle))
            }
            RegionWay::About(axis, angle, slopes) => {
                let across = self.across(*axis);
                let distance = |point: DVec3| (point - axis.foot()).dot(across);
                let moment = area * distance(region.region().mass().centroid);
                let by_region = region.moment_slopes(|point| angle.abs() * distance(point))?;
                Ok(sums(&by_region, slopes, |slope| angle.signum() * slope * moment))
            }
        }
    }

    /// The slopes of the centre of gravity of the inside along a direction, from the volume.
    ///
    /// # Errors
    /// [`LocalError::NotDifferentiable`] of a full turn whose angle varies, and where a region that is turned leaves the
    /// plane of the axis; where the work is ended.
    pub(super) fn centroid_slopes(&self, along: DVec3) -> Result<Vec<f64>, GeomError> {
        match &self.way {
            RegionWay::Along(_, slopes) => {
                let by_region = self.region.centroid_slopes(along)?;
                Ok(sums(&by_region, slopes, |slope: &DVec3| 0.5 * slope.dot(along)))
            }
            RegionWay::About(_, angle, _) if self.region.leaves_its_plane() => {
                Err(none(OUT_OF_PLANE, *angle))
            }
            RegionWay::About(axis, angle, _) if is_full(*angle) => {
                let mass = self.solid.volume_mass()?;
                let (across, share) = (self.across(*axis), along.dot(axis.direction()));
                let weight = |point: DVec3| {
                    let height = (point - mass.centroid).dot(axis.direction());
                    angle.abs() * (point - axis.foot()).dot(across) * height * share / mass.amount
                };
                self.region.moment_slopes(weight)
            }
            RegionWay::About(axis, angle, slopes) => {
                self.turned_centroid_slopes(*axis, *angle, slopes, along)
            }
        }
    }

    /// The same short of a full turn: of x = ρ cos φ, y = ρ sin φ, z by cylindrical coordinates, quotients of the
    /// moments of the region ∫ρ², ∫ρz and ∫ρ with what the angle makes of them.
    fn turned_centroid_slopes(
        &self,
        axis: Axis,
        angle: f64,
        slopes: &[f64],
        along: DVec3,
    ) -> Result<Vec<f64>, GeomError> {
        let (mass, across) = (self.solid.volume_mass()?, self.across(axis));
        let (foot, up, turn) = (axis.foot(), axis.direction(), angle.abs());
        let (sin, cos) = (libm::sin(turn), libm::cos(turn));
        let (ahead, aside) = (across.dot(along), angle.signum() * up.cross(across).dot(along));
        let rise = up.dot(along);
        // What the squares of the distance count, and how that grows with the angle.
        let (share, growth) = (ahead * sin + aside * (1.0 - cos), ahead * cos + aside * sin);
        let arm = mass.centroid - foot;
        let (place, height) = (arm.dot(along), arm.dot(up));
        let weight = |point: DVec3| {
            let (distance, z) = ((point - foot).dot(across), (point - foot).dot(up));
            distance * (turn * (rise * z - place) + share * distance) / mass.amount
        };
        let by_region = self.region.moment_slopes(weight)?;
        // Of the centre's distance from the axis; and the moments to the volume, for each radian.
        let squares = (arm - up * height).length() / (2.0 * libm::sin(0.5 * turn));
        let by_angle = squares * growth + (rise * height - place) / turn;
        Ok(sums(&by_region, slopes, |slope| angle.signum() * slope * by_angle))
    }

    /// The slopes of the area of its faces: twice that of the region, and what its borders pass; by Pappus and Guldin,
    /// of what turns, the angle times the integral of the distance from the axis along them, and twice the region
    /// short of a full turn.
    ///
    /// # Errors
    /// [`LocalError::NotDifferentiable`] of a full turn whose angle varies, and where a region that is turned leaves the
    /// plane of the axis; where the work is ended.
    pub(super) fn area_slopes(&self) -> Result<Vec<f64>, GeomError> {
        match &self.way {
            RegionWay::Along(way, slopes) => {
                let ends = self.region.area_slopes()?;
                let sides = self.region.side_slopes(*way)?;
                let by_way = self.region.side_gradient(*way)?;
                let by_region: Vec<f64> =
                    ends.iter().zip(sides).map(|(ends, sides)| 2.0 * ends + sides).collect();
                Ok(sums(&by_region, slopes, |slope: &DVec3| slope.dot(by_way)))
            }
            RegionWay::About(_, angle, slopes) if is_full(*angle) && !is_fixed(slopes) => {
                Err(none("the area of a full turn", *angle))
            }
            RegionWay::About(_, angle, _) if self.region.leaves_its_plane() => {
                Err(none(OUT_OF_PLANE, *angle))
            }
            RegionWay::About(axis, angle, slopes) => {
                let across = self.across(*axis);
                let distance = |point: DVec3| (point - axis.foot()).dot(across);
                let of_sides = self.region.border_slopes("the area", |point| {
                    (angle.abs() * distance(point), angle.abs() * across)
                })?;
                let n_ends = if is_full(*angle) { 0.0 } else { 2.0 };
                let ends = self.region.area_slopes()?;
                let by_region: Vec<f64> =
                    ends.iter().zip(of_sides).map(|(ends, sides)| n_ends * ends + sides).collect();
                let passed = self.region.border_integral("the area", distance)?;
                Ok(sums(&by_region, slopes, |slope| angle.signum() * slope * passed))
            }
        }
    }

    /// The direction in the plane of the region from an axis to it.
    pub(super) fn across(&self, axis: Axis) -> DVec3 {
        let across = self.region.normal().cross(axis.direction()).normalize_or_zero();
        let side = (self.region.region().mass().centroid - axis.foot()).dot(across);
        if side < 0.0 { -across } else { across }
    }
}

/// Each sum of a slope by the region and what `part` makes of one of the way.
pub(super) fn sums<S>(by_region: &[f64], slopes: &[S], part: impl Fn(&S) -> f64) -> Vec<f64> {
    by_region.iter().zip(slopes).map(|(own, slope)| own + part(slope)).collect()
}

/// Whether an angle is a full turn, as [`Solid::revolved`] takes it.
fn is_full(angle: f64) -> bool {
    TAU * (1.0 - KNOT_RELATIVE) <= angle.abs()
}

pub(super) fn is_fixed(slopes: &[f64]) -> bool {
    slopes.iter().all(|slope| slope.abs() <= 0.0)
}

pub(super) fn none(what: &'static str, at: f64) -> GeomError {
    LocalError::NotDifferentiable { what, at }.into()
}
