//! Quintic spline surfaces through points of an offset, on knots that are halved where needed.

use glam::{DVec3, DVec4};

use crate::{
    Direction, FitError, GeomError, Grid, Interpolator, Interval, KnotVector, NurbsSurface,
    Surface,
    ceiling::{OFFSET_LINES, OFFSET_PATCHES},
};

/// Degree of the spline.
const DEGREE: usize = 5;

/// Places of a span, along each direction, at which the distance is measured.
const N_PLACES: usize = 4;

/// Part of the tolerance that a patch may use up there, so that it holds between them.
const SAFETY: f64 = 0.5;

/// Spans that a function begins with, which has no knots.
const FUNCTION_SPANS: usize = 4;

/// What the offset needs to know besides the knots.
#[derive(Clone, Copy)]
pub(super) struct SurfaceOffsetTarget<'a> {
    pub(super) surface: &'a Surface,
    pub(super) distance: f64,
    pub(super) tolerance: f64,
}

impl SurfaceOffsetTarget<'_> {
    /// The point of the true offset.
    pub(super) fn point(self, u: f64, v: f64) -> Result<DVec3, GeomError> {
        let point = self.surface.point_at(u, v)?;
        Ok(point + self.surface.normal_at(u, v)? * self.distance)
    }

    /// The point at a parameter of one direction and one of the other.
    fn point_along(self, along: Direction, t: f64, across: f64) -> Result<DVec3, GeomError> {
        match along {
            Direction::U => self.point(t, across),
            Direction::V => self.point(across, t),
        }
    }
}

/// The largest distance and where it is, and the sum of all that were measured.
#[derive(Clone, Copy, Debug)]
pub(super) struct LargestDeviation {
    pub(super) distance: f64,
    pub(super) at: [f64; 2],
    sum: f64,
    n_places: usize,
}

impl LargestDeviation {
    fn at(u: f64, v: f64) -> Self {
        Self { distance: 0.0, at: [u, v], sum: 0.0, n_places: 0 }
    }

    fn take(&mut self, other: Self) {
        if self.distance < other.distance || self.n_places == 0 {
            (self.distance, self.at) = (other.distance, other.at);
        }
        self.sum += other.sum;
        self.n_places += other.n_places;
    }

    pub(super) fn mean(self) -> f64 {
        self.sum / self.n_places.max(1) as f64
    }
}

/// The spans of a surface along both directions.
pub(super) struct SpanLayout {
    spans: [Vec<Interval>; 2],
}

impl SpanLayout {
    pub(super) fn of(surface: &NurbsSurface) -> Self {
        let spans = |along: Direction| {
            let knots = surface.knots(along);
            knots.spans().map(|span| knots.span_interval(span)).collect()
        };
        Self { spans: Direction::BOTH.map(spans) }
    }

    /// How far the surface is at most from the true offset at inner places of every patch; the
    /// search ends at the first one above `enough`.
    pub(super) fn worst(
        &self,
        surface: &NurbsSurface,
        aim: SurfaceOffsetTarget<'_>,
        enough: Option<f64>,
    ) -> Result<LargestDeviation, GeomError> {
        let mut worst =
            LargestDeviation::at(surface.domain_u().start(), surface.domain_v().start());
        for &u in &self.spans[0] {
            for &v in &self.spans[1] {
                worst.take(worst_of_patch(surface, aim, [u, v])?);
                if enough.is_some_and(|enough| enough < worst.distance) {
                    return Ok(worst);
                }
            }
        }
        Ok(worst)
    }
}

fn worst_of_patch(
    surface: &NurbsSurface,
    aim: SurfaceOffsetTarget<'_>,
    [span_u, span_v]: [Interval; 2],
) -> Result<LargestDeviation, GeomError> {
    let mut worst = LargestDeviation::at(span_u.start(), span_v.start());
    for u in inner_places(span_u) {
        for v in inner_places(span_v) {
            let distance = surface.point_at(u, v).distance(aim.point(u, v)?);
            worst.take(LargestDeviation { distance, at: [u, v], sum: distance, n_places: 1 });
        }
    }
    Ok(worst)
}

