//! Runs compiled computations of points over a block of lanes, three for each point.

use glam::DVec3;

use super::{
    node::{LaneNode, PointNode},
    run::{Runner, are_finite},
};
use crate::value::OnVectors;

/// A lane for each coordinate.
pub(super) type PointLanes = [Vec<f64>; 3];

impl Runner {
    /// Computes a point for each element; `None` where one of them is none.
    pub(super) fn point(&mut self, node: &PointNode) -> Option<PointLanes> {
        match node {
            PointNode::Coordinates(nodes) => {
                let [x, y, z] = &**nodes;
                Some([self.computed(x)?, self.computed(y)?, self.computed(z)?])
            }
            PointNode::Unary(row, inner) => {
                let mut lanes = self.point(inner)?;
                lanes.iter_mut().for_each(|lane| (row.on_lane)(lane));
                Some(lanes)
            }
            PointNode::Arithmetic(row, sides) => {
                let (mut lanes, others) = (self.point(&sides[0])?, self.point(&sides[1])?);
                lanes.iter_mut().zip(&others).for_each(|(lane, other)| (row.on_lane)(lane, other));
                finite(lanes)
            }
            PointNode::Scaled(row, sides) => {
                let (point, factor) = &**sides;
                let mut lanes = self.point(point)?;
                match factor {
                    LaneNode::Constant(value) => {
                        lanes.iter_mut().for_each(|lane| (row.on_constant)(lane, *value));
                    }
                    _ => {
                        let factors = self.computed(factor)?;
                        lanes.iter_mut().for_each(|lane| (row.on_lane)(lane, &factors));
                    }
                }
                finite(lanes)
            }
            PointNode::OfVectors(function, points) => {
                let args = self.points(points)?;
                self.count_calls();
                match (function, &args[..]) {
                    (OnVectors::VectorOfOne(of), [a]) => each(self.len(), |i| of(at(a, i))),
                    (OnVectors::VectorOfTwo(of), [a, b]) => {
                        each(self.len(), |i| of(at(a, i), at(b, i)))
                    }
                    _ => None,
                }
            }
            PointNode::OfLengthAndAngle(of, args) => {
                let (lengths, angles) = (self.computed(&args[0])?, self.computed(&args[1])?);
                self.count_calls();
                each(self.len(), |i| of(lengths[i], angles[i]))
            }
            PointNode::Let(definitions, value, n_calls) => {
                self.define(definitions, *n_calls)?;
                self.point(value)
            }
        }
    }

    /// Computes a number of vectors for each element.
    pub(super) fn of_vectors(
        &mut self,
        function: &OnVectors,
        points: &[PointNode],
        out: &mut [f64],
    ) -> Option<()> {
        let args = self.points(points)?;
        self.count_calls();
        let places = out.iter_mut().enumerate();
        match (function, &args[..]) {
            (OnVectors::NumberOfOne(_, of), [a]) => {
                places.for_each(|(i, out)| *out = of(at(a, i)));
            }
            (OnVectors::NumberOfTwo(_, of), [a, b]) => {
                places.for_each(|(i, out)| *out = of(at(a, i), at(b, i)));
            }
            _ => return None,
        }
        Some(())
    }

    fn points(&mut self, nodes: &[PointNode]) -> Option<Vec<PointLanes>> {
        nodes.iter().map(|node| self.point(node)).collect()
    }
}

fn at([x, y, z]: &PointLanes, i: usize) -> DVec3 {
    DVec3::new(x[i], y[i], z[i])
}

fn each(n: usize, of: impl Fn(usize) -> DVec3) -> Option<PointLanes> {
    let mut lanes = [(); 3].map(|()| Vec::with_capacity(n));
    for i in 0..n {
        let point = of(i).to_array();
        lanes.iter_mut().zip(point).for_each(|(lane, coordinate)| lane.push(coordinate));
    }
    finite(lanes)
}

fn finite(lanes: PointLanes) -> Option<PointLanes> {
    lanes.iter().all(|lane| are_finite(lane)).then_some(lanes)
}
