//! What faces enclose.
//!
//! Every place of every edge must lie on one other edge, of the same or of another face, within the tolerance;
//! edges need not match one to one. Faces that look alike have their edges run against one another there. Edges
//! without a neighbour are rims.

use std::collections::BTreeSet;

use glam::DVec3;

use super::{
    AreaAndFlux, Face, FaceError,
    border_edge::{FaceBorderEdge, FacePair, N_PLACES, NeighbourSearch},
    measure::{FLUX_BITS, amid, arm, flux},
};
use crate::{
    Bounds, GeomError, MassProperties, Tolerance,
    frame::norm,
    surface::{
        Density, IntegralValues, MOMENT_KINDS, MassIntegral, ONE_MOMENT, ONE_QUANTITY, moments,
    },
    tolerance::LAST_BIT,
};

/// Faces that hang together, and what they enclose: moments of the flux, itself the first.
pub(crate) struct EnclosedShell<const N: usize = 1> {
    /// Each face by its number, with the sign that makes them look alike.
    pub(crate) faces: Vec<(usize, f64)>,
    /// The volume; negative where they look inward with these signs.
    pub(crate) volume: f64,
    moments: MassIntegral<N>,
}

impl Face {
    /// What faces that close enclose, of density one; they need not look outward.
    ///
    /// Faces that look alike throughout count positive where they look outward and negative where they look
    /// inward, so that they are a hole in others; the whole is not negative. All others are taken to look outward.
    ///
    /// The half of a ball:
    ///
    /// ```
    /// use std::{f64::consts::PI, sync::Arc};
    /// use virote_kernel::{CircleForm, Cutter, Face, Frame, NurbsCurve, NurbsSurface, Region, Tolerance, glam::DVec3};
    ///
    /// let sphere = Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, 1.0)?), Tolerance::DEFAULT)?;
    /// let dome = sphere.part_at(&[Cutter::Plane(Frame::XY)], DVec3::Z, Tolerance::DEFAULT)?;
    /// let rim = NurbsCurve::ellipse(Frame::XY, [1.0; 2], CircleForm::NinePoint)?;
    /// let floor = Face::of_region(&Region::new(&rim, &[], Tolerance::DEFAULT)?, Tolerance::DEFAULT)?;
    /// let half = Face::enclosed_mass(&[dome, floor], Tolerance::DEFAULT)?;
    /// assert!((half.amount - 2.0 / 3.0 * PI).abs() < 1e-9);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`FaceError::OpenShell`], [`FaceError::CrowdedShell`], [`FaceError::OneSided`], [`FaceError::Narrow`] of faces
    /// that enclose nothing;
    /// `MeasureError::NothingThere`, `MeasureError::TooLargeToMeasure`; `GeomError::Ended`.
    pub fn enclosed_mass(
        faces: &[Self],
        tolerance: Tolerance,
    ) -> Result<MassProperties, GeomError> {
        let (about, edges) = (amid(faces), FaceBorderEdge::all(faces, 0, tolerance)?);
        let moments = |face: usize| faces[face].flux_moments(about);
        let shells = shells_with(faces, &edges, tolerance, moments, area_of(faces))?;
        summed(&shells).volume(about)
    }

    /// The volume of [`Self::enclosed_mass`], and by which fraction it may be wrong.
    ///
    /// # Errors
    /// Those of [`Self::enclosed_mass`].
    pub fn enclosed_volume(faces: &[Self], tolerance: Tolerance) -> Result<(f64, f64), GeomError> {
        let (about, edges) = (amid(faces), FaceBorderEdge::all(faces, 0, tolerance)?);
        let flux = |face: usize| faces[face].flux_from(about);
        let shells = shells_with(faces, &edges, tolerance, flux, area_of(faces))?;
        summed(&shells).amount_of_volume()
    }

