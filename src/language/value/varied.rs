//! Curves and surfaces as operations take them that can be differentiated: as they are, or with control
//! points that carry derivatives.

use std::{ops::Deref, sync::Arc};

use super::{FromValue, IntoValue, Mismatch, Real, Type, Value, Vector};
use crate::{
    diag::Span,
    kernel::{
        Curve, GeomError, Grid, Jet, LocalError, Side, Surface, VariedCurve, VariedSurface, jet,
    },
};

/// A curve, or one that depends on the parameters of a function that is differentiated.
#[derive(Clone, Debug)]
pub struct RealCurve {
    curve: Curve,
    varied: Option<Arc<VariedCurve>>,
}

/// A surface, or one that depends on the parameters of a function that is differentiated.
#[derive(Clone, Debug)]
pub struct RealSurface {
    surface: Surface,
    varied: Option<Arc<VariedSurface>>,
}

/// The plain curve.
impl Deref for RealCurve {
    type Target = Curve;

    fn deref(&self) -> &Curve {
        &self.curve
    }
}

/// The plain surface.
impl Deref for RealSurface {
    type Target = Surface;

    fn deref(&self) -> &Surface {
        &self.surface
    }
}

/// A parameter beside what varies, as a jet of as many variables.
fn beside(t: &Real, n_variables: Option<usize>) -> Result<Option<Jet>, GeomError> {
    Ok(match (t, n_variables) {
        (Real::Jet(jet), _) => Some(jet.clone()),
        (Real::Plain(_), None) => None,
        (Real::Plain(t), Some(n)) => Some(Jet::with_slopes(*t, &vec![0.0; n])?),
    })
}

impl RealCurve {
    /// The curve with its slopes, where it has any.
    #[must_use]
    pub fn varied(&self) -> Option<&VariedCurve> {
        self.varied.as_deref()
    }

    /// A parameter as a jet, where it or the curve carries derivatives.
    ///
    /// # Errors
    /// A parameter that is no number.
    pub fn jet_of(&self, t: &Real) -> Result<Option<Jet>, GeomError> {
        beside(t, self.varied().map(|varied| varied.slopes().n_variables()))
    }

    /// C, C', … up to an order, at a parameter that varies.
    ///
    /// # Errors
    /// As for [`Curve::derivatives_beside`], and where a derivative is no number, or that of a point goes over from one to another.
    pub fn series_beside(
        &self,
        t: &Jet,
        side: Side,
        order: usize,
    ) -> Result<Vec<Vector>, GeomError> {
        // Directions and curvatures may go on where derivatives by the parameter do not: of them the side is asked for.
        if order == 0 && t.goes_both_ways() && !self.curve.is_smooth_at(t.value(), 1) {
            let what = "the curve at its knot";
            return Err(LocalError::NotDifferentiable { what, at: t.value() }.into());
        }
        if let Some(varied) = &self.varied {
            let all = varied.derivatives_beside(t, side, order)?;
            return Ok(all.into_iter().map(|jets| Vector::Jets(Box::new(jets))).collect());
        }
        let all = self.curve.derivatives_beside(t.value(), side, t.order() + order)?;
        let one = |k: usize| Ok(Vector::Jets(Box::new(jet::along(&all[k..=k + t.order()], t)?)));
        (0..=order).map(one).collect()
    }
}

impl RealSurface {
    /// The surface with its slopes, where it has any.
    #[must_use]
    pub fn varied(&self) -> Option<&VariedSurface> {
        self.varied.as_deref()
    }

    /// Both parameters as jets, where one of them, the surface or what stands beside carries derivatives.
    ///
    /// # Errors
    /// A parameter that is no number.
    pub fn jets_of(
        &self,
        [u, v]: [&Real; 2],
        like: Option<&Jet>,
    ) -> Result<Option<[Jet; 2]>, GeomError> {
        let own = beside(u, self.varied().map(|varied| varied.slopes().n_variables()))?;
        let like = match (&own, u, v) {
            (Some(jet), ..) | (None, _, Real::Jet(jet)) => jet,
            _ => match like {
                Some(jet) => jet,
                None => return Ok(None),
            },
        };
        Ok(Some([u.like(like), v.like(like)]))
    }

    /// S and its derivatives for both parameters up to an order, at parameters that vary: those of a total
    /// order up to it.
    ///
    /// # Errors
    /// As for [`Surface::derivatives_at`], and where a derivative is no number.
    pub fn series_at(&self, [u, v]: [&Jet; 2], order: usize) -> Result<Grid<Vector>, GeomError> {
        if let Some(varied) = &self.varied {
            let beyond = || std::iter::repeat(Vector::Plain(glam::DVec3::ZERO));
            let row = |own: Vec<[Jet; 3]>| {
                own.into_iter()
                    .map(|jets| Vector::Jets(Box::new(jets)))
                    .chain(beyond())
                    .take(order + 1)
            };
            let all = varied.derivatives_at([u, v], order)?.into_iter().flat_map(row).collect();
            return Grid::new(order + 1, order + 1, all);
        }
        let n = u.order();
        let all = self.surface.derivatives_at(u.value(), v.value(), n + order)?;
        let one = |(by_u, by_v): (usize, usize)| {
            if order < by_u + by_v {
                return Ok(Vector::Plain(glam::DVec3::ZERO));
            }
            let here = Grid::from_fn(n + 1, n + 1, |k, l| match k + l <= n {
                true => all.get(k + by_u, l + by_v),
                false => glam::DVec3::ZERO,
            });
            Ok(Vector::Jets(Box::new(jet::across(&here, u, v)?)))
        };
        let orders = (0..=order).flat_map(|k| (0..=order).map(move |l| (k, l)));
        Grid::new(order + 1, order + 1, orders.map(one).collect::<Result<_, GeomError>>()?)
    }
}

impl From<Curve> for RealCurve {
    fn from(curve: Curve) -> Self {
        Self { curve, varied: None }
    }
}

impl From<Surface> for RealSurface {
    fn from(surface: Surface) -> Self {
        Self { surface, varied: None }
    }
}

impl From<Arc<VariedCurve>> for RealCurve {
    fn from(varied: Arc<VariedCurve>) -> Self {
        Self { curve: Curve::Nurbs(Arc::clone(varied.given())), varied: Some(varied) }
    }
}

impl From<Arc<VariedSurface>> for RealSurface {
    fn from(varied: Arc<VariedSurface>) -> Self {
        Self { surface: Surface::Nurbs(Arc::clone(varied.given())), varied: Some(varied) }
    }
}

impl FromValue for RealCurve {
    const TYPE: Type = Type::Curve;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        match value {
            Value::JetCurve(varied) => Ok(Arc::clone(varied).into()),
            _ => Curve::from_value(value, span).map(Self::from),
        }
    }
}

impl FromValue for RealSurface {
    const TYPE: Type = Type::Surface;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        match value {
            Value::JetSurface(varied) => Ok(Arc::clone(varied).into()),
            _ => Surface::from_value(value, span).map(Self::from),
        }
    }
}

impl IntoValue for RealCurve {
    const RETURNS: Type = Type::Curve;

    fn into_value(self) -> Value {
        match self.varied {
            Some(varied) => Value::JetCurve(varied),
            None => Value::Curve(self.curve),
        }
    }
}

impl IntoValue for RealSurface {
    const RETURNS: Type = Type::Surface;

    fn into_value(self) -> Value {
        match self.varied {
            Some(varied) => Value::JetSurface(varied),
            None => Value::Surface(self.surface),
        }
    }
}
