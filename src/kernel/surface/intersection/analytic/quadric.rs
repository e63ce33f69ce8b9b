//! Which surfaces lie on a quadric, and of which kind it is.
//!
//! Points of the surface, in coordinates in which they spread alike along all axes, propose the
//! equation: the vector that a matrix of their ten products takes to zero. The simplest kind whose
//! equation, put into the homogeneous coordinates of each Bézier patch, leaves a polynomial that
//! vanishes up to rounding is the one.

use glam::{DAffine3, DMat3, DVec3, DVec4};

use super::equation::{OTHERS, QuadricEquation, ROUND};
use crate::{
    Grid, NurbsSurface, bezier,
    ceiling::{QUADRIC_PARTS, QUADRIC_WORK},
    numeric::singular_values::singular_values,
    surface::intersection::square::product,
    tolerance::{ANALYTIC_RELATIVE, RANK_RELATIVE},
};

/// A surface with a quadratic equation.
///
/// z = xy is a hyperbolic paraboloid:
///
/// ```
/// use virote_kernel::{NurbsSurface, QuadricKind, glam::DVec3};
///
/// let saddle = NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::ONE)?;
/// assert_eq!(saddle.quadric(), Some(QuadricKind::HyperbolicParaboloid));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "each is its name")]
pub enum QuadricKind {
    Plane,
    Sphere,
    Cylinder,
    Cone,
    Ellipsoid,
    EllipticParaboloid,
    HyperbolicParaboloid,
    HyperboloidOfOneSheet,
    HyperboloidOfTwoSheets,
    EllipticCylinder,
    HyperbolicCylinder,
    ParabolicCylinder,
    EllipticCone,
}

impl QuadricKind {
    /// Its name.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Plane => "plane",
            Self::Sphere => "sphere",
            Self::Cylinder => "cylinder",
            Self::Cone => "cone",
            Self::Ellipsoid => "ellipsoid",
            Self::EllipticParaboloid => "elliptic paraboloid",
            Self::HyperbolicParaboloid => "hyperbolic paraboloid",
            Self::HyperboloidOfOneSheet => "hyperboloid of one sheet",
            Self::HyperboloidOfTwoSheets => "hyperboloid of two sheets",
            Self::EllipticCylinder => "elliptic cylinder",
            Self::HyperbolicCylinder => "hyperbolic cylinder",
            Self::ParabolicCylinder => "parabolic cylinder",
            Self::EllipticCone => "elliptic cone",
        }
    }
}

impl NurbsSurface {
    /// The kind of quadric that it lies on up to rounding, and no further from it anywhere; of those
    /// that it is near enough to the one with the fewest terms.
    ///
    /// None for a surface that is a curve or a point, for one on a torus or any other surface, for one
    /// on two planes, for one with weights of zero or below, and for some with a hundred thousand patches
    /// or more.
    #[must_use]
    pub fn quadric(&self) -> Option<QuadricKind> {
        let ([n, m], order) = (self.n_patches(), (self.degree_u() + 1) * (self.degree_v() + 1));
        let is_large = QUADRIC_WORK < n.saturating_mul(m).saturating_mul(order * order);
        if is_large || self.control_points.iter().any(|point| point.w <= 0.0) {
            return None;
        }
        let points = self.samples();
        let spread = Spread::of(&points, self.bounds().magnitude())?;
        if spread.is_flat {
            let is_plane = |point: DVec3| spread.map.transform_point3(point).z.abs() <= 1.0;
            return self
                .points()
                .iter()
                .all(|&point| is_plane(point))
                .then_some(QuadricKind::Plane);
        }
        let points: Vec<DVec3> =
            points.into_iter().map(|point| spread.map.transform_point3(point)).collect();
        let equation = equation_of(&points, spread.allowed)?;
        let local = self.transformed(&spread.map);
        // What is left of an equation must be most of it.
        let is_whole = |found: &QuadricEquation| equation.norm() < 2.0 * found.norm();
        let proven =
            |found: &QuadricEquation| is_whole(found) && local.fulfils(found, spread.allowed);
        // What is round is so in coordinates of one scale.
        let even = equation.scaled(spread.widths);
        let round = ROUND.into_iter().filter_map(|terms| {
            let (round, kind) = even.with_terms(terms)?;
            kind.map(|_| (round.scaled(spread.widths.recip()), kind))
        });
        let others = OTHERS.into_iter().filter_map(|terms| equation.with_terms(terms));
        round.chain(others).find(|(found, _)| proven(found))?.1
    }

