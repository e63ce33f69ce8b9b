//! Parts of surfaces with closed forms, in every orientation and at three scales: borders, boxes, nearest points,
//! what of curves lies on them, and what they enclose.

use std::{f64::consts::PI, sync::Arc};

use virote_kernel::{
    Cutter, Face, Frame, NurbsCurve, NurbsSurface, Surface, TessellationOptions, Tolerance,
    glam::{DAffine3, DVec3},
};

use crate::crossing_turned::{fractions, orientations, turn};

const TOLERANCE: Tolerance = Tolerance::DEFAULT;

/// A place and a scale beside the turn, for a quarter of the orientations.
fn placements() -> impl Iterator<Item = (DAffine3, f64, Tolerance)> {
    (0..orientations().div_ceil(4)).map(|n| {
        let scale = [1.0, 1e-3, 1e3][n as usize % 3];
        let place = DAffine3::from_translation(DVec3::new(0.3, -1.7, 0.9) * scale)
            * DAffine3::from_scale(DVec3::splat(scale))
            * turn(n);
        (place, scale, TOLERANCE.with_distance(TOLERANCE.distance * scale))
    })
}

fn whole(surface: &NurbsSurface, place: &DAffine3, tolerance: Tolerance) -> Face {
    Face::whole(Arc::new(surface.transformed(place)), tolerance).unwrap()
}

/// The plane at a height over the middle, across a direction that depends on the number alone.
fn tilted(n: u64, height: f64) -> (DVec3, Frame) {
    let normal = turn(n + 1000).transform_vector3(DVec3::Z);
    (normal, Frame::from_normal(normal * height, normal, None).unwrap())
}

/// The plane moved.
fn moved(plane: Frame, place: &DAffine3) -> Frame {
    plane.transformed(place).unwrap()
}

#[test]
fn a_cap_of_a_sphere_has_its_rim_its_box_and_its_volume() {
    let sphere = NurbsSurface::sphere(Frame::XY, 1.0).unwrap();
    for (n, (place, scale, tolerance)) in placements().enumerate() {
        let height = 0.9 - 1.8 * fractions(n as u64)[3];
        let (normal, plane) = tilted(n as u64, height);
        let face = whole(&sphere, &place, tolerance);
        let cut = moved(plane, &place);
        let caps = face.beside_plane(cut, true, tolerance).unwrap();
        let [cap] = &caps[..] else { panic!("{n}: {} parts", caps.len()) };

        let rim = 2.0 * PI * (1.0 - height * height).sqrt() * scale;
        let length = cap.border_length(tolerance).unwrap();
        assert!((length / rim - 1.0).abs() < 1e-9, "{n}: {length} for {rim}");
        let edges = cap.edges(tolerance).unwrap();
        assert_eq!(edges.len(), 1, "{n}");
        assert!(edges[0].is_closed(tolerance.distance));
        for t in edges[0].domain().steps(64) {
            let off = (edges[0].point_at(t) - cut.origin()).dot(cut.z());
            assert!(off.abs() <= tolerance.distance, "{n}: {off}");
        }

        // The box of a cap about the middle of the sphere, along the axes of space.
        let normal = place.transform_vector3(normal) / scale;
        let middle = place.translation;
        let found = cap.bounds(tolerance).unwrap();
        for axis in 0..3 {
            for sign in [1.0, -1.0] {
                let along = sign * normal[axis];
                let rise = (1.0 - along * along).max(0.0).sqrt();
                let wanted = match height <= along {
                    true => 1.0,
                    false => height * along + (1.0 - height * height).sqrt() * rise,
                };
                let end = if 0.0 < sign { found.max } else { found.min };
                let error = sign * (end - middle)[axis] / scale - wanted;
                assert!(error.abs() < 1e-9, "{n}, axis {axis}: {error}");
            }
        }

        // With its floor it encloses the volume that Archimedes tells.
        let floor = floor_of(cap, cut, tolerance);
        for faces in [[cap.clone(), floor.clone()], [floor.reversed(), cap.clone()]] {
            let volume = Face::enclosed_mass(&faces, tolerance).unwrap().amount;
            let wanted = PI / 3.0
                * (1.0 - height)
                * (1.0 - height)
                * (2.0 + height)
                * (scale * scale * scale);
            assert!((volume / wanted - 1.0).abs() < 1e-6, "{n}: {volume} for {wanted}");
        }
    }
}

