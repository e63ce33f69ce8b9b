//! Pieces of a curve in search of a surface: boxes and cones of tangents.

use glam::{DVec3, DVec4};

use crate::{
    Bounds, NurbsCurve, bezier,
    frame::{norm, unit, widest_angle},
    homogeneous,
    nearest::BoxedPiece,
};

/// A piece of the curve.
pub(super) struct BezierSegment {
    pub(super) ends: [f64; 2],
    points: Vec<DVec4>,
    pub(super) places: Vec<DVec3>,
    pub(super) bounds: Bounds,
    /// All tangents are within the angle of the axis.
    pub(super) axis: DVec3,
    pub(super) angle: f64,
}

/// A piece of the curve that comes near the surface.
#[derive(Clone, Copy)]
pub(super) struct LyingPiece {
    pub(super) ends: [f64; 2],
    pub(super) bounds: Bounds,
    pub(super) widest: f64,
}

impl LyingPiece {
    /// One that was looked at with parts up to a size.
    pub(super) fn new(piece: &BezierSegment, widest: f64) -> Self {
        Self { ends: piece.ends, bounds: piece.bounds, widest }
    }
}

impl BoxedPiece for BezierSegment {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn halves(&self) -> [Self; 2] {
        let (before, behind) = bezier::cut_at(&self.points, 0.5);
        let middle = 0.5 * (self.ends[0] + self.ends[1]);
        [Self::new([self.ends[0], middle], before), Self::new([middle, self.ends[1]], behind)]
    }
}

impl BezierSegment {
    pub(super) fn of_span(curve: &NurbsCurve, span: usize) -> Self {
        let ends = curve.knots().span_interval(span);
        let points = bezier::piece(curve.knots(), curve.control_points(), span);
        Self::new([ends.start(), ends.end()], points)
    }

    fn new(ends: [f64; 2], points: Vec<DVec4>) -> Self {
        let places: Vec<DVec3> = points.iter().map(|&point| homogeneous::place(point)).collect();
        let nothing = Bounds { min: DVec3::ZERO, max: DVec3::ZERO };
        let bounds = Bounds::of(places.iter().copied()).unwrap_or(nothing);
        // Tangents of a rational curve are between the legs of its polygon.
        let legs = || places.windows(2).filter_map(|pair| unit(pair[1] - pair[0]));
        let axis = unit(legs().sum()).unwrap_or(DVec3::ZERO);
        let angle = match axis == DVec3::ZERO {
            true => std::f64::consts::PI,
            false => widest_angle(legs(), axis),
        };
        Self { ends, points, places, bounds, axis, angle }
    }

    /// How far the control points are from the chord.
    pub(super) fn deviation(&self) -> f64 {
        let (start, end) = (self.places[0], self.places[self.places.len() - 1]);
        let chord = unit(end - start).unwrap_or(DVec3::ZERO);
        let off = |&place: &DVec3| {
            let way = place - start;
            norm(way - chord * way.dot(chord))
        };
        self.places.iter().map(off).fold(0.0, f64::max)
    }
}
