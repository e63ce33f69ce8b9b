//! Networks from the curves that one has to one surface with its report: which curves count, and what is left of the
//! tolerance for it.

use super::{CurveAdjustment, Gordon, Network, NetworkError, NetworkInput, gordon};
use crate::{
    ConstructionReport, CountError, Curve, Direction, GeomError, NurbsCurve, NurbsSurface,
    ReportEntry, check_parameters, sorting::sort_by_key,
};

/// Part of the tolerance by which a curve that comes again may miss where it was before.
const AGAIN: f64 = 0.5;

/// Part of the tolerance within which splines stand in for functions: what is found within the tolerance of them is
/// then within it of the functions.
const FOR_FUNCTIONS: f64 = 0.25;

/// A surface through a network of curves before it is made.
///
/// The curves may be of any degree, direction, order and parameters; the first of each direction gives the direction.
/// Four sides of a square, one corner of which is lifted, have between them z = uv:
///
/// ```
/// use virote_kernel::{NetworkBuilder, NurbsCurve, glam::DVec3};
///
/// let line = |a, b| NurbsCurve::line(a, b);
/// let [o, x, y, top] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ONE];
/// let u = vec![line(o, x)?, line(top, y)?];
/// let v = vec![line(o, y)?, line(x, top)?];
/// let surface = NetworkBuilder::new(u, v, 1e-6).build()?;
/// assert!(surface.point_at(0.5, 0.5).distance(DVec3::new(0.5, 0.5, 0.25)) < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
#[must_use]
pub struct NetworkBuilder {
    curves: [Vec<Curve>; 2],
    at: [Option<Vec<f64>>; 2],
    is_lagrange: bool,
    tolerance: f64,
}

/// A network whose curves were looked through, so that those that count are known.
///
/// Where the curves along u close, the last one across them may be the first again, and counts once:
///
/// ```
/// use virote_kernel::{CircleForm, Frame, NetworkBuilder, NurbsCurve, glam::DVec3};
///
/// let ring = |z: f64| {
///     let plane = Frame::XY.at(DVec3::Z * z);
///     NurbsCurve::ellipse(plane, [1.0, 1.0], CircleForm::NinePoint)
/// };
/// let rung = |p: DVec3| NurbsCurve::line(p, p + DVec3::Z);
/// let u = vec![ring(0.0)?, ring(1.0)?];
/// let v = vec![rung(DVec3::X)?, rung(DVec3::NEG_X)?, rung(DVec3::X)?];
/// let network = NetworkBuilder::new(u, v, 1e-6).prepare()?;
/// assert_eq!(network.kept()[1], [0, 1]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct PreparedNetwork {
    curves: [Vec<NurbsCurve>; 2],
    kept: [Vec<usize>; 2],
    n_given: [usize; 2],
    at: [Option<Vec<f64>>; 2],
    is_lagrange: bool,
    tolerance: f64,
}

impl NetworkBuilder {
    /// The surface through curves along u and curves along v, within the tolerance of all of them, which may be as far
    /// apart where they meet.
    pub fn new<C: Into<Curve>>(u: Vec<C>, v: Vec<C>, tolerance: f64) -> Self {
        let curves = [u, v].map(|family| family.into_iter().map(Into::into).collect());
        Self { curves, at: [None, None], is_lagrange: false, tolerance }
    }

    /// The u of each v-curve, which else is found.
    pub fn at_u(self, parameters: Vec<f64>) -> Self {
        let [_, at_v] = self.at;
        Self { at: [Some(parameters), at_v], ..self }
    }

    /// The v of each u-curve, which else is found.
    pub fn at_v(self, parameters: Vec<f64>) -> Self {
        let [at_u, _] = self.at;
        Self { at: [at_u, Some(parameters)], ..self }
    }

    /// One polynomial through all curves of a direction, instead of cubic splines between them.
    pub fn lagrange(self) -> Self {
        Self { is_lagrange: true, ..self }
    }

