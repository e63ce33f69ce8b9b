//! Exact sums of surfaces that curves span: what Coons and Gordon surfaces are.

use glam::{DVec3, DVec4};

use crate::{
    CountError, GeomError, Grid, Interval, KnotVector, NurbsCurve, homogeneous,
    surface::{NurbsSurface, construction::revolve::check_size},
};

/// What a boolean sum takes along one of its directions.
#[derive(Clone, Debug)]
pub(crate) struct BooleanSumTerm {
    /// The curves that run along it; the first one's domain becomes the surface's.
    pub(crate) curves: Vec<NurbsCurve>,
    /// A function of its parameter for each curve of the other direction, which that curve is
    /// multiplied by: a curve without weights that has its values in x.
    pub(crate) blends: Vec<NurbsCurve>,
}

impl NurbsSurface {
    /// The surface Σ cₖ(u)·gₖ(v) + Σ fₗ(u)·dₗ(v) − Σ Pₗₖ·fₗ(u)·gₖ(v) of curves c along u, curves d
    /// along v, their blending functions g and f, and values P where they meet: row l, column k.
    ///
    /// The sum is that of points in space: curves of different weights are brought over one
    /// denominator first, a product W(u)·Z(v). Without weights the degrees are the highest among
    /// curves and functions, and the knots those of all.
    /// Piegl & Tiller, *The NURBS Book*, (10.28) to (10.36).
    ///
    /// # Errors
    /// `DegreeError::DegreeTooHigh`, where many different denominators multiply;
    /// [`CountError::TooManyPoints`], `InputError::NotFinite`,
    /// [`CountError::GridSize`] unless the numbers of curves, functions and values go together.
    pub(crate) fn boolean_sum(
        u: BooleanSumTerm,
        v: BooleanSumTerm,
        meetings: &Grid<DVec3>,
    ) -> Result<Self, GeomError> {
        let (rows, columns) = (v.curves.len(), u.curves.len());
        let counts = [u.blends.len(), v.blends.len()];
        if counts != [rows, columns] || [meetings.n_rows(), meetings.n_columns()] != counts {
            let got = meetings.as_slice().len();
            return Err(CountError::GridSize { rows, columns, needed: rows * columns, got }.into());
        }
        let (c, f, knots_u) = over_one_denominator(u)?;
        let (d, g, knots_v) = over_one_denominator(v)?;
        let (n, m) = (knots_u.n_points(), knots_v.n_points());
        check_size(n, m)?;
        // What curves along v have beyond the surface through their meetings.
        let gaps = Grid::from_fn(rows, m, |l, j| {
            let through = g.iter().enumerate().map(|(k, blend)| meetings.get(l, k) * blend[j].x);
            d[l][j].truncate() - through.sum::<DVec3>()
        });
        let net = Grid::from_fn(n, m, |i, j| {
            let mut point = DVec3::ZERO;
            for (along_u, blend) in c.iter().zip(&g) {
                point += along_u[i].truncate() * blend[j].x;
            }
            for (l, blend) in f.iter().enumerate() {
                point += gaps.get(l, j) * blend[i].x;
            }
            point.extend(c[0][i].w * d[0][j].w)
        });
        homogeneous::check_finite(net.as_slice())?;
        Ok(Self::new_unchecked(knots_u, knots_v, net))
    }
}

/// Homogeneous points of the curves and of the functions, over common knots and one denominator.
type CommonNets = (Vec<Vec<DVec4>>, Vec<Vec<DVec4>>, KnotVector);

fn over_one_denominator(strands: BooleanSumTerm) -> Result<CommonNets, GeomError> {
    let n_curves = strands.curves.len();
    let all = [strands.curves, strands.blends].concat();
    let common = crate::curve::on_one_denominator(&all)?;
    let knots = match common.first() {
        Some(curve) => curve.knots().clone(),
        None => return Err(CountError::TooFewCurves { got: 0, needed: 1 }.into()),
    };
    let mut points: Vec<Vec<DVec4>> =
        common.iter().map(|curve| curve.control_points().to_vec()).collect();
    let blends = points.split_off(n_curves);
    Ok((points, blends, knots))
}

/// The polynomial with these Bernstein coefficients on a domain, as a blending function.
///
/// # Errors
/// `InputError::NotFinite`, [`CountError::TooFewPoints`].
pub(crate) fn blend(coefficients: &[f64], domain: Interval) -> Result<NurbsCurve, GeomError> {
    let values: Vec<DVec3> = coefficients.iter().map(|&x| DVec3::new(x, 0.0, 0.0)).collect();
    NurbsCurve::bezier(&values).map(|blend| blend.reparametrized(domain))
}
