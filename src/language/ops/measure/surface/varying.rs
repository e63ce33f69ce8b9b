//! Questions about a surface where its parameters or the surface itself carry derivatives: the formulas of the field, on the
//! truncated Taylor series of the surface's derivatives.
//!
//! The value of an answer, and what is refused, is that of the question at the plain parameters; the
//! derivatives come on top. do Carmo, *Differential Geometry of Curves and Surfaces*, §3-2 and §3-3; the
//! functions that equations define by Griewank & Walther, *Evaluating Derivatives*, §15.1.

use glam::{DMat2, DVec2, DVec3};

use crate::{
    diag::{Result, Span, Spanned},
    kernel::{Grid, Interval, Jet, LocalError, tolerance::LAST_BIT},
    ops::{face::RealSurfaceOrFace, measure::Measured},
    value::{At, Real, RealSurface, Vector},
};

/// Parameters of a surface, inside its domain.
fn inside(surface: &RealSurfaceOrFace, parameters: [&Spanned<Real>; 2]) -> Result<[Real; 2]> {
    let [u, v] = parameters;
    let one = |domain: Interval, t: &Spanned<Real>| -> Result<Real> {
        Ok(t.value.clone().with_value(domain.clamp_inside(t.value.value()).at(t.span)?))
    };
    let inside = [one(surface.domain_u(), u)?, one(surface.domain_v(), v)?];
    surface.check_inside(inside.each_ref().map(Real::value), u.span)?;
    Ok(inside)
}

/// Parameters of a surface without and with derivatives: the latter where one of them carries any, or what
/// is asked beside them does.
pub(super) fn place(
    surface: &RealSurfaceOrFace,
    parameters: [&Spanned<Real>; 2],
    order: usize,
    beside: Option<&Jet>,
    span: Span,
) -> Result<([f64; 2], Option<Varying>)> {
    let [u, v] = inside(surface, parameters)?;
    let jets = surface.real().jets_of([&u, &v], beside).at(span)?;
    let varying =
        jets.map(|jets| Varying::new(surface.real(), &jets, order)).transpose().at(span)?;
    Ok(([u.value(), v.value()], varying))
}

/// A number that a surface has at parameters: that of the plain question, with the derivatives of a formula.
pub(super) fn number(
    surface: &RealSurfaceOrFace,
    parameters: [&Spanned<Real>; 2],
    span: Span,
    plain: impl FnOnce(f64, f64) -> Measured<f64>,
    (order, formula): (usize, impl FnOnce(&Varying) -> Measured<Real>),
) -> Result<Real> {
    let ([u, v], varying) = place(surface, parameters, order, None, span)?;
    let value = plain(u, v).at(span)?;
    match varying {
        None => Ok(Real::Plain(value)),
        Some(varying) => Ok(formula(&varying).at(span)?.with_value(value)),
    }
}

/// A vector that a surface has at parameters, as [`number`].
pub(super) fn vector(
    surface: &RealSurfaceOrFace,
    parameters: [&Spanned<Real>; 2],
    span: Span,
    plain: impl FnOnce(f64, f64) -> Measured<DVec3>,
    (order, formula): (usize, impl FnOnce(&Varying) -> Measured<Vector>),
) -> Result<Vector> {
    let ([u, v], varying) = place(surface, parameters, order, None, span)?;
    let value = plain(u, v).at(span)?;
    match varying {
        None => Ok(Vector::Plain(value)),
        Some(varying) => Ok(formula(&varying).at(span)?.with_value(value)),
    }
}

/// Derivatives of a surface where it or its parameters vary.
pub(super) struct Varying {
    derivatives: Grid<Vector>,
}

/// Coefficients of both fundamental forms: E, F, G and L, M, N.
pub(super) struct Forms {
    first: [Real; 3],
    second: [Real; 3],
}

impl Varying {
    /// With derivatives up to a total order.
    fn new(surface: &RealSurface, [u, v]: &[Jet; 2], order: usize) -> Measured<Self> {
        Ok(Self { derivatives: surface.series_at([u, v], order)? })
    }

