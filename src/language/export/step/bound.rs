//! What bounds parts of surfaces. ISO 10303-42, §5.4.
//!
//! A loop goes along a seam twice, there and back. Readers find a place on a sphere by angles, and lose their way
//! in a loop that turns back at both poles; the loops that are left without the seam bound the same part.

use super::{
    entity::{Id, Records},
    shape::{Carrier, bound, oriented},
};

/// An edge that a loop goes along, or back, and the vertices where it starts and ends on that way.
#[derive(Clone, Copy)]
pub(super) struct LoopStep {
    pub(super) edge: Id,
    pub(super) is_along: bool,
    pub(super) ends: [Id; 2],
}

/// The bounds of a part of a surface, the outer one first where there is one.
pub(super) fn bounds(
    loops: &[Vec<LoopStep>],
    carrier: &Carrier<'_>,
    file: &mut Records,
) -> Vec<Id> {
    let turns_back = loops.iter().map(|steps| n_turns_back(steps)).sum::<usize>();
    let rest = if carrier.is_sphere && 1 < turns_back { without_seams(loops) } else { Vec::new() };
    let has_outer = rest.is_empty();
    let loops = if has_outer { loops } else { &rest };
    let mut bounds = Vec::with_capacity(loops.len());
    for steps in loops.iter().filter(|steps| !steps.is_empty()) {
        let ids: Vec<Id> =
            steps.iter().map(|step| oriented(step.edge, step.is_along, file)).collect();
        bounds.push(bound(has_outer && bounds.is_empty(), &ids, file));
    }
    bounds
}

/// How often a loop goes back along the edge that it came by.
fn n_turns_back(steps: &[LoopStep]) -> usize {
    let next = steps.iter().cycle().skip(1);
    steps.iter().zip(next).filter(|(step, next)| step.edge == next.edge).count()
}

/// The loops of the edges that are gone along once.
fn without_seams(loops: &[Vec<LoopStep>]) -> Vec<Vec<LoopStep>> {
    let all: Vec<LoopStep> = loops.iter().flatten().copied().collect();
    let is_seam = |step: &LoopStep| 1 < all.iter().filter(|other| other.edge == step.edge).count();
    let mut rest: Vec<LoopStep> = all.iter().filter(|step| !is_seam(step)).copied().collect();
    let mut found = Vec::new();
    while let Some(first) = rest.pop() {
        let mut steps = vec![first];
        let mut at = first.ends[1];
        while at != first.ends[0]
            && let Some(next) = rest.iter().position(|step| step.ends[0] == at)
        {
            let step = rest.remove(next);
            at = step.ends[1];
            steps.push(step);
        }
        found.push(steps);
    }
    found
}
