//! Where the domains of borders and surfaces begin, and how wide they are: what regions, faces and solids are does not
//! depend on it, and what tells parameters tells those of the domain.

use std::{f64::consts::PI, sync::Arc};

use virote_kernel::{
    Axis, CornerStyle, Curve, Cutter, Direction, Face, Frame, Interval, NurbsCurve, NurbsSurface,
    Region, RegionSide, Solid, TessellationOptions, glam::DVec3,
};

use crate::solid::{TOLERANCE, circle, polygon, region, whole};

/// From zero and not, wide and narrow.
const DOMAINS: [[f64; 2]; 3] = [[0.0, 1.0], [3.0, 10.0], [-0.4, -0.1]];

fn interval([start, end]: [f64; 2]) -> Interval {
    Interval::new(start, end).unwrap()
}

/// A surface on a domain, and in the other direction on the one after it.
fn surface_on(surface: &NurbsSurface, k: usize) -> NurbsSurface {
    let [u, v] = [DOMAINS[k % 3], DOMAINS[(k + 1) % 3]].map(interval);
    surface.reparametrized(Direction::U, u).reparametrized(Direction::V, v)
}

/// A square of side 4 about the origin with a hole of radius 1.
fn plate(frame: Frame, domain: [f64; 2]) -> Region {
    let corner =
        |x: f64, y: f64| frame.to_space().transform_point3(DVec3::new(x, y, 0.0)).to_array();
    let outer =
        polygon(&[corner(-2.0, -2.0), corner(2.0, -2.0), corner(2.0, 2.0), corner(-2.0, 2.0)]);
    let [outer, hole] =
        [outer, circle(frame, 1.0)].map(|border| border.reparametrized(interval(domain)));
    region(&outer, &[hole])
}

#[track_caller]
fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-9 * (1.0 + expected.abs()), "{found} for {expected}");
}

fn area(parts: &[Region]) -> f64 {
    parts.iter().map(Region::area).sum()
}

#[test]
fn a_region_is_the_same_on_every_domain() {
    for domain in DOMAINS {
        let plate = plate(Frame::XY, domain);
        near(plate.area(), 16.0 - PI);
        near(plate.length(), 16.0 + 2.0 * PI);
        for distance in [0.5, -0.25] {
            let side = 4.0 + 2.0 * distance;
            let hole = PI * (1.0 - distance) * (1.0 - distance);
            let square =
                side * side - if 0.0 < distance { (4.0 - PI) * distance * distance } else { 0.0 };
            let found = plate.offset(distance, CornerStyle::Round, TOLERANCE).unwrap();
            near(area(&found), square - hole);
        }
        let rounded = plate.filleted(0.5, None, TOLERANCE).unwrap();
        near(rounded.area(), 16.0 - PI - (4.0 - PI) * 0.25);
        // A disc about the middle of a side: half of it lies within.
        let disc = circle(Frame::XY.at(DVec3::X * 2.0), 0.5).reparametrized(interval(domain));
        let both = [plate.clone(), region(&disc, &[])];
        near(area(&Region::union(&both, TOLERANCE, 1).unwrap()), 16.0 - PI + PI / 8.0);
        near(area(&Region::intersection(&both, TOLERANCE, 1).unwrap()), PI / 8.0);
        near(area(&Region::difference(&both, TOLERANCE, 1).unwrap()), 16.0 - PI - PI / 8.0);
        let foot = plate.closest(DVec3::new(0.1, 0.0, 0.0), 1e-9);
        assert!(foot.distance(DVec3::X) < 1e-9, "{foot}");
        assert!(plate.side_of(DVec3::X * 0.99, 1e-6) == RegionSide::Outside);
        assert!(plate.side_of(DVec3::X * 1.01, 1e-6) == RegionSide::Inside);
    }
}

/// Every step of a face lies on its edge where the surface is at the parameters of the step.
#[track_caller]
fn check_steps(solid: &Solid) {
    let topology = solid.topology(TOLERANCE).unwrap();
    for (face, parts) in solid.faces().iter().zip(&topology.loops) {
        for step in parts.iter().flatten().flatten() {
            let [from, to] = step.parameters.range;
            let curve = &topology.edges[step.edge].curve;
            let n = 8;
            for k in 0..=n {
                let f = f64::from(k) / f64::from(n);
                let at = step.parameters.curve.point_at(from + (to - from) * f);
                let point = face.surface().point_at(at.x, at.y);
                assert!(curve.closest(point, 1e-9).distance < 2.0 * TOLERANCE.distance);
                let end = if step.is_along { curve.end() } else { curve.start() };
                assert!(k < n || point.distance(end) < 2.0 * TOLERANCE.distance);
            }
        }
    }
}

