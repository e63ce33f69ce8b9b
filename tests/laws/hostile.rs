//! Whatever a constructor accepts can be asked anything: answers or errors, no panic and no hang.

use std::sync::Arc;

use glam::{DAffine3, DVec3};
use proptest::{collection::vec, prelude::Strategy, proptest, sample::select};
use virote_kernel::{
    Along, Approximator, CountError, Curve, Ends, FirstPass, Frame, GeomError, Grid, GridLines,
    Interpolator, Interval, KnotVector, LineFit, Lines, Mesh, NurbsCurve, NurbsSurface,
    Parametrization, PointSlopes, Side, Tolerance, VariedSurface, approximate, approximate_within,
    columns_within, find_trajectory, grid_mesh, join_patches, lagrange, make_compatible,
    surface_within, tessellate, tessellate_curve,
    work::{self, End, MemoryGauge, StopToken, Watch},
};

fn number() -> impl Strategy<Value = f64> {
    let tame = [0.0, -0.0, 1.0, 1.0, 1.0, 2.0, 0.5, -1.0, 1e-13];
    let wild = [1e-300, 5e-324, 1e300, -1e300, 1e8, f64::NAN, f64::INFINITY];
    (select(tame.to_vec()), select(wild.to_vec()), 0..12u32)
        .prop_map(|(tame, wild, which)| if which == 0 { wild } else { tame })
}

/// Sorted most of the time, so that many are accepted.
fn numbers(n: usize) -> impl Strategy<Value = Vec<f64>> {
    (vec(number(), n), 0..8u32).prop_map(|(mut numbers, which)| {
        if which > 0 {
            numbers.sort_by(f64::total_cmp);
        }
        numbers
    })
}

fn points(numbers: &[f64]) -> Vec<DVec3> {
    numbers.chunks_exact(3).map(DVec3::from_slice).collect()
}

fn ask_shape(curve: &Curve) {
    let (domain, tolerance) = (curve.domain(), Tolerance::DEFAULT);
    for t in [domain.start(), domain.end(), domain.at(0.3), f64::NAN, 1e300, -1e300] {
        if let Ok(local) = curve.local_at(t, Side::Left) {
            let _ = (local.frame(), local.torsion(), local.osculating_circle());
            let _ = (local.normal_plane(), local.signed_curvature(DVec3::Z, tolerance.angle));
        }
        let _ = curve.place_kind_at(t, tolerance);
    }
    let _ = (curve.is_straight(tolerance), curve.is_planar(tolerance), curve.is_closed(1e-6));
    let _ = (curve.continuity(tolerance), curve.continuity_with(curve, tolerance));
}

fn ask_curve(curve: &NurbsCurve) {
    ask_shape(&curve.clone().into());
    let domain = curve.domain();
    for t in [domain.start(), domain.end(), domain.at(0.3), f64::NAN, 1e300, -1e300] {
        let _ = (curve.point_at(t), curve.derivatives_at(t, 4));
        let _ = (curve.tangent_at(t, Side::Left), curve.tangent_at(t, Side::Right));
        let _ = (curve.split(t), curve.insert_knots(&[t, t]));
    }
    let _ = (curve.length(domain), curve.bounds(), curve.elevate_degree(curve.degree() + 2));
    let _ = (curve.decompose(), curve.clamped(), curve.trimmed(Interval::UNIT));
    let _ = (curve.reversed(), curve.reparametrized(Interval::UNIT).length(Interval::UNIT));
    let _ = tessellate_curve(curve, 1e-3, 1000);
    let _ = make_compatible(&[curve.clone(), curve.reversed()]);
    if let Ok(ruled) = NurbsSurface::ruled(curve, &curve.reversed()) {
        ask_surface(&ruled);
    }
}

fn ask_surface(surface: &NurbsSurface) {
    let (domain_u, domain_v) = (surface.domain_u(), surface.domain_v());
    for (u, v) in [(domain_u.start(), domain_v.end()), (domain_u.at(0.3), domain_v.at(0.5))] {
        let _ = (surface.point_at(u, v), surface.derivatives_at(u, v, 3));
        let _ = (surface.normal_at(u, v), surface.isocurve_u(u), surface.isocurve_v(v));
    }
    let _ = (surface.edges(), surface.bounds(), tessellate(surface, 1e-2, 1000));
    if let Ok(mesh) = grid_mesh(surface, 3, 2, 1000, 1) {
        let _ = (
            mesh.area(),
            mesh.volume(),
            mesh.bounds(),
            Mesh::merged(&[mesh.clone(), mesh.clone()], usize::MAX),
        );
        let _ = mesh.transformed(&DAffine3::from_scale(DVec3::new(1.0, 0.0, -1.0)));
    }
}

