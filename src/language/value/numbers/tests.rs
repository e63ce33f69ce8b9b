//! Values beside those that are a step away, and what they say of their numbers.

use super::{
    super::{
        Dimension, Record,
        variation::{are_alike, has_moving_knots, moved, sizes, with_form_of},
    },
    *,
};
use crate::kernel::KnotVector;

const N_VARIABLES: usize = 3;

fn jet(value: f64, slopes: [f64; N_VARIABLES]) -> Jet {
    Jet::with_slopes(value, &slopes).expect("finite numbers")
}

fn length(value: Real) -> Number<Real> {
    Number { value, dim: Dimension::LENGTH }
}

fn point(k: usize) -> DVec3 {
    DVec3::new(k as f64, 0.5 - k as f64, 0.25 * (k * k) as f64)
}

/// Slopes of points, of which the second variable moves none.
fn point_slopes(n_points: usize) -> PointSlopes {
    let of = |factor: f64| -> Vec<DVec4> {
        (0..n_points).map(|k| (point(k + 1) * factor).extend(0.0)).collect()
    };
    PointSlopes::new(N_VARIABLES, n_points, vec![(0, of(2.0)), (2, of(-0.5))]).expect("slopes")
}

fn curve(n_points: usize) -> Arc<NurbsCurve> {
    let points: Vec<DVec3> = (0..n_points).map(point).collect();
    Arc::new(NurbsCurve::polyline(&points).expect("a polygon"))
}

fn surface() -> Arc<NurbsSurface> {
    let net = Grid::from_fn(2, 3, |i, j| point(3 * i + j));
    Arc::new(NurbsSurface::bezier(&net).expect("a surface"))
}

fn varied_curve(n_points: usize) -> Value {
    let varied = VariedCurve::new(curve(n_points), point_slopes(n_points)).expect("slopes");
    Value::JetCurve(Arc::new(varied))
}

/// A value of every kind that can be differentiated, beside plain ones.
fn values() -> Vec<Value> {
    let plain = |value: f64| length(Real::Plain(value)).into_value();
    let jet_point = [jet(1.0, [0.0, 2.0, 0.0]), jet(-2.0, [0.5, 0.0, 0.0]), jet(0.0, [0.0; 3])];
    let range = JetRange {
        start: length(Real::Plain(1.0)),
        end: length(Real::Jet(jet(4.0, [0.0, 0.0, -1.0]))),
        closed: true,
    };
    let varied = VariedSurface::new(surface(), point_slopes(6)).expect("slopes");
    vec![
        plain(7.0),
        length(Real::Jet(jet(3.0, [1.0, 0.0, -4.0]))).into_value(),
        Value::JetPoint(jet_point.clone().into()),
        Value::JetRange(Arc::new(range)),
        Value::list(vec![plain(1.0), plain(2.0)]),
        Value::list(vec![Value::Point(point(3)), Value::JetPoint(jet_point.into())]),
        Value::list(vec![varied_curve(3), Value::Curve(Curve::Nurbs(curve(4))), plain(5.0)]),
        Value::JetSurface(Arc::new(varied)),
        Value::Record(Arc::new(Record::new([
            (Arc::from("a"), length(Real::Jet(jet(-1.0, [0.0, 8.0, 0.0]))).into_value()),
            (Arc::from("b"), Value::Bool(true)),
            (Arc::from("c"), Value::list(vec![varied_curve(2)])),
        ]))),
    ]
}

fn numbers_of(values: &[Value]) -> Vec<f64> {
    let mut all = Vec::new();
    values.iter().for_each(|value| numbers(value, &mut all));
    all
}

fn moved_by(values: &[Value], steps: &[(usize, f64)]) -> Vec<Value> {
    values.iter().map(|value| moved(value, steps).expect("room to move")).collect()
}

fn all_slopes(values: &[Value]) -> (usize, Vec<SparseNumbers>) {
    let mut all = vec![Vec::new(); N_VARIABLES];
    let n = values.iter().fold(0, |behind, value| slopes(value, behind, &mut all));
    (n, all)
}

#[test]
fn numbers_grow_by_their_slopes() {
    let values = values();
    let held = numbers_of(&moved_by(&values, &[]));
    let (n, all) = all_slopes(&values);
    assert_eq!(n, held.len());
    for (variable, slopes) in all.iter().enumerate() {
        assert!(!slopes.is_empty() && slopes.windows(2).all(|pair| pair[0].0 < pair[1].0));
        let there = moved_by(&values, &[(variable, 0.5)]);
        assert!(there.iter().zip(&moved_by(&values, &[])).all(|(a, b)| are_alike(a, b)));
        let mut expected = held.clone();
        slopes.iter().for_each(|(at, slope)| expected[*at] += 0.5 * slope);
        assert_eq!(numbers_of(&there), expected);
    }
    let several = numbers_of(&moved_by(&values, &[(0, 1.0), (1, -2.0), (2, 0.25)]));
    let mut expected = held;
    for (slopes, step) in all.iter().zip([1.0, -2.0, 0.25]) {
        slopes.iter().for_each(|(at, slope)| expected[*at] += step * slope);
    }
    assert_eq!(several, expected);
}