    /// The moments of the flux of the way from a point through it.
    ///
    /// # Errors
    /// Those of a search that was ended.
    pub(crate) fn flux_moments(&self, about: DVec3) -> Result<IntegralValues<10>, GeomError> {
        self.integral(MOMENT_KINDS, |point, normal| {
            let arm = arm(point, about);
            let Density { values: [flux], parts: [made_of] } = flux(arm, normal);
            Density { values: moments(arm, flux), parts: moments(arm.abs(), made_of) }
        })
    }

    /// The flux of the way from a point through it.
    ///
    /// # Errors
    /// Those of a search that was ended.
    pub(crate) fn flux_from(&self, about: DVec3) -> Result<IntegralValues<1>, GeomError> {
        if let Some((point, normal)) = self.plane_area() {
            let arm = arm(point, about);
            let sizes = [arm.length() * normal.length()];
            let errors = [FLUX_BITS * LAST_BIT * sizes[0]];
            return Ok(IntegralValues { values: flux(arm, normal).values, errors, sizes });
        }
        self.integral(ONE_MOMENT, |point, normal| flux(arm(point, about), normal))
    }

    /// The solid angle under which its back is seen from a point that is not on it, less that of its front.
    ///
    /// # Errors
    /// Those of a search that was ended.
    pub(crate) fn solid_angle(&self, from: DVec3) -> Result<f64, GeomError> {
        let seen = self.integral(ONE_QUANTITY, |point, normal| {
            let arm = point - from;
            let distance = norm(arm);
            [arm.dot(normal) / (distance * distance * distance)]
        })?;
        Ok(seen.values[0])
    }
}

/// The shells that faces with these edges make, each with its area and flux: that of the way from a point.
///
/// # Errors
/// Those of [`Face::enclosed_mass`].
pub(crate) fn enclosed_shells(
    faces: &[Face],
    edges: &[FaceBorderEdge],
    known: &[AreaAndFlux],
    tolerance: Tolerance,
) -> Result<Vec<EnclosedShell>, GeomError> {
    let about = amid(faces);
    let flux = |face: usize| Ok(known[face].flux_from(about));
    shells_with(faces, edges, tolerance, flux, |face| Ok(known[face].area()))
}

fn area_of(faces: &[Face]) -> impl Fn(usize) -> Result<f64, GeomError> {
    |face| faces[face].area()
}

/// The shells that faces make, with the sums of what is integrated over each face, and the area of each where it is
/// asked for.
fn shells_with<const N: usize>(
    faces: &[Face],
    edges: &[FaceBorderEdge],
    tolerance: Tolerance,
    integral: impl Fn(usize) -> Result<IntegralValues<N>, GeomError>,
    area: impl Fn(usize) -> Result<f64, GeomError>,
) -> Result<Vec<EnclosedShell<N>>, GeomError> {
    let (mut found, distance) = (Vec::new(), distance_for(faces, tolerance));
    let pairs = pairs(edges, distance)?;
    check_widths(edges, &pairs, distance, area)?;
    for faces_of_shell in hanging_together(faces.len(), &pairs)? {
        let mut moments = MassIntegral::default();
        for &(face, sign) in &faces_of_shell {
            moments.add(integral(face)?, sign);
        }
        let volume = moments.flux() / 3.0;
        found.push(EnclosedShell { faces: faces_of_shell, volume, moments });
    }
    Ok(found)
}

/// The moments of shells together.
fn summed<const N: usize>(shells: &[EnclosedShell<N>]) -> MassIntegral<N> {
    let mut sum = MassIntegral::default();
    for shell in shells {
        sum.add_shell(&shell.moments, shell.faces.iter().all(|&(_, sign)| 0.0 < sign));
    }
    sum
}

