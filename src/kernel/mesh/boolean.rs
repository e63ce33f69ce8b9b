//! Union, intersection and difference of closed meshes.
//!
//! The work is that of a guest, the library of Manifold: new vertices are where edges pierce triangles,
//! and what coincides is decided alike everywhere, so that the result closes. Meshes whose triangles
//! cross by their rounding go the guest's other way, in exact rational numbers. Around it stand checks:
//! what comes in must enclose each place once or not at all, and what goes out must close, with the
//! volume that the other operation leaves, V(a ∪ b) + V(a ∩ b) = V(a) + V(b) and
//! V(a ∖ b) + V(a ∩ b) = V(a). Smith, *Towards robust inexact geometric computation* (2009).

use glam::{DAffine3, DVec3};

use super::{
    Mesh,
    fault::MeshError,
    manifold_body::{BooleanTolerance, Combination, ManifoldBody},
    topology::weld_distance,
    weld::welded,
};
use crate::{Bounds, GeomError, Tolerance, scale::needed_scale, tolerance::BOOLEAN_RELATIVE};

impl Mesh {
    /// What lies in any of several closed meshes; none of none.
    ///
    /// Triangles alone, without normals, parameters, colours, faces and groups. Vertices of all meshes
    /// within the tolerance are one; new ones are rounded. Where the result would close only within
    /// the tolerance, vertices that it made move by up to that. O(n log n) time and the triangles
    /// that cross.
    ///
    /// # Errors
    /// [`MeshError::OfSeveral`] with [`MeshError::Open`], [`MeshError::Unoriented`],
    /// [`MeshError::Pinched`], [`MeshError::Inverted`], [`MeshError::Doubled`] or
    /// [`MeshError::CrossesItself`]; [`MeshError::TouchesItself`], [`MeshError::Unproven`].
    pub fn union(meshes: &[&Self], tolerance: Tolerance) -> Result<Option<Self>, GeomError> {
        combined(meshes, Combination::Union, tolerance)
    }

    /// What lies in all of several closed meshes, as [`Mesh::union`]; none where there is nothing.
    ///
    /// # Errors
    /// As [`Mesh::union`].
    pub fn intersection(meshes: &[&Self], tolerance: Tolerance) -> Result<Option<Self>, GeomError> {
        combined(meshes, Combination::Intersection, tolerance)
    }

    /// What lies in the first of several closed meshes and in none of the others, as
    /// [`Mesh::union`]; none where there is nothing.
    ///
    /// # Errors
    /// As [`Mesh::union`].
    pub fn difference(meshes: &[&Self], tolerance: Tolerance) -> Result<Option<Self>, GeomError> {
        combined(meshes, Combination::Difference, tolerance)
    }
}

