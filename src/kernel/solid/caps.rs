//! Plane rims closed by plane faces.

use glam::DVec3;

use super::{Solid, SolidError, areas_and_fluxes, box_around, check_pinches};
use crate::{
    Bounds, Face, FaceError, FormError, Frame, GeomError, NurbsCurve, Region, Tolerance,
    curve::join_chain,
    mesh::welded,
    trim::{AreaAndFlux, FaceBorderEdge, rims},
};

impl Solid {
    /// What faces enclose together with plane faces within their rims, which must be plane.
    ///
    /// Rims in one plane are closed together: what an odd number of them goes around.
    ///
    /// ```
    /// use std::{f64::consts::PI, sync::Arc};
    /// use virote_kernel::{Face, Frame, NurbsSurface, Solid, Tolerance};
    ///
    /// let pipe = Arc::new(NurbsSurface::cone(Frame::XY, [2.0, 1.0], 3.0)?);
    /// let frustum = Solid::capped(&[Face::whole(pipe, Tolerance::DEFAULT)?], Tolerance::DEFAULT)?;
    /// assert_eq!(frustum.faces().len(), 3);
    /// assert!((frustum.volume_mass()?.amount - 7.0 * PI).abs() < 1e-9);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`SolidError::UnevenRim`], [`SolidError::OpenRim`]; those of [`Self::new`] and [`Region::even_odd`].
    pub fn capped(faces: &[Face], tolerance: Tolerance) -> Result<Self, GeomError> {
        check_pinches(faces, tolerance)?;
        Self::with_caps(faces, tolerance)?.uncrossed(tolerance)
    }

    /// The same of faces that cross nowhere.
    ///
    /// # Errors
    /// Those of [`Self::capped`] but for crossings.
    pub(super) fn with_caps(faces: &[Face], tolerance: Tolerance) -> Result<Self, GeomError> {
        let caps = plane_caps(faces, tolerance)?;
        Ok(Self::closed_by(faces, areas_and_fluxes(faces)?, caps, tolerance)?.0)
    }

    /// What faces with these integrals enclose together with their caps, and the integrals of its faces.
    ///
    /// # Errors
    /// Those of [`Self::capped`] but for rims and crossings.
    pub(super) fn closed_by(
        faces: &[Face],
        mut known: Vec<AreaAndFlux>,
        PlaneCaps { regions, mut edges, rims, .. }: PlaneCaps,
        tolerance: Tolerance,
    ) -> Result<(Self, Vec<AreaAndFlux>), GeomError> {
        let caps = regions.iter().map(|region| Face::of_region(region, tolerance));
        let caps: Vec<Face> = caps.collect::<Result<_, GeomError>>()?;
        edges.extend(FaceBorderEdge::all(&caps, faces.len(), tolerance)?);
        known.extend(areas_and_fluxes(&caps)?);
        match Self::with_edges(&[faces, &caps].concat(), &edges, known, tolerance) {
            // Beside a place where rims cross, a cap is on the wrong side of the walls of one of them.
            Err(GeomError::Face(FaceError::OneSided { faces })) => {
                match crossing(&rims, tolerance)? {
                    Some(point) => Err(SolidError::CrossesItself { point }.into()),
                    None => Err(FaceError::OneSided { faces }.into()),
                }
            }
            found => found,
        }
    }
}

/// Regions that close faces.
pub(super) struct PlaneCaps {
    pub(super) regions: Vec<Region>,
    /// The edges of the faces.
    pub(super) edges: Vec<FaceBorderEdge>,
    /// Whether rims meet one another, or themselves.
    pub(super) has_knots: bool,
    /// The rims of each plane.
    rims: Vec<Vec<NurbsCurve>>,
}

/// The regions within the rims of faces.
///
/// # Errors
/// Those of [`Solid::capped`] but for those of bodies.
pub(super) fn plane_caps(faces: &[Face], tolerance: Tolerance) -> Result<PlaneCaps, GeomError> {
    let mut edges = FaceBorderEdge::all(faces, 0, tolerance)?;
    let open = match rims(faces, &edges, tolerance) {
        // Part of an edge may have a neighbour, as where a plane goes on along it behind a concave corner.
        Err(GeomError::Face(FaceError::OpenShell { .. })) => {
            let distance = tolerance.distance_for(box_around(faces).diagonal());
            edges = FaceBorderEdge::parts_around_areas(faces, distance, tolerance)?;
            rims(faces, &edges, tolerance)?
        }
        found => found?,
    };
    let mut rims = FaceBorderEdge::curves_around_areas(&edges, &open, faces, tolerance)?;
    let size = rims.iter().map(NurbsCurve::bounds).reduce(Bounds::union);
    let distance = tolerance.distance_for(size.map_or(0.0, Bounds::diagonal));
    // Where surfaces only touch a plane, crumbs of edges are left, which are one place.
    rims.retain(|rim| distance < rim.bounds().diagonal());
    let has_knots = has_knots(&rims, 2.0 * distance);
    let rims = rims_by_plane(rims, distance)?;
    let mut regions = Vec::new();
    for rims in &rims {
        regions.extend(Region::even_odd(rims, tolerance, 1)?);
    }
    Ok(PlaneCaps { regions, edges, has_knots, rims })
}

