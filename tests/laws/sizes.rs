//! Squares of the largest and the smallest coordinates are no numbers; what is asked of surfaces there
//! is answered as for moderate ones, or refused.

use glam::{DAffine3, DVec3};
use virote_kernel::{
    Curve, DomainError, Frame, GeomError, Grid, MeasureError, NurbsCurve, NurbsSurface, Side,
    Surface, Tolerance,
};

const SIZES: [f64; 8] = [1e-300, 1e-150, 1e-40, 1e-3, 1e3, 1e40, 1e150, 1e300];

fn by(factor: f64) -> DAffine3 {
    DAffine3::from_scale(DVec3::splat(factor))
}

fn hill() -> NurbsSurface {
    let height = |i: usize, j: usize| [[0.0, 0.3, 0.0], [0.2, 0.7, 0.0]][i][j];
    let net = Grid::from_fn(2, 3, |i, j| DVec3::new(i as f64, j as f64, height(i, j)));
    NurbsSurface::bezier(&net).unwrap()
}

/// A tolerance that is the same part of every size.
fn tolerance(size: f64) -> Tolerance {
    Tolerance::DEFAULT.with_distance(1e-6 * size)
}

fn agree(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * (1.0 + b.abs())
}

#[test]
fn a_surface_bends_alike_at_every_size() {
    let here = Surface::from(hill()).shape_at(0.3, 0.4).unwrap();
    for size in SIZES {
        let surface = Surface::from(hill().transformed(&by(size)));
        let found = surface.shape_at(0.3, 0.4).unwrap();
        assert!(found.normal().distance(here.normal()) < 1e-14, "{size:e}");
        assert!(surface.normal_at(0.3, 0.4).unwrap().distance(here.normal()) < 1e-14, "{size:e}");
        assert!(agree(found.mean() * size, here.mean()), "{size:e}");
        let [found, expected] = [found, here].map(|shape| shape.principal(Tolerance::DEFAULT));
        assert!(agree(found.k1 * size, expected.k1) && agree(found.k2 * size, expected.k2));
        assert!(found.d1.distance(expected.d1) < 1e-12, "{size:e}");
        assert_eq!(
            surface.kind_at(0.3, 0.4, tolerance(size)).unwrap(),
            Surface::from(hill()).kind_at(0.3, 0.4, Tolerance::DEFAULT).unwrap()
        );
        let second = surface.second_form_at(0.3, 0.4).unwrap();
        let plain = Surface::from(hill()).second_form_at(0.3, 0.4).unwrap();
        assert!((0..3).all(|i| agree(second[i] / size, plain[i])), "{size:e}");
    }
}

#[test]
fn squares_of_a_size_that_are_no_numbers_are_refused_and_no_zero() {
    let small = Surface::from(hill().transformed(&by(1e-300)));
    let refused = |found: Result<f64, GeomError>| {
        matches!(found, Err(GeomError::Measure(MeasureError::TooSmallToMeasure { .. })))
    };
    assert!(refused(small.first_form_at(0.3, 0.4).map(|form| form[0])));
    let large = Surface::from(hill().transformed(&by(1e300)));
    assert!(refused(large.gaussian_at(0.3, 0.4)));
    assert!(large.first_form_at(0.3, 0.4).unwrap()[0].is_infinite());
    assert!(small.gaussian_at(0.3, 0.4).unwrap().is_infinite());
    // What is flat has none, at any size.
    let flat = NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::new(1.0, 1.0, 0.0));
    let flat = Surface::from(flat.unwrap().transformed(&by(1e300)));
    assert_eq!(flat.gaussian_at(0.5, 0.5).unwrap().to_bits() << 1, 0);
}

#[test]
fn a_surface_of_any_size_has_its_area_and_its_poles() {
    for size in SIZES {
        assert!(hill().transformed(&by(size)).has_area(), "{size:e}");
        let sphere = NurbsSurface::sphere(Frame::XY, 1.0).unwrap().transformed(&by(size));
        let defects = Surface::from(sphere).defects(tolerance(size)).unwrap();
        assert_eq!((defects.collapsed.len(), defects.folds.len()), (2, 0), "{size:e}");
    }
}

