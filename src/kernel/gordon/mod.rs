//! Surfaces through networks of curves.
//!
//! `network` finds where the curves meet, `family` brings the curves of one direction into order,
//! `map` changes their parameters so that all meet the others at the same ones, `refit` makes
//! splines of what comes out of that. This file adds up the surface.

mod family;
mod map;
mod network;
mod refit;

pub use family::Changes;
pub use network::NetworkError;

pub(in crate::kernel) use map::Map;
pub(in crate::kernel) use refit::refitted;

use family::Member;
use glam::{DVec3, DVec4};
use network::{Meet, chosen, meets};

use super::{
    Ends, GeomError, Grid, Interpolator, KnotVector, NurbsCurve, NurbsSurface,
    frame::angle_between, make_compatible, make_surfaces_compatible,
};

/// What a network is made of, and how.
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
#[derive(Clone, Debug)]
pub struct Gordon {
    /// The surface.
    pub surface: NurbsSurface,
    /// The u of each v-curve and the v of each u-curve, in the order of the surface.
    pub at: [Vec<f64>; 2],
    /// What was done to the curves along u and along v, in the order of the surface.
    pub changes: [Vec<Changes>; 2],
    /// The widest gap of two curves where they meet, and the indices of these.
    pub gap: (f64, [usize; 2]),
    /// The largest angle between both sides of the seam, along u and along v, where they close.
    pub seams: [Option<f64>; 2],
}

/// Places of a seam, and of a curve, that are looked at.
const N_PLACES: usize = 65;

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
    let (found, gap) = meetings(&network, &us, &vs)?;
    let is_given = network.at.map(|at| at.is_some());
    let mut families = family::in_order(&us, &vs, &found, is_given, tolerance)?;

    // Where the curves of one family meet the other, by the parameter of the surface.
    let at = [0, 1].map(|f| family::common(&families[f], network.at[f]));
    let nodes = nodes(&families);
    for (f, family) in families.iter_mut().enumerate() {
        let node = |i: usize, j: usize| if f == 0 { nodes[i][j] } else { nodes[j][i] };
        family::adapt(family, &at[f], &node, 0.5 * tolerance)?;
    }
    let [us, vs] = [0, 1].map(|f| {
        let curves: Vec<NurbsCurve> =
            families[f].members.iter().map(|member| member.curve.clone()).collect();
        make_compatible(&curves)
    });
    let (us, vs) = (us?, vs?);
    let blends = [
        Blend::new(&at[0], families[0].is_ring, network.is_lagrange)?,
        Blend::new(&at[1], families[1].is_ring, network.is_lagrange)?,
    ];
    let surface = added(&us, &vs, &nodes, &blends)?;

    for (f, curves) in [us, vs].iter().enumerate() {
        for (k, member) in families[f].members.iter_mut().enumerate() {
            let t = at[1 - f][k];
            let iso = if f == 0 { surface.isocurve_v(t) } else { surface.isocurve_u(t) };
            member.miss(&curves[k], &iso);
        }
    }
    let seams = [0, 1].map(|f| families[f].is_ring.then(|| seam_angle(&surface, f == 0)));
    let changes = families.map(|family| family.members.into_iter().map(Member::changes).collect());
    Ok(Gordon { surface, at, changes, gap, seams })
}

/// The meetings of all pairs, and the widest gap.
type Meetings = (Vec<Vec<Meet>>, (f64, [usize; 2]));

