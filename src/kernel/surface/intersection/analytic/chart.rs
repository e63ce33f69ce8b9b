//! Parameters of planes, cylinders, cones, spheres and tori as exchange files have them.
//!
//! About the axis by the angle from x; along it by the height, on spheres and about the tube of tori by the
//! angle from the plane of x and y. ISO 10303-42, §4.5.
//!
//! One parameter of the surface goes around the axis, the other along a meridian, so that either tells one of
//! both: also in a pole, where the point alone tells no angle.

use std::f64::consts::TAU;

use glam::{DAffine3, DVec2, DVec3};

use super::{AnalyticForm, AnalyticSurface};
use crate::{
    Direction, Interval, NurbsSurface,
    frame::norm,
    tolerance::{AXIS_RELATIVE, SENSE_LOOK},
};

/// Fractions of a parameter line at which is looked whether it goes around the axis.
const LOOKED_AT: [f64; 3] = [0.0, 0.37, 0.71];

/// From the parameters of a surface to those of its equation.
///
/// ```
/// use virote_kernel::{Frame, NurbsSurface, glam::DVec2};
///
/// let tube = NurbsSurface::cone(Frame::XY, [1.0, 1.0], 5.0)?;
/// let Some(found) = tube.analytic(1e-9) else { unreachable!("it is a cylinder") };
/// let place = tube.analytic_chart(&found).place([0.5, tube.domain_v().end()]);
/// assert!(place.distance(DVec2::new(std::f64::consts::PI, 5.0)) < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct AnalyticChart<'a> {
    surface: &'a NurbsSurface,
    form: AnalyticForm,
    from_space: DAffine3,
    to_space: DAffine3,
    /// Which parameter goes around the axis; that of a plane does not.
    around: Direction,
    /// The angle about the axis, and about the middle of a tube.
    turns: [ChartTurn; 2],
    /// Where along the meridian it is farthest from the axis, so that angles are told best.
    widest: f64,
}

/// How an angle grows with a parameter.
#[derive(Clone, Copy, Debug, Default)]
struct ChartTurn {
    /// The angle where the parameter starts.
    start: f64,
    is_backward: bool,
    /// The middle of the parameter, and how far it has turned there.
    middle: [f64; 2],
}

impl ChartTurn {
    /// The angle whose value but for full turns is known, where the parameter is.
    fn angle(&self, raw: f64, at: f64) -> f64 {
        let sense = if self.is_backward { -1.0 } else { 1.0 };
        let mut turned = libm::fmod((raw - self.start) * sense, TAU);
        if turned < 0.0 {
            turned += TAU;
        }
        let [middle, half] = self.middle;
        if at < middle && 0.5 * (half + TAU) < turned {
            turned -= TAU;
        } else if middle < at && turned < 0.5 * half {
            turned += TAU;
        }
        self.start + sense * turned
    }

    /// Of an angle that is known but for full turns over a parameter.
    fn of(raw: impl Fn(f64) -> f64, domain: Interval) -> Self {
        let (start, middle) = (raw(domain.start()), domain.at(0.5));
        // Hardly away from the start, where less than half a turn tells the sense.
        let step = raw(domain.at(SENSE_LOOK)) - start;
        let is_backward = (0.5 * TAU < step) || (-0.5 * TAU < step && step < 0.0);
        let mut turn = Self { start, is_backward, middle: [middle, 0.0] };
        turn.middle[1] = (turn.angle(raw(middle), middle) - start).abs();
        let end = turn.angle(raw(domain.end()), domain.end());
        // Backward around it begins where it ends forward.
        if is_backward && end < -AXIS_RELATIVE {
            turn.start += TAU;
        }
        turn
    }
}

impl NurbsSurface {
    /// How its parameters are those of an equation that [`Self::analytic`] found of it.
    #[must_use]
    pub fn analytic_chart(&self, found: &AnalyticSurface) -> AnalyticChart<'_> {
        let mut chart = AnalyticChart {
            surface: self,
            form: found.form,
            from_space: found.frame.from_space(),
            to_space: found.frame.to_space(),
            around: Direction::U,
            turns: [ChartTurn::default(); 2],
            widest: 0.0,
        };
        if found.form == AnalyticForm::Plane {
            return chart;
        }
        let middle_v = self.domain_v().at(0.5);
        let points = LOOKED_AT.map(|at| chart.half_plane(self.domain_u().at(at), middle_v));
        let reach = self.bounds().magnitude() * AXIS_RELATIVE;
        if points.iter().any(|point| reach < point.distance(points[0])) {
            chart.around = Direction::V;
        }
        let along = self.domain(chart.around.other());
        let from_axis =
            |&at: &f64| chart.local(self.domain(chart.around).start(), at).truncate().length();
        let places = [0.0, 0.25, 0.5, 0.75, 1.0].map(|at| along.at(at));
        let widest = places.into_iter().max_by(|a, b| from_axis(a).total_cmp(&from_axis(b)));
        chart.widest = widest.unwrap_or(along.start());
        let own = ChartTurn::of(|at| chart.raw_angle(at), self.domain(chart.around));
        let tube = match found.form {
            AnalyticForm::Torus { .. } => ChartTurn::of(|at| chart.raw_height(at), along),
            _ => ChartTurn::default(),
        };
        chart.turns = [own, tube];
        chart
    }
}

