//! Polynomials through places by the least sum of magnitudes and by the least greatest magnitude: functions with narrow
//! valleys of kinks, whose least values linear programming tells.

use virote_kernel::{Answers, ConstrainedLeast, LeastEnd, LeastProblem, Wanted};

const FREE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// What is fitted at places at equal distances from zero on, and the least values of polynomials of degree 1 to 4: of the
/// sum of the magnitudes of what is left, and of the greatest one.
///
/// By the dual simplex method of HiGHS through `scipy.optimize.linprog`, with the equations of the vertex that it
/// ends in solved once more.
struct Fitted {
    function: fn(f64) -> f64,
    n_places: u32,
    width: f64,
    sums: [f64; 4],
    greatest: [f64; 4],
}

const FITTED: [Fitted; 4] = [
    Fitted {
        function: |k| 2.0 + 3.0 * k + libm::sin(k),
        n_places: 21,
        width: 20.0,
        sums: [13.004_205_068_312, 12.560_377_459_493, 12.492_884_099_391, 12.127_590_781_161],
        greatest: [0.994_986_503_855, 0.990_318_553_155, 0.990_007_838_445, 0.985_363_245_011],
    },
    Fitted {
        function: |k| libm::cos(k * k),
        n_places: 40,
        width: 10.0,
        sums: [22.289_559_386_258, 21.723_474_983_365, 21.682_172_083_495, 21.640_296_606_271],
        greatest: [0.990_777_470_724, 0.989_202_176_435, 0.985_916_998_343, 0.979_368_597_831],
    },
    Fitted {
        function: |k| k.sqrt() + libm::sin(3.0 * k),
        n_places: 13,
        width: 3.0,
        sums: [8.776_470_446_224, 7.978_771_453_670, 7.963_000_253_242, 7.314_965_865_777],
        greatest: [1.051_066_928_567, 0.989_189_367_988, 0.988_090_193_678, 0.981_282_474_456],
    },
    Fitted {
        function: |k| if 10.0 < k { 1.0 } else { 0.0 } + 0.1 * libm::cos(k),
        n_places: 60,
        width: 1.0,
        sums: [13.323_541_866_610, 9.635_943_785_694, 7.932_179_488_631, 7.788_954_511_322],
        greatest: [0.563_599_353_358, 0.514_999_372_136, 0.513_276_345_412, 0.494_687_850_980],
    },
];

/// How what is left at the places counts.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Counted {
    Sum,
    Greatest,
}

/// What holds the unknowns, none of which matters where the function is least.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Held {
    Free,
    Bounds,
    Condition,
}

/// The places' powers, each with the size of its unknown, and what is fitted.
fn rows(fitted: &Fitted, sizes: &[f64]) -> Vec<(Vec<f64>, f64)> {
    let row = |k: u32| {
        let at = fitted.width * f64::from(k) / f64::from(fitted.n_places - 1);
        let power = |(p, size): (usize, &f64)| size * libm::pow(at, p as f64);
        (sizes.iter().enumerate().map(power).collect(), (fitted.function)(f64::from(k)))
    };
    (0..fitted.n_places).map(row).collect()
}

fn value_and_slopes(rows: &[(Vec<f64>, f64)], x: &[f64], counted: Counted) -> (f64, Vec<f64>) {
    let (mut value, mut slopes) = (0.0_f64, vec![0.0; x.len()]);
    for (row, wanted) in rows {
        let rest = row.iter().zip(x).map(|(a, x)| a * x).sum::<f64>() - wanted;
        let side = if rest < 0.0 { -1.0 } else { 1.0 };
        if counted == Counted::Sum {
            value += rest.abs();
            slopes.iter_mut().zip(row).for_each(|(slope, part)| *slope += side * part);
        } else if value < rest.abs() {
            value = rest.abs();
            slopes = row.iter().map(|part| side * part).collect();
        }
    }
    (value, slopes)
}

