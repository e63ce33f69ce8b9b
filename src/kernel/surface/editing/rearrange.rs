//! Parts of surfaces of either kind, and the same surface with its parameters run differently.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    Curve, DomainError, FunctionFailure, GeomError, Grid, Interval,
    surface::{Direction, ParametricSurface, Surface, SurfaceFunction},
    tolerance::KNOT_RELATIVE,
};

impl Surface {
    /// The parameters along a direction that have points.
    #[must_use]
    pub fn domain(&self, along: Direction) -> Interval {
        match along {
            Direction::U => self.domain_u(),
            Direction::V => self.domain_v(),
        }
    }

    /// The part over an interval of one parameter, with the parameters that it had.
    ///
    /// # Errors
    /// [`DomainError::ParameterOutside`] the domain; [`DomainError::NarrowInterval`] shorter than a
    /// span can be; and as [`Self::point_at`].
    pub fn trimmed(&self, along: Direction, interval: Interval) -> Result<Self, GeomError> {
        match self {
            Self::Nurbs(surface) => surface.trimmed(along, interval).map(Self::from),
            Self::Parametric(surface) => surface.trimmed(along, interval).map(Self::from),
        }
    }

    /// Both parts at a parameter, each on its part of the domain.
    ///
    /// # Errors
    /// [`DomainError::ParameterOutside`] the domain; [`DomainError::ParameterAtEnd`] of it; and as
    /// [`Self::point_at`].
    pub fn split(&self, along: Direction, t: f64) -> Result<[Self; 2], GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(surface.split(along, t)?.map(Self::from)),
            Self::Parametric(surface) => Ok(surface.split(along, t)?.map(Self::from)),
        }
    }

    /// The same points run through backwards along a direction, on the same domain: the normal
    /// turns around.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn reversed(&self, along: Direction) -> Result<Self, GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(surface.reversed(along).into()),
            Self::Parametric(surface) => {
                surface.rearranged(Reparametrization::Reversed(along)).map(Self::from)
            }
        }
    }

    /// The same points with u and v exchanged: the normal turns around.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn swapped(&self) -> Result<Self, GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(surface.swapped().into()),
            Self::Parametric(surface) => {
                surface.rearranged(Reparametrization::Swapped).map(Self::from)
            }
        }
    }

    /// The curve of constant parameter of the *other* direction, which runs along this one.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn isocurve(&self, along: Direction, at: f64) -> Result<Curve, GeomError> {
        match along {
            Direction::U => self.isocurve_v(at),
            Direction::V => self.isocurve_u(at),
        }
    }

    /// The boundary, `[u0, u1, v0, v1]`: first and last u, then first and last v.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn edges(&self) -> Result<[Curve; 4], GeomError> {
        let (u, v) = (self.domain_u(), self.domain_v());
        Ok([
            self.isocurve_u(u.start())?,
            self.isocurve_u(u.end())?,
            self.isocurve_v(v.start())?,
            self.isocurve_v(v.end())?,
        ])
    }

    /// The corners, first index along u.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn corners(&self) -> Result<[[DVec3; 2]; 2], GeomError> {
        let (u, v) = (self.domain_u(), self.domain_v());
        let at = |u, v| self.point_at(u, v);
        Ok([
            [at(u.start(), v.start())?, at(u.start(), v.end())?],
            [at(u.end(), v.start())?, at(u.end(), v.end())?],
        ])
    }
}

impl ParametricSurface {
    fn trimmed(&self, along: Direction, interval: Interval) -> Result<Self, GeomError> {
        let domain = self.domain(along);
        let (start, end) =
            (domain.clamp_inside(interval.start())?, domain.clamp_inside(interval.end())?);
        if end - start <= KNOT_RELATIVE * domain.length() {
            return Err(DomainError::NarrowInterval { start, end }.into());
        }
        self.over(along, Interval::new(start, end)?)
    }

    fn split(&self, along: Direction, t: f64) -> Result<[Self; 2], GeomError> {
        let domain = self.domain(along);
        let t = domain.clamp_inside(t)?;
        let slack = KNOT_RELATIVE * domain.length();
        if t - domain.start() <= slack || domain.end() - t <= slack {
            return Err(DomainError::ParameterAtEnd { parameter: t, domain }.into());
        }
        let (before, behind) = (Interval::new(domain.start(), t)?, Interval::new(t, domain.end())?);
        Ok([self.over(along, before)?, self.over(along, behind)?])
    }

    fn rearranged(&self, change: Reparametrization) -> Result<Self, GeomError> {
        let domains = match change {
            Reparametrization::Swapped => [self.domain_v(), self.domain_u()],
            Reparametrization::Reversed(_) => [self.domain_u(), self.domain_v()],
        };
        let function = ReparametrizedSurface { surface: self.clone(), change };
        Self::new(domains[0], domains[1], Arc::new(function))
    }
}

/// How the parameters of a function are run differently.
#[derive(Clone, Copy, Debug)]
enum Reparametrization {
    /// u and v exchanged.
    Swapped,
    /// One of them backwards over its domain.
    Reversed(Direction),
}

/// A surface with other parameters.
#[derive(Debug)]
struct ReparametrizedSurface {
    surface: ParametricSurface,
    change: Reparametrization,
}

impl SurfaceFunction for ReparametrizedSurface {
    fn derivatives_at(&self, u: f64, v: f64, order: usize) -> Result<Grid<DVec3>, FunctionFailure> {
        let at =
            |u: f64, v: f64| self.surface.derivatives_at(u, v, order).map_err(FunctionFailure::new);
        let back = |along: Direction, t: f64| {
            let domain = self.surface.domain(along);
            (domain.start() + (domain.end() - t)).clamp(domain.start(), domain.end())
        };
        let odd = |k: usize| if k % 2 == 1 { -1.0 } else { 1.0 };
        let n = order + 1;
        Ok(match self.change {
            Reparametrization::Swapped => at(v, u)?.transposed(),
            Reparametrization::Reversed(Direction::U) => {
                let forward = at(back(Direction::U, u), v)?;
                Grid::from_fn(n, n, |k, l| forward.get(k, l) * odd(k))
            }
            Reparametrization::Reversed(Direction::V) => {
                let forward = at(u, back(Direction::V, v))?;
                Grid::from_fn(n, n, |k, l| forward.get(k, l) * odd(l))
            }
        })
    }
}
