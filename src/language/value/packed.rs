//! Several variables moved by one step.
//!
//! Most operations that make curves and surfaces of points and curves do the same to each coordinate by itself: what moves
//! along one coordinate is moved along another one beside it, and what the answer does there is what it would do along its
//! own. And where control points move a part of the answer each, those of other parts move together. That an operation is
//! of this kind is supposed only; whoever uses this holds the outcome against the variables as they are.
//!
//! Curtis, Powell & Reid, *On the estimation of sparse Jacobian matrices*, IMA J. Appl. Math. 13 (1974).

use std::sync::Arc;

use super::{
    Value,
    held_numbers::HeldNumbers,
    numbers::{NumberPlaces, OTHER_NUMBER, SparseNumbers, slopes},
    reach::{Moved, PointReach},
};
use crate::limits::work;

/// How many coordinates a point has, and so how many variables go together that move all of an answer.
const N_AXES: usize = 3;

/// Of how many control points that move alike those are that are moved first, at most.
const FEW: usize = 4;

/// What moves in the arguments of an operation.
pub(super) struct MovingNumbers {
    held: Arc<HeldNumbers>,
    places: NumberPlaces,
    /// The slopes of all numbers, by each variable.
    slopes: Vec<SparseNumbers>,
}

/// A variable among those that are moved together.
#[derive(Clone, Debug)]
struct PackedVariable {
    variable: usize,
    /// By how much it is moved over a step of one.
    scale: f64,
    /// The coordinate that it moves, and that along which this is done; none of one that stays where it is.
    turned: Option<[usize; 2]>,
    /// Which points of the answer it moves; none where it may move any.
    points: Option<Vec<usize>>,
}

/// Variables that are moved together.
#[derive(Clone, Debug)]
pub(super) struct Pack {
    members: Vec<PackedVariable>,
    /// Which points of the answer move along each coordinate.
    taken: [Vec<bool>; N_AXES],
}

/// By how much an answer grows over a step of a variable.
pub(super) struct Growth {
    pub(super) variable: usize,
    pub(super) step: f64,
    pub(super) growth: SparseNumbers,
}

impl MovingNumbers {
    /// Of arguments, and the same without derivatives; none where there is no room for them.
    pub(super) fn new(args: &[Value], held: Vec<Value>, n_variables: usize) -> Option<Self> {
        let held = HeldNumbers::new(held);
        let places = held.places.clone();
        // The slopes of all numbers by all variables may be more than there is room for.
        let n_parts = n_variables * places.numbers.len();
        if !work::goes_on(1 + n_parts as u64 / work::PARTS_A_STEP) {
            return None;
        }
        let mut all = vec![Vec::new(); n_variables];
        args.iter().fold(0, |behind, arg| slopes(arg, behind, &mut all));
        Some(Self { held: Arc::new(held), places, slopes: all })
    }

    /// Of arguments without derivatives, whose numbers have these slopes by each variable.
    pub(super) fn of_slopes(held: &Arc<HeldNumbers>, slopes: Vec<SparseNumbers>) -> Self {
        Self { held: Arc::clone(held), places: held.places.clone(), slopes }
    }

    /// The arguments without derivatives.
    pub(super) fn held(&self) -> &HeldNumbers {
        &self.held
    }

    /// Whether several curves or surfaces stand in a list, so that they are taken for alike.
    pub(super) fn has_lists(&self) -> bool {
        self.places.has_lists()
    }

    /// The same with none of them taken for alike.
    pub(super) fn apart(&self) -> Self {
        let mut places = self.places.clone();
        places.nets.iter_mut().for_each(|net| net.list = None);
        Self { held: Arc::clone(&self.held), places, slopes: self.slopes.clone() }
    }

    /// The variables that move something.
    pub(super) fn variables(&self) -> Vec<usize> {
        (0..self.slopes.len()).filter(|&variable| !self.slopes[variable].is_empty()).collect()
    }

    /// The control point that a variable moves alone; none where it moves others too.
    fn moved(&self, variable: usize) -> Option<Moved> {
        let own = &self.slopes[variable];
        let point = |(at, _): &(usize, f64)| self.places.numbers[*at].1;
        let first = point(own.first()?);
        let (net, at) = self.places.in_net(first)?;
        (point(own.last()?) == first).then_some(Moved { variable, net, at })
    }

    /// Variables of points of a net that may move alike, those of curves or surfaces in one list together: two of each are
    /// to be moved before all others.
    pub(super) fn first_ones(&self) -> Vec<[Moved; 2]> {
        let nets = &self.places.nets;
        let mut by_net = vec![Vec::new(); nets.len()];
        let moved = self.variables().into_iter().filter_map(|variable| self.moved(variable));
        moved.for_each(|moved| by_net[moved.net].push(moved));
        let mut found: Vec<[Moved; 2]> = Vec::new();
        let mut n_moved = 0;
        for own in by_net.iter().filter(|own| FEW <= own.len()) {
            n_moved += own.len();
            let net = own[0].net;
            let is_known = |pair: &[Moved; 2]| self.are_alike(pair[0].net, net);
            if !found.iter().any(is_known) {
                let mut own = own.clone();
                own.sort_by_key(|moved| moved.at);
                found.push([own[own.len() / 3], own[2 * own.len() / 3]]);
            }
        }
        let is_worth_it = 2 * FEW * found.len() <= n_moved;
        if is_worth_it { found } else { Vec::new() }
    }

