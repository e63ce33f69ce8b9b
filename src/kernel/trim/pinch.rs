//! Where a surface narrows to a point along a line of constant parameter, like a double cone at its apex.
//!
//! All of such a line is one place: what cuts the surface there cuts it along the line, at which both sides only
//! touch, and a solid with such a face touches itself. Edges that are points, such as poles, are none.

use glam::DVec3;

use super::{Face, plane::ParameterPlane};
use crate::{
    Bounds, GeomError, KnotVector, NurbsCurve, RegionSide,
    frame::unit,
    numeric::golden_section::golden_section,
    tolerance::{PARAMETER_RELATIVE, PINCH_ALIKE, PINCH_STEP},
};

/// Even parts of each span at whose ends lines of constant parameter are looked at.
const PARTS: usize = 16;

/// Where on such a line.
const LOOKS: [f64; 4] = [0.0, 0.3, 0.7, 1.0];

/// Parts of an arc at whose ends it is looked at how far it is from such a line.
const ARC_LOOKS: usize = 8;

/// Between neighbours a line may be a point where it is no longer than this part of the longer one of them.
const LEAST_SHARE: f64 = 0.5;

/// A line of constant parameter that is a point, not at an end of the domain unless that is a seam.
#[derive(Clone, Copy, Debug)]
pub(super) struct DegenerateLine {
    /// The number of the parameter that is constant along it, and that parameter.
    across: usize,
    at: f64,
    pub(super) point: DVec3,
}

/// Parameters by the number of that which is constant along a line, its value and the other one.
const fn parameters((across, at): (usize, f64), along: f64) -> [f64; 2] {
    if across == 0 { [at, along] } else { [along, at] }
}

/// The ends of even parts of all spans.
fn parameters_of(knots: &KnotVector) -> Vec<f64> {
    let spans = knots.spans().flat_map(|span| knots.span_interval(span).steps(PARTS));
    let mut parameters: Vec<f64> = spans.collect();
    parameters.dedup();
    parameters
}

impl ParameterPlane {
    /// The lines of constant parameter that are points within a distance.
    pub(super) fn pinches(&self, distance: f64) -> Vec<DegenerateLine> {
        (0..2).flat_map(|across| self.pinches_across(across, 2.0 * distance)).collect()
    }

    fn pinches_across(&self, across: usize, widest: f64) -> Vec<DegenerateLine> {
        let knots = [self.surface.knots_u(), self.surface.knots_v()];
        let along = self.domains()[1 - across];
        let width = |at: f64| self.width((across, at), LOOKS.map(|look| along.at(look)));
        let places = parameters_of(knots[across]);
        let widths: Vec<f64> = places.iter().map(|&at| width(at)).collect();
        let last = places.len() - 1;
        let mut found: Vec<f64> = Vec::new();
        let is_wide = |widths: &[f64]| widths.iter().any(|&width| widest < width);
        if self.is_closed[across] && widths[0] <= widest && is_wide(&widths) {
            found.push(places[0]);
        }
        for i in 1..last {
            let [before, here, behind] = [widths[i - 1], widths[i], widths[i + 1]];
            if !(is_wide(&widths[..i]) && is_wide(&widths[i + 1..])) {
                continue;
            }
            if here <= widest {
                found.push(places[i]);
            } else if here <= before.min(behind) && here <= LEAST_SHARE * before.max(behind) {
                let (at, least) = golden_section(width, [places[i - 1], places[i + 1]]);
                found.extend((least <= widest).then_some(at));
            }
        }
        let others = parameters_of(knots[1 - across]);
        found.retain(|&at| self.width((across, at), others.iter().copied()) <= widest);
        let point = |at: f64| self.surface_at((across, at), along.at(0.0));
        found.into_iter().map(|at| DegenerateLine { across, at, point: point(at) }).collect()
    }

    /// The edges of the domain that are points where the surface has a tip, like the apex of a cone: beside poles
    /// at which it is smooth all normals are one.
    fn tips(&self, distance: f64) -> Vec<DegenerateLine> {
        let mut found = Vec::new();
        for across in (0..2).filter(|&across| !self.is_closed[across]) {
            let (own, along) = (self.domains()[across], self.domains()[1 - across]);
            let others =
                parameters_of([self.surface.knots_u(), self.surface.knots_v()][1 - across]);
            for (end, step) in [(own.start(), PINCH_STEP), (own.end(), -PINCH_STEP)] {
                let is_point = self.width((across, end), LOOKS.map(|look| along.at(look)))
                    <= 2.0 * distance
                    && self.width((across, end), others.iter().copied()) <= 2.0 * distance;
                let beside = end + step * own.length();
                let normal = |&other: &f64| {
                    let [u, v] = parameters((across, beside), other);
                    self.surface.normal_at(u, v).ok()
                };
                let normals: Vec<DVec3> =
                    others.iter().filter(|_| is_point).filter_map(normal).collect();
                if normals.iter().any(|normal| PINCH_ALIKE < normal.distance(normals[0])) {
                    let point = self.surface_at((across, end), along.at(0.0));
                    found.push(DegenerateLine { across, at: end, point });
                }
            }
        }
        found
    }

