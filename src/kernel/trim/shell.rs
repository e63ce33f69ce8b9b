//! What faces enclose.
//!
//! Every place of every edge must lie on one other edge, of the same or of another face, within the tolerance;
//! edges need not match one to one. Faces that look alike have their edges run against one another there.

use glam::DVec3;

use super::{
    Face, FaceError,
    measure::{arm, flux},
};
use crate::{
    Bounds, GeomError, MassProperties, NurbsCurve, Tolerance,
    surface::{MassIntegral, moments},
};

/// Places of each edge where its neighbour is looked for.
const PLACES: usize = 24;

/// An edge of one of several faces.
struct FaceBorderEdge {
    face: usize,
    curve: NurbsCurve,
    bounds: Bounds,
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
    /// [`FaceError::OpenShell`], [`FaceError::CrowdedShell`], [`FaceError::OneSided`] of faces that enclose nothing;
    /// `MeasureError::NothingThere`, `MeasureError::TooLargeToMeasure`; `GeomError::Ended`.
    pub fn enclosed_mass(
        faces: &[Self],
        tolerance: Tolerance,
    ) -> Result<MassProperties, GeomError> {
        let boxes = faces.iter().map(|face| face.plane.surface.bounds());
        let whole = boxes.reduce(Bounds::union);
        let about = whole.map_or(DVec3::ZERO, Bounds::center);
        let distance = tolerance.distance_for(whole.map_or(0.0, Bounds::diagonal));
        let mut sum = MassIntegral::default();
        for shell in shells(faces, tolerance, distance)? {
            let mut own = MassIntegral::default();
            for &(face, sign) in &shell {
                let part = faces[face].integral(|point, normal| {
                    let arm = arm(point, about);
                    moments(arm, flux(arm, normal))
                })?;
                own.add(part, sign);
            }
            sum.add_shell(&own, shell.iter().all(|&(_, sign)| 0.0 < sign));
        }
        sum.volume(about)
    }
}

/// The faces that hang together, each with the sign that makes them look alike.
fn shells(
    faces: &[Face],
    tolerance: Tolerance,
    distance: f64,
) -> Result<Vec<Vec<(usize, f64)>>, GeomError> {
    let mut edges = Vec::new();
    for (face, own) in faces.iter().enumerate() {
        for curve in own.edges(tolerance)? {
            let bounds = curve.bounds();
            edges.push(FaceBorderEdge { face, curve, bounds });
        }
    }
    // Neighbours, and whether one of both must turn.
    let mut neighbours: Vec<(usize, usize, bool)> = Vec::new();
    for (i, edge) in edges.iter().enumerate() {
        let domain = edge.curve.domain();
        for k in 0..PLACES {
            GeomError::go_on(1)?;
            let t = domain.at((k as f64 + 0.5) / PLACES as f64);
            let derivatives = edge.curve.derivatives_at(t, 1);
            let (point, along) = (derivatives[0], derivatives[1]);
            neighbours.push(neighbour(&edges, i, (point, along), distance)?);
        }
    }
    let mut signs: Vec<Option<f64>> = vec![None; faces.len()];
    let mut found = Vec::new();
    for first in 0..faces.len() {
        if signs[first].is_some() {
            continue;
        }
        signs[first] = Some(1.0);
        let (mut shell, mut next) = (vec![(first, 1.0)], 0);
        while let Some(&(face, sign)) = shell.get(next) {
            next += 1;
            for &(one, other, must_turn) in neighbours.iter().filter(|pair| pair.0 == face) {
                let wanted = if must_turn { -sign } else { sign };
                match signs[other] {
                    None => {
                        signs[other] = Some(wanted);
                        shell.push((other, wanted));
                    }
                    Some(known) if (known < 0.0) != (wanted < 0.0) => {
                        return Err(FaceError::OneSided { faces: [one, other] }.into());
                    }
                    Some(_) => {}
                }
            }
        }
        found.push(shell);
    }
    Ok(found)
}

/// The face on the other side of a place of an edge, with that of the edge before it, and whether one of both must
/// turn to look as the other does.
fn neighbour(
    edges: &[FaceBorderEdge],
    own: usize,
    (point, along): (DVec3, DVec3),
    distance: f64,
) -> Result<(usize, usize, bool), GeomError> {
    let reach = 2.0 * distance;
    let (mut there, mut nearest) = (Vec::new(), f64::INFINITY);
    for (i, other) in edges.iter().enumerate().filter(|&(i, _)| i != own) {
        let apart = (other.bounds.min - point).max(point - other.bounds.max).max_element();
        if nearest.max(reach) < apart {
            continue;
        }
        let foot = other.curve.closest(point, distance);
        nearest = nearest.min(foot.distance);
        if foot.distance <= reach {
            there.push((i, other.curve.derivatives_at(foot.parameter, 1)[1]));
        }
    }
    match there[..] {
        [(other, way)] => Ok((edges[own].face, edges[other].face, 0.0 < along.dot(way))),
        [] => {
            let face = edges[own].face;
            Err(FaceError::OpenShell { face, n_faces: 1 + last_face(edges), gap: nearest, point }
                .into())
        }
        _ => {
            let faces = there.iter().map(|&(i, _)| edges[i].face).collect();
            Err(FaceError::CrowdedShell { face: edges[own].face, others: faces, point }.into())
        }
    }
}

fn last_face(edges: &[FaceBorderEdge]) -> usize {
    edges.iter().map(|edge| edge.face).max().unwrap_or(0)
}
