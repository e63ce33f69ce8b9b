//! Surfaces: rational B-splines, and functions.
//!
//! This file has the type of rational B-splines, its constructors and what can be read off it. In
//! the rooms stands what a surface is (`representation`), its points (`evaluation`), the same in
//! another form (`editing`), what can be asked of it (`measurement`), the lines along which
//! something vanishes on it (`intersection`), what makes it (`construction`), and splines near
//! functions (`approximation`).

mod approximation;
mod construction;
mod editing;
mod evaluation;
mod intersection;
mod measurement;
mod representation;

use std::sync::Arc;

use glam::{DAffine3, DVec3, DVec4};

pub use construction::coons::{Blend, CrossFields, Twists};
pub use construction::offset::{FocalPoint, SurfaceOffset};
pub use construction::revolve::{Axis, AxisContact};
pub(crate) use construction::sum::BooleanSumTerm;
pub use editing::compatible::make_surfaces_compatible;
pub use editing::join::join_patches;
pub use evaluation::evaluator::SurfaceEvaluator;
pub use evaluation::grid_eval::GridSamples;
pub use intersection::analytic::{AnalyticChart, AnalyticForm, AnalyticSurface, QuadricKind};
pub use intersection::level_set::{CurveSurfaceIntersection, LevelSet, PictureError};
pub(crate) use intersection::square;
pub use measurement::closest::{ParametricPlaces, SurfaceClosestPoint};
pub use measurement::defects::SurfaceDefects;
pub use measurement::joint::SurfaceContinuity;
pub(crate) use measurement::mass::{MOMENT_KINDS, MassIntegral, are_closed, moments};
pub use measurement::mass::{
    MassProperties, SignedVolume, area_mass, facing_unlike, signed_volume, volume_mass,
};
pub(crate) use measurement::quadrature::{
    Density, IntegralValues, ONE_MOMENT, ONE_QUANTITY, QuadratureMap, QuantityKinds, far_share,
    integral, integral_over,
};
pub use measurement::shape::{Principal, SurfacePointKind, SurfaceShape};
pub use measurement::shell::ShellError;
pub use representation::any::Surface;
pub(crate) use representation::crease::Crease;
pub use representation::direction::Direction;
pub use representation::edge::Edge;
pub use representation::parametric::{ParametricSurface, SurfaceFunction};

use evaluation::expansion::SurfaceExpansion;

use super::{
    Bounds, ConstructionReport, CountError, GeomError, Grid, Interval, KnotVector, WeightError,
    homogeneous, lazy::Lazy, nearest::ClosestPointTree, positive, scale::needed_scale,
};

/// A rational B-spline surface; row i of its net runs along u, column j along v.
///
/// Invariants: as many rows and columns as the knots need, all entries finite; the denominator
/// `Σ wᵢⱼNᵢNⱼ` is positive on the whole domain.
///
/// The saddle z = xy through four corners:
///
/// ```
/// use virote_kernel::{NurbsSurface, glam::DVec3};
///
/// let saddle = NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::ONE)?;
/// assert_eq!(saddle.point_at(0.5, 0.5), DVec3::new(0.5, 0.5, 0.25));
/// assert_eq!(saddle.derivatives_at(0.5, 0.5, 2).get(1, 1), DVec3::Z);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct NurbsSurface {
    knots_u: KnotVector,
    knots_v: KnotVector,
    control_points: Grid<DVec4>,
    is_rational: bool,
    /// The area of Su × Sv over a span each that is rounding and no area.
    fold_area: f64,
    /// The surface divided by a power of two near its size, with that power, where squares of its
    /// coordinates are no numbers.
    scaled: Option<(Arc<NurbsSurface>, f64)>,
    report: ConstructionReport,
    /// The surface in powers, prepared for many parameters.
    expanded: Lazy<SurfaceExpansion>,
    /// The patches, prepared to be searched for the nearest point.
    nearest: Lazy<ClosestPointTree>,
    /// The smallest box around it.
    bounds: Lazy<Bounds>,
    /// What it is a part of, each with the distance that it was asked for with: the first few of these.
    analytic: [Lazy<(f64, Option<AnalyticSurface>)>; 3],
}

