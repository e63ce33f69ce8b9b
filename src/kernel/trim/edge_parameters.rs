//! Curves of parameters over the parameter of an edge, as exchange files want them.
//!
//! What lies along a line of constant parameters is straight. An arc of parameters of which the edge was made runs as
//! the edge does. Any other is followed: to each place of the edge the one of the arc that is beside it, and through
//! such places polynomials, over pieces that are halved until they keep to the arc.

use glam::{DVec2, DVec3};

use crate::{
    AnalyticChart, AnalyticCurve, GeomError, Interval, KnotVector, NurbsCurve, NurbsSurface,
    ceiling::{NEWTON_STEPS, WRITTEN_HALVINGS},
    frame::norm,
    numeric::{linear::solve_linear, newton},
    tolerance::{EDGE_SHARE, PARAMETER_RELATIVE, VANISHING_RELATIVE, WRITTEN_LOOK, WRITTEN_SHARE},
};

use super::{arc_of_parameters::ParameterArc, pull::chebyshev_fraction};

/// The degree of the polynomials.
const DEGREE: usize = 7;

/// Halvings after which each must bring a piece nearer by a factor.
const LEAST_HALVINGS: usize = 3;
const GAIN: f64 = 0.7;

/// Fractions of a piece at which it is compared with the arc.
const COMPARED_AT: [f64; 4] = [WRITTEN_LOOK, 0.3, 0.55, 0.9];

/// Parts of each span at whose ends a curve is compared with the edge.
const SPAN_PARTS: usize = 6;

/// Parts into which an edge is cut at least: less than a right angle of a circle.
const LEAST_PARTS: usize = 8;

/// An edge as it is written: a line or circle by length or angle from its start, any other curve by its parameter.
///
/// ```
/// use virote_kernel::{EdgePath, Frame, NurbsCurve};
///
/// let circle = NurbsCurve::arc(Frame::XY, 2.0, 0.0, std::f64::consts::TAU)?;
/// let by_angle = EdgePath::new(&circle, circle.analytic());
/// assert!((by_angle.domain().end() - std::f64::consts::TAU).abs() < 1e-14);
/// assert_eq!(EdgePath::new(&circle, None).domain(), circle.domain());
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct EdgePath<'a> {
    curve: &'a NurbsCurve,
    analytic: Option<AnalyticCurve>,
}

impl<'a> EdgePath<'a> {
    /// Of a curve, by its equation where that is given.
    #[must_use]
    pub fn new(curve: &'a NurbsCurve, analytic: Option<AnalyticCurve>) -> Self {
        Self { curve, analytic }
    }

    /// From its start to its end.
    #[must_use]
    pub fn domain(&self) -> Interval {
        let last = match self.analytic {
            None => return self.curve.domain(),
            Some(AnalyticCurve::Line { length, .. }) => length,
            Some(AnalyticCurve::Circle { turn, .. }) => turn,
        };
        Interval::new(0.0, last).unwrap_or(self.curve.domain())
    }

    /// A point and the first derivative there.
    fn at(&self, t: f64) -> [DVec3; 2] {
        match self.analytic {
            None => {
                let found = self.curve.derivatives_at(t, 1);
                [found[0], found[1]]
            }
            Some(AnalyticCurve::Line { start, direction, .. }) => {
                [start + direction * t, direction]
            }
            Some(AnalyticCurve::Circle { frame, radius, .. }) => {
                let [x, y] = [frame.x(), frame.y()].map(|axis| axis * radius);
                let (sine, cosine) = (libm::sin(t), libm::cos(t));
                [frame.origin() + x * cosine + y * sine, y * cosine - x * sine]
            }
        }
    }

    /// About where a point beside it is.
    fn foot(&self, point: DVec3, distance: f64) -> f64 {
        match self.analytic {
            None => self.curve.closest(point, distance).parameter,
            Some(AnalyticCurve::Line { start, direction, .. }) => (point - start).dot(direction),
            Some(AnalyticCurve::Circle { frame, .. }) => {
                let out = point - frame.origin();
                let angle = libm::atan2(out.dot(frame.y()), out.dot(frame.x()));
                if angle < 0.0 { angle + std::f64::consts::TAU } else { angle }
            }
        }
    }
}