#[test]
fn the_nearest_point_of_a_surface_is_the_same_at_every_size() {
    let p = DVec3::new(0.5, 0.5, 2.0);
    let here = hill().closest(p);
    for size in SIZES {
        let foot = hill().transformed(&by(size)).closest(p * size);
        assert!((0..2).all(|i| agree(foot.parameters[i], here.parameters[i])), "{size:e}");
        assert!(agree(foot.distance / size, here.distance), "{size:e}");
        assert!((foot.point / size).distance(here.point) < 1e-12, "{size:e}");
    }
}

#[test]
fn a_line_meets_a_surface_in_one_place_at_every_size() {
    let line = NurbsCurve::line(DVec3::new(0.5, 0.5, -1.0), DVec3::new(0.5, 0.7, 3.0)).unwrap();
    let here = Surface::from(hill()).piercings(&line.clone().into(), Tolerance::DEFAULT).unwrap();
    assert_eq!(here.len(), 1);
    for size in SIZES {
        let surface = Surface::from(hill().transformed(&by(size)));
        let line = Curve::from(line.transformed(&by(size)));
        let found = surface.piercings(&line, tolerance(size)).unwrap();
        assert_eq!(found.len(), 1, "{size:e}");
        assert!(agree(found[0].t, here[0].t), "{size:e}");
        assert!((found[0].point / size).distance(here[0].point) < 1e-12, "{size:e}");
    }
}

#[test]
fn spheres_and_planes_cut_circles_at_every_size() {
    let sphere = |x: f64| NurbsSurface::sphere(Frame::XY.at(DVec3::X * x), 1.0).unwrap();
    for size in SIZES {
        let [a, b] = [sphere(0.0), sphere(1.2)].map(|s| Surface::from(s.transformed(&by(size))));
        let total = |curves: &[NurbsCurve]| {
            curves.iter().map(|curve| curve.length(curve.domain()) / size).sum::<f64>()
        };
        let round = 1.6 * std::f64::consts::PI;
        let crossing = a.intersections(&b, tolerance(size)).unwrap();
        assert!((total(&crossing.curves) - round).abs() < 1e-4, "{size:e}");
        let section = a.section(Frame::XY.at(DVec3::Z * (0.6 * size)), tolerance(size)).unwrap();
        assert!((total(&section.curves) - round).abs() < 1e-4, "{size:e}");
        let isophotes = a.isophotes(DVec3::Z, &[libm::acos(0.6)], tolerance(size)).unwrap();
        assert!((total(&isophotes[0].curves) - round).abs() < 1e-4, "{size:e}");
    }
}

#[test]
fn a_refusal_names_the_place_where_it_is() {
    for size in SIZES {
        let square = Surface::from(
            NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::new(1.0, 1.0, 0.0))
                .unwrap()
                .transformed(&by(size)),
        );
        let found = square.intersections(&square, tolerance(size));
        let Err(GeomError::Picture(virote_kernel::PictureError::SurfacesRunTogether { point })) =
            found
        else {
            panic!("{size:e}: {found:?}");
        };
        let place = point / size;
        assert!(place.cmpge(DVec3::ZERO).all() && place.cmple(DVec3::ONE).all(), "{place}");
    }
}

#[test]
fn a_curve_turns_alike_at_every_size() {
    let corners =
        [DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0), DVec3::new(2.0, 0.0, 1.0), DVec3::Y * 3.0];
    let curve = NurbsCurve::bezier(&corners).unwrap();
    let torsion = |curve: NurbsCurve| {
        Curve::from(curve).local_at(0.3, Side::Right).and_then(|local| local.torsion()).unwrap()
    };
    for size in SIZES {
        let found = torsion(curve.transformed(&by(size)));
        assert!(agree(found * size, torsion(curve.clone())), "{size:e}: {found:e}");
    }
}

fn arch(size: f64) -> NurbsCurve {
    let points = [[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]];
    NurbsCurve::bezier(&points.map(|[x, y]| DVec3::new(x, y, 0.0) * size)).unwrap()
}

