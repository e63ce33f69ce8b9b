//! Which points of an answer a control point moves, as those of others beside it tell.
//!
//! A control point of a spline moves what is near its own place: a few points of a curve, a few rows or columns of a
//! surface. Two of them tell which, and how that goes on from one to the next.

use std::ops::Range;

use super::numbers::{NumberPlaces, SparseNumbers};

/// A control point that a variable moves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moved {
    pub(super) variable: usize,
    /// Of which curve or surface it is, or list of points.
    pub(super) net: usize,
    /// Its row and column there.
    pub(super) at: [usize; 2],
}

/// Which points of an answer the control points of a net reach.
#[derive(Debug)]
pub(super) struct PointReach {
    /// For each net of the answer; none where they reach nothing of it.
    nets: Vec<Option<[AxisReach; 2]>>,
    /// Other points and numbers.
    others: Vec<usize>,
}

/// Which rows or columns of a net are reached.
#[derive(Clone, Copy, Debug)]
enum AxisReach {
    All,
    /// Those from and up to a place of two that goes on so fast with the rows or columns of the control points.
    Along {
        axis: usize,
        from: usize,
        speed: f64,
        low: f64,
        high: f64,
    },
}

/// The rows and columns of a net between which something moves.
type Box2 = [Range<usize>; 2];

impl PointReach {
    /// As two control points of a net tell, by what moves with them, and some rows and columns more of an answer.
    pub(super) fn new(
        pair: &[Moved; 2],
        grown: [&SparseNumbers; 2],
        (answer, margin): (&NumberPlaces, f64),
    ) -> Self {
        let moving = grown.map(|grown| moving_points(grown, answer));
        let mut others: Vec<usize> = moving.iter().flat_map(|(others, _)| others.clone()).collect();
        others.sort_unstable();
        others.dedup();
        let nets = (answer.nets.iter().enumerate())
            .map(|(net, own)| {
                let boxes = [&moving[0].1[net], &moving[1].1[net]];
                let axis =
                    |axis: usize| AxisReach::new(pair, boxes, (axis, own.size[axis])).wider(margin);
                boxes.iter().any(|found| found.is_some()).then(|| [axis(0), axis(1)])
            })
            .collect();
        Self { nets, others }
    }

    /// The points that one at a place in a net of this size reaches; none where they may be all.
    pub(super) fn points(&self, at: [usize; 2], answer: &NumberPlaces) -> Option<Vec<usize>> {
        let mut points = self.others.clone();
        for (reach, net) in self.nets.iter().zip(&answer.nets) {
            let Some(reach) = reach else { continue };
            let [rows, columns] = [0, 1].map(|axis| reach[axis].range(at, net.size[axis]));
            for row in rows {
                points.extend(columns.clone().map(|column| net.first + row * net.size[1] + column));
            }
        }
        (points.len() < answer.points.len()).then_some(points)
    }
}

/// The points outside of nets that move, and between which rows and columns those of each net do.
fn moving_points(grown: &SparseNumbers, answer: &NumberPlaces) -> (Vec<usize>, Vec<Option<Box2>>) {
    let (mut others, mut boxes) = (Vec::new(), vec![None; answer.nets.len()]);
    for (at, _) in grown {
        let point = answer.numbers[*at].1;
        match answer.in_net(point) {
            None => others.push(point),
            Some((net, [row, column])) => {
                let [rows, columns]: &mut Box2 =
                    boxes[net].get_or_insert([row..row + 1, column..column + 1]);
                *rows = rows.start.min(row)..rows.end.max(row + 1);
                *columns = columns.start.min(column)..columns.end.max(column + 1);
            }
        }
    }
    (others, boxes)
}