    /// The derivative by u and by v so many times.
    pub(super) fn derivative(&self, by_u: usize, by_v: usize) -> Measured<Vector> {
        Ok(self.derivatives.row(by_u)[by_v].clone())
    }

    /// A derivative at length 1.
    pub(super) fn direction(&self, by_u: usize, by_v: usize) -> Measured<Vector> {
        let vector = self.derivative(by_u, by_v)?;
        vector.over(&vector.norm()?)
    }

    /// Su × Sv at length 1.
    pub(super) fn normal(&self) -> Measured<Vector> {
        let across = self.derivative(1, 0)?.cross(&self.derivative(0, 1)?);
        across.over(&across.norm()?)
    }

    /// E, F and G.
    pub(super) fn first_form(&self) -> Measured<[Real; 3]> {
        let (u, v) = (self.derivative(1, 0)?, self.derivative(0, 1)?);
        Ok([u.dot(&u), u.dot(&v), v.dot(&v)])
    }

    /// L, M and N.
    pub(super) fn second_form(&self) -> Measured<[Real; 3]> {
        let normal = self.normal()?;
        let second =
            |by_u, by_v| -> Measured<Real> { Ok(self.derivative(by_u, by_v)?.dot(&normal)) };
        Ok([second(2, 0)?, second(1, 1)?, second(0, 2)?])
    }

    pub(super) fn forms(&self) -> Measured<Forms> {
        Ok(Forms { first: self.first_form()?, second: self.second_form()? })
    }
}

impl Forms {
    /// EG − F².
    fn area(&self) -> Real {
        let [e, f, g] = &self.first;
        e.times(g).minus(&f.times(f))
    }

    /// (LN − M²)/(EG − F²).
    pub(super) fn gaussian(&self) -> Measured<Real> {
        let [l, m, n] = &self.second;
        l.times(n).minus(&m.times(m)).over(&self.area())
    }

    /// (EN − 2FM + GL)/(2(EG − F²)).
    pub(super) fn mean(&self) -> Measured<Real> {
        let ([e, f, g], [l, m, n]) = (&self.first, &self.second);
        let sum = e.times(n).minus(&f.times(m).scaled(2.0)).plus(&g.times(l));
        sum.over(&self.area().scaled(2.0))
    }

    /// H ∓ √(H² − K), which has no derivatives at an umbilic.
    pub(super) fn principal(&self) -> Measured<[Real; 2]> {
        let mean = self.mean()?;
        let spread = mean.times(&mean).minus(&self.gaussian()?);
        let size = mean.value() * mean.value() + spread.value().abs();
        if spread.value() <= LAST_BIT.sqrt() * size {
            let at = mean.value();
            return Err(
                LocalError::NotDifferentiable { what: "the principal curvatures", at }.into()
            );
        }
        let spread = spread.sqrt()?;
        Ok([mean.minus(&spread), mean.plus(&spread)])
    }

    /// The unit vector of the direction in which the normal curvature is `curvature`, a principal one, on
    /// the side of `towards`.
    pub(super) fn principal_direction(
        &self,
        at: &Varying,
        curvature: &Real,
        towards: DVec3,
    ) -> Measured<Vector> {
        let (u, v) = (at.derivative(1, 0)?, at.derivative(0, 1)?);
        let [p, q, r] = [0, 1, 2].map(|i| self.second[i].minus(&curvature.times(&self.first[i])));
        // (II − kI)(a, b) = 0 by its rows, of which the larger tells more.
        let [first, second] = [[&q, &p], [&r, &q]].map(|[a, b]| u.times(a).minus(&v.times(b)));
        let longer = if first.value().length() < second.value().length() { second } else { first };
        let found = longer.over(&longer.norm()?)?;
        let sign = if found.value().dot(towards) < 0.0 { -1.0 } else { 1.0 };
        Ok(found.times(&Real::Plain(sign)))
    }

