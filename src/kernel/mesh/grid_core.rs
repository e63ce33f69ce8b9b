//! Whole cells of a grid within borders, which need no triangulation.
//!
//! A cell whose corners are all given and through which no border goes is two triangles at once. Only between
//! these cells and the borders is triangulated, with the sides of the outermost cells as borders more.

use glam::DVec2;

use super::{even_plane::cells_along, triangulation::BorderPolygon};
use crate::GeomError;

/// A corner that is not given.
const NONE: u32 = u32::MAX;

/// Corners of an even grid, and the cells between them that are whole.
pub(super) struct GridCore {
    /// Those that are corners of other triangles too, at whole coordinates.
    pub(super) shared: Vec<DVec2>,
    /// Those that are corners of whole cells alone.
    pub(super) deep: Vec<DVec2>,
    /// The sides that a whole cell has in common with none: pairs of numbers of shared corners.
    pub(super) sides: Vec<[usize; 2]>,
    n_shared: usize,
    /// The whole cells: the numbers of their corners, the shared ones first, counter-clockwise from the least.
    cells: Vec<[u32; 4]>,
}

/// The numbers of corners and the whole cells of the part of a grid in which corners are given, by rows.
struct CellMarks {
    /// Its least coordinates.
    origin: DVec2,
    n_columns: usize,
    corners: Vec<u32>,
    is_whole: Vec<bool>,
}

/// The row and the column of a corner.
fn place_of(corner: DVec2, origin: DVec2) -> [usize; 2] {
    let DVec2 { x, y } = corner - origin;
    [x as usize, y as usize]
}

impl CellMarks {
    fn place(&self, corner: DVec2) -> [usize; 2] {
        place_of(corner, self.origin)
    }

    fn corner(&self, i: usize, j: usize) -> u32 {
        self.corners[i * self.n_columns + j]
    }

    /// Whether a cell is whole, none of the outside.
    fn is_whole(&self, i: usize, j: usize) -> bool {
        j + 1 < self.n_columns
            && self.is_whole.get(i * (self.n_columns - 1) + j).is_some_and(|&is_whole| is_whole)
    }

    /// Whether all four cells about a corner are whole.
    fn is_deep(&self, i: usize, j: usize) -> bool {
        let (Some(low), Some(left)) = (i.checked_sub(1), j.checked_sub(1)) else { return false };
        [low, i].into_iter().all(|i| [left, j].into_iter().all(|j| self.is_whole(i, j)))
    }
}

impl GridCore {
    /// Of the corners of a grid that lie within borders and keep away from them, by rows.
    ///
    /// # Errors
    /// `GeomError::Ended`.
    pub(super) fn of(corners: &[DVec2], rings: &[BorderPolygon]) -> Result<Self, GeomError> {
        let origin = corners.iter().copied().reduce(DVec2::min).unwrap_or(DVec2::ZERO);
        let last = corners.iter().copied().reduce(DVec2::max).unwrap_or(DVec2::ZERO) - origin;
        let [n_rows, n_columns] = [last.x as usize + 1, last.y as usize + 1];
        let is_whole = vec![false; (n_rows - 1) * (n_columns - 1)];
        let numbers = vec![NONE; n_rows * n_columns];
        let mut marks = CellMarks { origin, n_columns, corners: numbers, is_whole };
        for (number, corner) in corners.iter().enumerate() {
            let [i, j] = marks.place(*corner);
            marks.corners[i * n_columns + j] = number as u32;
        }
        let is_crossed = crossed_cells(rings, origin, [n_rows - 1, n_columns - 1])?;
        for &corner in corners {
            GeomError::go_on(1)?;
            let [i, j] = marks.place(corner);
            if i + 1 == n_rows || j + 1 == n_columns {
                continue;
            }
            let others = [[i + 1, j], [i, j + 1], [i + 1, j + 1]];
            let cell = i * (n_columns - 1) + j;
            marks.is_whole[cell] =
                !is_crossed[cell] && others.into_iter().all(|[i, j]| marks.corner(i, j) != NONE);
        }
        Ok(Self::with(corners, marks))
    }

    fn with(corners: &[DVec2], mut marks: CellMarks) -> Self {
        let origin = marks.origin;
        let place = |corner: &DVec2| place_of(*corner, origin);
        let is_deep = |corner: &&DVec2| {
            let [i, j] = place(corner);
            marks.is_deep(i, j)
        };
        let (deep, shared): (Vec<&DVec2>, Vec<&DVec2>) = corners.iter().partition(is_deep);
        let numbered = shared.iter().chain(&deep).map(|corner| place(corner)).enumerate();
        for (number, [i, j]) in numbered {
            marks.corners[i * marks.n_columns + j] = number as u32;
        }
        let (mut cells, mut sides) = (Vec::new(), Vec::new());
        for [i, j] in corners.iter().map(place).filter(|&[i, j]| marks.is_whole(i, j)) {
            let [a, b, c, d] =
                [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(|[i, j]| marks.corner(i, j));
            cells.push([a, b, c, d]);
            let before = |k: usize| k.checked_sub(1);
            let beside = [
                (before(j).map(|j| [i, j]), [a, b]),
                (Some([i + 1, j]), [b, c]),
                (Some([i, j + 1]), [c, d]),
                (before(i).map(|i| [i, j]), [d, a]),
            ];
            for (beside, ends) in beside {
                if !beside.is_some_and(|[i, j]| marks.is_whole(i, j)) {
                    sides.push(ends.map(|end| end as usize));
                }
            }
        }
        let n_shared = shared.len();
        let [shared, deep] = [shared, deep].map(|corners| corners.into_iter().copied().collect());
        Self { shared, deep, sides, n_shared, cells }
    }

    /// The triangles of the whole cells, as those of a grid, with the numbers of the first shared corner and of the
    /// first deep one.
    pub(super) fn triangles(&self, first: usize, first_deep: usize) -> Vec<[u32; 3]> {
        let n_shared = self.n_shared as u32;
        let number = |corner: u32| match corner.checked_sub(n_shared) {
            Some(deep) => first_deep as u32 + deep,
            None => first as u32 + corner,
        };
        let of_cell = |cell: &[u32; 4]| {
            let [a, b, c, d] = cell.map(number);
            [[a, b, c], [a, c, d]]
        };
        self.cells.iter().flat_map(of_cell).collect()
    }
}

/// Which cells of a grid sides of polygons come to.
///
/// # Errors
/// `GeomError::Ended`.
fn crossed_cells(
    rings: &[BorderPolygon],
    origin: DVec2,
    [n_rows, n_columns]: [usize; 2],
) -> Result<Vec<bool>, GeomError> {
    let mut is_crossed = vec![false; n_rows * n_columns];
    for ring in rings {
        let n = ring.places.len();
        for k in 0..n {
            let [a, b] = [k, (k + 1) % n].map(|k| ring.places[k] - origin);
            let (low, high) = if a.x <= b.x { (a, b) } else { (b, a) };
            for i in cells_along(low.x, high.x, n_rows) {
                GeomError::go_on(1)?;
                // Where the side is between the lines beside the cells.
                let at = |x: f64| {
                    let share = (x - low.x) / (high.x - low.x);
                    let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
                    low.y + (high.y - low.y) * share
                };
                let mut ends = [at(i as f64), at((i + 1) as f64)];
                if high.x <= low.x {
                    ends = [low.y, high.y];
                }
                let [from, to] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
                for j in cells_along(from, to, n_columns) {
                    is_crossed[i * n_columns + j] = true;
                }
            }
        }
    }
    Ok(is_crossed)
}
