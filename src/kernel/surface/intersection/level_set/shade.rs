//! Lines of light on surfaces: isophotes, stripes, and reflected lines.
//!
//! With P = (wS, w) the normal Su × Sv is a positive multiple of the polynomial
//! w·(A_u × A_v) + w_v·(A × A_u) − w_u·(A × A_v), A = wS. Factors that vanish along a side of the
//! patch, as at a pole, are divided out of it, so that its direction has its limit there. What a
//! mirror shows is told by r = 2(N·e)N − |N|²e, e towards the eye.
//!
//! Poeschl, *Detecting surface irregularities using isophotes*, CAGD 1 (1984); Klass, *Correction of
//! local surface irregularities using reflection lines*, CAD 12 (1980).

use std::f64::consts::TAU;

use glam::DVec3;

use super::{CommonScale, LevelSet, PositivityCondition, ScalarField, ZeroSetParts, cell, square};
use crate::{
    GeomError, Grid, InputError, NurbsSurface, Surface, Tolerance,
    frame::{across, norm, unit},
    tolerance::{LIGHT_SHARE, SIGN_RELATIVE, VANISHING_RELATIVE},
};

/// A Bézier patch with its normals.
struct PatchWithNormals {
    patch: NurbsSurface,
    /// What the other fields are seen from.
    origin: DVec3,
    /// The homogeneous points from there: those in space, and their weights.
    places: Grid<DVec3>,
    weights: Grid<f64>,
    /// A positive multiple of Su × Sv.
    normals: Grid<DVec3>,
    /// N·N.
    squared: Grid<f64>,
}

impl Surface {
    /// For each angle the lines along which the normal stands at it to the direction `to_light`,
    /// within the tolerance's distance and complete; the lighter side is to their left.
    ///
    /// A patch that has the angle all over is told by its border.
    ///
    /// # Errors
    /// [`InputError::ZeroAxis`] without a light, [`super::PictureError::Unresolved`]; for functions as
    /// [`crate::ParametricSurface::to_nurbs`].
    pub fn isophotes(
        &self,
        to_light: DVec3,
        angles: &[f64],
        tolerance: Tolerance,
    ) -> Result<Vec<LevelSet>, GeomError> {
        if let Some((scaled, scale)) = CommonScale::of(self) {
            let found = scaled.isophotes(to_light, angles, scale.tolerance(tolerance));
            return scale.all_lines(found);
        }
        if let Some((whole, near)) = self.near_zero() {
            return whole.told_here(near.isophotes(to_light, angles, tolerance));
        }
        let light =
            unit(to_light).ok_or(GeomError::Input(InputError::ZeroAxis { what: "the light" }))?;
        let (patches, distance) = shaded(self, tolerance)?;
        let mut collected: Vec<ZeroSetParts> =
            angles.iter().map(|_| ZeroSetParts::new(distance)).collect();
        for shaded in &patches {
            let lit = shaded.normals.map(|normal| normal.dot(light));
            let lit_squared = square::product(&lit, &lit, |a, b| a * b);
            for (angle, collected) in angles.iter().zip(&mut collected) {
                let cosine = libm::cos(*angle);
                let side = if cosine < 0.0 { -1.0 } else { 1.0 };
                if cosine.abs() <= VANISHING_RELATIVE {
                    let rounding = SIGN_RELATIVE * largest(&shaded.normals);
                    collected.add(shaded.field(lit.clone(), rounding, Vec::new()))?;
                    continue;
                }
                let values = square::joined(&lit_squared, &shaded.squared, |lit, all| {
                    side * (lit - cosine * cosine * all)
                });
                let conditions = vec![condition(lit.map(|lit| side * lit))];
                let rounding = SIGN_RELATIVE * square::largest(&shaded.squared);
                collected.add(shaded.field(values, rounding, conditions))?;
            }
        }
        collected.into_iter().map(ZeroSetParts::finish).collect()
    }

    /// The lines between the stripes that the surface mirrors when it is seen along the rays of a
    /// light that comes from `to_light`, within the tolerance's distance and complete, stripe by
    /// stripe.
    ///
    /// The stripes are `n_bands` equal sectors about an axis across the light: z made normal to it,
    /// or x where the light comes along z. The light itself is in the middle of one.
    ///
    /// # Errors
    /// [`InputError::ZeroAxis`] without a light, [`super::PictureError::Unresolved`]; for functions as
    /// [`crate::ParametricSurface::to_nurbs`].
    pub fn zebra(
        &self,
        to_light: DVec3,
        n_bands: usize,
        tolerance: Tolerance,
    ) -> Result<Vec<LevelSet>, GeomError> {
        let light =
            unit(to_light).ok_or(GeomError::Input(InputError::ZeroAxis { what: "the light" }))?;
        let along = across(DVec3::Z, light).or_else(|| across(DVec3::X, light));
        self.sectors(light, along.unwrap_or(DVec3::X), n_bands, tolerance)
    }

