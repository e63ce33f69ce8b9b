//! Two surfaces about places where they are nearly parallel: heights over the plane at right angles to their
//! common normal.

use glam::{DMat2, DVec2, DVec3};

use super::surface_pair::SurfacePair;
use crate::{
    frame::unit,
    numeric::symmetric_eigen::eigen_of_two,
    tolerance::{BEND_RELATIVE, SIGN_RELATIVE},
};

/// Both surfaces about parameters where they are nearly parallel.
#[derive(Clone, Copy, Debug)]
pub(super) struct ParallelPair {
    pub(super) at: [f64; 4],
    pub(super) point: DVec3,
    /// Two axes in the tangent plane of the first, and its normal.
    pub(super) axes: [DVec3; 3],
    /// From the point of the first to that of the second: in the plane, and over it.
    pub(super) apart: DVec2,
    pub(super) rise: f64,
    /// How the second climbs over the plane, and whether it has the same side up.
    pub(super) slope: DVec2,
    pub(super) is_alike: bool,
    /// Steps in the parameters by steps in the plane.
    pub(super) maps: [DMat2; 2],
    /// Second derivatives of the height of the second, and of the difference.
    pub(super) bend: DMat2,
    pub(super) difference: DMat2,
    /// How fast the parameters lead through space.
    pub(super) speeds: [f64; 4],
}

/// Parameters of both surfaces about a place, within which all is known that they share.
#[derive(Clone, Copy, Debug)]
pub(super) struct ParameterRegion {
    pub(super) at: [f64; 4],
    pub(super) point: DVec3,
    pub(super) radius: f64,
    pub(super) widths: [f64; 4],
}

impl ParameterRegion {
    /// Whether parameters between these are within, on both surfaces.
    pub(super) fn holds(&self, low: [f64; 4], high: [f64; 4]) -> bool {
        (0..4).all(|i| {
            self.at[i] - self.widths[i] <= low[i] && high[i] <= self.at[i] + self.widths[i]
        })
    }
}

/// A surface over a plane.
struct HeightField {
    point: DVec3,
    map: DMat2,
    slope: DVec2,
    bend: DMat2,
    speeds: [f64; 2],
    normal: DVec3,
}

impl HeightField {
    fn new([point, u, v, uu, uv, vv]: [DVec3; 6], [x, y, z]: [DVec3; 3]) -> Option<Self> {
        let flat = |vector: DVec3| DVec2::new(vector.dot(x), vector.dot(y));
        let map = DMat2::from_cols(flat(u), flat(v)).inverse();
        let slope = map.transpose() * DVec2::new(u.dot(z), v.dot(z));
        let upward = z - x * slope.x - y * slope.y;
        let [uu, uv, vv] = [uu, uv, vv].map(|second| second.dot(upward));
        let second = DMat2::from_cols(DVec2::new(uu, uv), DVec2::new(uv, vv));
        let bend = map.transpose() * second * map;
        let normal = unit(u.cross(v))?;
        let height = Self { point, map, slope, bend, speeds: [u.length(), v.length()], normal };
        (map.is_finite() && bend.is_finite()).then_some(height)
    }
}

impl ParallelPair {
    /// `None` where a surface has no normal, or the normals are far from parallel.
    pub(super) fn new(crossing: &SurfacePair<'_>, at: [f64; 4]) -> Option<Self> {
        let [first, second] =
            [0, 1].map(|i| crossing.surfaces[i].second_order_at(at[2 * i], at[2 * i + 1]));
        let normal = unit(first[1].cross(first[2]))?;
        let x = unit(first[1])?;
        let axes = [x, normal.cross(x), normal];
        let (a, b) = (HeightField::new(first, axes)?, HeightField::new(second, axes)?);
        let facing = b.normal.dot(normal);
        let way = b.point - a.point;
        let seen = Self {
            at,
            point: a.point.midpoint(b.point),
            axes,
            apart: DVec2::new(way.dot(axes[0]), way.dot(axes[1])),
            rise: way.dot(normal),
            slope: b.slope,
            is_alike: 0.0 < facing,
            maps: [a.map, b.map],
            bend: b.bend,
            difference: a.bend - b.bend,
            speeds: [a.speeds[0], a.speeds[1], b.speeds[0], b.speeds[1]],
        };
        (0.5 <= facing.abs()).then_some(seen)
    }

    /// The step in the plane to where the slope of e vanishes, but not along a line of zeros; none
    /// where surfaces of that size bend alike.
    pub(super) fn step(&self, size: f64) -> DVec2 {
        let right = self.slope - self.bend * self.apart;
        let [(weak, along), (strong, across)] = eigen_of_two(self.difference);
        let bend = self.bend.x_axis.abs().max_element().max(self.bend.y_axis.abs().max_element());
        let rounding = SIGN_RELATIVE * (bend + 1.0 / size);
        let part = |value: f64, axis: DVec2| match value.abs() <= rounding {
            true => DVec2::ZERO,
            false => axis * (axis.dot(right) / value),
        };
        let rest = if weak.abs() <= BEND_RELATIVE * strong.abs() { 0.0 } else { 1.0 };
        part(strong, across) + rest * part(weak, along)
    }

    pub(super) fn in_space(&self, step: DVec2) -> DVec3 {
        self.axes[0] * step.x + self.axes[1] * step.y
    }

    /// The parameters a step further, each surface by its own.
    pub(super) fn moved(&self, first: DVec2, second: DVec2) -> [f64; 4] {
        let steps = self.steps(first, second);
        std::array::from_fn(|i| self.at[i] + steps[i])
    }

    /// The parameters' steps there.
    pub(super) fn steps(&self, first: DVec2, second: DVec2) -> [f64; 4] {
        let [a, b] = [self.maps[0] * first, self.maps[1] * second];
        [a.x, a.y, b.x, b.y]
    }

    /// The direction in which e bends least.
    pub(super) fn along(&self) -> DVec3 {
        self.in_space(eigen_of_two(self.difference)[0].1)
    }

    /// How much it bends across that.
    pub(super) fn strongest(&self) -> f64 {
        eigen_of_two(self.difference)[1].0.abs()
    }

    /// The parameters that lead a way through space further.
    pub(super) fn ahead(&self, way: DVec3) -> [f64; 4] {
        let step = DVec2::new(way.dot(self.axes[0]), way.dot(self.axes[1]));
        self.moved(step, step)
    }

    pub(super) fn reach(&self, radius: f64) -> ParameterRegion {
        let widths = self.speeds.map(|speed| 0.5 * radius / speed);
        ParameterRegion { at: self.at, point: self.point, radius, widths }
    }
}