#[test]
fn an_extruded_plate_is_the_same_on_every_domain() {
    for domain in DOMAINS {
        let solid = Solid::extruded(&plate(Frame::XY, domain), DVec3::Z * 3.0, TOLERANCE).unwrap();
        near(solid.volume_mass().unwrap().amount, 3.0 * (16.0 - PI));
        near(solid.area_mass().unwrap().amount, 2.0 * (16.0 - PI) + 3.0 * (16.0 + 2.0 * PI));
        assert_eq!(solid.topology(TOLERANCE).unwrap().genus(), 1);
        check_steps(&solid);
        // A plane through the middle, however it leans, leaves halves.
        let plane = Frame::from_normal(DVec3::Z * 1.5, DVec3::new(0.3, 0.2, 1.0), None).unwrap();
        for is_above in [false, true] {
            let half = solid.cut(plane, is_above, TOLERANCE).unwrap().unwrap();
            let volume = half.volume_mass().unwrap().amount;
            assert!((volume - 1.5 * (16.0 - PI)).abs() < 1e-5, "{volume}");
            check_steps(&half);
        }
        let mesh = solid.mesh(&TessellationOptions::within(1e-3), 100_000).unwrap();
        let check = mesh.check(TOLERANCE);
        assert!(check.is_closed && check.euler == 0 && check.degenerate == 0, "{check:?}");
        assert!((mesh.volume() - 3.0 * (16.0 - PI)).abs() < 0.05);
        let line = NurbsCurve::line(DVec3::new(-5.0, 0.0, 1.0), DVec3::new(5.0, 0.0, 1.0)).unwrap();
        let line = line.reparametrized(interval(domain));
        let found = solid.piercings(&Curve::from(line.clone()), TOLERANCE).unwrap();
        for (found, x) in found.iter().zip([-2.0, -1.0, 1.0, 2.0]) {
            near(line.domain().fraction_of(found.place.t), 0.1 * (x + 5.0));
            near(found.place.point.x, x);
        }
        assert_eq!(found.len(), 4);
    }
}

#[test]
fn a_turned_plate_follows_pappus_on_every_domain() {
    let axis = Axis::new(DVec3::ZERO, DVec3::Z).unwrap();
    for domain in DOMAINS {
        let section = plate(Frame::ZX.at(DVec3::X * 5.0), domain);
        for angle in [2.0 * PI, 1.0] {
            let solid = Solid::revolved(&section, axis, angle, TOLERANCE).unwrap();
            near(solid.volume_mass().unwrap().amount, 5.0 * angle * (16.0 - PI));
            check_steps(&solid);
            // Within the wall about the hole, far from both ends of the turn.
            let (sin, cos) = libm::sincos(0.5);
            let found = solid.closest(DVec3::new(cos, sin, 0.0) * 3.9, TOLERANCE).unwrap();
            near(found.foot.distance, 0.1);
        }
    }
}

/// Half of a cylinder of radius 1 and height 2, whatever its parameters run along, and its parts.
#[test]
fn parts_of_a_cylinder_are_the_same_on_every_domain() {
    let pipe = NurbsSurface::cone(Frame::XY, [1.0, 1.0], 2.0).unwrap();
    for k in 0..3 {
        let face: Face = whole(surface_on(&pipe, k));
        near(face.mass().unwrap().amount, 4.0 * PI);
        near(face.border_length(TOLERANCE).unwrap(), 4.0 * PI);
        let plane = Frame::from_normal(DVec3::Z, DVec3::new(0.2, 0.5, 1.0), None).unwrap();
        for part in face.split(&[Cutter::Plane(plane)], TOLERANCE).unwrap() {
            let mass = part.mass().unwrap();
            assert!((mass.amount - 2.0 * PI).abs() < 1e-5, "{}", mass.amount);
            // Below a plane z = 1 − x/5 − y/2 the mean of x is that of −x²/5 over the heights.
            let sign = if mass.centroid.z < 1.0 { -1.0 } else { 1.0 };
            let expected = DVec3::new(0.1, 0.25, 0.0) * sign;
            assert!(((mass.centroid - expected) * DVec3::new(1.0, 1.0, 0.0)).length() < 1e-5);
            let mesh = part.mesh(&TessellationOptions::within(1e-3), 100_000).unwrap();
            assert!((mesh.area() - 2.0 * PI).abs() < 0.02, "{}", mesh.area());
        }
        let solid = Solid::capped(&[face], TOLERANCE).unwrap();
        near(solid.volume_mass().unwrap().amount, 2.0 * PI);
        check_steps(&solid);
        let foot = solid.closest(DVec3::new(0.0, 2.0, 0.7), TOLERANCE).unwrap().foot;
        assert!(foot.point.distance(DVec3::new(0.0, 1.0, 0.7)) < 1e-9);
    }
}

/// Two cylinders of radius 1 that cross at right angles: the arc of the one within the other has the area of Steinmetz.
#[test]
fn steinmetz_holds_on_every_domain() {
    let pipe = |frame: Frame| NurbsSurface::cone(frame, [1.0, 1.0], 4.0).unwrap();
    for k in 0..3 {
        let own = whole(surface_on(&pipe(Frame::XY.at(DVec3::Z * -2.0)), k));
        let other = Arc::new(surface_on(&pipe(Frame::YZ.at(DVec3::X * -2.0)), k + 1));
        let parts = own.split(&[Cutter::Surface(other)], TOLERANCE).unwrap();
        let mut areas: Vec<f64> = parts.iter().map(|part| part.mass().unwrap().amount).collect();
        areas.sort_by(f64::total_cmp);
        // Two halves of what lies within, 8 in all, and of what is beyond at both ends.
        assert_eq!(areas.len(), 4, "{areas:?}");
        let within: f64 = areas[..2].iter().sum();
        assert!((within - 8.0).abs() < 1e-4, "{areas:?}");
        assert!((areas.iter().sum::<f64>() - 8.0 * PI).abs() < 1e-4, "{areas:?}");
    }
}
