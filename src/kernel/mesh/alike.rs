//! Pieces of a surface that are one piece, moved: of such one is bounded for all.
//!
//! The quarters of a circle that was turned, the teeth of a wheel, the steps along a cylinder: what
//! cells must keep to is the same over each of them, since lengths and angles are all that counts.

use std::ops::RangeInclusive;

use glam::{DMat3, DVec3};

use crate::{
    Direction, Grid, NurbsSurface,
    frame::unit,
    homogeneous::place,
    tolerance::{EXACT_RELATIVE, TOUCH_RELATIVE},
};

/// Spans are compared with so many that differ from one another, no more.
const MANY_KINDS: usize = 16;

/// Which pieces of a surface are alike, along u and along v.
#[derive(Clone, Debug)]
pub(super) struct AlikePieces {
    kinds: [Kinds; 2],
}

/// The kinds of the pieces along one direction.
#[derive(Clone, Debug)]
struct Kinds {
    /// That of each piece.
    of: Vec<usize>,
    /// The first piece of each.
    firsts: Vec<usize>,
}

/// What is over one span, all across, as a Bézier strip.
#[derive(Debug)]
struct Strip<'a> {
    /// The net with its lines across the direction as rows: places and weights.
    net: &'a Grid<(DVec3, f64)>,
    lines: RangeInclusive<usize>,
    /// How long the span is.
    length: f64,
}

/// Places in a strip that tell how it is turned: two far from one another, one far from their line.
#[derive(Clone, Copy, Debug)]
struct Anchors([[usize; 2]; 3]);

impl AlikePieces {
    /// Those of a surface in so many equal parts of each span; `strips` are the surface divided into Bézier strips,
    /// of steps along u and of steps along v.
    pub(super) fn of(strips: [&NurbsSurface; 2], n_parts: [usize; 2]) -> Self {
        let kinds = Direction::BOTH.map(|along| {
            let kinds = Kinds::of(strips[along], along, n_parts[along]);
            // In a plane it is told by directions whether pieces fold over one another.
            if is_flat(strips[along]) { Kinds::apart(kinds.of.len()) } else { kinds }
        });
        Self { kinds }
    }

    /// The same for so many pieces along u and along v; of another number none count as alike.
    pub(super) fn of_as_many(mut self, n_pieces: [usize; 2]) -> Self {
        for along in Direction::BOTH {
            if self.n_pieces(along) != n_pieces[along] {
                self.kinds[along] = Kinds::apart(n_pieces[along]);
            }
        }
        self
    }

    /// The same, where no two pieces along a direction count as alike.
    pub(super) fn told_apart(mut self, along: Direction) -> Self {
        self.kinds[along] = Kinds::apart(self.n_pieces(along));
        self
    }

    /// How many pieces there are along a direction.
    pub(super) fn n_pieces(&self, along: Direction) -> usize {
        self.kinds[along].of.len()
    }

    /// The first piece of each kind along a direction.
    pub(super) fn firsts(&self, along: Direction) -> &[usize] {
        &self.kinds[along].firsts
    }

    /// The kind of each piece along a direction.
    pub(super) fn kinds(&self, along: Direction) -> &[usize] {
        &self.kinds[along].of
    }

    /// The first piece along a direction that is like this one.
    pub(super) fn first_like(&self, along: Direction, piece: usize) -> usize {
        let kinds = &self.kinds[along];
        kinds.firsts[kinds.of[piece]]
    }

    /// What holds of each piece, found once for all that are alike.
    pub(super) fn grid<T: Copy>(&self, mut of: impl FnMut(usize, usize) -> T) -> Grid<T> {
        let [n_rows, n_columns] = Direction::BOTH.map(|along| self.n_pieces(along));
        let mut values = Vec::with_capacity(n_rows * n_columns);
        for i in 0..n_rows {
            let first = self.first_like(Direction::U, i);
            if first < i {
                values.extend_from_within(first * n_columns..(first + 1) * n_columns);
                continue;
            }
            for j in 0..n_columns {
                let first = self.first_like(Direction::V, j);
                let value = if first < j { values[i * n_columns + first] } else { of(i, j) };
                values.push(value);
            }
        }
        Grid::from_rows_of(n_columns, values)
    }
}