    /// The surface, with its report.
    ///
    /// # Errors
    /// Those of [`Self::prepare`] and [`PreparedNetwork::build`].
    pub fn build(self) -> Result<NurbsSurface, NetworkError> {
        self.prepare()?.build()
    }

    /// The network of the curves that count: where those across them all close, curves that come again do not.
    ///
    /// # Errors
    /// [`NetworkError::Input`] for fewer than two curves of a direction, functions without a spline near them, and
    /// parameters that do not increase or are not as many as there are curves; [`NetworkError::Point`].
    pub fn prepare(self) -> Result<PreparedNetwork, NetworkError> {
        let Self { curves: [us, vs], at, is_lagrange, tolerance } = self;
        let n_given = [us.len(), vs.len()];
        let us = splines(&us, Direction::U, tolerance)?;
        let vs = splines(&vs, Direction::V, tolerance)?;
        let [(of_u, apart_u), (of_v, apart_v)] =
            [once(&us, &vs, tolerance), once(&vs, &us, tolerance)];
        let kept = [of_u, of_v];
        // What is left of it, so that the surface is within it of the curves that come again too.
        let tolerance = tolerance - apart_u.max(apart_v);
        let curves = [(us, &kept[0]), (vs, &kept[1])]
            .map(|(curves, kept)| kept.iter().map(|&i| curves[i].clone()).collect::<Vec<_>>());
        let needed = [(NetworkInput::AtU, curves[1].len()), (NetworkInput::AtV, curves[0].len())];
        for ((of, needed), given) in needed.into_iter().zip(&at) {
            let Some(given) = given else { continue };
            check_parameters(given, needed).map_err(|error| NetworkError::Input { of, error })?;
        }
        Ok(PreparedNetwork { curves, kept, n_given, at, is_lagrange, tolerance })
    }
}

impl PreparedNetwork {
    /// The indices of the curves that count, along u and along v, among those that were given.
    #[must_use]
    pub fn kept(&self) -> [&[usize]; 2] {
        [&self.kept[0], &self.kept[1]]
    }

    /// What is left of the tolerance by curves that come again, not quite where they were.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// The surface, with its report, in which curves have the indices with which they were given.
    ///
    /// # Errors
    /// Those of [`gordon`], with these indices too.
    pub fn build(&self) -> Result<NurbsSurface, NetworkError> {
        let made = gordon(Network {
            curves: [&self.curves[0], &self.curves[1]],
            at: [0, 1].map(|f| self.at[f].as_deref()),
            is_lagrange: self.is_lagrange,
            tolerance: self.tolerance,
        });
        let made = made.map_err(|error| error.renumbered(self.kept()))?;
        Ok(with_report(made, [0, 1].map(|f| (&self.kept[f][..], self.n_given[f]))))
    }
}

/// The curves of a direction as NURBS, two or more, none of them a point.
fn splines(
    given: &[Curve],
    along: Direction,
    tolerance: f64,
) -> Result<Vec<NurbsCurve>, NetworkError> {
    let of = [NetworkInput::U, NetworkInput::V][along];
    let blamed = |error: GeomError| NetworkError::Input { of, error };
    if given.len() < 2 {
        return Err(blamed(CountError::TooFewCurves { got: given.len(), needed: 2 }.into()));
    }
    let nurbs = |(index, curve): (usize, &Curve)| {
        let curve = curve.nurbs_within(FOR_FUNCTIONS * tolerance).map_err(blamed)?;
        if curve.is_point() {
            return Err(NetworkError::Point { along, curve: index });
        }
        Ok(NurbsCurve::clone(&curve))
    };
    given.iter().enumerate().map(nurbs).collect()
}

/// A bound of how far two curves are apart at equal fractions of their domains.
fn apart(a: &NurbsCurve, b: &NurbsCurve) -> f64 {
    a.deviation_from(&b.reparametrized(a.domain()))
}