#[test]
fn what_stands_out_on_a_curve_is_found_at_every_size() {
    for size in SIZES {
        for tolerance in [tolerance(size), Tolerance::DEFAULT] {
            let curve = Curve::from(arch(size));
            assert_eq!(curve.extrema(DVec3::Y, tolerance).unwrap(), [0.5], "{size:e}");
            let corner = [DVec3::ZERO, DVec3::X, DVec3::ONE].map(|point| point * size);
            let corners = Curve::from(NurbsCurve::polyline(&corner).unwrap()).corners(tolerance);
            assert_eq!(corners.unwrap(), [1.0], "{size:e}");
        }
        let plane = Frame::XY.at(DVec3::ZERO);
        let upright = Frame::from_normal(DVec3::X * (0.5 * size), DVec3::X, None).unwrap();
        let curve = Curve::from(arch(size));
        let found = curve.plane_parameters(upright, tolerance(size)).unwrap();
        assert!(found.len() == 1 && (found[0] - 0.25).abs() < 1e-12, "{size:e}: {found:?}");
        assert_eq!(curve.plane_parameters(plane, tolerance(size)).unwrap(), [0.0, 1.0]);
    }
}

#[test]
fn a_corner_is_one_at_every_size() {
    for size in SIZES {
        let corner = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y].map(|point| point * size);
        let legs = [[0, 1], [1, 2]].map(|[a, b]| NurbsCurve::line(corner[a], corner[b]).unwrap());
        let [first, second] = legs.map(Curve::from);
        let joint = first.continuity_with(&second, tolerance(size)).unwrap();
        assert_eq!((joint.c, joint.g), (0, 0), "{size:e}");
        assert!((joint.angle - std::f64::consts::FRAC_PI_2).abs() < 1e-12, "{size:e}");
        let whole = Curve::from(NurbsCurve::polyline(&corner).unwrap());
        assert_eq!(whole.continuity(tolerance(size)).unwrap().g, 0, "{size:e}");
    }
    // A line that goes on as a circle: the leap of the curvature is 1 over the radius.
    for size in [1e-150, 1e150] {
        let line = NurbsCurve::line(DVec3::new(size, -size, 0.0), DVec3::X * size).unwrap();
        let arc = NurbsCurve::arc(Frame::XY, size, 0.0, 2.0).unwrap();
        let joint = Curve::from(line).continuity_with(&Curve::from(arc), tolerance(size)).unwrap();
        let gap = joint.curvature_gap.unwrap() * size;
        assert!(joint.g == 1 && (gap - 1.0).abs() < 1e-12, "{size:e}: {joint:?}");
    }
}

#[test]
fn a_line_pierces_what_is_large_for_its_tolerance() {
    for size in [1e9, 1e11, 1e13, 1e150] {
        let ball = Surface::from(NurbsSurface::sphere(Frame::XY, size).unwrap());
        let ends = [-2.0, 2.0].map(|x| DVec3::new(x, 0.0, 0.1) * size);
        let line = Curve::from(NurbsCurve::line(ends[0], ends[1]).unwrap());
        let found = ball.piercings(&line, Tolerance::DEFAULT).unwrap();
        assert_eq!(found.len(), 2, "{size:e}: {found:?}");
        let x = f64::sqrt(1.0 - 0.01) * size;
        assert!((found[1].point.x / x - 1.0).abs() < 1e-14, "{size:e}: {found:?}");
    }
}

#[test]
fn a_length_beyond_a_curve_is_refused_with_that_of_the_whole_at_every_size() {
    for size in SIZES {
        // Three sides of a triangle of 3, 4 and 5.
        let corners = [[0.0, 0.0], [3.0, 0.0], [3.0, 4.0], [0.0, 0.0]];
        let corners = corners.map(|[x, y]| DVec3::new(x, y, 0.0) * size);
        let curve = NurbsCurve::polyline(&corners).unwrap();
        let there = curve.point_at(curve.parameter_at_length(5.0 * size).unwrap());
        assert!((there / size).distance(DVec3::new(3.0, 2.0, 0.0)) < 1e-12, "{size:e}");
        match curve.parameter_at_length(13.0 * size) {
            Err(GeomError::Domain(DomainError::LengthOutside { got, total })) => {
                assert!(agree(got / size, 13.0) && agree(total / size, 12.0), "{size:e}");
            }
            other => panic!("{other:?} at {size:e}"),
        }
    }
}
