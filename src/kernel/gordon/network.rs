//! Where the curves of a network meet, in which order and direction.

use glam::DVec3;

use crate::{
    Direction, GeomError, IntersectionError, NurbsCurve,
    ceiling::DISTANT_PAIRS,
    digits::few_digits,
    sorting::sort_by,
    tolerance::{ONE_MEETING_SHARE, PLACE_RELATIVE},
};

/// Why curves are no network; indices are those in which the curves were given.
///
/// Two curves along x, one of two across them a unit above:
///
/// ```
/// use virote_kernel::{Network, NetworkError, NurbsCurve, glam::DVec3, gordon};
///
/// let line = |a, b| NurbsCurve::line(a, b);
/// let [o, x, y, z] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
/// let curves = [&[line(o, x)?, line(y, x + y)?][..], &[line(o, y)?, line(x + z, x + y + z)?][..]];
/// let network = Network { curves, at: [None, None], is_lagrange: false, tolerance: 1e-6 };
/// let Err(NetworkError::Apart { gap, n_pairs, .. }) = gordon(network) else {
///     unreachable!("they do not meet");
/// };
/// assert!((gap - 1.0).abs() < 1e-12 && n_pairs == 2);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NetworkError {
    /// Two curves that do not come within the tolerance of one another, those furthest apart.
    #[error("`u[{}]` and `v[{}]` do not meet: they are {} apart", pair[0], pair[1], few_digits(*gap))]
    Apart {
        /// Index of the u-curve and of the v-curve.
        pair: [usize; 2],
        /// Their least distance.
        gap: f64,
        /// The parameters of both where they are nearest.
        at: [f64; 2],
        /// The place between them there.
        point: DVec3,
        /// How many pairs do not meet.
        n_pairs: usize,
        /// Whether that are all pairs there are.
        are_all: bool,
    },
    /// Two curves that meet at several places, none of which fits the others better.
    #[error("`u[{}]` and `v[{}]` meet at {} places, and no other curve tells which is meant", pair[0], pair[1], at.len())]
    Ambiguous {
        /// Index of the u-curve and of the v-curve.
        pair: [usize; 2],
        /// The parameters of the u-curve and of the v-curve, and the places.
        at: Vec<([f64; 2], DVec3)>,
    },
    /// Two curves that share a stretch.
    #[error("`u[{}]` and `v[{}]` run along one another instead of crossing", pair[0], pair[1])]
    Together {
        /// Index of the u-curve and of the v-curve.
        pair: [usize; 2],
        /// Where the stretch begins and ends.
        ends: [DVec3; 2],
    },
    /// A closed curve and an open one in one family.
    #[error("`{0}[{closed}]` is closed and `{0}[{open}]` is open", along.name())]
    Mixed {
        /// The direction of both.
        along: Direction,
        /// Index of the closed one.
        closed: usize,
        /// Index of the open one.
        open: usize,
        /// How far apart the ends of that are.
        gap: f64,
    },
    /// Two curves of one family that cross.
    #[error("`{0}[{1}]` and `{0}[{2}]` cross", along.name(), curves[0], curves[1])]
    Crossing {
        /// The direction of both.
        along: Direction,
        /// Their indices.
        curves: [usize; 2],
        /// Where.
        point: DVec3,
    },
    /// A curve that meets the others in another order than the first curve of its family does.
    #[error("`{}[{curve}]` meets the others in another order than the first curve does", along.name())]
    Order {
        /// Its direction.
        along: Direction,
        /// Its index.
        curve: usize,
        /// Two of the others, which it meets the other way around, or at one place.
        others: [usize; 2],
        /// Its parameters there.
        at: [f64; 2],
        /// Where these two cross, if they do.
        crossing: Option<DVec3>,
    },
    /// A curve that is a point.
    #[error("`{}[{curve}]` is one point", along.name())]
    Point {
        /// Its direction.
        along: Direction,
        /// Its index.
        curve: usize,
    },
    /// Something that was given and cannot be used.
    #[error("{error}")]
    Input {
        /// What.
        of: NetworkInput,
        /// Why not.
        error: GeomError,
    },
    /// Anything else.
    #[error(transparent)]
    Geometry(#[from] GeomError),
}

/// What an error of a network is about.
///
/// ```
/// use virote_kernel::{NetworkBuilder, NetworkError, NetworkInput, NurbsCurve, glam::DVec3};
///
/// let [o, x, y] = [DVec3::ZERO, DVec3::X, DVec3::Y];
/// let u = vec![NurbsCurve::line(o, x)?];
/// let v = vec![NurbsCurve::line(o, y)?, NurbsCurve::line(x, x + y)?];
/// let found = NetworkBuilder::new(u, v, 1e-6).build();
/// assert!(matches!(found, Err(NetworkError::Input { of: NetworkInput::U, .. })));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NetworkInput {
    /// The curves along u.
    U,
    /// The curves along v.
    V,
    /// The u of each v-curve.
    AtU,
    /// The v of each u-curve.
    AtV,
}

