//! The parts into which arcs divide a plane, as regions.

use super::{PlaneLoop, Region, RegionError};
use crate::{
    Frame, GeomError,
    arrange::{Arrangement, CellLoop, OrientedEdge},
};

/// A part of the plane that no edge of an arrangement runs through.
pub(crate) struct PlaneCell {
    pub(crate) region: Region,
    /// The edges around it, and whether it is to the left of them.
    pub(crate) steps: Vec<OrientedEdge>,
}

impl PlaneCell {
    /// The edges around it, in the order of their numbers.
    fn edges(&self) -> Vec<usize> {
        let mut edges: Vec<usize> = self.steps.iter().map(|&(edge, _)| edge).collect();
        edges.sort_unstable();
        edges
    }
}

/// Whether each edge of a loop is run along both ways: it holds nothing.
fn runs_there_and_back(steps: &[OrientedEdge]) -> bool {
    let mut sorted = steps.to_vec();
    sorted.sort_unstable();
    let (pairs, rest) = sorted.as_chunks::<2>();
    rest.is_empty() && pairs.iter().all(|[there, back]| there.0 == back.0 && there.1 != back.1)
}

/// The bounded parts into which the edges divide the plane z = 0, in the order in which they are found;
/// no edge may be loose. Chains of edges with the same part on both sides are around none.
///
/// # Errors
/// [`RegionError::Unclear`], [`RegionError::Thin`].
pub(crate) fn cells(arrangement: &Arrangement, distance: f64) -> Result<Vec<PlaneCell>, GeomError> {
    let (mut parts, mut holes) = (Vec::new(), Vec::new());
    for CellLoop { steps, arcs, component } in arrangement.cell_loops()? {
        GeomError::go_on(1)?;
        if runs_there_and_back(&steps) {
            continue;
        }
        let border = PlaneLoop { arcs };
        let area = border.area();
        if border.is_strip(area, 0.5 * distance) {
            let (width, point) = (2.0 * area.abs() / border.length(), border.arcs[0].start());
            return Err(RegionError::Thin { point, width, tolerance: distance }.into());
        }
        if 0.0 < area {
            let region = Region { frame: Frame::XY, loops: vec![border] };
            parts.push((area, component, PlaneCell { region, steps }));
        } else {
            holes.push((component, border, steps));
        }
    }
    let outer_edges: Vec<Vec<usize>> = parts.iter().map(|(.., part)| part.edges()).collect();
    for (component, hole, steps) in holes {
        let mut around: Option<usize> = None;
        for (i, (area, own, part)) in parts.iter().enumerate() {
            let is_smaller = around.is_none_or(|best| *area < parts[best].0);
            let outer = &part.region.loops[0];
            // What hangs on a part in vertices alone may be a hole of it; along an edge they are neighbours.
            let is_beside =
                || steps.iter().any(|(edge, _)| outer_edges[i].binary_search(edge).is_ok());
            let may = is_smaller && outer.bounds().holds(hole.bounds(), distance);
            if may && !(*own == component && is_beside()) && outer.holds(&hole)? {
                around = Some(i);
            }
        }
        // What goes around everything of its own has nothing around it.
        if let Some(around) = around {
            let part = &mut parts[around].2;
            part.region.loops.push(hole);
            part.steps.extend(steps);
        }
    }
    Ok(parts.into_iter().map(|(_, _, part)| part).collect())
}