impl AnalyticChart<'_> {
    /// The parameters u and v of the equation at parameters of the surface.
    #[must_use]
    pub fn place(&self, [u, v]: [f64; 2]) -> DVec2 {
        if self.form == AnalyticForm::Plane {
            return self.from_space.transform_point3(self.surface.point_at(u, v)).truncate();
        }
        let [around, along] = match self.around {
            Direction::U => [u, v],
            Direction::V => [v, u],
        };
        let angle = self.turns[0].angle(self.raw_angle(around), around);
        let height = self.raw_height(along);
        match self.form {
            AnalyticForm::Torus { .. } => DVec2::new(angle, self.turns[1].angle(height, along)),
            _ => DVec2::new(angle, height),
        }
    }

    /// The parameters of a point of the equation, of those that are full turns apart the ones near a place; the place
    /// itself where the point is on the axis.
    #[must_use]
    pub fn place_of(&self, point: DVec3, near: DVec2) -> DVec2 {
        let local = self.from_space.transform_point3(point);
        let from_axis = local.truncate().length();
        if self.form == AnalyticForm::Plane {
            return local.truncate();
        }
        if from_axis <= AXIS_RELATIVE * (1.0 + local.z.abs()) {
            return near;
        }
        let height = self.height(from_axis, local.z);
        let beside = |raw: f64, near: f64| raw + TAU * libm::round((near - raw) / TAU);
        DVec2::new(
            beside(libm::atan2(local.y, local.x), near.x),
            match self.form {
                AnalyticForm::Torus { .. } => beside(height, near.y),
                _ => height,
            },
        )
    }

    /// The point of the equation at its parameters.
    #[must_use]
    pub fn point_at(&self, DVec2 { x: u, y: v }: DVec2) -> DVec3 {
        let (sine, cosine) = (libm::sin(v), libm::cos(v));
        let [out, z] = match self.form {
            AnalyticForm::Plane => return self.to_space.transform_point3(DVec3::new(u, v, 0.0)),
            AnalyticForm::Cylinder { radius } => [radius, v],
            AnalyticForm::Cone { radius, half_angle } => [radius + v * libm::tan(half_angle), v],
            AnalyticForm::Sphere { radius } => [radius * cosine, radius * sine],
            AnalyticForm::Torus { major, minor } => [major + minor * cosine, minor * sine],
        };
        let local = DVec3::new(out * libm::cos(u), out * libm::sin(u), z);
        self.to_space.transform_point3(local)
    }

    /// A point in the coordinates of the equation by its parameters around the axis and along a meridian.
    fn local(&self, around: f64, along: f64) -> DVec3 {
        let [u, v] = match self.around {
            Direction::U => [around, along],
            Direction::V => [along, around],
        };
        self.from_space.transform_point3(self.surface.point_at(u, v))
    }

    /// The distance from the axis and the height of a point of the surface.
    fn half_plane(&self, u: f64, v: f64) -> DVec2 {
        let local = self.from_space.transform_point3(self.surface.point_at(u, v));
        DVec2::new(norm(local.with_z(0.0)), local.z)
    }

    fn raw_angle(&self, around: f64) -> f64 {
        let local = self.local(around, self.widest);
        libm::atan2(local.y, local.x)
    }

    fn raw_height(&self, along: f64) -> f64 {
        let local = self.local(self.surface.domain(self.around).start(), along);
        self.height(local.truncate().length(), local.z)
    }

    /// The second parameter by the distance from the axis and the height.
    fn height(&self, from_axis: f64, z: f64) -> f64 {
        match self.form {
            AnalyticForm::Plane | AnalyticForm::Cylinder { .. } | AnalyticForm::Cone { .. } => z,
            AnalyticForm::Sphere { .. } => libm::atan2(z, from_axis),
            AnalyticForm::Torus { major, .. } => libm::atan2(z, from_axis - major),
        }
    }
}
