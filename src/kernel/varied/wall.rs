//! Walls of solids that vary: each with plane ends, or closed by itself.
//!
//! A wall and fans over its rims, from a point in the plane of each, go around what it encloses, however the rims run.
//! What a solid of several walls holds is what its outer one encloses less what those of its holes do, and so are its
//! moments: sums of fluxes, which tell nothing of how the fans lie in the ends.

use std::sync::Arc;

use glam::{DVec3, DVec4};

use super::{PointSlopes, SurfaceIntegral, VariedCurve, VariedSurface};
use crate::{
    GeomError, Grid, KnotVector, LocalError, NurbsCurve, NurbsSurface, Surface,
    homogeneous::{place, place_speed},
    numeric::gauss_legendre::{EIGHT_NODES, nodes},
    tolerance::ACCURACY_WORTH_TELLING,
};

/// A wall of a solid around the outside or around a hole: a surface that closes along u, and the planes in which it
/// ends along v.
///
/// A tube of radius 1 and height 3 encloses 3π, which grow by 6π with its radius:
///
/// ```
/// use std::{f64::consts::PI, sync::Arc};
/// use virote_kernel::{Frame, NurbsSurface, PointSlopes, Solid, Face, Tolerance, VariedSolid, VariedSurface, VariedWall};
///
/// let tube = Arc::new(NurbsSurface::cone(Frame::XY, [1.0, 1.0], 3.0)?);
/// let solid = Solid::capped(&[Face::whole(Arc::clone(&tube), Tolerance::DEFAULT)?], Tolerance::DEFAULT)?;
/// let outward: Vec<_> = tube.control_points().as_slice().iter().map(|p| p.truncate().with_z(0.0).extend(0.0)).collect();
/// let slopes = PointSlopes::new(1, outward.len(), vec![(0, outward)])?;
/// let wall = VariedWall::new(VariedSurface::new(tube, slopes)?, false, false)?;
/// let varied = VariedSolid::between(Arc::new(solid), vec![wall], 1);
/// assert!((varied.volume_slopes()?[0] - 6.0 * PI).abs() < 1e-12);
/// assert!((varied.area_slopes()?[0] - 10.0 * PI).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct VariedWall {
    side: VariedSurface,
    /// Where v begins and where it ends; none of a wall that closes.
    ends: Vec<WallEnd>,
    /// The point from which fluxes are told.
    about: DVec3,
    /// The sign of its fluxes, by which they count as much as the solid holds.
    sense: f64,
    /// −1 around a hole, else 1.
    share: f64,
}

/// A plane end of a wall.
#[derive(Clone, Debug)]
struct WallEnd {
    rim: VariedCurve,
    fan: VariedSurface,
    /// What lies within the rim, as a vector.
    area: DVec3,
    /// The sign of its fluxes beside those of the wall.
    sense: f64,
}

impl VariedWall {
    /// The wall that a surface is, around a hole or the outside; it closes along v too, or ends in planes.
    ///
    /// # Errors
    /// Those of [`NurbsSurface::new`], for weights that vanish.
    pub fn new(side: VariedSurface, is_hole: bool, is_closed: bool) -> Result<Self, GeomError> {
        let domain = side.surface().domain_v();
        let ends = [(domain.start(), 1.0), (domain.end(), -1.0)];
        let ends = ends.into_iter().take(if is_closed { 0 } else { 2 });
        let ends = ends.map(|(v, sense)| WallEnd::new(&side, v, sense));
        let ends: Vec<WallEnd> = ends.collect::<Result<_, GeomError>>()?;
        let about = side.surface().point_at(side.surface().domain_u().start(), domain.start());
        let of_ends = ends.iter().map(|end| end.sense * flux(end.fan.surface(), about));
        let whole = flux(side.surface(), about) + of_ends.sum::<f64>();
        let share = if is_hole { -1.0 } else { 1.0 };
        Ok(Self { side, ends, about, sense: share * whole.signum(), share })
    }

    /// What the wall adds to the slopes of the volume.
    pub(super) fn volume_slopes(&self) -> Result<Vec<f64>, GeomError> {
        self.fluxes("the volume", |surface| surface.volume_slopes(self.about))
    }

    /// What it adds to those of the integral of (x − C)·D, a point C held.
    pub(super) fn moment_slopes(&self, center: DVec3, along: DVec3) -> Result<Vec<f64>, GeomError> {
        self.fluxes("the centroid", |surface| {
            surface.volume_moment_slopes(self.about, center, along)
        })
    }

    /// What it adds to those of the integral of (x − C)·D (x − C)·E, a point C held.
    pub(super) fn second_moment_slopes(
        &self,
        center: DVec3,
        along: [DVec3; 2],
    ) -> Result<Vec<f64>, GeomError> {
        self.fluxes("the inertia", |surface| {
            surface.volume_second_moment_slopes([self.about, center], along)
        })
    }

    /// What it adds to those of the area, its ends as far as they are its own.
    pub(super) fn area_slopes(&self) -> Result<Vec<f64>, GeomError> {
        let mut all = known("the area", self.side.area_slopes()?)?;
        for end in &self.ends {
            let normal = end.area.normalize_or_zero();
            let partials = |_, tangent: DVec3| Some([tangent.cross(normal), DVec3::ZERO]);
            let own = end.rim.integral_slopes("the area", &partials)?;
            all.iter_mut().zip(own).for_each(|(sum, slope)| *sum += self.share * slope);
        }
        Ok(all)
    }

