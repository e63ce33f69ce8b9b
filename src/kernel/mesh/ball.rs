//! What a mesh of a sphere, or of a part of one between meridians and circles, must keep to.
//!
//! The corners of a triangle are on the sphere. What is furthest from it is the middle of the circle around the
//! corners, or of the longest side where that is outside of the triangle: the triangle is within the tolerance where
//! this circle, or this side, is small enough. `ball_rows` lays rows of such triangles.

use std::f64::consts::{PI, TAU};

use glam::DVec3;

use super::cell_bounds::TessellationOptions;
use crate::{AnalyticForm, Direction, NurbsSurface, tolerance::LEAST_HEIGHT};

/// Places at which angles are told: along each span of the parameters at most, and of many spans together.
const ANGLES_A_SPAN: usize = 256;
const ANGLES: usize = 1024;

/// A sphere is at least so many times as large as the circles around its triangles.
const LEAST_FINE: f64 = 4.0;

/// How long a leg of an edge may be for the reach of a triangle: of rows that end beside it at a quarter and at three
/// quarters of a step, the triangles there then keep to the tolerance.
const LEG_SHARE: f64 = 1.3;

/// A part of a sphere, with meridians along one direction and circles along the other.
#[derive(Debug)]
pub(super) struct Ball {
    pub(super) center: DVec3,
    pub(super) radius: f64,
    pub(super) is_outward: bool,
    /// The direction of the circles.
    pub(super) around: Direction,
    /// Longitudes along the circles and latitudes along the meridians, by the direction.
    pub(super) angles: [AngleTable; 2],
    /// The latitude at the start of a meridian; radians.
    pub(super) start: f64,
    /// Whether latitudes grow along meridians.
    pub(super) is_northward: bool,
    /// How large the circle around a triangle may be: its radius.
    pub(super) reach: f64,
    /// How long a side may be for the angle that normals turn by, and at all.
    most_side: f64,
}

/// How far a point of a circle has turned by each parameter.
#[derive(Debug)]
pub(super) struct AngleTable {
    parameters: Vec<f64>,
    angles: Vec<f64>,
}

impl Ball {
    /// That of a spline which is one, within a tolerance.
    pub(super) fn of(
        spline: &NurbsSurface,
        tolerance: f64,
        wanted: &TessellationOptions,
    ) -> Option<Self> {
        let found = spline.analytic(wanted.weld)?;
        let AnalyticForm::Sphere { radius } = found.form else { return None };
        let turn = 2.0 * radius * libm::sin(0.5 * wanted.angle.min(PI));
        let most_side = wanted.max_edge.min(turn);
        // A larger one than the radius allows no longer sides.
        let tolerance = tolerance.min(radius);
        let chord = (tolerance * (2.0 * radius - tolerance)).sqrt();
        // No side is longer than the circle is wide.
        let reach = chord.min(0.5 * most_side);
        // Of few triangles a grid needs no more.
        if radius < LEAST_FINE * reach {
            return None;
        }
        let local = found.frame.from_space();
        let place = |[u, v]: [f64; 2]| local.transform_point3(spline.point_at(u, v));
        let domains = [spline.domain_u(), spline.domain_v()];
        let middles = domains.map(|domain| domain.at(0.5));
        let ends_along = |along: Direction| {
            let domain = domains[along];
            [domain.start(), domain.end()].map(|t| place(along.pair(t, middles[along.other()])))
        };
        // Along a circle all are at one height.
        let [rise_u, rise_v] = Direction::BOTH.map(|along| {
            let ends = ends_along(along).map(|end| (end.z - place(middles).z).abs());
            ends[0].max(ends[1])
        });
        let around = if rise_u < rise_v { Direction::U } else { Direction::V };
        let latitude = |p: DVec3| libm::atan2(p.z, p.truncate().length());
        let table = |along: Direction| {
            let angle = |t: f64| match place(along.pair(t, middles[along.other()])) {
                p if along == around => libm::atan2(p.y, p.x),
                p => latitude(p),
            };
            let knots = spline.knots(along);
            let n_steps = (ANGLES / knots.spans().count().max(1)).clamp(1, ANGLES_A_SPAN);
            let spans = knots.spans().map(|span| knots.span_interval(span));
            AngleTable::new(spans.flat_map(|span| span.steps(n_steps)), angle)
        };
        let [start, end] = ends_along(around.other()).map(latitude);
        Some(Self {
            center: found.frame.origin(),
            radius,
            is_outward: found.is_outward,
            around,
            angles: [table(Direction::U)?, table(Direction::V)?],
            start,
            is_northward: start < end,
            reach,
            most_side,
        })
    }

