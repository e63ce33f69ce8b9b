//! Curves: rational B-splines, and functions.
//!
//! This file has the type of rational B-splines, its constructors and what can be read off it. In
//! the rooms stands what a curve is (`representation`), its points (`evaluation`), the same in
//! another form (`editing`), what can be asked of it (`measurement`), where curves meet
//! (`intersection`), what makes it (`construction`), and splines near functions (`approximation`).

mod approximation;
mod construction;
mod editing;
mod evaluation;
mod intersection;
mod measurement;
mod representation;

use glam::{DAffine3, DMat4, DVec3, DVec4};

use super::{
    Bounds, ConstructionReport, CountError, GeomError, Interval, KnotVector, Tolerance,
    WeightError, frame::norm, homogeneous, lazy::Lazy, nearest::ClosestPointTree, positive,
};

pub(crate) use construction::chain::{power_weights, powers};
pub use construction::circle::CircleForm;
pub use construction::conic::ConicKind;
pub(crate) use construction::hermite::blossom_weights;
pub use construction::offset::Offset;
pub use construction::tangent::{TangentArc, TangentEnd, TangentLine};
pub use editing::compatible::make_compatible;
pub(crate) use editing::denominator::on_one_denominator;
pub use editing::join::join;
pub(crate) use editing::join::{join_chain, join_pieces};
pub use evaluation::evaluator::CurveEvaluator;
pub use intersection::intersect::CurveIntersection;
pub use measurement::analytic::AnalyticCurve;
pub(crate) use measurement::analytic::{rounded, rounded_place};
pub(crate) use measurement::arc_length::ArcLengths;
pub use measurement::closest::ClosestPoint;
pub use measurement::continuity::Continuity;
pub use measurement::direction::CurvePointKind;
pub(crate) use measurement::flat::{lie_in_a_plane, plane_of};
pub use measurement::local::{EvaluationPlace, LocalGeometry};
pub(crate) use measurement::planar::facing;
pub use representation::any::Curve;
pub use representation::parametric::{CurveFunction, ParametricCurve};
pub(crate) use representation::part;

/// A rational B-spline curve in space, with homogeneous points `(w·x, w·y, w·z, w)`.
///
/// Invariants: as many control points as the knots need, all finite; the denominator `Σ wᵢNᵢ` is
/// positive on the whole domain.
///
/// A quarter of the unit circle, whose half parameter is the point (3/5, 4/5): *The NURBS Book*, Ex7.1.
///
/// ```
/// use virote_kernel::{KnotVector, NurbsCurve, glam::DVec3};
///
/// let points = [DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y];
/// let quarter = NurbsCurve::rational(KnotVector::bezier(2)?, &points, &[1.0, 1.0, 2.0])?;
/// assert!(quarter.point_at(0.5).distance(DVec3::new(0.6, 0.8, 0.0)) < 1e-15);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct NurbsCurve {
    knots: KnotVector,
    control_points: Vec<DVec4>,
    is_rational: bool,
    report: ConstructionReport,
    /// The pieces, prepared for many parameters.
    evaluator: Lazy<CurveEvaluator>,
    /// The same, prepared to be searched for the nearest point.
    nearest: Lazy<ClosestPointTree>,
    /// The smallest box around it.
    bounds: Lazy<Bounds>,
}

impl NurbsCurve {
    /// The curve of homogeneous control points.
    ///
    /// # Errors
    /// `KnotError::KnotCount`, `InputError::NotFinite`, [`WeightError::VanishingWeights`].
    pub fn new(knots: KnotVector, control_points: Vec<DVec4>) -> Result<Self, GeomError> {
        knots.check_points(control_points.len())?;
        homogeneous::check_finite(&control_points)?;
        positive::check_curve(&knots, &control_points)?;
        Ok(Self::new_unchecked(knots, control_points))
    }