/// The face of the plane within the edges of another face.
fn floor_of(face: &Face, plane: Frame, tolerance: Tolerance) -> Face {
    let rims = face.loops(tolerance).unwrap();
    let size = face.surface().bounds().diagonal();
    let [x, y] = [plane.x() * size, plane.y() * size];
    let o = plane.origin();
    let carrier = NurbsSurface::bilinear(o - x - y, o - x + y, o + x - y, o + x + y).unwrap();
    let bounded =
        |rims: &[NurbsCurve]| Face::bounded(Arc::new(carrier.clone()), rims, tolerance).unwrap();
    let back: Vec<NurbsCurve> = rims.iter().map(NurbsCurve::reversed).collect();
    let [one, other] = [bounded(&rims), bounded(&back)];
    let area = |face: &Face| face.mass().unwrap().amount;
    if area(&one) < area(&other) { one } else { other }
}

#[test]
fn the_nearest_point_of_a_face_is_that_of_its_mesh_but_for_the_tolerance() {
    let torus = NurbsSurface::torus(Frame::XY, 2.0, 0.8).unwrap();
    let post = NurbsSurface::cone(Frame::XY.at(DVec3::new(2.0, 0.3, -3.0)), [0.5; 2], 6.0).unwrap();
    let shift = DVec3::new(0.1, 0.2, 0.3);
    for (n, (place, scale, tolerance)) in placements().enumerate() {
        let cutter = Cutter::Surface(Arc::new(post.transformed(&place)));
        let parts = whole(&torus, &place, tolerance).split(&[cutter], tolerance).unwrap();
        assert_eq!(parts.len(), 3, "{n}");
        let chord = 1e-3;
        for (i, part) in parts.iter().enumerate() {
            let options = TessellationOptions::within(chord * scale);
            let mesh = part.mesh(&options, 1_000_000).unwrap();
            for k in 0..3 {
                let [a, b, c, _] = fractions(3 * (n as u64) + k);
                let point = (DVec3::new(a, b, c) * 6.0 - 3.0 + shift) * scale;
                let point = place.transform_point3(point / scale);
                let found = part.closest(point, tolerance).unwrap();
                let nearest = mesh.vertices().iter().map(|vertex| vertex.distance(point));
                let nearest = nearest.fold(f64::INFINITY, f64::min);
                assert!(
                    found.distance <= nearest + 1e-9 * scale,
                    "{n}, {i}: {} {nearest}",
                    found.distance
                );
                // Corners of the mesh are as far apart as chords allow on the tightest bend.
                assert!(
                    nearest <= found.distance + 0.12 * scale,
                    "{n}, {i}: {} {nearest}",
                    found.distance
                );
                let [u, v] = found.parameters;
                assert!(part.has([u, v], tolerance), "{n}, {i}");
            }
        }
    }
}

