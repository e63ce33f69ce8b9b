//! The parts into which arcs divide a plane, as regions.

use std::collections::BTreeSet;

use super::{PlaneLoop, Region, RegionError};
use crate::{
    Bounds, Frame, GeomError,
    arrange::{Arrangement, CellLoop, OrientedEdge},
    sorting::sort_by,
};

/// A part of the plane that no edge of an arrangement runs through.
pub(crate) struct PlaneCell {
    pub(crate) region: Region,
    pub(crate) area: f64,
    /// The edges around it, and whether it is to the left of them.
    pub(crate) steps: Vec<OrientedEdge>,
}

/// Such a part, with what is known of its borders.
struct BorderedCell {
    /// What its outer border goes around, and what is left of that by its holes.
    within: f64,
    area: f64,
    /// The number that edges have in common which hang together with that.
    component: usize,
    /// The outer border and those of the holes, and the steps around each of them.
    loops: Vec<PlaneLoop>,
    steps: Vec<Vec<OrientedEdge>>,
}

/// The numbers of edges, in order.
fn sorted_edges(steps: &[OrientedEdge]) -> Vec<usize> {
    let mut edges: Vec<usize> = steps.iter().map(|&(edge, _)| edge).collect();
    edges.sort_unstable();
    edges
}

/// Whether each edge of a loop is run along both ways: it holds nothing.
fn runs_there_and_back(steps: &[OrientedEdge]) -> bool {
    let mut sorted = steps.to_vec();
    sorted.sort_unstable();
    let (pairs, rest) = sorted.as_chunks::<2>();
    rest.is_empty() && pairs.iter().all(|[there, back]| there.0 == back.0 && there.1 != back.1)
}

/// The bounded parts into which the edges divide the plane z = 0, in the order in which they are found;
/// no edge may be loose. Chains of edges with the same part on both sides are around none. Where loops around a part
/// touch their arcs are cut.
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
            let (loops, steps) = (vec![border], vec![steps]);
            parts.push(BorderedCell { within: area, area, component, loops, steps });
        } else {
            holes.push((component, border, area, steps));
        }
    }
    let outer_edges: Vec<Vec<usize>> =
        parts.iter().map(|part| sorted_edges(&part.steps[0])).collect();
    let bounds: Vec<Bounds> = parts.iter().map(|part| part.loops[0].bounds()).collect();
    // The smallest that holds a hole has it.
    let mut by_area: Vec<usize> = (0..parts.len()).collect();
    sort_by(&mut by_area, |&a, &b| parts[a].within.total_cmp(&parts[b].within));
    for (component, hole, area, steps) in holes {
        let (mut around, within) = (None, hole.bounds());
        GeomError::go_on(1 + parts.len())?;
        for &i in &by_area {
            let part = &parts[i];
            // What hangs on a part in vertices alone may be a hole of it; along an edge they are neighbours.
            let is_beside =
                || steps.iter().any(|(edge, _)| outer_edges[i].binary_search(edge).is_ok());
            if bounds[i].holds(within, distance)
                && !(part.component == component && is_beside())
                && part.loops[0].holds(&hole)?
            {
                around = Some(i);
                break;
            }
        }
        // What goes around everything of its own has nothing around it.
        if let Some(around) = around {
            parts[around].area += area;
            parts[around].loops.push(hole);
            parts[around].steps.push(steps);
        }
    }
    let mut cells = Vec::with_capacity(parts.len());
    for BorderedCell { area, mut loops, steps, .. } in parts {
        cut_where_they_touch(&mut loops, &steps, arrangement)?;
        let region = Region { frame: Frame::XY, loops };
        cells.push(PlaneCell { region, area, steps: steps.concat() });
    }
    Ok(cells)
}

/// Cuts the arcs of loops with these steps at the vertices through which more than one of them goes.
///
/// # Errors
/// Those of [`Arrangement::arcs_of`].
fn cut_where_they_touch(
    loops: &mut [PlaneLoop],
    steps: &[Vec<OrientedEdge>],
    arrangement: &Arrangement,
) -> Result<(), GeomError> {
    let (mut known, mut shared) = (BTreeSet::new(), BTreeSet::new());
    for step in steps.iter().flatten() {
        let vertex = arrangement.ends_of(*step)[0];
        if !known.insert(vertex) {
            shared.insert(vertex);
        }
    }
    let touches = |steps: &[OrientedEdge]| {
        steps.iter().any(|&step| shared.contains(&arrangement.ends_of(step)[0]))
    };
    for (border, steps) in loops.iter_mut().zip(steps).filter(|(_, steps)| touches(steps)) {
        border.arcs = arrangement.arcs_of(steps, |vertex| shared.contains(&vertex))?;
    }
    Ok(())
}
