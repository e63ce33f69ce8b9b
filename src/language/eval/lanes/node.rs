//! Compiled computations.

use crate::{
    eval::operator::table::{Arithmetic, ComparisonRow, UnaryArithmetic},
    value::{Dimension, EnclosedFunction, OnNumbers},
};

/// A computation of numbers.
#[derive(Debug)]
pub(super) enum LaneNode {
    Constant(f64),
    /// A lane.
    Variable(usize),
    Unary(&'static UnaryArithmetic, Box<Self>),
    Arithmetic(&'static Arithmetic, Box<[Self; 2]>),
    /// A built-in function of numbers: of the first one, and the others.
    Builtin(OnNumbers, Box<(Self, Vec<Self>)>),
    /// A built-in function of one number, of which only bounds are known here.
    Enclosed(EnclosedFunction, Box<Self>),
    Choose(Box<TruthNode>, Box<[Self; 2]>),
    /// Lanes that are computed first, then the result; so many calls are counted as steps.
    Let(Vec<(usize, Self)>, Box<Self>, u64),
}

/// A computation of truths.
#[derive(Debug)]
pub(super) enum TruthNode {
    Constant(bool),
    Compare(&'static ComparisonRow, Box<[LaneNode; 2]>),
    Not(fn(bool) -> bool, Box<Self>),
    /// The second where the first is not the truth that decides.
    Logic {
        decided_by: bool,
        sides: Box<[Self; 2]>,
    },
    Let(Vec<(usize, LaneNode)>, Box<Self>, u64),
}

/// What a comprehension makes of each element.
#[derive(Debug)]
pub(super) enum LaneBody {
    Number(LaneNode, Dimension),
    Point(Box<[LaneNode; 3]>),
}
