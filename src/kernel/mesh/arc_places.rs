//! Places along the borders of parts of a surface.

use glam::{DVec2, DVec3};

use crate::NurbsCurve;

/// A place on the border of a part: at which parameters of the surface, and where it is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BorderVertex {
    pub(crate) parameters: DVec2,
    pub(crate) point: DVec3,
}

/// Where an arc runs along a line that parts share: which parameter is constant, and the line's number.
pub(super) type SharedLine = (usize, u64);

/// The parameters of the surface at one of an arc.
pub(super) fn at(arc: &NurbsCurve, t: f64) -> DVec2 {
    arc.point_at(t).truncate()
}

/// The places on a line along which an arc runs, from its start up to before its end.
pub(super) fn between(arc: &NurbsCurve, along: usize, places: &[f64], slack: f64) -> Vec<DVec2> {
    let (start, end) = (arc.start().truncate(), arc.end().truncate());
    let (from, to) = (start[along], end[along]);
    let (low, high) = (from.min(to) + slack, from.max(to) - slack);
    let inner = places.iter().copied().filter(|&t| low < t && t < high);
    let mut inner: Vec<f64> = inner.collect();
    if to < from {
        inner.reverse();
    }
    let place = |t: f64| if along == 0 { DVec2::new(t, start.y) } else { DVec2::new(start.x, t) };
    std::iter::once(start).chain(inner.into_iter().map(place)).collect()
}
