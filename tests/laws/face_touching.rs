//! Parts of surfaces whose cuts touch a border, a seam or a corner of the parameters, against closed forms.

use std::{f64::consts::PI, sync::Arc};

use virote_kernel::{
    CircleForm, Cutter, Face, FaceEdge, FaceError, Frame, GeomError, NurbsCurve, NurbsSurface,
    Surface, Tolerance,
    glam::{DAffine3, DVec3},
};

use crate::crossing_turned::{fractions, orientations, turn};

const TOLERANCE: Tolerance = Tolerance::DEFAULT;

fn whole(surface: NurbsSurface) -> Face {
    Face::whole(Arc::new(surface), TOLERANCE).unwrap()
}

/// The areas of parts, least first.
fn areas(parts: &[Face]) -> Vec<f64> {
    let mut areas: Vec<f64> = parts.iter().map(|part| part.mass().unwrap().amount).collect();
    areas.sort_by(f64::total_cmp);
    areas
}

fn tube(origin: DVec3, axis: DVec3, radius: f64, height: f64) -> NurbsSurface {
    let frame = Frame::from_normal(origin, axis, None).unwrap();
    NurbsSurface::cone(frame, [radius; 2], height).unwrap()
}

#[test]
fn a_disc_that_touches_the_border_of_a_square_is_taken_out_of_the_rest() {
    let square =
        NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::X + DVec3::Y).unwrap();
    for n in 0..orientations() {
        let [a, b, ..] = fractions(n);
        let radius = 0.05 + 0.4 * a;
        let middle = DVec3::new(radius + (1.0 - 2.0 * radius) * b, radius, 0.0);
        let place = DAffine3::from_translation(DVec3::new(0.3, -1.7, 0.9)) * turn(n);
        let disc =
            NurbsCurve::ellipse(Frame::XY.at(middle), [radius; 2], CircleForm::NinePoint).unwrap();
        let cut = Cutter::Curve(disc.transformed(&place));
        let parts = whole(square.transformed(&place)).split(&[cut], TOLERANCE).unwrap();
        let found = areas(&parts);
        let disc = PI * radius * radius;
        let mut wanted = [disc, 1.0 - disc];
        wanted.sort_by(f64::total_cmp);
        assert_eq!(found.len(), 2, "{n}: {found:?}");
        assert!((found[0] - wanted[0]).abs() < 1e-9, "{n}: {found:?} for {wanted:?}");
        assert!((found[1] - wanted[1]).abs() < 1e-9, "{n}: {found:?} for {wanted:?}");
    }
}

#[test]
fn discs_that_touch_one_another_and_the_border_are_parts_of_their_own() {
    let square = NurbsSurface::bilinear(
        DVec3::ZERO,
        DVec3::Y * 4.0,
        DVec3::X * 4.0,
        DVec3::X * 4.0 + DVec3::Y * 4.0,
    );
    let disc = |x: f64, radius: f64| {
        let frame = Frame::XY.at(DVec3::new(x, 2.0, 0.0));
        Cutter::Curve(NurbsCurve::ellipse(frame, [radius; 2], CircleForm::NinePoint).unwrap())
    };
    // One in the other, which touches the border at the same point; and one beside both,
    // so that the rest falls apart.
    let cuts = [disc(1.0, 1.0), disc(0.5, 0.5), disc(3.0, 1.0)];
    let found = areas(&whole(square.unwrap()).split(&cuts, TOLERANCE).unwrap());
    let rest = 8.0 - PI;
    let wanted = [0.25 * PI, 0.75 * PI, PI, rest, rest];
    assert_eq!(found.len(), 5, "{found:?}");
    assert!(found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?}");
}