    /// The area that it has, and that its ends add or take away.
    pub(super) fn area(&self) -> Result<f64, GeomError> {
        let (area, _) = Surface::Nurbs(Arc::clone(self.side.surface())).area()?;
        let of_ends: f64 = self.ends.iter().map(|end| end.area.length()).sum();
        Ok(area + self.share * of_ends)
    }

    /// The area of its least end.
    pub(super) fn least_end(&self) -> f64 {
        self.ends.iter().map(|end| end.area.length()).fold(f64::INFINITY, f64::min)
    }

    /// The slopes of the sum of a flux through the wall and its ends.
    fn fluxes(
        &self,
        what: &'static str,
        of: impl Fn(&VariedSurface) -> Result<SurfaceIntegral, GeomError>,
    ) -> Result<Vec<f64>, GeomError> {
        let fans = self.ends.iter().map(|end| (&end.fan, end.sense));
        let mut all = vec![0.0; self.side.slopes().n_variables()];
        for (surface, sense) in std::iter::once((&self.side, 1.0)).chain(fans) {
            let own = known(what, of(surface)?)?;
            all.iter_mut().zip(own).for_each(|(sum, slope)| *sum += self.sense * sense * slope);
        }
        Ok(all)
    }
}

impl WallEnd {
    /// Where v has a value; `sense` is that of the fan's fluxes.
    fn new(side: &VariedSurface, v: f64, sense: f64) -> Result<Self, GeomError> {
        let rim = rim(side, v)?;
        let fan = fan(&rim)?;
        let area = by_cells(fan.surface(), |[_, u, v]| v.cross(u));
        Ok(Self { rim, fan, area, sense })
    }
}

/// The isocurve of a surface along u, with its slopes.
fn rim(side: &VariedSurface, v: f64) -> Result<VariedCurve, GeomError> {
    let net = side.surface().control_points();
    side.surface().knots_v().with_basis(v, |span, values| {
        let first = span + 1 - values.len();
        let on_line = |line: &[DVec4]| -> DVec4 {
            line[first..].iter().zip(values).map(|(&point, &n)| point * n).sum()
        };
        let of = |points: &[DVec4]| {
            points.chunks_exact(net.n_columns()).map(on_line).collect::<Vec<_>>()
        };
        let curve = NurbsCurve::new(side.surface().knots_u().clone(), of(net.as_slice()))?;
        let slopes = side.slopes().by_variable();
        let slopes = slopes.iter().map(|(variable, own)| (*variable, of(own))).collect();
        let slopes = PointSlopes::new(side.slopes().n_variables(), net.n_rows(), slopes)?;
        VariedCurve::new(curve.into(), slopes)
    })
}

/// The straight lines to the points of a curve in a plane from a point that stays in it: the mean of its control points.
fn fan(rim: &VariedCurve) -> Result<VariedSurface, GeomError> {
    let points = rim.curve().control_points();
    let n = points.len() as f64;
    let center = points.iter().map(|&point| place(point)).sum::<DVec3>() / n;
    let net = points.iter().flat_map(|&point| [(center * point.w).extend(point.w), point]);
    let net = Grid::new(points.len(), 2, net.collect())?;
    let lines = KnotVector::new(1, vec![0.0, 0.0, 1.0, 1.0])?;
    let surface = NurbsSurface::new(rim.curve().knots().clone(), lines, net)?;
    let moving = |(variable, slopes): &(usize, Vec<DVec4>)| {
        let pairs = || points.iter().zip(slopes);
        let speed = pairs().map(|(&point, &slope)| place_speed(point, slope)).sum::<DVec3>() / n;
        let both = |(point, slope): (&DVec4, &DVec4)| {
            [(speed * point.w + center * slope.w).extend(slope.w), *slope]
        };
        (*variable, pairs().flat_map(both).collect())
    };
    let slopes = rim.slopes().by_variable().iter().map(moving).collect();
    let slopes = PointSlopes::new(rim.slopes().n_variables(), 2 * points.len(), slopes)?;
    VariedSurface::new(surface.into(), slopes)
}

/// Three times the volume between a surface and a point, as near as a rule for each patch tells it.
fn flux(surface: &NurbsSurface, about: DVec3) -> f64 {
    by_cells(surface, |[point, u, v]| DVec3::X * (point - about).dot(u.cross(v))).x
}

/// The integral of what `density` makes of S, Su and Sv, by the rule of Gauss and Legendre on each patch.
fn by_cells(surface: &NurbsSurface, density: impl Fn([DVec3; 3]) -> DVec3) -> DVec3 {
    let (knots_u, knots_v) = (surface.knots_u(), surface.knots_v());
    let mut sum = DVec3::ZERO;
    for side_u in knots_u.spans().map(|span| knots_u.span_interval(span)) {
        for side_v in knots_v.spans().map(|span| knots_v.span_interval(span)) {
            let area = side_u.length() * side_v.length();
            for (u, weight_u) in nodes(&EIGHT_NODES, side_u) {
                for (v, weight_v) in nodes(&EIGHT_NODES, side_v) {
                    let d = surface.derivatives_at(u, v, 1);
                    let own = density([d.get(0, 0), d.get(1, 0), d.get(0, 1)]);
                    sum += own * (area * weight_u * weight_v);
                }
            }
        }
    }
    sum
}

/// Slopes that are known to as many digits as are worth having.
fn known(what: &'static str, found: SurfaceIntegral) -> Result<Vec<f64>, GeomError> {
    match found.relative_error <= ACCURACY_WORTH_TELLING {
        true => Ok(found.slopes),
        false => Err(LocalError::NotDifferentiable { what, at: found.relative_error }.into()),
    }
}
