//! Surfaces within four boundary curves.

use glam::DVec3;

use crate::{
    GeomError, Grid, Interval, NurbsCurve,
    surface::{
        NurbsSurface,
        construction::sum::{BooleanSumTerm, blend},
    },
};

/// How a Coons surface goes from one boundary to the one opposite.
///
/// Between a level and a lifted side, halfway up both; a quarter of the way 1/4 by lines, and 3·(1/4)²
/// − 2·(1/4)³ by cubics:
///
/// ```
/// use virote_kernel::{Blend, NurbsCurve, NurbsSurface, glam::DVec3};
///
/// let [o, x, y] = [DVec3::ZERO, DVec3::X, DVec3::Y];
/// let low = NurbsCurve::bezier(&[o, x * 0.5, x])?;
/// let high = NurbsCurve::bezier(&[y, DVec3::new(0.5, 1.0, 2.0), x + y])?;
/// let [left, right] = [NurbsCurve::line(o, y)?, NurbsCurve::line(x, x + y)?];
/// let height = |across| NurbsSurface::coons([&low, &high], [&left, &right], across).map(|s| s.point_at(0.5, 0.25).z);
/// assert!((height(Blend::Linear)? - 0.25).abs() < 1e-14);
/// assert!((height(Blend::Cubic)? - 5.0 / 32.0).abs() < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Blend {
    /// Along straight lines.
    Linear,
    /// By the cubics that leave and arrive level, so that the derivative across a boundary depends
    /// on that boundary and the ends of its neighbours alone.
    Cubic,
}

/// The derivatives that a bicubically blended surface takes across its boundaries; of pairs the
/// first is at the lower end.
///
/// Around a square, with a slope that grows to 1 in the middle of the sides along u:
///
/// ```
/// use virote_kernel::{CrossFields, NurbsCurve, NurbsSurface, glam::DVec3};
///
/// let [o, x, y, z] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
/// let u = [NurbsCurve::line(o, x)?, NurbsCurve::line(y, x + y)?];
/// let v = [NurbsCurve::line(o, y)?, NurbsCurve::line(x, x + y)?];
/// let bump = NurbsCurve::bezier(&[y, y, y + z * 8.0 / 3.0, y, y])?;
/// let level = NurbsCurve::line(x, x)?;
/// let fields = CrossFields { cross_u: [bump.clone(), bump], cross_v: [level.clone(), level] };
/// let surface = NurbsSurface::coons_bicubic([&u[0], &u[1]], [&v[0], &v[1]], &fields)?;
/// let slope = surface.derivatives_at(0.5, 0.0, 1).get(0, 1);
/// assert!(slope.distance(DVec3::new(0.0, 1.0, 1.0)) < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct CrossFields {
    /// Sv along the u-curves, as curves of vectors.
    pub cross_u: [NurbsCurve; 2],
    /// Su along the v-curves.
    pub cross_v: [NurbsCurve; 2],
}

/// The two twists at a corner, which should be one.
///
/// ```
/// use virote_kernel::{Twists, glam::DVec3};
///
/// let unlike = Twists { corner: [0, 0], of_cross_u: DVec3::X, of_cross_v: DVec3::Y };
/// assert_eq!(unlike.mean(), DVec3::new(0.5, 0.5, 0.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twists {
    /// Which corner: 0 or 1 for the lower or upper end of u and of v.
    pub corner: [usize; 2],
    /// The derivative of `cross_u` there.
    pub of_cross_u: DVec3,
    /// The derivative of `cross_v` there.
    pub of_cross_v: DVec3,
}

impl Twists {
    /// The mean of both.
    #[must_use]
    pub fn mean(&self) -> DVec3 {
        self.of_cross_u.midpoint(self.of_cross_v)
    }
}

impl NurbsSurface {
    /// The Coons surface of two curves along u, at both ends of v, and two along v, at both ends
    /// of u; the domains are those of the first of each.
    ///
    /// Exact for rational boundaries too. A corner is the middle between the ends of its two
    /// curves, so that each boundary is met as far as these meet.
    /// Coons, *Surfaces for computer-aided design of space forms*, MIT 1967;
    /// Piegl & Tiller, *The NURBS Book*, (10.34) to (10.36).
    ///
    /// Between the sides of a square it is the square:
    ///
    /// ```
    /// use virote_kernel::{Blend, NurbsCurve, NurbsSurface, glam::DVec3};
    ///
    /// let line = |a, b| NurbsCurve::line(a, b);
    /// let [o, x, y] = [DVec3::ZERO, DVec3::X, DVec3::Y];
    /// let (u, v) = ([line(o, x)?, line(y, x + y)?], [line(o, y)?, line(x, x + y)?]);
    /// let square = NurbsSurface::coons([&u[0], &u[1]], [&v[0], &v[1]], Blend::Linear)?;
    /// assert!(square.point_at(0.25, 0.75).distance(DVec3::new(0.25, 0.75, 0.0)) < 1e-15);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// `DegreeError::DegreeTooHigh`, where different denominators multiply; those of
    /// [`crate::make_compatible`]; `InputError::NotFinite`.
    pub fn coons(
        u: [&NurbsCurve; 2],
        v: [&NurbsCurve; 2],
        across: Blend,
    ) -> Result<Self, GeomError> {
        let functions = |curve: &NurbsCurve| {
            let coefficients: [&[f64]; 2] = match across {
                Blend::Linear => [&[1.0, 0.0], &[0.0, 1.0]],
                Blend::Cubic => [&[1.0, 1.0, 0.0, 0.0], &[0.0, 0.0, 1.0, 1.0]],
            };
            coefficients.into_iter().map(|c| blend(c, curve.domain())).collect::<Result<_, _>>()
        };
        let strands = |curves: [&NurbsCurve; 2]| {
            Ok::<_, GeomError>(BooleanSumTerm {
                curves: curves.map(NurbsCurve::clone).to_vec(),
                blends: functions(curves[0])?,
            })
        };
        Self::boolean_sum(strands(u)?, strands(v)?, &corners(u, v))
    }

