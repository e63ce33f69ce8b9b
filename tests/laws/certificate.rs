//! Curves on two surfaces: what is proven of them.

use virote_kernel::{
    CurveEnd, Frame, NurbsSurface, Surface, SurfaceCurve, SurfaceCurveKind, Tolerance, glam::DVec3,
};

fn tube(center: DVec3, axis: DVec3, radius: f64, length: f64) -> NurbsSurface {
    let frame = Frame::from_normal(center - axis * (0.5 * length), axis, None).expect("a frame");
    NurbsSurface::cone(frame, [radius, radius], length).expect("a tube")
}

fn sphere(center: DVec3, radius: f64) -> NurbsSurface {
    NurbsSurface::sphere(Frame::XY.at(center), radius).expect("a sphere")
}

fn all(a: &NurbsSurface, b: &NurbsSurface) -> Vec<SurfaceCurve> {
    SurfaceCurve::all([a, b], Tolerance::DEFAULT).expect("curves")
}

/// Bounds hold wherever it is looked, and the parameters are inside of both domains.
#[track_caller]
fn keeps_its_bounds(found: &SurfaceCurve, surfaces: [&NurbsSurface; 2]) {
    for part in found.parts().expect("parts") {
        for t in part.curve.domain().steps(2000) {
            let point = part.curve.point_at(t);
            for (surface, on) in surfaces.iter().zip(&part.on) {
                let uv = on.point_at(t);
                let (domain_u, domain_v) = (surface.domain_u(), surface.domain_v());
                assert!(domain_u.clamp_inside(uv.x).is_ok() && domain_v.clamp_inside(uv.y).is_ok());
                let distance = surface.point_at(uv.x, uv.y).distance(point);
                assert!(distance <= found.deviation, "{distance:e} > {:e} at {t}", found.deviation);
            }
        }
    }
}

#[test]
fn tubes_that_cross_are_proven_within_the_tolerance() {
    for radius in [0.5, 0.9, 0.999] {
        let surfaces =
            [&tube(DVec3::ZERO, DVec3::Z, 1.0, 6.0), &tube(DVec3::ZERO, DVec3::X, radius, 6.0)];
        let found = all(surfaces[0], surfaces[1]);
        assert_eq!(found.len(), 2);
        for curve in &found {
            let bound = curve.radius.expect("a proof");
            assert!(curve.is_proven && bound <= 1e-6 && curve.deviation <= bound);
            assert_eq!(curve.kind, SurfaceCurveKind::Crossing);
            assert_eq!(curve.between, [CurveEnd::Closed; 2]);
            keeps_its_bounds(curve, surfaces);
            // x² + y² = 1 and y² + z² = r²: the place with this y is (±√(1 − y²), y, ±√(r² − y²)).
            for t in curve.curve.domain().steps(500) {
                let point = curve.curve.point_at(t);
                let (x, z) = (1.0 - point.y * point.y, radius * radius - point.y * point.y);
                if 0.1 < z.abs() {
                    let there = DVec3::new(
                        x.sqrt() * point.x.signum(),
                        point.y,
                        z.sqrt() * point.z.signum(),
                    );
                    assert!(there.distance(point) <= 8.0 * bound, "{point}");
                }
            }
        }
    }
}

#[test]
fn a_curve_as_it_is_is_proven_as_far_as_it_is_away() {
    let surfaces = [&sphere(DVec3::ZERO, 2.0), &tube(DVec3::X, DVec3::Z, 1.2, 6.0)];
    let [a, b] = surfaces.map(|surface| Surface::from(surface.clone()));
    let found = a.intersections(&b, Tolerance::DEFAULT).expect("curves");
    assert!(!found.curves.is_empty());
    for curve in &found.curves {
        let told = SurfaceCurve::of(curve, surfaces, 1e-6).expect("what is known of it");
        assert!(told.is_proven && told.deviation <= 1e-6 && &told.curve == curve);
        keeps_its_bounds(&told, surfaces);
        // Moved by more than the tolerance it is none of both.
        let by = virote_kernel::glam::DAffine3::from_translation(DVec3::new(2e-6, 2e-6, 2e-6));
        let moved =
            SurfaceCurve::of(&curve.transformed(&by), surfaces, 1e-6).expect("what is known");
        assert!(!moved.is_proven && moved.radius.is_none());
    }
}

#[test]
fn a_proven_curve_moved_by_twice_its_radius_is_not_proven_within_it() {
    let surfaces = [&tube(DVec3::ZERO, DVec3::Z, 1.0, 6.0), &tube(DVec3::ZERO, DVec3::X, 0.7, 6.0)];
    for curve in all(surfaces[0], surfaces[1]) {
        let bound = curve.radius.expect("a proof");
        let mut same = curve.clone();
        same.prove(surfaces, bound);
        assert!(same.is_proven);
        for direction in [DVec3::X, DVec3::Y, DVec3::Z, DVec3::NEG_X, DVec3::new(0.6, 0.0, 0.8)] {
            let by = virote_kernel::glam::DAffine3::from_translation(direction * (2.0 * bound));
            let mut moved = curve.clone();
            moved.curve = moved.curve.transformed(&by);
            moved.prove(surfaces, bound);
            assert!(!moved.is_proven && moved.radius.is_none(), "{direction}");
            // Neither do its parameters alone.
            let mut aside = curve.clone();
            aside.on[0] = aside.on[0].transformed(&by);
            aside.prove(surfaces, bound);
            assert!(!aside.is_proven || direction.x == 0.0 && direction.y == 0.0, "{direction}");
        }
    }
}

