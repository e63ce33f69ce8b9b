//! Curves of parameters that a curve's own parameter tells: along a line of constant parameter that it goes along
//! evenly, and on a plane patch.

use glam::{DAffine3, DVec3};

use super::{super::lift::parameters_map, piece::Carrier};
use crate::{KnotVector, NurbsCurve, NurbsSurface, tolerance::PLACE_RELATIVE};

/// Where in a span of the curve it is looked at which parameters it has there.
const LOOKS: [f64; 2] = [0.25, 0.75];

/// The parameters along a curve on a surface, if they are of that kind; how far they miss it is another question.
pub(super) fn even_parameters(curve: &NurbsCurve, surface: &NurbsSurface) -> Option<NurbsCurve> {
    match parameters_map(surface) {
        Some(map) if !curve.is_rational() => {
            let flat = DAffine3::from_scale(DVec3::new(1.0, 1.0, 0.0));
            Some(curve.transformed(&(flat * map)))
        }
        _ => along_line(curve, surface),
    }
}

/// Those along a line of constant parameter: even in each span, with corners where the surface has knots.
fn along_line(curve: &NurbsCurve, surface: &NurbsSurface) -> Option<NurbsCurve> {
    let carrier = Carrier::new(surface);
    let looks = |t: f64| surface.closest(curve.point_at(t)).parameters;
    let mut corners: Vec<(f64, [f64; 2])> = Vec::new();
    for pair in curve.knots().breaks().windows(2) {
        let at = |share: f64| pair[0] + (pair[1] - pair[0]) * share;
        let [a, b] = LOOKS.map(|share| looks(at(share)));
        let ends = [0.0, 1.0].map(|end| {
            let share = (end - LOOKS[0]) / (LOOKS[1] - LOOKS[0]);
            carrier.on_knots([0, 1].map(|i| a[i] + (b[i] - a[i]) * share))
        });
        match corners.last() {
            None => corners.push((pair[0], ends[0])),
            // Over a seam parameters jump.
            Some((_, known)) if known.map(f64::to_bits) != ends[0].map(f64::to_bits) => {
                return None;
            }
            Some(_) => {}
        }
        corners.push((pair[1], ends[1]));
    }
    let bits = |(_, place): &(f64, [f64; 2]), i: usize| place[i].to_bits();
    let stays = |i: usize| corners.iter().all(|corner| bits(corner, i) == bits(&corners[0], i));
    let is_line = (0..2).any(stays);
    if !is_line {
        return None;
    }
    let mut all = vec![*corners.first()?];
    for pair in corners.windows(2) {
        let [(t, from), (end, to)] = [pair[0], pair[1]];
        let mut shares: Vec<f64> = (0..2)
            .flat_map(|i| {
                let knots = carrier.knots(i).breaks().into_iter();
                knots.map(move |knot| (knot - from[i]) / (to[i] - from[i]))
            })
            .filter(|share| PLACE_RELATIVE < *share && *share < 1.0 - PLACE_RELATIVE)
            .collect();
        shares.sort_by(f64::total_cmp);
        let between = shares.into_iter().map(|share| {
            let place = [0, 1].map(|i| from[i] + (to[i] - from[i]) * share);
            (t + (end - t) * share, carrier.on_knots(place))
        });
        all.extend(between);
        all.push((end, to));
    }
    let first = all.first()?.0;
    let last = all.last()?.0;
    let knots = [first].into_iter().chain(all.iter().map(|corner| corner.0)).chain([last]);
    let points: Vec<DVec3> = all.iter().map(|(_, [u, v])| DVec3::new(*u, *v, 0.0)).collect();
    NurbsCurve::polynomial(KnotVector::new(1, knots.collect()).ok()?, &points).ok()
}

impl Carrier<'_> {
    /// Parameters, put on knots and ends of domains that they miss by rounding.
    fn on_knots(&self, at: [f64; 2]) -> [f64; 2] {
        let within = self.within(at);
        [0, 1].map(|i| {
            let slack = PLACE_RELATIVE * self.knots(i).domain().length();
            let mut knots = self.knots(i).breaks().into_iter();
            knots.find(|knot| (knot - within[i]).abs() <= slack).unwrap_or(within[i])
        })
    }
}
