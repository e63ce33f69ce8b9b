//! Surfaces whose control points depend on variables: their points and derivatives.

use std::sync::Arc;

use glam::{DVec3, DVec4};

use super::{PointSlopes, binomials};
use crate::{
    CountError, GeomError, Grid, Jet, KnotVector, LocalError, NurbsSurface, Side, homogeneous,
    tolerance::{EXACT_RELATIVE, LAST_BIT},
};

/// A surface and the slopes of its control points by several variables, row after row.
///
/// The middle of a square one corner of which rises:
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{Jet, NurbsSurface, PointSlopes, VariedSurface, glam::{DVec3, DVec4}};
///
/// let square = NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::new(1.0, 1.0, 0.0))?;
/// let slopes = PointSlopes::new(1, 4, vec![(0, vec![DVec4::ZERO, DVec4::ZERO, DVec4::ZERO, DVec4::Z])])?;
/// let varied = VariedSurface::new(Arc::new(square), slopes)?;
/// let half = Jet::with_slopes(0.5, &[0.0])?;
/// let middle = varied.derivatives_at([&half, &half], 0)?;
/// assert_eq!(middle.row(0)[0][2].slopes(), [0.25]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct VariedSurface {
    surface: Arc<NurbsSurface>,
    slopes: PointSlopes,
    /// The same surface on its own knots, where these move: `surface` has more of them, which do not.
    given: Option<Arc<NurbsSurface>>,
}

impl VariedSurface {
    /// A surface with the slopes of its control points.
    ///
    /// # Errors
    /// [`CountError::TooFewPoints`] for slopes of another number of points.
    pub fn new(surface: Arc<NurbsSurface>, slopes: PointSlopes) -> Result<Self, GeomError> {
        let needed = surface.control_points().as_slice().len();
        match slopes.by_variable().iter().find(|(_, slopes)| slopes.len() != needed) {
            Some((_, slopes)) => Err(CountError::TooFewPoints { got: slopes.len(), needed }.into()),
            None => Ok(Self { surface, slopes, given: None }),
        }
    }

    /// The same as the form of a surface whose own knots move; none unless both are one surface.
    #[must_use]
    pub fn of_moving_knots(self, given: Arc<NurbsSurface>) -> Option<Self> {
        let knots = |surface: &NurbsSurface| [surface.knots_u().clone(), surface.knots_v().clone()];
        let is_other = knots(&self.surface) != knots(&given);
        is_same(&self.surface, &given).then_some(Self { given: is_other.then_some(given), ..self })
    }

    /// The surface on its own knots: those of [`Self::surface`], unless they move.
    #[must_use]
    pub fn given(&self) -> &Arc<NurbsSurface> {
        self.given.as_ref().unwrap_or(&self.surface)
    }

    /// Whether its own knots move, so that its control points have no slopes but those of another form.
    #[must_use]
    pub fn has_moving_knots(&self) -> bool {
        self.given.is_some()
    }

    /// The surface itself.
    #[must_use]
    pub fn surface(&self) -> &Arc<NurbsSurface> {
        &self.surface
    }

    /// The slopes of its control points.
    #[must_use]
    pub fn slopes(&self) -> &PointSlopes {
        &self.slopes
    }

    /// The surface with some variables moved by steps, the control points along their slopes.
    ///
    /// # Errors
    /// As for [`NurbsSurface::new`].
    pub fn moved(&self, steps: &[(usize, f64)]) -> Result<NurbsSurface, GeomError> {
        let net = self.surface.control_points();
        let points = self.slopes.moved(net.as_slice(), steps);
        let net = Grid::new(net.n_rows(), net.n_columns(), points)?;
        NurbsSurface::new(self.surface.knots_u().clone(), self.surface.knots_v().clone(), net)
    }

    /// The point and derivatives at parameters that may vary with the variables: row k, column l holds the
    /// one of order k in u and l in v, for both up to `order`.
    ///
    /// As [`VariedCurve::derivatives_beside`](crate::VariedCurve::derivatives_beside), in two parameters.
    ///
    /// # Errors
    /// [`LocalError::DerivativeBeyondNumbers`](crate::LocalError::DerivativeBeyondNumbers).
    pub fn derivatives_at(
        &self,
        [u, v]: [&Jet; 2],
        order: usize,
    ) -> Result<Grid<[Jet; 3]>, GeomError> {
        let (knots_u, knots_v) = (self.surface.knots_u(), self.surface.knots_v());
        let place = [u.value(), v.value()];
        let spans = [knots_u.span_at(place[0]), knots_v.span_at(place[1])];
        let (space, slopes) = self.slopes_on(spans, place, order);
        if self.given.is_some() {
            let before = [
                knots_u.span_beside(place[0], Side::Left),
                knots_v.span_beside(place[1], Side::Left),
            ];
            for other in [[before[0], spans[1]], [spans[0], before[1]], before] {
                if other != spans {
                    self.check_meeting(&slopes, other, place, order)?;
                }
            }
        }
        let vector = |(k, l): (usize, usize)| {
            let own: Vec<DVec3> = slopes.iter().map(|slopes| slopes.get(k, l)).collect();
            let growths = [(u, space.get(k + 1, l)), (v, space.get(k, l + 1))];
            self.slopes.vector(space.get(k, l), &own, &growths)
        };
        let orders = (0..=order).flat_map(|k| (0..=order).map(move |l| (k, l)));
        Grid::new(order + 1, order + 1, orders.map(vector).collect::<Result<_, _>>()?)
    }

