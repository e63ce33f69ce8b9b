//! The shape of a surface at a pole: where an edge is collapsed to a point.
//!
//! At the pole S = P + w·A(u) + w²·B(u)/2 + …, where w counts across the edge. If all A(u) lie in
//! one plane, that is the tangent plane, with normal n, and the isocurve u leaves the pole with
//! normal curvature n·B/|A|². The surface has a second fundamental form there if these are the
//! values of one quadratic form, II(A, A) = n·B for all u. Three derivatives of that by u give
//! the form; other places of the edge tell whether it is the one of all.

use glam::DVec3;

use crate::{
    Direction, GeomError, Grid, LocalError,
    frame::{norm, unit},
    surface::{Surface, SurfaceShape},
    tolerance::{NORMAL_AGREEMENT, VANISHING_RELATIVE},
};

/// Even parts of a collapsed edge at whose ends its shape is compared.
const PARTS: usize = 32;

/// Derivatives at a place of a collapsed edge: first index along it, second across it.
struct PoleDerivatives(Grid<DVec3>);

impl Surface {
    /// The shape at a place where Su × Sv vanishes.
    ///
    /// # Errors
    /// [`LocalError::NoNormal`], [`LocalError::NoCurvature`], and as [`Self::point_at`].
    pub(in crate::surface) fn pole_shape(&self, u: f64, v: f64) -> Result<SurfaceShape, GeomError> {
        let normal = self.normal_at(u, v)?;
        let (domain_u, domain_v) = (self.domain_u(), self.domain_v());
        let [width_u, width_v] = self.widths_at(u, v);
        let edges = [
            (domain_v.inward(v), Direction::U, domain_u, [width_u, width_v]),
            (domain_u.inward(u), Direction::V, domain_v, [width_v, width_u]),
        ];
        for (across, along, domain, widths) in edges {
            let Some(across) = across else { continue };
            let fan_at = |t: f64| -> Result<PoleDerivatives, GeomError> {
                Ok(PoleDerivatives(match along {
                    Direction::U => self.derivatives_at(t, v, 4)?,
                    Direction::V => self.derivatives_at(u, t, 4)?.transposed(),
                }))
            };
            let here = fan_at([u, v][along])?;
            let Some(shape) = here.shape(normal, across, widths) else { continue };
            let mut is_one = true;
            for t in domain.steps(PARTS) {
                is_one &= fan_at(t)?.agrees_with(&shape);
            }
            if is_one {
                return Ok(shape);
            }
        }
        Err(GeomError::Local(LocalError::NoCurvature { u, v }))
    }
}

impl PoleDerivatives {
    /// The form that derivatives along the edge give; `None` where it does not follow from them.
    fn shape(&self, normal: DVec3, across: f64, widths: [f64; 2]) -> Option<SurfaceShape> {
        let Self(derivatives) = self;
        let [along, step] = widths;
        let point = derivatives.get(0, 0);
        let leg = derivatives.get(0, 1) * across;
        let length = norm(leg);
        let coordinates = point.abs().max_element() + length * step;
        let is_still = norm(derivatives.get(1, 0)) * along <= VANISHING_RELATIVE * coordinates;
        let x = unit(leg - normal * leg.dot(normal)).filter(|_| is_still)?;
        let y = normal.cross(x);
        // How the leg turns along the edge, and its second derivative.
        let [turn, second] = [1, 2].map(|k| derivatives.get(k, 1) * across);
        let (p, q) = (turn.dot(x), turn.dot(y));
        let (r, s) = (second.dot(x), second.dot(y));
        if q.abs() * along <= VANISHING_RELATIVE.sqrt() * length {
            return None;
        }
        let bends = [0, 1, 2].map(|k| normal.dot(derivatives.get(k, 2)));
        let a = bends[0] / (length * length);
        let b = (0.5 * bends[1] / length - p * a) / q;
        let c = (0.5 * bends[2] - p * p * a - 2.0 * p * q * b - length * (r * a + s * b)) / (q * q);
        let extent = length * step;
        let rounding = VANISHING_RELATIVE * coordinates / extent / extent;
        let tensor = [a, b, c];
        let shape = SurfaceShape { point, normal, axes: [x, y], tensor, extent, rounding };
        tensor.iter().all(|entry| entry.is_finite()).then_some(shape)
    }

    /// Whether the surface leaves this place of the edge as the shape says.
    fn agrees_with(&self, shape: &SurfaceShape) -> bool {
        let Self(derivatives) = self;
        let (leg, bend) = (derivatives.get(0, 1), derivatives.get(0, 2));
        let length = norm(leg);
        let [x, y] = shape.axes.map(|axis| leg.dot(axis) / length);
        let [a, b, c] = shape.tensor;
        let expected = a * x * x + 2.0 * b * x * y + c * y * y;
        let found = shape.normal.dot(bend) / length / length;
        let size = a.abs().max(b.abs()).max(c.abs()).max(1.0 / shape.extent);
        leg.dot(shape.normal).abs() <= NORMAL_AGREEMENT * length
            && (found - expected).abs() <= NORMAL_AGREEMENT * size
            && derivatives.get(0, 0).distance(shape.point)
                <= VANISHING_RELATIVE * (shape.point.abs().max_element() + shape.extent)
    }
}