    /// II(d, d)/I(d, d) of the part of a direction in the tangent plane.
    pub(super) fn normal_curvature(&self, at: &Varying, direction: &Vector) -> Measured<Real> {
        let (p, q) = (direction.dot(&at.derivative(1, 0)?), direction.dot(&at.derivative(0, 1)?));
        let [e, f, g] = &self.first;
        let (a, b) = (g.times(&p).minus(&f.times(&q)), e.times(&q).minus(&f.times(&p)));
        let form = |[x, y, z]: &[Real; 3]| {
            let mixed = y.times(&a).times(&b).scaled(2.0);
            x.times(&a).times(&a).plus(&mixed).plus(&z.times(&b).times(&b))
        };
        form(&self.second).over(&form(&self.first))
    }
}

/// The parameters of the nearest point where the surface or the point varies, which are given at their values: where S − P is at
/// right angles to Su and Sv, or an edge of the surface that they stay at.
pub(super) fn closest(surface: &RealSurface, p: &Vector, place: [f64; 2]) -> Measured<[Real; 2]> {
    let beside = match p {
        Vector::Plain(_) => None,
        Vector::Jets(jets) => Some(&jets[0]),
    };
    let parameters = place.map(Real::Plain);
    let Some([like, _]) = &surface.jets_of([&parameters[0], &parameters[1]], beside)? else {
        return Ok(parameters);
    };
    let here = surface.derivatives_at(place[0], place[1], 2)?;
    let way = here.get(0, 0) - p.value();
    let [by_u, by_v] = [here.get(1, 0), here.get(0, 1)];
    let domains = [surface.domain_u(), surface.domain_v()];
    let is_held = |i: usize, by: DVec3| {
        let (slope, rounding) = (way.dot(by), LAST_BIT.sqrt() * way.length() * by.length());
        place[i] <= domains[i].start() && rounding < slope
            || domains[i].end() <= place[i] && slope < -rounding
    };
    let held = [is_held(0, by_u), is_held(1, by_v)];
    let bend = |a: DVec3, b: DVec3, second: DVec3| a.dot(b) + way.dot(second);
    let mut matrix = DMat2::from_cols(
        DVec2::new(bend(by_u, by_u, here.get(2, 0)), bend(by_u, by_v, here.get(1, 1))),
        DVec2::new(bend(by_u, by_v, here.get(1, 1)), bend(by_v, by_v, here.get(0, 2))),
    );
    let scale = by_u.length_squared() * by_v.length_squared();
    for i in (0..2).filter(|&i| held[i]) {
        // What is held does not move.
        let own = matrix.col(i)[i].abs().max(f64::MIN_POSITIVE);
        *matrix.col_mut(i) = DVec2::ZERO;
        matrix.col_mut(1 - i)[i] = 0.0;
        matrix.col_mut(i)[i] = own;
    }
    let is_minimum = LAST_BIT.sqrt() * scale < matrix.determinant() && 0.0 < matrix.x_axis.x;
    if !is_minimum {
        let what = "the nearest place of the surface";
        return Err(LocalError::NotDifferentiable { what, at: place[0] }.into());
    }
    let inverse = matrix.inverse();
    let mut found = place.map(|t| like.same(t));
    for _ in 0..like.order() {
        let at = Varying::new(surface, &found, 1)?;
        let way = at.derivative(0, 0)?.minus(p);
        let slope = |i: usize| -> Measured<Jet> {
            if held[i] {
                return Ok(like.same(0.0));
            }
            Ok(way.dot(&at.derivative(1 - i, i)?).like(like))
        };
        let slopes = [slope(0)?, slope(1)?];
        found = [0, 1].map(|i| {
            let step =
                slopes[0].scaled(inverse.x_axis[i]).plus(&slopes[1].scaled(inverse.y_axis[i]));
            found[i].minus(&step).with_value(place[i])
        });
    }
    Ok(found.map(Real::Jet))
}

/// The point of a surface at parameters that vary.
pub(super) fn point(
    surface: &RealSurface,
    parameters: &[Real; 2],
    value: DVec3,
) -> Measured<Vector> {
    match surface.jets_of([&parameters[0], &parameters[1]], None)? {
        None => Ok(Vector::Plain(value)),
        Some(parameters) => {
            let point = Varying::new(surface, &parameters, 0)?.derivative(0, 0)?;
            Ok(point.with_value(value))
        }
    }
}
