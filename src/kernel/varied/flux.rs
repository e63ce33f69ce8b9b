//! Area and enclosed volume of surfaces whose control points depend on variables.
//!
//! The integrand is a function of S, Su and Sv, so that its gradient by a control point is its three
//! partial gradients times the basis functions and their slopes. Cells are halved until the rule on the
//! whole and those on its halves agree, as in the integrals of the surfaces themselves.

use glam::{DVec3, DVec4};

use super::VariedSurface;
use crate::{
    Direction, GeomError, Interval, LocalError,
    ceiling::SURFACE_CUTS,
    knots::acting,
    numeric::gauss_legendre::{EIGHT_NODES, nodes},
    tolerance::{GRADIENT_RELATIVE, LAST_BIT},
};

/// The slopes of an integral over a surface, and by which fraction of the gradient by its control points
/// they may be wrong.
///
/// The area of a unit square grows by 1 with the length of a side:
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{NurbsSurface, PointSlopes, SurfaceIntegral, VariedSurface, glam::{DVec3, DVec4}};
///
/// let square = NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::new(1.0, 1.0, 0.0))?;
/// let slopes = PointSlopes::new(1, 4, vec![(0, vec![DVec4::ZERO, DVec4::ZERO, DVec4::X, DVec4::X])])?;
/// let found: SurfaceIntegral = VariedSurface::new(Arc::new(square), slopes)?.area_slopes()?;
/// assert!((found.slopes[0] - 1.0).abs() < 1e-14 && found.relative_error < 1e-11);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceIntegral {
    /// By each variable.
    pub slopes: Vec<f64>,
    /// What is known of the error, as a fraction.
    pub relative_error: f64,
}

/// What an integrand's gradients by S, Su and Sv are, from these; none where there is none.
trait Partials: Fn([DVec3; 3]) -> Option<[DVec3; 3]> {}

impl<F: Fn([DVec3; 3]) -> Option<[DVec3; 3]>> Partials for F {}

/// A rectangle of parameters inside one patch.
#[derive(Clone, Copy)]
struct FluxCell {
    spans: [usize; 2],
    sides: [Interval; 2],
}

/// The gradient of an integral over a cell by the control points that act there.
struct CellGradient {
    values: Vec<DVec4>,
    /// The integral of its size.
    size: f64,
}

/// A cell with the rules on the whole and on its halves.
struct KnownCell {
    cell: FluxCell,
    values: Vec<DVec4>,
    size: f64,
    /// How much the halves differ from the whole, along u and along v.
    changes: [f64; 2],
}

impl FluxCell {
    fn halves(self, along: Direction) -> [Self; 2] {
        self.sides[along].halves().map(|side| {
            let mut half = self;
            half.sides[along] = side;
            half
        })
    }
}

impl KnownCell {
    fn change(&self) -> f64 {
        self.changes[0] + self.changes[1]
    }
}

impl VariedSurface {
    /// The slopes of the area: the integral of the unit normal times those of Su × Sv.
    ///
    /// # Errors
    /// [`LocalError::NotDifferentiable`] where the surface has no normal all over a cell.
    pub fn area_slopes(&self) -> Result<SurfaceIntegral, GeomError> {
        self.integral_slopes("the area", |[_, u, v]| {
            let across = u.cross(v);
            let length = across.length();
            let normal = across / length;
            (LAST_BIT * u.length() * v.length() < length)
                .then(|| [DVec3::ZERO, v.cross(normal), normal.cross(u)])
        })
    }

    /// The slopes of a third of the flux of the position about a point, (S − P)·(Su × Sv): what the surface
    /// adds to a volume that it encloses with others.
    ///
    /// # Errors
    /// Where the work is ended.
    pub fn volume_slopes(&self, about: DVec3) -> Result<SurfaceIntegral, GeomError> {
        self.integral_slopes("the volume", |[point, u, v]| {
            let arm = point - about;
            Some([u.cross(v), v.cross(arm), arm.cross(u)].map(|gradient| gradient / 3.0))
        })
    }

    /// The slopes of the integral of (S − C)·D over the area, a point C held: the sum over surfaces whose centre of
    /// gravity C is, is their area times how fast that moves along the direction D.
    ///
    /// # Errors
    /// As for [`Self::area_slopes`].
    pub fn area_moment_slopes(
        &self,
        center: DVec3,
        along: DVec3,
    ) -> Result<SurfaceIntegral, GeomError> {
        self.integral_slopes("the centroid", |[point, u, v]| {
            let (across, arm) = (u.cross(v), (point - center).dot(along));
            let length = across.length();
            let normal = across / length;
            (LAST_BIT * u.length() * v.length() < length)
                .then(|| [along * length, v.cross(normal) * arm, normal.cross(u) * arm])
        })
    }

