//! Plane regions whose borders depend on variables: their areas, moments and lengths, and what they make where
//! they are moved or turned.
//!
//! What a region holds grows by what its border sweeps: the integral of a density f over it by the integral of
//! f·(v × C')·n along the borders, with the speed v of their points. Reynolds' transport theorem.

use std::sync::Arc;

use glam::{DVec3, DVec4};

use super::{CurvePoint, VariedCurve};
use crate::{
    GeomError, Interval, LocalError, PictureError, Region,
    numeric::{
        gauss_legendre::{SIXTEEN_NODES, nodes},
        integral::find_integral,
        integral_error::IntegralError,
    },
    tolerance::{GRADIENT_RELATIVE, KNOT_RELATIVE},
};

/// A region, with the curves along its borders that vary.
///
/// A disc grows by its circumference with its radius:
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{CircleForm, Frame, NurbsCurve, PointSlopes, Region, Tolerance, VariedCurve, VariedRegion};
///
/// let circle = NurbsCurve::ellipse(Frame::XY, [2.0, 2.0], CircleForm::NinePoint)?;
/// let region = Region::new(&circle, &[], Tolerance::DEFAULT)?;
/// let outward = circle.control_points().iter().map(|p| (p.truncate() / 2.0).extend(0.0)).collect();
/// let slopes = PointSlopes::new(1, 9, vec![(0, outward)])?;
/// let border = VariedCurve::new(circle.into(), slopes)?;
/// let varied = VariedRegion::new(Arc::new(region), vec![vec![border]])?;
/// assert!((varied.area_slopes()?[0] - 4.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct VariedRegion {
    region: Arc<Region>,
    borders: Vec<VariedBorder>,
    n_variables: usize,
}

/// Curves around a border.
#[derive(Clone, Debug, PartialEq)]
struct VariedBorder {
    curves: Vec<VariedCurve>,
    /// 1 where the region is to their left, −1 where it is to their right.
    sense: f64,
}

/// How an integral along a curve grows with its point and with its derivative.
type CurvePartials = [DVec3; 2];

impl VariedRegion {
    /// A region with the curves along its borders in order, the outer border first.
    ///
    /// # Errors
    /// [`PictureError::NoArea`] for a border that goes around nothing.
    pub fn new(region: Arc<Region>, borders: Vec<Vec<VariedCurve>>) -> Result<Self, GeomError> {
        let of = borders.len();
        let curves = || borders.iter().flatten();
        let n_variables = curves().map(|curve| curve.slopes().n_variables()).max().unwrap_or(0);
        let (normal, about) = (region.frame().to_space().matrix3.z_axis, region.bounds().center());
        let border = |(index, curves): (usize, Vec<VariedCurve>)| {
            let area: f64 = curves.iter().map(|curve| double_area(curve, normal, about)).sum();
            let sense = if index == 0 { area.signum() } else { -area.signum() };
            match 0.0 < area.abs() {
                true => Ok(VariedBorder { curves, sense }),
                false => Err(PictureError::NoArea { index, of }.into()),
            }
        };
        let borders: Result<_, GeomError> = borders.into_iter().enumerate().map(border).collect();
        Ok(Self { region, borders: borders?, n_variables })
    }

    /// The region itself.
    #[must_use]
    pub fn region(&self) -> &Arc<Region> {
        &self.region
    }

    /// How many variables there are.
    #[must_use]
    pub fn n_variables(&self) -> usize {
        self.n_variables
    }

    /// The curves along each border, the outer one first, and whether they run backwards, with the region to their
    /// right.
    pub fn borders(&self) -> impl ExactSizeIterator<Item = (&[VariedCurve], bool)> {
        self.borders.iter().map(|border| (&border.curves[..], border.sense < 0.0))
    }

    /// The normal of its plane.
    #[must_use]
    pub fn normal(&self) -> DVec3 {
        self.region.frame().to_space().matrix3.z_axis
    }

    /// Whether its borders move out of its plane, beyond rounding.
    pub(super) fn leaves_its_plane(&self) -> bool {
        let ways = || {
            self.borders.iter().flat_map(|border| &border.curves).flat_map(|curve| {
                let points = curve.curve().control_points();
                curve.slopes().by_variable().iter().flat_map(move |(_, slopes)| {
                    let way = |(slope, point): (&DVec4, &DVec4)| {
                        slope.truncate() - point.truncate() * (slope.w / point.w)
                    };
                    slopes.iter().zip(points).map(way)
                })
            })
        };
        let longest = ways().map(DVec3::length).fold(0.0, f64::max);
        ways().any(|way| KNOT_RELATIVE * longest < way.dot(self.normal()).abs())
    }

    /// The slopes of the area.
    ///
    /// # Errors
    /// Where the work is ended.
    pub fn area_slopes(&self) -> Result<Vec<f64>, GeomError> {
        self.flux_slopes(self.normal())
    }

