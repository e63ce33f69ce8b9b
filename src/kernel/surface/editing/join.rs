//! A grid of patches as one surface.

use glam::DVec4;

use crate::{
    CountError, GeomError, Grid, JointError, KnotError,
    compatible::on_common_knots,
    homogeneous,
    joint::{Joined, joint_accuracy, vanishing_span},
    refine::ControlLines,
    surface::{Direction, NurbsSurface},
    tolerance::{EXACT_RELATIVE, JOINT_REMOVAL_SHARE},
};

/// The patches `[i][j]`, i along u, as one surface on the domain of the first and those of the
/// others behind it, each as long as it was; patches beside one another share the domain of the
/// first of them.
///
/// All get the highest degrees among them, and weights that go on from one to the next. A joint
/// keeps only the knots that its continuity needs. Sides that differ within the tolerance meet
/// halfway.
///
/// # Errors
/// [`CountError::CountTooSmall`] of an empty grid; [`JointError::PatchGap`] wider than the tolerance; [`JointError::UnlikeWeights`] where two sides
/// are one curve run through at different speeds; [`KnotError::VanishingPatch`];
/// `InputError::NotFinite` or `WeightError::VanishingWeightsAt` where the weights leave the numbers.
pub fn join_patches(
    patches: &Grid<NurbsSurface>,
    tolerance: f64,
) -> Result<NurbsSurface, GeomError> {
    let (n_rows, n_columns) = (patches.n_rows(), patches.n_columns());
    for (what, got) in [("the number of rows", n_rows), ("the number of columns", n_columns)] {
        if got == 0 {
            return Err(CountError::CountTooSmall { what, got, needed: 1 }.into());
        }
    }
    check_domains(patches)?;

    // One after another along u, in strips that share the knots of v.
    let mut strips = Vec::with_capacity(n_columns);
    for j in 0..n_columns {
        let column: Vec<NurbsSurface> = (0..n_rows).map(|i| patches.row(i)[j].clone()).collect();
        let place = |i: usize| [i, j];
        strips.push(joined(&column, Direction::U, tolerance, &place)?);
    }
    joined(&strips, Direction::V, tolerance, &|j| [n_rows - 1, j])
}

/// Patches one after another along a direction.
fn joined(
    patches: &[NurbsSurface],
    along: Direction,
    tolerance: f64,
    place: &dyn Fn(usize) -> [usize; 2],
) -> Result<NurbsSurface, GeomError> {
    let across = along.other();
    let lines = on_common_knots(patches.iter().map(|patch| patch.lines(across)).collect())?;
    let beside: Vec<NurbsSurface> =
        patches.iter().zip(lines).map(|(patch, lines)| patch.with_lines(across, lines)).collect();
    if beside.len() == 1 {
        return Ok(beside[0].clone());
    }
    let degree = beside.iter().map(|patch| patch.knots(along).degree()).max().unwrap_or(0).max(1);
    let raised = |patch: &NurbsSurface| patch.clamped(along).lines(along).elevated(degree);
    let mut chain = Joined::new(raised(&beside[0])?);
    for (i, patch) in beside.iter().enumerate().skip(1) {
        let next = raised(patch)?;
        let places = [place(i - 1), place(i)];
        let gap = meeting(&chain.ends(), &next, places)?;
        if tolerance < gap.width {
            let [before, next] = places;
            let (gap, along) = (gap.width, along.name());
            return Err(JointError::PatchGap { along, before, next, gap, tolerance }.into());
        }
        let accuracy =
            joint_accuracy(magnitude(&next), JOINT_REMOVAL_SHARE * tolerance) + gap.width;
        chain.append(&next, gap.scale, accuracy);
    }
    let chain = chain.finish()?;
    let whole = beside[0].with_lines(along, chain);
    NurbsSurface::new(whole.knots_u, whole.knots_v, whole.control_points)
}

/// How two sides meet.
struct SideMatch {
    /// The factor of the next one's homogeneous points.
    scale: f64,
    /// How far control points are apart at most.
    width: f64,
}

/// # Errors
/// [`JointError::UnlikeWeights`].
fn meeting(
    ends: &[DVec4],
    next: &ControlLines,
    places: [[usize; 2]; 2],
) -> Result<SideMatch, GeomError> {
    let starts: Vec<DVec4> = next.lines.iter().map(|line| line[0]).collect();
    let sum = |points: &[DVec4]| points.iter().map(|point| point.w).sum::<f64>();
    let scale = sum(ends) / sum(&starts);
    let largest = ends.iter().map(|point| point.w.abs()).fold(0.0, f64::max);
    let mut width: f64 = 0.0;
    for (&end, &start) in ends.iter().zip(&starts) {
        width = width.max(homogeneous::place(end).distance(homogeneous::place(start)));
        if EXACT_RELATIVE * largest < (end.w - start.w * scale).abs() {
            let [before, next] = places;
            return Err(JointError::UnlikeWeights { before, next }.into());
        }
    }
    Ok(SideMatch { scale, width })
}

/// The largest coordinate of a control point.
fn magnitude(lines: &ControlLines) -> f64 {
    let largest = |&point: &DVec4| homogeneous::place(point).abs().max_element();
    lines.lines.iter().flatten().map(largest).fold(0.0, f64::max)
}

/// # Errors
/// [`KnotError::VanishingPatch`].
fn check_domains(patches: &Grid<NurbsSurface>) -> Result<(), GeomError> {
    let (n_rows, n_columns) = (patches.n_rows(), patches.n_columns());
    let patch = |i: usize, j: usize| &patches.row(i)[j];
    let length = |i: usize, j: usize, along: Direction| patch(i, j).domain(along).length();
    let total_u: f64 = (0..n_rows).map(|i| length(i, 0, Direction::U)).sum();
    let total_v: f64 = (0..n_columns).map(|j| length(0, j, Direction::V)).sum();
    for i in 0..n_rows {
        for j in 0..n_columns {
            for (along, total) in [(Direction::U, total_u), (Direction::V, total_v)] {
                if let Some(length) = vanishing_span(patch(i, j).knots(along), total) {
                    return Err(KnotError::VanishingPatch { patch: [i, j], length, total }.into());
                }
            }
        }
    }
    Ok(())
}
