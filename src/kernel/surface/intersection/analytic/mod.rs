//! Which surfaces are planes, cylinders, cones, spheres and tori, whatever made them and whatever
//! form they are in.
//!
//! `plane` looks for planes, `revolved` for the others, whose parameter lines must be circles about
//! the axis and meridians. Both propose from a few points and then prove it: of each homogeneous
//! Bézier patch the coefficients of a polynomial must vanish up to rounding, so that nothing
//! between the points is missed. Proven, too, is that the surface covers its part of the plane,
//! cylinder and so on once: no Bézier patch turns back, and its border does not meet itself.
//!
//! `quadric` tells on which kind of quadric a surface lies, whatever part of it it covers and however
//! often, by an `equation` that singular values propose. `apart` puts other surfaces into such equations. `conic` has the exact curves in which
//! planes cut them, without a search where that is an ellipse all around, `coaxial` the circles in which those about one
//! axis cross, `inscribed` the conics of cylinders and cones around one sphere, `carrier` tells which are parts of one,
//! `chart` has the parameters that files give them.

mod apart;
mod ball;
mod carrier;
mod chart;
mod coaxial;
mod conic;
mod equation;
mod inscribed;
mod plane;
mod quadric;
mod revolved;

pub use chart::AnalyticChart;
pub use quadric::QuadricKind;

use glam::{DVec3, DVec4};

use crate::{
    Direction, Frame, Grid, bezier,
    ceiling::{QUADRIC_WORK, SIGN_HALVINGS},
    frame::norm,
    surface::{NurbsSurface, intersection::square::range},
    tolerance::{ANALYTIC_RELATIVE, SIGN_RELATIVE},
};

/// A surface with an equation, in the coordinates of a frame.
///
/// ```
/// use virote_kernel::{AnalyticForm, Frame, NurbsSurface};
///
/// let ring = NurbsSurface::torus(Frame::XY, 3.0, 1.0)?;
/// let form = ring.analytic(1e-9).map(|found| found.form);
/// let Some(AnalyticForm::Torus { major, minor }) = form else { unreachable!("it is a torus") };
/// assert!((major - 3.0).abs() < 1e-12 && (minor - 1.0).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnalyticForm {
    /// z = 0.
    Plane,
    /// x² + y² = r².
    Cylinder {
        /// The radius r, model units.
        radius: f64,
    },
    /// x² + y² = (r + z tan α)² where the right side's root is not negative.
    Cone {
        /// The radius r at z = 0, model units; zero where the surface has the apex.
        radius: f64,
        /// The angle α of axis and meridian, radians within 0..π/2.
        half_angle: f64,
    },
    /// x² + y² + z² = r².
    Sphere {
        /// The radius r, model units.
        radius: f64,
    },
    /// (√(x² + y²) − R)² + z² = r².
    Torus {
        /// The radius R of the circle in the middle of the tube, model units.
        major: f64,
        /// The radius r of the tube, less than the other.
        minor: f64,
    },
}

/// What a surface is a part of that its border bounds.
///
/// ```
/// use virote_kernel::{AnalyticForm, Frame, NurbsSurface, glam::DVec3};
///
/// let place = Frame::XY.at(DVec3::new(1.0, 2.0, 3.0));
/// let sphere = NurbsSurface::sphere(place, 2.0)?;
/// let Some(found) = sphere.analytic(1e-9) else { unreachable!("it is a sphere") };
/// assert!(matches!(found.form, AnalyticForm::Sphere { radius } if (radius - 2.0).abs() < 1e-12));
/// assert!(found.frame.origin().distance(place.origin()) < 1e-12 && found.is_outward);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnalyticSurface {
    /// Its kind and sizes.
    pub form: AnalyticForm,
    /// The coordinates: about the axis counter-clockwise from the half plane of x, in which the
    /// surface begins.
    pub frame: Frame,
    /// Whether Su × Sv points to where z is upward over a plane, and away from the axis, or from
    /// the middle of the tube or of the sphere.
    pub is_outward: bool,
}

impl AnalyticSurface {
    /// The largest of its radii; zero of a plane.
    pub(crate) fn radius(&self) -> f64 {
        match self.form {
            AnalyticForm::Plane => 0.0,
            AnalyticForm::Cylinder { radius }
            | AnalyticForm::Cone { radius, .. }
            | AnalyticForm::Sphere { radius } => radius,
            AnalyticForm::Torus { major, .. } => major,
        }
    }

