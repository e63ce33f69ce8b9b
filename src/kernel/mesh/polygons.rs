//! Meshes of polygons, and how these are split into triangles.
//!
//! A quadrilateral is cut by the diagonal that leaves the larger least triangle, as it is seen along
//! its normal (Newell); a convex polygon from its first corner; any other by a constrained Delaunay
//! triangulation in the plane of its normal. Polygons need not be plane.

use glam::{DVec2, DVec3};

use super::{
    Mesh, MeshError,
    fault::FaceFault,
    planar::turn,
    triangulation::{BorderPolygon, triangles},
};
use crate::{Bounds, CountError, Frame, GeomError, frame::unit, tolerance::VANISHING_RELATIVE};

/// The mesh of these vertices whose faces are polygons over them, given by the indices of their corners,
/// counter-clockwise seen from outside.
///
/// # Errors
/// `InputError::NotFinite`, [`CountError::TooManyVertices`], [`MeshError::BadFace`], `GeomError::Ended`.
pub fn polygon_mesh(
    vertices: Vec<DVec3>,
    faces: &[Vec<usize>],
    max_vertices: usize,
) -> Result<Mesh, GeomError> {
    let (got, most) = (vertices.len(), max_vertices.min(u32::MAX as usize));
    if most < got {
        return Err(CountError::TooManyVertices { got, most }.into());
    }
    let (mut all, mut sizes) = (Vec::new(), Vec::with_capacity(faces.len()));
    for (face, corners) in faces.iter().enumerate() {
        GeomError::go_on(1 + corners.len())?;
        let blamed = |(corner, fault)| MeshError::BadFace { face, corner, fault };
        let corners = checked(corners, vertices.len()).map_err(blamed)?;
        let split = split_polygon(&vertices, &corners).map_err(|fault| blamed((None, fault)))?;
        sizes.push(split.len() as u32);
        all.extend(split);
    }
    Ok(Mesh::new(vertices, Vec::new(), Vec::new(), all)?.of_runs(sizes))
}

/// Triangles that are the polygon with three corners or more at these vertices, none twice.
///
/// # Errors
/// [`FaceFault::NoVertex`], [`FaceFault::Crosses`].
pub fn split_polygon(vertices: &[DVec3], corners: &[u32]) -> Result<Vec<[u32; 3]>, FaceFault> {
    let place = |&corner: &u32| {
        let vertex = corner as usize;
        let missing = FaceFault::NoVertex { vertex, vertices: vertices.len() };
        vertices.get(vertex).copied().ok_or(missing)
    };
    let places: Vec<DVec3> = corners.iter().map(place).collect::<Result<_, _>>()?;
    let mut triangles = split(&places)?;
    // The first corner of the first triangle is where the corners of a face are told from.
    if let Some(first) = triangles.iter().position(|triangle| triangle.contains(&0)) {
        triangles.swap(0, first);
        while triangles[0][0] != 0 {
            triangles[0].rotate_left(1);
        }
    }
    Ok(triangles.into_iter().map(|triangle| triangle.map(|k| corners[k])).collect())
}

/// The corners of a face, if they are vertices, three or more, none twice.
fn checked(corners: &[usize], vertices: usize) -> Result<Vec<u32>, (Option<usize>, FaceFault)> {
    if corners.len() < 3 {
        return Err((None, FaceFault::TooFew { got: corners.len() }));
    }
    if let Some(corner) = corners.iter().position(|&vertex| vertices <= vertex) {
        return Err((Some(corner), FaceFault::NoVertex { vertex: corners[corner], vertices }));
    }
    let mut by_vertex: Vec<(usize, usize)> =
        corners.iter().enumerate().map(|(corner, &vertex)| (vertex, corner)).collect();
    by_vertex.sort_unstable();
    let twice = by_vertex.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| pair[1]);
    if let Some((vertex, corner)) = twice.min_by_key(|&(_, corner)| corner) {
        return Err((Some(corner), FaceFault::Repeats { vertex }));
    }
    Ok(corners.iter().map(|&vertex| vertex as u32).collect())
}

/// Triangles of a polygon by the indices of its corners, two fewer than these.
fn split(places: &[DVec3]) -> Result<Vec<[usize; 3]>, FaceFault> {
    let n = places.len();
    if n == 3 {
        return Ok(vec![[0, 1, 2]]);
    }
    let places = of_size_one(places);
    let Some(frame) = frame(&places) else { return flat(&places) };
    let seen: Vec<DVec2> =
        places.iter().map(|place| DVec2::new(place.dot(frame.x()), place.dot(frame.y()))).collect();
    match n {
        4 => quadrilateral(&seen),
        _ if is_convex(&seen) => Ok(fan(n)),
        _ => delaunay(&seen),
    }
}