    /// The curve with all weights one.
    ///
    /// The quadratic B-spline of five points: the middle of a segment's legs at its knots.
    ///
    /// ```
    /// use virote_kernel::{KnotVector, NurbsCurve, glam::DVec3};
    ///
    /// let knots = KnotVector::new(2, vec![0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0])?;
    /// let points = [(0.0, 0.0), (1.0, 2.0), (3.0, 2.0), (4.0, 0.0)];
    /// let points = points.map(|(x, y)| DVec3::new(x, y, 0.0));
    /// let curve = NurbsCurve::polynomial(knots, &points)?;
    /// assert_eq!(curve.point_at(1.0), points[1].midpoint(points[2]));
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// `KnotError::KnotCount`, `InputError::NotFinite`.
    pub fn polynomial(knots: KnotVector, points: &[DVec3]) -> Result<Self, GeomError> {
        knots.check_points(points.len())?;
        Ok(Self::new_unchecked(knots, homogeneous::unweighted(points)?))
    }

    /// The curve with a weight for each point; a weight of zero takes its point away.
    ///
    /// # Errors
    /// `KnotError::KnotCount`, [`WeightError::WeightCount`], `InputError::NotFinite`,
    /// [`WeightError::BadWeight`] below zero, [`WeightError::BadEndWeight`] for a zero at an end,
    /// [`WeightError::VanishingWeights`] where zeros leave a parameter without a point.
    pub fn rational(
        knots: KnotVector,
        points: &[DVec3],
        weights: &[f64],
    ) -> Result<Self, GeomError> {
        knots.check_points(points.len())?;
        let control_points = homogeneous::weighted(points, weights)?;
        for index in [0, weights.len() - 1] {
            if weights[index] <= 0.0 {
                return Err(WeightError::BadEndWeight { index, weight: weights[index] }.into());
            }
        }
        Self::new(knots, control_points)
    }