/// Whatever fits something to points, with lists of any lengths.
fn fit(points: &[DVec3], parameters: &[f64], degree: usize, n_control: usize) {
    let _ = approximate(points, parameters, degree, n_control);
    for are_fixed in [false, true] {
        let _ = approximate_within(points, parameters, degree, 1e-3, are_fixed);
    }
    let _ = KnotVector::spreading(degree, n_control, parameters);
    let _ = lagrange(points, parameters);
    let values: Vec<_> = points.iter().map(|point| point.extend(1.0)).collect();
    let ends = [Ends::Bessel, Ends::Natural, Ends::Quadratic, Ends::Clamped, Ends::NotAKnot];
    let ends = ends.into_iter().chain([Ends::Averaged]);
    let interpolators = ends
        .map(|ends| Interpolator::new(parameters, degree, ends))
        .chain(
            [true, false].map(|has| Interpolator::with_end_slopes(parameters, degree, [has, true])),
        )
        .chain([Interpolator::periodic(parameters, degree)])
        .chain([Interpolator::with_derivatives(parameters, degree)]);
    for interpolator in interpolators.flatten() {
        let _ = (interpolator.curve(points), interpolator.with_slopes(&values, &values));
        let _ = interpolator.curve_with_tangents(points, [DVec3::X; 2]);
        let _ = interpolator.with_slopes_at_ends(&values, [None, values.first().copied()]);
    }
    if let Ok(knots) = KnotVector::uniform_clamped(degree, n_control, 1.0)
        && let Ok(approximator) = Approximator::new(parameters, knots)
    {
        let _ = (approximator.curve(points), approximator.near(&values));
    }
    for rule in [Parametrization::Uniform, Parametrization::Chord, Parametrization::Foley] {
        let _ = (rule.parameters(points), rule.loose_parameters(points));
    }
    let _ = (NurbsCurve::hermite(points, &points[..points.len() / 2]), NurbsCurve::bezier(points));
    for is_closed in [false, true] {
        let _ = NurbsCurve::uniform(degree, points, is_closed);
        let _ = NurbsCurve::beta_spline(points, 1.0, 0.0, is_closed);
    }
}

/// The spline surface through a grid that grows about the origin, with its slopes.
fn slopes_of_grid(grid: &Grid<DVec3>, rule: Parametrization) -> Result<(), GeomError> {
    let (us, vs) = (rule.mean_parameters(&grid.transposed())?, rule.mean_parameters(grid)?);
    let lines =
        |parameters| GridLines { degree: 3, ends: Ends::Bessel, parameters, rule: Some(rule) };
    let fit = |of: &[f64]| Interpolator::new(of, 3, Ends::Bessel).map(LineFit::Through);
    let surface = Arc::new(FirstPass::new(grid, &fit(&us)?)?.second(&fit(&vs)?)?);
    let outward = grid.as_slice().iter().map(|point| point.extend(0.0)).collect();
    let slopes = PointSlopes::new(1, grid.as_slice().len(), vec![(0, outward)])?;
    let varied = VariedSurface::through_grid(&surface, [lines(&us), lines(&vs)], grid, &slopes)?;
    varied.map(|varied| varied.slopes().by_variable().len());
    Ok(())
}

/// Whatever fits something to a grid.
fn fit_grid(grid: &Grid<DVec3>, [u, v]: [&Lines; 2]) {
    for rule in [Parametrization::Uniform, Parametrization::Chord] {
        let _ = slopes_of_grid(grid, rule);
    }
    if let Ok(columns) = columns_within(grid, u, 1e-3) {
        let _ = surface_within(grid, [u, v], &columns, 1e-3);
        let _ = surface_within(&grid.transposed(), [v, u], &columns, 1e-3);
    }
}