fn found(
    rows: &[(Vec<f64>, f64)],
    counted: Counted,
    held: Held,
    start: &[f64],
) -> ConstrainedLeast {
    let answers = |x: &[f64], wanted: Wanted| {
        let (value, slopes) = value_and_slopes(rows, x, counted);
        let (mut values, mut gradients) = (vec![value], vec![slopes]);
        if held == Held::Condition {
            values.push(1e12 - x.iter().map(|x| x * x).sum::<f64>());
            gradients.push(x.iter().map(|x| -2.0 * x).collect());
        }
        let gradients = (wanted == Wanted::Gradients).then_some(gradients);
        Ok::<_, ()>(Answers { values, gradients })
    };
    let bound = if held == Held::Bounds { [-1e5, 1e5] } else { FREE };
    LeastProblem { start, bounds: &vec![bound; start.len()], n_equations: 0 }
        .find(answers)
        .expect("no failure")
}

#[track_caller]
fn check(sizes: &[f64], held: Held) {
    for (idx, fitted) in FITTED.iter().enumerate() {
        for degree in 1..=4 {
            let rows = rows(fitted, &sizes[..=degree]);
            for (counted, least) in [
                (Counted::Sum, fitted.sums[degree - 1]),
                (Counted::Greatest, fitted.greatest[degree - 1]),
            ] {
                for start in [0.0, 1.0, -7.0] {
                    let found = found(&rows, counted, held, &vec![start; degree + 1]);
                    let case = format!("{idx} by degree {degree}, {counted:?}, {held:?}, {start}");
                    assert_eq!(found.end, LeastEnd::Settled, "{case}: {found:?}");
                    assert!((found.values[0] - least).abs() < 1e-9, "{case}: {found:?}");
                    assert!(found.n_evaluations < 4000, "{case}: {}", found.n_evaluations);
                }
            }
        }
    }
}

#[test]
fn polynomials_fit_by_least_magnitudes() {
    for held in [Held::Free, Held::Bounds, Held::Condition] {
        check(&[1.0; 5], held);
    }
}

#[test]
fn polynomials_fit_by_least_magnitudes_in_unknowns_of_unlike_sizes() {
    check(&[1e3, 1e-2, 30.0, 0.1, 1e-3], Held::Free);
    check(&[1e-3, 2.0, 1e-2, 50.0, 3.0], Held::Free);
}

#[test]
fn exact_fits_leave_nothing() {
    let fitted = Fitted { function: |k| 2.0 + 3.0 * k - k * k, width: 20.0, ..FITTED[0] };
    for counted in [Counted::Sum, Counted::Greatest] {
        for held in [Held::Free, Held::Bounds, Held::Condition] {
            let found = found(&rows(&fitted, &[1.0; 4]), counted, held, &[0.0; 4]);
            assert_eq!(found.end, LeastEnd::Settled, "{counted:?}, {held:?}: {found:?}");
            assert!(found.values[0] < 1e-9, "{counted:?}, {held:?}: {found:?}");
        }
    }
}

#[test]
fn polynomials_fitted_without_derivatives_are_right_or_refused() {
    let mut n_told = 0;
    for (idx, fitted) in FITTED.iter().enumerate() {
        for degree in 1..=4 {
            let rows = rows(fitted, &[1.0; 5][..=degree]);
            for (counted, least) in [
                (Counted::Sum, fitted.sums[degree - 1]),
                (Counted::Greatest, fitted.greatest[degree - 1]),
            ] {
                for start in [0.0, 1.0, -7.0] {
                    let start = vec![start; degree + 1];
                    let value = |x: &[f64], _| {
                        Ok::<_, ()>(Answers::from(vec![value_and_slopes(&rows, x, counted).0]))
                    };
                    let bounds = vec![FREE; start.len()];
                    let problem = LeastProblem { start: &start, bounds: &bounds, n_equations: 0 };
                    let found = problem.find(value).expect("no failure");
                    let is_told = found.end == LeastEnd::Settled;
                    let case = format!("{idx} by degree {degree}, {counted:?}, {start:?}");
                    let fall = value_and_slopes(&rows, &start, counted).0 - least;
                    let off = found.values[0] - least;
                    assert!(!is_told || off < 1e-6 + 1e-10 * fall, "{case}: {found:?}");
                    n_told += usize::from(is_told);
                }
            }
        }
    }
    assert!(30 <= n_told, "{n_told}");
}