fn combined(
    meshes: &[&Mesh],
    combination: Combination,
    tolerance: Tolerance,
) -> Result<Option<Mesh>, GeomError> {
    let bounds = meshes.iter().filter_map(|mesh| mesh.bounds()).reduce(Bounds::union);
    let Some(bounds) = bounds else { return Ok(None) };
    if let Some(scale) = needed_scale(bounds.magnitude()) {
        let smaller = DAffine3::from_scale(DVec3::splat(scale.recip()));
        let plain: Vec<Mesh> = meshes.iter().map(|mesh| mesh.transformed(&smaller)).collect();
        let plain: Vec<&Mesh> = plain.iter().collect();
        let within = tolerance.with_distance(tolerance.distance / scale);
        let found = combined(&plain, combination, within).map_err(|error| larger(error, scale))?;
        return Ok(found.map(|mesh| mesh.transformed(&DAffine3::from_scale(DVec3::splat(scale)))));
    }

    // Make vertices within the tolerance one, of all meshes.
    let distance = weld_distance(Some(bounds), tolerance);
    let places: Vec<DVec3> = meshes.iter().flat_map(|mesh| mesh.vertices.iter().copied()).collect();
    let mut first = welded(&places, distance).into_iter().map(|first| places[first as usize]);
    let rounding = BOOLEAN_RELATIVE * bounds.magnitude();
    let mut bodies = Vec::with_capacity(meshes.len());
    let mut known: Vec<Mesh> = Vec::new();
    for (index, mesh) in meshes.iter().enumerate() {
        let vertices = first.by_ref().take(mesh.n_vertices()).collect();
        let mesh = Mesh { vertices, triangles: mesh.triangles.clone(), ..Mesh::default() };
        // The same mesh again adds nothing, and takes all away.
        if let Some(same) = known.iter().position(|known| *known == mesh) {
            if same == 0 && combination == Combination::Difference {
                return Ok(None);
            }
            continue;
        }
        let body =
            ManifoldBody::checked(&mesh, tolerance, distance).map_err(|error| match error {
                GeomError::Mesh(fault) if 1 < meshes.len() => {
                    MeshError::OfSeveral { index, fault: Box::new(fault) }.into()
                }
                error => error,
            })?;
        bodies.push(body);
        known.push(mesh);
    }

    // Combine them exactly; where that leaves slivers, once more with what is short in one place.
    let exact = BooleanTolerance { merged: 0.0, allowed: rounding };
    let merging = BooleanTolerance { merged: distance, allowed: distance.max(rounding) };
    match of_bodies(&bodies, combination, exact).and_then(|body| body.mesh(tolerance)) {
        Err(GeomError::Mesh(_)) => of_bodies(&bodies, combination, merging)?.mesh(tolerance),
        found => found,
    }
}

/// What was refused of meshes that were divided by a scale, about the meshes themselves.
fn larger(error: GeomError, scale: f64) -> GeomError {
    fn of_fault(fault: MeshError, scale: f64) -> MeshError {
        match fault {
            MeshError::Open { edges, loops, at } => {
                MeshError::Open { edges, loops, at: at * scale }
            }
            MeshError::Unoriented { at } => MeshError::Unoriented { at: at * scale },
            MeshError::Pinched { at } => MeshError::Pinched { at: at * scale },
            MeshError::Inverted { at } => MeshError::Inverted { at: at * scale },
            MeshError::Doubled { at } => MeshError::Doubled { at: at * scale },
            MeshError::CrossesItself { at } => MeshError::CrossesItself { at: at * scale },
            MeshError::TouchesItself { at } => MeshError::TouchesItself { at: at * scale },
            MeshError::OfSeveral { index, fault } => {
                MeshError::OfSeveral { index, fault: Box::new(of_fault(*fault, scale)) }
            }
            fault => fault,
        }
    }
    match error {
        GeomError::Mesh(fault) => of_fault(fault, scale).into(),
        error => error,
    }
}

/// What the bodies make together, two at a time: a union or intersection as a balanced tree, so that
/// few triangles are carried along.
fn of_bodies(
    bodies: &[ManifoldBody],
    combination: Combination,
    slack: BooleanTolerance,
) -> Result<ManifoldBody, GeomError> {
    let bodies: Vec<ManifoldBody> = bodies.iter().map(|body| body.merging(slack.merged)).collect();
    let [whole, others @ ..] = &bodies[..] else { unreachable!("a box around them was found") };
    match combination {
        Combination::Difference if others.is_empty() => Ok(whole.clone()),
        Combination::Difference => {
            let others = tree(others.to_vec(), Combination::Union, slack)?;
            whole.with(&others, combination, slack)
        }
        _ => tree(bodies, combination, slack),
    }
}

fn tree(
    mut bodies: Vec<ManifoldBody>,
    combination: Combination,
    slack: BooleanTolerance,
) -> Result<ManifoldBody, GeomError> {
    while 1 < bodies.len() {
        let pairs = bodies.chunks(2).map(|pair| match pair {
            [a, b] => a.with(b, combination, slack),
            _ => Ok(pair[0].clone()),
        });
        bodies = pairs.collect::<Result<_, _>>()?;
    }
    Ok(bodies.swap_remove(0))
}