proptest! {
    #[test]
    fn fits_of_any_lists(
        points in vec(number(), 0..24), parameters in numbers(6), n in 0..7usize, degree in 0..5usize, n_control in 0..8usize,
    ) {
        let places = self::points(&points);
        let n = n.min(parameters.len());
        fit(&places, &parameters[..n], degree, n_control);
        // As many as there are points, too.
        let even: Vec<f64> = (0..places.len()).map(|i| i as f64).collect();
        fit(&places, &even, degree, n_control);
    }

    #[test]
    fn fits_of_any_grids(
        places in vec(number(), 36), rows in 0..4usize, columns in 0..4usize, n in (0..5usize, 0..5usize), degree in 0..4usize,
    ) {
        let places = points(&places);
        let grid = Grid::from_fn(rows, columns, |i, j| places[3 * i + j]);
        let lines = |n: usize| Lines { parameters: (0..n).map(|i| i as f64).collect(), degree };
        fit_grid(&grid, [&lines(n.0), &lines(n.1)]);
        fit_grid(&grid, [&lines(rows), &lines(columns)]);
    }

    #[test]
    fn curves_of_any_numbers(
        degree in 0..5usize, knots in numbers(11), places in vec(number(), 30), weights in vec(number(), 10),
    ) {
        let n_points = 10 - degree;
        if let Ok(knots) = KnotVector::for_points(degree, n_points, knots) {
            let points = &points(&places)[..n_points];
            let weights = &weights[..n_points];
            let curves = [
                NurbsCurve::polynomial(knots.clone(), points),
                NurbsCurve::rational(knots.clone(), points, weights),
                NurbsCurve::new(
                    knots,
                    points.iter().zip(weights).map(|(point, &weight)| point.extend(weight)).collect(),
                ),
            ];
            curves.iter().flatten().for_each(ask_curve);
        }
    }

    #[test]
    fn surfaces_of_any_numbers(
        degree in 0..3usize, knots in numbers(6), places in vec(number(), 75), weights in vec(number(), 25),
    ) {
        let n = 5 - degree;
        if let Ok(knots) = KnotVector::for_points(degree, n, knots) {
            let points = Grid::new(n, n, points(&places)[..n * n].to_vec()).unwrap();
            let weights = Grid::new(n, n, weights[..n * n].to_vec()).unwrap();
            let surfaces = [
                NurbsSurface::polynomial(knots.clone(), knots.clone(), &points),
                NurbsSurface::rational(knots.clone(), knots, &points, &weights),
            ];
            surfaces.iter().flatten().for_each(ask_surface);
        }
    }

    #[test]
    fn meshes_of_any_numbers(places in vec(number(), 9), normals in vec(number(), 9), i in 0..4u32) {
        let mesh = Mesh::new(points(&places), points(&normals), Vec::new(), vec![[0, 1, i], [2, 1, 0]]);
        if let Ok(mesh) = mesh {
            let _ = (mesh.check(Tolerance::DEFAULT), mesh.check_solid(Tolerance::DEFAULT));
            let _ = (mesh.area_centroid(), mesh.volume_centroid());
            let _ = mesh.with_colors(points(&normals));
        }
    }
}

/// Within a thousandth of a second's work.
fn few_steps() -> Watch {
    let (gauge, stop) = (MemoryGauge::default(), StopToken::default());
    Watch { gauge, memory_bytes: usize::MAX, stop, steps: 1_000 }
}

#[test]
fn counts_beyond_all_ceilings_are_refused_at_once() {
    let refused = |found: Result<NurbsCurve, GeomError>| {
        matches!(found, Err(GeomError::Count(CountError::TooManyPoints { .. })))
    };
    let (points, at) = ([DVec3::ZERO, DVec3::X], [0.0, 1.0]);
    assert!(refused(NurbsCurve::arc(Frame::XY, 1.0, 0.0, 1e9)));
    assert!(refused(NurbsCurve::arc(Frame::XY, 1.0, 0.0, 1e300)));
    assert!(refused(NurbsCurve::helix(Frame::XY, 1.0, 1.0, 1e300, 1e-6)));
    assert!(refused(approximate(&points, &at, 1, usize::MAX)));
    for degree in [usize::MAX, 101] {
        assert!(KnotVector::bezier(degree).is_err());
        assert!(KnotVector::spreading(degree, usize::MAX, &at).is_err());
        assert!(Interpolator::periodic(&[0.0, 1.0, 2.0, 3.0], degree).is_ok());
        let lines = Lines { parameters: at.to_vec(), degree };
        assert!(columns_within(&Grid::from_fn(2, 2, |_, _| DVec3::X), &lines, 1e-3).is_err());
    }
    assert!(KnotVector::uniform(1, usize::MAX).is_err());
    assert!(KnotVector::uniform_clamped(1, usize::MAX, 1.0).is_err());
}

#[test]
fn an_arc_of_many_turns_can_be_ended() {
    let (found, done) = work::under(few_steps(), || NurbsCurve::arc(Frame::XY, 1.0, 0.0, 5e6));
    assert_eq!((found, done.end), (Err(GeomError::Ended), Some(End::Steps)));
}

#[test]
fn nothing_makes_nothing() {
    let none: Grid<NurbsSurface> = Grid::from_fn(0, 0, |_, _| unreachable!("it has no patch"));
    assert!(join_patches(&none, 1e-6).is_err());
    let rate = |_: f64, _: &[f64]| Ok::<_, ()>(vec![1.0]);
    let Ok(mut found) = find_trajectory(rate, &[0.0], [0.0, 1.0], 1e-6) else {
        unreachable!("a straight line")
    };
    found.nodes.truncate(1);
    assert_eq!(found.at(0.5), [0.0]);
    found.nodes.clear();
    assert_eq!(found.at(0.5), [0.0; 0]);
    assert!(NurbsCurve::of_trajectory(&found, usize::MAX).is_err());
    let untold = |_: f64, _: &[f64]| Ok::<_, ()>(Vec::new());
    assert!(find_trajectory(untold, &[0.0], [0.0, 1.0], 1e-6).is_err());
    assert!(Along::monotone(&[], true).is_err() && Along::monotone(&[0.0], false).is_err());
}