/// Whether all control points are in a plane, or nearly.
fn is_flat(surface: &NurbsSurface) -> bool {
    let net = surface.control_points().map(|&point| (place(point), point.w));
    let whole = Strip { net: &net, lines: 0..=net.n_rows() - 1, length: 1.0 };
    let Some(anchors) = whole.anchors() else { return true };
    let Some(axes) = whole.axes(&anchors) else { return true };
    let [origin, far, _] = anchors.0.map(|anchor| whole.place(anchor));
    let room = TOUCH_RELATIVE * origin.distance(far);
    whole.points().all(|(_, _, place, _)| axes.z_axis.dot(place - origin).abs() <= room)
}

impl Kinds {
    fn apart(n_pieces: usize) -> Self {
        Self { of: (0..n_pieces).collect(), firsts: (0..n_pieces).collect() }
    }

    fn of(strips: &NurbsSurface, along: Direction, n_parts: usize) -> Self {
        let net = strips.control_points().map(|&point| (place(point), point.w));
        let net = if along == Direction::U { net } else { net.transposed() };
        let knots = strips.lines(along).knots;
        let mut kinds = Self { of: Vec::new(), firsts: Vec::new() };
        // Each with its anchors and its first piece.
        let mut known: Vec<(Strip<'_>, Anchors, usize)> = Vec::new();
        for span in knots.spans() {
            let length = knots.span_interval(span).length();
            let strip = Strip { net: &net, lines: knots.support(span), length };
            let n_before = kinds.of.len();
            let like = known.iter().find(|(other, anchors, _)| strip.is_like(other, anchors));
            if let Some(&(_, _, first)) = like {
                kinds.of.extend_from_within(first..first + n_parts);
                continue;
            }
            let n_kinds = if strip.is_straight() { 1 } else { n_parts };
            kinds.of.extend((0..n_parts).map(|part| kinds.firsts.len() + part.min(n_kinds - 1)));
            kinds.firsts.extend(n_before..n_before + n_kinds);
            if let Some(anchors) = strip.anchors().filter(|_| known.len() < MANY_KINDS) {
                known.push((strip, anchors, n_before));
            }
        }
        kinds
    }
}

impl Strip<'_> {
    fn points(&self) -> impl Iterator<Item = (usize, usize, DVec3, f64)> {
        let lines = self.lines.clone().enumerate();
        lines.flat_map(|(i, line)| {
            let points = self.net.row(line).iter().enumerate();
            points.map(move |(j, &(place, weight))| (i, j, place, weight))
        })
    }

