//! Trajectories beside closed forms: within the tolerance everywhere, with the derivative that the field tells.

use virote_kernel::{NurbsCurve, Trajectory, TrajectoryError, find_integral, find_trajectory};

type Field = fn(f64, &[f64]) -> Vec<f64>;
type Solution = fn(f64) -> Vec<f64>;

/// Fields with their solutions over a range.
const FIELDS: [(&str, Field, Solution, [f64; 2]); 14] = [
    ("a circle", |_, p| vec![-p[1], p[0]], |t| vec![libm::cos(t), libm::sin(t)], [0.0, 20.0]),
    ("growth", |_, p| vec![p[0]], |t| vec![libm::exp(t)], [0.0, 6.0]),
    ("decay", |_, p| vec![-3.0 * p[0]], |t| vec![libm::exp(-3.0 * t)], [0.0, 9.0]),
    ("a parabola", |t, _| vec![2.0 * t], |t| vec![t * t], [-3.0, 4.0]),
    ("rest", |_, _| vec![0.0], |_| vec![0.7], [0.0, 1.0]),
    (
        "logistic",
        |_, p| vec![p[0] * (1.0 - p[0])],
        |t| vec![1.0 / (1.0 + libm::exp(-t))],
        [-8.0, 8.0],
    ),
    ("a hyperbola", |_, p| vec![p[0] * p[0]], |t| vec![1.0 / (1.0 - t)], [0.0, 0.999]),
    ("a bell", |t, p| vec![-2.0 * t * p[0]], |t| vec![libm::exp(-t * t)], [-4.0, 4.0]),
    ("a root", |_, p| vec![0.5 / p[0]], |t| vec![t.sqrt()], [1e-3, 5.0]),
    (
        "a spiral",
        |_, p| vec![p[0] - 9.0 * p[1], 9.0 * p[0] + p[1]],
        |t| vec![libm::exp(t) * libm::cos(9.0 * t), libm::exp(t) * libm::sin(9.0 * t)],
        [0.0, 3.0],
    ),
    (
        "a narrow bend",
        |t, _| vec![1.0 / (1.0 + 1e4 * t * t)],
        |t| vec![libm::atan(100.0 * t) / 100.0],
        [-1.0, 2.0],
    ),
    (
        "a corner",
        |t, _| vec![if t < 0.3 { -1.0 } else { 1.0 }],
        |t| vec![(t - 0.3).abs()],
        [-1.0, 1.0],
    ),
    (
        "what fades",
        |t, p| vec![-200.0 * (p[0] - libm::cos(t)) - libm::sin(t)],
        libm_cos,
        [0.0, 10.0],
    ),
    (
        "far away",
        |t, p| vec![libm::cos(t - 1e6) + 0.0 * p[0]],
        |t| vec![libm::sin(t - 1e6)],
        [1e6, 1e6 + 7.0],
    ),
];

fn libm_cos(t: f64) -> Vec<f64> {
    vec![libm::cos(t)]
}

fn found(
    field: Field,
    start: &[f64],
    range: [f64; 2],
    tolerance: f64,
) -> Result<Trajectory, TrajectoryError<()>> {
    find_trajectory(|t, p| Ok(field(t, p)), start, range, tolerance)
}

#[test]
fn trajectories_are_within_their_tolerance_of_closed_forms() {
    for (name, field, solution, range) in FIELDS {
        for tolerance in [1e-3, 1e-6, 1e-9] {
            let trajectory = found(field, &solution(range[0]), range, tolerance).unwrap();
            assert!(trajectory.error <= tolerance, "{name}: {}", trajectory.error);
            let curve = NurbsCurve::of_trajectory(&trajectory, 0).unwrap();
            for i in 0..=1000 {
                let t = range[0] + (range[1] - range[0]) * f64::from(i) / 1000.0;
                let (state, point) = (trajectory.at(t), curve.point_at(t));
                for (idx, (part, exact)) in state.iter().zip(solution(t)).enumerate() {
                    assert!(
                        (part - exact).abs() <= tolerance,
                        "{name} at {t}: {part}, not {exact}"
                    );
                    let rounding = 1e-13 * (1.0 + exact.abs());
                    assert!((part - point[idx]).abs() < rounding, "{name}: {part}, {point}");
                }
            }
        }
    }
}

