//! Many sheets, of which each is held whole only until its edges are divided.
//!
//! What bounds a sheet takes some fifty kilobytes, however few triangles it becomes. It is asked until the sheets beside
//! it have their cells too, so that of sheets in any order in which neighbours are near one another, few are held at once.

use super::{
    cell_bounds::TessellationOptions,
    division::KnownPlaces,
    seam::{SharedEdges, Vertices},
    surface_patch::{Cells, SurfacePatch},
};
use crate::{GeomError, side_by_side};

/// Sheets whose cells are found before the edges that they share are divided.
const SHEETS_AT_ONCE: usize = 64;

/// The cells of all sheets and the vertices on their edges, by up to `n_threads` threads, each sheet with the limits
/// `alone`; these are kept where the angle is limited, since they may be made sharper then.
///
/// # Errors
/// Those of [`SurfacePatch::cells`] and of [`SharedEdges::vertices`].
pub(super) fn cells_and_vertices(
    seams: &SharedEdges,
    (sheets, known): (&[SurfacePatch<'_>], &KnownPlaces),
    alone: &TessellationOptions,
    [most, n_threads]: [usize; 2],
) -> Result<(Vec<Cells>, Vec<[Vertices; 4]>), GeomError> {
    // A seam is divided when the last of its sheets has cells, a sheet let go of when the last of its seams is.
    let mut last_of_sheet: Vec<usize> = (0..sheets.len()).collect();
    let mut ending: Vec<Vec<usize>> = vec![Vec::new(); sheets.len()];
    for seam in 0..seams.seams.len() {
        let last = seams.sheets_of(seam).max().unwrap_or(0);
        ending[last].push(seam);
        seams.sheets_of(seam).for_each(|i| last_of_sheet[i] = last_of_sheet[i].max(last));
    }
    let mut cells: Vec<Cells> = Vec::with_capacity(sheets.len());
    let mut found: Vec<Vertices> = vec![Vertices::new(); seams.stretches.len()];
    let mut held: Vec<usize> = Vec::new();
    let numbers: Vec<usize> = (0..sheets.len()).collect();
    for block in numbers.chunks(SHEETS_AT_ONCE) {
        let made = side_by_side::map(block, n_threads, |&i| {
            let cells = sheets[i].cells(sheets[i].limits(alone), most)?;
            Ok::<_, GeomError>(cells.of_ball(sheets[i].ball(alone)))
        });
        for made in made {
            cells.push(made?);
        }
        let whole: Vec<usize> = block.iter().flat_map(|&i| ending[i].iter().copied()).collect();
        seams.divide(&whole, (sheets, &cells, known), [most, n_threads], &mut found)?;
        if !alone.limits_angle() {
            held.extend(block);
            held.retain(|&i| {
                let is_needed = cells.len() <= last_of_sheet[i];
                if !is_needed && !cells[i].can_unfold() {
                    cells[i].let_go();
                }
                is_needed
            });
        }
    }
    Ok((cells, seams.around(sheets.len(), found)))
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::{SharedEdges, SurfacePatch, TessellationOptions, cells_and_vertices};
    use crate::NurbsSurface;

    #[test]
    fn limits_are_let_go_of_unless_they_may_be_made_sharper() {
        let corner = |i: u32, y: f64| DVec3::new(f64::from(i), y, 0.3 * f64::from(i) * y);
        let strip: Vec<NurbsSurface> = (0..100)
            .map(|i| {
                let [a, b] = [i, i + 1].map(|i| [corner(i, 0.0), corner(i, 1.0)]);
                NurbsSurface::bilinear(a[0], a[1], b[0], b[1]).unwrap()
            })
            .collect();
        for (angle, is_kept) in [(4.0, false), (0.5, true)] {
            let wanted = TessellationOptions { angle, ..TessellationOptions::within(0.01) };
            let mut sheets: Vec<SurfacePatch<'_>> =
                strip.iter().map(|patch| SurfacePatch::of_spline(patch, 0.01)).collect();
            let seams = SharedEdges::of(&mut sheets, &[], &wanted).unwrap();
            let of = (&sheets[..], &seams.places());
            let (cells, edges) = cells_and_vertices(&seams, of, &wanted, [10_000, 1]).unwrap();
            assert!(cells.iter().all(|cells| cells.limits().is_some() == is_kept));
            for pair in edges.windows(2) {
                let points = |edge: &[(f64, DVec3)]| -> Vec<DVec3> {
                    edge.iter().map(|&(_, point)| point).collect()
                };
                assert!(2 <= pair[0][1].len());
                assert_eq!(points(&pair[0][1]), points(&pair[1][0]));
            }
        }
    }
}
