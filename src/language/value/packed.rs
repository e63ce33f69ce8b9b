//! Several variables moved by one step, for operations that do the same to each coordinate by itself, as most do
//! that make curves and surfaces of points and curves: what moves along one coordinate is moved along another one
//! beside it, and what the answer does there is what it would do along its own.
//!
//! That an operation is of this kind is supposed only; whoever uses this holds the outcome against the variables as
//! they are.

use super::{
    Value,
    numbers::{NumberSlopes, OTHER_NUMBER, axes, slopes},
};
use crate::limits::work;

/// How many coordinates a point has, and so how many variables go together.
const N_AXES: usize = 3;

/// A variable among those that are moved together.
#[derive(Clone, Copy, Debug)]
struct PackedVariable {
    variable: usize,
    /// By how much it is moved over a step of one.
    scale: f64,
    /// The coordinate that it moves, and that along which this is done; none of one that moves several.
    turned: Option<[usize; 2]>,
}

/// Variables by those that are moved together.
#[derive(Debug)]
pub(super) struct PackedVariables {
    packs: Vec<Vec<PackedVariable>>,
    /// What is moved, its variables the packs.
    pub(super) args: Vec<Value>,
}

impl PackedVariables {
    /// Of arguments and the same without derivatives; none where no variables go together.
    pub(super) fn new(args: &[Value], held: &[Value], n_variables: usize) -> Option<Self> {
        let mut kinds = Vec::new();
        held.iter().for_each(|arg| axes(arg, &mut kinds));
        // The slopes of all numbers by all variables may be more than there is room for.
        if !work::goes_on(1 + (n_variables * kinds.len()) as u64 / work::PARTS_A_STEP) {
            return None;
        }
        let mut all = vec![Vec::with_capacity(kinds.len()); n_variables];
        args.iter().for_each(|arg| slopes(arg, &mut all));
        let packs = packs(&all, &kinds);
        let n_moving: usize = packs.iter().map(Vec::len).sum();
        if packs.len() == n_moving {
            return None;
        }
        let direction = |(idx, pack): (usize, &Vec<PackedVariable>)| {
            let mut sum = vec![0.0; kinds.len()];
            for member in pack {
                let places = sum_places(&kinds, member.turned);
                for (to, slope) in places.zip(&all[member.variable]) {
                    sum[to] += member.scale * slope;
                }
            }
            (idx, sum)
        };
        let by_variable: Vec<(usize, Vec<f64>)> = packs.iter().enumerate().map(direction).collect();
        let mut seeds =
            NumberSlopes { n_variables: packs.len(), by_variable: &by_variable, n_used: 0 };
        let args: Option<Vec<Value>> = held.iter().map(|arg| seeds.value(arg)).collect();
        Some(Self { packs, args: args? })
    }

    pub(super) fn len(&self) -> usize {
        self.packs.len()
    }

    /// Of the growth of an answer over a step of a pack, that of each of its variables, with the variable and its own step.
    pub(super) fn taken_apart(
        &self,
        pack: usize,
        (step, growth): (f64, &[f64]),
        answer: &Value,
    ) -> Vec<(usize, f64, Vec<f64>)> {
        let mut kinds = Vec::with_capacity(growth.len());
        axes(answer, &mut kinds);
        let of_member = |member: &PackedVariable| {
            let places = sum_places(&kinds, member.turned);
            let own = kinds.iter().zip(places).map(|(&kind, place)| match member.turned {
                Some([axis, _]) if axis != kind => 0.0,
                _ => growth[place],
            });
            (member.variable, step * member.scale, own.collect())
        };
        self.packs[pack].iter().map(of_member).collect()
    }
}

/// Where each number of a variable goes to, among numbers of these kinds.
fn sum_places(kinds: &[usize], turned: Option<[usize; 2]>) -> impl Iterator<Item = usize> + '_ {
    kinds.iter().enumerate().map(move |(idx, &kind)| match turned {
        Some([axis, along]) if kind == axis => idx - axis + along,
        _ => idx,
    })
}

/// The variables that move something, by those that can go together.
fn packs(all: &[Vec<f64>], kinds: &[usize]) -> Vec<Vec<PackedVariable>> {
    let (mut packs, mut open) = (Vec::new(), Vec::new());
    for (variable, slopes) in all.iter().enumerate() {
        let moving = || slopes.iter().zip(kinds).filter(|(slope, _)| **slope != 0.0);
        let Some((_, &axis)) = moving().next() else { continue };
        let largest = moving().fold(0.0, |most: f64, (slope, _)| most.max(slope.abs()));
        let scale = libm::exp2(-libm::log2(largest).round());
        if axis == OTHER_NUMBER || moving().any(|(_, kind)| *kind != axis) {
            packs.push(vec![PackedVariable { variable, scale, turned: None }]);
            continue;
        }
        open.push(PackedVariable { variable, scale, turned: Some([axis, open.len()]) });
        if open.len() == N_AXES {
            packs.push(std::mem::take(&mut open));
        }
    }
    // One alone stays where it is.
    if let [only] = &mut open[..] {
        only.turned = None;
    }
    packs.extend((!open.is_empty()).then_some(open));
    packs
}