    /// The slopes of what the surface adds to the integral of (S − C)·D over the volume that it encloses with others,
    /// as the fluxes of (S − P)((S − P)·D)/4 and (S − P)((C − P)·D)/3 about a point P: the sum is the volume times how
    /// fast its centre of gravity C moves along D.
    ///
    /// # Errors
    /// Where the work is ended.
    pub fn volume_moment_slopes(
        &self,
        about: DVec3,
        center: DVec3,
        along: DVec3,
    ) -> Result<SurfaceIntegral, GeomError> {
        self.integral_slopes("the centroid", |[point, u, v]| {
            let (arm, across) = (point - about, u.cross(v));
            let share = arm.dot(along) / 4.0 - (center - about).dot(along) / 3.0;
            let by_point = along * (arm.dot(across) / 4.0) + across * share;
            Some([by_point, v.cross(arm) * share, arm.cross(u) * share])
        })
    }

    /// The slopes of the integral of (S − C)·D (S − C)·E over the area, a point C held.
    ///
    /// # Errors
    /// As for [`Self::area_slopes`].
    pub fn area_second_moment_slopes(
        &self,
        center: DVec3,
        [d, e]: [DVec3; 2],
    ) -> Result<SurfaceIntegral, GeomError> {
        self.integral_slopes("the inertia", |[point, u, v]| {
            let (across, arm) = (u.cross(v), point - center);
            let length = across.length();
            let normal = across / length;
            let product = arm.dot(d) * arm.dot(e);
            let by_point = (d * arm.dot(e) + e * arm.dot(d)) * length;
            (LAST_BIT * u.length() * v.length() < length)
                .then(|| [by_point, v.cross(normal) * product, normal.cross(u) * product])
        })
    }

    /// The slopes of what the surface adds to the integral of (S − C)·D (S − C)·E over the volume that it encloses with
    /// others, a point C held: with A = S − P and B = C − P about a point P, the flux of
    /// A·(A·D A·E/5 − (A·D B·E + B·D A·E)/4 + B·D B·E/3).
    ///
    /// # Errors
    /// Where the work is ended.
    pub fn volume_second_moment_slopes(
        &self,
        [about, center]: [DVec3; 2],
        [d, e]: [DVec3; 2],
    ) -> Result<SurfaceIntegral, GeomError> {
        self.integral_slopes("the inertia", |[point, u, v]| {
            let (arm, across, held) = (point - about, u.cross(v), center - about);
            let mixed = arm.dot(d) * held.dot(e) + held.dot(d) * arm.dot(e);
            let share =
                arm.dot(d) * arm.dot(e) / 5.0 - mixed / 4.0 + held.dot(d) * held.dot(e) / 3.0;
            let by_arm =
                (d * arm.dot(e) + e * arm.dot(d)) / 5.0 - (d * held.dot(e) + e * held.dot(d)) / 4.0;
            let by_point = across * share + by_arm * arm.dot(across);
            Some([by_point, v.cross(arm) * share, arm.cross(u) * share])
        })
    }

    fn integral_slopes(
        &self,
        what: &'static str,
        partials: impl Partials,
    ) -> Result<SurfaceIntegral, GeomError> {
        let n_variables = self.slopes().n_variables();
        if self.slopes().is_fixed() {
            return Ok(SurfaceIntegral { slopes: vec![0.0; n_variables], relative_error: 0.0 });
        }
        let (knots_u, knots_v) = (self.surface().knots_u(), self.surface().knots_v());
        let mut known = Vec::new();
        for span_u in knots_u.spans() {
            for span_v in knots_v.spans() {
                let sides = [knots_u.span_interval(span_u), knots_v.span_interval(span_v)];
                let cell = FluxCell { spans: [span_u, span_v], sides };
                known.push(self.known(cell, what, &partials)?);
            }
        }
        let total: f64 = known.iter().map(|cell| cell.size).sum();
        let share = GRADIENT_RELATIVE * total / known.len() as f64;
        let mut gradient = vec![DVec4::ZERO; self.surface().control_points().as_slice().len()];
        let (mut error, mut n_cuts) = (0.0, SURFACE_CUTS);
        while let Some(cell) = known.pop() {
            GeomError::go_on(1)?;
            if cell.change() <= share || n_cuts == 0 {
                error += cell.change();
                self.add(&cell, &mut gradient);
                continue;
            }
            n_cuts -= 1;
            let along = if cell.changes[0] < cell.changes[1] { Direction::V } else { Direction::U };
            for half in cell.cell.halves(along) {
                known.push(self.known(half, what, &partials)?);
            }
        }
        let relative_error = error / total.max(f64::MIN_POSITIVE);
        Ok(SurfaceIntegral { slopes: self.slopes().through(&gradient), relative_error })
    }

