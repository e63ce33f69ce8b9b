//! Integrals over a surface, piece by piece, to nearly all digits.
//!
//! The tensor rule of Gauss and Legendre with 8 × 8 nodes is exact where the integrand is a
//! polynomial of degree 15 in each parameter, as it is for volumes of bicubic patches. Each cell
//! is compared with its halves along u and along v, and the cell that changes most is halved next,
//! along the parameter by which it changes more: towards a pole or an edge where the integrand is
//! not smooth the cells shrink in proportion. Along a straight and even way, as of an extrusion, quantities are
//! polynomials of degree 3 at most, for which Simpson's rule is exact.
//!
//! How far an integral may be off is told by its changes. Where these fade from one halving to the
//! next by a factor ρ, what is still to come is ρ/(1 − ρ) of the last one: little of a smooth
//! integrand, of which ρ is tiny, and many times as much where it grows beyond bounds.

use std::sync::Arc;

use glam::DVec3;

use super::quadrature_cell::{CellEstimate, IntegralCells, IntegratedCell, QuadratureCell};
use crate::{
    Direction, GeomError, Interval, NurbsSurface,
    ceiling::SURFACE_CUTS,
    numeric::gauss_legendre::{EIGHT_NODES, nodes},
    surface::{Surface, representation::even::evened},
    tolerance::{BESIDE_CREASE, FAR_SHARE, LAST_BIT},
};

/// Even parts of each domain of a function, which has no knots, that are looked at first.
const FUNCTION_PARTS: usize = 4;

/// Steps that a cell takes, of which each asks for some places.
const CELL_STEPS: usize = 64;

/// How an integral whose cuts run out changes within the last quarter of them is how far it may be
/// off at least: cells that are wider than what happens in them agree with their halves by chance.
const LATE_CUTS: usize = SURFACE_CUTS / 4;

/// What is integrated, at a place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Density<const N: usize> {
    pub(crate) values: [f64; N],
    /// What the values are made of, where that is larger than they are, so that they are known to its last bits at
    /// best; else nothing.
    pub(crate) parts: [f64; N],
}

impl<const N: usize> From<[f64; N]> for Density<N> {
    fn from(values: [f64; N]) -> Self {
        Self { values, parts: [0.0; N] }
    }
}

/// An integral of several quantities.
#[derive(Clone, Copy, Debug)]
pub(crate) struct IntegralValues<const N: usize> {
    pub(crate) values: [f64; N],
    /// How far each may be off.
    pub(crate) errors: [f64; N],
    /// The integrals of the absolute values, of each quantity that of the largest of its kind.
    pub(crate) sizes: [f64; N],
}

impl<const N: usize> IntegralValues<N> {
    /// What is known of the error, as a fraction of the sizes; the largest of all kinds.
    pub(crate) fn relative_error(&self) -> f64 {
        let error = |i: usize| self.errors[i] / self.sizes[i].max(f64::MIN_POSITIVE);
        (0..N).map(error).fold(LAST_BIT, f64::max)
    }
}

/// Parameters over which is integrated: a map from a rectangle, with what its area is multiplied by.
pub(crate) trait QuadratureMap {
    /// What places with one second parameter have in common.
    type Line;

    /// That of a second parameter.
    fn line_at(&self, second: f64) -> Self::Line;

    /// The point, Su × Sv and the factor of the area at a first parameter on a line.
    ///
    /// # Errors
    /// As [`Surface::point_at`].
    fn at(&self, first: f64, line: &Self::Line) -> Result<(DVec3, DVec3, f64), GeomError>;

    /// Rectangles in which all is smooth.
    fn cells(&self) -> [Vec<Interval>; 2];

    /// Along which directions points move evenly, and Su × Sv and the factor stay.
    fn even_ways(&self) -> [bool; 2];
}

impl QuadratureMap for Surface {
    type Line = f64;

    fn line_at(&self, v: f64) -> f64 {
        v
    }

    fn at(&self, u: f64, &v: &f64) -> Result<(DVec3, DVec3, f64), GeomError> {
        let found = match (self, self.tangents_at(u, v)) {
            // On a crease a function has no derivative; what is beside it counts.
            (Self::Parametric(_), Err(error)) => {
                let domain = self.domain_u();
                let step = BESIDE_CREASE * domain.length();
                let beside = if u + step < domain.end() { u + step } else { u - step };
                self.tangents_at(beside, v).map_err(|_| error)?
            }
            (_, found) => found?,
        };
        let [point, along_u, along_v] = found;
        Ok((point, along_u.cross(along_v), 1.0))
    }

