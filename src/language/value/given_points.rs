//! The points that move in the arguments of an operation: control points of curves and surfaces, and those of lists.

use std::sync::Arc;

use glam::DVec3;

use super::{
    Value, affine::all_moved, control_points::slopes_by_variable, held_numbers::HeldNumbers,
    numbers::SparseNumbers, packed::MovingNumbers, variation::Variables,
};
use crate::kernel::{Curve, Jet, PointEntries, PointFactors, PointSlopes, Surface};

/// The points that move in the arguments of an operation, where nothing else does.
pub(super) struct GivenPoints {
    pub(super) held: Arc<HeldNumbers>,
    /// The slopes of the points of each net that moves.
    pub(super) sets: Vec<PointSlopes>,
    /// Which of all nets each is.
    pub(super) nets: Vec<usize>,
    /// Whether control points of curves or surfaces move.
    pub(super) has_splines: bool,
    pub(super) moving: Vec<GivenPoint>,
}

/// A point that moves.
#[derive(Clone)]
pub(super) struct GivenPoint {
    /// Where it stands among the points of all sets.
    pub(super) point: usize,
    /// Of which set it is.
    pub(super) set: usize,
    /// Along which coordinates it moves.
    pub(super) is_along: [bool; 3],
    /// The first of its numbers, and of those of points in other sets that move with it, as ends of curves that meet.
    numbers: Vec<usize>,
}

impl GivenPoints {
    /// None where anything else varies, or, unless it is known what is made of them, lists of points alone: that is cheap beside
    /// finding a matrix.
    pub(super) fn new(args: &[Value], n_variables: usize, is_known: bool) -> Option<Self> {
        let mut walk = GivenWalk { n_variables, n_nets: 0, has_splines: false, sets: Vec::new() };
        args.iter().try_for_each(|arg| walk.add(arg))?;
        if !walk.has_splines && !is_known {
            return None;
        }
        let held = HeldNumbers::new(all_moved(args, &[])?);
        let (mut moving, mut n_before) = (Vec::new(), 0);
        for (set, (net, slopes)) in walk.sets.iter().enumerate() {
            let first = held.places.nets[*net].first;
            let all = slopes.moving_coordinates()?;
            let own = all.iter().enumerate().filter(|(_, is_along)| is_along.contains(&true));
            moving.extend(own.map(|(idx, &is_along)| GivenPoint {
                point: n_before + idx,
                set,
                is_along,
                numbers: vec![held.places.points[first + idx]],
            }));
            n_before += all.len();
        }
        let has_splines = walk.has_splines;
        let (nets, sets) = walk.sets.into_iter().unzip();
        let mut own = Self { held: Arc::new(held), sets, nets, has_splines, moving };
        if 1 < own.sets.len() {
            own.join();
        }
        Some(own)
    }

    /// A matrix by all points of the arguments as one by those of the nets that move.
    pub(super) fn of_sets(&self, entries: &PointEntries) -> PointFactors {
        let mut places = vec![None; self.held.places.points.len()];
        let mut n_before = 0;
        for (set, net) in self.sets.iter().zip(&self.nets) {
            let (first, n_points) = (self.held.places.nets[*net].first, set.n_points());
            (0..n_points).for_each(|idx| places[first + idx] = Some(n_before + idx));
            n_before += n_points;
        }
        let of = |&(made, point, factor): &(usize, usize, f64)| {
            Some((made, (*places.get(point)?)?, factor))
        };
        PointFactors::Alike(entries.iter().filter_map(of).collect())
    }

    /// By how many variables points move.
    pub(super) fn n_variables(&self) -> usize {
        let mut all: Vec<usize> = self.sets.iter().flat_map(PointSlopes::variables).collect();
        all.sort_unstable();
        all.dedup();
        all.len()
    }

    /// Lets points at one place that move alike move as one: curves that meet go apart where the end of one moves alone.
    fn join(&mut self) {
        let all = &self.held.all;
        let place = |own: &GivenPoint| [0, 1, 2].map(|axis| all[own.numbers[0] + axis].to_bits());
        let mut order: Vec<usize> = (0..self.moving.len()).collect();
        order.sort_by_key(|&idx| (place(&self.moving[idx]), idx));
        let at_one_place =
            order.chunk_by(|&a, &b| place(&self.moving[a]) == place(&self.moving[b]));
        let mut is_joined = vec![false; self.moving.len()];
        let mut joined: Vec<(usize, GivenPoint)> = Vec::new();
        for group in at_one_place.filter(|group| 1 < group.len()) {
            let (first, own) = (group[0], &self.moving[group[0]]);
            for &idx in &group[1..] {
                let other = &self.moving[idx];
                if other.set != own.set && self.move_alike(own, other) {
                    is_joined[idx] = true;
                    joined.push((first, other.clone()));
                }
            }
        }
        for (first, other) in joined {
            let own = &mut self.moving[first];
            own.numbers.extend(other.numbers);
            (0..3).for_each(|axis| own.is_along[axis] |= other.is_along[axis]);
        }
        let mut is_joined = is_joined.into_iter();
        self.moving.retain(|_| !is_joined.next().unwrap_or(false));
    }