impl NetworkError {
    /// The same of curves that are some of others, by their indices among those.
    pub(super) fn renumbered(self, kept: [&[usize]; 2]) -> Self {
        let both = |[k, l]: [usize; 2]| [kept[0][k], kept[1][l]];
        let own = |along: Direction| kept[along];
        match self {
            Self::Apart { pair, gap, at, point, n_pairs, are_all } => {
                Self::Apart { pair: both(pair), gap, at, point, n_pairs, are_all }
            }
            Self::Ambiguous { pair, at } => Self::Ambiguous { pair: both(pair), at },
            Self::Together { pair, ends } => Self::Together { pair: both(pair), ends },
            Self::Mixed { along, closed, open, gap } => {
                Self::Mixed { along, closed: own(along)[closed], open: own(along)[open], gap }
            }
            Self::Crossing { along, curves, point } => {
                Self::Crossing { along, curves: curves.map(|index| own(along)[index]), point }
            }
            Self::Order { along, curve, others, at, crossing } => {
                let others = others.map(|index| own(along.other())[index]);
                Self::Order { along, curve: own(along)[curve], others, at, crossing }
            }
            as_it_is @ (Self::Point { .. } | Self::Input { .. } | Self::Geometry(_)) => as_it_is,
        }
    }
}

/// A place where two curves meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct NetworkCrossing {
    /// Parameter of the u-curve.
    pub(super) t: f64,
    /// Parameter of the v-curve.
    pub(super) s: f64,
}

/// Places on a curve that stand for its neighbourhood when it is searched for the nearest one.
const N_PLACES: usize = 64;

/// The longest part of a curve that two may run together where they only touch.
const TOUCH: f64 = 0.1;

/// Every meeting of two curves within the tolerance, ends first.
///
/// # Errors
/// [`NetworkError::Together`].
pub(super) fn meets(
    c: &NurbsCurve,
    d: &NurbsCurve,
    tolerance: f64,
    pair: [usize; 2],
) -> Result<Vec<NetworkCrossing>, NetworkError> {
    let ends = |curve: &NurbsCurve| [curve.domain().start(), curve.domain().end()];
    let mut found: Vec<NetworkCrossing> = Vec::new();
    let near = |curve: &NurbsCurve, a: f64, b: f64| {
        let same = PLACE_RELATIVE * curve.domain().length();
        (a - b).abs() <= same
            || curve.point_at(a).distance(curve.point_at(b)) <= 4.0 * tolerance
                && (a - b).abs() <= ONE_MEETING_SHARE * curve.domain().length()
    };
    let add = |found: &mut Vec<NetworkCrossing>, meet: NetworkCrossing| {
        let is_told =
            found.iter().any(|other| near(c, other.t, meet.t) && near(d, other.s, meet.s));
        if !is_told {
            found.push(meet);
        }
    };
    // Ends on ends, then ends on the other curve, then what lies inside both.
    for t in ends(c) {
        for s in ends(d) {
            if c.point_at(t).distance(d.point_at(s)) <= tolerance {
                add(&mut found, NetworkCrossing { t, s });
            }
        }
    }
    for t in ends(c) {
        let foot = d.closest(c.point_at(t), tolerance);
        if foot.distance <= tolerance {
            add(&mut found, NetworkCrossing { t, s: foot.parameter });
        }
    }
    for s in ends(d) {
        let foot = c.closest(d.point_at(s), tolerance);
        if foot.distance <= tolerance {
            add(&mut found, NetworkCrossing { t: foot.parameter, s });
        }
    }
    match c.intersections(d, tolerance) {
        Ok(inside) => {
            for meeting in inside {
                add(&mut found, NetworkCrossing { t: meeting.first, s: meeting.second });
            }
        }
        Err(GeomError::Intersection(IntersectionError::RunTogether { start, end })) => {
            let mut ends = [start, end].map(|t| c.point_at(t));
            // Where it was found may be longer on one than on the other.
            if let Err(GeomError::Intersection(IntersectionError::RunTogether { start, end })) =
                d.intersections(c, tolerance)
            {
                let others = [start, end].map(|s| d.point_at(s));
                if others[0].distance(others[1]) < ends[0].distance(ends[1]) {
                    ends = others;
                }
            }
            // Curves that touch are together for a while, within the tolerance.
            let size = c.bounds().diagonal().min(d.bounds().diagonal());
            if found.len() != 1 || TOUCH < ends[0].distance(ends[1]) / size {
                return Err(NetworkError::Together { pair, ends });
            }
        }
        Err(other) => return Err(other.into()),
    }
    Ok(found)
}

