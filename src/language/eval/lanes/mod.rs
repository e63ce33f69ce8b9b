//! Comprehensions over numbers and points, many elements at a time.
//!
//! A comprehension whose body computes numbers or points from its variable is compiled to passes over
//! *lanes*, blocks of numbers: each operation works on a whole block before the next one begins.
//! That can be done because a dimension follows from dimensions alone, so that all elements share
//! it, and because nothing in the language has side effects.
//!
//! The machine stays the one that defines what an expression means. Lanes compute the same bits
//! in the same order; what they cannot do is not compiled, and where anything goes wrong inside a
//! block (a division by zero, a number beyond the largest) they give the block back, and the
//! machine evaluates it element by element and finds the error at its place.

mod bounds;
mod compile;
mod compile_points;
mod node;
mod run;
mod run_points;

use std::ops::Range;

use super::{
    ir::{Comprehension, Generator},
    items::Items,
    machine::Machine,
};
use crate::value::{Dimension, List, Number, Value};
pub(super) use bounds::bounded;
use compile::{Compiler, LaneInput};
use node::{LaneBody, TruthNode};
use run::Runner;

/// Elements in one pass: a few lanes fit into the nearest cache.
const BLOCK: usize = 1024;

/// Elements below which compiling does not pay.
const WORTH_COMPILING: usize = 32;

/// A comprehension over one source of numbers, ready to run.
#[derive(Debug)]
pub(super) struct Lanes {
    source: LaneSource,
    condition: Option<TruthNode>,
    body: LaneBody,
    n_variables: usize,
}

/// The numbers that the variable runs through.
#[derive(Debug)]
enum LaneSource {
    Integers(i64, usize),
    Numbers(List),
    /// Points, as far as known.
    Points(List),
}

impl LaneSource {
    fn len(&self) -> usize {
        match self {
            Self::Integers(_, count) => *count,
            Self::Numbers(list) | Self::Points(list) => list.len(),
        }
    }

    /// Sets the lanes of the variable to the elements of a block; `None` where one of them is no point.
    fn fill(&self, range: &Range<usize>, runner: &mut Runner) -> Option<()> {
        match self {
            Self::Integers(start, _) => {
                *runner.lane(0) = range.clone().map(|i| (start + i as i64) as f64).collect();
            }
            Self::Numbers(list) => {
                let (values, _) = list.numbers()?;
                *runner.lane(0) = values[range.clone()].to_vec();
            }
            Self::Points(list) => {
                let points = || list[range.clone()].iter();
                if !points().all(|value| matches!(value, Value::Point(_))) {
                    return None;
                }
                for axis in 0..3 {
                    let coordinate = |value: &Value| match value {
                        Value::Point(point) => Some(point[axis]),
                        _ => None,
                    };
                    *runner.lane(axis) = points().filter_map(coordinate).collect();
                }
            }
        }
        Some(())
    }

    /// The variable that runs through them, whose lanes come first.
    fn variable(&self, dim: Dimension) -> LaneInput {
        match self {
            Self::Points(_) => LaneInput::Point([0, 1, 2]),
            Self::Integers(..) | Self::Numbers(_) => LaneInput::Lane(0, dim),
        }
    }
}

/// What a block of elements came to.
#[derive(Debug)]
pub(super) enum BlockResult {
    /// Numbers of one dimension.
    Numbers(Vec<f64>, Dimension),
    /// Anything else.
    Values(Vec<Value>),
}

impl BlockResult {
    pub(super) fn len(&self) -> usize {
        match self {
            Self::Numbers(values, _) => values.len(),
            Self::Values(values) => values.len(),
        }
    }

    pub(super) fn into_values(self) -> Vec<Value> {
        match self {
            Self::Numbers(values, dim) => {
                let number = |value| Value::Number(Number { value, dim });
                values.into_iter().map(number).collect()
            }
            Self::Values(values) => values,
        }
    }
}

impl Lanes {
    /// The last generator and the body as lanes, if they can be.
    pub(super) fn of(
        machine: &Machine<'_>,
        comprehension: &Comprehension,
        generator: &Generator,
        source: &Value,
    ) -> Option<Self> {
        if !generator.parts.is_empty() {
            return None;
        }
        let (source, dim) = match source {
            Value::Range(range) => {
                let (start, count) = range.integers()?;
                (LaneSource::Integers(start, count), Dimension::NONE)
            }
            Value::List(list) => match list.numbers() {
                Some((_, dim)) => (LaneSource::Numbers(list.clone()), dim),
                None if matches!(list.first(), Some(Value::Point(_))) => {
                    (LaneSource::Points(list.clone()), Dimension::NONE)
                }
                None => return None,
            },
            _ => return None,
        };
        if source.len() < WORTH_COMPILING {
            return None;
        }
        let mut compiler = Compiler::new(machine, generator.slot, source.variable(dim));
        let condition = match &generator.condition {
            Some(condition) => Some(compiler.condition(condition)?),
            None => None,
        };
        let body = compiler.body(&comprehension.body)?;
        Some(Self { source, condition, body, n_variables: compiler.n_variables() })
    }

    /// The blocks of elements, in order.
    pub(super) fn blocks(&self) -> impl Iterator<Item = Range<usize>> + use<> {
        let n = self.source.len();
        (0..n).step_by(BLOCK).map(move |start| start..n.min(start + BLOCK))
    }

    /// The elements of a block one by one.
    pub(super) fn elements(&self, range: Range<usize>) -> Items<'_> {
        match &self.source {
            LaneSource::Integers(start, _) => {
                Items::Integers(start + range.start as i64, range.len())
            }
            LaneSource::Numbers(list) | LaneSource::Points(list) => Items::of(list, range),
        }
    }

    /// What a block comes to and in how many steps; `None` where only the machine can tell.
    pub(super) fn run(&self, range: &Range<usize>) -> Option<(BlockResult, u64)> {
        let mut runner = Runner::new(self.n_variables, range.len());
        self.source.fill(range, &mut runner)?;
        let mut steps = range.len() as u64;
        if let Some(condition) = &self.condition {
            let mask = runner.truth(condition)?;
            let narrowed = runner.narrowed(&mask, true);
            steps += runner.steps();
            runner = narrowed;
        }
        let n = runner.len();
        let made = match &self.body {
            LaneBody::Number(node, dim) => {
                let mut out = vec![0.0; n];
                runner.number(node, &mut out)?;
                BlockResult::Numbers(out, *dim)
            }
            LaneBody::Point(node) => {
                let [x, y, z] = runner.point(node)?;
                let point = |i: usize| Value::Point(glam::DVec3::new(x[i], y[i], z[i]));
                BlockResult::Values((0..n).map(point).collect())
            }
        };
        Some((made, steps + runner.steps()))
    }
}
