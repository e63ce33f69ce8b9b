//! Bounds of the derivatives of a surface, piece by piece.
//!
//! A piece is a Bézier patch, or a part of one. Its homogeneous derivatives are inside the hulls of
//! their control vectors; those in space follow by the quotient rule, taken about the middle of the
//! piece so that little of it is lost. Second derivatives are those in the middle and no more than
//! half of a piece of third ones further, where that is less.
//! Piegl & Tiller, *The NURBS Book*, (4.8); Filip, Magedson & Markot, *Surface algorithms using
//! bounds on derivatives*, CAGD 3 (1986).

use glam::{DVec3, DVec4};

use crate::kernel::{
    Direction, Grid, Interval, KnotVector, NurbsSurface, bezier, frame::unit, homogeneous::place,
};

/// Pieces along one direction, about: of a polynomial, and of a rational surface, whose bounds are
/// wider.
const PIECES: usize = 16;
const RATIONAL_PIECES: usize = 48;

/// Quarterings of a piece whose weights are not all positive: the denominator is, so that some
/// refinement of them is.
const MAX_QUARTERINGS: usize = 12;

/// Orders of derivatives that are looked at, from none to three.
const ORDERS: usize = 4;

/// Bounds by orders along u and along v.
type Sizes = [[f64; ORDERS]; ORDERS];

/// The binomial coefficients that Leibniz' rule needs.
const CHOOSE: [[f64; ORDERS]; ORDERS] =
    [[1.0, 0.0, 0.0, 0.0], [1.0, 1.0, 0.0, 0.0], [1.0, 2.0, 1.0, 0.0], [1.0, 3.0, 3.0, 1.0]];

/// The pieces of a surface with what bounds its derivatives there.
#[derive(Debug)]
pub(super) struct Bends {
    /// Where the pieces along u and along v begin and end.
    pub(super) ends: [Vec<f64>; 2],
    pub(super) pieces: Grid<Bend>,
    /// The mean normal; none of a closed surface.
    pub(super) normal: Option<DVec3>,
}

/// Bounds over one piece, of derivatives by the parameters.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bend {
    /// Of the lengths of Suu, Suv and Svv.
    pub(super) second: [f64; 3],
    /// Of what they are along the mean normal.
    pub(super) lift: [f64; 3],
    /// Of the lengths of Su and Sv.
    pub(super) first: [f64; 2],
    /// How far Su and Sv may be from those in the middle.
    pub(super) spread: [f64; 2],
    /// The same of what they are along the mean normal.
    pub(super) lift_spread: [f64; 2],
    /// Su, Sv, Suu and Suv, Svv in the middle.
    pub(super) middle: [DVec3; 5],
}

impl Bends {
    pub(super) fn of(surface: &NurbsSurface) -> Self {
        let wanted = if surface.is_rational() { RATIONAL_PIECES } else { PIECES };
        let mut refined = surface.clone();
        for along in Direction::BOTH {
            let mut lines = refined.lines(along).clamped();
            let new = missing_knots(&lines.knots, wanted);
            if let Ok(more) = lines.clone().with_knots(&new) {
                lines = more;
            }
            refined = refined.with_lines(along, lines);
        }
        let spans = [refined.knots_u(), refined.knots_v()].map(|knots| {
            knots.spans().map(|span| (span, knots.span_interval(span))).collect::<Vec<_>>()
        });
        let normal = mean_normal(&refined, &spans);
        let about = normal.unwrap_or(DVec3::ZERO);
        let pieces = Grid::from_fn(spans[0].len(), spans[1].len(), |i, j| {
            let ((span_u, domain_u), (span_v, domain_v)) = (spans[0][i], spans[1][j]);
            let net = refined.control_points();
            let columns = refined.knots_v().support(span_v);
            let (first, n_columns) = (*columns.start(), columns.clone().count());
            let rows = refined.knots_u().support(span_u);
            let n_rows = rows.clone().count();
            let points = rows.flat_map(|row| net.row(row)[first..][..n_columns].iter().copied());
            let net = Grid::from_rows_of(n_columns, points.collect());
            debug_assert_eq!(net.n_rows(), n_rows);
            bend(surface, &net, [domain_u, domain_v], about, 0)
        });
        let ends = spans.map(|spans| {
            let starts = spans.iter().map(|(_, interval)| interval.start());
            starts.chain(spans.last().map(|(_, interval)| interval.end())).collect()
        });
        Self { ends, pieces, normal }
    }
}