/// The numbers of those edges of faces that have no neighbour along all of their length.
///
/// # Errors
/// [`FaceError::OpenShell`] of an edge that has one along a part, [`FaceError::CrowdedShell`].
pub(crate) fn rims(
    faces: &[Face],
    edges: &[FaceBorderEdge],
    tolerance: Tolerance,
) -> Result<Vec<usize>, GeomError> {
    let distance = distance_for(faces, tolerance);
    let search = NeighbourSearch::new(edges, distance);
    let mut rims = Vec::new();
    for i in 0..edges.len() {
        let (mut n_open, mut first) = (0, None);
        for point in search.neighbours(i)?.into_iter().filter_map(Result::err) {
            n_open += 1;
            first.get_or_insert(point);
        }
        match first {
            None => {}
            Some(_) if n_open == N_PLACES => rims.push(i),
            Some(point) => return Err(search.no_neighbour(i, point)),
        }
    }
    Ok(rims)
}

/// Within which distance edges of faces are one.
fn distance_for(faces: &[Face], tolerance: Tolerance) -> f64 {
    let boxes = faces.iter().map(|face| face.plane.surface.bounds());
    tolerance.distance_for(boxes.reduce(Bounds::union).map_or(0.0, Bounds::diagonal))
}

/// The faces on both sides of the places of all edges.
///
/// # Errors
/// [`FaceError::OpenShell`], [`FaceError::CrowdedShell`].
fn pairs(edges: &[FaceBorderEdge], distance: f64) -> Result<Vec<FacePair>, GeomError> {
    let search = NeighbourSearch::new(edges, distance);
    let mut pairs = Vec::with_capacity(N_PLACES * edges.len());
    for i in 0..edges.len() {
        for pair in search.neighbours(i)? {
            pairs.push(pair.map_err(|point| search.no_neighbour(i, point))?);
        }
    }
    Ok(pairs)
}

/// Refuses a face whose edges are neighbours of one another because it is so narrow.
///
/// # Errors
/// [`FaceError::Narrow`].
fn check_widths(
    edges: &[FaceBorderEdge],
    pairs: &[FacePair],
    distance: f64,
    area: impl Fn(usize) -> Result<f64, GeomError>,
) -> Result<(), GeomError> {
    let to_itself = pairs.iter().filter(|pair| pair.faces[0] == pair.faces[1]);
    let own: BTreeSet<usize> = to_itself.map(|pair| pair.faces[0]).collect();
    for face in own {
        let own_edges = || edges.iter().filter(|edge| edge.face == face);
        let along: f64 = own_edges().map(|edge| edge.curve.length(edge.curve.domain())).sum();
        let width = 2.0 * area(face)? / along;
        if width <= 2.0 * distance {
            let point = own_edges().next().map_or(DVec3::ZERO, |edge| edge.curve.start());
            return Err(FaceError::Narrow { face, width, tolerance: distance, point }.into());
        }
    }
    Ok(())
}

/// The faces that hang together by pairs, each with the sign that makes them look alike.
///
/// # Errors
/// [`FaceError::OneSided`].
pub(super) fn hanging_together(
    n_faces: usize,
    pairs: &[FacePair],
) -> Result<Vec<Vec<(usize, f64)>>, GeomError> {
    let mut beside: Vec<Vec<&FacePair>> = vec![Vec::new(); n_faces];
    for pair in pairs {
        beside[pair.faces[0]].push(pair);
    }
    let mut signs: Vec<Option<f64>> = vec![None; n_faces];
    let mut found = Vec::new();
    for first in 0..n_faces {
        if signs[first].is_some() {
            continue;
        }
        signs[first] = Some(1.0);
        let (mut shell, mut next) = (vec![(first, 1.0)], 0);
        while let Some(&(face, sign)) = shell.get(next) {
            next += 1;
            for pair in &beside[face] {
                let other = pair.faces[1];
                let wanted = if pair.must_turn { -sign } else { sign };
                match signs[other] {
                    None => {
                        signs[other] = Some(wanted);
                        shell.push((other, wanted));
                    }
                    Some(known) if (known < 0.0) != (wanted < 0.0) => {
                        return Err(FaceError::OneSided { faces: pair.faces }.into());
                    }
                    Some(_) => {}
                }
            }
        }
        found.push(shell);
    }
    Ok(found)
}
