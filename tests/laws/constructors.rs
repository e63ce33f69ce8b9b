//! Laws that hold for every construction of a curve, over a table of them all.

use std::f64::consts::TAU;

use glam::{DAffine3, DMat3, DVec3};
use proptest::{collection::vec, prelude::Strategy, prop_assert, proptest};
use virote_kernel::{
    CircleForm, Curve, Ends, Frame, GeomError, Interpolator, Interval, KnotVector, NurbsCurve,
    Parametrization, Side, Tolerance, approximate, approximate_within, lagrange,
};

use crate::some::{affine_map, are_near, fraction, parameter, point};

/// Points of each example, as many vectors and weights.
const N: usize = 8;

/// What a curve may be made of.
#[derive(Clone, Debug)]
struct Data {
    points: Vec<DVec3>,
    vectors: Vec<DVec3>,
    weights: Vec<f64>,
    /// Positive lengths and angles in turns.
    sizes: [f64; 3],
    frame: Frame,
}

impl Data {
    /// The same under an affine map, which vectors follow too.
    fn moved(&self, map: &DAffine3) -> Self {
        let points = self.points.iter().map(|&p| map.transform_point3(p)).collect();
        let vectors = self.vectors.iter().map(|&v| map.transform_vector3(v)).collect();
        Self { points, vectors, ..self.clone() }
    }

    fn values(&self) -> Vec<f64> {
        (0..N).map(|i| i as f64 * (1.0 + 0.05 * i as f64)).collect()
    }
}

fn data() -> impl Strategy<Value = Data> {
    let sizes = [0.5..4.0, 0.5..4.0, 0.05..0.95];
    (vec(point(), N), vec(point(), N), vec(0.2..5.0, N), sizes, point()).prop_map(
        |(points, vectors, weights, sizes, normal)| {
            let normal = if normal.length() < 0.1 { DVec3::Z } else { normal };
            let frame = Frame::from_normal(points[0], normal, None).unwrap();
            Data { points, vectors, weights, sizes, frame }
        },
    )
}

/// How a construction follows what its data do.
#[derive(Clone, Copy, PartialEq)]
enum Moves {
    /// Under every affine map.
    Affinely,
    /// Under motions and scaling.
    Similarly,
    /// It has places and sizes of its own, and no points.
    Alone,
}

/// What the points are to a curve.
#[derive(Clone, Copy, PartialEq)]
enum Points {
    /// It ends at the first and the last, and stays in their hull.
    Ends,
    /// It passes through all of them.
    Passes,
    /// They pull it.
    Pull,
    /// There are none.
    None,
}

struct Construction {
    name: &'static str,
    moves: Moves,
    points: Points,
    make: fn(&Data) -> Result<NurbsCurve, GeomError>,
}

fn knots(degree: usize, inner: &[f64]) -> KnotVector {
    let ends = |t: f64| vec![t; degree + 1];
    let knots = [ends(0.0), inner.to_vec(), ends(1.0)].concat();
    KnotVector::new(degree, knots).unwrap()
}

fn through(data: &Data, spacing: Parametrization, ends: Ends) -> Result<NurbsCurve, GeomError> {
    let parameters = spacing.parameters(&data.points)?;
    Interpolator::new(&parameters, 3, ends)?.curve(&data.points)
}

fn at_values(data: &Data, degree: usize, ends: Ends) -> Result<NurbsCurve, GeomError> {
    Interpolator::new(&data.values(), degree, ends)?.curve(&data.points)
}

fn circle(data: &Data, form: CircleForm) -> Result<NurbsCurve, GeomError> {
    NurbsCurve::ellipse(data.frame, [data.sizes[0]; 2], form)
}

/// A row of the table.
macro_rules! construction {
    ($name:literal, $moves:ident, $points:ident, $make:expr) => {
        Construction { name: $name, moves: Moves::$moves, points: Points::$points, make: $make }
    };
}