/// The knots that make Bézier pieces of a clamped spline, about as many as wanted.
fn missing_knots(knots: &KnotVector, wanted: usize) -> Vec<f64> {
    let (degree, breaks) = (knots.degree(), knots.breaks());
    let n_parts = wanted.div_ceil(breaks.len().max(2) - 1).next_power_of_two();
    let mut missing = Vec::new();
    for pair in breaks.windows(2) {
        let times = if pair[0] <= breaks[0] { degree } else { knots.times(pair[0]) };
        missing.extend(vec![pair[0]; degree.saturating_sub(times)]);
        let Ok(span) = Interval::new(pair[0], pair[1]) else { continue };
        for t in span.steps(n_parts).into_iter().skip(1).take(n_parts - 1) {
            missing.extend(vec![t; degree]);
        }
    }
    missing
}

/// The direction of the sum of Su × Sv in the middles of the pieces.
fn mean_normal(surface: &NurbsSurface, spans: &[Vec<(usize, Interval)>; 2]) -> Option<DVec3> {
    let middles = |spans: &[(usize, Interval)]| -> Vec<(f64, f64)> {
        spans.iter().map(|(_, interval)| (interval.at(0.5), interval.length())).collect()
    };
    let (us, vs) = (middles(&spans[0]), middles(&spans[1]));
    let (mut sum, mut size) = (DVec3::ZERO, 0.0);
    for &(u, width_u) in &us {
        for &(v, width_v) in &vs {
            let [_, along_u, along_v] = surface.tangents_at(u, v);
            let area = along_u.cross(along_v) * (width_u * width_v);
            sum += area;
            size += area.length();
        }
    }
    unit(sum).filter(|_| 0.5 * size < sum.length())
}

/// The bounds over a piece with this net and these parameters.
fn bend(
    surface: &NurbsSurface,
    net: &Grid<DVec4>,
    domains: [Interval; 2],
    normal: DVec3,
    n_quarterings: usize,
) -> Bend {
    let center = place(net.get(net.n_rows() / 2, net.n_columns() / 2));
    match sizes(net, center, normal) {
        Some(sizes) => in_parameters(surface, sizes, domains, normal),
        None if n_quarterings < MAX_QUARTERINGS => {
            let (halves_u, halves_v) = (domains[0].halves(), domains[1].halves());
            let mut all = Bend::default();
            for (half, domain_u) in bezier::halves(net, true).iter().zip(halves_u) {
                for (quarter, domain_v) in bezier::halves(half, false).iter().zip(halves_v) {
                    let domains = [domain_u, domain_v];
                    let part = bend(surface, quarter, domains, normal, n_quarterings + 1);
                    all = all.union(part);
                }
            }
            all
        }
        None => Bend::UNBOUNDED,
    }
}

impl Bend {
    /// What is known of nothing.
    const UNBOUNDED: Self = Self {
        second: [f64::INFINITY; 3],
        lift: [f64::INFINITY; 3],
        first: [f64::INFINITY; 2],
        spread: [f64::INFINITY; 2],
        lift_spread: [f64::INFINITY; 2],
        middle: [DVec3::ZERO; 5],
    };

    /// Bounds over two pieces; the middle is that of the second one.
    fn union(self, other: Self) -> Self {
        fn max<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
            std::array::from_fn(|i| a[i].max(b[i]))
        }
        let first = max(self.first, other.first);
        Self {
            second: max(self.second, other.second),
            lift: max(self.lift, other.lift),
            first,
            spread: first.map(|length| 2.0 * length),
            lift_spread: first.map(|length| 2.0 * length),
            middle: other.middle,
        }
    }
}