#[test]
fn holes_that_touch_end_edges_where_they_touch() {
    let square = NurbsSurface::bilinear(
        DVec3::ZERO,
        DVec3::Y * 4.0,
        DVec3::X * 4.0,
        DVec3::X * 4.0 + DVec3::Y * 4.0,
    );
    let square = square.unwrap();
    for n in 0..orientations() {
        let [a, b, c, ..] = fractions(n);
        let place = DAffine3::from_translation(DVec3::new(0.3, -1.7, 0.9)) * turn(n);
        let disc = |middle: DVec3, radius: f64| {
            let circle =
                NurbsCurve::ellipse(Frame::XY.at(middle), [radius; 2], CircleForm::NinePoint);
            Cutter::Curve(circle.unwrap().transformed(&place))
        };
        let (radius, other) = (0.2 + 0.4 * a, 0.2 + 0.4 * b);
        let middle = DVec3::new(1.8 + 0.4 * c, 2.2, 0.0);
        let way = DVec3::new(libm::cos(6.0 * b), libm::sin(6.0 * b), 0.0);
        let of_two = [disc(middle, radius), disc(middle + way * (radius + other), other)];
        let at_border = [disc(DVec3::new(1.0 + c, radius, 0.0), radius)];
        for (cutters, touch) in
            [(&of_two[..], middle + way * radius), (&at_border[..], DVec3::new(1.0 + c, 0.0, 0.0))]
        {
            let face = whole(square.transformed(&place));
            let corner = place.transform_point3(DVec3::new(3.9, 3.9, 0.0));
            let rest = face.part_at(cutters, corner, TOLERANCE).unwrap();
            let touch = place.transform_point3(touch);
            let parts = rest.part_edges(TOLERANCE).unwrap();
            assert_eq!(parts.len(), 1, "{n}");
            assert_eq!(parts[0].len(), 1 + cutters.len(), "{n}");
            let ends_there = |edges: &&Vec<FaceEdge>| {
                let mut curves = edges.iter().filter_map(|edge| edge.curve.as_ref());
                curves.any(|curve| curve.start().distance(touch) <= 2e-6)
            };
            assert_eq!(parts[0].iter().filter(ends_there).count(), 2, "{n}");
        }
    }
}

#[test]
fn a_tip_that_stands_on_a_plate_or_on_a_tip_touches_it_there() {
    let cup = NurbsSurface::cone(Frame::XY, [0.0, 1.0], 2.0).unwrap();
    let hat = NurbsSurface::cone(Frame::XY.at(DVec3::Z * -2.0), [1.0, 0.0], 2.0).unwrap();
    // The tip stands where the plate is halved, and beside that.
    let plate = |shift: f64| {
        let corner = |x: f64, y: f64| DVec3::new(x + shift, y, 0.0);
        NurbsSurface::bilinear(
            corner(-3.0, -3.0),
            corner(-3.0, 3.0),
            corner(3.0, -3.0),
            corner(3.0, 3.0),
        )
        .unwrap()
    };
    for n in 0..orientations() {
        let [a, b, ..] = fractions(n);
        let place = DAffine3::from_translation(DVec3::new(a, b, -1.3)) * turn(n);
        for other in [&hat, &plate(0.0), &plate(0.7)] {
            let [own, other] =
                [&cup, other].map(|surface| Surface::Nurbs(Arc::new(surface.transformed(&place))));
            for [first, second] in [[&own, &other], [&other, &own]] {
                let found = first.intersections(second, TOLERANCE).unwrap();
                let [touch] = found.touches[..] else { panic!("{n}: {found:?}") };
                let tip = place.transform_point3(DVec3::ZERO);
                assert!(touch.distance(tip) < 1e-14, "{n}: {touch} for {tip}");
                assert!(found.curves.is_empty() && found.contacts.is_empty(), "{n}: {found:?}");
            }
        }
    }
}

#[test]
fn a_plane_beside_a_sphere_touches_its_seam_with_the_cap_that_it_cuts_off() {
    let sphere = NurbsSurface::sphere(Frame::XY, 2.0).unwrap();
    let normal = (DVec3::X + DVec3::Y).normalize();
    let plane = Frame::from_normal(DVec3::X * 2.0, normal, None).unwrap();
    let found = areas(&whole(sphere).split(&[Cutter::Plane(plane)], TOLERANCE).unwrap());
    let cap = 4.0 * PI * (2.0 - 2.0 / 2.0_f64.sqrt());
    assert_eq!(found.len(), 2, "{found:?}");
    assert!((found[0] - cap).abs() < 1e-9 && (found[1] - 16.0 * PI + cap).abs() < 1e-9);
}

#[test]
fn planes_through_the_pole_of_an_ellipsoid_divide_its_area() {
    let sphere = NurbsSurface::sphere(Frame::XY, 1.0).unwrap();
    let stretch = DAffine3::from_scale(DVec3::new(3.0, 2.0, 1.0));
    let egg = whole(sphere.transformed(&stretch));
    let all = egg.mass().unwrap().amount;
    for normal in [[1.0, 2.0, 1.0], [1.0, 2.0, 0.992], [1.0, 2.0, 1.01], [0.3, 0.2, 1.0]] {
        let plane = Frame::from_normal(DVec3::Z, DVec3::from(normal), None).unwrap();
        let found = areas(&egg.split(&[Cutter::Plane(plane)], TOLERANCE).unwrap());
        assert_eq!(found.len(), 2, "{normal:?}: {found:?}");
        assert!((found[0] + found[1] - all).abs() < 1e-9, "{normal:?}: {found:?}");
    }
}