fn inner_places(span: Interval) -> impl Iterator<Item = f64> {
    (0..N_PLACES).map(move |i| span.at((i as f64 + 0.5) / N_PLACES as f64))
}

/// The spline near the offset, and how far it is.
pub(super) fn fitted(
    aim: SurfaceOffsetTarget<'_>,
) -> Result<(NurbsSurface, LargestDeviation), GeomError> {
    let start = Direction::BOTH.map(|along| start_knots(aim.surface, along));
    let [u, v] = start;
    let lines = [lines_across(&v?), lines_across(&u?)];
    let [mut knots_u, mut knots_v] =
        [along_lines(aim, Direction::U, &lines[0])?, along_lines(aim, Direction::V, &lines[1])?];
    loop {
        let surface = through(aim, &knots_u, &knots_v)?;
        let SpanLayout { spans: [spans_u, spans_v] } = SpanLayout::of(&surface);
        let mut worst =
            LargestDeviation::at(surface.domain_u().start(), surface.domain_v().start());
        let (mut to_halve_u, mut to_halve_v) =
            (vec![false; spans_u.len()], vec![false; spans_v.len()]);
        for (i, &u) in spans_u.iter().enumerate() {
            for (j, &v) in spans_v.iter().enumerate() {
                GeomError::go_on(1)?;
                let of_patch = worst_of_patch(&surface, aim, [u, v])?;
                worst.take(of_patch);
                let is_far = SAFETY * aim.tolerance < of_patch.distance;
                to_halve_u[i] |= is_far;
                to_halve_v[j] |= is_far;
            }
        }
        if !to_halve_u.contains(&true) {
            return Ok((surface, worst));
        }
        knots_u = halved(&knots_u, &spans_u, &to_halve_u, aim, worst.at)?;
        knots_v = halved(&knots_v, &spans_v, &to_halve_v, aim, worst.at)?;
        if OFFSET_PATCHES < knots_u.spans().count() * knots_v.spans().count() {
            return Err(far(aim, worst.at));
        }
    }
}

fn far(aim: SurfaceOffsetTarget<'_>, [u, v]: [f64; 2]) -> GeomError {
    GeomError::Fit(FitError::NoSurfaceNear { most: OFFSET_PATCHES, tolerance: aim.tolerance, u, v })
}

/// The surface through the offset at the Greville parameters of the knots.
fn through(
    aim: SurfaceOffsetTarget<'_>,
    knots_u: &KnotVector,
    knots_v: &KnotVector,
) -> Result<NurbsSurface, GeomError> {
    let (us, vs) = (knots_u.greville(), knots_v.greville());
    let mut values = Vec::with_capacity(us.len() * vs.len());
    for &u in &us {
        for &v in &vs {
            values.push(aim.point(u, v)?.extend(1.0));
        }
    }
    let along_u = Interpolator::on_knots(&us, knots_u.clone())?;
    let along_v = Interpolator::on_knots(&vs, knots_v.clone())?;
    let net = tensor([&along_u, &along_v], &Grid::from_rows_of(vs.len(), values))?;
    NurbsSurface::polynomial(knots_u.clone(), knots_v.clone(), &net.map(|p| p.truncate()))
}

/// Knots of the surface's own breaks, each as often as the offset may be rough there: it is once
/// less smooth than the surface.
fn start_knots(surface: &Surface, along: Direction) -> Result<KnotVector, GeomError> {
    let domain = surface.domain(along);
    let inner: Vec<(f64, usize)> = match surface {
        Surface::Nurbs(surface) => {
            let knots = surface.knots(along);
            let is_inner = |&(t, _): &(f64, usize)| domain.start() < t && t < domain.end();
            let times = |(t, times): (f64, usize)| {
                let order = knots.degree().saturating_sub(times).saturating_sub(1);
                (t, DEGREE.saturating_sub(order).max(1))
            };
            knots.distinct().into_iter().filter(is_inner).map(times).collect()
        }
        Surface::Parametric(_) => {
            let steps = domain.steps(FUNCTION_SPANS);
            steps[1..FUNCTION_SPANS].iter().map(|&t| (t, 1)).collect()
        }
    };
    let inner = inner.into_iter().flat_map(|(t, times)| vec![t; times]).collect::<Vec<f64>>();
    let [start, end] = [domain.start(), domain.end()].map(|t| vec![t; DEGREE + 1]);
    KnotVector::new(DEGREE, [start, inner, end].concat())
}