/// The surface of a face, by its own parameters or those of its equation.
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{EdgePath, Face, FaceChart, Frame, NurbsSurface, ParameterArc, Tolerance};
///
/// let tube = NurbsSurface::cone(Frame::XY, [1.0, 1.0], 5.0)?;
/// let face = Face::whole(Arc::new(tube.clone()), Tolerance::DEFAULT)?;
/// let edge = &face.part_edges(Tolerance::DEFAULT)?[0][0][0];
/// let rim = edge.curve.as_ref().expect("a circle");
/// let equation = tube.analytic(1e-9).map(|found| tube.analytic_chart(&found));
/// let chart = FaceChart { surface: &tube, equation };
/// let arc = ParameterArc::whole(edge.parameters.clone());
/// let path = EdgePath::new(rim, rim.analytic());
/// let line = chart.along(&arc, &path, 1e-6)?.expect("a line");
/// assert!((line.end().x - std::f64::consts::TAU).abs() < 1e-14 && line.degree() == 1);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct FaceChart<'a> {
    /// The surface.
    pub surface: &'a NurbsSurface,
    /// How its parameters are those of its equation, where that is what is written.
    pub equation: Option<AnalyticChart<'a>>,
}

impl FaceChart<'_> {
    fn place(&self, at: DVec3) -> DVec2 {
        match &self.equation {
            Some(chart) => chart.place(self.inside(at)),
            None => at.truncate(),
        }
    }

    fn point(&self, place: DVec2) -> DVec3 {
        match &self.equation {
            Some(chart) => chart.point_at(place),
            None => self.own_point(place.extend(0.0)),
        }
    }

    fn own_point(&self, at: DVec3) -> DVec3 {
        let [u, v] = self.inside(at);
        self.surface.point_at(u, v)
    }

    fn inside(&self, at: DVec3) -> [f64; 2] {
        let [u, v] = [self.surface.domain_u(), self.surface.domain_v()];
        [at.x.clamp(u.start(), u.end()), at.y.clamp(v.start(), v.end())]
    }

    /// An arc of parameters of the surface over the parameter of an edge, in the plane z = 0 of the parameters that are
    /// written: at each parameter of the edge its place is beside that of the edge, within a quarter of `distance`.
    ///
    /// None where it leaves the edge by more, or no polynomials keep to it.
    ///
    /// # Errors
    /// `GeomError::Ended`; those of [`NurbsCurve::new`].
    pub fn along(
        &self,
        arc: &ParameterArc,
        path: &EdgePath<'_>,
        distance: f64,
    ) -> Result<Option<NurbsCurve>, GeomError> {
        let followed = FollowedArc { chart: self, arc, path, distance };
        if arc.is_straight() {
            let ends = arc.range.map(|t| self.place(arc.curve.point_at(t)).extend(0.0));
            if let Ok(line) = NurbsCurve::line(ends[0], ends[1]) {
                let line = line.reparametrized(path.domain());
                if followed.is_beside(&line)? {
                    return Ok(Some(line));
                }
            }
        }
        if self.equation.is_none()
            && let Some(own) = arc.as_curve()
        {
            let own = own.reparametrized(path.domain());
            if followed.is_beside(&own)? {
                return Ok(Some(own));
            }
        }
        followed.through_places()
    }
}

/// An arc of parameters beside an edge.
struct FollowedArc<'a> {
    chart: &'a FaceChart<'a>,
    arc: &'a ParameterArc,
    path: &'a EdgePath<'a>,
    distance: f64,
}