    /// The slopes of the area as a vector along its normal, by a direction: of what is seen of it from there.
    ///
    /// # Errors
    /// Where the work is ended.
    pub fn flux_slopes(&self, along: DVec3) -> Result<Vec<f64>, GeomError> {
        self.along_borders("the area", |_, tangent| Some([tangent.cross(along), DVec3::ZERO]))
    }

    /// The slopes of the integral of a density over it.
    ///
    /// # Errors
    /// Where the work is ended, and where the density cannot be integrated.
    pub fn moment_slopes(&self, density: impl Fn(DVec3) -> f64) -> Result<Vec<f64>, GeomError> {
        let normal = self.normal();
        self.along_borders("the moment", |point, tangent| {
            Some([tangent.cross(normal) * density(point), DVec3::ZERO])
        })
    }

    /// The slopes of its centre of gravity along a direction.
    ///
    /// Where its plane moves, as the borders tell: z over the plane is even there, and its integral half of
    /// that of z·(C − centre) through the border.
    ///
    /// # Errors
    /// Where the work is ended.
    pub fn centroid_slopes(&self, along: DVec3) -> Result<Vec<f64>, GeomError> {
        let (mass, normal) = (self.region.mass(), self.normal());
        self.along_borders("the centroid", |point, tangent| {
            let (arm, outward) = (point - mass.centroid, tangent.cross(normal));
            let rise = normal * (0.5 * along.dot(normal) * arm.dot(outward));
            Some([(outward * arm.dot(along) + rise) / mass.amount, DVec3::ZERO])
        })
    }

    /// The slopes of the integral of (S − C)·D (S − C)·E over it, its centre of gravity C.
    ///
    /// Where its plane moves, that of (S − C)·D times an even z is a quarter of that of their product with (S − C)
    /// through the border.
    ///
    /// # Errors
    /// Where the work is ended.
    pub fn second_moment_slopes(&self, [d, e]: [DVec3; 2]) -> Result<Vec<f64>, GeomError> {
        let (center, normal) = (self.region.mass().centroid, self.normal());
        self.along_borders("the inertia", |point, tangent| {
            let (arm, outward) = (point - center, tangent.cross(normal));
            let beside = d.dot(normal) * arm.dot(e) + e.dot(normal) * arm.dot(d);
            let rise = normal * (0.25 * beside * arm.dot(outward));
            Some([outward * (arm.dot(d) * arm.dot(e)) + rise, DVec3::ZERO])
        })
    }

    /// The slopes of the length of all borders.
    ///
    /// # Errors
    /// [`LocalError::NotDifferentiable`] where a border stands still.
    pub fn length_slopes(&self) -> Result<Vec<f64>, GeomError> {
        let mut all = vec![0.0; self.n_variables];
        for curve in self.borders.iter().flat_map(|border| &border.curves) {
            let length = curve.length(curve.curve().domain())?;
            all.iter_mut().zip(length.slopes()).for_each(|(sum, slope)| *sum += slope);
        }
        Ok(all)
    }

    /// The area that its borders pass on their way along a vector.
    pub(super) fn side_slopes(&self, way: DVec3) -> Result<Vec<f64>, GeomError> {
        let mut all = vec![0.0; self.n_variables];
        let partials =
            |_, tangent: DVec3| Some([DVec3::ZERO, way.cross(tangent.cross(way).try_normalize()?)]);
        for curve in self.borders.iter().flat_map(|border| &border.curves) {
            let slopes = curve.integral_slopes("the area", &partials)?;
            all.iter_mut().zip(slopes).for_each(|(sum, slope)| *sum += slope);
        }
        Ok(all)
    }

    /// The slopes of the integral of a density, and of its value at each place and its gradient, along all borders.
    pub(super) fn border_slopes(
        &self,
        what: &'static str,
        density: impl Fn(DVec3) -> (f64, DVec3),
    ) -> Result<Vec<f64>, GeomError> {
        let mut all = vec![0.0; self.n_variables];
        let partials = |point: DVec3, tangent: DVec3| {
            let (value, gradient) = density(point);
            Some([gradient * tangent.length(), tangent.try_normalize()? * value])
        };
        for curve in self.borders.iter().flat_map(|border| &border.curves) {
            let slopes = curve.integral_slopes(what, &partials)?;
            all.iter_mut().zip(slopes).for_each(|(sum, slope)| *sum += slope);
        }
        Ok(all)
    }

    /// The integral of a density along all borders.
    pub(super) fn border_integral(
        &self,
        what: &'static str,
        density: impl Fn(DVec3) -> f64,
    ) -> Result<f64, GeomError> {
        let mut sum = 0.0;
        for curve in self.borders.iter().flat_map(|border| &border.curves) {
            let curve = curve.curve();
            let along = |t: f64| {
                let found = curve.derivatives_at(t, 1);
                Ok::<_, GeomError>(vec![density(found[0]) * found[1].length()])
            };
            for span in curve.knots().spans() {
                let found = integral(what, along, curve.knots().span_interval(span))?;
                sum += found.first().copied().unwrap_or_default();
            }
        }
        Ok(sum)
    }