    /// Whether the line at the start of a closed parameter is a point.
    pub(super) fn has_point_seam(&self, across: usize, distance: f64) -> bool {
        let (own, along) = (self.domains()[across], self.domains()[1 - across]);
        self.width((across, own.start()), LOOKS.map(|look| along.at(look))) <= 2.0 * distance
    }

    fn surface_at(&self, line: (usize, f64), along: f64) -> DVec3 {
        let [u, v] = parameters(line, along);
        self.surface.point_at(u, v)
    }

    /// How wide a line of constant parameter is by some of its places.
    fn width(&self, line: (usize, f64), along: impl IntoIterator<Item = f64>) -> f64 {
        let places = along.into_iter().map(|along| self.surface_at(line, along));
        Bounds::of(places).map_or(0.0, Bounds::diagonal)
    }

    /// Whether both sides of the line are one disc, which only its parameters part: the ends of each lead on into
    /// those of the other, as those of a circle do that is turned by half about its diameter.
    fn is_disc(&self, pinch: &DegenerateLine) -> bool {
        let along = self.domains()[1 - pinch.across];
        let domain = self.domains()[pinch.across];
        let direction = |share: f64, end: f64| {
            let at = pinch.at + share * PINCH_STEP * domain.length();
            let place = self.surface_at((pinch.across, at), end);
            unit(place - pinch.point).unwrap_or(DVec3::ZERO)
        };
        let is_one =
            |[a, b]: [f64; 2]| direction(-1.0, a).distance(direction(1.0, b)) <= PINCH_ALIKE;
        let ends = [along.start(), along.end()];
        !self.is_closed[1 - pinch.across]
            && domain.start() < pinch.at
            && is_one(ends)
            && is_one([ends[1], ends[0]])
    }
}

impl Face {
    /// A place in which parts of it touch that hang together nowhere else near it.
    pub(crate) fn pinch(&self, distance: f64) -> Option<DVec3> {
        let pinches = self.plane.pinches(distance).into_iter();
        let mut inside = pinches.filter(|pinch| self.is_inside(pinch, distance));
        inside.find(|pinch| !self.plane.is_disc(pinch)).map(|pinch| pinch.point)
    }

    /// The places to which it narrows, whether inside or at tips.
    pub(crate) fn narrow_places(&self, distance: f64) -> Vec<DVec3> {
        let pinches = self.plane.pinches(distance).into_iter();
        let inside = pinches.filter(|pinch| self.is_inside(pinch, distance));
        let tips = self.plane.tips(distance).into_iter();
        let tips =
            tips.filter(|tip| self.has_any_of(tip, distance, |side| side != RegionSide::Outside));
        inside.chain(tips).map(|pinch| pinch.point).collect()
    }

    fn is_inside(&self, pinch: &DegenerateLine, distance: f64) -> bool {
        self.has_any_of(pinch, distance, |side| side == RegionSide::Inside)
    }

    fn has_any_of(
        &self,
        pinch: &DegenerateLine,
        distance: f64,
        is_it: impl Fn(RegionSide) -> bool,
    ) -> bool {
        let knots = [self.surface().knots_v(), self.surface().knots_u()][pinch.across];
        parameters_of(knots).windows(2).any(|pair| {
            let place = parameters((pinch.across, pinch.at), 0.5 * (pair[0] + pair[1]));
            is_it(self.side_of_parameters(place, distance))
        })
    }

    /// Adds to the arcs of a cutter those lines within the domain that are points on it.
    ///
    /// # Errors
    /// Those of [`NurbsCurve::line`].
    pub(super) fn with_pinches(
        &self,
        mut arcs: Vec<NurbsCurve>,
        distance: f64,
        is_on_cutter: impl Fn(DVec3) -> bool,
    ) -> Result<Vec<NurbsCurve>, GeomError> {
        let has_arcs = !arcs.is_empty();
        for pinch in self.plane.pinches(distance) {
            let (domain, along) =
                (self.plane.domains()[pinch.across], self.plane.domains()[1 - pinch.across]);
            let is_within = PARAMETER_RELATIVE * domain.length() < pinch.at - domain.start();
            let is_cut = is_within && is_on_cutter(pinch.point) && self.is_inside(&pinch, distance);
            if is_cut && (has_arcs || !self.plane.is_disc(&pinch)) {
                // What runs around the place within the distance is the place.
                let is_there = |arc: &NurbsCurve| {
                    let places = arc.domain().steps(ARC_LOOKS).into_iter();
                    let mut points = places.map(|t| self.plane.point(arc.point_at(t)));
                    points.all(|point| point.distance(pinch.point) <= 2.0 * distance)
                };
                arcs.retain(|arc| !is_there(arc));
                let line = (pinch.across, pinch.at);
                let end = |along: f64| self.plane.place(parameters(line, along));
                arcs.push(NurbsCurve::line(end(along.start()), end(along.end()))?);
            }
        }
        Ok(arcs)
    }
}