    /// The place that is largest by a measure.
    fn most(&self, measure: impl Fn(DVec3) -> f64) -> Option<[usize; 2]> {
        let measured = self.points().map(|(i, j, place, _)| (measure(place), [i, j]));
        measured.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, place)| place)
    }

    fn place(&self, [i, j]: [usize; 2]) -> DVec3 {
        self.net.row(self.lines.start() + i)[j].0
    }

    /// None of places on one line.
    fn anchors(&self) -> Option<Anchors> {
        let origin = self.place([0, 0]);
        let far = self.most(|place| place.distance_squared(origin))?;
        let along = unit(self.place(far) - origin)?;
        let beside = self.most(|place| along.cross(place - origin).length_squared())?;
        let anchors = Anchors([[0, 0], far, beside]);
        self.axes(&anchors).map(|_| anchors)
    }

    fn axes(&self, anchors: &Anchors) -> Option<DMat3> {
        let [origin, far, beside] = anchors.0.map(|anchor| self.place(anchor));
        let x = unit(far - origin)?;
        let z = unit(x.cross(beside - origin))?;
        Some(DMat3::from_cols(x, z.cross(x), z))
    }

    /// Whether it is another strip, moved and turned.
    fn is_like(&self, other: &Self, anchors: &Anchors) -> bool {
        let is_near = |one: f64, other: f64| (one - other).abs() <= EXACT_RELATIVE * other.abs();
        let (Some(to), Some(from)) = (self.axes(anchors), other.axes(anchors)) else {
            return false;
        };
        let turn = to * from.transpose();
        let [origin, far, _] = anchors.0;
        let (to, from) = (self.place(origin), other.place(origin));
        let room = EXACT_RELATIVE * from.distance(other.place(far));
        is_near(self.length, other.length)
            && self.points().zip(other.points()).all(|((_, _, one, weight), (_, _, like, same))| {
                is_near(weight, same) && one.distance(to + turn * (like - from)) <= room
            })
    }

    /// Whether it is one line, carried straight: each part of it is any other.
    fn is_straight(&self) -> bool {
        let (first, last) = (*self.lines.start(), *self.lines.end());
        if last != first + 1 {
            return false;
        }
        let [from, to] = [first, last].map(|line| self.net.row(line));
        let step = to[0].0 - from[0].0;
        let size = from.iter().map(|(place, _)| place.distance(from[0].0)).fold(0.0, f64::max);
        let room = EXACT_RELATIVE * size.max(step.length());
        from.iter().zip(to).all(|(from, to)| {
            let is_same = (from.1 - to.1).abs() <= EXACT_RELATIVE * from.1.abs();
            is_same && (to.0 - from.0).distance(step) <= room
        })
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use glam::{DVec3, dvec3};

    use super::AlikePieces;
    use crate::{Axis, Direction, Frame, KnotVector, NurbsCurve, NurbsSurface};

    #[track_caller]
    fn check(surface: &NurbsSurface, n_parts: [usize; 2], n_kinds: [usize; 2]) {
        let alike = AlikePieces::of([surface; 2], n_parts);
        assert_eq!(Direction::BOTH.map(|along| alike.firsts(along).len()), n_kinds);
        for along in Direction::BOTH {
            for (piece, &kind) in alike.kinds(along).iter().enumerate() {
                assert_eq!(alike.first_like(along, piece), alike.firsts(along)[kind]);
            }
        }
        let pieces = alike.grid(|i, j| [i, j]);
        for (i, j) in
            (0..pieces.n_rows()).flat_map(|i| (0..pieces.n_columns()).map(move |j| (i, j)))
        {
            let expected = [alike.first_like(Direction::U, i), alike.first_like(Direction::V, j)];
            assert_eq!(pieces.get(i, j), expected);
        }
    }

    #[test]
    fn quarters_of_what_was_turned_are_alike() {
        check(&NurbsSurface::sphere(Frame::XY, 2.0).unwrap(), [3, 5], [3, 10]);
        check(&NurbsSurface::torus(Frame::XY, 5.0, 2.0).unwrap(), [4, 4], [4, 16]);
        let slope = NurbsCurve::line(DVec3::X, dvec3(2.0, 0.0, 1.0)).unwrap();
        let axis = Axis::new(DVec3::ZERO, DVec3::Z).unwrap();
        check(&NurbsSurface::revolved(&slope, axis, TAU).unwrap(), [2, 3], [2, 3]);
    }

    #[test]
    fn in_a_plane_nothing_is_alike() {
        let radius = NurbsCurve::line(DVec3::X, 2.0 * DVec3::X).unwrap();
        let axis = Axis::new(DVec3::ZERO, DVec3::Z).unwrap();
        check(&NurbsSurface::revolved(&radius, axis, TAU).unwrap(), [2, 3], [8, 3]);
    }

    #[test]
    fn what_is_another_size_or_turned_over_is_not() {
        let extruded = |degree: usize, knots: &[f64], heights: &[f64]| {
            let point = |(i, &z): (usize, &f64)| dvec3(i as f64, 0.0, z);
            let points: Vec<DVec3> = heights.iter().enumerate().map(point).collect();
            let knots = KnotVector::new(degree, knots.to_vec()).unwrap();
            let curve = NurbsCurve::polynomial(knots, &points).unwrap();
            NurbsSurface::extruded(&curve, DVec3::Y).unwrap()
        };
        let zigzag =
            |heights: &[f64; 5]| extruded(1, &[0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 4.0], heights);
        check(&zigzag(&[0.0, 1.0, 0.0, 1.0, 2.0]), [1, 7], [1, 1]);
        check(&zigzag(&[0.0, 1.0, 0.0, 1.0, 1.5]), [1, 7], [2, 1]);
        let arches =
            |heights: &[f64; 5]| extruded(2, &[0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0], heights);
        check(&arches(&[0.0, 1.0, 0.0, 1.0, 0.0]), [2, 7], [2, 1]);
        check(&arches(&[0.0, 1.0, 0.0, -1.0, 0.0]), [2, 7], [4, 1]);
    }
}