    /// Points over the whole of it.
    pub(super) fn samples(&self) -> Vec<DVec3> {
        // Twice the degree and one more tell a polynomial of twice the degree.
        let counts =
            [(self.degree_u(), self.n_patches()[0]), (self.degree_v(), self.n_patches()[1])]
                .map(|(degree, n_spans)| (2 * degree * n_spans).clamp(MIN_PARTS, QUADRIC_PARTS));
        let (us, vs) = (self.domain_u().steps(counts[0]), self.domain_v().steps(counts[1]));
        self.points_on_grid(&us, &vs).as_slice().to_vec()
    }

    /// Whether it is nowhere further than `allowed` from zero, put into an equation.
    fn fulfils(&self, equation: &QuadricEquation, allowed: f64) -> bool {
        let QuadricEquation { squares, linear, constant } = *equation;
        let image = |point: &DVec4| {
            let place = point.truncate();
            let image = squares * place + linear * point.w;
            image.extend(linear.dot(place) + constant * point.w)
        };
        let knots = [&self.knots_u, &self.knots_v];
        self.knots_u.spans().all(|span_u| {
            self.knots_v.spans().all(|span_v| {
                let net = bezier::patch(knots, &self.control_points, span_u, span_v);
                let images: Grid<DVec4> =
                    Grid::from_fn(net.n_rows(), net.n_columns(), |i, j| image(&net.get(i, j)));
                let left = product(&net, &images, DVec4::dot);
                let weights = net.map(|point| point.w);
                let denominator = product(&weights, &weights, |a: f64, b: f64| a * b);
                let pairs = left.iter().zip(denominator.iter());
                pairs.into_iter().all(|(left, weight)| left.abs() <= allowed * weight)
            })
        })
    }
}

/// Even parts of a domain at whose ends points are taken.
const MIN_PARTS: usize = 8;

/// How points spread.
struct Spread {
    /// To coordinates in which they spread alike; where they are flat the third tells how far they are
    /// from their plane, one being rounding.
    map: DAffine3,
    /// The spread along each axis, as part of the largest.
    widths: DVec3,
    /// What is rounding in these coordinates.
    allowed: f64,
    is_flat: bool,
}

impl Spread {
    /// None for points on one line.
    fn of(points: &[DVec3], magnitude: f64) -> Option<Self> {
        let size = points.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
        let n = points.len() as f64;
        let center = points.iter().map(|&point| point / size).sum::<DVec3>() / n;
        let columns = [0, 1, 2]
            .map(|axis| points.iter().map(|&point| (point / size - center)[axis]).collect());
        let found = singular_values::<3>(columns);
        let axes = DMat3::from_cols_array_2d(&found.map(|(_, axis)| axis)).transpose();
        let widths = DVec3::from(found.map(|(value, _)| value / n.sqrt()));
        let rounding = ANALYTIC_RELATIVE * (magnitude / size);
        if widths.y.partial_cmp(&rounding) != Some(std::cmp::Ordering::Greater) {
            return None;
        }
        let is_flat = widths.z <= rounding;
        let scale = if is_flat { widths.with_z(rounding) } else { widths };
        let to_axes = DMat3::from_diagonal(scale.recip()) * axes;
        let map = DAffine3 { matrix3: to_axes * (1.0 / size), translation: to_axes * -center };
        let allowed = rounding / widths.z;
        Some(Self { map, widths: widths / widths.x, allowed, is_flat })
    }
}

/// The one equation, of norm one, that the points fulfil best; none where there are several or none.
fn equation_of(points: &[DVec3], allowed: f64) -> Option<QuadricEquation> {
    let column = |term: fn(DVec3) -> f64| points.iter().map(|&point| term(point)).collect();
    let columns = [
        column(|p| p.x * p.x),
        column(|p| p.y * p.y),
        column(|p| p.z * p.z),
        column(|p| p.x * p.y),
        column(|p| p.x * p.z),
        column(|p| p.y * p.z),
        column(|p| p.x),
        column(|p| p.y),
        column(|p| p.z),
        column(|_| 1.0),
    ];
    let found = singular_values::<10>(columns);
    let n = (points.len() as f64).sqrt();
    let (least, next) = (found[9].0 / n, found[8].0 / n);
    if allowed < least || next <= RANK_RELATIVE.max(allowed) {
        return None;
    }
    let [xx, yy, zz, xy, xz, yz, x, y, z, constant] = found[9].1;
    let squares = DMat3::from_cols(
        DVec3::new(xx, 0.5 * xy, 0.5 * xz),
        DVec3::new(0.5 * xy, yy, 0.5 * yz),
        DVec3::new(0.5 * xz, 0.5 * yz, zz),
    );
    Some(QuadricEquation { squares, linear: 0.5 * DVec3::new(x, y, z), constant })
}