/// Bounds by the parameters from those by fractions of the piece.
fn in_parameters(
    surface: &NurbsSurface,
    [full, lift]: [Sizes; 2],
    domains: [Interval; 2],
    normal: DVec3,
) -> Bend {
    let [u, v] = domains.map(|domain| domain.at(0.5));
    let [a, b] = domains.map(Interval::length);
    let middle = surface.derivatives_at(u, v, 2);
    // The bound of a derivative: that of the middle and half a piece of the next ones.
    let bound = |sizes: &Sizes, k: usize, l: usize, at_middle: f64| {
        let scale = libm::pow(a, k as f64) * libm::pow(b, l as f64);
        let spread = 0.5 * (sizes[k + 1][l] + sizes[k][l + 1]) / scale;
        ((at_middle + spread).min(sizes[k][l] / scale), spread)
    };
    let orders = [(2, 0), (1, 1), (0, 2)];
    let second = orders.map(|(k, l)| bound(&full, k, l, middle.get(k, l).length()).0);
    let lifts = orders.map(|(k, l)| bound(&lift, k, l, normal.dot(middle.get(k, l)).abs()).0);
    let slopes = [(1, 0), (0, 1)].map(|(k, l)| bound(&full, k, l, middle.get(k, l).length()));
    let half = |bends: [f64; 3], i: usize| 0.5 * (a * bends[i] + b * bends[i + 1]);
    Bend {
        second,
        lift: lifts,
        first: slopes.map(|(bound, _)| bound),
        spread: [0, 1].map(|i| half(second, i)),
        lift_spread: [0, 1].map(|i| half(lifts, i)),
        middle: [(1, 0), (0, 1), (2, 0), (1, 1), (0, 2)].map(|(k, l)| middle.get(k, l)),
    }
}

/// Bounds of the derivatives by fractions of a Bézier patch, of their lengths and of what they are
/// along a direction; none unless all weights are positive.
fn sizes(net: &Grid<DVec4>, center: DVec3, normal: DVec3) -> Option<[Sizes; 2]> {
    let least = net.iter().map(|point| point.w).fold(f64::INFINITY, f64::min);
    if least <= 0.0 || least.is_nan() {
        return None;
    }
    let (mut full, mut lift, mut weights) =
        ([[0.0; ORDERS]; ORDERS], [[0.0; ORDERS]; ORDERS], [[0.0; ORDERS]; ORDERS]);
    let (n_rows, n_columns) = (net.n_rows(), net.n_columns());
    let mut rows: Vec<DVec4> =
        net.iter().map(|&p| (p.truncate() - center * p.w).extend(p.w)).collect();
    for k in 0..ORDERS.min(n_rows) {
        if 0 < k {
            let degree = (n_rows - k) as f64;
            for i in 0..(n_rows - k) * n_columns {
                rows[i] = (rows[i + n_columns] - rows[i]) * degree;
            }
        }
        let mut all = rows.clone();
        for l in 0..(ORDERS - k).min(n_columns) {
            let width = n_columns - l;
            let (mut most, mut highest, mut heaviest) = (0.0_f64, 0.0_f64, 0.0_f64);
            for i in 0..n_rows - k {
                let row = &mut all[i * n_columns..][..width + 1 - usize::from(l == 0)];
                if 0 < l {
                    for j in 0..width {
                        row[j] = (row[j + 1] - row[j]) * width as f64;
                    }
                }
                for point in &row[..width] {
                    most = most.max(point.truncate().length_squared());
                    highest = highest.max(normal.dot(point.truncate()).abs());
                    heaviest = heaviest.max(point.w.abs());
                }
            }
            (full[k][l], lift[k][l], weights[k][l]) = (most.sqrt(), highest, heaviest);
        }
    }
    Some([quotient(full, &weights, least), quotient(lift, &weights, least)])
}

/// Bounds in space from homogeneous ones, by Leibniz' rule; `least` is a bound of the denominator
/// from below.
fn quotient(mut sizes: Sizes, weights: &Sizes, least: f64) -> Sizes {
    for k in 0..ORDERS {
        for l in 0..ORDERS - k {
            let mut sum = sizes[k][l];
            for i in 0..=k {
                for j in usize::from(i == 0)..=l {
                    sum += CHOOSE[k][i] * CHOOSE[l][j] * weights[i][j] * sizes[k - i][l - j];
                }
            }
            sizes[k][l] = sum / least;
        }
    }
    sizes
}
