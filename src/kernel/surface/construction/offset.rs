//! The surface at a distance beside another one.

mod fit;
mod turn;

use glam::DVec3;

use crate::{
    Bounds, ConstructionError, GeomError, Grid, Interpolator, KnotVector,
    surface::{Direction, NurbsSurface, Surface},
    tolerance::{EXACT_RELATIVE, LAST_BIT},
};

use fit::{SpanLayout, SurfaceOffsetTarget, tensor};
pub use turn::FocalPoint;

/// Last bits of a coordinate that a point of the offset may be off.
const MOST_ROUNDINGS: f64 = 64.0;

/// An offset surface, and what is to be known about it.
///
/// Beside a sphere run spheres, on the same control points:
///
/// ```
/// use virote_kernel::{Frame, NurbsSurface, Surface};
///
/// let sphere = Surface::from(NurbsSurface::sphere(Frame::XY, 1.0)?);
/// let found = sphere.offset(0.5, 1e-6)?;
/// assert!(found.is_exact);
/// assert!((found.surface.point_at(0.3, 0.7).length() - 1.5).abs() < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceOffset {
    /// The surface.
    pub surface: NurbsSurface,
    /// Whether it has the degrees, knots and weights of the original and is exact up to rounding.
    pub is_exact: bool,
    /// The largest distance from the true offset that was measured, at equal parameters.
    pub deviation: f64,
    /// The mean of all that were.
    pub mean: f64,
    /// Where that is.
    pub at: [f64; 2],
    /// The tightest bend towards the offset, if the distance is beyond its radius.
    pub turn: Option<FocalPoint>,
}

impl Surface {
    /// The surface of the points S + d·N, on the same parameters.
    ///
    /// First a surface on the basis of the original is tried, weights and all, which is exact for
    /// planes, spheres, cylinders, cones, tori and whatever else has a normal of that form. Others
    /// are quintic splines through points of the true offset, with knots halved until the distance
    /// at equal parameters is below half of the tolerance at 16 places of every patch.
    /// Piegl & Tiller, *Computing offsets of NURBS curves and surfaces*, CAD 31 (1999).
    ///
    /// # Errors
    /// `LocalError::NoNormal` at a place without one, [`ConstructionError::Crease`] along a parameter
    /// line where the normal leaps, `FitError::NoSurfaceNear` where the pieces do not suffice;
    /// and as [`Self::point_at`].
    pub fn offset(&self, distance: f64, tolerance: f64) -> Result<SurfaceOffset, GeomError> {
        if let Self::Nurbs(surface) = self
            && distance.abs() <= 0.0
        {
            let at = [surface.domain_u().start(), surface.domain_v().start()];
            let surface = NurbsSurface::clone(surface);
            return Ok(SurfaceOffset {
                surface,
                is_exact: true,
                deviation: 0.0,
                mean: 0.0,
                at,
                turn: None,
            });
        }
        let size = self.magnitude()? + distance.abs();
        let tolerance = tolerance.max(MOST_ROUNDINGS * LAST_BIT * size);
        let aim = SurfaceOffsetTarget { surface: self, distance, tolerance };
        if let Self::Nurbs(surface) = self {
            check_creases(surface, aim)?;
        }
        let turn = turn::tightest(self, distance)?;
        let exact = match self {
            Self::Nurbs(surface) => exact(surface, aim, EXACT_RELATIVE * size)?,
            Self::Parametric(_) => None,
        };
        let is_exact = exact.is_some();
        let (surface, worst) = match exact {
            Some(found) => found,
            None => fit::fitted(aim)?,
        };
        let (deviation, mean, at) = (worst.distance, worst.mean(), worst.at);
        Ok(SurfaceOffset { surface, is_exact, deviation, mean, at, turn })
    }