    /// How far a point is from all of what the equation describes, signed, and the direction that leads away from it;
    /// no numbers where there is none, as on an axis.
    pub(crate) fn height(&self, point: DVec3) -> (f64, DVec3) {
        let (axis, way) = (self.frame.z(), point - self.frame.origin());
        let along = way.dot(axis);
        let out = way - axis * along;
        let away = norm(out);
        match self.form {
            AnalyticForm::Plane => (along, axis),
            AnalyticForm::Cylinder { radius } => (away - radius, out / away),
            AnalyticForm::Cone { radius, half_angle } => {
                let (sine, cosine) = libm::sincos(half_angle);
                let height = (away - radius) * cosine - along * sine;
                (height, out * (cosine / away) - axis * sine)
            }
            AnalyticForm::Sphere { radius } => (norm(way) - radius, way / norm(way)),
            AnalyticForm::Torus { major, minor } => {
                let from_tube = out * (1.0 - major / away) + axis * along;
                (norm(from_tube) - minor, from_tube / norm(from_tube))
            }
        }
    }
}

impl NurbsSurface {
    /// The plane, cylinder, cone, sphere or torus that it is a part of up to rounding.
    ///
    /// None for any other surface, and for some with a hundred thousand patches or more; for one
    /// with weights of zero or below; for one that covers a part of it twice, turns back, has two
    /// sides of an apex, is of a torus that meets itself or no wider than `distance`; for one whose
    /// parameter lines are not the circles and meridians of it, unless it is a plane. Edges within
    /// `distance` of one another are taken for one, and are one up to rounding then.
    #[must_use]
    pub fn analytic(&self, distance: f64) -> Option<AnalyticSurface> {
        for told in &self.analytic {
            let (known_for, known) = told.get_or_make(|| (distance, self.found_analytic(distance)));
            if known_for.to_bits() == distance.to_bits() {
                return *known;
            }
        }
        self.found_analytic(distance)
    }

    fn found_analytic(&self, distance: f64) -> Option<AnalyticSurface> {
        let has_points = 0 < self.degree_u() && 0 < self.degree_v();
        let ([n, m], order) = (self.n_patches(), (self.degree_u() + 1) * (self.degree_v() + 1));
        if QUADRIC_WORK < n.saturating_mul(m).saturating_mul(order * order) {
            return None;
        }
        if !has_points || self.control_points.iter().any(|point| point.w <= 0.0) {
            return None;
        }
        let allowed = ANALYTIC_RELATIVE * self.bounds().magnitude();
        let closed = [self.is_closed_u(distance), self.is_closed_v(distance)];
        if let Some(plane) = self.plane_form(distance, closed) {
            return Some(plane);
        }
        self.revolved_form(allowed, distance, closed).or_else(|| {
            let found = self.swapped().revolved_form(allowed, distance, [closed[1], closed[0]])?;
            // With u and v exchanged Su × Sv turns around.
            Some(AnalyticSurface { is_outward: !found.is_outward, ..found })
        })
    }

    /// The one sign that a polynomial of its patches has everywhere.
    fn sign_of(&self, field: impl Fn(&Grid<DVec4>) -> Grid<f64>) -> Option<f64> {
        let knots = [&self.knots_u, &self.knots_v];
        let mut found = None;
        for span_u in self.knots_u.spans() {
            for span_v in self.knots_v.spans() {
                let net = bezier::patch(knots, &self.control_points, span_u, span_v);
                let sign = sign_on(&net, &field, SIGN_HALVINGS)?;
                if found.is_some_and(|found: f64| found * sign < 0.0) {
                    return None;
                }
                found = Some(sign);
            }
        }
        found
    }
}

/// The sign that the coefficients over a patch have, at once or on its parts.
fn sign_on(
    net: &Grid<DVec4>,
    field: &impl Fn(&Grid<DVec4>) -> Grid<f64>,
    n_left: usize,
) -> Option<f64> {
    let [least, most] = range(&field(net));
    let rounding = SIGN_RELATIVE * most.max(-least);
    if -rounding <= least && rounding < most {
        return Some(1.0);
    }
    if most <= rounding && least < -rounding {
        return Some(-1.0);
    }
    if n_left == 0 {
        return None;
    }
    let along = if n_left.is_multiple_of(2) { Direction::U } else { Direction::V };
    let [first, second] = bezier::halves(net, along);
    let first = sign_on(&first, field, n_left - 1)?;
    sign_on(&second, field, n_left - 1).filter(|second| 0.0 < first * second)
}