/// Every construction of a curve, with the choices that change how it works.
const ALL: &[Construction] = &[
    construction!("line", Affinely, Ends, |d| NurbsCurve::line(d.points[0], d.points[N - 1])),
    construction!("polyline", Affinely, Passes, |d| NurbsCurve::polyline(&d.points)),
    construction!("bezier", Affinely, Ends, |d| NurbsCurve::bezier(&d.points)),
    construction!("rational bezier", Affinely, Ends, |d| {
        NurbsCurve::rational(KnotVector::bezier(N - 1)?, &d.points, &d.weights)
    }),
    construction!("hermite", Affinely, Passes, |d| NurbsCurve::hermite(&d.points, &d.vectors)),
    construction!("coons_cubic", Affinely, Pull, |d| {
        NurbsCurve::uniform(3, &d.points[..4], false)
    }),
    construction!("coons_bspline", Affinely, Pull, |d| NurbsCurve::uniform(3, &d.points, false)),
    construction!("coons_bspline, closed", Affinely, Pull, |d| {
        NurbsCurve::uniform(3, &d.points, true)
    }),
    construction!("clamped", Affinely, Ends, |d| {
        NurbsCurve::polynomial(KnotVector::uniform_clamped(3, N, 5.0)?, &d.points)
    }),
    construction!("clamped of degree 5", Affinely, Ends, |d| {
        NurbsCurve::polynomial(KnotVector::uniform_clamped(5, N, 3.0)?, &d.points)
    }),
    construction!("bspline with a double knot", Affinely, Ends, |d| {
        NurbsCurve::polynomial(knots(3, &[0.2, 0.6, 0.6, 0.9]), &d.points)
    }),
    construction!("bspline, closed", Affinely, Pull, |d| NurbsCurve::uniform(4, &d.points, true)),
    construction!("nurbs", Affinely, Ends, |d| {
        NurbsCurve::rational(knots(2, &[0.1, 0.3, 0.5, 0.6, 0.8]), &d.points, &d.weights)
    }),
    construction!("beta_spline", Affinely, Pull, |d| {
        NurbsCurve::beta_spline(&d.points, d.sizes[0], d.sizes[1], false)
    }),
    construction!("beta_spline, closed", Affinely, Pull, |d| {
        NurbsCurve::beta_spline(&d.points, d.sizes[0], d.sizes[1], true)
    }),
    construction!("interpolate by chords", Similarly, Passes, |d| {
        through(d, Parametrization::Chord, Ends::Bessel)
    }),
    construction!("interpolate by roots of chords", Similarly, Passes, |d| {
        through(d, Parametrization::Centripetal, Ends::NotAKnot)
    }),
    construction!("interpolate by Foley", Similarly, Passes, |d| {
        through(d, Parametrization::Foley, Ends::Natural)
    }),
    construction!("interpolate uniformly", Affinely, Passes, |d| {
        through(d, Parametrization::Uniform, Ends::Quadratic)
    }),
    construction!("interpolate at parameters, degree 5", Affinely, Passes, |d| {
        at_values(d, 5, Ends::Averaged)
    }),
    construction!("interpolate with derivatives", Affinely, Passes, |d| {
        Interpolator::with_derivatives(&d.values(), 3)?
            .curve_with_derivatives(&d.points, &d.vectors)
    }),
    construction!("interpolate, closed", Affinely, Pull, |d| {
        let parameters: Vec<f64> = (0..=N).map(|i| i as f64).collect();
        Interpolator::periodic(&parameters, 3)?.curve(&d.points)
    }),
    construction!("cubic_spline", Affinely, Passes, |d| {
        let parameters: Vec<f64> = (0..N).map(|i| i as f64).collect();
        Interpolator::new(&parameters, 3, Ends::Clamped)?
            .curve_with_tangents(&d.points, [d.vectors[0], d.vectors[1]])
    }),
    construction!("lagrange", Affinely, Passes, |d| lagrange(&d.points, &d.values())),
    construction!("approximate by a count", Affinely, Ends, |d| {
        approximate(&d.points, &d.values(), 2, 5)
    }),
    construction!("polynomial", Affinely, None, |d| {
        // The first coefficient is a point, the others are vectors.
        let coefficients: Vec<DVec3> =
            [d.points[0]].into_iter().chain(d.vectors[..4].iter().copied()).collect();
        NurbsCurve::power_form(&coefficients, Interval::new(-1.0, 2.0)?)
    }),
    construction!("conic", Affinely, Ends, |d| {
        let ends = [d.points[0], d.points[1], d.points[N - 1]];
        NurbsCurve::rational(KnotVector::bezier(2)?, &ends, &[1.0, d.weights[0], 1.0])
    }),
    construction!("arc_through", Similarly, None, |d| {
        NurbsCurve::arc_through([d.points[0], d.points[1], d.points[2]], 1e-9)
    }),
    construction!("arc", Alone, None, |d| {
        NurbsCurve::arc(d.frame, d.sizes[0], d.sizes[1], d.sizes[2] * TAU)
    }),
    construction!("circle of nine points", Alone, None, |d| circle(d, CircleForm::NinePoint)),
    construction!("circle of a square", Alone, None, |d| circle(d, CircleForm::SevenSquare)),
    construction!("circle of a triangle", Alone, None, |d| circle(d, CircleForm::SevenTriangle)),
    construction!("circle of degree 5", Alone, None, |d| circle(d, CircleForm::DegreeFive)),
    construction!("ellipse", Alone, None, |d| {
        NurbsCurve::ellipse(d.frame, [d.sizes[0], d.sizes[1]], CircleForm::NinePoint)
    }),
    construction!("helix", Alone, None, |d| {
        NurbsCurve::helix(d.frame, d.sizes[0], d.sizes[1], d.sizes[2], 1e-6)
    }),
];