    /// As [`Self::zebra`], with sectors about `axis` made normal to the light.
    ///
    /// # Errors
    /// [`InputError::ZeroAxis`] for an axis along the light; else those of [`Self::zebra`].
    pub fn zebra_about(
        &self,
        axis: DVec3,
        to_light: DVec3,
        n_bands: usize,
        tolerance: Tolerance,
    ) -> Result<Vec<LevelSet>, GeomError> {
        let missing = |what| GeomError::Input(InputError::ZeroAxis { what });
        let light = unit(to_light).ok_or_else(|| missing("the light"))?;
        let along = across(axis, light).ok_or_else(|| missing("the axis across the light"))?;
        self.sectors(light, along, n_bands, tolerance)
    }

    /// The lines between sectors about a direction `along`, which is normal to `light`.
    fn sectors(
        &self,
        light: DVec3,
        along: DVec3,
        n_bands: usize,
        tolerance: Tolerance,
    ) -> Result<Vec<LevelSet>, GeomError> {
        if let Some((scaled, scale)) = CommonScale::of(self) {
            let found = scaled.sectors(light, along, n_bands, scale.tolerance(tolerance));
            return scale.all_lines(found);
        }
        if let Some((whole, near)) = self.near_zero() {
            return whole.told_here(near.sectors(light, along, n_bands, tolerance));
        }
        let aside = along.cross(light);
        let (patches, distance) = shaded(self, tolerance)?;
        let mut collected: Vec<ZeroSetParts> =
            (0..n_bands).map(|_| ZeroSetParts::new(distance)).collect();
        for shaded in &patches {
            // The reflected ray along the light and aside, times |N|².
            let lit = shaded.normals.map(|normal| normal.dot(light));
            let sided = shaded.normals.map(|normal| normal.dot(aside));
            let lit_squared = square::product(&lit, &lit, |a, b| 2.0 * a * b);
            let back = square::joined(&lit_squared, &shaded.squared, |a, b| a - b);
            let aside = square::product(&lit, &sided, |a, b| 2.0 * a * b);
            let rounding = SIGN_RELATIVE * square::largest(&shaded.squared);
            for (band, collected) in collected.iter_mut().enumerate() {
                let (sine, cosine) = libm::sincos(TAU * (band as f64 + 0.5) / n_bands as f64);
                let values = square::joined(&back, &aside, |x, y| cosine * y - sine * x);
                let ahead = square::joined(&back, &aside, |x, y| cosine * x + sine * y);
                let conditions = vec![PositivityCondition { values: ahead, rounding }];
                collected.add(shaded.field(values, rounding, conditions))?;
            }
        }
        collected.into_iter().map(ZeroSetParts::finish).collect()
    }

    /// For each light, an endless straight line through a point along a direction, the lines on the
    /// surface where the eye sees it mirrored, within the tolerance's distance and complete.
    ///
    /// # Errors
    /// [`InputError::ZeroAxis`] of a light without a direction, [`super::PictureError::Unresolved`]; for
    /// functions as [`crate::ParametricSurface::to_nurbs`].
    pub fn reflection_lines(
        &self,
        eye: DVec3,
        lights: &[[DVec3; 2]],
        tolerance: Tolerance,
    ) -> Result<Vec<LevelSet>, GeomError> {
        if let Some((scaled, scale)) = CommonScale::of(self) {
            let lights: Vec<_> = lights.iter().map(|&[at, way]| [scale.place(at), way]).collect();
            let tolerance = scale.tolerance(tolerance);
            return scale.all_lines(scaled.reflection_lines(scale.place(eye), &lights, tolerance));
        }
        if let Some((whole, near)) = self.near_zero() {
            return whole.told_here(near.reflection_lines(eye, lights, tolerance));
        }
        let (patches, distance) = shaded(self, tolerance)?;
        let mut collected: Vec<ZeroSetParts> =
            lights.iter().map(|_| ZeroSetParts::new(distance)).collect();
        for shaded in &patches {
            let to_eye = shaded.ways_to(eye);
            let facing = square::product(&shaded.normals, &to_eye, DVec3::dot);
            let along = square::product(&facing, &shaded.normals, |a, n: DVec3| 2.0 * a * n);
            let back = square::product(&shaded.squared, &to_eye, |a, e: DVec3| a * e);
            let rays = square::joined(&along, &back, |a, b| a - b);
            for (&[point, direction], collected) in lights.iter().zip(&mut collected) {
                let direction = unit(direction)
                    .ok_or(GeomError::Input(InputError::ZeroAxis { what: "the light" }))?;
                let turned = shaded.ways_to(point).map(|way| way.cross(direction));
                // The ray and the light are in one plane, and meet ahead of the surface.
                let values = square::product(&rays, &turned, DVec3::dot);
                let turned_rays = rays.map(|ray| ray.cross(direction));
                let ahead = square::product(&turned, &turned_rays, DVec3::dot);
                let scale = largest(&rays) * largest(&turned);
                let rounding = SIGN_RELATIVE * scale;
                let conditions = vec![PositivityCondition { values: ahead, rounding }];
                collected.add(shaded.field(values, rounding, conditions))?;
            }
        }
        collected.into_iter().map(ZeroSetParts::finish).collect()
    }
}