    fn even_ways(&self) -> [bool; 2] {
        match self {
            Self::Nurbs(surface) => surface.even_ways(),
            Self::Parametric(_) => [false; 2],
        }
    }

    /// What the surface is made of, or for a function even parts.
    fn cells(&self) -> [Vec<Interval>; 2] {
        match self {
            Self::Nurbs(surface) => [surface.knots_u(), surface.knots_v()]
                .map(|knots| knots.spans().map(|span| knots.span_interval(span)).collect()),
            Self::Parametric(surface) => [surface.domain_u(), surface.domain_v()].map(|domain| {
                let ends = domain.steps(FUNCTION_PARTS);
                ends.windows(2).filter_map(|ends| Interval::new(ends[0], ends[1]).ok()).collect()
            }),
        }
    }
}

/// What several quantities are.
#[derive(Clone, Copy, Debug)]
pub(crate) struct QuantityKinds<const N: usize> {
    /// For each the number of its kind. Quantities of a kind are known as well as the largest of them: of the three
    /// moments of a plate, that across it may be nothing but rounding.
    pub(crate) numbers: [usize; N],
    /// Whether they are polynomials of degree 3 at most in the point, where Su × Sv and how far it lies along that stay.
    pub(crate) are_moments: bool,
}

/// One such polynomial.
pub(crate) const ONE_MOMENT: QuantityKinds<1> = QuantityKinds { numbers: [0], are_moments: true };

/// One quantity of any sort.
pub(crate) const ONE_QUANTITY: QuantityKinds<1> =
    QuantityKinds { numbers: [0], are_moments: false };

/// The integral over du·dv of quantities that depend on a point and on Su × Sv.
///
/// # Errors
/// As [`Surface::check_function`].
pub(crate) fn integral<const N: usize, D: Into<Density<N>>>(
    surface: &Surface,
    kinds: QuantityKinds<N>,
    density: impl Fn(DVec3, DVec3) -> D,
) -> Result<IntegralValues<N>, GeomError> {
    surface.check_function()?;
    let far = match surface {
        Surface::Nurbs(surface) => far_share(surface),
        Surface::Parametric(_) => 0.0,
    };
    integral_over(&parts(surface), far, kinds, density)
}

/// Sizes of a surface that its coordinates are, where they are many: by so much more rounding moves what depends on
/// its shape, and no division into parts takes that away.
pub(crate) fn far_share(surface: &NurbsSurface) -> f64 {
    let bounds = surface.bounds();
    let share = bounds.magnitude() / bounds.diagonal();
    if FAR_SHARE < share && share.is_finite() { share } else { 0.0 }
}

/// The integral over all of some maps, of surfaces that are `far` of their sizes from the origin.
///
/// # Errors
/// As [`QuadratureMap::at`].
pub(crate) fn integral_over<const N: usize, M: QuadratureMap, D: Into<Density<N>>>(
    parts: &[M],
    far: f64,
    kinds: QuantityKinds<N>,
    density: impl Fn(DVec3, DVec3) -> D,
) -> Result<IntegralValues<N>, GeomError> {
    let of_map = |map: &M| if kinds.are_moments { map.even_ways() } else { [false; 2] };
    let ways: Vec<[bool; 2]> = parts.iter().map(of_map).collect();
    let rule = |cell: QuadratureCell| {
        quadrature((&parts[cell.part], ways[cell.part]), far, cell, &density)
    };
    let known =
        |cell: QuadratureCell, whole: CellEstimate<N>| -> Result<IntegratedCell<N>, GeomError> {
            GeomError::go_on(CELL_STEPS)?;
            let pair = |direction: Direction| -> Result<Option<[CellEstimate<N>; 2]>, GeomError> {
                if ways[cell.part][direction] {
                    return Ok(None);
                }
                let [a, b] = cell.halves(direction);
                Ok(Some([rule(a)?, rule(b)?]))
            };
            Ok(IntegratedCell::new(cell, whole, [pair(Direction::U)?, pair(Direction::V)?]))
        };
    let mut first = Vec::new();
    for cell in parts.iter().enumerate().flat_map(|(part, map)| cells(part, map)) {
        first.push(known(cell, rule(cell)?)?);
    }
    let (mut all, mut late) = (IntegralCells::new(first, kinds.numbers), None);
    for n_left in (0..SURFACE_CUTS).rev() {
        if all.is_beyond_numbers() {
            let nowhere = [f64::INFINITY; N];
            return Ok(IntegralValues { values: [f64::NAN; N], errors: nowhere, sizes: nowhere });
        }
        let Some(worst) = all.most_urgent() else { break };
        if n_left == LATE_CUTS {
            late = Some(all.values());
        }
        let whole = all.cell(worst);
        let direction = whole.direction(all.allowed());
        // Along an even way there is nothing to cut.
        let Some(estimates) = whole.halves[direction] else { continue };
        let [low, high] = whole.cell.halves(direction);
        let halves = [(low, estimates[0]), (high, estimates[1])]
            .map(|(half, estimate)| known(half, estimate).map(|half| half.after(whole, direction)));
        let [low, high] = halves;
        all.replace(worst, [low?, high?]);
    }
    let values = all.values();
    let [errors, sizes] = all.errors_and_sizes(late);
    Ok(IntegralValues { values, errors, sizes })
}

