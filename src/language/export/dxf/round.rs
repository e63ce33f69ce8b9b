//! Circles, circular arcs, and paths of arcs and straight lines, as a DXF has them: in the plane of a normal.
//!
//! Autodesk, *AutoCAD 2000 DXF Reference*, "Object Coordinate Systems": the normal alone tells the axes, by what is
//! called the arbitrary axis algorithm.

use std::f64::consts::{PI, TAU};

use glam::DVec3;

use crate::kernel::{AnalyticCurve, NurbsCurve, tolerance::ANALYTIC_RELATIVE};

/// A normal whose x and y are below one part in so many counts as that of the plane of x and y, by the reference.
const NEAR_Z_PARTS: f64 = 64.0;

/// Axes and normal of a plane through the origin, whose third coordinate is the height above it.
#[derive(Clone, Copy)]
pub(super) struct ObjectAxes([DVec3; 3]);

impl ObjectAxes {
    /// Those of a normal or of its opposite, whichever looks upward: readers know that one best.
    fn upward(normal: DVec3) -> (Self, bool) {
        let [x, y, z] = normal.to_array();
        let lead = [z, y, x].into_iter().find(|part| ANALYTIC_RELATIVE < part.abs());
        let is_turned = lead.is_some_and(|lead| lead < 0.0);
        let normal = if is_turned { -normal } else { normal };
        let is_near_z = NEAR_Z_PARTS * normal.x.abs().max(normal.y.abs()) < 1.0;
        let beside = if is_near_z { DVec3::Y } else { DVec3::Z };
        let x = beside.cross(normal).normalize();
        (Self([x, normal.cross(x), normal]), is_turned)
    }

    pub(super) fn normal(&self) -> DVec3 {
        self.0[2]
    }

    fn place(&self, point: DVec3) -> DVec3 {
        DVec3::from_array(self.0.map(|axis| axis.dot(point)))
    }

    /// The angle of a direction, radians.
    fn angle(&self, direction: DVec3) -> f64 {
        let place = self.place(direction);
        libm::atan2(place.y, place.x)
    }
}

/// A curve of circular arcs; places are those by the axes.
pub(super) enum RoundCurve {
    Circle {
        axes: ObjectAxes,
        center: DVec3,
        radius: f64,
    },
    /// Counter-clockwise between two angles, degrees.
    Arc {
        axes: ObjectAxes,
        center: DVec3,
        radius: f64,
        angles: [f64; 2],
    },
    Path(ArcPath),
}

/// Arcs and straight lines, each from a vertex to the next; of a closed one the last goes to the first.
pub(super) struct ArcPath {
    pub(super) axes: ObjectAxes,
    pub(super) vertices: Vec<ArcPathVertex>,
    pub(super) is_closed: bool,
}

pub(super) struct ArcPathVertex {
    pub(super) place: DVec3,
    /// The tangent of a quarter of the angle that the arc behind it turns by, counter-clockwise; 0 of a line.
    pub(super) bulge: f64,
}

/// The circle, arc or path that a curve is up to rounding; ends so near one another are one point. None for
/// what has no arc or lies in no plane.
pub(super) fn round_curve(curve: &NurbsCurve, precision: f64) -> Option<RoundCurve> {
    if !curve.is_rational() {
        return None;
    }
    let Some(AnalyticCurve::Circle { frame, radius, turn }) = curve.analytic() else {
        return path(curve, precision).map(RoundCurve::Path);
    };
    let (axes, is_turned) = ObjectAxes::upward(frame.z());
    let center = axes.place(frame.origin());
    if TAU <= turn {
        return Some(RoundCurve::Circle { axes, center, radius });
    }
    let first = axes.angle(frame.x());
    let [from, to] = if is_turned { [first - turn, first] } else { [first, first + turn] };
    let angles = [from, to].map(|angle| angle.to_degrees().rem_euclid(360.0));
    Some(RoundCurve::Arc { axes, center, radius, angles })
}

/// An arc within a path.
#[derive(Clone, Copy)]
struct PathArc {
    center: DVec3,
    radius: f64,
    /// Counter-clockwise.
    turn: f64,
}

impl PathArc {
    /// Both as one, where they lie on one circle and together turn by half of it at most.
    fn joined(self, next: Self, allowed: f64) -> Option<Self> {
        let turn = self.turn + next.turn;
        let is_one = self.center.distance(next.center) <= allowed
            && (self.radius - next.radius).abs() <= allowed
            && 0.0 < self.turn * next.turn
            && turn.abs() <= PI + ANALYTIC_RELATIVE;
        is_one.then_some(Self { turn, ..self })
    }
}

fn path(curve: &NurbsCurve, precision: f64) -> Option<ArcPath> {
    let allowed = ANALYTIC_RELATIVE * curve.bounds().magnitude();
    let mut pieces = Vec::new();
    for piece in curve.decompose() {
        pieces.push((piece.start(), piece.analytic()?));
    }
    let normal = pieces.iter().find_map(|(_, piece)| match piece {
        AnalyticCurve::Circle { frame, .. } => Some(frame.z()),
        AnalyticCurve::Line { .. } => None,
    })?;
    let (axes, _) = ObjectAxes::upward(normal);
    let height = axes.place(curve.start()).z;
    let is_level = |point: DVec3| (axes.place(point).z - height).abs() <= allowed;
    let mut legs: Vec<(DVec3, Option<PathArc>)> = Vec::with_capacity(pieces.len());
    for (start, piece) in pieces {
        let arc = match piece {
            AnalyticCurve::Line { .. } => None,
            AnalyticCurve::Circle { frame, radius, turn } => {
                let up = frame.z().dot(axes.normal());
                if !is_level(frame.origin()) || radius * (1.0 - up.abs()) > allowed {
                    return None;
                }
                Some(PathArc { center: frame.origin(), radius, turn: turn * up.signum() })
            }
        };
        if !is_level(start) {
            return None;
        }
        let before = legs.last_mut().and_then(|(_, before)| before.as_mut());
        match before.and_then(|before| Some((before.joined(arc?, allowed)?, before))) {
            Some((both, before)) => *before = both,
            None => legs.push((start, arc)),
        }
    }
    let is_closed = curve.start().distance(curve.end()) <= precision;
    let vertex = |&(start, arc): &(DVec3, Option<PathArc>)| ArcPathVertex {
        place: axes.place(start),
        bulge: arc.map_or(0.0, |arc| libm::tan(0.25 * arc.turn)),
    };
    let mut vertices: Vec<ArcPathVertex> = legs.iter().map(vertex).collect();
    if !is_closed {
        if !is_level(curve.end()) {
            return None;
        }
        vertices.push(ArcPathVertex { place: axes.place(curve.end()), bulge: 0.0 });
    }
    Some(ArcPath { axes, vertices, is_closed })
}
