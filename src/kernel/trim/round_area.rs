//! Area and flux of faces on cylinders, cones, spheres and tori.
//!
//! About the axis the integrals have closed forms: over the angle from θ₀ to θ₁ the direction outward e has the integral
//! E = sin(θ₁ − θ₀) e₀ + (1 − cos(θ₁ − θ₀)) z × e₀. With the meridian (r, h) over v the normal Su × Sv du is
//! r (h′ e − r′ z) dθ, so that what is left is an integral along the border.

use std::array::from_fn;

use glam::DVec3;

use super::{Face, measure::ParameterPiece};
use crate::{
    AnalyticForm, Frame, GeomError, Interval, NurbsSurface,
    frame::norm,
    numeric::gauss_legendre::{SIXTEEN_NODES, nodes},
    surface::IntegralValues,
    tolerance::{ANALYTIC_RELATIVE, LAST_BIT, ROUND_SKEW},
};

/// Pieces of the border over which one rule is taken, before the integral over areas is asked instead.
const MOST_RULES: usize = 2000;

/// Last bits of what an integral is made of that its halves may differ from it.
const ROUNDINGS: f64 = 64.0;

/// Area, the three coordinates of the normal, and flux; and what each of them is made of.
type Quantities = [[f64; 5]; 2];

impl Face {
    /// The area, the integral of the normal, and the flux of the way from a point, of a face whose surface turns about
    /// an axis along u; none of any other, and where the integrals do not settle.
    ///
    /// # Errors
    /// Those of a search that was ended.
    pub(super) fn round_area_and_flux(
        &self,
        about: DVec3,
    ) -> Result<Option<IntegralValues<5>>, GeomError> {
        let surface = &*self.plane.surface;
        let Some(round) = RoundSurface::of(surface, about) else { return Ok(None) };
        let arcs = self.closed_arcs()?;
        let pieces = self.parameter_pieces(&arcs)?;
        let mut todo: Vec<(usize, Interval, Quantities)> = Vec::with_capacity(pieces.len());
        for (number, piece) in pieces.iter().enumerate() {
            GeomError::go_on(SIXTEEN_NODES.len())?;
            let interval = match *piece {
                ParameterPiece::Rectangle { v, .. } => v,
                ParameterPiece::Strip { interval, .. } => interval,
            };
            todo.push((number, interval, round.over(piece, interval)));
        }
        // Of a short piece rounding of its ends is much, of the whole it is nothing.
        let whole = todo.iter().fold(Quantities::default(), |sum, piece| added(sum, piece.2))[1];
        let share = whole.map(|size| size / pieces.len().max(1) as f64);
        let (mut sum, mut changes) = (Quantities::default(), [0.0; 5]);
        let mut n_left = MOST_RULES;
        while let Some((number, interval, rough)) = todo.pop() {
            GeomError::go_on(SIXTEEN_NODES.len())?;
            let over = |half: Interval| (number, half, round.over(&pieces[number], half));
            let halves = interval.halves().map(over);
            let both = added(halves[0].2, halves[1].2);
            let change: [f64; 5] = from_fn(|i| (both[0][i] - rough[0][i]).abs());
            if (0..5).all(|i| change[i] <= round.rounding * both[1][i].max(share[i])) {
                sum = added(sum, both);
                changes = from_fn(|i| changes[i] + change[i]);
                continue;
            }
            if n_left == 0 {
                return Ok(None);
            }
            n_left -= 1;
            todo.extend(halves);
        }
        let [values, sizes] = sum;
        let errors = from_fn(|i| changes[i] + round.rounding * sizes[i]);
        let is_number = values.iter().chain(&sizes).all(|value| value.is_finite());
        Ok(is_number.then_some(IntegralValues { values, errors, sizes }))
    }
}

fn added(one: Quantities, other: Quantities) -> Quantities {
    from_fn(|k| from_fn(|i| one[k][i] + other[k][i]))
}

/// A surface that turns about the axis of a frame along u.
struct RoundSurface<'a> {
    surface: &'a NurbsSurface,
    frame: Frame,
    /// The flux is that of the way from here.
    about: DVec3,
    /// What of an integral is rounding.
    rounding: f64,
}

