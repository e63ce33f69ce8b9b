//! Runs compiled comprehensions over a block of lanes.

use super::node::{LaneDefinition, LaneNode, TruthNode};

/// The lanes of a block.
#[derive(Debug)]
pub(super) struct Runner {
    lanes: Vec<Vec<f64>>,
    len: usize,
    steps: u64,
}

impl Runner {
    pub(super) fn new(n_variables: usize, len: usize) -> Self {
        Self { lanes: vec![Vec::new(); n_variables], len, steps: 0 }
    }

    pub(super) fn len(&self) -> usize {
        self.len
    }

    /// Calls so far, a step for each element.
    pub(super) fn steps(&self) -> u64 {
        self.steps
    }

    /// One call for each element.
    pub(super) fn count_calls(&mut self) {
        self.steps += self.len as u64;
    }

    pub(super) fn lane(&mut self, variable: usize) -> &mut Vec<f64> {
        &mut self.lanes[variable]
    }

    /// The same lanes, of the elements that `mask` says to be `wanted`.
    pub(super) fn narrowed(&self, mask: &[bool], wanted: bool) -> Self {
        let narrow = |lane: &Vec<f64>| {
            let chosen = lane.iter().zip(mask).filter(|&(_, &is)| is == wanted);
            chosen.map(|(&value, _)| value).collect()
        };
        let len = mask.iter().filter(|&&is| is == wanted).count();
        Self { lanes: self.lanes.iter().map(narrow).collect(), len, steps: 0 }
    }

    /// Computes a number for each element; `None` where one of them is none.
    pub(super) fn number(&mut self, node: &LaneNode, out: &mut [f64]) -> Option<()> {
        match node {
            LaneNode::Constant(value) => out.fill(*value),
            LaneNode::Variable(variable) => out.copy_from_slice(&self.lanes[*variable]),
            LaneNode::Unary(row, inner) => {
                self.number(inner, out)?;
                (row.on_lane)(out);
            }
            LaneNode::Arithmetic(row, sides) => {
                let [left, right] = &**sides;
                self.number(left, out)?;
                match right {
                    LaneNode::Constant(value) => (row.on_constant)(out, *value),
                    LaneNode::Variable(variable) => {
                        (row.on_lane)(out, &self.lanes[*variable]);
                    }
                    _ => {
                        let other = self.computed(right)?;
                        (row.on_lane)(out, &other);
                    }
                }
                return are_finite(out).then_some(());
            }
            LaneNode::Builtin(function, args) => {
                let (first, others) = &**args;
                self.number(first, out)?;
                let others: Vec<Vec<f64>> =
                    others.iter().map(|node| self.computed(node)).collect::<Option<_>>()?;
                function.apply(out, &others);
                self.count_calls();
                return are_finite(out).then_some(());
            }
            LaneNode::Enclosed(..) => return None,
            LaneNode::OfVectors(function, points) => {
                self.of_vectors(function, points, out)?;
                return are_finite(out).then_some(());
            }
            LaneNode::Coordinate(axis, point) => {
                out.copy_from_slice(&self.point(point)?[*axis]);
            }
            LaneNode::Choose(condition, sides) => self.choose(condition, sides, out)?,
            LaneNode::Let(definitions, value, n_calls) => {
                self.define(definitions, *n_calls)?;
                self.number(value, out)?;
            }
        }
        Some(())
    }

    /// The lane of a number that is computed for each element.
    pub(super) fn computed(&mut self, node: &LaneNode) -> Option<Vec<f64>> {
        let mut lane = vec![0.0; self.len];
        self.number(node, &mut lane)?;
        Some(lane)
    }

    pub(super) fn define(&mut self, definitions: &[LaneDefinition], n_calls: u64) -> Option<()> {
        self.steps += n_calls * self.len as u64;
        for definition in definitions {
            match definition {
                LaneDefinition::Number(variable, node) => {
                    self.lanes[*variable] = self.computed(node)?;
                }
                LaneDefinition::Point(variables, node) => {
                    for (variable, lane) in variables.iter().zip(self.point(node)?) {
                        self.lanes[*variable] = lane;
                    }
                }
            }
        }
        Some(())
    }

    /// Each side only where the condition asks for it.
    fn choose(
        &mut self,
        condition: &TruthNode,
        sides: &[LaneNode; 2],
        out: &mut [f64],
    ) -> Option<()> {
        let mask = self.truth(condition)?;
        for (wanted, side) in [(true, &sides[0]), (false, &sides[1])] {
            let n = mask.iter().filter(|&&is| is == wanted).count();
            if n == self.len {
                self.number(side, out)?;
            } else if 0 < n {
                let mut part = self.narrowed(&mask, wanted);
                let mut values = vec![0.0; n];
                part.number(side, &mut values)?;
                self.steps += part.steps;
                let places = out.iter_mut().zip(&mask).filter(|&(_, &is)| is == wanted);
                places.zip(values).for_each(|((place, _), value)| *place = value);
            }
        }
        Some(())
    }

    /// Computes a truth for each element.
    pub(super) fn truth(&mut self, truth: &TruthNode) -> Option<Vec<bool>> {
        Some(match truth {
            TruthNode::Constant(value) => vec![*value; self.len],
            TruthNode::Compare(row, sides) => {
                let mut lanes = [vec![0.0; self.len], vec![0.0; self.len]];
                for (side, lane) in sides.iter().zip(&mut lanes) {
                    self.number(side, lane)?;
                }
                (row.lanes)(&lanes[0], &lanes[1])
            }
            TruthNode::Not(truth_of, inner) => {
                self.truth(inner)?.into_iter().map(truth_of).collect()
            }
            TruthNode::Logic { decided_by, sides } => self.both(sides, *decided_by)?,
            TruthNode::Let(definitions, value, n_calls) => {
                self.define(definitions, *n_calls)?;
                self.truth(value)?
            }
        })
    }

    /// The first truth, and where it is not the one that decides the second.
    fn both(&mut self, sides: &[TruthNode; 2], decided_by: bool) -> Option<Vec<bool>> {
        let mut mask = self.truth(&sides[0])?;
        let mut part = self.narrowed(&mask, !decided_by);
        let mut rest = part.truth(&sides[1])?.into_iter();
        self.steps += part.steps;
        for is in mask.iter_mut().filter(|is| **is != decided_by) {
            *is = rest.next()?;
        }
        Some(mask)
    }
}

/// Whether no number of a lane is infinite or none at all.
pub(super) fn are_finite(lane: &[f64]) -> bool {
    /// All bits of the exponent, which only those have.
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    !lane.iter().fold(false, |bad, value| bad | (value.to_bits() & EXPONENT == EXPONENT))
}
