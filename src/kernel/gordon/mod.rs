//! Surfaces through networks of curves.
//!
//! `builder` looks through what is given; `network` finds where the curves meet, `family` brings the curves of one direction into order,
//! `adapt` to common parameters: `map` changes them so that all meet the others at the same ones,
//! `refit` makes splines of what comes out of that. This file adds up the surface.

mod adapt;
mod builder;
mod family;
mod map;
mod network;
mod refit;

pub use builder::{NetworkBuilder, PreparedNetwork};
pub use family::CurveAdjustment;
pub use network::{NetworkError, NetworkInput};

pub(crate) use map::NetworkParameterMap;
pub(crate) use refit::{RefitRequest, refitted};

use family::{N_PLACES, NetworkCurve};
use glam::{DVec3, DVec4};
use network::{NetworkCrossing, apart, check_alike, chosen, meets};

use super::{
    Direction, Ends, FitError, GeomError, Grid, Interpolator, KnotVector, NurbsCurve, NurbsSurface,
    frame::angle_between, surface::BooleanSumTerm,
};

use crate::ceiling::GORDON_ROUNDS;

/// What a network is made of, and how.
///
/// Four sides of a square, one corner of which is lifted, have between them z = uv:
///
/// ```
/// use virote_kernel::{Network, NurbsCurve, glam::DVec3, gordon};
///
/// let line = |a, b| NurbsCurve::line(a, b);
/// let [o, x, y, top] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ONE];
/// let curves = [&[line(o, x)?, line(y, top)?][..], &[line(o, y)?, line(x, top)?][..]];
/// let network = Network { curves, at: [None, None], is_lagrange: false, tolerance: 1e-6 };
/// let surface = gordon(network).map_err(|error| format!("{error:?}"))?.surface;
/// assert!(surface.point_at(0.5, 0.5).distance(DVec3::new(0.5, 0.5, 0.25)) < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Network<'a> {
    /// Curves along u and along v.
    pub curves: [&'a [NurbsCurve]; 2],
    /// The u of each v-curve and the v of each u-curve, where they are given.
    pub at: [Option<&'a [f64]>; 2],
    /// Whether one polynomial blends each direction, instead of a cubic spline.
    pub is_lagrange: bool,
    /// How far apart curves may be where they meet, and the surface from them.
    pub tolerance: f64,
}

/// A surface through a network, and what was done for it.
///
/// What was found: here the places of the curves across, at even distances.
///
/// ```
/// use virote_kernel::{Network, NurbsCurve, glam::DVec3, gordon};
///
/// let along = |y: f64| NurbsCurve::line(DVec3::Y * y, DVec3::new(4.0, y, 0.0));
/// let across = |x: f64| NurbsCurve::line(DVec3::X * x, DVec3::new(x, 1.0, 0.0));
/// let curves = [&[along(0.0)?, along(1.0)?][..], &[across(0.0)?, across(1.0)?, across(4.0)?][..]];
/// let network = Network { curves, at: [None, None], is_lagrange: false, tolerance: 1e-6 };
/// let made = gordon(network).map_err(|error| format!("{error:?}"))?;
/// assert!((made.at[0][1] - 0.25).abs() < 1e-12);
/// assert!(made.gap.0 < 1e-12 && made.seams == [None, None]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Gordon {
    /// The surface.
    pub surface: NurbsSurface,
    /// The u of each v-curve and the v of each u-curve, in the order of the surface.
    pub at: [Vec<f64>; 2],
    /// What was done to the curves along u and along v, in the order of the surface.
    pub changes: [Vec<CurveAdjustment>; 2],
    /// The widest gap of two curves where they meet, and the indices of these.
    pub gap: (f64, [usize; 2]),
    /// The largest angle between both sides of the seam, along u and along v, where they close.
    pub seams: [Option<f64>; 2],
}

/// Part of a gap between two curves by which the surface may miss both.
const GAP_SHARE: f64 = 0.75;

/// The least part of the tolerance that remains for splines in place of curves, and by which it
/// falls where the surface missed.
const LEAST_SHARE: f64 = 0.4;

