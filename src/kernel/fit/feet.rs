//! Parameters of points that move towards their nearest places on a curve and stay in order.

use glam::DVec3;

use crate::{CurveEvaluator, NurbsCurve};

/// How far parameters may move at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FootStep {
    /// Up to where their neighbours are: few points, whose curve may still be far from where it belongs, do not crowd so.
    UpToNeighbours,
    /// All together past where their neighbours were: of many points a place is many neighbours away from where it
    /// belongs, and steps up to the next would take as many.
    PastNeighbours,
}

/// Parameters one step of Newton's method nearer to the places of the curve that are nearest to the points, the first
/// and the last as they are; none where that leads away. `known` are point, first and second derivative at the
/// parameters, if they are.
pub(super) fn stepped(
    curve: &NurbsCurve,
    points: &[DVec3],
    parameters: Vec<f64>,
    known: Option<&[[DVec3; 3]]>,
    how: FootStep,
) -> Vec<f64> {
    let found = curve.evaluator();
    let mut wanted = Vec::with_capacity(parameters.len());
    let mut misses = Vec::with_capacity(parameters.len());
    let mut step_from = |[value, first, second]: [DVec3; 3]| {
        let i = wanted.len();
        let miss = value - points[i];
        let speed = first.length_squared();
        let bent = speed + miss.dot(second);
        let slope = if 0.0 < bent { bent } else { speed };
        let step = if 0.0 < slope { miss.dot(first) / slope } else { 0.0 };
        wanted.push(parameters[i] - step);
        misses.push(miss.length_squared());
    };
    match known.filter(|known| known.len() == parameters.len()) {
        Some(known) => known.iter().copied().for_each(step_from),
        None => found.each_second_order(&parameters, &mut step_from),
    }
    match how {
        FootStep::UpToNeighbours => up_to_neighbours(found, points, parameters, (&wanted, &misses)),
        FootStep::PastNeighbours => past_neighbours(found, points, parameters, (wanted, &misses)),
    }
}

/// The parameters, each where it is wanted or at a neighbour before that, if its point is nearer there than it was.
fn up_to_neighbours(
    curve: &CurveEvaluator,
    points: &[DVec3],
    mut parameters: Vec<f64>,
    (wanted, misses): (&[f64], &[f64]),
) -> Vec<f64> {
    // Few of them come upon a neighbour: the others are looked at together.
    let mut found = Vec::with_capacity(wanted.len());
    curve.each_point(wanted, |place| found.push(place.distance_squared(points[found.len()])));
    for i in 1..parameters.len() - 1 {
        let next = wanted[i].max(parameters[i - 1]).min(parameters[i + 1]);
        let is_there = next.total_cmp(&wanted[i]).is_eq();
        let off = match is_there {
            true => found[i],
            false => curve.point_at(next).distance_squared(points[i]),
        };
        if off < misses[i] {
            parameters[i] = next;
        }
    }
    parameters
}

/// The parameters, each in order as near as can be to where it is wanted, if its point is nearer there than it was.
fn past_neighbours(
    curve: &CurveEvaluator,
    points: &[DVec3],
    mut parameters: Vec<f64>,
    (mut wanted, misses): (Vec<f64>, &[f64]),
) -> Vec<f64> {
    let last = parameters.len() - 1;
    let [start, end] = [parameters[0], parameters[last]];
    wanted.iter_mut().for_each(|t| *t = t.clamp(start, end));
    (wanted[0], wanted[last]) = (start, end);
    order(&mut wanted);
    let (mut i, mut before) = (0, start);
    curve.each_point(&wanted, |place| {
        if place.distance_squared(points[i]) < misses[i] {
            parameters[i] = wanted[i];
        }
        parameters[i] = parameters[i].max(before);
        before = parameters[i];
        i += 1;
    });
    parameters
}

/// Makes of numbers the nearest ones of which none is less than one before it: the largest difference is as small as can be.
///
/// Halfway between the most of those before and the least of those behind. Barlow, Bartholomew, Bremner & Brunk,
/// *Statistical Inference under Order Restrictions*, 1972.
fn order(numbers: &mut [f64]) {
    let mut least = numbers.to_vec();
    for i in (1..least.len()).rev() {
        least[i - 1] = least[i - 1].min(least[i]);
    }
    let mut most = f64::NEG_INFINITY;
    for (number, least) in numbers.iter_mut().zip(least) {
        most = most.max(*number);
        *number = 0.5 * (most + least);
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::{FootStep, order, stepped};
    use crate::NurbsCurve;

    #[test]
    fn what_is_out_of_order_meets_halfway() {
        let mut numbers = [0.0, 3.0, 1.0, 4.0, 5.0];
        order(&mut numbers);
        assert_eq!(numbers, [0.0, 2.0, 2.0, 4.0, 5.0]);
    }

    #[test]
    fn parameters_pass_where_their_neighbours_were() {
        // On a line of length 1 every foot is one step away, and here ten spacings of the parameters.
        let line = NurbsCurve::line(DVec3::ZERO, DVec3::X).unwrap();
        let points: Vec<DVec3> = (0..=100).map(|i| DVec3::X * f64::from(i) / 100.0).collect();
        let start = (0..100).map(|i| f64::from(i) / 1000.0).chain([1.0]).collect();
        let found = stepped(&line, &points, start, None, FootStep::PastNeighbours);
        for (t, point) in found.iter().zip(&points) {
            assert!((t - point.x).abs() < 1e-15, "{t} for {point}");
        }
    }
}
