//! Curves whose control points depend on variables: their points and derivatives.

use std::sync::Arc;

use glam::DVec3;

use super::{PointSlopes, orders::Orders, rows::VariableRows, same_shape::is_same_curve};
use crate::{
    GeomError, Grid, Jet, LocalError, NurbsCurve, Side, homogeneous,
    tolerance::{EXACT_RELATIVE, LAST_BIT},
};

/// A curve and the slopes of its control points by several variables.
///
/// The middle of a parabola whose inner control point rises:
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{Jet, NurbsCurve, PointSlopes, Side, VariedCurve, glam::{DVec3, DVec4}};
///
/// let points = [DVec3::ZERO, DVec3::new(1.0, 2.0, 0.0), DVec3::X * 2.0];
/// let curve = Arc::new(NurbsCurve::bezier(&points)?);
/// let slopes = PointSlopes::new(1, 3, vec![(0, vec![DVec4::ZERO, DVec4::Y, DVec4::ZERO])])?;
/// let varied = VariedCurve::new(curve, slopes)?;
/// let middle = &varied.derivatives_beside(&Jet::with_slopes(0.5, &[0.0])?, Side::Right, 0)?[0];
/// assert_eq!((middle[1].value(), middle[1].slopes()), (1.0, &[0.5][..]));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct VariedCurve {
    curve: Arc<NurbsCurve>,
    slopes: PointSlopes,
    /// The same curve on its own knots, where these move: `curve` has more of them, which do not.
    given: Option<Arc<NurbsCurve>>,
}

impl VariedCurve {
    /// A curve with the slopes of its control points.
    ///
    /// # Errors
    /// `KnotError::KnotCount` for slopes of another number of points.
    pub fn new(curve: Arc<NurbsCurve>, slopes: PointSlopes) -> Result<Self, GeomError> {
        if !slopes.is_fixed() {
            curve.knots().check_points(slopes.n_points())?;
        }
        Ok(Self { curve, slopes, given: None })
    }

    /// A curve that does not depend on so many variables.
    ///
    /// # Errors
    /// None but those of [`Self::new`].
    pub fn fixed(curve: Arc<NurbsCurve>, n_variables: usize) -> Result<Self, GeomError> {
        let n_points = curve.control_points().len();
        Self::new(curve, PointSlopes::new(n_variables, n_points, Vec::new())?)
    }

    /// The same as the form of a curve whose own knots move; none unless both are one curve.
    #[must_use]
    pub fn of_moving_knots(self, given: Arc<NurbsCurve>) -> Option<Self> {
        let is_one = is_same_curve(&given, &self.curve);
        (is_one || is_same(&self.curve, &given)).then(|| self.known_of_moving_knots(given))
    }

    /// The same as the form of a curve whose own knots move, which it is known to be.
    pub(crate) fn known_of_moving_knots(self, given: Arc<NurbsCurve>) -> Self {
        let is_other = self.curve.knots() != given.knots();
        Self { given: is_other.then_some(given), ..self }
    }

    /// The curve on its own knots: those of [`Self::curve`], unless they move.
    #[must_use]
    pub fn given(&self) -> &Arc<NurbsCurve> {
        self.given.as_ref().unwrap_or(&self.curve)
    }

    /// Whether its own knots move, so that its control points have no slopes but those of another form.
    #[must_use]
    pub fn has_moving_knots(&self) -> bool {
        self.given.is_some()
    }

    /// The curve itself.
    #[must_use]
    pub fn curve(&self) -> &Arc<NurbsCurve> {
        &self.curve
    }

    /// The slopes of its control points.
    #[must_use]
    pub fn slopes(&self) -> &PointSlopes {
        &self.slopes
    }

    /// The curve with some variables moved by steps, the control points along their slopes.
    ///
    /// # Errors
    /// As for [`NurbsCurve::new`].
    pub fn moved(&self, steps: &[(usize, f64)]) -> Result<NurbsCurve, GeomError> {
        let points = self.slopes.moved(self.curve.control_points(), steps);
        NurbsCurve::new(self.curve.knots().clone(), points)
    }