impl NurbsSurface {
    /// The surface of homogeneous control points.
    ///
    /// # Errors
    /// `KnotError::KnotCount`, `InputError::NotFinite`, [`WeightError::VanishingWeightsAt`].
    pub fn new(
        knots_u: KnotVector,
        knots_v: KnotVector,
        control_points: Grid<DVec4>,
    ) -> Result<Self, GeomError> {
        knots_u.check_points(control_points.n_rows())?;
        knots_v.check_points(control_points.n_columns())?;
        homogeneous::check_finite(control_points.as_slice())?;
        positive::check_surface([&knots_u, &knots_v], &control_points)?;
        Ok(Self::new_unchecked(knots_u, knots_v, control_points))
    }

    /// The surface with all weights one.
    ///
    /// # Errors
    /// `KnotError::KnotCount`, `InputError::NotFinite`.
    pub fn polynomial(
        knots_u: KnotVector,
        knots_v: KnotVector,
        points: &Grid<DVec3>,
    ) -> Result<Self, GeomError> {
        let (n_rows, n_columns) = (points.n_rows(), points.n_columns());
        let control_points = homogeneous::unweighted(points.as_slice())?;
        Self::new(knots_u, knots_v, Grid::new(n_rows, n_columns, control_points)?)
    }

    /// The surface with a weight for each point; a weight of zero takes its point away.
    ///
    /// # Errors
    /// `KnotError::KnotCount`, [`WeightError::WeightCount`], `InputError::NotFinite`,
    /// [`WeightError::BadWeight`] below zero (indices count row after row),
    /// [`WeightError::VanishingWeightsAt`] where zeros leave a place without a point.
    pub fn rational(
        knots_u: KnotVector,
        knots_v: KnotVector,
        points: &Grid<DVec3>,
        weights: &Grid<f64>,
    ) -> Result<Self, GeomError> {
        let (n_rows, n_columns) = (points.n_rows(), points.n_columns());
        if (n_rows, n_columns) != (weights.n_rows(), weights.n_columns()) {
            let (points, weights) = (points.as_slice().len(), weights.as_slice().len());
            return Err(WeightError::WeightCount { points, weights }.into());
        }
        let control_points = homogeneous::weighted(points.as_slice(), weights.as_slice())?;
        Self::new(knots_u, knots_v, Grid::new(n_rows, n_columns, control_points)?)
    }

    /// The Bézier surface of a net, on 0..1 × 0..1.
    ///
    /// One corner of a bilinear patch lifted by 4 lifts its middle by 1:
    ///
    /// ```
    /// use virote_kernel::{Grid, NurbsSurface, glam::DVec3};
    ///
    /// let corners = Grid::from_fn(2, 2, |i, j| DVec3::new(i as f64, j as f64, 4.0 * (i * j) as f64));
    /// assert_eq!(NurbsSurface::bezier(&corners)?.point_at(0.5, 0.5).z, 1.0);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`CountError::TooFewPoints`] for an empty net, `DegreeError::DegreeTooHigh`,
    /// `InputError::NotFinite`.
    pub fn bezier(points: &Grid<DVec3>) -> Result<Self, GeomError> {
        if points.as_slice().is_empty() {
            return Err(CountError::TooFewPoints { got: 0, needed: 1 }.into());
        }
        let knots_u = KnotVector::bezier(points.n_rows() - 1)?;
        let knots_v = KnotVector::bezier(points.n_columns() - 1)?;
        Self::polynomial(knots_u, knots_v, points)
    }

    /// The bilinear surface between four corners; the first index of a name counts along u.
    ///
    /// ```
    /// use virote_kernel::{NurbsSurface, Surface, glam::DVec3};
    ///
    /// let sheet = NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y * 2.0, DVec3::X * 3.0, DVec3::new(3.0, 2.0, 0.0))?;
    /// assert!((Surface::from(sheet).area()?.0 - 6.0).abs() < 1e-13);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// `InputError::NotFinite`.
    pub fn bilinear(p00: DVec3, p01: DVec3, p10: DVec3, p11: DVec3) -> Result<Self, GeomError> {
        Self::bezier(&Grid::new(2, 2, vec![p00, p01, p10, p11])?)
    }