/// The surface through all curves of a network: L1 + L2 − T.
///
/// L1 runs through the u-curves, L2 through the v-curves and T through their meetings, all three
/// with the same splines along each direction, of degree 3 or one less than there are curves;
/// periodic where the curves close. Only so is the sum a surface through all curves.
/// Gordon, *Spline-blended surface interpolation through curve networks* (1969); Piegl & Tiller,
/// *The NURBS Book*, §10.5.
///
/// # Errors
/// [`NetworkError`].
pub fn gordon(network: Network<'_>) -> Result<Gordon, NetworkError> {
    let [us, vs] = network.curves;
    let tolerance = network.tolerance;
    let us: Vec<NurbsCurve> = us.iter().map(NurbsCurve::clamped).collect();
    let vs: Vec<NurbsCurve> = vs.iter().map(NurbsCurve::clamped).collect();
    check_alike(&us, Direction::U, tolerance)?;
    check_alike(&vs, Direction::V, tolerance)?;
    let (found, gap) = meetings(&network, &us, &vs)?;
    let is_given = network.at.map(|at| at.is_some());
    let families = family::in_order(&us, &vs, &found, is_given, tolerance)?;
    for along in Direction::BOTH {
        families[along].check_apart(along, tolerance)?;
    }

    // Where the curves of one family meet the other, by the parameter of the surface.
    let at = [0, 1].map(|f| adapt::common(&families[f], network.at[f], tolerance));
    let nodes = nodes(&families);
    let blends = [
        BlendingSplines::new(&at[0], families[0].is_ring, network.is_lagrange)?,
        BlendingSplines::new(&at[1], families[1].is_ring, network.is_lagrange)?,
    ];
    // Half a gap remains, and a little more between the curves.
    let mut share = (tolerance - GAP_SHARE * gap.0).max(LEAST_SHARE * tolerance);
    let mut found = f64::INFINITY;
    for _ in 0..GORDON_ROUNDS {
        let mut families = families.clone();
        for (f, family) in families.iter_mut().enumerate() {
            adapt::adapt(family, &at[f], blends[f].knots(), [tolerance, share])?;
        }
        let surface = added(&families, &nodes, &blends)?;
        for (f, family) in families.iter_mut().enumerate() {
            for (k, member) in family.members.iter_mut().enumerate() {
                let t = at[1 - f][k];
                let iso = if f == 0 { surface.isocurve_v(t) } else { surface.isocurve_u(t) };
                member.miss(&iso);
            }
        }
        let members = || families.iter().flat_map(|family| &family.members);
        found = members().map(NetworkCurve::deviation).fold(0.0, f64::max);
        if found <= tolerance {
            let seams = Direction::BOTH
                .map(|along| families[along].is_ring.then(|| seam_angle(&surface, along)));
            let changes = families
                .map(|family| family.members.into_iter().map(NetworkCurve::changes).collect());
            return Ok(Gordon { surface, at, changes, gap, seams });
        }
        if !members().any(NetworkCurve::is_refitted) {
            break;
        }
        share *= LEAST_SHARE;
    }
    Err(GeomError::Fit(FitError::ToleranceNotKept { tolerance, found }).into())
}

/// The meetings of all pairs, and the widest gap.
type NetworkCrossings = (Vec<Vec<NetworkCrossing>>, (f64, [usize; 2]));

fn meetings(
    network: &Network<'_>,
    us: &[NurbsCurve],
    vs: &[NurbsCurve],
) -> Result<NetworkCrossings, NetworkError> {
    let tolerance = network.tolerance;
    let all = match network.at {
        [Some(at_u), Some(at_v)] => {
            let meet = |k: usize, l: usize| NetworkCrossing { t: at_u[l], s: at_v[k] };
            (0..us.len()).map(|k| (0..vs.len()).map(|l| meet(k, l)).collect()).collect()
        }
        [Some(at_u), None] => {
            let meet = |c: &NurbsCurve, l: usize| {
                let foot = vs[l].closest(c.point_at(at_u[l]), tolerance);
                NetworkCrossing { t: at_u[l], s: foot.parameter }
            };
            us.iter().map(|c| (0..vs.len()).map(|l| meet(c, l)).collect()).collect()
        }
        [None, Some(at_v)] => {
            let meet = |k: usize, d: &NurbsCurve| {
                let foot = us[k].closest(d.point_at(at_v[k]), tolerance);
                NetworkCrossing { t: foot.parameter, s: at_v[k] }
            };
            (0..us.len()).map(|k| vs.iter().map(|d| meet(k, d)).collect()).collect()
        }
        [None, None] => found(us, vs, tolerance)?,
    };
    let mut widest = (0.0_f64, [0, 0]);
    for (k, c) in us.iter().enumerate() {
        for (l, d) in vs.iter().enumerate() {
            let NetworkCrossing { t, s } = all[k][l];
            c.domain().clamp_inside(t)?;
            d.domain().clamp_inside(s)?;
            let (p, q) = (c.point_at(t), d.point_at(s));
            let gap = p.distance(q);
            if tolerance < gap {
                let point = p.midpoint(q);
                let (n_pairs, are_all) = (1, false);
                let (pair, at) = ([k, l], [t, s]);
                return Err(NetworkError::Apart { pair, gap, at, point, n_pairs, are_all });
            }
            if widest.0 < gap {
                widest = (gap, [k, l]);
            }
        }
    }
    Ok((all, widest))
}

