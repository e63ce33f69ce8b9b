//! Surfaces whose control points depend on variables: their points and derivatives.

use std::{ops::Range, sync::Arc};

use glam::DVec3;

use super::{PointSlopes, orders::Orders, rows::VariableRows, same_shape::is_same_surface};
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
/// assert_eq!(middle[0][0][2].slopes(), [0.25]);
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
        match slopes.is_fixed() || slopes.n_points() == needed {
            true => Ok(Self { surface, slopes, given: None }),
            false => Err(CountError::TooFewPoints { got: slopes.n_points(), needed }.into()),
        }
    }

    /// A surface that does not depend on so many variables.
    ///
    /// # Errors
    /// None but those of [`Self::new`].
    pub fn fixed(surface: Arc<NurbsSurface>, n_variables: usize) -> Result<Self, GeomError> {
        let n_points = surface.control_points().as_slice().len();
        Self::new(surface, PointSlopes::new(n_variables, n_points, Vec::new())?)
    }

    /// The same as the form of a surface whose own knots move; none unless both are one surface.
    #[must_use]
    pub fn of_moving_knots(self, given: Arc<NurbsSurface>) -> Option<Self> {
        let is_it = !has_other_knots(&self.surface, &given)
            && self.surface.control_points() == given.control_points();
        (is_it || is_same_surface(&given, &self.surface) || is_same(&self.surface, &given))
            .then(|| self.known_of_moving_knots(given))
    }

    /// The same as the form of a surface whose own knots move, which it is known to be.
    pub(crate) fn known_of_moving_knots(self, given: Arc<NurbsSurface>) -> Self {
        let is_other = has_other_knots(&self.surface, &given);
        Self { given: is_other.then_some(given), ..self }
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
    /// one of order k in u and l in v, for all of a total order up to `order`.
    ///
    /// As [`VariedCurve::derivatives_beside`](crate::VariedCurve::derivatives_beside), in two parameters.
    ///
    /// # Errors
    /// [`LocalError::DerivativeBeyondNumbers`](crate::LocalError::DerivativeBeyondNumbers).
    pub fn derivatives_at(
        &self,
        [u, v]: [&Jet; 2],
        order: usize,
    ) -> Result<Vec<Vec<[Jet; 3]>>, GeomError> {
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
        let orders = Orders { most: order, of_surface: true };
        let vector = |k: usize, l: usize| {
            let place = orders.place(k, l);
            let growths = [(u, space.get(k + 1, l)), (v, space.get(k, l + 1))];
            self.slopes.vector(space.get(k, l), slopes.column(place), &growths)
        };
        (0..=order).map(|k| (0..=order - k).map(|l| vector(k, l)).collect()).collect()
    }

    /// Derivatives up to one more than an order by the patch over spans, and their slopes by each variable that moves it,
    /// up to the order.
    fn slopes_on(
        &self,
        spans: [usize; 2],
        [u, v]: [f64; 2],
        order: usize,
    ) -> (Grid<DVec3>, VariableRows<DVec3>) {
        let weighted = self.surface.homogeneous_derivatives_on(spans, [u, v], order + 1);
        let space = homogeneous::quotient_grid(&weighted);
        let orders = Orders { most: order, of_surface: true };
        let weights: Vec<f64> = orders.all().map(|(k, l)| weighted.get(k, l).w).collect();
        let held: Vec<DVec3> = orders.all().map(|(k, l)| space.get(k, l)).collect();
        let (acting, factors) = self.acting(spans, [u, v], orders);
        let sums = self.slopes.sums(acting.iter().cloned(), &factors);
        (space, orders.in_space(&sums, (&weights, self.surface.is_rational()), &held))
    }

    /// The control points that act on a patch, and by how much each does on the derivatives at a place.
    fn acting(
        &self,
        [span_u, span_v]: [usize; 2],
        [u, v]: [f64; 2],
        orders: Orders,
    ) -> (Vec<Range<usize>>, Grid<f64>) {
        let (knots_u, knots_v) = (self.surface.knots_u(), self.surface.knots_v());
        let [basis_u, basis_v] =
            [(knots_u, span_u, u), (knots_v, span_v, v)].map(|(knots, span, t)| {
                knots.basis_derivatives_on(span, t, orders.most.min(knots.degree()))
            });
        let n_columns = self.surface.control_points().n_columns();
        let [support_u, support_v] = [(knots_u, span_u), (knots_v, span_v)]
            .map(|(knots, span)| span - knots.degree()..span + 1);
        let row = |i: usize| i * n_columns + support_v.start..i * n_columns + support_v.end;
        let factor = |point: usize, (k, l): (usize, usize)| {
            let (i, j) = (point / support_v.len(), point % support_v.len());
            let is_any = k < basis_u.n_rows() && l < basis_v.n_rows();
            if is_any { basis_u.get(k, i) * basis_v.get(l, j) } else { 0.0 }
        };
        let n_points = support_u.len() * support_v.len();
        let factors = (0..n_points).flat_map(|point| orders.all().map(move |order| (point, order)));
        let factors = factors.map(|(point, order)| factor(point, order)).collect();
        let acting = support_u.map(row).collect();
        (acting, Grid::from_rows_of(orders.len(), factors))
    }

    /// Fails where the patch beside a knot that moves grows in another way.
    fn check_meeting(
        &self,
        slopes: &VariableRows<DVec3>,
        spans: [usize; 2],
        place: [f64; 2],
        order: usize,
    ) -> Result<(), GeomError> {
        let (_, beside) = self.slopes_on(spans, place, order);
        let points = self.surface.points();
        let own = slopes.vectors().iter();
        let size = own.chain(points.as_slice()).map(|vector| vector.length()).fold(0.0, f64::max);
        let allowed = LAST_BIT.sqrt() * size;
        let n_orders = Orders { most: order, of_surface: true }.len();
        let still = vec![DVec3::ZERO; n_orders];
        let differ = |(variable, _): (usize, &[DVec3])| {
            let [own, beside] =
                [slopes, &beside].map(|all| all.row_of(variable).unwrap_or(&still).iter());
            own.zip(beside).any(|(own, beside)| allowed < own.distance(*beside))
        };
        if slopes.rows().chain(beside.rows()).any(differ) {
            let what = "the surface at its knot";
            return Err(LocalError::NotDifferentiable { what, at: place[0] }.into());
        }
        Ok(())
    }
}

fn has_other_knots(a: &NurbsSurface, b: &NurbsSurface) -> bool {
    a.knots_u() != b.knots_u() || a.knots_v() != b.knots_v()
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
