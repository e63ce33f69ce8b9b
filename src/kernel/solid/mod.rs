//! Solids: faces that close, with an inside.
//!
//! This file has the type, its checking constructor and what can be read off it; `nesting` which shells lie in
//! which, `caps` plane rims that are closed by plane faces, `cut` what is on a side of a plane and in it,
//! `beside_rim` planes that nearly touch an edge, `sweep` regions
//! that are moved along a vector or about an axis, `mesh` triangles whose vertices neighbours share, `topology` edges
//! that they share, `crossing` whether they go through one another, `edge_angle` how faces meet along them, `place` where points are, `contents` what it is made of.

mod beside_rim;
mod caps;
mod contents;
mod crossing;
mod cut;
mod edge_angle;
mod edges;
mod error;
mod mesh;
mod nesting;
mod part;
mod piercing;
mod place;
mod sweep;
mod topology;

use glam::{DAffine3, DVec3};

use crate::{
    Bounds, Face, GeomError, MassProperties, Tolerance,
    surface::MassIntegral,
    trim::{AreaAndFlux, EnclosedShell, FaceBorderEdge, amid, enclosed_shells},
};

pub use contents::SolidContents;
pub use edge_angle::EdgeAngles;
pub use error::SolidError;
pub use nesting::SolidBody;
pub use piercing::CurveSolidIntersection;
pub use place::SolidClosestPoint;
pub use topology::{SolidEdge, SolidStep, SolidTopology};

/// What faces enclose that close: every place of every edge lies on one other edge.
///
/// Its faces look away from the inside. Each shell is a closed set of faces; one that lies in another is a void in
/// it, one that lies in a void is a body of its own. Shells do not meet.
///
/// ```
/// use std::{f64::consts::PI, sync::Arc};
/// use virote_kernel::{Face, Frame, NurbsSurface, Solid, Tolerance};
///
/// let ball = |radius: f64| Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, radius)?), Tolerance::DEFAULT);
/// let hollow = Solid::new(&[ball(2.0)?, ball(1.0)?], Tolerance::DEFAULT)?;
/// assert_eq!(hollow.shells().count(), 2);
/// assert!((hollow.volume_mass()?.amount - 4.0 / 3.0 * PI * 7.0).abs() < 1e-9);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    faces: Vec<Face>,
    /// The faces of each shell by their numbers.
    shells: Vec<Vec<usize>>,
    /// Whether it was not looked at whether it goes through itself.
    may_cross: bool,
}

impl Solid {
    /// What faces enclose, whichever way each of them looks.
    ///
    /// # Errors
    /// `FaceError::OpenShell`, `FaceError::CrowdedShell`, `FaceError::OneSided` of faces that do not close;
    /// [`SolidError::Thin`], [`SolidError::ShellsMeet`], [`SolidError::UnclearNesting`], [`SolidError::CrossesItself`],
    /// [`SolidError::Overlaid`], [`SolidError::Pinched`];
    /// `GeomError::Ended`.
    pub fn new(faces: &[Face], tolerance: Tolerance) -> Result<Self, GeomError> {
        check_pinches(faces, tolerance)?;
        let edges = FaceBorderEdge::all(faces, 0, tolerance)?;
        let known = areas_and_fluxes(faces)?;
        Self::with_edges(faces, &edges, known, tolerance)?.0.uncrossed(tolerance)
    }

    /// What faces with these edges and integrals enclose, which cross nowhere, and the integrals of its faces.
    ///
    /// # Errors
    /// Those of [`Self::new`] but for crossings.
    fn with_edges(
        faces: &[Face],
        edges: &[FaceBorderEdge],
        mut known: Vec<AreaAndFlux>,
        tolerance: Tolerance,
    ) -> Result<(Self, Vec<AreaAndFlux>), GeomError> {
        let shells = enclosed_shells(faces, edges, &known, tolerance)?;
        let mut turns = vec![false; faces.len()];
        for shell in &shells {
            let numbers = shell.faces.iter().map(|&(face, _)| face);
            let size = box_around(numbers.clone().map(|face| &faces[face])).diagonal();
            let distance = tolerance.distance_for(size);
            let area: f64 = numbers.map(|face| known[face].area()).sum();
            // A sheet with two sides is as thick as twice its volume is to its area.
            let thickness = 2.0 * shell.volume.abs() / area;
            if thickness.is_nan() || thickness <= distance {
                let point = faces[shell.faces[0].0].border_place();
                return Err(SolidError::Thin { point, thickness, tolerance: distance }.into());
            }
            for &(face, sign) in &shell.faces {
                turns[face] = (sign < 0.0) != (shell.volume < 0.0);
            }
        }
        let outward = |(face, &turns): (&Face, &bool)| {
            if turns { face.reversed() } else { face.clone() }
        };
        let faces: Vec<Face> = faces.iter().zip(&turns).map(outward).collect();
        let numbers = |shell: &EnclosedShell| {
            let mut numbers: Vec<usize> = shell.faces.iter().map(|&(face, _)| face).collect();
            numbers.sort_unstable();
            numbers
        };
        let mut solid =
            Self { faces, shells: shells.iter().map(numbers).collect(), may_cross: false };
        for shell in solid.voids(tolerance)? {
            for &face in &solid.shells[shell] {
                solid.faces[face] = solid.faces[face].reversed();
                turns[face] = !turns[face];
            }
        }
        for (known, _) in known.iter_mut().zip(turns).filter(|&(_, turns)| turns) {
            *known = known.reversed();
        }
        Ok((solid, known))
    }