    fn move_alike(&self, a: &GivenPoint, b: &GivenPoint) -> bool {
        let place = |own: &GivenPoint| {
            let n_before: usize = self.sets[..own.set].iter().map(PointSlopes::n_points).sum();
            (&self.sets[own.set], own.point - n_before)
        };
        let [(a, own), (b, other)] = [place(a), place(b)];
        a.moves_as(own, b, other)
    }

    /// The arguments with a variable for each of some points, along a coordinate.
    pub(super) fn along(&self, axis: usize, points: &[GivenPoint]) -> MovingNumbers {
        let of = |own: &GivenPoint| own.numbers.iter().map(|first| (first + axis, 1.0)).collect();
        let slopes = points.iter().map(of).collect();
        MovingNumbers::of_slopes(&self.held, slopes)
    }

    /// The direction in which each of some points goes so far for a step of one; and how far each of all goes.
    pub(super) fn at_once(
        &self,
        step: impl Fn(usize, &GivenPoint) -> DVec3,
    ) -> (SparseNumbers, Vec<DVec3>) {
        let n_points: usize = self.sets.iter().map(PointSlopes::n_points).sum();
        let (mut steps, mut all) = (vec![DVec3::ZERO; n_points], SparseNumbers::new());
        for (idx, own) in self.moving.iter().enumerate() {
            let step = step(idx, own);
            steps[own.point] = step;
            for axis in (0..3).filter(|&axis| 0.0 < step[axis].abs()) {
                all.extend(own.numbers.iter().map(|first| (first + axis, step[axis])));
            }
        }
        all.sort_by_key(|(at, _)| *at);
        (all, steps)
    }
}

impl GivenPoint {
    /// A step along the coordinates in which it moves, unlike those of other points.
    pub(super) fn own_step(&self, idx: usize) -> DVec3 {
        let along = |axis: usize| {
            let golden = (3 * idx + axis + 1) as f64 * 0.618_033_988_749_894_9;
            if self.is_along[axis] { golden.fract() - 0.5 } else { 0.0 }
        };
        DVec3::from([0, 1, 2].map(along))
    }
}

/// Gathers the slopes of nets of points, in the order of [`NumberPlaces::nets`].
struct GivenWalk {
    n_variables: usize,
    n_nets: usize,
    /// Whether control points of curves or surfaces move.
    has_splines: bool,
    sets: Vec<(usize, PointSlopes)>,
}

impl GivenWalk {
    fn net(&mut self, slopes: Option<PointSlopes>) {
        let own = slopes.filter(|slopes| !slopes.is_fixed());
        self.sets.extend(own.map(|slopes| (self.n_nets, slopes)));
        self.n_nets += 1;
    }

    fn spline(&mut self, slopes: &PointSlopes) {
        self.has_splines |= !slopes.is_fixed();
        self.net(Some(slopes.clone()));
    }

    /// None where anything beside nets of points varies.
    fn add(&mut self, value: &Value) -> Option<()> {
        match value {
            Value::JetCurve(curve) => self.spline(curve.slopes()),
            Value::JetSurface(surface) => self.spline(surface.slopes()),
            Value::JetPoint(jets) => self.points(1, &[(0, jets)])?,
            Value::Curve(Curve::Nurbs(_)) | Value::Surface(Surface::Nurbs(_)) | Value::Point(_) => {
                self.net(None);
            }
            Value::List(items) => {
                let all: Vec<Value> = items.values().collect();
                let is_point = |item: &Value| matches!(item, Value::Point(_) | Value::JetPoint(_));
                if !all.iter().all(is_point) {
                    return all.iter().try_for_each(|item| self.add(item));
                }
                let jets: Vec<(usize, &[Jet; 3])> = (all.iter().enumerate())
                    .filter_map(|(idx, item)| match item {
                        Value::JetPoint(jets) => Some((idx, &**jets)),
                        _ => None,
                    })
                    .collect();
                self.points(all.len(), &jets)?;
            }
            Value::Record(record) => record.iter().try_for_each(|(_, value)| self.add(value))?,
            other => return (Variables::of(other) == Variables::None).then_some(()),
        }
        Some(())
    }

    /// Adds a net of so many points, some of which move.
    fn points(&mut self, n_points: usize, jets: &[(usize, &[Jet; 3])]) -> Option<()> {
        let moving = jets.iter().map(|(idx, jets)| (*idx, *jets, 1.0));
        let by_variable = slopes_by_variable([self.n_variables, n_points], moving);
        self.net(Some(PointSlopes::new(self.n_variables, n_points, by_variable).ok()?));
        Some(())
    }
}