/// Every curve that can be made of the data.
fn every(data: &Data) -> impl Iterator<Item = (&'static Construction, NurbsCurve)> {
    ALL.iter().filter_map(|construction| {
        let curve = (construction.make)(data).ok()?;
        Some((construction, curve))
    })
}

/// The size of a curve's control points, about the first.
fn size(curve: &NurbsCurve) -> f64 {
    curve.points().iter().map(|p| p.length()).fold(1.0, f64::max)
}

/// The two ends of the domain, where the knots hold the curve at its end points.
fn clamped_ends(curve: &NurbsCurve) -> [bool; 2] {
    let (knots, p) = (curve.knots().as_slice(), curve.degree());
    let n = knots.len();
    [knots[p] <= knots[0], knots[n - 1] <= knots[n - 1 - p]]
}

proptest! {
    #[test]
    fn every_construction_makes_a_curve(data in data()) {
        let n_made = every(&data).count();
        prop_assert!(ALL.len() - 1 <= n_made, "{n_made} of {}", ALL.len());
    }

    #[test]
    fn ends_are_interpolated_with_the_first_leg_as_tangent(data in data()) {
        for (construction, curve) in every(&data) {
            let (points, weights) = (curve.points(), curve.weights());
            let (u, p, n) = (curve.knots().as_slice(), curve.degree(), points.len());
            let [start, end] = clamped_ends(&curve);
            let near = 1e-11 * size(&curve);
            if start {
                prop_assert!(curve.start().distance(points[0]) < near, "{}", construction.name);
                let factor = p as f64 / (u[p + 1] - u[1]) * weights[1] / weights[0];
                let slope = curve.derivatives_at(curve.domain().start(), 1)[1];
                let expected = (points[1] - points[0]) * factor;
                prop_assert!(slope.distance(expected) < near * factor, "{}", construction.name);
            }
            if end {
                prop_assert!(curve.end().distance(points[n - 1]) < near, "{}", construction.name);
                let width = u[n + p - 1] - u[n - 1];
                let factor = p as f64 / width * weights[n - 2] / weights[n - 1];
                let slope = curve.derivatives_at(curve.domain().end(), 1)[1];
                let expected = (points[n - 1] - points[n - 2]) * factor;
                prop_assert!(slope.distance(expected) < near * factor, "{}", construction.name);
            }
            if matches!(construction.points, Points::Ends | Points::Passes) {
                prop_assert!(curve.start().distance(data.points[0]) < near, "{}", construction.name);
                prop_assert!(curve.end().distance(data.points[N - 1]) < near, "{}", construction.name);
            }
        }
    }

    #[test]
    fn each_span_lies_in_the_hull_of_its_own_points(
        data in data(), f in fraction(), direction in point(),
    ) {
        for (construction, curve) in every(&data) {
            let t = parameter(&curve, f);
            let support = curve.knots().support(curve.knots().span_at(t));
            let along = |p: DVec3| p.dot(direction);
            let reach = curve.points()[support].iter().map(|&p| along(p)).fold(f64::NEG_INFINITY, f64::max);
            let slack = 1e-12 * size(&curve) * direction.length();
            prop_assert!(along(curve.point_at(t)) <= reach + slack, "{}", construction.name);
        }
    }

    #[test]
    fn no_plane_meets_it_more_often_than_its_control_polygon(
        data in data(), normal in point(), offset in -5.0..5.0,
    ) {
        let crossings = |points: &[DVec3]| {
            let sides: Vec<bool> = points.iter().map(|p| offset < p.dot(normal)).collect();
            sides.windows(2).filter(|pair| pair[0] != pair[1]).count()
        };
        for (construction, curve) in every(&data) {
            let of_curve = crossings(&curve.sample(300));
            let of_polygon = crossings(&curve.points());
            prop_assert!(of_curve <= of_polygon, "{}: {of_curve} {of_polygon}", construction.name);
        }
    }

    #[test]
    fn making_and_moving_commute(data in data(), map in affine_map(), f in fraction(), scale in 0.1..9.0) {
        let similar = DAffine3::from_translation(data.vectors[0])
            * DAffine3::from_axis_angle(data.frame.z(), data.sizes[0])
            * DAffine3::from_scale(DVec3::splat(scale));
        for (construction, curve) in every(&data) {
            let map = match construction.moves {
                Moves::Affinely => map,
                Moves::Similarly => similar,
                Moves::Alone => continue,
            };
            let Ok(made) = (construction.make)(&data.moved(&map)) else { continue };
            let moved = curve.transformed(&map);
            let t = parameter(&curve, f);
            let slack = 1e-9 * (size(&moved) + size(&made));
            let apart = made.point_at(parameter(&made, f)).distance(moved.point_at(t));
            prop_assert!(apart < slack, "{}: {apart}", construction.name);
        }
    }

    #[test]
    fn every_curve_goes_along_with_an_affine_map_point_by_point(
        data in data(), map in affine_map(), f in fraction(),
    ) {
        for (construction, curve) in every(&data) {
            let t = parameter(&curve, f);
            let expected = map.transform_point3(curve.point_at(t));
            let slack = 1e-12 * (size(&curve) * 20.0 + expected.length());
            let apart = curve.transformed(&map).point_at(t).distance(expected);
            prop_assert!(apart < slack, "{}: {apart}", construction.name);
        }
    }

    #[test]
    fn an_ellipse_is_the_affine_image_of_a_circle(data in data(), f in fraction()) {
        let [rx, ry, _] = data.sizes;
        let unit = NurbsCurve::ellipse(Frame::XY, [1.0; 2], CircleForm::NinePoint).unwrap();
        let axes = [data.frame.x() * rx, data.frame.y() * ry, data.frame.z()];
        let map = DAffine3 {
            matrix3: DMat3::from_cols(axes[0], axes[1], axes[2]),
            translation: data.frame.origin(),
        };
        let ellipse = NurbsCurve::ellipse(data.frame, [rx, ry], CircleForm::NinePoint).unwrap();
        prop_assert!(are_near(unit.transformed(&map).point_at(f), ellipse.point_at(f), 1e-14));
    }

    #[test]
    fn data_on_a_line_make_a_curve_on_it(mut data in data(), along in point(), f in fraction()) {
        let origin = data.points[0];
        let along = if along.length() < 0.1 { DVec3::ONE } else { along };
        for (i, point) in data.points.iter_mut().enumerate() {
            *point = origin + along * (data.weights[i] + i as f64);
        }
        for vector in &mut data.vectors {
            *vector = along * vector.x;
        }
        let (low, high) = data.points.iter().map(|p| (*p - origin).dot(along))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        for (construction, curve) in every(&data) {
            if construction.moves == Moves::Alone || construction.name == "arc_through" {
                continue;
            }
            let arm = curve.point_at(parameter(&curve, f)) - origin;
            let off = arm.cross(along).length() / along.length();
            prop_assert!(off < 1e-11 * size(&curve), "{}: {off}", construction.name);
            // What ends at its points or is pulled by them does not leave their segment.
            let stays = matches!(construction.points, Points::Ends | Points::Pull)
                && !construction.name.starts_with("interpolate")
                && !construction.name.starts_with("approximate");
            let slack = 1e-11 * size(&curve) * along.length();
            let place = arm.dot(along);
            prop_assert!(
                !stays || low - slack <= place && place <= high + slack, "{}", construction.name
            );
        }
    }

    #[test]
    fn basis_functions_are_a_partition_of_unity(data in data(), f in fraction()) {
        for (construction, curve) in every(&data) {
            let t = parameter(&curve, f);
            let values = curve.basis_at(t);
            prop_assert!((values.iter().sum::<f64>() - 1.0).abs() < 1e-13, "{}", construction.name);
            prop_assert!(values.iter().all(|&value| 0.0 <= value), "{}", construction.name);
            let blend: DVec3 = values.iter().zip(curve.points()).map(|(&n, p)| p * n).sum();
            let apart = curve.point_at(t).distance(blend);
            prop_assert!(apart < 1e-12 * size(&curve), "{}: {apart}", construction.name);
        }
    }

    #[test]
    fn a_control_point_moves_only_its_own_spans(data in data(), f in fraction(), which in 0..64usize) {
        for (construction, curve) in every(&data) {
            let mut points = curve.points();
            let i = which % points.len();
            points[i] += DVec3::new(1.0, -2.0, 3.0);
            let changed =
                NurbsCurve::rational(curve.knots().clone(), &points, &curve.weights()).unwrap();
            let (t, u) = (parameter(&curve, f), curve.knots().as_slice());
            let apart = curve.point_at(t).distance(changed.point_at(t));
            let is_inside = u[i] <= t && t <= u[i + curve.degree() + 1];
            prop_assert!(is_inside || apart < 1e-13 * size(&curve), "{}", construction.name);
        }
    }

    #[test]
    fn each_piece_is_the_bezier_curve_of_its_points(data in data(), f in fraction()) {
        for (construction, curve) in every(&data) {
            for piece in curve.decompose() {
                let knots = KnotVector::bezier(curve.degree()).unwrap();
                let bezier =
                    NurbsCurve::rational(knots, &piece.points(), &piece.weights()).unwrap();
                let t = parameter(&piece, 0.001 + 0.998 * f);
                let apart = bezier.point_at(0.001 + 0.998 * f).distance(curve.point_at(t));
                prop_assert!(apart < 1e-11 * size(&curve), "{}: {apart}", construction.name);
            }
        }
    }

    #[test]
    fn a_weight_pulls_to_its_point_and_without_one_the_point_is_gone(
        data in data(), which in 0..64usize,
    ) {
        for (construction, curve) in every(&data) {
            let (knots, points) = (curve.knots().clone(), curve.points());
            if points.len() < 3 || clamped_ends(&curve) != [true; 2] {
                continue;
            }
            let i = 1 + which % (points.len() - 2);
            let t = knots.greville()[i];
            let with = |weight: f64, points: &[DVec3]| {
                let mut weights = curve.weights();
                weights[i] = weight;
                NurbsCurve::rational(knots.clone(), points, &weights)
            };
            let pulled = with(1e12, &points).unwrap().point_at(t);
            prop_assert!(pulled.distance(points[i]) < 1e-6 * size(&curve), "{}", construction.name);
            let mut elsewhere = points.clone();
            elsewhere[i] += DVec3::new(5.0, -7.0, 9.0);
            // A weight may be all that a parameter has.
            let (Ok(a), Ok(b)) = (with(0.0, &points), with(0.0, &elsewhere)) else { continue };
            prop_assert!(a.point_at(t).distance(b.point_at(t)) < 1e-13 * size(&curve), "{}", construction.name);
        }
    }

    #[test]
    fn a_knot_of_multiplicity_s_leaves_all_but_s_derivatives(data in data()) {
        for (construction, curve) in every(&data) {
            let domain = curve.domain();
            for (t, times) in curve.knots().distinct() {
                if t <= domain.start() || domain.end() <= t {
                    continue;
                }
                let order = curve.degree().saturating_sub(times);
                let [left, right] =
                    [Side::Left, Side::Right].map(|side| curve.derivatives_beside(t, side, order));
                for k in 0..=order {
                    let scale = 1.0 + left[k].length().max(right[k].length());
                    let apart = left[k].distance(right[k]);
                    let slack = 1e-9 * scale * size(&curve);
                    prop_assert!(apart < slack, "{} at {t}, order {k}: {apart}", construction.name);
                }
            }
        }
    }

    #[test]
    fn continuity_tells_no_less_than_the_knots_promise(data in data()) {
        for (construction, curve) in every(&data) {
            let domain = curve.domain();
            let inner = curve.knots().distinct().into_iter()
                .filter(|&(t, _)| domain.start() < t && t < domain.end());
            let Some(most) = inner.map(|(_, times)| times).max() else { continue };
            if curve.is_closed(1e-6) {
                continue;
            }
            let promised = (curve.degree() as i32 - most as i32).min(3);
            let tolerance = Tolerance { distance: 1e-6, angle: 1e-6 };
            let told = Curve::from(curve).continuity(tolerance).unwrap();
            prop_assert!(promised <= told.c, "{}: {} of {promised}", construction.name, told.c);
        }
    }

    #[test]
    fn an_approximation_within_a_tolerance_keeps_it(data in data(), tolerance in 0.01..2.0) {
        let parameters = Parametrization::Chord.parameters(&data.points).unwrap();
        let curve = approximate_within(&data.points, &parameters, 3, tolerance, false).unwrap();
        for &point in &data.points {
            prop_assert!(curve.closest(point, 1e-9).distance <= tolerance * (1.0 + 1e-9));
        }
    }
}

#[test]
fn circles_are_rational_and_parabolas_are_not() {
    for form in CircleForm::ALL {
        let circle = NurbsCurve::ellipse(Frame::XY, [2.0; 2], form).unwrap();
        assert!(circle.is_rational(), "{form:?}");
        for point in circle.sample(1000) {
            assert!((point.length() - 2.0).abs() < 1e-14, "{form:?}");
        }
    }
    // y = x² as a conic of weight one.
    let points =
        [DVec3::new(-1.0, 1.0, 0.0), DVec3::new(0.0, -1.0, 0.0), DVec3::new(1.0, 1.0, 0.0)];
    let knots = KnotVector::bezier(2).unwrap();
    let parabola = NurbsCurve::rational(knots, &points, &[1.0; 3]).unwrap();
    assert!(!parabola.is_rational());
    for point in parabola.sample(1000) {
        assert!((point.y - point.x * point.x).abs() < 1e-15);
    }
}