    /// The point and derivatives up to an order, of the piece on one side of a parameter that may vary with
    /// the variables.
    ///
    /// By the slopes of Leibniz' rule for w·C, whose derivatives are linear in the control points.
    /// Piegl & Tiller, *The NURBS Book*, (4.8).
    ///
    /// # Errors
    /// [`LocalError::DerivativeBeyondNumbers`](crate::LocalError::DerivativeBeyondNumbers).
    pub fn derivatives_beside(
        &self,
        t: &Jet,
        side: Side,
        order: usize,
    ) -> Result<Vec<[Jet; 3]>, GeomError> {
        let span = self.curve.knots().span_beside(t.value(), side);
        let (space, slopes) = self.slopes_on(span, t.value(), order);
        if self.given.is_some() {
            let spans = [Side::Left, Side::Right]
                .map(|side| self.curve.knots().span_beside(t.value(), side));
            if spans[0] != spans[1] {
                self.check_meeting(spans, t.value(), order)?;
            }
        }
        let vector =
            |k: usize| self.slopes.vector(space[k], slopes.column(k), &[(t, space[k + 1])]);
        (0..=order).map(vector).collect()
    }

    /// Derivatives up to one more than an order by the piece over a span, and their slopes by each variable that
    /// moves it, up to the order.
    fn slopes_on(&self, span: usize, t: f64, order: usize) -> (Vec<DVec3>, VariableRows<DVec3>) {
        let knots = self.curve.knots();
        let weighted = self.curve.homogeneous_derivatives(span, t, order + 1);
        let space = homogeneous::quotient(&weighted);
        let weights: Vec<f64> = weighted.iter().map(|derivative| derivative.w).collect();
        let basis = knots.basis_derivatives_on(span, t, order.min(knots.degree()));
        let factors = Grid::from_fn(knots.degree() + 1, order + 1, |i, k| {
            if k < basis.n_rows() { basis.get(k, i) } else { 0.0 }
        });
        let orders = Orders { most: order, of_surface: false };
        let sums = self.slopes.sums(std::iter::once(span - knots.degree()..span + 1), &factors);
        let slopes = orders.in_space(&sums, (&weights, self.curve.is_rational()), &space);
        (space, slopes)
    }

    /// Fails where the pieces beside a knot that moves grow in different ways.
    fn check_meeting(&self, spans: [usize; 2], t: f64, order: usize) -> Result<(), GeomError> {
        let [before, behind] = spans.map(|span| {
            let mut all = vec![vec![DVec3::ZERO; order + 1]; self.slopes.n_variables()];
            let own = self.slopes_on(span, t, order).1;
            own.rows().for_each(|(variable, slopes)| all[variable] = slopes.to_vec());
            all
        });
        for (before, behind) in before.iter().flatten().zip(behind.iter().flatten()) {
            let size = before.length().max(behind.length()).max(self.curve.magnitude());
            if LAST_BIT.sqrt() * size < before.distance(*behind) {
                return Err(
                    LocalError::NotDifferentiable { what: "the curve at its knot", at: t }.into()
                );
            }
        }
        Ok(())
    }
}

/// Whether a curve and one on fewer knots are the same, as far as p + 1 places on each span of the first tell.
fn is_same(fine: &NurbsCurve, coarse: &NurbsCurve) -> bool {
    let (knots, allowed) = (fine.knots(), EXACT_RELATIVE * fine.magnitude());
    let n = knots.degree() + 1;
    let is_near = |t: f64| fine.point_at(t).distance(coarse.point_at(t)) <= allowed;
    knots.domain() == coarse.domain()
        && knots.spans().all(|span| {
            let piece = knots.span_interval(span);
            (0..n).all(|k| is_near(piece.at((k as f64 + 0.5) / n as f64)))
        })
}
