//! Lines and arcs that touch curves in one plane.
//!
//! A curve is looked at through its tangents (`dual`), which are a curve in the plane of lines: where two of those
//! meet is a line that touches both. The centre of an arc is as far from either curve as its radius: where offsets
//! meet (`arc`). So both searches are as complete as that of meetings; what they come to is made exact by Newton's
//! method on the curves themselves, and what does not touch then is left out.

mod arc;
mod dual;
mod line;
mod pair;

use glam::{DAffine3, DVec3};

use crate::{
    ConstructionError, FormError, Frame, GeomError, NurbsCurve, Tolerance, frame::norm,
    sorting::sort_by,
};

/// What a line or an arc starts from or comes to.
///
/// ```
/// use virote_kernel::{CircleForm, Frame, NurbsCurve, TangentEnd, TangentLine, Tolerance, glam::DVec3};
///
/// // From (5, 0) to a circle of radius 3 about the origin: the square of the length is 25 − 9.
/// let circle = NurbsCurve::ellipse(Frame::XY, [3.0; 2], CircleForm::NinePoint)?;
/// let ends = [TangentEnd::Point(DVec3::X * 5.0), TangentEnd::Curve(&circle)];
/// let lines = TangentLine::all(ends, Tolerance::DEFAULT)?;
/// assert_eq!(lines.len(), 2);
/// assert!(lines.iter().all(|line| (line.points[0].distance(line.points[1]) - 4.0).abs() < 1e-12));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub enum TangentEnd<'c> {
    /// To go through.
    Point(DVec3),
    /// To touch.
    Curve(&'c NurbsCurve),
}

/// A straight line that touches curves where it ends.
///
/// Two equal circles have two tangents outside and two that cross between them:
///
/// ```
/// use virote_kernel::{CircleForm, Frame, NurbsCurve, TangentEnd, TangentLine, Tolerance, glam::DVec3};
///
/// let circle = |x: f64| NurbsCurve::ellipse(Frame::XY.at(DVec3::X * x), [1.0; 2], CircleForm::NinePoint);
/// let (a, b) = (circle(0.0)?, circle(4.0)?);
/// let lines = TangentLine::all([TangentEnd::Curve(&a), TangentEnd::Curve(&b)], Tolerance::DEFAULT)?;
/// let mut lengths: Vec<f64> = lines.iter().map(|line| line.points[0].distance(line.points[1])).collect();
/// lengths.sort_by(f64::total_cmp);
/// let wanted = [12.0_f64.sqrt(), 12.0_f64.sqrt(), 4.0, 4.0];
/// assert!(lengths.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-12));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TangentLine {
    /// Where it starts and where it ends.
    pub points: [DVec3; 2],
    /// The parameters of the curves there; of a point none.
    pub parameters: [Option<f64>; 2],
}

/// An arc of a circle that touches curves where it ends.
///
/// Between the legs of a right angle the centre is as far from both as the radius:
///
/// ```
/// use virote_kernel::{NurbsCurve, TangentArc, TangentEnd, Tolerance, glam::DVec3};
///
/// let [x, y] = [DVec3::X, DVec3::Y].map(|end| NurbsCurve::line(DVec3::ZERO, end * 5.0));
/// let (x, y) = (x?, y?);
/// let arcs = TangentArc::all([TangentEnd::Curve(&x), TangentEnd::Curve(&y)], 2.0, Tolerance::DEFAULT)?;
/// let [arc] = &arcs[..] else { unreachable!("one") };
/// assert!(arc.center.distance(DVec3::new(2.0, 2.0, 0.0)) < 1e-14);
/// assert!((arc.turn - std::f64::consts::FRAC_PI_2).abs() < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TangentArc {
    /// Where it starts and where it ends.
    pub points: [DVec3; 2],
    /// The parameters of the curves there; of a point none.
    pub parameters: [Option<f64>; 2],
    /// The centre of its circle.
    pub center: DVec3,
    /// The radius, model units.
    pub radius: f64,
    /// The normal about which the shorter arc from start to end runs counter-clockwise: that of the plane if it is half
    /// a turn.
    pub normal: DVec3,
    /// The angle of the shorter arc, radians.
    pub turn: f64,
}