#[test]
fn planes_through_the_crossing_of_the_seams_of_a_torus_halve_it() {
    let torus = whole(NurbsSurface::torus(Frame::XY, 3.0, 1.0).unwrap());
    let steep = 8.0_f64.sqrt();
    let normals = [[1.0, 1.0], [2.0, 1.0], [1.0, 2.0], [1.0, 2.828_427_12], [1.0, steep]];
    for [y, z] in normals.into_iter().chain((0..20).map(|n| {
        let [a, b, ..] = fractions(n);
        [a - 0.5, b - 0.5]
    })) {
        let plane = Frame::from_normal(DVec3::ZERO, DVec3::new(0.0, y, z), None).unwrap();
        let above = torus.beside_plane(plane, true, TOLERANCE).unwrap();
        let area: f64 = areas(&above).iter().sum();
        assert!((area - 6.0 * PI * PI).abs() < 1e-7, "{y}, {z}: {area}");
    }
}

#[test]
fn spheres_cut_thin_tubes_wherever_their_seams_are() {
    for (n, radius) in [1.0, 0.1, 0.05, 0.03, 0.01, 0.001, 0.07].into_iter().enumerate() {
        for shift in [0.0, 1.0] {
            let middle = DVec3::new(1.0, 2.0, 3.0) * shift;
            let sphere = NurbsSurface::sphere(Frame::XY.at(middle), 10.0).unwrap();
            let tube = whole(tube(middle - DVec3::Z * 12.0, DVec3::Z, radius, 24.0));
            let parts = tube.split(&[Cutter::Surface(Arc::new(sphere))], TOLERANCE).unwrap();
            let half = (100.0 - radius * radius).sqrt();
            let found = areas(&parts).last().copied().unwrap_or_default();
            let wanted = 4.0 * PI * radius * half;
            assert!((found / wanted - 1.0).abs() < 1e-9, "{n}: {found} for {wanted}");
        }
    }
}

#[test]
fn a_bore_that_touches_a_seam_is_right_or_refused() {
    let middle = |off: f64| DVec3::new(0.0, 0.3 - off, 0.5);
    let part = |off: f64| {
        let wall = whole(tube(DVec3::Z * -2.0, DVec3::Z, 1.0, 4.0));
        let bore = Cutter::Surface(Arc::new(tube(middle(off), DVec3::X, 0.3, 8.0)));
        wall.split(&[bore], TOLERANCE)
    };
    let clear = areas(&part(-0.01).unwrap());
    let mut n_refused = 0;
    for off in [0.0, 1e-9, 1e-7, 3e-7, 1e-6, 1.2e-6, 1.5e-6, 2e-6, 3e-6, 5e-6, 1e-5, 1e-4] {
        for off in [off, -off] {
            let Ok(parts) = part(off) else {
                n_refused += 1;
                continue;
            };
            // By how much the bore is larger where the wall is steeper.
            let found = areas(&parts);
            assert_eq!(found.len(), 2, "{off}: {found:?}");
            assert!((found.iter().sum::<f64>() - 8.0 * PI).abs() < 1e-9, "{off}: {found:?}");
            assert!((found[0] / clear[0] - 1.0).abs() < 0.02, "{off}: {found:?}, {clear:?}");
        }
    }
    assert!(n_refused < 10, "{n_refused}");
}

#[test]
fn round_surfaces_touch_along_a_line_that_is_the_seam_of_both() {
    let inner = |radii: [f64; 2], height: f64, z: f64| {
        let frame = Frame::XY.at(DVec3::new(0.5, 0.0, z));
        Surface::from(NurbsSurface::cone(frame, radii, height).unwrap())
    };
    let outer = |radii: [f64; 2]| Surface::from(NurbsSurface::cone(Frame::XY, radii, 2.0).unwrap());
    let pairs = [
        (outer([1.0; 2]), inner([0.5; 2], 4.0, -1.0), 2.0),
        (outer([1.0, 0.0]), inner([0.5, 0.0], 1.0, 0.0), 1.25_f64.sqrt()),
    ];
    for (outer, inner, length) in pairs {
        let found = outer.intersections(&inner, TOLERANCE).unwrap().curves;
        let [line] = &found[..] else { panic!("{} curves", found.len()) };
        assert!((line.length(line.domain()) - length).abs() < 1e-5, "{length}");
    }
}