impl<'a> RoundSurface<'a> {
    /// None of a plane, of a surface that turns along v, and of one whose spans may go around by half a turn or more.
    fn of(surface: &'a NurbsSurface, about: DVec3) -> Option<Self> {
        if surface.degree_u() != 2 {
            return None;
        }
        let bounds = surface.bounds();
        let found = surface.analytic(ANALYTIC_RELATIVE * bounds.magnitude())?;
        let [u, v] = [surface.domain_u(), surface.domain_v()].map(|domain| domain.at(0.4));
        let [point, along_u, _] = surface.tangents_at(u, v);
        let out = point - found.frame.origin();
        let axis = found.frame.z();
        let radial = out - axis * out.dot(axis);
        let skew = along_u.dot(axis).abs() + along_u.dot(radial).abs() / norm(radial);
        let is_along_u = skew <= ROUND_SKEW * norm(along_u);
        let is_round = !matches!(found.form, AnalyticForm::Plane);
        let rounding = ROUNDINGS * LAST_BIT * (1.0 + bounds.magnitude() / bounds.diagonal());
        (is_round && is_along_u).then_some(Self { surface, frame: found.frame, about, rounding })
    }

    /// One rule along a part of the border of a piece, or along v.
    fn over(&self, piece: &ParameterPiece<'_>, interval: Interval) -> Quantities {
        let mut sum = Quantities::default();
        for (t, weight) in nodes(&SIXTEEN_NODES, interval) {
            let (v, ends, factor) = match *piece {
                ParameterPiece::Rectangle { u, times, .. } => (t, [u.start(), u.end()], times),
                ParameterPiece::Strip { arc, from, .. } => {
                    let derivatives = arc.derivatives_at(t, 1);
                    (derivatives[0].y, [from, derivatives[0].x], derivatives[1].y)
                }
            };
            let factor = weight * interval.length() * factor;
            let [values, sizes] = self.across(v, ends);
            for i in 0..5 {
                sum[0][i] += factor * values[i];
                sum[1][i] += factor.abs() * sizes[i];
            }
        }
        sum
    }

    /// The integrals along u from one parameter to another.
    fn across(&self, v: f64, ends: [f64; 2]) -> Quantities {
        let (domain_u, domain_v) = (self.surface.domain_u(), self.surface.domain_v());
        let v = v.clamp(domain_v.start(), domain_v.end());
        let ends = ends.map(|u| u.clamp(domain_u.start(), domain_u.end()));
        let (axis, origin) = (self.frame.z(), self.frame.origin());
        let first = self.surface.point_at(ends[0], v) - origin;
        let [last, _, along] = self.surface.tangents_at(ends[1], v);
        let outward = |way: DVec3| way - axis * way.dot(axis);
        let (height, radius) = ((last - origin).dot(axis), norm(outward(last - origin)));
        let [start, end] = [outward(first), outward(last - origin)].map(DVec3::normalize_or_zero);
        let (sine, cosine) = (axis.dot(start.cross(end)), start.dot(end));
        let turn = libm::atan2(sine, cosine);
        let half_sine = libm::sin(0.5 * turn);
        let outwards = start * libm::sin(turn) + axis.cross(start) * (2.0 * half_sine * half_sine);
        let (widening, rise) = (along.dot(end), along.dot(axis));

        let normal = (outwards * rise - axis * (widening * turn)) * radius;
        let way = origin - self.about;
        let flux = radius
            * (rise * (way.dot(outwards) + radius * turn)
                - widening * (way.dot(axis) + height) * turn);
        let speed = radius * libm::hypot(widening, rise);
        let area = speed * if ends[1] < ends[0] { -turn.abs() } else { turn.abs() };
        // An angle, however small, is known to the last bits of one.
        let size = speed * (turn.abs() + 1.0);
        let reach = size * (norm(way) + libm::hypot(radius, height));
        [[area, normal.x, normal.y, normal.z, flux], [size, size, size, size, reach]]
    }
}