fn meetings(
    network: &Network<'_>,
    us: &[NurbsCurve],
    vs: &[NurbsCurve],
) -> Result<Meetings, NetworkError> {
    let tolerance = network.tolerance;
    let all = match network.at {
        [Some(at_u), Some(at_v)] => {
            let meet = |k: usize, l: usize| Meet { t: at_u[l], s: at_v[k] };
            (0..us.len()).map(|k| (0..vs.len()).map(|l| meet(k, l)).collect()).collect()
        }
        [Some(at_u), None] => {
            let meet = |c: &NurbsCurve, l: usize| {
                let foot = vs[l].closest(c.point_at(at_u[l]), tolerance);
                Meet { t: at_u[l], s: foot.parameter }
            };
            us.iter().map(|c| (0..vs.len()).map(|l| meet(c, l)).collect()).collect()
        }
        [None, Some(at_v)] => {
            let meet = |k: usize, d: &NurbsCurve| {
                let foot = us[k].closest(d.point_at(at_v[k]), tolerance);
                Meet { t: foot.parameter, s: at_v[k] }
            };
            (0..us.len()).map(|k| vs.iter().map(|d| meet(k, d)).collect()).collect()
        }
        [None, None] => {
            let rings = [us, vs].map(|curves| curves.iter().all(|c| c.is_closed(tolerance)));
            let mut all = Vec::with_capacity(us.len());
            for (k, c) in us.iter().enumerate() {
                let mut row = Vec::with_capacity(vs.len());
                for (l, d) in vs.iter().enumerate() {
                    let mut found = meets(c, d, tolerance, [k, l])?;
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
            chosen(&all, us, vs)?
        }
    };
    let mut widest = (0.0_f64, [0, 0]);
    for (k, c) in us.iter().enumerate() {
        for (l, d) in vs.iter().enumerate() {
            let Meet { t, s } = all[k][l];
            c.domain().clamp_inside(t)?;
            d.domain().clamp_inside(s)?;
            let (p, q) = (c.point_at(t), d.point_at(s));
            let gap = p.distance(q);
            if tolerance < gap {
                let point = p.midpoint(q);
                return Err(NetworkError::Apart { pair: [k, l], gap, at: [t, s], point });
            }
            if widest.0 < gap {
                widest = (gap, [k, l]);
            }
        }
    }
    Ok((all, widest))
}

/// The places where the curves meet, by u-curve and v-curve.
fn nodes(families: &[family::Family; 2]) -> Vec<Vec<DVec3>> {
    let [us, vs] = [&families[0].members, &families[1].members];
    let node = |k: usize, l: usize| {
        let (c, d) = (&us[k], &vs[l]);
        c.curve.point_at(c.at[l]).midpoint(d.curve.point_at(d.at[k]))
    };
    (0..us.len()).map(|k| (0..vs.len()).map(|l| node(k, l)).collect()).collect()
}

/// Splines through values at places of one direction.
struct Blend {
    fit: Interpolator,
    /// Whether values halfway are put in, as a ring of two has too few of its own.
    is_doubled: bool,
}

impl Blend {
    /// `at` has one parameter more than there are values where the direction closes.
    fn new(at: &[f64], is_ring: bool, is_lagrange: bool) -> Result<Self, GeomError> {
        if !is_ring {
            let degree = if is_lagrange { at.len() - 1 } else { 3 };
            return Ok(Self {
                fit: Interpolator::new(at, degree, Ends::Averaged)?,
                is_doubled: false,
            });
        }
        if let &[start, middle, end] = at {
            let doubled = [start, 0.5 * (start + middle), middle, 0.5 * (middle + end), end];
            return Ok(Self { fit: Interpolator::periodic(&doubled, 3)?, is_doubled: true });
        }
        Ok(Self { fit: Interpolator::periodic(at, 3)?, is_doubled: false })
    }

    fn knots(&self) -> &KnotVector {
        self.fit.knots()
    }

    fn through(&self, values: &[DVec3]) -> Result<Vec<DVec3>, GeomError> {
        let mut lifted: Vec<DVec4> = values.iter().map(|value| value.extend(1.0)).collect();
        if self.is_doubled {
            let middle = (lifted[0] + lifted[1]) * 0.5;
            lifted = vec![lifted[0], middle, lifted[1], middle];
        }
        Ok(self.fit.through(&lifted)?.into_iter().map(DVec4::truncate).collect())
    }
}

/// L1 + L2 − T.
fn added(
    us: &[NurbsCurve],
    vs: &[NurbsCurve],
    nodes: &[Vec<DVec3>],
    [along_u, along_v]: &[Blend; 2],
) -> Result<NurbsSurface, GeomError> {
    let lines = |curves: &[NurbsCurve]| -> Vec<Vec<DVec3>> {
        let points: Vec<Vec<DVec3>> = curves.iter().map(NurbsCurve::points).collect();
        (0..points[0].len()).map(|i| points.iter().map(|line| line[i]).collect()).collect()
    };
    let each = |lines: &[Vec<DVec3>], blend: &Blend| -> Result<Grid<DVec3>, GeomError> {
        let rows: Result<Vec<Vec<DVec3>>, GeomError> =
            lines.iter().map(|line| blend.through(line)).collect();
        Grid::from_rows(rows?)
    };
    let (knots_u, knots_v) = (along_u.knots().clone(), along_v.knots().clone());
    let through_us = each(&lines(us), along_v)?;
    let through_vs = each(&lines(vs), along_u)?.transposed();
    let first = each(nodes, along_u)?.transposed();
    let rows: Vec<Vec<DVec3>> = (0..first.n_rows()).map(|i| first.row(i).to_vec()).collect();
    let through_nodes = each(&rows, along_v)?;

    let three = [
        NurbsSurface::polynomial(us[0].knots().clone(), knots_v.clone(), &through_us)?,
        NurbsSurface::polynomial(knots_u.clone(), vs[0].knots().clone(), &through_vs)?,
        NurbsSurface::polynomial(knots_u, knots_v, &through_nodes)?,
    ];
    let common = make_surfaces_compatible(&three)?;
    let [a, b, c] = [0, 1, 2].map(|i| common[i].points());
    let sum =
        Grid::from_fn(a.n_rows(), a.n_columns(), |i, j| a.get(i, j) + b.get(i, j) - c.get(i, j));
    NurbsSurface::polynomial(common[0].knots_u().clone(), common[0].knots_v().clone(), &sum)
}

/// The largest angle between the tangents on both sides of a seam.
fn seam_angle(surface: &NurbsSurface, is_u: bool) -> f64 {
    let (across, along) = (surface.domain_u(), surface.domain_v());
    let (across, along) = if is_u { (across, along) } else { (along, across) };
    let tangent = |t: f64, s: f64| match is_u {
        true => surface.derivatives_at(t, s, 1).get(1, 0),
        false => surface.derivatives_at(s, t, 1).get(0, 1),
    };
    let angle = |s: f64| angle_between(tangent(across.start(), s), tangent(across.end(), s));
    along.steps(N_PLACES - 1).into_iter().map(angle).fold(0.0, f64::max)
}