/// Whether more than two ends of edges are one place, or an edge passes by an end of others.
fn has_knots(edges: &[NurbsCurve], distance: f64) -> bool {
    let ends: Vec<DVec3> = edges.iter().flat_map(|edge| [edge.start(), edge.end()]).collect();
    let mut n_ends = vec![0; ends.len()];
    welded(&ends, distance).into_iter().for_each(|first| n_ends[first as usize] += 1);
    n_ends.into_iter().any(|n| 2 < n) || edges.iter().any(|edge| passes_by(edge, &ends, distance))
}

/// Whether a place other than its own ends lies on an edge.
fn passes_by(edge: &NurbsCurve, places: &[DVec3], distance: f64) -> bool {
    let (bounds, own) = (edge.bounds(), [edge.start(), edge.end()]);
    let is_apart = |place: &&DVec3| own.iter().all(|end| distance < end.distance(**place));
    let mut near = places.iter().filter(|place| bounds.distance(**place) <= distance);
    near.any(|place| is_apart(&place) && edge.foot_within(*place, distance).is_some())
}

/// A place where a rim crosses another one of its plane, or itself.
///
/// # Errors
/// Those of [`NurbsCurve::intersections`].
fn crossing(rims: &[Vec<NurbsCurve>], tolerance: Tolerance) -> Result<Option<DVec3>, GeomError> {
    for rims in rims {
        for (i, rim) in rims.iter().enumerate() {
            let distance = tolerance.distance_for(rim.bounds().diagonal());
            for other in &rims[i + 1..] {
                if let Some(found) = rim.intersections(other, distance)?.first() {
                    return Ok(Some(found.point));
                }
            }
            if let Some(found) = rim.self_intersections(distance)?.first() {
                return Ok(Some(found.point));
            }
        }
    }
    Ok(None)
}

/// The closed rims that plane edges make, by their planes.
///
/// # Errors
/// Those of [`Solid::capped`] but for what faces enclose.
fn rims_by_plane(edges: Vec<NurbsCurve>, distance: f64) -> Result<Vec<Vec<NurbsCurve>>, GeomError> {
    let mut planes: Vec<(Frame, Vec<NurbsCurve>)> = Vec::new();
    for rim in closed_rims(edges, 2.0 * distance)? {
        let is_in = |plane: &Frame| {
            rim.points().into_iter().all(|p| (p - plane.origin()).dot(plane.z()).abs() <= distance)
        };
        match planes.iter_mut().find(|(plane, _)| is_in(plane)) {
            Some((_, others)) => others.push(rim),
            None => planes.push((plane_of(&rim, distance)?, vec![rim])),
        }
    }
    Ok(planes.into_iter().map(|(_, rims)| rims).collect())
}

/// # Errors
/// [`SolidError::UnevenRim`]; those of [`NurbsCurve::plane_across`].
fn plane_of(rim: &NurbsCurve, distance: f64) -> Result<Frame, GeomError> {
    rim.plane_across(DVec3::Z, distance).map_err(|error| match error {
        GeomError::Form(FormError::NotPlanar { by }) => {
            SolidError::UnevenRim { point: rim.start(), by }.into()
        }
        other => other,
    })
}

/// Edges as closed curves, one after another in whatever sense each runs.
///
/// # Errors
/// [`SolidError::OpenRim`]; those of [`crate::join`].
fn closed_rims(mut edges: Vec<NurbsCurve>, distance: f64) -> Result<Vec<NurbsCurve>, GeomError> {
    let mut rims = Vec::new();
    while let Some(first) = edges.pop() {
        let (start, mut end, mut chain) = (first.start(), first.end(), vec![first]);
        while distance < start.distance(end) {
            GeomError::go_on(edges.len() + 1)?;
            let gap = |edge: &NurbsCurve| edge.start().distance(end).min(edge.end().distance(end));
            let next = edges.iter().enumerate().map(|(i, edge)| (i, gap(edge)));
            let (next, gap) = next.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0, f64::INFINITY));
            if distance < gap {
                let gap = gap.min(start.distance(end));
                return Err(SolidError::OpenRim { point: end, gap }.into());
            }
            let edge = edges.swap_remove(next);
            let is_forward = edge.start().distance(end) <= distance;
            let edge = if is_forward { edge } else { edge.reversed() };
            end = edge.end();
            chain.push(edge);
        }
        rims.push(with_one_end(&join_chain(&chain, distance)?)?);
    }
    Ok(rims)
}

/// A curve whose ends are within the tolerance of one another, with its end where it starts.
///
/// # Errors
/// Those of [`NurbsCurve::new`].
fn with_one_end(rim: &NurbsCurve) -> Result<NurbsCurve, GeomError> {
    if rim.start().distance(rim.end()) <= 0.0 {
        return Ok(rim.clone());
    }
    let clamped = rim.clamped();
    let mut points = clamped.control_points().to_vec();
    if let Some(last) = points.last_mut() {
        *last = (rim.start() * last.w).extend(last.w);
    }
    NurbsCurve::new(clamped.knots().clone(), points)
}