impl FollowedArc<'_> {
    /// Whether a curve of written parameters runs as the edge does.
    fn is_beside(&self, curve: &NurbsCurve) -> Result<bool, GeomError> {
        let knots = curve.knots();
        for span in knots.spans() {
            GeomError::go_on(1)?;
            for t in knots
                .span_interval(span)
                .steps(SPAN_PARTS.max(LEAST_PARTS * 8 / knots.breaks().len()))
            {
                let point = self.chart.point(curve.point_at(t).truncate());
                let gap = norm(point - self.path.at(t)[0]);
                if 2.0 * EDGE_SHARE * self.distance < gap {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }

    /// The place in the arc beside a place of the edge, between two of its parameters.
    fn arc_parameter(&self, t: f64, [from, to]: [f64; 2], fraction: f64) -> f64 {
        let [point, along] = self.path.at(t);
        let domain = self.arc.curve.domain();
        let inside = |part: f64| (from + (to - from) * part).clamp(domain.start(), domain.end());
        // From the start to the end of the bracket it goes along the edge, which its parameter need not.
        let part = newton::within_bracket(
            [0.0, 1.0],
            fraction,
            NEWTON_STEPS,
            |a, b| (a - b).abs() <= VANISHING_RELATIVE,
            |part| {
                let found = self.arc.curve.derivatives_at(inside(part), 1);
                let [u, v] = self.chart.inside(found[0]);
                let [place, by_u, by_v] = self.chart.surface.tangents_at(u, v);
                let slope = (by_u * found[1].x + by_v * found[1].y) * (to - from);
                let [value, slope] = [(place - point).dot(along), slope.dot(along)];
                (value != 0.0).then_some([value, slope])
            },
        );
        inside(part)
    }

    /// The written place beside a place of the edge.
    fn place(&self, t: f64, bracket: [f64; 2], fraction: f64) -> DVec2 {
        let at = self.arc_parameter(t, bracket, fraction);
        self.written(t, at)
    }

    /// The written place at a parameter of the arc, which is that of the edge where both have an equation.
    fn written(&self, t: f64, at: f64) -> DVec2 {
        let place = self.chart.place(self.arc.curve.point_at(at));
        match (&self.chart.equation, self.path.analytic) {
            (Some(chart), Some(_)) => chart.place_of(self.path.at(t)[0], place),
            _ => place,
        }
    }

    /// Parameters of the edge and of the arc beside one another: at both ends, where either has knots, and between.
    fn stops(&self) -> Vec<[f64; 2]> {
        let domain = self.path.domain();
        let [from, to] = self.arc.range;
        let mut stops = vec![[domain.start(), from]];
        let least = PARAMETER_RELATIVE * domain.length();
        for at in self.arc.breaks() {
            let foot =
                self.path.foot(self.chart.own_point(self.arc.curve.point_at(at)), self.distance);
            let last = stops[stops.len() - 1][0];
            if last + least < foot && foot < domain.end() - least {
                stops.push([foot, at]);
            }
        }
        stops.push([domain.end(), to]);
        let knots = match self.path.analytic {
            None => self.path.curve.knots().breaks(),
            Some(_) => Vec::new(),
        };
        let mut extra: Vec<f64> = knots.into_iter().chain(domain.steps(LEAST_PARTS)).collect();
        extra.sort_by(f64::total_cmp);
        let mut all = Vec::with_capacity(stops.len() + extra.len());
        for pair in stops.windows(2) {
            all.push(pair[0]);
            let mut last = pair[0];
            for &t in extra.iter().filter(|&&t| pair[0][0] + least < t && t < pair[1][0] - least) {
                if last[0] + least < t {
                    let fraction = (t - last[0]) / (pair[1][0] - last[0]);
                    last = [t, self.arc_parameter(t, [last[1], pair[1][1]], fraction)];
                    all.push(last);
                }
            }
        }
        all.push([domain.end(), to]);
        all
    }

    /// A spline of polynomials through places of the arc.
    fn through_places(&self) -> Result<Option<NurbsCurve>, GeomError> {
        let Some(inverse) = inverse_of_nodes() else { return Ok(None) };
        let size = self.chart.surface.bounds().magnitude();
        let finest = (WRITTEN_SHARE * self.distance).max(VANISHING_RELATIVE * size);
        let mut knots = vec![self.path.domain().start(); DEGREE + 1];
        let mut points: Vec<DVec3> = Vec::new();
        for pair in self.stops().windows(2) {
            let mut left = vec![(pair[0], pair[1], 0, f64::INFINITY)];
            while let Some((one, other, n_halvings, before)) = left.pop() {
                GeomError::go_on(DEGREE)?;
                let (piece, gap) = self.piece(one, other, &inverse);
                // Where halves are no nearer than the whole was, their halves are not either.
                let gains = n_halvings < LEAST_HALVINGS || gap < GAIN * before;
                if finest < gap && gains && n_halvings < WRITTEN_HALVINGS {
                    let t = 0.5 * (one[0] + other[0]);
                    let middle = [t, self.arc_parameter(t, [one[1], other[1]], 0.5)];
                    left.extend([
                        (middle, other, n_halvings + 1, gap),
                        (one, middle, n_halvings + 1, gap),
                    ]);
                    continue;
                }
                if 2.0 * EDGE_SHARE * self.distance < gap {
                    return Ok(None);
                }
                points.extend(piece.iter().skip(usize::from(!points.is_empty())));
                knots.extend([other[0]; DEGREE]);
            }
        }
        knots.push(self.path.domain().end());
        let knots = KnotVector::new(DEGREE, knots)?;
        let points = points.into_iter().map(|point| point.extend(1.0)).collect();
        let found = NurbsCurve::new(knots, points)?;
        Ok(self.is_beside(&found)?.then_some(found))
    }

    /// The Bézier points of a polynomial between two stops, and how far it is from the arc in space at most.
    fn piece(&self, one: [f64; 2], other: [f64; 2], inverse: &[Vec<f64>]) -> (Vec<DVec3>, f64) {
        let bracket = [one[1], other[1]];
        let at = |fraction: f64| one[0] + (other[0] - one[0]) * fraction;
        let place = |fraction: f64| self.place(at(fraction), bracket, fraction);
        let nodes = (0..=DEGREE).map(|k| match k {
            0 => self.written(one[0], one[1]),
            DEGREE => self.written(other[0], other[1]),
            k => place(chebyshev_fraction(k, DEGREE)),
        });
        let nodes: Vec<DVec2> = nodes.collect();
        let combined = |row: &Vec<f64>| {
            let sum: DVec2 = row.iter().zip(&nodes).map(|(&weight, &node)| node * weight).sum();
            sum.extend(0.0)
        };
        let mut points: Vec<DVec3> = inverse.iter().map(combined).collect();
        points[0] = nodes[0].extend(0.0);
        points[DEGREE] = nodes[DEGREE].extend(0.0);
        let gap = |fraction: f64| {
            let weights = bernstein(fraction);
            let own: DVec3 = weights.iter().zip(&points).map(|(&b, &point)| point * b).sum();
            norm(self.chart.point(own.truncate()) - self.chart.point(place(fraction)))
        };
        let gaps = COMPARED_AT.map(gap);
        let is_known = gaps.iter().all(|gap| gap.is_finite());
        let most = if is_known { gaps.into_iter().fold(0.0, f64::max) } else { f64::INFINITY };
        (points, most)
    }
}

/// The Bernstein polynomials at a fraction.
fn bernstein(t: f64) -> [f64; DEGREE + 1] {
    let mut values = [0.0; DEGREE + 1];
    values[0] = 1.0;
    for n in 1..=DEGREE {
        for i in (0..=n).rev() {
            let before = if i == 0 { 0.0 } else { values[i - 1] };
            values[i] = (1.0 - t) * if i == n { 0.0 } else { values[i] } + t * before;
        }
    }
    values
}

/// What makes Bézier points of places at Chebyshev's nodes.
fn inverse_of_nodes() -> Option<Vec<Vec<f64>>> {
    let rows = (0..=DEGREE).map(|k| bernstein(chebyshev_fraction(k, DEGREE)).to_vec());
    let matrix: Vec<Vec<f64>> = rows.collect();
    let column = |k: usize| {
        let unit = (0..=DEGREE).map(|i| if i == k { 1.0 } else { 0.0 }).collect();
        solve_linear(matrix.clone(), unit)
    };
    let columns: Vec<Vec<f64>> = (0..=DEGREE).map(column).collect::<Option<_>>()?;
    Some((0..=DEGREE).map(|i| columns.iter().map(|column| column[i]).collect()).collect())
}