/// The surface, or patches of it whose weights are alike.
fn parts(surface: &Surface) -> Vec<Surface> {
    let evened = match surface {
        Surface::Nurbs(surface) => evened(surface),
        Surface::Parametric(_) => None,
    };
    match evened {
        Some(parts) => parts.into_iter().map(|part| Surface::Nurbs(Arc::new(part))).collect(),
        None => vec![surface.clone()],
    }
}

fn cells(part: usize, map: &impl QuadratureMap) -> Vec<QuadratureCell> {
    let [us, vs] = map.cells();
    us.iter().flat_map(|&u| vs.iter().map(move |&v| QuadratureCell { part, u, v })).collect()
}

/// The rule on one cell, of the quantities and of their absolute values.
///
/// What is added up is the difference from the middle of the cell, so that what does not change
/// has its exact integral.
fn quadrature<const N: usize, M: QuadratureMap, D: Into<Density<N>>>(
    (map, ways): (&M, [bool; 2]),
    far: f64,
    cell: QuadratureCell,
    density: &impl Fn(DVec3, DVec3) -> D,
) -> Result<CellEstimate<N>, GeomError> {
    let at = |u: f64, line: &M::Line| -> Result<Density<N>, GeomError> {
        let (point, normal, factor) = map.at(u, line)?;
        let Density { values, parts } = density(point, normal).into();
        Ok(Density {
            values: values.map(|value| value * factor),
            parts: parts.map(|value| value * factor.abs()),
        })
    };
    let middle = at(cell.u.at(0.5), &map.line_at(cell.v.at(0.5)))?.values;
    let (mut means, mut absolute, mut parts) = ([0.0; N], [0.0; N], [0.0; N]);
    let nodes_along = |direction: Direction, interval: Interval| -> Vec<(f64, f64)> {
        match ways[direction] {
            true => [(0.0, 1.0), (0.5, 4.0), (1.0, 1.0)]
                .map(|(share, weight)| (interval.at(share), weight / 6.0))
                .to_vec(),
            false => nodes(&EIGHT_NODES, interval).collect(),
        }
    };
    let along_v = nodes_along(Direction::V, cell.v).into_iter();
    let lines: Vec<(M::Line, f64)> = along_v.map(|(v, weight)| (map.line_at(v), weight)).collect();
    for (u, weight_u) in nodes_along(Direction::U, cell.u) {
        for (line, weight_v) in &lines {
            let weight = weight_u * weight_v;
            let there = at(u, line)?;
            for (i, value) in there.values.into_iter().enumerate() {
                means[i] += weight * (value - middle[i]);
                absolute[i] += weight * value.abs();
                parts[i] += weight
                    * match 0.0 < far {
                        true => far * there.parts[i].max(value.abs()),
                        false => there.parts[i],
                    };
            }
        }
    }
    means.iter_mut().zip(middle).for_each(|(mean, value)| *mean += value);
    let size = cell.u.length() * cell.v.length();
    Ok(CellEstimate {
        values: means.map(|mean| mean * size),
        absolute: absolute.map(|mean| mean * size),
        parts: parts.map(|mean| mean * size),
    })
}