/// Tells of those of these pairs that are furthest apart.
pub(super) fn apart(
    pairs: &[[usize; 2]],
    us: &[NurbsCurve],
    vs: &[NurbsCurve],
    tolerance: f64,
) -> Option<NetworkError> {
    let each = pairs.iter().take(DISTANT_PAIRS).map(|&pair| {
        let (at, point, gap) = nearest(&us[pair[0]], &vs[pair[1]], tolerance);
        (pair, at, point, gap)
    });
    let (pair, at, point, gap) = each.max_by(|a, b| a.3.total_cmp(&b.3))?;
    let (n_pairs, are_all) = (pairs.len(), pairs.len() == us.len() * vs.len());
    Some(NetworkError::Apart { pair, gap, at, point, n_pairs, are_all })
}

/// Fails where a family has both closed and open curves.
pub(super) fn check_alike(
    curves: &[NurbsCurve],
    along: Direction,
    tolerance: f64,
) -> Result<(), NetworkError> {
    let find = |wanted: bool| curves.iter().position(|c| c.is_closed(tolerance) == wanted);
    let (Some(closed), Some(open)) = (find(true), find(false)) else { return Ok(()) };
    let gap = curves[open].start().distance(curves[open].end());
    Err(NetworkError::Mixed { along, closed, open, gap })
}

/// Where two curves are nearest, found from many places.
fn nearest(c: &NurbsCurve, d: &NurbsCurve, tolerance: f64) -> ([f64; 2], DVec3, f64) {
    let mut best = ([c.domain().start(), d.domain().start()], DVec3::ZERO, f64::INFINITY);
    let steps = d.domain().steps(N_PLACES);
    let starts: Vec<f64> = steps;
    for s in starts {
        let mut s = s;
        for _ in 0..8 {
            let foot = c.closest(d.point_at(s), tolerance);
            if foot.distance < best.2 {
                let middle = foot.point.midpoint(d.point_at(s));
                best = ([foot.parameter, s], middle, foot.distance);
            } else {
                break;
            }
            s = d.closest(foot.point, tolerance).parameter;
        }
    }
    best
}

/// One meeting for each pair, by u-curve and v-curve, out of all there are.
///
/// Pairs that meet once are clear; where there are several, that counts which is nearest to where
/// the other u-curves meet the same v-curve, by the fractions of their domains.
///
/// # Errors
/// [`NetworkError::Ambiguous`].
pub(super) fn chosen(
    all: &[Vec<Vec<NetworkCrossing>>],
    us: &[NurbsCurve],
    vs: &[NurbsCurve],
) -> Result<Vec<Vec<NetworkCrossing>>, NetworkError> {
    let fraction = |curve: &NurbsCurve, t: f64| curve.domain().fraction_of(t);
    let mean = |values: Vec<f64>| match values.len() {
        0 => None,
        n => Some(values.iter().sum::<f64>() / n as f64),
    };
    let choose = |k: usize, l: usize| {
        let own = &all[k][l];
        if let [only] = own[..] {
            return Ok(only);
        }
        let ambiguous = || NetworkError::Ambiguous {
            pair: [k, l],
            at: own.iter().map(|m| ([m.t, m.s], us[k].point_at(m.t))).collect(),
        };
        let clear =
            |meets: &Vec<NetworkCrossing>| if let [only] = meets[..] { Some(only) } else { None };
        let column = (0..us.len()).filter_map(|i| clear(&all[i][l]).map(|m| fraction(&us[i], m.t)));
        let row = (0..vs.len()).filter_map(|j| clear(&all[k][j]).map(|m| fraction(&vs[j], m.s)));
        let (t, s) = (mean(column.collect()), mean(row.collect()));
        if t.is_none() && s.is_none() {
            return Err(ambiguous());
        }
        let miss = |meet: &NetworkCrossing| {
            let by =
                |wanted: Option<f64>, got: f64| wanted.map_or(0.0, |wanted| (wanted - got).abs());
            by(t, fraction(&us[k], meet.t)) + by(s, fraction(&vs[l], meet.s))
        };
        let mut sorted: Vec<(f64, NetworkCrossing)> =
            own.iter().map(|meet| (miss(meet), *meet)).collect();
        sort_by(&mut sorted, |a, b| a.0.total_cmp(&b.0));
        match sorted[..] {
            [(best, meet), (second, _), ..] if 2.0 * best < second => Ok(meet),
            _ => Err(ambiguous()),
        }
    };
    (0..us.len()).map(|k| (0..vs.len()).map(|l| choose(k, l)).collect()).collect()
}