#[test]
fn a_curve_that_ends_inside_of_a_closed_surface_divides_nothing_although_it_goes_over_the_seam() {
    let frame =
        Frame::from_axes(DVec3::Z * 0.5, DVec3::new(0.8, 0.6, 0.0), DVec3::new(-0.6, 0.8, 0.0));
    let helix = NurbsCurve::helix(frame.unwrap(), 1.0, 1.0, 2.0, 1e-7).unwrap();
    let wall = whole(tube(DVec3::ZERO, DVec3::Z, 1.0, 3.0));
    let found = wall.split(&[Cutter::Curve(helix)], TOLERANCE);
    assert!(matches!(found, Err(GeomError::Face(FaceError::EndsInside { .. }))), "{found:?}");
    // What runs around a ring opens it, but leaves it one part.
    let ring = Frame::from_normal(DVec3::X * 3.0, DVec3::Y, None).unwrap();
    let ring = NurbsCurve::ellipse(ring, [1.0; 2], CircleForm::NinePoint).unwrap();
    let torus = whole(NurbsSurface::torus(Frame::XY, 3.0, 1.0).unwrap());
    assert_eq!(torus.split(&[Cutter::Curve(ring)], TOLERANCE).unwrap().len(), 1);
}

/// A roller and a ball that lie on a plate, wherever that is, and a plane under them.
#[test]
fn cutters_that_only_touch_a_face_tell_where() {
    let [x, y] = [DVec3::X * 6.0, DVec3::Y * 6.0];
    let plate = NurbsSurface::bilinear(DVec3::ZERO, y, x, x + y).unwrap();
    for n in 0..orientations() {
        let [a, b, c, ..] = fractions(n);
        let (radius, length) = (0.2 + 2.0 * a, 1.0 + 2.0 * b);
        let at = DVec3::new(1.0 + b, 1.0 + 4.0 * c, 0.0);
        let roller = tube(at + DVec3::Z * radius, DVec3::X, radius, length);
        let ball = NurbsSurface::sphere(Frame::XY.at(at + DVec3::Z * radius), radius).unwrap();
        let place = DAffine3::from_translation(DVec3::new(0.3, -1.7, 0.9)) * turn(n);
        let [plate, roller, ball] = [&plate, &roller, &ball].map(|s| s.transformed(&place));
        let normal = place.matrix3 * DVec3::Z;
        let plane = Cutter::Plane(Frame::from_normal(place.translation, normal, None).unwrap());
        let [plate, roller, ball] = [plate, roller, ball].map(Arc::new);
        let face = |surface: &Arc<NurbsSurface>| whole((**surface).clone());
        let surface = |surface: &Arc<NurbsSurface>| Cutter::Surface(Arc::clone(surface));
        match face(&plate).split(&[surface(&roller)], TOLERANCE) {
            Err(GeomError::Face(FaceError::TouchesAlong { ends, length: told, .. })) => {
                let wanted = [at, at + DVec3::X * length].map(|end| place.transform_point3(end));
                let [near, far] = wanted.map(|end| ends.map(|own| own.distance(end)));
                let off = near[0].min(near[1]).max(far[0].min(far[1]));
                assert!(off < 1e-6 && (told - length).abs() < 1e-6, "{n}: {ends:?}, {told}");
            }
            other => panic!("{n}: {other:?}"),
        }
        for (touched, cutter) in [(&plate, surface(&ball)), (&ball, plane.clone())] {
            match face(touched).split(&[cutter], TOLERANCE) {
                Err(GeomError::Face(FaceError::TouchesAt { point, n_points: 1, .. })) => {
                    assert!(point.distance(place.transform_point3(at)) < 1e-4, "{n}: {point}");
                }
                other => panic!("{n}: {other:?}"),
            }
        }
        for touched in [&roller, &ball] {
            let Cutter::Plane(plane) = plane else { unreachable!("it is one") };
            let face = face(touched);
            let kept = [true, false].map(|side| face.beside_plane(plane, side, TOLERANCE).unwrap());
            assert!(kept[1].is_empty() && kept[0] == [face], "{n}: {kept:?}");
        }
    }
}