    /// A surface of parts that keep the invariants by construction.
    pub(crate) fn new_unchecked(
        knots_u: KnotVector,
        knots_v: KnotVector,
        control_points: Grid<DVec4>,
    ) -> Self {
        let is_rational = homogeneous::have_different_weights(control_points.as_slice());
        let places = control_points.iter().map(|&point| homogeneous::place(point));
        let bounds = Bounds::of(places);
        let scale = bounds.and_then(|bounds| needed_scale(bounds.magnitude()));
        let scaled = scale.map(|scale| {
            let divide = DAffine3::from_scale(DVec3::splat(scale.recip()));
            let net = control_points.map(|&point| homogeneous::transformed(point, &divide));
            (Arc::new(Self::new_unchecked(knots_u.clone(), knots_v.clone(), net)), scale)
        });
        Self {
            knots_u,
            knots_v,
            control_points,
            is_rational,
            fold_area: bounds.map_or(0.0, evaluation::normal::fold_area),
            scaled,
            report: ConstructionReport::NONE,
            expanded: Lazy::default(),
            nearest: Lazy::default(),
            bounds: Lazy::default(),
            analytic: Default::default(),
        }
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

    /// Polynomial degree along u.
    #[must_use]
    pub fn degree_u(&self) -> usize {
        self.knots_u.degree()
    }

    /// Polynomial degree along v.
    #[must_use]
    pub fn degree_v(&self) -> usize {
        self.knots_v.degree()
    }

    /// All knots along u.
    #[must_use]
    pub fn knots_u(&self) -> &KnotVector {
        &self.knots_u
    }

    /// All knots along v.
    #[must_use]
    pub fn knots_v(&self) -> &KnotVector {
        &self.knots_v
    }

    /// The homogeneous control points.
    #[must_use]
    pub fn control_points(&self) -> &Grid<DVec4> {
        &self.control_points
    }

    /// The control points in space; one of weight zero gives its direction.
    #[must_use]
    pub fn points(&self) -> Grid<DVec3> {
        self.control_points.map(|&point| homogeneous::place(point))
    }

    /// The weights.
    #[must_use]
    pub fn weights(&self) -> Grid<f64> {
        self.control_points.map(|point| point.w)
    }

    /// Whether the weights differ.
    #[must_use]
    pub fn is_rational(&self) -> bool {
        self.is_rational
    }

    /// The parameters u that have points.
    #[must_use]
    pub fn domain_u(&self) -> Interval {
        self.knots_u.domain()
    }

    /// The parameters v that have points.
    #[must_use]
    pub fn domain_v(&self) -> Interval {
        self.knots_v.domain()
    }

    /// How many polynomial pieces along u and along v.
    #[must_use]
    pub fn n_patches(&self) -> [usize; 2] {
        [self.knots_u.spans().count(), self.knots_v.spans().count()]
    }

    /// Whether the edges at the two ends of u are within `distance` of one another everywhere.
    #[must_use]
    pub fn is_closed_u(&self, distance: f64) -> bool {
        let (start, end) = (self.domain_u().start(), self.domain_u().end());
        let vs = samples(&self.knots_v);
        vs.iter().all(|&v| self.point_at(start, v).distance(self.point_at(end, v)) <= distance)
    }

    /// Whether the edges at the two ends of v are within `distance` of one another everywhere.
    #[must_use]
    pub fn is_closed_v(&self, distance: f64) -> bool {
        let (start, end) = (self.domain_v().start(), self.domain_v().end());
        let us = samples(&self.knots_u);
        us.iter().all(|&u| self.point_at(u, start).distance(self.point_at(u, end)) <= distance)
    }

    /// The image under an affine map: exact, because the basis sums to one.
    #[must_use]
    pub fn transformed(&self, map: &DAffine3) -> Self {
        let control_points = self.control_points.map(|&point| homogeneous::transformed(point, map));
        Self::new_unchecked(self.knots_u.clone(), self.knots_v.clone(), control_points)
    }
}

/// Parameters in every span, enough of them to tell two different rational curves on it apart.
fn samples(knots: &KnotVector) -> Vec<f64> {
    let n_steps = 4 * knots.degree() + 1;
    knots.spans().flat_map(|span| knots.span_interval(span).steps(n_steps)).collect()
}