    /// Whether points of two nets may move alike.
    fn are_alike(&self, a: usize, b: usize) -> bool {
        let [one, other] = [a, b].map(|net| self.places.nets[net]);
        a == b || one.list.is_some() && one.list == other.list && one.size == other.size
    }

    /// Variables by those that are moved together, each along a coordinate of its own or as it is, where it is known which
    /// points of an answer control points reach.
    pub(super) fn packs(
        &self,
        variables: &[usize],
        reaches: &[(Moved, PointReach)],
        answer: &NumberPlaces,
        is_turning: bool,
    ) -> Vec<Pack> {
        let reached = |variable: usize| {
            let moved = self.moved(variable)?;
            let (_, reach) =
                reaches.iter().find(|(first, _)| self.are_alike(first.net, moved.net))?;
            reach.points(moved.at, answer)
        };
        let mut packs: Vec<Pack> = Vec::new();
        let mut n_full = 0;
        for &variable in variables {
            let mut member = self.packed(variable, is_turning);
            member.points = reached(variable);
            n_full += packs[n_full..].iter().take_while(|pack| pack.is_full()).count();
            let found = packs[n_full..].iter_mut().position(|pack| pack.take(&mut member));
            match found {
                Some(idx) => packs[n_full + idx].members.push(member),
                None => {
                    let mut pack = Pack::new(answer.points.len());
                    pack.take(&mut member);
                    pack.members.push(member);
                    packs.push(pack);
                }
            }
        }
        // One alone stays where it is.
        for pack in &mut packs {
            if let [only] = &mut pack.members[..] {
                (only.turned, only.points) = (None, None);
            }
        }
        packs
    }

    fn packed(&self, variable: usize, is_turning: bool) -> PackedVariable {
        let own = &self.slopes[variable];
        let largest = own.iter().fold(0.0, |most: f64, (_, slope)| most.max(slope.abs()));
        let scale = libm::exp2(-libm::log2(largest).round());
        let axis = |(at, _): &(usize, f64)| self.places.numbers[*at].0;
        let axis_of_all = own.first().map(axis).filter(|&first| {
            first != OTHER_NUMBER && own.iter().all(|number| axis(number) == first)
        });
        let turned = axis_of_all.filter(|_| is_turning).map(|axis| [axis, axis]);
        PackedVariable { variable, scale, turned, points: None }
    }

    /// How all numbers go over a step of a pack.
    pub(super) fn direction(&self, pack: &Pack) -> SparseNumbers {
        let mut sum = SparseNumbers::new();
        for member in &pack.members {
            for (at, slope) in &self.slopes[member.variable] {
                let to = match member.turned {
                    Some([axis, along]) => at - axis + along,
                    None => *at,
                };
                sum.push((to, member.scale * slope));
            }
        }
        sum.sort_by_key(|(at, _)| *at);
        sum.dedup_by(|next, own| {
            let is_same = next.0 == own.0;
            if is_same {
                own.1 += next.1;
            }
            is_same
        });
        sum
    }
}

impl Pack {
    fn new(n_points: usize) -> Self {
        Self { members: Vec::new(), taken: std::array::from_fn(|_| vec![false; n_points]) }
    }

    fn is_full(&self) -> bool {
        self.taken.iter().flatten().all(|is_taken| *is_taken)
    }

    /// Takes the points of a variable along the first coordinate where they are free, or along all of them that the
    /// variable moves; whether they were.
    fn take(&mut self, member: &mut PackedVariable) -> bool {
        let is_free = |taken: &Vec<bool>| match &member.points {
            None => taken.iter().all(|is_taken| !is_taken),
            Some(points) => points.iter().all(|&point| !taken[point]),
        };
        let axes = match &mut member.turned {
            Some([_, along]) => match self.taken.iter().position(is_free) {
                Some(free) => {
                    *along = free;
                    free..free + 1
                }
                None => return false,
            },
            None if self.taken.iter().all(is_free) => 0..N_AXES,
            None => return false,
        };
        for taken in &mut self.taken[axes] {
            match &member.points {
                None => taken.fill(true),
                Some(points) => points.iter().for_each(|&point| taken[point] = true),
            }
        }
        true
    }

    /// Whether variables are among them that move a part of the answer alone.
    pub(super) fn is_in_part(&self) -> bool {
        self.members.iter().any(|member| member.points.is_some())
    }

    /// Of the growth of an answer over a step of the pack, that of each of its variables.
    pub(super) fn taken_apart(
        &self,
        (step, growth): (f64, &[f64]),
        answer: &NumberPlaces,
    ) -> Vec<Growth> {
        let n_numbers = answer.numbers.len();
        let of_member = |member: &PackedVariable| {
            let mut own = SparseNumbers::new();
            let mut add = |point: usize| {
                let first = answer.points[point];
                let end = answer.points.get(point + 1).copied().unwrap_or(n_numbers);
                let numbers = match member.turned {
                    Some([axis, along]) if first + axis.max(along) < end => {
                        own.extend(Some((first + axis, growth[first + along])));
                        return;
                    }
                    Some(_) => return,
                    None => first..end,
                };
                own.extend(numbers.map(|at| (at, growth[at])));
            };
            match &member.points {
                None => (0..answer.points.len()).for_each(add),
                Some(points) => points.iter().for_each(|&point| add(point)),
            }
            own.retain(|(_, grown)| *grown != 0.0);
            Growth { variable: member.variable, step: step * member.scale, growth: own }
        };
        self.members.iter().map(of_member).collect()
    }
}