/// The patches of a surface with their normals, but those that have none, and the tolerance for lines.
fn shaded(
    surface: &Surface,
    tolerance: Tolerance,
) -> Result<(Vec<PatchWithNormals>, f64), GeomError> {
    let spline = surface.splined(LIGHT_SHARE * tolerance.distance)?;
    let distance = spline.line_tolerance(tolerance)?;
    let spans = |knots: &crate::KnotVector| knots.spans().collect::<Vec<_>>();
    let (spans_u, spans_v) = (spans(spline.knots_u()), spans(spline.knots_v()));
    let pairs = spans_u.iter().flat_map(|&u| spans_v.iter().map(move |&v| (u, v)));
    let patches = pairs.filter_map(|(u, v)| PatchWithNormals::new(spline.patch(u, v)));
    Ok((patches.collect(), distance))
}

impl PatchWithNormals {
    /// `None` where the patch is a line or a point.
    fn new(patch: NurbsSurface) -> Option<Self> {
        let (origin, places, weights) = seen(&patch);
        let normals = without_sides(&normals(&places, &weights, patch.is_rational())?)?;
        let squared = square::product(&normals, &normals, DVec3::dot);
        Some(Self { patch, origin, places, weights, normals, squared })
    }

    fn field(
        &self,
        values: Grid<f64>,
        rounding: f64,
        conditions: Vec<PositivityCondition>,
    ) -> ScalarField<'_> {
        let is_zero = square::largest(&values) <= rounding;
        let basis = Some(&self.squared);
        ScalarField { patch: &self.patch, values, rounding, is_zero, conditions, basis }
    }

    /// From the surface to a point, times the denominator.
    fn ways_to(&self, point: DVec3) -> Grid<DVec3> {
        square::joined(&self.weights, &self.places, |w, place| (point - self.origin) * w - place)
    }
}

/// A Bézier patch seen from a place near it: the place, and the homogeneous points.
fn seen(patch: &NurbsSurface) -> (DVec3, Grid<DVec3>, Grid<f64>) {
    let points = patch.points();
    let origin = points.get(points.n_rows() / 2, points.n_columns() / 2);
    let places = patch.control_points.map(|point| point.truncate() - origin * point.w);
    (origin, places, patch.control_points.map(|point| point.w))
}

/// A positive multiple of Su × Sv of a Bézier patch, without factors that vanish along its sides;
/// `None` where it is a line or a point.
pub(super) fn normals_of(patch: &NurbsSurface) -> Option<Grid<DVec3>> {
    let (_, places, weights) = seen(patch);
    without_sides(&normals(&places, &weights, patch.is_rational())?)
}

fn condition(values: Grid<f64>) -> PositivityCondition {
    let rounding = SIGN_RELATIVE * square::largest(&values);
    PositivityCondition { values, rounding }
}

fn largest(vectors: &Grid<DVec3>) -> f64 {
    vectors.iter().map(|&vector| norm(vector)).fold(0.0, f64::max)
}

/// A positive multiple of Su × Sv; `None` where it is rounding all over.
fn normals(places: &Grid<DVec3>, weights: &Grid<f64>, is_rational: bool) -> Option<Grid<DVec3>> {
    if places.n_rows() < 2 || places.n_columns() < 2 {
        return None;
    }
    let [by_u, by_v] = [square::slope_u(places), square::slope_v(places)];
    let area = square::product(&by_u, &by_v, DVec3::cross);
    let rounding = VANISHING_RELATIVE * largest(&by_u).max(largest(&by_v)) * largest(places);
    let normals = if is_rational {
        let [w_by_u, w_by_v] = [square::slope_u(weights), square::slope_v(weights)];
        let times = |w: f64, vector: DVec3| w * vector;
        let terms = [
            square::product(weights, &area, times),
            square::product(&w_by_v, &square::product(places, &by_u, DVec3::cross), times),
            square::product(&w_by_u, &square::product(places, &by_v, DVec3::cross), times),
        ];
        let [a, b, c] = terms;
        square::joined(&square::joined(&a, &b, |a, b| a + b), &c, |a, c| a - c)
    } else {
        area
    };
    (rounding < largest(&normals)).then_some(normals)
}

/// The normals without the factors that vanish along sides.
fn without_sides(normals: &Grid<DVec3>) -> Option<Grid<DVec3>> {
    let rounding = SIGN_RELATIVE * largest(normals);
    cell::without_sides(normals, |vector| norm(*vector) <= rounding).map(|(rest, _)| rest)
}
