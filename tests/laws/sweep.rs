//! Laws of sections along paths.

use glam::{DAffine3, DQuat, DVec3};
use proptest::{collection::vec, prelude::Strategy, prop_assert, proptest};
use virote_kernel::{
    CircleForm, Columns, Ends, FrameRule, Frames, GeomError, Interpolator, KnotVector, Motion,
    NurbsCurve, Parametrization, PlacedAxes, Sweep, SweepResolution, swept, translated,
};

use crate::some::{are_near, curve, fraction, point};

/// A section that is only carried along.
struct Still;

impl Motion for Still {
    fn scale(&mut self, _: f64) -> Result<DVec3, GeomError> {
        Ok(DVec3::ONE)
    }

    fn twist(&mut self, _: f64) -> Result<f64, GeomError> {
        Ok(0.0)
    }

    fn upwards(&mut self, _: f64, _: DVec3, _: DVec3) -> Result<Option<DVec3>, GeomError> {
        Ok(None)
    }

    fn held(&mut self, _: f64, _: DVec3, _: DVec3) -> Result<Option<PlacedAxes>, GeomError> {
        Ok(None)
    }
}

/// A path that leads on and bends gently.
fn path() -> impl Strategy<Value = NurbsCurve> {
    vec(point(), 4..7).prop_map(|points| {
        let at = |(k, p): (usize, &DVec3)| 0.2 * *p + DVec3::X * (8.0 * k as f64);
        let points: Vec<DVec3> = points.iter().enumerate().map(at).collect();
        let parameters = Parametrization::Chord.parameters(&points).unwrap();
        Interpolator::new(&parameters, 3, Ends::Averaged).unwrap().curve(&points).unwrap()
    })
}

const TOLERANCE: f64 = 1e-6;

/// A ring about the x axis.
fn ring() -> NurbsCurve {
    NurbsCurve::circle(DVec3::ZERO, 0.1, DVec3::Y, DVec3::X, CircleForm::NinePoint).unwrap()
}

fn pipe(path: &NurbsCurve, up: DVec3) -> Sweep {
    let frames = Frames::new(path, FrameRule::RotationMinimizing, up, false).unwrap();
    let fineness = SweepResolution {
        n_sections: None,
        tolerance: TOLERANCE,
        keeps_path: true,
        columns: Columns::Through,
    };
    swept(&ring(), path, &frames, &mut Still, &[], fineness).unwrap()
}

proptest! {
    #[test]
    fn a_translated_section_is_the_sum_of_section_and_path(
        section in curve(), path in curve(), f in fraction(), g in fraction(),
    ) {
        let surface = translated(&section, &path).unwrap();
        let (u, v) = (section.domain().at(f), path.domain().at(g));
        let sum = section.point_at(u) + path.point_at(v);
        prop_assert!(are_near(surface.point_at(u, v), sum, 1e-11));
    }
}

proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig::with_cases(24))]

    #[test]
    fn a_pipe_keeps_its_radius(path in path(), f in 0.0..1.0, u in 0.0..1.0) {
        let made = pipe(&path, DVec3::Z);
        let t = path.domain().at(f);
        let apart = made.surface.point_at(u, t).distance(path.point_at(t));
        prop_assert!((apart - 0.1).abs() <= TOLERANCE);
        prop_assert!(made.deviation.0 <= TOLERANCE);
    }

    #[test]
    fn sweeping_and_moving_commute(path in path(), axis in point(), angle in 0.0..6.0, by in point(), f in 0.0..1.0, u in 0.0..1.0) {
        let map = DAffine3::from_rotation_translation(DQuat::from_axis_angle((axis + DVec3::Z * 20.0).normalize(), angle), by);
        let (here, there) = (pipe(&path, DVec3::Z), pipe(&path.transformed(&map), map.transform_vector3(DVec3::Z)));
        let t = path.domain().at(f);
        let moved = map.transform_point3(here.surface.point_at(u, t));
        prop_assert!(moved.distance(there.surface.point_at(u, t)) <= 2.0 * TOLERANCE);
    }

    #[test]
    fn a_rotation_minimizing_frame_does_not_turn_about_the_path(path in path(), f in 0.01..0.99) {
        let frames = Frames::new(&path, FrameRule::RotationMinimizing, DVec3::Z, false).unwrap();
        let (t, h) = (path.domain().at(f), 1e-4 * path.domain().length());
        let [before, here, behind] = [t - h, t, t + h].map(|t| frames.at(t).unwrap());
        prop_assert!((here.x.dot(here.z)).abs() < 1e-12 && (here.z.length() - 1.0).abs() < 1e-12);
        // The change of z is along x.
        prop_assert!((behind.z - before.z).dot(here.y).abs() < 1e-7);
    }
}