    /// Whether a leg of the edge of this number may run between two parameters.
    pub(super) fn allows_leg(&self, edge: usize, [low, high]: [f64; 2]) -> bool {
        let along = if edge < 2 { Direction::V } else { Direction::U };
        let angles = &self.angles[along];
        let turn = angles.at(high) - angles.at(low);
        let radius = match along == self.around {
            true => {
                let whole = self.angles[along.other()].whole();
                self.circle(if edge.is_multiple_of(2) { 0.0 } else { whole })
            }
            false => self.radius,
        };
        radius * turn <= LEG_SHARE * self.reach
    }

    /// The radius of the circle so far along a meridian; radians.
    pub(super) fn circle(&self, along: f64) -> f64 {
        let latitude = if self.is_northward { self.start + along } else { self.start - along };
        self.radius * libm::cos(latitude)
    }

    /// Whether the triangle of three places that are no further than `off` from the sphere is within `tolerance` of it,
    /// and what else is wanted.
    pub(super) fn allows(&self, [a, b, c]: [DVec3; 3], tolerance: f64, off: f64) -> bool {
        let sides = [a.distance_squared(b), b.distance_squared(c), c.distance_squared(a)];
        let longest = sides[0].max(sides[1]).max(sides[2]);
        let sum: f64 = sides.iter().sum();
        let area = (b - a).cross(c - a).length_squared();
        // Of the circle around them, or of the longest side where it faces an angle that is not sharp.
        let is_sharp = longest < sum - longest;
        let square = match is_sharp {
            true => sides[0] * sides[1] * sides[2] / (4.0 * area),
            false => 0.25 * longest,
        };
        let left = tolerance - off;
        let faces = (b - a).cross(c - a).dot(a - self.center);
        let is_turned = if self.is_outward { 0.0 < faces } else { faces < 0.0 };
        let is_sliver = area < (LEAST_HEIGHT * longest) * (LEAST_HEIGHT * longest);
        !is_sliver
            && longest <= self.most_side * self.most_side
            && 0.0 < left
            && square <= left * (2.0 * self.radius - left)
            && is_turned
    }
}

impl AngleTable {
    /// None of what turns back or stands still.
    fn new(parameters: impl Iterator<Item = f64>, angle: impl Fn(f64) -> f64) -> Option<Self> {
        let mut table = Self { parameters: Vec::new(), angles: Vec::new() };
        let (mut before, mut sum, mut side) = (0.0, 0.0, 0.0);
        for t in parameters {
            let now = angle(t);
            if table.parameters.is_empty() {
                table.parameters.push(t);
                table.angles.push(0.0);
                before = now;
                continue;
            }
            // Spans that follow one another share their ends.
            if table.parameters.last().is_some_and(|&last| t <= last) {
                continue;
            }
            let turn = now - before;
            let turn = turn - TAU * (turn / TAU).round();
            if PI / 2.0 < turn.abs() || turn * side < 0.0 || turn.abs() <= 0.0 || turn.is_nan() {
                return None;
            }
            (before, sum, side) = (now, sum + turn.abs(), turn);
            table.parameters.push(t);
            table.angles.push(sum);
        }
        (1 < table.angles.len()).then_some(table)
    }

    /// The angle at the end.
    pub(super) fn whole(&self) -> f64 {
        self.angles[self.angles.len() - 1]
    }

    /// The angle at a parameter.
    fn at(&self, t: f64) -> f64 {
        between(&self.parameters, &self.angles, t)
    }

    /// The parameter at an angle.
    pub(super) fn parameter(&self, angle: f64) -> f64 {
        between(&self.angles, &self.parameters, angle)
    }
}

/// What stands beside a number of a list that grows, on straight lines between.
fn between(from: &[f64], to: &[f64], number: f64) -> f64 {
    let i = from.partition_point(|&known| known <= number).clamp(1, from.len() - 1);
    let fraction = (number - from[i - 1]) / (from[i] - from[i - 1]);
    to[i - 1] + fraction * (to[i] - to[i - 1])
}