    /// The Bézier curve of a control polygon, on 0..1; one point gives degree 0.
    ///
    /// ```
    /// use glam::DVec3;
    /// use virote_kernel::NurbsCurve;
    ///
    /// let peak = [DVec3::ZERO, DVec3::new(1.0, 2.0, 0.0), DVec3::new(2.0, 0.0, 0.0)];
    /// let parabola = NurbsCurve::bezier(&peak)?;
    /// assert_eq!(parabola.point_at(0.5), DVec3::new(1.0, 1.0, 0.0));
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`CountError::TooFewPoints`] without points, `DegreeError::DegreeTooHigh`,
    /// `InputError::NotFinite`.
    pub fn bezier(points: &[DVec3]) -> Result<Self, GeomError> {
        match points.len() {
            0 => Err(GeomError::Count(CountError::TooFewPoints { got: 0, needed: 1 })),
            n => Self::polynomial(KnotVector::bezier(n - 1)?, points),
        }
    }

    /// The segment from `a` to `b` on 0..1.
    ///
    /// ```
    /// use virote_kernel::{NurbsCurve, glam::DVec3};
    ///
    /// let line = NurbsCurve::line(DVec3::ZERO, DVec3::new(2.0, 4.0, 6.0))?;
    /// assert_eq!(line.point_at(0.5), DVec3::new(1.0, 2.0, 3.0));
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// `InputError::NotFinite`.
    pub fn line(a: DVec3, b: DVec3) -> Result<Self, GeomError> {
        Self::bezier(&[a, b])
    }

    /// The polygon through the points, one unit of parameter a leg.
    ///
    /// ```
    /// use virote_kernel::{NurbsCurve, glam::DVec3};
    ///
    /// let corner = NurbsCurve::polyline(&[DVec3::ZERO, DVec3::X * 3.0, DVec3::new(3.0, 4.0, 0.0)])?;
    /// assert!((corner.length(corner.domain()) - 7.0).abs() < 1e-14);
    /// assert_eq!(corner.degree(), 1);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`CountError::TooFewPoints`] below two, `InputError::NotFinite`.
    pub fn polyline(points: &[DVec3]) -> Result<Self, GeomError> {
        let got = points.len();
        if got < 2 {
            return Err(CountError::TooFewPoints { got, needed: 2 }.into());
        }
        Self::polynomial(KnotVector::uniform_clamped(1, got, (got - 1) as f64)?, points)
    }

    /// A curve of parts that keep the invariants by construction.
    pub(crate) fn new_unchecked(knots: KnotVector, control_points: Vec<DVec4>) -> Self {
        let is_rational = homogeneous::have_different_weights(&control_points);
        let (evaluator, nearest, bounds) = (Lazy::default(), Lazy::default(), Lazy::default());
        let report = ConstructionReport::NONE;
        Self { knots, control_points, is_rational, report, evaluator, nearest, bounds }
    }

    /// The same with a report of how it was made.
    #[must_use]
    pub fn with_report(self, report: ConstructionReport) -> Self {
        Self { report, ..self }
    }

    /// What the construction that made it did, if it left a report.
    #[must_use]
    pub fn report(&self) -> Option<&ConstructionReport> {
        self.report.if_any()
    }

    /// Polynomial degree of the pieces.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.knots.degree()
    }

    /// All knots.
    #[must_use]
    pub fn knots(&self) -> &KnotVector {
        &self.knots
    }

    /// The homogeneous control points.
    #[must_use]
    pub fn control_points(&self) -> &[DVec4] {
        &self.control_points
    }

    /// The control points in space; one of weight zero gives its direction.
    #[must_use]
    pub fn points(&self) -> Vec<DVec3> {
        self.control_points.iter().map(|&point| homogeneous::place(point)).collect()
    }

    /// The weights.
    #[must_use]
    pub fn weights(&self) -> Vec<f64> {
        self.control_points.iter().map(|point| point.w).collect()
    }

    /// Whether the weights differ.
    #[must_use]
    pub fn is_rational(&self) -> bool {
        self.is_rational
    }

    /// The parameters that have a point.
    #[must_use]
    pub fn domain(&self) -> Interval {
        self.knots.domain()
    }

    /// The point at the start of the domain.
    #[must_use]
    pub fn start(&self) -> DVec3 {
        self.point_at(self.domain().start())
    }

    /// The point at the end of the domain.
    #[must_use]
    pub fn end(&self) -> DVec3 {
        self.point_at(self.domain().end())
    }

    /// Whether start and end are within `distance` of one another, and of a small fraction of the
    /// size of the curve: a short curve is not closed, nor one that jumps.
    #[must_use]
    pub fn is_closed(&self, distance: f64) -> bool {
        let (start, tolerance) = (self.start(), Tolerance::DEFAULT.with_distance(distance));
        let reach = |&point: &DVec4| norm(homogeneous::place(point) - start);
        let size = self.control_points.iter().map(reach).fold(0.0, f64::max);
        start.distance(self.end()) <= tolerance.distance_for(size) && self.jumps().is_empty()
    }

    /// How many polynomial pieces: spans of the domain that have a width.
    #[must_use]
    pub fn n_segments(&self) -> usize {
        self.knots.spans().count()
    }

    /// The image under an affine map: exact, because the basis sums to one.
    #[must_use]
    pub fn transformed(&self, map: &DAffine3) -> Self {
        let move_point = |&point: &DVec4| homogeneous::transformed(point, map);
        let control_points = self.control_points.iter().map(move_point).collect();
        Self { control_points, report: ConstructionReport::NONE, ..self.clone() }
    }

    /// The image under a projective map, such as a central projection: exact, because rational
    /// curves are images of polynomial ones under such maps. The weights of the image are the
    /// control points' distances from the plane that the map takes to infinity.
    ///
    /// Piegl & Tiller, *The NURBS Book*, §4.2, P4.7; Lee, *The rational Bézier representation for
    /// conics*, Geometric Modeling (1987).
    ///
    /// # Errors
    /// [`WeightError::BadWeight`] where a control point lies on or beyond that plane, or has a weight
    /// of zero; `InputError::NotFinite`.
    pub fn projected(&self, map: &DMat4) -> Result<Self, GeomError> {
        let points: Vec<DVec4> = self.control_points.iter().map(|&point| *map * point).collect();
        if let Some(index) = points.iter().position(|point| point.w <= 0.0) {
            return Err(WeightError::BadWeight { index, weight: points[index].w }.into());
        }
        Self::new(self.knots.clone(), points)
    }
}
