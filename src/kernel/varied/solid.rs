//! Solids that depend on variables: what they hold, and how that is spread.

use std::sync::Arc;

use glam::DVec3;

use super::{RegionWay, VariedRegion, VariedWall, body::MovedRegion};
use crate::{GeomError, LocalError, Solid};

/// A solid that varying regions make.
///
/// The volume of a cylinder of radius 1 grows by π with its height:
///
/// ```
/// use std::{f64::consts::TAU, sync::Arc};
/// use virote_kernel::{
///     CircleForm, Frame, NurbsCurve, PointSlopes, Region, RegionWay, Solid, Tolerance, VariedCurve,
///     VariedRegion, VariedSolid, glam::DVec3,
/// };
///
/// let circle = NurbsCurve::ellipse(Frame::XY, [1.0, 1.0], CircleForm::NinePoint)?;
/// let disc = Region::new(&circle, &[], Tolerance::DEFAULT)?;
/// let solid = Solid::extruded(&disc, DVec3::Z, Tolerance::DEFAULT)?;
/// let border = VariedCurve::new(circle.into(), PointSlopes::new(1, 9, Vec::new())?)?;
/// let region = VariedRegion::new(Arc::new(disc), vec![vec![border]])?;
/// let way = RegionWay::Along(DVec3::Z, vec![DVec3::Z]);
/// let varied = VariedSolid::new(solid.into(), region.into(), way);
/// assert!((varied.volume_slopes()?[0] - std::f64::consts::PI).abs() < 1e-13);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct VariedSolid(Form);

/// What a solid is made of.
#[derive(Clone, Debug)]
enum Form {
    /// What a region passes.
    Moved(MovedRegion),
    /// What lies between walls that vary.
    Walled { solid: Arc<Solid>, walls: Vec<VariedWall>, n_variables: usize },
}

impl VariedSolid {
    /// The solid that a region makes on its way.
    #[must_use]
    pub fn new(solid: Arc<Solid>, region: Arc<VariedRegion>, way: RegionWay) -> Self {
        Self(Form::Moved(MovedRegion::new(solid, region, way)))
    }

    /// The solid between walls, those that do not vary among them.
    #[must_use]
    pub fn between(solid: Arc<Solid>, walls: Vec<VariedWall>, n_variables: usize) -> Self {
        Self(Form::Walled { solid, walls, n_variables })
    }

    /// The solid itself.
    #[must_use]
    pub fn solid(&self) -> &Arc<Solid> {
        match &self.0 {
            Form::Moved(moved) => moved.solid(),
            Form::Walled { solid, .. } => solid,
        }
    }

    /// How many variables there are.
    #[must_use]
    pub fn n_variables(&self) -> usize {
        match &self.0 {
            Form::Moved(moved) => moved.n_variables(),
            Form::Walled { n_variables, .. } => *n_variables,
        }
    }

    /// The slopes of the volume: of what a region passes, the area as a vector times the way, and by Pappus and Guldin
    /// the angle times the moment about the axis.
    ///
    /// # Errors
    /// [`LocalError::NotDifferentiable`] where a region that is turned leaves the
    /// plane of the axis; where the work is ended.
    pub fn volume_slopes(&self) -> Result<Vec<f64>, GeomError> {
        match &self.0 {
            Form::Moved(moved) => moved.volume_slopes(),
            Form::Walled { walls, n_variables, .. } => {
                sum(walls, *n_variables, VariedWall::volume_slopes)
            }
        }
    }

    /// The slopes of the centre of gravity of the inside along a direction, from the volume.
    ///
    /// # Errors
    /// [`LocalError::NotDifferentiable`] of a full turn whose angle varies, and
    /// where a region that is turned leaves the plane of the axis; where the work is ended.
    pub fn centroid_slopes(&self, along: DVec3) -> Result<Vec<f64>, GeomError> {
        match &self.0 {
            Form::Moved(moved) => moved.centroid_slopes(along),
            Form::Walled { solid, walls, n_variables } => {
                let mass = solid.volume_mass()?;
                let of = |wall: &VariedWall| wall.moment_slopes(mass.centroid, along);
                let all = sum(walls, *n_variables, of)?;
                Ok(all.into_iter().map(|slope| slope / mass.amount).collect())
            }
        }
    }

    /// The slopes of the integral of (x − C)·D (x − C)·E over the inside, its centre of gravity C.
    ///
    /// # Errors
    /// [`LocalError::NotDifferentiable`] of a turn whose angle varies, and where a region that is turned leaves the plane
    /// of the axis; where the work is ended.
    pub fn second_moment_slopes(&self, along: [DVec3; 2]) -> Result<Vec<f64>, GeomError> {
        match &self.0 {
            Form::Moved(moved) => moved.second_moment_slopes(along),
            Form::Walled { solid, walls, n_variables } => {
                // As the centroid moves the second moments about it stay, since the first ones are zero.
                let center = solid.volume_mass()?.centroid;
                sum(walls, *n_variables, |wall| wall.second_moment_slopes(center, along))
            }
        }
    }

    /// The slopes of the area of its faces: of what a region passes, twice that of the region, and what its borders
    /// pass; by Pappus and Guldin, of what turns, the angle times the integral of the distance from the axis along
    /// them, and twice the region short of a full turn.
    ///
    /// # Errors
    /// [`LocalError::NotDifferentiable`] of a full turn whose angle varies, where a
    /// region that is turned leaves the plane of the axis, and where the ends of a wall are not two; where the work is
    /// ended.
    pub fn area_slopes(&self) -> Result<Vec<f64>, GeomError> {
        match &self.0 {
            Form::Moved(moved) => moved.area_slopes(),
            Form::Walled { solid, walls, n_variables } => {
                check_ends(solid, walls)?;
                sum(walls, *n_variables, VariedWall::area_slopes)
            }
        }
    }
}

/// Fails where the ends of walls are not all faces as they are, as where one lies within the other.
fn check_ends(solid: &Solid, walls: &[VariedWall]) -> Result<(), GeomError> {
    let least = walls.iter().map(VariedWall::least_end).fold(f64::INFINITY, f64::min);
    let mut told = 0.0;
    for wall in walls {
        told += wall.area()?;
    }
    let area = solid.area_mass()?.amount;
    match (told - area).abs() < 0.5 * least {
        true => Ok(()),
        false => Err(LocalError::NotDifferentiable {
            what: "the area of a solid whose ends overlap",
            at: area,
        }
        .into()),
    }
}

/// What walls have together.
fn sum(
    walls: &[VariedWall],
    n_variables: usize,
    of: impl Fn(&VariedWall) -> Result<Vec<f64>, GeomError>,
) -> Result<Vec<f64>, GeomError> {
    let mut all = vec![0.0; n_variables];
    for wall in walls {
        all.iter_mut().zip(of(wall)?).for_each(|(sum, slope)| *sum += slope);
    }
    Ok(all)
}