/// The indices of the curves; where those across them all close, without curves that come again in
/// either direction, and how far these are at most from where they were before.
fn once(curves: &[NurbsCurve], across: &[NurbsCurve], tolerance: f64) -> (Vec<usize>, f64) {
    let all: Vec<usize> = (0..curves.len()).collect();
    if !across.iter().all(|curve| curve.is_closed(tolerance)) {
        return (all, 0.0);
    }
    let same = AGAIN * tolerance;
    let (mut kept, mut farthest) = (Vec::new(), 0.0_f64);
    for &i in &all {
        let ways = [curves[i].clone(), curves[i].reversed()];
        let misses = kept.iter().flat_map(|&k: &usize| {
            let own = &curves[k];
            let meets = |way: &&NurbsCurve| {
                own.start().distance(way.start()).max(own.end().distance(way.end())) <= same
            };
            ways.iter().filter(meets).map(|way| apart(own, way))
        });
        let least = misses.fold(f64::INFINITY, f64::min);
        if least <= same {
            farthest = farthest.max(least);
        } else {
            kept.push(i);
        }
    }
    if kept.len() < 2 { (all, 0.0) } else { (kept, farthest) }
}

/// The surface with its report.
fn with_report(made: Gordon, kept: [(&[usize], usize); 2]) -> NurbsSurface {
    let Gordon { surface, at, mut changes, gap, seams } = made;
    for (changes, (kept, _)) in changes.iter_mut().zip(kept) {
        changes.iter_mut().for_each(|change| change.index = kept[change.index]);
    }
    let repeated =
        kept.map(|(kept, given)| (0..given).filter(|i| !kept.contains(i)).collect::<Vec<usize>>());
    // In the order in which the curves were given.
    let [at_u, at_v] = [0, 1].map(|f| {
        let mut pairs: Vec<(usize, f64)> =
            changes[1 - f].iter().map(|change| change.index).zip(at[f].iter().copied()).collect();
        sort_by_key(&mut pairs, |&(index, _)| index);
        pairs.into_iter().map(|(_, t)| t).collect::<Vec<f64>>()
    });
    changes.iter_mut().for_each(|family| family.sort_by_key(|change| change.index));
    let net = surface.control_points();
    let both = |u: usize, v: usize| ConstructionReport::default().with("u", u).with("v", v);
    let family = |changes: &[CurveAdjustment]| {
        let one = |change: &CurveAdjustment| {
            ConstructionReport::default()
                .with("curve", change.index)
                .with("deviation", ReportEntry::Length(change.deviation))
                .with("at", change.worst_at)
                .with("reversed", change.is_reversed)
                .with("trimmed", change.is_trimmed)
                .with("seam", change.seam)
                .with("reparametrized", change.is_reparametrized)
                .with("refitted", change.is_refitted)
        };
        changes.iter().map(one).collect::<Vec<_>>()
    };
    let deviations = changes.iter().flatten().map(|change| change.deviation);
    let [u, v] = &changes;
    let [seam_u, seam_v] = seams.map(|angle| angle.map_or(ReportEntry::None, ReportEntry::Angle));
    let [repeated_u, repeated_v] = repeated;
    let (widest, [k, l]) = (gap.0, [kept[0].0[gap.1[0]], kept[1].0[gap.1[1]]]);
    let report = ConstructionReport::of("gordon")
        .with("at_u", at_u)
        .with("at_v", at_v)
        .with("deviation", ReportEntry::Length(deviations.fold(0.0, f64::max)))
        .with(
            "gap",
            ConstructionReport::default()
                .with("max", ReportEntry::Length(widest))
                .with("u", k)
                .with("v", l),
        )
        .with("u", family(u))
        .with("v", family(v))
        .with("repeated_u", repeated_u)
        .with("repeated_v", repeated_v)
        .with("seam_u", seam_u)
        .with("seam_v", seam_v)
        .with("degree", both(surface.degree_u(), surface.degree_v()))
        .with("control_points", both(net.n_rows(), net.n_columns()));
    surface.with_report(report)
}