#[test]
fn of_a_line_or_circle_on_a_sphere_the_part_on_a_cap_is_told_at_its_length() {
    let sphere = NurbsSurface::sphere(Frame::XY, 1.0).unwrap();
    for (n, (place, scale, tolerance)) in placements().enumerate() {
        let (normal, plane) = tilted(n as u64, 0.5);
        let caps = whole(&sphere, &place, tolerance)
            .beside_plane(moved(plane, &place), true, tolerance)
            .unwrap();
        // Great circles through the cap's middle have a third of a turn on it, however they lie to the seam.
        let beside = turn(n as u64 + 77).transform_vector3(normal);
        let across =
            moved(Frame::from_normal(DVec3::ZERO, normal.cross(beside), None).unwrap(), &place);
        let surface = Surface::Nurbs(Arc::clone(caps[0].surface()));
        let circles = surface.section(across, tolerance).unwrap().curves;
        let parts = caps[0].clipped(&circles, tolerance).unwrap();
        let length: f64 = parts.iter().map(|part| part.length(part.domain())).sum();
        let wanted = 2.0 * PI / 3.0 * scale;
        assert!((length - wanted).abs() < 1e-5 * scale, "{n}: {length} for {wanted}");
    }
}

#[test]
fn two_equal_cylinders_enclose_the_volume_of_steinmetz() {
    let tube =
        |frame: Frame| NurbsSurface::cone(frame.at(frame.z() * -2.0), [1.0; 2], 4.0).unwrap();
    let tubes = [tube(Frame::XY), tube(Frame::YZ)];
    for (n, (place, scale, tolerance)) in placements().enumerate() {
        let faces = tubes.each_ref().map(|tube| whole(tube, &place, tolerance));
        let mut lenses = Vec::new();
        for (face, other) in [(&faces[0], &faces[1]), (&faces[1], &faces[0])] {
            let cutter = Cutter::Face(Arc::new(other.clone()));
            let parts = face.split(&[cutter], tolerance).unwrap();
            let is_lens = |part: &&Face| {
                let area = part.mass().unwrap().amount / (scale * scale);
                (area - 4.0).abs() < 1e-6
            };
            lenses.extend(parts.iter().filter(is_lens).cloned());
        }
        assert_eq!(lenses.len(), 4, "{n}");
        let volume =
            Face::enclosed_mass(&lenses, tolerance).unwrap().amount / (scale * scale * scale);
        assert!((volume * 3.0 / 16.0 - 1.0).abs() < 1e-9, "{n}: {volume}");
    }
}

#[test]
fn what_touches_a_torus_along_a_circle_takes_nothing_away() {
    let torus = NurbsSurface::torus(Frame::XY, 3.0, 1.0).unwrap();
    let all = 12.0 * PI * PI;
    let plane = |height: f64| Frame::XY.at(DVec3::Z * height);
    let tube = |radius: f64| NurbsSurface::cone(plane(-3.0), [radius; 2], 6.0).unwrap();
    for (n, (place, scale, tolerance)) in placements().enumerate() {
        let face = whole(&torus, &place, tolerance);
        let areas = |cutter: Cutter| -> Vec<f64> {
            let parts = face.split(&[cutter], tolerance).unwrap();
            let mut areas: Vec<f64> =
                parts.iter().map(|part| part.mass().unwrap().amount / (scale * scale)).collect();
            areas.sort_by(f64::total_cmp);
            areas
        };
        let touching = [
            Cutter::Plane(moved(plane([1.0, -1.0][n % 2]), &place)),
            Cutter::Surface(Arc::new(tube([4.0, 2.0][n % 2]).transformed(&place))),
        ];
        for cutter in touching {
            let found = areas(cutter);
            assert_eq!(found.len(), 1, "{n}: {found:?}");
            assert!((found[0] / all - 1.0).abs() < 1e-9, "{n}: {found:?}");
        }
        // Nearly touching, twice the angle of the tube from the top to the cut, by Pappus.
        for below in [1e-5_f64, 1e-7] {
            let strip = 2.0 * libm::acos(1.0 - below) * 6.0 * PI;
            let found = areas(Cutter::Plane(moved(plane(1.0 - below), &place)));
            assert_eq!(found.len(), 2, "{n}: {found:?}");
            assert!((found[0] - strip).abs() < 1e-7, "{n}: {found:?} for {strip}");
            assert!((found[0] + found[1] - all).abs() < 1e-7, "{n}: {found:?} for {all}");
        }
    }
}