    /// How that area grows with the vector.
    pub(super) fn side_gradient(&self, way: DVec3) -> Result<DVec3, GeomError> {
        let mut sum = DVec3::ZERO;
        for curve in self.borders.iter().flat_map(|border| &border.curves) {
            let curve = curve.curve();
            let growth = |t: f64| {
                let tangent = curve.derivatives_at(t, 1)[1];
                let across = tangent.cross(way).normalize_or_zero();
                Ok::<_, GeomError>(across.cross(tangent).to_array().to_vec())
            };
            for span in curve.knots().spans() {
                let piece = curve.knots().span_interval(span);
                let found = integral("the area", growth, piece)?;
                sum += DVec3::from_slice(&found);
            }
        }
        Ok(sum)
    }

    /// The slopes of the sum over all borders, with the region to their left, of an integral by the parameter
    /// that does not depend on which one it is. `partials` tells how the integrand grows with the point and with the
    /// derivative, at these; none where it has no slopes.
    fn along_borders(
        &self,
        what: &'static str,
        partials: impl Fn(DVec3, DVec3) -> Option<CurvePartials>,
    ) -> Result<Vec<f64>, GeomError> {
        let mut all = vec![0.0; self.n_variables];
        for border in &self.borders {
            for curve in &border.curves {
                let slopes = curve.integral_slopes(what, &partials)?;
                all.iter_mut().zip(slopes).for_each(|(sum, slope)| *sum += border.sense * slope);
            }
        }
        Ok(all)
    }
}

/// Twice the area to the left of the way from a point along a curve and back.
fn double_area(curve: &VariedCurve, normal: DVec3, about: DVec3) -> f64 {
    let knots = curve.curve().knots();
    let swept = |t: f64| {
        let derivatives = curve.curve().derivatives_at(t, 1);
        (derivatives[0] - about).cross(derivatives[1]).dot(normal)
    };
    let pieces = knots.spans().map(|span| knots.span_interval(span));
    let of_piece =
        |piece| nodes(&SIXTEEN_NODES, piece).map(|(t, weight)| weight * swept(t)).sum::<f64>();
    pieces.map(|piece| piece.length() * of_piece(piece)).sum()
}

/// An integral over a piece of a curve.
fn integral(
    what: &'static str,
    density: impl FnMut(f64) -> Result<Vec<f64>, GeomError>,
    piece: Interval,
) -> Result<Vec<f64>, GeomError> {
    let found = find_integral(density, [piece.start(), piece.end()], GRADIENT_RELATIVE, 0.0);
    found.map(|found| found.value).map_err(|error| match error {
        IntegralError::Function(error) => error,
        IntegralError::Unsettled { at, .. } => LocalError::NotDifferentiable { what, at }.into(),
    })
}

impl VariedCurve {
    /// The slopes of an integral along the curve by its parameter.
    pub(super) fn integral_slopes(
        &self,
        what: &'static str,
        partials: &impl Fn(DVec3, DVec3) -> Option<CurvePartials>,
    ) -> Result<Vec<f64>, GeomError> {
        if self.slopes().is_fixed() {
            return Ok(vec![0.0; self.slopes().n_variables()]);
        }
        let curve = self.curve();
        let mut gradient = vec![DVec4::ZERO; curve.control_points().len()];
        for span in curve.knots().spans() {
            GeomError::go_on(1)?;
            let density = |t: f64| {
                let found = self.density(span, t, partials);
                found.ok_or(GeomError::Local(LocalError::NotDifferentiable { what, at: t }))
            };
            let found = integral(what, density, curve.knots().span_interval(span))?;
            let parts = found.chunks_exact(4);
            for (sum, part) in gradient[curve.knots().support(span)].iter_mut().zip(parts) {
                *sum += DVec4::from_slice(part);
            }
        }
        Ok(self.slopes().through(&gradient))
    }

    /// The gradient of an integrand by the control points that act on a span, one behind the other.
    fn density(
        &self,
        span: usize,
        t: f64,
        partials: impl Fn(DVec3, DVec3) -> Option<CurvePartials>,
    ) -> Option<Vec<f64>> {
        let knots = self.curve().knots();
        let points = &self.curve().control_points()[knots.support(span)];
        knots.with_slopes(span, t, |values, slopes| {
            let CurvePoint { value, along, place, velocity } =
                CurvePoint::new(points, values, slopes);
            let [by_place, by_velocity] = partials(place, velocity)?;
            let mut gradient = Vec::with_capacity(4 * values.len());
            for (&n, &dn) in values.iter().zip(slopes) {
                // Of a control point (A, ω): dC = N·(A − ω·C)/w, dC' = (N' − N·w'/w)·(A − ω·C)/w − ω·N·C'/w.
                let slope = (dn - n * along.w / value.w) / value.w;
                let by_point = by_place * (n / value.w) + by_velocity * slope;
                let by_weight = -place.dot(by_point) - n / value.w * by_velocity.dot(velocity);
                gradient.extend(by_point.extend(by_weight).to_array());
            }
            Some(gradient)
        })
    }
}
