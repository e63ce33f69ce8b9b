//! Several variables moved by one step, for operations that do the same to each coordinate by itself, as most do
//! that make curves and surfaces of points and curves: what moves along one coordinate is moved along another one
//! beside it, and what the answer does there is what it would do along its own. Where lines of control points go
//! through curves and each makes a row of a surface by itself, as in a skin, so do variables of other lines.
//!
//! That an operation is of this kind is supposed only; whoever uses this holds the outcome against the variables as
//! they are.

use std::ops::Range;

use super::{
    Value,
    numbers::{NumberPlace, NumberSlopes, OTHER_NUMBER, n_lines, places, slopes},
};
use crate::limits::work;

/// How many coordinates a point has, and so how many variables go together that move all lines.
const N_AXES: usize = 3;

/// A variable among those that are moved together.
#[derive(Clone, Debug)]
struct PackedVariable {
    variable: usize,
    /// By how much it is moved over a step of one.
    scale: f64,
    /// The coordinate that it moves, and that along which this is done; none of one that moves several.
    turned: Option<[usize; 2]>,
    /// Which lines it moves, in order; none where it may move any.
    lines: Option<Vec<usize>>,
}

impl PackedVariable {
    /// Whether it may move what belongs to a line.
    fn moves(&self, line: Option<usize>) -> bool {
        let lines = self.lines.as_ref();
        lines.zip(line).is_none_or(|(all, own)| all.binary_search(&own).is_ok())
    }
}

/// Variables that are moved together.
#[derive(Debug, Default)]
struct Pack {
    members: Vec<PackedVariable>,
    /// Which lines move along each coordinate; of none the rest are free.
    taken: [Taken; N_AXES],
}

/// Lines that move along a coordinate.
#[derive(Clone, Debug)]
enum Taken {
    Lines(Vec<usize>),
    All,
}

impl Default for Taken {
    fn default() -> Self {
        Self::Lines(Vec::new())
    }
}

impl Taken {
    /// Takes lines, or all; whether they were free.
    fn take(&mut self, lines: Option<&[usize]>) -> bool {
        match (&mut *self, lines) {
            (Self::All, _) => false,
            (Self::Lines(own), None) => {
                let is_free = own.is_empty();
                if is_free {
                    *self = Self::All;
                }
                is_free
            }
            (Self::Lines(own), Some(lines)) => {
                let is_free = lines.iter().all(|line| !own.contains(line));
                if is_free {
                    own.extend(lines);
                }
                is_free
            }
        }
    }
}

/// Variables by those that are moved together.
#[derive(Debug)]
pub(super) struct PackedVariables {
    packs: Vec<Vec<PackedVariable>>,
    /// What is moved, its variables the packs.
    pub(super) args: Vec<Value>,
}

impl PackedVariables {
    /// Of arguments and the same without derivatives, those of other lines together too where `by_line`; none where no
    /// variables go together.
    pub(super) fn new(
        args: &[Value],
        held: &[Value],
        n_variables: usize,
        by_line: bool,
    ) -> Option<Self> {
        let mut kinds = Vec::new();
        held.iter().for_each(|arg| places(arg, &mut kinds));
        // The slopes of all numbers by all variables may be more than there is room for.
        if !work::goes_on(1 + (n_variables * kinds.len()) as u64 / work::PARTS_A_STEP) {
            return None;
        }
        let mut all = vec![Vec::with_capacity(kinds.len()); n_variables];
        args.iter().for_each(|arg| slopes(arg, &mut all));
        let packs = packs(&all, &kinds, by_line);
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

    /// Whether each line of an answer may be made of the same line of all arguments, as far as their number tells.
    pub(super) fn have_lines(held: &[Value], answer: &Value) -> bool {
        n_lines(held).is_some_and(|n| 1 < n && n_lines([answer]) == Some(n))
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
        places(answer, &mut kinds);
        let mut behind = 0;
        let runs: Vec<(Option<usize>, Range<usize>)> = kinds
            .chunk_by(|a, b| a.line == b.line)
            .map(|run| {
                behind += run.len();
                (run[0].line, behind - run.len()..behind)
            })
            .collect();
        let of_member = |member: &PackedVariable| {
            let mut own = vec![0.0; kinds.len()];
            for (_, run) in runs.iter().filter(|(line, _)| member.moves(*line)) {
                match member.turned {
                    None => own[run.clone()].copy_from_slice(&growth[run.clone()]),
                    Some([axis, along]) => run
                        .clone()
                        .filter(|idx| kinds[*idx].axis == axis)
                        .for_each(|idx| own[idx] = growth[idx - axis + along]),
                }
            }
            (member.variable, step * member.scale, own)
        };
        self.packs[pack].iter().map(of_member).collect()
    }
}

/// Where each number of a variable goes to, among numbers that stand there.
fn sum_places(
    kinds: &[NumberPlace],
    turned: Option<[usize; 2]>,
) -> impl Iterator<Item = usize> + '_ {
    kinds.iter().enumerate().map(move |(idx, kind)| match turned {
        Some([axis, along]) if kind.axis == axis => idx - axis + along,
        _ => idx,
    })
}

/// The variables that move something, by those that can go together.
fn packs(all: &[Vec<f64>], kinds: &[NumberPlace], by_line: bool) -> Vec<Vec<PackedVariable>> {
    let (mut alone, mut packs, mut n_full) = (Vec::new(), Vec::<Pack>::new(), 0);
    for (variable, slopes) in all.iter().enumerate() {
        let moving = || slopes.iter().zip(kinds).filter(|(slope, _)| **slope != 0.0);
        let Some((_, first)) = moving().next() else { continue };
        let largest = moving().fold(0.0, |most: f64, (slope, _)| most.max(slope.abs()));
        let scale = libm::exp2(-libm::log2(largest).round());
        let axis = first.axis;
        if axis == OTHER_NUMBER || moving().any(|(_, kind)| kind.axis != axis) {
            alone.push(vec![PackedVariable { variable, scale, turned: None, lines: None }]);
            continue;
        }
        let lines: Option<Vec<usize>> =
            if by_line { moving().map(|(_, kind)| kind.line).collect() } else { None };
        let lines = lines.map(|mut lines| {
            lines.sort_unstable();
            lines.dedup();
            lines
        });
        let is_full = |pack: &Pack| pack.taken.iter().all(|taken| matches!(taken, Taken::All));
        n_full += packs[n_full..].iter().take_while(|pack| is_full(pack)).count();
        let place =
            |pack: &mut Pack| pack.taken.iter_mut().position(|taken| taken.take(lines.as_deref()));
        let found = packs[n_full..]
            .iter_mut()
            .enumerate()
            .find_map(|(idx, pack)| place(pack).map(|along| (n_full + idx, along)));
        let (idx, along) = found.unwrap_or_else(|| {
            let mut pack = Pack::default();
            let along = place(&mut pack).unwrap_or(0);
            packs.push(pack);
            (packs.len() - 1, along)
        });
        packs[idx].members.push(PackedVariable {
            variable,
            scale,
            turned: Some([axis, along]),
            lines,
        });
    }
    for pack in packs {
        let mut members = pack.members;
        // One alone stays where it is.
        if let [only] = &mut members[..] {
            only.turned = None;
            only.lines = None;
        }
        alone.push(members);
    }
    alone
}