/// Both ends in a plane of which lengths are about 1.
struct PlaneEnds {
    /// The plane, with its origin amid them.
    frame: Frame,
    /// A length there, as one in space: a power of two.
    scale: f64,
    ends: [PlaneEnd; 2],
}

/// An end in a plane, z = 0.
#[derive(Clone, Debug)]
enum PlaneEnd {
    Point(DVec3),
    /// The parts of a curve between corners and cusps, each over its own parameters.
    Parts(Vec<NurbsCurve>),
}

impl PlaneEnds {
    /// # Errors
    /// [`ConstructionError::NotInOnePlane`], [`GeomError::Jump`]; those of [`NurbsCurve::plane_across`].
    fn of(ends: [TangentEnd<'_>; 2], tolerance: Tolerance) -> Result<Self, GeomError> {
        let mut places = Vec::new();
        for end in ends {
            match end {
                TangentEnd::Point(point) => places.push(point),
                TangentEnd::Curve(curve) => {
                    curve.check_connected()?;
                    places.extend(curve.points());
                }
            }
        }
        let around = NurbsCurve::polyline(&places)?;
        let bounds = around.bounds();
        let distance = tolerance.distance_for(bounds.diagonal());
        let plane = around.plane_across(DVec3::Z, distance).map_err(|error| match error {
            GeomError::Form(FormError::NotPlanar { by }) => {
                ConstructionError::NotInOnePlane { by }.into()
            }
            other => other,
        })?;
        let center = bounds.center();
        let frame = plane.at(center + plane.z() * (plane.origin() - center).dot(plane.z()));
        let (_, exponent) = libm::frexp(bounds.diagonal());
        let scale = libm::ldexp(1.0, exponent);
        let shrunk = DAffine3::from_scale(DVec3::new(1.0, 1.0, 0.0) / scale);
        let map = shrunk * frame.from_space();
        let in_plane = |end: TangentEnd<'_>| match end {
            TangentEnd::Point(point) => Ok(PlaneEnd::Point(map.transform_point3(point))),
            TangentEnd::Curve(curve) => {
                curve.transformed(&map).smooth_parts(tolerance.angle).map(PlaneEnd::Parts)
            }
        };
        let [first, second] = ends.map(in_plane);
        Ok(Self { frame, scale, ends: [first?, second?] })
    }

    /// A place of the plane, in space.
    fn in_space(&self, place: DVec3) -> DVec3 {
        self.frame.point(place * self.scale)
    }

    /// The point of an end at a parameter, in space.
    fn point(&self, end: TangentEnd<'_>, place: DVec3, parameter: Option<f64>) -> DVec3 {
        match (end, parameter) {
            (TangentEnd::Point(point), _) => point,
            (TangentEnd::Curve(curve), Some(t)) => curve.point_at(t),
            (TangentEnd::Curve(_), None) => self.in_space(place),
        }
    }
}

/// The number that (a × b) is along z.
fn cross(a: DVec3, b: DVec3) -> f64 {
    a.x * b.y - a.y * b.x
}

/// Leaves of contacts that are one within a distance the first, in the order of the parameters of both ends.
fn sorted<T>(
    mut found: Vec<T>,
    points: impl Fn(&T) -> [DVec3; 3],
    parameters: impl Fn(&T) -> [Option<f64>; 2],
    distance: f64,
) -> Vec<T> {
    let key = |item: &T| parameters(item).map(|t| t.unwrap_or(f64::NEG_INFINITY));
    sort_by(&mut found, |a, b| {
        let ([a, b], [c, d]) = (key(a), key(b));
        a.total_cmp(&c).then(b.total_cmp(&d))
    });
    let mut kept: Vec<T> = Vec::with_capacity(found.len());
    for item in found {
        let own = points(&item);
        let is_one = |other: &T| {
            points(other).iter().zip(own).all(|(other, own)| norm(*other - own) <= distance)
        };
        if !kept.iter().any(is_one) {
            kept.push(item);
        }
    }
    kept
}
