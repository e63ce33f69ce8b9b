//! Integrals over regions and faces, by the strips that they consist of.

use super::{
    found::{Found, Tolerances, nested, place_text, shared},
    integrand::{IntegralRange, Integrand, settled},
};
use crate::{
    diag::Result,
    kernel::{
        AreaStrip,
        tolerance::{PARAMETER_RELATIVE, QUADRATURE_RELATIVE},
    },
    value::{Real, Value},
};

/// Where in a strip the function is asked for its size, across and along.
const LOOKS: [f64; 3] = [1.0 / 6.0, 0.5, 5.0 / 6.0];

/// How many times too large the size of the function may be taken.
const SIZE_ROOM: f64 = 2.0;

/// An integral over strips: so exact as the size of all of it tells, since little of it may lie in a narrow one,
/// and a function may have few digits there.
pub(super) fn over_strips(
    strips: &[AreaStrip<'_>],
    integrand: &mut Integrand<'_, '_>,
    tolerances: Tolerances,
) -> Result<Found> {
    let mut size = 0.0;
    for strip in strips {
        size += rough_size(strip, integrand)?;
    }
    let mut found = to_size(strips, integrand, tolerances, size)?;
    if SIZE_ROOM * found.size < size {
        size = found.size;
        found = to_size(strips, integrand, tolerances, size)?;
    }
    Ok(found)
}

fn to_size(
    strips: &[AreaStrip<'_>],
    integrand: &mut Integrand<'_, '_>,
    [relative, absolute]: Tolerances,
    size: f64,
) -> Result<Found> {
    let tolerances = [relative, absolute.max(QUADRATURE_RELATIVE * size)];
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
fn rough_size(strip: &AreaStrip<'_>, integrand: &mut Integrand<'_, '_>) -> Result<f64> {
    let mut sum = 0.0;
    for s in LOOKS {
        let (y, rate) = height(strip, s);
        let places = strip.places_at(y);
        let (start, width) = (places[0], places[places.len() - 1] - places[0]);
        for along in LOOKS {
            let (point, stretch) = strip.at([start + along * width, y]);
            let factor = Real::Plain(rate * width * stretch);
            sum += integrand.at(&[Value::Point(point)], &factor)?.size;
        }
    }
    Ok(sum / (LOOKS.len() * LOOKS.len()) as f64)
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