#[test]
fn a_trajectory_has_the_derivatives_that_the_field_tells() {
    for (name, field, solution, range) in FIELDS {
        // The corner has no second derivative, and what fades amplifies the rest.
        if ["a corner", "what fades"].contains(&name) {
            continue;
        }
        let trajectory = found(field, &solution(range[0]), range, 1e-9).unwrap();
        let curve = NurbsCurve::of_trajectory(&trajectory, 0).unwrap();
        for node in &trajectory.nodes {
            let told = field(node.place, &node.state);
            let own = curve.derivatives_at(node.place, 1)[1];
            let size = told.iter().fold(1.0, |size: f64, part| size.max(part.abs()));
            let is_near =
                told.iter().enumerate().all(|(i, part)| (part - own[i]).abs() < 1e-9 * size);
            assert!(is_near, "{name} at {}: {own}, not {told:?}", node.place);
        }
        let inner = curve.knots().distinct();
        assert!(inner.iter().skip(1).rev().skip(1).all(|(_, times)| *times == 3), "{name} is C2");
    }
}

#[test]
fn a_clothoid_ends_where_fresnels_integrals_do() {
    let rate = |s: f64, p: &[f64]| Ok::<_, ()>(vec![libm::cos(p[2]), libm::sin(p[2]), s]);
    let trajectory = find_trajectory(rate, &[0.0; 3], [0.0, 8.0], 1e-10).unwrap();
    for end in [0.5, 3.0, 8.0] {
        let integrand = |s: f64| Ok::<_, ()>(vec![libm::cos(0.5 * s * s), libm::sin(0.5 * s * s)]);
        let exact = find_integral(integrand, [0.0, end], 1e-14, 0.0).unwrap().value;
        let state = trajectory.at(end);
        assert!((state[0] - exact[0]).abs() < 1e-10 && (state[1] - exact[1]).abs() < 1e-10);
        assert!((state[2] - 0.5 * end * end).abs() < 1e-10);
    }
}

#[test]
fn a_smaller_tolerance_takes_more_steps_as_an_order_of_five_does() {
    let (_, field, solution, range) = FIELDS[0];
    let [rough, fine] = [1e-4, 1e-9].map(|tolerance| {
        found(field, &solution(range[0]), range, tolerance).unwrap().nodes.len() as f64
    });
    // A hundred thousandth of the error, a tenth of the width.
    assert!((6.0..14.0).contains(&(fine / rough)), "{rough}, then {fine}");
}

#[test]
fn what_has_no_trajectory_is_refused_where_it_ends() {
    // To infinity in finite time, from two sides.
    let blow_up = found(|_, p| vec![1.0 + p[0] * p[0]], &[0.0], [0.0, 2.0], 1e-6);
    assert!(
        matches!(&blow_up, Err(TrajectoryError::Ends { at, .. })
            if (at - std::f64::consts::FRAC_PI_2).abs() < 1e-6),
        "{blow_up:?}"
    );
    // A rate that always points back: it cannot be left, and no step stays on it.
    let trapped = found(|_, p| vec![if p[0] < 0.0 { 1.0 } else { -1.0 }], &[0.5], [0.0, 2.0], 1e-9);
    let is_at = |at: f64| 0.49 < at && at < 0.51;
    assert!(
        matches!(trapped, Err(TrajectoryError::Long { at, .. } | TrajectoryError::Ends { at, .. }) if is_at(at)),
        "{trapped:?}"
    );
    let stiff = found(|_, p| vec![-1e6 * (p[0] - 1.0)], &[1.1], [0.0, 10.0], 1e-6);
    assert!(matches!(stiff, Err(TrajectoryError::Long { is_stiff: true, .. })), "{stiff:?}");
    // Lorenz's weather, beyond what any digits tell.
    let weather: Field = |_, p| {
        vec![10.0 * (p[1] - p[0]), p[0] * (28.0 - p[2]) - p[1], p[0] * p[1] - 8.0 / 3.0 * p[2]]
    };
    let chaos = found(weather, &[1.0, 1.0, 1.0], [0.0, 100.0], 1e-6);
    assert!(matches!(chaos, Err(TrajectoryError::Unsettled { .. })), "{chaos:?}");
}