impl AxisReach {
    fn new(pair: &[Moved; 2], boxes: [&Option<Box2>; 2], (axis, n): (usize, usize)) -> Self {
        let ranges = boxes.map(|found| found.as_ref().map(|found| found[axis].clone()));
        let is_all = |range: &Range<usize>| 1 < n && range.len() == n;
        if n == 1 || ranges.iter().flatten().any(is_all) {
            return Self::All;
        }
        let middle = |range: &Range<usize>| 0.5 * (range.start + range.end) as f64;
        let from_to = |idx: usize, along: usize| {
            let [from, to] = [pair[idx].at[along], pair[1 - idx].at[along]];
            to as f64 - from as f64
        };
        let (idx, range, along, speed) = match &ranges {
            [Some(a), Some(b)] => {
                // Of rows and columns the ones along which it goes on most evenly.
                let way = middle(b) - middle(a);
                let speed = |along: usize| way / from_to(0, along);
                let evenness = |along: usize| libm::log2(speed(along).abs()).abs();
                let found = [0, 1].into_iter().min_by(|a, b| evenness(*a).total_cmp(&evenness(*b)));
                let along = found.unwrap_or(0);
                (0, a.clone(), along, speed(along))
            }
            [Some(a), None] => (0, a.clone(), 0, 1.0),
            [None, Some(b)] => (1, b.clone(), 0, 1.0),
            [None, None] => return Self::All,
        };
        if !speed.is_finite() || speed == 0.0 {
            return Self::All;
        }
        let from = pair[idx].at[along];
        let mut own = Self::Along {
            axis: along,
            from,
            speed,
            low: range.start as f64,
            high: range.end as f64,
        };
        if let (Self::Along { low, high, .. }, [Some(a), Some(b)]) = (&mut own, &ranges) {
            let way = speed * from_to(0, along);
            *low = low.min(b.start as f64 - way);
            *high = high.max(b.end as f64 - way);
            let is_even = a.len() == b.len() && speed.abs().total_cmp(&1.0).is_eq();
            if !is_even {
                (*low, *high) = (*low - 1.0, *high + 1.0);
            }
        }
        own
    }

    fn wider(self, margin: f64) -> Self {
        match self {
            Self::All => Self::All,
            Self::Along { axis, from, speed, low, high } => {
                Self::Along { axis, from, speed, low: low - margin, high: high + margin }
            }
        }
    }

    /// The rows or columns, of so many, that a control point at a place reaches.
    fn range(self, at: [usize; 2], n: usize) -> Range<usize> {
        match self {
            Self::All => 0..n,
            Self::Along { axis, from, speed, low, high } => {
                let way = speed * (at[axis] as f64 - from as f64);
                let inside = |place: f64| place.clamp(0.0, n as f64) as usize;
                inside((low + way).floor())..inside((high + way).ceil())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::DVec3;

    use super::*;
    use crate::{
        kernel::{Grid, NurbsSurface, Surface},
        value::Value,
    };

    /// A net of seven rows and five columns, in which a control point reaches two rows and two columns from its own on.
    #[test]
    fn two_control_points_tell_the_rows_and_columns_that_others_reach() {
        let net = Grid::from_fn(7, 5, |i, j| DVec3::new(i as f64, j as f64, 0.0));
        let surface = NurbsSurface::bezier(&net).expect("a surface");
        let answer = NumberPlaces::of([&Value::Surface(Surface::Nurbs(Arc::new(surface)))]);
        let reached = |[row, column]: [usize; 2]| -> Vec<usize> {
            let rows = row..(row + 2).min(7);
            rows.flat_map(|i| (column..(column + 2).min(5)).map(move |j| 5 * i + j)).collect()
        };
        let moved = |variable: usize, at: [usize; 2]| Moved { variable, net: 0, at };
        let pair = [moved(0, [1, 1]), moved(1, [4, 2])];
        let grown = pair.map(|moved| -> SparseNumbers {
            reached(moved.at).into_iter().map(|point| (4 * point, 1.0)).collect()
        });
        let narrow = PointReach::new(&pair, grown.each_ref(), (&answer, 0.0));
        for at in (0..7).flat_map(|i| (0..5).map(move |j| [i, j])) {
            assert_eq!(narrow.points(at, &answer), Some(reached(at)), "{at:?}");
        }
        let wide = PointReach::new(&pair, grown.each_ref(), (&answer, 1.0));
        let found = wide.points([3, 2], &answer).expect("a part");
        assert_eq!(found, (2..6).flat_map(|i| (1..5).map(move |j| 5 * i + j)).collect::<Vec<_>>());
    }
}