    fn add(&self, cell: &KnownCell, gradient: &mut [DVec4]) {
        let surface = self.surface();
        let n_columns = surface.control_points().n_columns();
        let mut values = cell.values.iter();
        for i in surface.knots_u().support(cell.cell.spans[0]) {
            for (j, value) in surface.knots_v().support(cell.cell.spans[1]).zip(&mut values) {
                gradient[i * n_columns + j] += *value;
            }
        }
    }

    fn known(
        &self,
        cell: FluxCell,
        what: &'static str,
        partials: &impl Partials,
    ) -> Result<KnownCell, GeomError> {
        let whole = self.by_rule(cell, what, partials)?;
        let mut values: Vec<DVec4> = whole.values.clone();
        let mut changes = [0.0; 2];
        for (along, change) in Direction::BOTH.into_iter().zip(&mut changes) {
            let [a, b] = cell.halves(along);
            let (a, b) = (self.by_rule(a, what, partials)?, self.by_rule(b, what, partials)?);
            for (idx, value) in values.iter_mut().enumerate() {
                let correction = a.values[idx] + b.values[idx] - whole.values[idx];
                *value += correction;
                *change += correction.abs().element_sum();
            }
        }
        Ok(KnownCell { cell, values, size: whole.size, changes })
    }

    /// The tensor rule of Gauss and Legendre on a cell.
    fn by_rule(
        &self,
        cell: FluxCell,
        what: &'static str,
        partials: &impl Partials,
    ) -> Result<CellGradient, GeomError> {
        let [degree_u, degree_v] = [self.surface().degree_u(), self.surface().degree_v()];
        let mut values = vec![DVec4::ZERO; (degree_u + 1) * (degree_v + 1)];
        let mut size = 0.0;
        let area = cell.sides[0].length() * cell.sides[1].length();
        for (u, weight_u) in nodes(&EIGHT_NODES, cell.sides[0]) {
            for (v, weight_v) in nodes(&EIGHT_NODES, cell.sides[1]) {
                let weight = area * weight_u * weight_v;
                let here = self.add_density(cell.spans, [u, v], weight, partials, &mut values);
                let missing = LocalError::NotDifferentiable { what, at: u };
                size += here.ok_or(GeomError::Local(missing))?;
            }
        }
        Ok(CellGradient { values, size })
    }

    /// Adds the integrand's gradient by the control points that act at a place, times a weight; its size.
    fn add_density(
        &self,
        [span_u, span_v]: [usize; 2],
        [u, v]: [f64; 2],
        weight: f64,
        partials: &impl Partials,
        sums: &mut [DVec4],
    ) -> Option<f64> {
        let surface = self.surface();
        let net = surface.control_points();
        surface.knots_u().with_slopes(span_u, u, |values_u, slopes_u| {
            surface.knots_v().with_slopes(span_v, v, |values_v, slopes_v| {
                let mut d = [DVec4::ZERO; 3];
                let first = span_u + 1 - values_u.len();
                for (i, (&n_u, &dn_u)) in values_u.iter().zip(slopes_u).enumerate() {
                    let row = acting(net.row(first + i), span_v, values_v);
                    let (mut value, mut slope) = (DVec4::ZERO, DVec4::ZERO);
                    for ((&point, &n_v), &dn_v) in row.iter().zip(values_v).zip(slopes_v) {
                        value += point * n_v;
                        slope += point * dn_v;
                    }
                    d[0] += value * n_u;
                    d[1] += value * dn_u;
                    d[2] += slope * n_u;
                }
                let per_weight = 1.0 / d[0].w;
                let point = d[0].truncate() * per_weight;
                let [along_u, along_v] =
                    [d[1], d[2]].map(|slope| (slope.truncate() - point * slope.w) * per_weight);
                let [by_point, by_u, by_v] = partials([point, along_u, along_v])?;
                let tail = along_u.dot(by_u) + along_v.dot(by_v);
                let weight = weight * per_weight;
                // Of a control point (a, ω): dS = B·(a − ω·S)/w, and Su, Sv by its slopes.
                let held = by_point - by_u * (d[1].w * per_weight) - by_v * (d[2].w * per_weight);
                let (mut size, mut sums) = (0.0, sums.iter_mut());
                for (&n_u, &dn_u) in values_u.iter().zip(slopes_u) {
                    for ((&n_v, &dn_v), sum) in values_v.iter().zip(slopes_v).zip(&mut sums) {
                        let gradient =
                            held * (n_u * n_v) + by_u * (dn_u * n_v) + by_v * (n_u * dn_v);
                        let by_weight = -point.dot(gradient) - n_u * n_v * tail;
                        let part = gradient.extend(by_weight) * weight;
                        size += part.abs().element_sum();
                        *sum += part;
                    }
                }
                Some(size)
            })
        })
    }
}

#[cfg(test)]
mod tests;
