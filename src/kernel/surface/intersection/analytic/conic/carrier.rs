//! What planes cut exactly: planes, quadrics and tori, by their equations.

use glam::{DAffine3, DMat3, DMat4, DVec3, DVec4};

use super::plane_conic::PlaneConic;
use crate::{
    AnalyticForm, Frame, NurbsCurve, NurbsSurface,
    frame::{norm, unit},
    tolerance::{ANALYTIC_RELATIVE, LAST_BIT},
};

/// Last bits of coordinates within which a plane and a torus that touch may miss one another.
const TOUCH_ROUNDINGS: f64 = 64.0;

/// Places within each piece that are put into the equation: one more than the degree of what is left of that of a
/// torus.
const N_PROOFS: usize = 9;

/// A surface with an equation.
#[derive(Clone, Copy, Debug)]
pub(super) enum ExactCarrier {
    /// A point of it, and its normal.
    Plane(DVec3, DVec3),
    Quadric(Quadric),
    /// About z of a frame.
    Torus {
        frame: Frame,
        major: f64,
        minor: f64,
    },
}

/// The points whose images p under a map have p·Qp = 0, where p = (x, y, z, 1).
#[derive(Clone, Copy, Debug)]
pub(super) struct Quadric {
    map: DAffine3,
    /// The symmetric Q.
    matrix: DMat4,
}

impl ExactCarrier {
    /// That of a surface up to rounding; edges within `distance` of one another are one.
    pub(super) fn of(surface: &NurbsSurface, distance: f64) -> Option<Self> {
        if let Some(plane) = surface.flat_frame() {
            return Some(Self::Plane(plane.origin(), plane.z()));
        }
        let found = surface.analytic(distance)?;
        let squares = match found.form {
            AnalyticForm::Plane => {
                return Some(Self::Plane(found.frame.origin(), found.frame.z()));
            }
            AnalyticForm::Torus { major, minor } => {
                return Some(Self::Torus { frame: found.frame, major, minor });
            }
            AnalyticForm::Cylinder { radius } => DVec4::new(1.0, 1.0, 0.0, -radius * radius),
            AnalyticForm::Sphere { radius } => DVec4::new(1.0, 1.0, 1.0, -radius * radius),
            AnalyticForm::Cone { radius, half_angle } => {
                let slope = libm::tan(half_angle);
                DVec4::new(1.0, 1.0, -slope * slope, -radius * radius)
            }
        };
        let mut matrix = DMat4::from_diagonal(squares);
        if let AnalyticForm::Cone { radius, half_angle } = found.form {
            let mixed = -radius * libm::tan(half_angle);
            (matrix.z_axis.w, matrix.w_axis.z) = (mixed, mixed);
        }
        Some(Self::Quadric(Quadric { map: found.frame.from_space(), matrix }))
    }

    /// The conics in which a plane may cut it: for a torus the circles among what it may cut.
    pub(super) fn conics(&self, plane: Frame) -> Vec<PlaneConic> {
        match self {
            Self::Plane(..) => Vec::new(),
            Self::Quadric(quadric) => vec![quadric.conic(plane)],
            Self::Torus { frame, major, minor } => {
                circles_of_torus(*frame, [*major, *minor], plane)
            }
        }
    }

    /// Whether a curve lies on it as near as what is rounding.
    pub(super) fn holds(&self, curve: &NurbsCurve, allowed: f64) -> bool {
        let intervals = curve.knots().spans().map(|span| curve.knots().span_interval(span));
        let mut places = intervals.flat_map(|interval| interval.steps(N_PROOFS - 1));
        places.all(|t| self.misses(curve.point_at(t)) <= allowed)
    }

    /// How far a point beside it is from it, in the first order.
    fn misses(&self, point: DVec3) -> f64 {
        match self {
            Self::Plane(origin, normal) => (point - origin).dot(*normal).abs(),
            Self::Quadric(quadric) => quadric.misses(point),
            Self::Torus { frame, major, minor } => {
                let local = frame.from_space().transform_point3(point);
                let from_middle = libm::hypot(local.x, local.y) - major;
                (libm::hypot(from_middle, local.z) - minor).abs()
            }
        }
    }
}

impl Quadric {
    /// The conic of a plane.
    fn conic(&self, plane: Frame) -> PlaneConic {
        let image = |way: DVec3| (self.map.matrix3 * way).extend(0.0);
        let origin = self.map.transform_point3(plane.origin()).extend(1.0);
        let columns = [image(plane.x()), image(plane.y()), origin];
        let entry = |i: usize, k: usize| columns[i].dot(self.matrix * columns[k]);
        let column = |k: usize| DVec3::new(entry(0, k), entry(1, k), entry(2, k));
        let matrix = DMat3::from_cols(column(0), column(1), column(2));
        PlaneConic { frame: plane, matrix }
    }

    /// How far a point is from it in the first order, or in the second where it has no gradient.
    fn misses(&self, point: DVec3) -> f64 {
        let place = self.map.transform_point3(point).extend(1.0);
        let image = self.matrix * place;
        let (value, slope) = (place.dot(image).abs(), 2.0 * image.truncate().length());
        (value / slope).min(libm::sqrt(value))
    }
}

/// Around the axis, around the tube, and those of Villarceau: which of them are in the plane is not asked here.
fn circles_of_torus(torus: Frame, [major, minor]: [f64; 2], plane: Frame) -> Vec<PlaneConic> {
    let (normal, axis) = (plane.z(), torus.z());
    let height = (torus.origin() - plane.origin()).dot(normal);
    let center = torus.origin() - normal * height;
    let mut found = Vec::new();
    // A plane that touches the tube up to rounding touches it: the root of what is left would be far more.
    let size = plane.origin().abs().max(torus.origin().abs()).max_element().max(major);
    let is_touching = (minor - height.abs()).abs() <= TOUCH_ROUNDINGS * LAST_BIT * size;
    let reach = if is_touching { 0.0 } else { libm::sqrt(minor * minor - height * height) };
    if reach.is_finite() {
        let radii = [major + reach, major - reach];
        found.extend(radii.map(|radius| PlaneConic::circle(plane.at(center), radius)));
    }
    if let Some(along) =
        unit(normal.cross(axis)).filter(|_| ANALYTIC_RELATIVE < norm(normal.cross(axis)))
    {
        for (away, radius) in [(major, minor), (-major, minor), (minor, major), (-minor, major)] {
            found.push(PlaneConic::circle(plane.at(center + along * away), radius));
        }
    }
    found
}