/// Parameters of lines on which knots of the other direction are looked for: the breaks and the
/// middles between them, but not too many.
fn lines_across(knots: &KnotVector) -> Vec<f64> {
    let breaks = knots.breaks();
    let middles = breaks.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    let mut lines: Vec<f64> = breaks.iter().copied().chain(middles).collect();
    lines.sort_by(f64::total_cmp);
    let step = lines.len().div_ceil(OFFSET_LINES);
    lines.into_iter().step_by(step).collect()
}

/// Knots along a direction on which single splines keep the tolerance on the lines.
fn along_lines(
    aim: SurfaceOffsetTarget<'_>,
    along: Direction,
    lines: &[f64],
) -> Result<KnotVector, GeomError> {
    let mut knots = start_knots(aim.surface, along)?;
    loop {
        let fit = Interpolator::on_knots(&knots.greville(), knots.clone())?;
        let spans: Vec<Interval> = knots.spans().map(|span| knots.span_interval(span)).collect();
        let mut to_halve = vec![false; spans.len()];
        let mut place = [0.0; 2];
        for &line in lines {
            GeomError::go_on(spans.len())?;
            let values: Result<Vec<DVec4>, GeomError> = knots
                .greville()
                .iter()
                .map(|&t| Ok(aim.point_along(along, t, line)?.extend(1.0)))
                .collect();
            let points = fit.through(&values?)?;
            for (i, &span) in spans.iter().enumerate() {
                if to_halve[i] {
                    continue;
                }
                for t in inner_places(span) {
                    let found = value(&knots, &points, t);
                    if SAFETY * aim.tolerance < found.distance(aim.point_along(along, t, line)?) {
                        to_halve[i] = true;
                        place = match along {
                            Direction::U => [t, line],
                            Direction::V => [line, t],
                        };
                        break;
                    }
                }
            }
        }
        if !to_halve.contains(&true) {
            return Ok(knots);
        }
        knots = halved(&knots, &spans, &to_halve, aim, place)?;
    }
}

/// The point of a spline.
fn value(knots: &KnotVector, points: &[DVec4], t: f64) -> DVec3 {
    knots.with_basis(t, |span, basis| {
        let support = &points[knots.support(span)];
        let sum = support.iter().zip(basis).fold(DVec4::ZERO, |sum, (&p, &n)| sum + p * n);
        sum.truncate()
    })
}

/// The knots with one more in the middle of each marked span.
fn halved(
    knots: &KnotVector,
    spans: &[Interval],
    marked: &[bool],
    aim: SurfaceOffsetTarget<'_>,
    place: [f64; 2],
) -> Result<KnotVector, GeomError> {
    let middles: Vec<f64> =
        spans.iter().zip(marked).filter(|pair| *pair.1).map(|(span, _)| span.at(0.5)).collect();
    let more = [knots.as_slice(), &middles].concat();
    let mut more = more;
    more.sort_by(f64::total_cmp);
    let n_before = spans.len();
    match KnotVector::new(DEGREE, more) {
        // Where the middle is no new knot any more, the span has no width left.
        Ok(new)
            if new.spans().count() == n_before + middles.len()
                && new.spans().count() <= OFFSET_PATCHES =>
        {
            Ok(new)
        }
        _ => Err(far(aim, place)),
    }
}

/// Control points of the tensor-product spline through a grid of values.
pub(super) fn tensor(
    fits: [&Interpolator; 2],
    values: &Grid<DVec4>,
) -> Result<Grid<DVec4>, GeomError> {
    let columns: Result<Vec<Vec<DVec4>>, GeomError> =
        (0..values.n_columns()).map(|j| fits[0].through(&values.column(j))).collect();
    let strip = Grid::from_rows(columns?)?.transposed();
    let rows: Result<Vec<Vec<DVec4>>, GeomError> =
        (0..strip.n_rows()).map(|i| fits[1].through(strip.row(i))).collect();
    Grid::from_rows(rows?)
}