    /// The faces, which look away from the inside.
    #[must_use]
    pub fn faces(&self) -> &[Face] {
        &self.faces
    }

    /// Whether it was not looked at whether it goes through itself, because its mesh is too large.
    #[must_use]
    pub fn may_cross(&self) -> bool {
        self.may_cross
    }

    /// The faces of each shell.
    pub fn shells(&self) -> impl Iterator<Item = Vec<&Face>> {
        self.shells.iter().map(|shell| shell.iter().map(|&face| &self.faces[face]).collect())
    }

    /// How much it encloses, and how that is spread.
    ///
    /// # Errors
    /// `MeasureError::NothingThere`, `MeasureError::TooLargeToMeasure`; `GeomError::Ended`.
    pub fn volume_mass(&self) -> Result<MassProperties, GeomError> {
        let about = amid(&self.faces);
        let mut sum = MassIntegral::default();
        for face in &self.faces {
            sum.add(face.flux_moments(about)?, 1.0);
        }
        sum.volume(about)
    }

    /// The area of its faces, and how that is spread.
    ///
    /// # Errors
    /// Those of [`Self::volume_mass`].
    pub fn area_mass(&self) -> Result<MassProperties, GeomError> {
        Face::mass_of(&self.faces)
    }

    /// The smallest box with sides along the axes of space.
    ///
    /// # Errors
    /// Those of [`Face::bounds`].
    pub fn bounds(&self, tolerance: Tolerance) -> Result<Bounds, GeomError> {
        let mut whole: Option<Bounds> = None;
        for face in &self.faces {
            let bounds = face.bounds(tolerance)?;
            whole = Some(whole.map_or(bounds, |whole| whole.union(bounds)));
        }
        let Some(whole) = whole else { unreachable!("a solid has faces") };
        Ok(whole)
    }

    /// The image under an affine map.
    ///
    /// # Errors
    /// `InputError::ZeroAxis` for a map that leaves no volume.
    pub fn transformed(&self, map: &DAffine3) -> Result<Self, GeomError> {
        // In a mirror the front of a face is where its back was.
        let is_mirror = map.matrix3.determinant() < 0.0;
        let image = |face: &Face| {
            let image = face.transformed(map)?;
            Ok(if is_mirror { image.reversed() } else { image })
        };
        let faces = self.faces.iter().map(image).collect::<Result<_, GeomError>>()?;
        Ok(Self { faces, shells: self.shells.clone(), may_cross: self.may_cross })
    }
}

/// The area and flux of each of some faces.
///
/// # Errors
/// Those of a search that was ended.
fn areas_and_fluxes(faces: &[Face]) -> Result<Vec<AreaAndFlux>, GeomError> {
    faces.iter().map(AreaAndFlux::of).collect()
}

/// Refuses faces that narrow to a point, in which what they enclose touches itself.
///
/// # Errors
/// [`SolidError::Pinched`].
fn check_pinches(faces: &[Face], tolerance: Tolerance) -> Result<(), GeomError> {
    let distance = tolerance.distance_for(box_around(faces).diagonal());
    for (face, own) in faces.iter().enumerate() {
        GeomError::go_on(1)?;
        if let Some(point) = own.pinch(distance) {
            return Err(SolidError::Pinched { face, point }.into());
        }
    }
    Ok(())
}

/// The box around the surfaces of faces.
fn box_around<'f>(faces: impl IntoIterator<Item = &'f Face>) -> Bounds {
    let boxes = faces.into_iter().map(|face| face.surface().bounds());
    boxes.reduce(Bounds::union).unwrap_or(Bounds { min: DVec3::ZERO, max: DVec3::ZERO })
}