/// A binormal that turns fast, by more than a right angle between two places of the first look, does not
/// turn around; that of a plane S does.
#[test]
fn a_frame_that_turns_fast_is_no_flip() -> Result<(), GeomError> {
    let turning =
        [[0.0, 0.0, 0.0], [1.0, 2.0, 1.0], [2.0, -2.0, 0.0], [3.0, 0.0, 1.0], [4.0, 1.0, 0.0]];
    let plane = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [2.0, -2.0, 0.0], [3.0, 0.0, 0.0]];
    let flips = |points: &[[f64; 3]]| {
        let path = NurbsCurve::bezier(&points.iter().map(|&p| DVec3::from(p)).collect::<Vec<_>>())?;
        Frames::new(&path, FrameRule::Frenet, DVec3::Z, false).map(|frames| frames.flips().to_vec())
    };
    assert!(flips(&turning)?.is_empty());
    let found = flips(&plane)?;
    assert!(found.len() == 1 && found[0][0] <= 0.5 && 0.5 <= found[0][1], "{found:?}");
    Ok(())
}

/// A frame that jumps, at a knot of a path of degree 2 by any angle, jumps at one place: beside it the surface is
/// where its report says, and nowhere does it leave the reach of its section.
#[test]
fn a_frenet_frame_that_jumps_leaves_the_surface_within_reach() {
    let paths: [&[[f64; 3]]; 3] = [
        &[[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [3.0, -2.0, 0.0], [4.0, 0.0, 0.0]],
        &[
            [0.0, 0.0, 0.0],
            [1.0, 2.0, 0.0],
            [3.0, -2.0, 1.0],
            [4.0, 0.0, 0.0],
            [5.0, 1.0, 1.0],
            [3.0, 3.0, 3.0],
        ],
        &[[0.0, 0.0, 0.0], [1.0, 0.0, 1.0], [2.0, 2.0, 0.0], [3.0, 0.0, 0.5], [5.0, 1.0, 3.0]],
    ];
    let section = NurbsCurve::line(DVec3::Z * 0.1, DVec3::new(0.0, 0.1, 0.1)).unwrap();
    for (points, degree) in paths.into_iter().flat_map(|points| [(points, 2), (points, 3)]) {
        let points: Vec<DVec3> = points.iter().map(|&p| DVec3::from(p)).collect();
        let knots = KnotVector::uniform_clamped(degree, points.len(), 1.0).unwrap();
        let path = NurbsCurve::polynomial(knots, &points).unwrap();
        let frames = Frames::new(&path, FrameRule::Frenet, DVec3::Z, false).unwrap();
        for (columns, keeps_path) in
            [(Columns::Through, true), (Columns::Through, false), (Columns::Offset, true)]
        {
            let resolution =
                SweepResolution { columns, keeps_path, ..SweepResolution::within(1e-4) };
            let made = swept(&section, &path, &frames, &mut Still, &[], resolution).unwrap();
            assert!(made.deviation.0 <= 1e-4, "{:?}", made.deviation);
            for k in 0..=500 {
                let t = f64::from(k) / 500.0;
                let found = made.surface.point_at(0.0, t);
                let axes = frames.at(t).unwrap();
                let wanted = path.point_at(t) + axes.z * 0.1;
                let is_turning = frames.flips().iter().any(|flip| flip[0] <= t && t <= flip[1]);
                let allowed = if is_turning { 0.25 } else { 1e-4 };
                assert!(found.distance(wanted) <= allowed, "{columns:?} {degree} at {t}: {found}");
            }
            for &[before, behind] in frames.flips() {
                for t in (0..=50).map(|k| before + (behind - before) * f64::from(k) / 50.0) {
                    let away = made.surface.point_at(0.0, t).distance(path.point_at(t));
                    assert!(away < 0.2, "{columns:?} {degree} at {t}: {away}");
                }
            }
        }
    }
}