    /// The bicubically blended Coons surface, with these derivatives across its boundaries, which
    /// run over the same domains as these.
    ///
    /// That the ends of the fields agree with the derivatives of the boundaries, and the twists
    /// with one another, is presumed: [`CrossFields::with_mean_twists`].
    /// Piegl & Tiller, *The NURBS Book*, (10.37) to (10.43).
    ///
    /// # Errors
    /// Those of [`Self::coons`].
    pub fn coons_bicubic(
        u: [&NurbsCurve; 2],
        v: [&NurbsCurve; 2],
        fields: &CrossFields,
    ) -> Result<Self, GeomError> {
        let places = corners(u, v);
        let end = |i: usize, curve: &NurbsCurve| [curve.start(), curve.end()][i];
        let meetings = Grid::from_fn(4, 4, |l, k| match (l < 2, k < 2) {
            (true, true) => places.get(l, k),
            (true, false) => end(l, &fields.cross_u[k - 2]),
            (false, true) => end(k, &fields.cross_v[l - 2]),
            (false, false) => fields.twists([l - 2, k - 2]).mean(),
        });
        let strands = |curves: [&NurbsCurve; 2], across: &[NurbsCurve; 2]| {
            let domain = curves[0].domain();
            let third = domain.length() / 3.0;
            let hermite: [&[f64]; 4] = [
                &[1.0, 1.0, 0.0, 0.0],
                &[0.0, 0.0, 1.0, 1.0],
                &[0.0, third, 0.0, 0.0],
                &[0.0, 0.0, -third, 0.0],
            ];
            let blends = hermite.into_iter().map(|c| blend(c, domain));
            Ok::<_, GeomError>(BooleanSumTerm {
                curves: curves.into_iter().chain(across).cloned().collect(),
                blends: blends.collect::<Result<_, _>>()?,
            })
        };
        let (along_u, along_v) = (strands(u, &fields.cross_u)?, strands(v, &fields.cross_v)?);
        Self::boolean_sum(along_u, along_v, &meetings)
    }
}

impl CrossFields {
    /// The fields over the domains of a surface's boundaries, clamped.
    #[must_use]
    pub fn over(self, u: Interval, v: Interval) -> Self {
        let on = |domain: Interval| move |field: NurbsCurve| field.clamped().reparametrized(domain);
        Self { cross_u: self.cross_u.map(on(u)), cross_v: self.cross_v.map(on(v)) }
    }

    /// Both twists at a corner.
    #[must_use]
    pub fn twists(&self, corner: [usize; 2]) -> Twists {
        let [i, j] = corner;
        Twists {
            corner,
            of_cross_u: slope_at_end(&self.cross_u[j], i),
            of_cross_v: slope_at_end(&self.cross_v[i], j),
        }
    }

    /// The fields with the mean of both twists at each of these corners: the control point next to
    /// the end of either field is moved. Fields of fewer than four points are written with more
    /// first, so that their other end stays.
    ///
    /// Piegl & Tiller, *The NURBS Book*, end of §10.6.
    ///
    /// # Errors
    /// `DegreeError::DegreeTooHigh` never, with a degree of three.
    pub fn with_mean_twists(mut self, corners: &[[usize; 2]]) -> Result<Self, GeomError> {
        for &[i, j] in corners {
            let mean = self.twists([i, j]).mean();
            self.cross_u[j] = with_slope(&self.cross_u[j], i, mean)?;
            self.cross_v[i] = with_slope(&self.cross_v[i], j, mean)?;
        }
        Ok(self)
    }
}

/// The clamped curve with another derivative at an end, by its control point next to that.
fn with_slope(curve: &NurbsCurve, end: usize, slope: DVec3) -> Result<NurbsCurve, GeomError> {
    let curve = match curve.control_points().len() {
        0..4 => curve.elevate_degree(3)?,
        _ => curve.clone(),
    };
    let (p, mut points) = (curve.degree(), curve.control_points().to_vec());
    let (knots, n) = (curve.knots().as_slice(), points.len());
    // The derivative at an end is p/width · w₁/w₀ · (P₁ − P₀).
    let (at, next, width) = match end {
        0 => (0, 1, knots[p + 1] - knots[p]),
        _ => (n - 1, n - 2, knots[n] - knots[n - 1]),
    };
    let change = (slope - slope_at_end(&curve, end)) * if end == 0 { 1.0 } else { -1.0 };
    let step = change * (width / p as f64 * points[at].w);
    points[next] += step.extend(0.0);
    NurbsCurve::new(curve.knots().clone(), points)
}

/// The corners, row i at an end of u: each the middle between the ends of two curves.
fn corners(u: [&NurbsCurve; 2], v: [&NurbsCurve; 2]) -> Grid<DVec3> {
    let ends = |curve: &NurbsCurve| [curve.start(), curve.end()];
    let (along_u, along_v) = (u.map(ends), v.map(ends));
    Grid::from_fn(2, 2, |i, j| along_u[j][i].midpoint(along_v[i][j]))
}

/// The first derivative at the lower or upper end.
pub(crate) fn slope_at_end(curve: &NurbsCurve, end: usize) -> DVec3 {
    let domain = curve.domain();
    curve.derivatives_at([domain.start(), domain.end()][end], 1)[1]
}
