//! Integrals over several parts: each is found so exactly as the function's size over all of them asks for, since little
//! of it may lie in one, and a function may have few digits there, as a distance does on an edge in the plane from
//! which it is measured.

use super::{
    domain::{Domain, pieces},
    found::{Found, Tolerances, shared},
    integrand::{Integrand, LOOKS},
    moving_range::MovingRange,
    strips::rough_strip_size,
};
use crate::{
    diag::Result,
    kernel::{
        AreaStrip,
        tolerance::{INTEGRAL_RELATIVE, QUADRATURE_RELATIVE},
    },
    value::{IntoValue, RealCurve, RealSurface, Value, Vector},
};

/// How many times too large the size of the function may be taken.
const SIZE_ROOM: f64 = 2.0;

/// A domain, with the strips of which it consists if it is a region or a face.
pub(super) struct Part<'a> {
    domain: &'a Domain,
    strips: Vec<AreaStrip<'a>>,
}

impl<'a> Part<'a> {
    pub(super) fn new(domain: &'a Domain) -> Result<Self> {
        Ok(Self { domain, strips: domain.strips()? })
    }

    /// The integral of the function's size, as some places tell it; where it fails it adds nothing.
    fn rough_size(&self, integrand: &mut Integrand<'_, '_>) -> f64 {
        match self.domain {
            Domain::Box(ranges) => rough_box_size(ranges, &mut Vec::new(), integrand),
            Domain::Curve(curve, _) => rough_curve_size(curve, integrand),
            Domain::Surface(surface, _) => rough_surface_size(surface, integrand),
            Domain::Region(..) | Domain::Face(..) => {
                self.strips.iter().map(|strip| rough_strip_size(strip, integrand)).sum()
            }
        }
    }

    fn integral(&self, integrand: &mut Integrand<'_, '_>, tolerances: Tolerances) -> Result<Found> {
        self.domain.integral(&self.strips, integrand, tolerances)
    }
}

/// The integrals over all parts together.
pub(super) fn over_all(
    parts: &[Part<'_>],
    integrand: &mut Integrand<'_, '_>,
    tolerances: Tolerances,
) -> Result<Found> {
    // A range alone tells its size itself.
    if let [Part { domain: Domain::Box(ranges), .. }] = parts
        && ranges.len() == 1
    {
        return parts[0].integral(integrand, tolerances);
    }
    let mut size = parts.iter().map(|part| part.rough_size(integrand)).sum();
    loop {
        let found = to_size(parts, integrand, tolerances, size)?;
        match SIZE_ROOM * found.size < size {
            true => size = found.size,
            false => return Ok(found),
        }
    }
}

fn to_size(
    parts: &[Part<'_>],
    integrand: &mut Integrand<'_, '_>,
    [relative, absolute]: Tolerances,
    size: f64,
) -> Result<Found> {
    let share = match parts {
        [Part { domain: Domain::Curve(..), .. }, ..] => INTEGRAL_RELATIVE,
        _ => QUADRATURE_RELATIVE,
    };
    let tolerances = [relative, absolute.max(share * size)];
    let mut total = Found::default();
    for part in parts {
        total = total.plus(part.integral(integrand, shared(tolerances, parts.len()))?);
    }
    Ok(total)
}

fn rough_box_size(
    ranges: &[MovingRange],
    known: &mut Vec<Value>,
    integrand: &mut Integrand<'_, '_>,
) -> f64 {
    let Some((first, rest)) = ranges.split_first() else {
        return integrand.size_at(known, 1.0);
    };
    let mut sum = 0.0;
    for share in LOOKS {
        known.push(first.place_within(share));
        sum += rough_box_size(rest, known, integrand);
        known.pop();
    }
    sum * first.length() / LOOKS.len() as f64
}

fn rough_curve_size(curve: &RealCurve, integrand: &mut Integrand<'_, '_>) -> f64 {
    let pieces = pieces(curve.domain(), curve.nurbs().ok().map(|it| it.knots().as_slice()));
    let mut sum = 0.0;
    for [start, end] in pieces {
        for share in LOOKS {
            let found = curve.derivatives_at(start + share * (end - start), 1);
            let Ok([point, speed, ..]) = found.as_deref() else { continue };
            let factor = speed.length() * (end - start) / LOOKS.len() as f64;
            sum += integrand.size_at(&[Vector::Plain(*point).into_value()], factor);
        }
    }
    sum
}

fn rough_surface_size(surface: &RealSurface, integrand: &mut Integrand<'_, '_>) -> f64 {
    let nurbs = surface.nurbs().ok();
    let along_u = pieces(surface.domain_u(), nurbs.map(|it| it.knots_u().as_slice()));
    let along_v = pieces(surface.domain_v(), nurbs.map(|it| it.knots_v().as_slice()));
    let places = |pieces: &[[f64; 2]]| -> Vec<[f64; 2]> {
        let of = |[start, end]: &[f64; 2]| {
            let (start, length) = (*start, end - start);
            LOOKS.map(|share| [start + share * length, length / LOOKS.len() as f64])
        };
        pieces.iter().flat_map(of).collect()
    };
    let (along_u, along_v) = (places(&along_u), places(&along_v));
    let mut sum = 0.0;
    for &[u, width] in &along_u {
        for &[v, height] in &along_v {
            let Ok(found) = surface.derivatives_at(u, v, 1) else { continue };
            let stretch = found.get(1, 0).cross(found.get(0, 1)).length();
            let point = Vector::Plain(found.get(0, 0)).into_value();
            sum += integrand.size_at(&[point], width * height * stretch);
        }
    }
    sum
}