#[test]
fn what_touches_or_nearly_does_is_not_proven() {
    for (radius, n) in [(0.999_999, 2), (1.0, 4)] {
        let surfaces =
            [&tube(DVec3::ZERO, DVec3::Z, 1.0, 6.0), &tube(DVec3::ZERO, DVec3::X, radius, 6.0)];
        let found = all(surfaces[0], surfaces[1]);
        assert_eq!(found.len(), n);
        for curve in &found {
            assert!(!curve.is_proven);
            keeps_its_bounds(curve, surfaces);
        }
    }
}

#[test]
fn sections_of_a_torus_are_proven_but_where_they_touch_or_meet() {
    let torus = NurbsSurface::torus(Frame::XY, 3.0, 1.0).expect("a torus");
    let section = |origin: DVec3, normal: DVec3| {
        let plane = Frame::from_normal(origin, normal, None).expect("a plane");
        SurfaceCurve::all_in_plane(&torus, plane, Tolerance::DEFAULT).expect("curves")
    };
    // Two ovals beside the hole (Perseus).
    let spiric = section(DVec3::Y * 1.5, DVec3::Y);
    assert!(spiric.len() == 2 && spiric.iter().all(|curve| curve.is_proven));
    for curve in &spiric {
        for t in curve.curve.domain().steps(500) {
            let point = curve.curve.point_at(t);
            let miss = libm::hypot(libm::hypot(point.x, point.y) - 3.0, point.z) - 1.0;
            assert!(miss.abs() <= curve.deviation && (point.y - 1.5).abs() <= curve.deviation);
        }
    }
    let top = section(DVec3::Z, DVec3::Z);
    assert!(top.len() == 1 && top[0].kind == SurfaceCurveKind::Contact && !top[0].is_proven);
    assert!(top[0].deviation <= 1e-6);
    // Villarceau's circles meet in two places, the lemniscate meets itself.
    let tilted = section(DVec3::ZERO, DVec3::new(0.0, -1.0, f64::sqrt(8.0)));
    let eight = section(DVec3::Y * 2.0, DVec3::Y);
    for curve in tilted.iter().chain(&eight) {
        assert!(!curve.is_proven);
    }
}

#[test]
fn a_sphere_cut_through_its_poles_has_parameters_on_both_sides_of_them() {
    let ball = sphere(DVec3::ZERO, 5.0);
    for normal in [DVec3::new(1.0, 2.0, 0.0), DVec3::Y] {
        let plane = Frame::from_normal(DVec3::ZERO, normal, None).expect("a plane");
        let found = SurfaceCurve::all_in_plane(&ball, plane, Tolerance::DEFAULT).expect("a circle");
        assert_eq!(found.len(), 1);
        assert!(found[0].deviation <= 1e-6);
        for part in found[0].parts().expect("parts") {
            assert!(part.seams().is_empty());
        }
    }
}

/// Circles and loops that run over the seams of both surfaces in one place, or in two, in either sense.
#[test]
fn what_runs_over_seams_of_both_surfaces_is_proven() {
    let ball = sphere(DVec3::ZERO, 1.0);
    let torus = NurbsSurface::torus(Frame::XY, 2.0, 0.5).expect("a torus");
    let tall = |x: f64, radius: f64| tube(DVec3::X * x, DVec3::Z, radius, 6.0);
    let pairs = [
        (&ball, tall(0.0, 0.6)),
        (&ball, tall(0.2, 0.6)),
        (&ball, tall(-0.2, 0.6)),
        (&torus, tall(0.0, 2.1)),
        (&torus, sphere(DVec3::ZERO, 2.1)),
        (&torus, sphere(DVec3::X * 0.3, 2.1)),
    ];
    for (number, (one, other)) in pairs.iter().enumerate() {
        let surfaces = [*one, other];
        let [a, b] = surfaces.map(|surface| Surface::from(surface.clone()));
        let found = a.intersections(&b, Tolerance::DEFAULT).expect("curves");
        assert_eq!(found.curves.len(), 2, "{number}");
        for curve in &found.curves {
            let told = SurfaceCurve::of(curve, surfaces, 1e-6).expect("what is known of it");
            assert!(told.is_proven && told.deviation <= 1e-6, "{number}: {}", told.deviation);
            assert_eq!(told.between, [CurveEnd::Closed; 2], "{number}");
            keeps_its_bounds(&told, surfaces);
            if number == 0 {
                let around = 1.2 * std::f64::consts::PI;
                let length = told.curve.length(told.curve.domain());
                assert!((length - around).abs() < 1e-5, "{length} for {around}");
            }
        }
    }
}