    /// Derivatives up to one more than an order by the patch over spans, and their slopes by each variable that the points
    /// depend on, up to the order.
    fn slopes_on(
        &self,
        spans: [usize; 2],
        place: [f64; 2],
        order: usize,
    ) -> (Grid<DVec3>, Vec<Grid<DVec3>>) {
        let weighted = self.surface.homogeneous_derivatives_on(spans, place, order + 1);
        let space = homogeneous::quotient_grid(&weighted);
        let of_variable = |(_, slopes): &(usize, Vec<DVec4>)| {
            let own = self.weighted_slopes(slopes, spans, place, order);
            space_slopes(&own, &weighted, &space)
        };
        let slopes = self.slopes.by_variable().iter().map(of_variable).collect();
        (space, slopes)
    }

    /// Fails where the patch beside a knot that moves grows in another way.
    fn check_meeting(
        &self,
        slopes: &[Grid<DVec3>],
        spans: [usize; 2],
        place: [f64; 2],
        order: usize,
    ) -> Result<(), GeomError> {
        let (_, beside) = self.slopes_on(spans, place, order);
        let points = self.surface.points();
        let vectors = slopes.iter().flat_map(Grid::as_slice).chain(points.as_slice());
        let size = vectors.map(|vector| vector.length()).fold(0.0, f64::max);
        let allowed = LAST_BIT.sqrt() * size;
        let orders = || (0..=order).flat_map(|k| (0..=order - k).map(move |l| (k, l)));
        let differ = |(own, beside): (&Grid<DVec3>, &Grid<DVec3>)| {
            orders().any(|(k, l)| allowed < own.get(k, l).distance(beside.get(k, l)))
        };
        if slopes.iter().zip(&beside).any(differ) {
            let what = "the surface at its knot";
            return Err(LocalError::NotDifferentiable { what, at: place[0] }.into());
        }
        Ok(())
    }

    /// Homogeneous derivatives of the surface that has the slopes of one variable for control points.
    fn weighted_slopes(
        &self,
        slopes: &[DVec4],
        [span_u, span_v]: [usize; 2],
        [u, v]: [f64; 2],
        order: usize,
    ) -> Grid<DVec4> {
        let (knots_u, knots_v) = (self.surface.knots_u(), self.surface.knots_v());
        let basis_u = knots_u.basis_derivatives_on(span_u, u, order.min(knots_u.degree()));
        let basis_v = knots_v.basis_derivatives_on(span_v, v, order.min(knots_v.degree()));
        let n_columns = self.surface.control_points().n_columns();
        Grid::from_fn(order + 1, order + 1, |k, l| {
            let mut sum = DVec4::ZERO;
            if k < basis_u.n_rows() && l < basis_v.n_rows() {
                for (i, &n_u) in knots_u.support(span_u).zip(basis_u.row(k)) {
                    for (j, &n_v) in knots_v.support(span_v).zip(basis_v.row(l)) {
                        sum += slopes[i * n_columns + j] * (n_u * n_v);
                    }
                }
            }
            sum
        })
    }
}

/// Whether a surface and one on fewer knots are the same, as far as p + 1 by q + 1 places on each patch of the
/// first tell.
fn is_same(fine: &NurbsSurface, coarse: &NurbsSurface) -> bool {
    let knots = [fine.knots_u(), fine.knots_v()];
    if knots.map(KnotVector::domain) != [coarse.domain_u(), coarse.domain_v()] {
        return false;
    }
    let [us, vs] = knots.map(|knots| {
        let n = knots.degree() + 1;
        let place =
            |(span, k): (usize, usize)| knots.span_interval(span).at((k as f64 + 0.5) / n as f64);
        knots
            .spans()
            .flat_map(|span| (0..n).map(move |k| (span, k)))
            .map(place)
            .collect::<Vec<f64>>()
    });
    let (fine, coarse) = (fine.points_on_grid(&us, &vs), coarse.points_on_grid(&us, &vs));
    let size = fine.as_slice().iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
    let pairs = fine.as_slice().iter().zip(coarse.as_slice());
    pairs.map(|(a, b)| a.distance(*b)).fold(0.0, f64::max) <= EXACT_RELATIVE * size
}

/// The slopes of derivatives in space, from those of the homogeneous ones.
fn space_slopes(own: &Grid<DVec4>, weighted: &Grid<DVec4>, space: &Grid<DVec3>) -> Grid<DVec3> {
    let numerators = Grid::from_fn(own.n_rows(), own.n_columns(), |k, l| {
        let mut sum = own.get(k, l).truncate();
        for (i, of_u) in binomials(k).enumerate() {
            for (j, of_v) in binomials(l).enumerate() {
                sum -= space.get(k - i, l - j) * (of_u * of_v * own.get(i, j).w);
            }
        }
        sum.extend(weighted.get(k, l).w)
    });
    homogeneous::quotient_grid(&numerators)
}
