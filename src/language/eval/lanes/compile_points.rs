//! Compiles expressions of points to lanes.

use super::{
    compile::{Compiled, Compiler, LaneFrame, LaneInput},
    node::{LaneNode, PointNode},
};
use crate::{
    eval::{
        ir::{CallExpr, Expr},
        operator::{operand::Sides, table::Arithmetic},
    },
    value::{Dimension, OnVectors, Value},
};

impl Compiler<'_> {
    /// A point of three coordinates.
    pub(super) fn coordinates(
        &mut self,
        coordinates: &[Expr; 3],
        frame: &mut LaneFrame<'_>,
    ) -> Option<Compiled> {
        if self.is_for_bounds {
            return None;
        }
        let mut coordinate = |expr: &Expr| {
            let (node, dim) = self.expr(expr, frame)?.number()?;
            dim.is_as_length().then_some(node)
        };
        let [x, y, z] = coordinates;
        let nodes = [coordinate(x)?, coordinate(y)?, coordinate(z)?];
        Some(Compiled::Point(PointNode::Coordinates(Box::new(nodes))))
    }

    /// A built-in function of vectors, or that makes one of a length and an angle.
    pub(super) fn of_vectors(
        &mut self,
        function: OnVectors,
        call: &CallExpr,
        frame: &mut LaneFrame<'_>,
    ) -> Option<Compiled> {
        if self.is_for_bounds {
            return None;
        }
        let mut args = Vec::with_capacity(call.args.len());
        for arg in &call.args {
            args.push(self.expr(arg.value.as_ref()?, frame)?);
        }
        if let OnVectors::OfLengthAndAngle(of) = function {
            let [length, angle] = <[Compiled; 2]>::try_from(args).ok()?;
            let ((length, a), (angle, b)) = (length.number()?, angle.number()?);
            let node = PointNode::OfLengthAndAngle(of, Box::new([length, angle]));
            return OnVectors::are_length_and_angle(a, b).then_some(Compiled::Point(node));
        }
        let points: Vec<PointNode> =
            args.into_iter().map(Compiled::point).collect::<Option<_>>()?;
        match (function, points.len()) {
            (OnVectors::NumberOfOne(dim, _), 1) | (OnVectors::NumberOfTwo(dim, _), 2) => {
                Some(Compiled::Number(LaneNode::OfVectors(function, points), dim))
            }
            (OnVectors::VectorOfOne(_), 1) | (OnVectors::VectorOfTwo(_), 2) => {
                Some(Compiled::Point(PointNode::OfVectors(function, points)))
            }
            _ => None,
        }
    }
}

impl Compiled {
    pub(super) fn is_point(&self) -> bool {
        matches!(
            self,
            Self::Point(_)
                | Self::LaneInput(LaneInput::Point(_) | LaneInput::Value(Value::Point(_)))
        )
    }

    pub(super) fn point(self) -> Option<PointNode> {
        let of = |nodes| Some(PointNode::Coordinates(Box::new(nodes)));
        match self {
            Self::Point(node) => Some(node),
            Self::LaneInput(LaneInput::Point(lanes)) => of(lanes.map(LaneNode::Variable)),
            Self::LaneInput(LaneInput::Value(Value::Point(point))) => {
                of(point.to_array().map(LaneNode::Constant))
            }
            _ => None,
        }
    }

    /// A coordinate of a point.
    pub(super) fn coordinate(self, name: &str) -> Option<Self> {
        let axis = ["x", "y", "z"].iter().position(|axis| *axis == name)?;
        let node = match self {
            Self::LaneInput(LaneInput::Point(lanes)) => LaneNode::Variable(lanes[axis]),
            Self::LaneInput(LaneInput::Value(Value::Point(point))) => {
                LaneNode::Constant(point[axis])
            }
            _ => LaneNode::Coordinate(axis, Box::new(self.point()?)),
        };
        Some(Self::Number(node, Dimension::OPEN))
    }

    /// What an operator makes of two points, or of a point and a number.
    pub(super) fn with_points(self, row: &'static Arithmetic, other: Self) -> Option<Self> {
        let takes = |sides| row.sides.contains(&sides);
        let scaled = |point: Self, number: Self| {
            let (factor, dim) = number.number()?;
            let sides = Box::new((point.point()?, factor));
            (dim.angle_power() == 0).then_some(Self::Point(PointNode::Scaled(row, sides)))
        };
        match (self.is_point(), other.is_point()) {
            (true, true) if takes(Sides::Points) => {
                let sides = Box::new([self.point()?, other.point()?]);
                Some(Self::Point(PointNode::Arithmetic(row, sides)))
            }
            (true, false) if takes(Sides::PointByNumber) => scaled(self, other),
            (false, true) if takes(Sides::NumberByPoint) => scaled(other, self),
            _ => None,
        }
    }
}