    /// The largest coordinate, of control points or of some points.
    fn magnitude(&self) -> Result<f64, GeomError> {
        let points = match self {
            Self::Nurbs(surface) => surface.points(),
            Self::Parametric(_) => {
                self.points_on_grid(&self.domain_u().steps(8), &self.domain_v().steps(8))?
            }
        };
        Ok(Bounds::of(points.into_values()).map_or(0.0, Bounds::magnitude))
    }
}

/// The offset on the basis of the original, if it has that form: the one that agrees at as many
/// places as there are control points is compared at others.
fn exact(
    surface: &NurbsSurface,
    aim: SurfaceOffsetTarget<'_>,
    accuracy: f64,
) -> Result<Option<(NurbsSurface, fit::LargestDeviation)>, GeomError> {
    let clamped = surface.clamped(Direction::U).clamped(Direction::V);
    let knots = Direction::BOTH.map(|along| clamped.knots(along).clone());
    let is_broken = |knots: &KnotVector| {
        let distinct = knots.distinct();
        let inner = &distinct[1..distinct.len() - 1];
        knots.degree() == 0 || inner.iter().any(|&(_, times)| knots.degree() < times)
    };
    if knots.iter().any(is_broken) {
        return Ok(None);
    }
    let [us, vs] = [&knots[0], &knots[1]].map(KnotVector::greville);
    let mut values = Vec::with_capacity(us.len() * vs.len());
    for &u in &us {
        for &v in &vs {
            let weight = clamped.homogeneous_at(u, v).w;
            values.push((aim.point(u, v)? * weight).extend(weight));
        }
    }
    let [knots_u, knots_v] = knots;
    let (Ok(along_u), Ok(along_v)) =
        (Interpolator::on_knots(&us, knots_u), Interpolator::on_knots(&vs, knots_v))
    else {
        return Ok(None);
    };
    let net = tensor([&along_u, &along_v], &Grid::from_rows_of(vs.len(), values))?;
    let candidate = NurbsSurface::new(along_u.knots().clone(), along_v.knots().clone(), net);
    let Ok(candidate) = candidate else { return Ok(None) };
    let allowed = accuracy.min(aim.tolerance);
    let layout = SpanLayout::of(&candidate);
    let worst = layout.worst(&candidate, aim, Some(allowed))?;
    Ok((worst.distance <= allowed).then_some((candidate, worst)))
}

/// Places across a parameter line at which the normals of its two sides are compared.
const N_CREASE_SAMPLES: usize = 16;

/// # Errors
/// [`ConstructionError::Crease`] at a knot where the two sides' normals, or points, move the offset further
/// apart than the tolerance.
fn check_creases(surface: &NurbsSurface, aim: SurfaceOffsetTarget<'_>) -> Result<(), GeomError> {
    for along in Direction::BOTH {
        let (knots, domain) = (surface.knots(along), surface.domain(along));
        let is_rough = |&(t, times): &(f64, usize)| {
            knots.degree() <= times && domain.start() < t && t < domain.end()
        };
        for (t, _) in knots.distinct().into_iter().filter(is_rough) {
            let sides = surface.split(along, t)?;
            for s in surface.domain(along.other()).steps(N_CREASE_SAMPLES) {
                let (u, v) = match along {
                    Direction::U => (t, s),
                    Direction::V => (s, t),
                };
                let [a, b] = [&sides[0], &sides[1]].map(|side| offset_point(side, aim, u, v));
                // A place without a normal is told where it matters.
                let (Ok(a), Ok(b)) = (a, b) else { continue };
                let gap = a.distance(b);
                if aim.tolerance < gap {
                    let name = along.name();
                    return Err(ConstructionError::Crease { along: name, parameter: t, gap }.into());
                }
            }
        }
    }
    Ok(())
}

fn offset_point(
    surface: &NurbsSurface,
    aim: SurfaceOffsetTarget<'_>,
    u: f64,
    v: f64,
) -> Result<DVec3, GeomError> {
    Ok(surface.point_at(u, v) + surface.normal_at(u, v)? * aim.distance)
}
