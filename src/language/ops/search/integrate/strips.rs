//! Integrals over regions and faces, by the strips that they consist of.

use super::{
    found::{Found, Tolerances, nested, place_text, shared},
    integrand::{IntegralRange, Integrand, LOOKS, settled},
};
use crate::{
    diag::Result,
    kernel::{AreaStrip, tolerance::PARAMETER_RELATIVE},
    value::{Real, Value},
};

/// An integral over strips.
pub(super) fn over_strips(
    strips: &[AreaStrip<'_>],
    integrand: &mut Integrand<'_, '_>,
    tolerances: Tolerances,
) -> Result<Found> {
    let mut total = Found::default();
    for strip in strips {
        total = total.plus(over_strip(strip, integrand, shared(tolerances, strips.len()))?);
    }
    Ok(total)
}

/// The y at a fraction of the way across a strip, and how fast it grows there. Towards the ends steps become
/// smaller with their square, since the width of a strip may begin like a root, as at the top of a circle.
fn height(strip: &AreaStrip<'_>, s: f64) -> (f64, f64) {
    let across = strip.across();
    let y = across.start() + across.length() * s * s * (3.0 - 2.0 * s);
    (y, 6.0 * across.length() * s * (1.0 - s))
}

/// The integral of the function's size, as some places tell it.
pub(super) fn rough_strip_size(strip: &AreaStrip<'_>, integrand: &mut Integrand<'_, '_>) -> f64 {
    let mut sum = 0.0;
    for s in LOOKS {
        let (y, rate) = height(strip, s);
        let places = strip.places_at(y);
        let (start, width) = (places[0], places[places.len() - 1] - places[0]);
        for along in LOOKS {
            let (point, stretch) = strip.at([start + along * width, y]);
            sum += integrand.size_at(&[Value::Point(point)], rate * width * stretch);
        }
    }
    sum / (LOOKS.len() * LOOKS.len()) as f64
}

fn over_strip(
    strip: &AreaStrip<'_>,
    integrand: &mut Integrand<'_, '_>,
    tolerances: Tolerances,
) -> Result<Found> {
    let [own, inner] = nested(tolerances, 1.0);
    let text = |x, y| {
        let dust = |part: f64| part.abs() < PARAMETER_RELATIVE * strip.across().length();
        let point = strip.at([x, y]).0;
        place_text(point.map(|part| if dust(part) { 0.0 } else { part }))
    };
    let middle = |s| {
        let (y, _) = height(strip, s);
        let places = strip.places_at(y);
        text(0.5 * (places[0] + places[places.len() - 1]), y)
    };
    settled(&integrand.range([0.0, 1.0]), own, middle, |s| {
        let s = s.value();
        let (y, rate) = height(strip, s);
        let places = strip.places_at(y);
        let inner = shared(inner, places.len() - 1);
        let range = integrand.range([0.0, 1.0]);
        let mut ask = |x: f64, factor: f64| {
            let (point, stretch) = strip.at([x, y]);
            let factor = Real::Plain(factor * stretch);
            integrand.at(&[Value::Point(point)], &factor)
        };
        let mut total = Found::default();
        for ends in places.windows(2).filter(|ends| ends[0] < ends[1]) {
            let ends = [ends[0], ends[1]];
            let range = IntegralRange { ends, ..range.clone() };
            total = total.plus(settled(&range, inner, |x| text(x, y), |x| ask(x.value(), rate))?);
        }
        match total.value.is_empty() {
            true => ask(places[0], 0.0),
            false => Ok(total),
        }
    })
}