#[test]
fn values_with_their_slopes_again_are_what_they_were() {
    let values = values();
    let (_, all) = all_slopes(&values);
    let by_variable: Vec<(usize, SparseNumbers)> = all.iter().cloned().enumerate().collect();
    let held = moved_by(&values, &[]);
    let mut handed_out = NumberSlopes::new(N_VARIABLES, &by_variable);
    let again: Option<Vec<Value>> = held.iter().map(|value| handed_out.value(value)).collect();
    let again = again.expect("numbers alone");
    assert_eq!(all_slopes(&again), all_slopes(&values));
    assert_eq!(numbers_of(&moved_by(&again, &[])), numbers_of(&held));
    for (value, again) in values.iter().zip(&again) {
        assert_eq!(value.is_jet(), again.is_jet());
        assert!(!has_moving_knots(value));
        let Some(formed) = with_form_of(again, &moved(value, &[]).expect("the value")) else {
            assert!(matches!(value, Value::JetRange(_)));
            continue;
        };
        let mut formed_slopes = vec![Vec::new(); N_VARIABLES];
        let mut own_slopes = formed_slopes.clone();
        slopes(&formed, 0, &mut formed_slopes);
        slopes(value, 0, &mut own_slopes);
        assert_eq!(formed_slopes, own_slopes);
    }
}

#[test]
fn points_stand_in_the_rows_and_columns_of_their_nets() {
    let held = moved_by(&values(), &[]);
    let places = NumberPlaces::of(&held);
    let all = numbers_of(&held);
    assert_eq!(places.numbers.len(), all.len());
    assert_eq!(
        places.nets.iter().map(|net| net.size).collect::<Vec<_>>(),
        [[1, 1], [2, 1], [3, 1], [4, 1], [2, 3], [2, 1]]
    );
    let lists: Vec<Option<usize>> = places.nets.iter().map(|net| net.list).collect();
    assert!(lists[2].is_some() && lists[2] == lists[3] && lists[5].is_some());
    assert!(lists[5] != lists[2] && [lists[0], lists[1], lists[4]] == [None; 3]);
    assert!(places.has_lists() && !NumberPlaces::of(&held[7..]).has_lists());
    for (point, &first) in places.points.iter().enumerate() {
        match places.in_net(point) {
            Some((net, [row, column])) => {
                let PointNet { size: [n_rows, n_columns], first, .. } = places.nets[net];
                assert!(row < n_rows && column < n_columns);
                assert_eq!(first + row * n_columns + column, point);
            }
            None => assert_eq!(places.numbers[first], (OTHER_NUMBER, point)),
        }
    }
    for (at, &(axis, point)) in places.numbers.iter().enumerate() {
        let behind = if places.in_net(point).is_some() { axis } else { 0 };
        assert_eq!(at, places.points[point] + behind);
    }
}

#[test]
fn sizes_are_the_largest_of_what_moves() {
    let of = |idx: usize, variable: usize| sizes(&values()[idx], variable);
    assert_eq!(
        [of(0, 0), of(1, 0), of(1, 1), of(1, 2)],
        [[0.0; 2], [1.0, 3.0], [0.0; 2], [4.0, 3.0]]
    );
    assert_eq!([of(2, 0), of(2, 1), of(2, 2)], [[0.5, 2.0], [2.0, 2.0], [0.0; 2]]);
    assert_eq!([of(3, 2), of(4, 0), of(5, 1)], [[1.0, 4.0], [0.0; 2], [2.0, 2.0]]);
    // The points of the curve are 0 to 2 of its kind, those of its slopes 1 to 3, twice and halved.
    assert_eq!([of(6, 0), of(6, 1), of(6, 2)], [[6.0, 2.0], [0.0; 2], [1.5, 2.0]]);
    assert_eq!([of(7, 0), of(8, 1)], [[18.0, 6.25], [8.0, 1.0]]);
}

#[test]
fn values_of_one_form_differ_in_their_numbers_alone() {
    let knots = |knots: &[f64]| {
        let points: Vec<DVec3> = (0..3).map(point).collect();
        let knots = KnotVector::new(knots.len() - 4, knots.to_vec()).expect("knots");
        Value::Curve(Curve::Nurbs(Arc::new(
            NurbsCurve::polynomial(knots, &points).expect("a curve"),
        )))
    };
    let number = |value: f64, dim: Dimension| Value::Number(Number { value, dim });
    let range = |end: f64, closed: bool| {
        let number = |value: f64| Number { value, dim: Dimension::NONE };
        Value::Range(super::super::Range { start: number(0.0), end: number(end), closed })
    };
    let record = |label: &str, value: Value| {
        Value::Record(Arc::new(Record::new([(Arc::from(label), value)])))
    };
    let (even, uneven) = (knots(&[0.0, 0.0, 1.0, 2.0, 2.0]), knots(&[0.0, 0.0, 1.5, 2.0, 2.0]));
    let moved = Value::Curve(Curve::Nurbs(Arc::new(
        NurbsCurve::polyline(&[point(5), point(1), point(0)]).expect("a polygon"),
    )));
    let of = number(1.0, Dimension::LENGTH);
    assert!(are_alike(&even, &moved) && are_alike(&of, &number(2.0, Dimension::LENGTH)));
    assert!(are_alike(&range(1.0, true), &range(4.0, true)));
    assert!(are_alike(&record("a", of.clone()), &record("a", number(3.0, Dimension::LENGTH))));
    assert!(are_alike(
        &Value::list(vec![even.clone(), of.clone()]),
        &Value::list(vec![moved, of.clone()])
    ));
    let others = [
        (even.clone(), uneven),
        (even.clone(), knots(&[0.0, 0.0, 0.0, 2.0, 2.0, 2.0])),
        (even, Value::Curve(Curve::Nurbs(curve(4)))),
        (of.clone(), number(1.0, Dimension::NONE)),
        (range(1.0, true), range(1.0, false)),
        (record("a", of.clone()), record("b", of.clone())),
        (Value::list(vec![of.clone()]), Value::list(vec![of.clone(), of.clone()])),
        (Value::Bool(true), Value::Bool(false)),
        (of, Value::Point(point(1))),
    ];
    for (a, b) in &others {
        assert!(!are_alike(a, b) && !are_alike(b, a), "{a:?} and {b:?}");
    }
}
