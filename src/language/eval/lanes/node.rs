//! Compiled computations.

use glam::DVec3;

use crate::{
    eval::operator::table::{Arithmetic, ComparisonRow, UnaryArithmetic},
    value::{Dimension, EnclosedFunction, OnNumbers, OnVectors},
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
    /// A built-in function that makes numbers of vectors.
    OfVectors(OnVectors, Vec<PointNode>),
    /// A coordinate of a point, by its axis.
    Coordinate(usize, Box<PointNode>),
    Choose(Box<TruthNode>, Box<[Self; 2]>),
    /// Lanes that are computed first, then the result; so many calls are counted as steps.
    Let(Vec<LaneDefinition>, Box<Self>, u64),
}

/// A computation of points.
#[derive(Debug)]
pub(super) enum PointNode {
    Coordinates(Box<[LaneNode; 3]>),
    Unary(&'static UnaryArithmetic, Box<Self>),
    /// Coordinate by coordinate.
    Arithmetic(&'static Arithmetic, Box<[Self; 2]>),
    /// Each coordinate with one number.
    Scaled(&'static Arithmetic, Box<(Self, LaneNode)>),
    /// A built-in function that makes vectors of vectors.
    OfVectors(OnVectors, Vec<Self>),
    /// A built-in function that makes vectors of a length and an angle.
    OfLengthAndAngle(fn(f64, f64) -> DVec3, Box<[LaneNode; 2]>),
    Let(Vec<LaneDefinition>, Box<Self>, u64),
}

/// What is computed once and has lanes of its own.
#[derive(Debug)]
pub(super) enum LaneDefinition {
    Number(usize, LaneNode),
    Point([usize; 3], PointNode),
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
    Let(Vec<LaneDefinition>, Box<Self>, u64),
}

/// What a comprehension makes of each element.
#[derive(Debug)]
pub(super) enum LaneBody {
    Number(LaneNode, Dimension),
    Point(PointNode),
}