/// What the curves themselves tell of where they meet.
fn found(
    us: &[NurbsCurve],
    vs: &[NurbsCurve],
    tolerance: f64,
) -> Result<Vec<Vec<NetworkCrossing>>, NetworkError> {
    let rings = [us, vs].map(|curves| curves.iter().all(|c| c.is_closed(tolerance)));
    let mut all = Vec::with_capacity(us.len());
    let mut missing: Vec<[usize; 2]> = Vec::new();
    for (k, c) in us.iter().enumerate() {
        let mut row = Vec::with_capacity(vs.len());
        for (l, d) in vs.iter().enumerate() {
            let mut found = meets(c, d, tolerance, [k, l])?;
            missing.extend(found.is_empty().then_some([k, l]));
            // The end of a closed curve is its start.
            let is_end = |curve: &NurbsCurve, t: f64| curve.domain().end() <= t;
            if 1 < found.len() {
                found.retain(|m| !(rings[0] && is_end(c, m.t)));
            }
            if 1 < found.len() {
                found.retain(|m| !(rings[1] && is_end(d, m.s)));
            }
            row.push(found);
        }
        all.push(row);
    }
    if let Some(error) = apart(&missing, us, vs, tolerance) {
        return Err(error);
    }
    chosen(&all, us, vs)
}

/// The places where the curves meet, by u-curve and v-curve.
fn nodes(families: &[family::CurveFamily; 2]) -> Vec<Vec<DVec3>> {
    let [us, vs] = [&families[0].members, &families[1].members];
    let node = |k: usize, l: usize| {
        let (c, d) = (&us[k], &vs[l]);
        c.curve.point_at(c.at[l]).midpoint(d.curve.point_at(d.at[k]))
    };
    (0..us.len()).map(|k| (0..vs.len()).map(|l| node(k, l)).collect()).collect()
}

/// Splines through values at places of one direction.
struct BlendingSplines {
    fit: Interpolator,
    n_places: usize,
    /// Whether there is a value halfway between the two that close, and one behind them.
    is_doubled: bool,
}

impl BlendingSplines {
    /// `at` has one parameter more than there are values where the direction closes.
    fn new(at: &[f64], is_ring: bool, is_lagrange: bool) -> Result<Self, GeomError> {
        let n_places = at.len() - usize::from(is_ring);
        let made = |fit, is_doubled| Self { fit, n_places, is_doubled };
        if !is_ring {
            let degree = if is_lagrange { at.len() - 1 } else { 3 };
            return Ok(made(Interpolator::new(at, degree, Ends::Averaged)?, false));
        }
        if let &[start, middle, end] = at {
            let doubled = [start, 0.5 * (start + middle), middle, 0.5 * (middle + end), end];
            return Ok(made(Interpolator::periodic(&doubled, 3)?, true));
        }
        Ok(made(Interpolator::periodic(at, 3)?, false))
    }

    fn knots(&self) -> &KnotVector {
        self.fit.knots()
    }

    /// For each place the function that is 1 there and 0 at the others.
    fn functions(&self) -> Result<Vec<NurbsCurve>, GeomError> {
        let n = self.n_places;
        let function = |k: usize| {
            let mut values: Vec<DVec4> =
                (0..n).map(|i| DVec4::new(f64::from(u8::from(i == k)), 0.0, 0.0, 1.0)).collect();
            if self.is_doubled {
                let middle = (values[0] + values[1]) * 0.5;
                values = vec![values[0], middle, values[1], middle];
            }
            let points = self.fit.through(&values)?;
            let points: Vec<DVec3> = points.into_iter().map(DVec4::truncate).collect();
            NurbsCurve::polynomial(self.knots().clone(), &points)
        };
        (0..n).map(function).collect()
    }
}

/// L1 + L2 − T.
fn added(
    [us, vs]: &[family::CurveFamily; 2],
    nodes: &[Vec<DVec3>],
    [along_u, along_v]: &[BlendingSplines; 2],
) -> Result<NurbsSurface, GeomError> {
    let strands = |family: &family::CurveFamily, blend: &BlendingSplines| {
        Ok::<_, GeomError>(BooleanSumTerm {
            curves: family.members.iter().map(|member| member.curve.clone()).collect(),
            blends: blend.functions()?,
        })
    };
    let (n, m) = (vs.members.len(), us.members.len());
    let meetings = Grid::from_fn(n, m, |l, k| nodes[k][l]);
    NurbsSurface::boolean_sum(strands(us, along_u)?, strands(vs, along_v)?, &meetings)
}

/// The largest angle between the tangents on both sides of a seam.
fn seam_angle(surface: &NurbsSurface, closed: Direction) -> f64 {
    let domain = surface.domain(closed);
    let tangent = |t: f64, s: f64| match closed {
        Direction::U => surface.derivatives_at(t, s, 1).get(1, 0),
        Direction::V => surface.derivatives_at(s, t, 1).get(0, 1),
    };
    let angle = |s: f64| angle_between(tangent(domain.start(), s), tangent(domain.end(), s));
    surface.domain(closed.other()).steps(N_PLACES - 1).into_iter().map(angle).fold(0.0, f64::max)
}