/// The same polygon about its first corner, of size one, so that no product overflows.
fn of_size_one(places: &[DVec3]) -> Vec<DVec3> {
    let magnitude = Bounds::of(places.iter().copied()).map_or(0.0, Bounds::magnitude);
    let scaled = |size: f64| if 0.0 < size { size } else { 1.0 };
    let about = places[0] / scaled(magnitude);
    let offsets = places.iter().map(|&place| place / scaled(magnitude) - about);
    let offsets: Vec<DVec3> = offsets.collect();
    let extent = offsets.iter().map(|place| place.abs().max_element()).fold(0.0, f64::max);
    offsets.into_iter().map(|place| place / scaled(extent)).collect()
}

/// A frame whose z is along the normal of a polygon; none where that has no area.
fn frame(places: &[DVec3]) -> Option<Frame> {
    let about = places[0];
    let pairs = places.windows(2).map(|pair| (pair[0] - about).cross(pair[1] - about));
    let area: DVec3 = pairs.sum();
    let normal = unit(area).filter(|_| VANISHING_RELATIVE < area.length())?;
    Frame::from_normal(DVec3::ZERO, normal, None).ok()
}

/// Triangles without area, where all corners are on a line; what crosses itself has no area either.
fn flat(places: &[DVec3]) -> Result<Vec<[usize; 3]>, FaceFault> {
    let far = places.iter().copied().max_by(|a, b| a.length().total_cmp(&b.length()));
    let along = far.and_then(unit).unwrap_or(DVec3::X);
    let is_on_line = |place: &DVec3| place.cross(along).length() <= VANISHING_RELATIVE;
    if places.iter().all(is_on_line) { Ok(fan(places.len())) } else { Err(FaceFault::Crosses) }
}

/// Triangles from the first corner to all sides.
fn fan(n: usize) -> Vec<[usize; 3]> {
    (1..n - 1).map(|k| [0, k, k + 1]).collect()
}

fn is_convex(seen: &[DVec2]) -> bool {
    let n = seen.len();
    let at = |k: usize| seen[k % n];
    // That no side crosses another: around all corners the direction turns once.
    let angle = |k: usize| (at(k + 1) - at(k)).angle_to(at(k + 2) - at(k + 1));
    let is_sharp = |k: usize| VANISHING_RELATIVE < turn(at(k), at(k + 1), at(k + 2));
    (0..n).all(is_sharp) && (0..n).map(angle).sum::<f64>() < 3.0 * std::f64::consts::PI
}

/// The better of two diagonals; the one from the first corner where they are alike.
fn quadrilateral(seen: &[DVec2]) -> Result<Vec<[usize; 3]>, FaceFault> {
    let least = |triangles: [[usize; 3]; 2]| {
        let areas = triangles.map(|[a, b, c]| turn(seen[a], seen[b], seen[c]));
        areas[0].min(areas[1])
    };
    let choices = [[[0, 1, 2], [0, 2, 3]], [[1, 2, 3], [1, 3, 0]]];
    let [first, second] = choices.map(least);
    if first.max(second) < -VANISHING_RELATIVE {
        return Err(FaceFault::Crosses);
    }
    Ok(choices[usize::from(first + VANISHING_RELATIVE < second)].to_vec())
}

/// A triangulation of the corners at places of their own; one at the place of the one before it has
/// triangles without area.
fn delaunay(seen: &[DVec2]) -> Result<Vec<[usize; 3]>, FaceFault> {
    let n = seen.len();
    let is_kept = |&k: &usize| k == 0 || seen[k] != seen[k - 1] && seen[k] != seen[0];
    let kept: Vec<usize> = (0..n).filter(is_kept).collect();
    let ring = BorderPolygon { places: kept.iter().map(|&k| seen[k]).collect(), first: 0 };
    let found = triangles(&[ring]).map_err(|_| FaceFault::Crosses)?.triangles;
    if found.len() + 2 != kept.len() {
        return Err(FaceFault::Crosses);
    }
    let mut all: Vec<[usize; 3]> =
        found.into_iter().map(|triangle| triangle.map(|k| kept[k as usize])).collect();
    for (i, &from) in kept.iter().enumerate() {
        let to = kept.get(i + 1).copied().unwrap_or(n);
        all.extend((from + 1..to).map(|k| [from, k, (k + 1) % n]));
    }
    Ok(all)
}
