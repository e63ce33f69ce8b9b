//! Unit normals Su × Sv, also where the cross product vanishes.
//!
//! At a pole, on a collapsed edge or at the corner of a degenerate net Su × Sv is zero, but its
//! direction has a limit. The product is expanded in a Taylor series, and the terms of the lowest
//! order that do not vanish give the limit, if they all point one way inside the domain.

use glam::DVec3;

use crate::{
    Bounds, GeomError, Grid, Interval, LocalError,
    frame::unit,
    surface::NurbsSurface,
    tolerance::{NORMAL_AGREEMENT, NORMAL_STEP, VANISHING_RELATIVE},
};

/// Order of the last derivatives that the limit of a normal is looked for in.
const MAX_ORDER: usize = 4;

impl NurbsSurface {
    /// The unit vector along Su × Sv, or its limit where the product vanishes.
    ///
    /// At the pole of a surface of revolution or on an edge that is collapsed to a point this is
    /// the direction of Suv × Sv, or of Su × Suv.
    ///
    /// # Errors
    /// [`LocalError::NoNormal`] where the limit depends on the side that it is taken from.
    pub fn normal_at(&self, u: f64, v: f64) -> Result<DVec3, GeomError> {
        if let Some((scaled, _)) = &self.scaled {
            return scaled.normal_at(u, v);
        }
        let [_, tangent_u, tangent_v] = self.tangents_at(u, v);
        let normal = tangent_u.cross(tangent_v);
        let [width_u, width_v] = self.span_widths(u, v);
        if self.fold_area < normal.length() * width_u * width_v {
            return unit(normal).ok_or(GeomError::Local(LocalError::NoNormal { u, v }));
        }
        let derivatives = |order| Ok(self.derivatives_at(u, v, order));
        let places = [(self.domain_u(), u), (self.domain_v(), v)];
        limit_normal(derivatives, [width_u, width_v], places, self.fold_area)?
            .ok_or(GeomError::Local(LocalError::NoNormal { u, v }))
    }

    /// A unit vector for shading: the normal, or the nearest there is.
    ///
    /// Where there is no limit either, the normal a little further inside the domain; and (0, 0,
    /// 1) where the whole neighbourhood is folded.
    pub(in crate::surface) fn shading_normal(&self, u: f64, v: f64) -> DVec3 {
        let (inner_u, inner_v) =
            (shading_place(self.domain_u(), u), shading_place(self.domain_v(), v));
        self.normal_at(u, v)
            .or_else(|_| self.normal_at(inner_u, inner_v))
            .or_else(|_| self.plain_normal(u, v))
            .unwrap_or(DVec3::Z)
    }

    fn plain_normal(&self, u: f64, v: f64) -> Result<DVec3, GeomError> {
        let [_, tangent_u, tangent_v] = self.tangents_at(u, v);
        let normal = tangent_u.cross(tangent_v);
        unit(normal).ok_or(GeomError::Local(LocalError::NoNormal { u, v }))
    }

    /// The widths of the spans that hold a place.
    pub(in crate::surface) fn span_widths(&self, u: f64, v: f64) -> [f64; 2] {
        let width_u = self.knots_u.span_interval(self.knots_u.span_at(u)).length();
        let width_v = self.knots_v.span_interval(self.knots_v.span_at(v)).length();
        [width_u, width_v]
    }
}

/// Where to look for a normal for shading at a place that has none: a little inside the domain.
pub(in crate::surface) fn shading_place(domain: Interval, t: f64) -> f64 {
    t + (domain.at(0.5) - t) * NORMAL_STEP
}

/// The limit of the unit vector along Su × Sv at a place where the product vanishes.
///
/// `derivatives` answers up to an order; `widths` are the steps in u and v that the surface's size
/// corresponds to; `rounding` is an area over these that is none.
pub(in crate::surface) fn limit_normal(
    derivatives: impl FnOnce(usize) -> Result<Grid<DVec3>, GeomError>,
    widths: [f64; 2],
    places: [(Interval, f64); 2],
    rounding: f64,
) -> Result<Option<DVec3>, GeomError> {
    let normals = normal_series(&derivatives(MAX_ORDER)?, widths);
    let sides = places.map(|(domain, t)| domain.inward(t));
    for order in 1..MAX_ORDER {
        let terms: Vec<(usize, DVec3)> = (0..=order)
            .map(|i| (i, normals.get(i, order - i)))
            .filter(|(_, term)| rounding < term.length())
            .collect();
        if !terms.is_empty() {
            return Ok(common_direction(&terms, order, sides));
        }
    }
    Ok(None)
}

/// The area, of Su × Sv over one span each, that is rounding and no area.
pub(in crate::surface) fn fold_area(bounds: Bounds) -> f64 {
    bounds.magnitude() * bounds.diagonal() * VANISHING_RELATIVE
}

/// The direction of all terms `n·duⁱ·dvʲ`, i + j = `order`, for steps into the domain.
fn common_direction(
    terms: &[(usize, DVec3)],
    order: usize,
    sides: [Option<f64>; 2],
) -> Option<DVec3> {
    // An odd power has both signs around a place inside the domain.
    let sign = |side: Option<f64>, power: usize| match side {
        Some(side) if power % 2 == 1 => Some(side),
        None if power % 2 == 1 => None,
        _ => Some(1.0),
    };
    let mut directions = terms.iter().map(|&(i, term)| {
        let sign = sign(sides[0], i)? * sign(sides[1], order - i)?;
        unit(term * sign)
    });
    let first = directions.next()??;
    let agree = |direction: Option<DVec3>| {
        direction.is_some_and(|direction| direction.distance(first) < NORMAL_AGREEMENT)
    };
    directions.all(agree).then_some(first)
}

/// Taylor coefficients of Su × Sv by powers of u and v, for steps in units of `widths`.
fn normal_series(derivatives: &Grid<DVec3>, widths: [f64; 2]) -> Grid<DVec3> {
    let coefficient = |i: usize, j: usize| {
        let mut term = derivatives.get(i, j);
        for k in 1..=i {
            term *= widths[0] / k as f64;
        }
        for k in 1..=j {
            term *= widths[1] / k as f64;
        }
        term
    };
    let along_u = |i: usize, j: usize| (i + 1) as f64 * coefficient(i + 1, j);
    let along_v = |i: usize, j: usize| (j + 1) as f64 * coefficient(i, j + 1);
    let n = derivatives.n_rows() - 1;
    Grid::from_fn(n, n, |i, j| {
        let mut sum = DVec3::ZERO;
        for k in 0..=i {
            for l in 0..=j {
                sum += along_u(k, l).cross(along_v(i - k, j - l));
            }
        }
        sum
    })
}
