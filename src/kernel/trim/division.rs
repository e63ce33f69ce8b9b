//! A face divided by arcs in its plane of parameters.

use glam::DVec3;

use super::{Face, FaceError, plane::ParameterPlane};
use crate::{
    GeomError, NurbsCurve, Region,
    arrange::{Apart, Arrangement, RaySearch, Ring, Windings},
    region::{PlaneCell, cells},
};

/// The group of the face's own border; arcs have those behind it.
pub(super) const BORDER: usize = 0;

/// The parts into which arcs divide a face.
pub(super) struct Division {
    arrangement: Arrangement,
    /// The cells within the face.
    cells: Vec<PlaneCell>,
    /// For each cell a number that it has in common with those that it hangs together with over seams.
    parts: Vec<usize>,
    /// Edges of arcs within the face that have one cell on both sides.
    slits: Vec<usize>,
    /// Where arcs end that divide nothing, each with its arc.
    pub(super) loose: Vec<(usize, DVec3)>,
}

/// The cells on both sides of an edge, of those within the face.
#[derive(Clone, Copy, Default)]
struct EdgeCells {
    left: Option<usize>,
    right: Option<usize>,
}

/// How an arc runs by the parts into which arcs divide a face.
#[derive(Clone, Copy, Default)]
pub(super) struct ArcCourse {
    /// It runs along one, or within one.
    pub(super) is_along: bool,
    /// It has two of them beside it, or one on one side alone.
    pub(super) is_between: bool,
}

/// Whether the face's own border winds around a place.
fn is_within(around: &Windings) -> bool {
    around.iter().any(|&(group, winding)| group == BORDER && winding != 0)
}

/// The chords of the halves of all arcs of a region's border.
fn chords(region: &Region) -> f64 {
    let of_arc = |arc: &NurbsCurve| {
        let middle = arc.point_at(arc.domain().at(0.5));
        arc.start().distance(middle) + middle.distance(arc.end())
    };
    region.arcs().flatten().map(of_arc).sum()
}

/// Fails where the parts of a face do not come to all of it, in its plane of parameters.
fn check_sum(face: &Face, cells: &[PlaneCell], tolerance: f64) -> Result<(), GeomError> {
    let parts = || cells.iter().map(|cell| &cell.region);
    let whole: f64 = face.parts.iter().map(Region::area).sum();
    let excess = cells.iter().map(|cell| cell.area).sum::<f64>() - whole;
    let is_within = |length: fn(&Region) -> f64| {
        excess.abs() <= tolerance * face.parts.iter().chain(parts()).map(length).sum::<f64>()
    };
    // A border is no shorter than its chords, which are known at once.
    match is_within(chords) || is_within(Region::length) {
        true => Ok(()),
        false => Err(FaceError::PartsMissArea { excess: excess / whole }.into()),
    }
}

impl Division {
    /// # Errors
    /// Those of an arrangement; [`crate::RegionError::Unclear`], [`crate::RegionError::Thin`];
    /// [`FaceError::PartsMissArea`].
    pub(super) fn of(
        face: &Face,
        arcs: &[NurbsCurve],
        tolerance: f64,
        n_threads: usize,
    ) -> Result<Self, GeomError> {
        let borders = face.parts.iter().flat_map(Region::arcs);
        let mut rings: Vec<Ring> =
            borders.map(|arcs| Ring { group: BORDER, arcs: arcs.to_vec() }).collect();
        let n_border: usize = rings.iter().map(|ring| ring.arcs.len()).sum();
        let cutters = arcs.iter().enumerate();
        rings.extend(cutters.map(|(i, arc)| Ring { group: i + 1, arcs: vec![arc.clone()] }));
        let mut arrangement = Arrangement::of(&rings, Apart::Nothing, tolerance, n_threads)?;
        let loose = arrangement.drop_loose_edges();
        let loose = loose
            .into_iter()
            .filter_map(|(arc, end)| arc.checked_sub(n_border).map(|arc| (arc, end)));
        let loose: Vec<(usize, DVec3)> = loose.collect();
        let search = RaySearch::of_groups(&arrangement, |group| group == BORDER);
        let mut inside = Vec::new();
        for cell in cells(&arrangement, tolerance)? {
            let around = cell.steps.iter().find_map(|&(edge, is_left)| {
                let [left, right] = search.around(edge)?;
                Some(if is_left { left } else { right })
            });
            let Some(around) = around else {
                let point = super::loops::place_of(std::slice::from_ref(&cell.region));
                return Err(crate::RegionError::Unclear { point }.into());
            };
            if is_within(&around) {
                inside.push(cell);
            }
        }
        let mut has_cell = vec![false; arrangement.edges.len()];
        inside.iter().flat_map(|cell| &cell.steps).for_each(|&(edge, _)| has_cell[edge] = true);
        let is_slit = |&edge: &usize| {
            let is_within =
                || search.around(edge).is_some_and(|around| around.iter().any(is_within));
            !has_cell[edge] && is_within()
        };
        let slits = (0..has_cell.len()).filter(is_slit).collect();
        drop(search);
        check_sum(face, &inside, tolerance)?;
        let parts = (0..inside.len()).collect();
        let mut division = Self { arrangement, cells: inside, parts, slits, loose };
        division.join_over_seams(&face.plane, tolerance);
        Ok(division)
    }

    /// For each edge the cells beside it.
    fn beside(&self) -> Vec<EdgeCells> {
        let mut beside = vec![EdgeCells::default(); self.arrangement.edges.len()];
        for (number, cell) in self.cells.iter().enumerate() {
            for &(edge, is_left) in &cell.steps {
                let side = if is_left { &mut beside[edge].left } else { &mut beside[edge].right };
                *side = Some(number);
            }
        }
        beside
    }

    /// Makes cells one part that are beside one another over a seam along which nothing cuts, unless it is a point.
    fn join_over_seams(&mut self, plane: &ParameterPlane, tolerance: f64) {
        let (beside, bounds) = (self.beside(), plane.bounds());
        for across in (0..2).filter(|&i| plane.is_closed[i] && !plane.has_point_seam(i, tolerance))
        {
            let along = 1 - across;
            // The stretches of both ends: from, to, the cell inside, whether something cuts along it.
            let stretches = [bounds.min[across], bounds.max[across]].map(|end| {
                let mut found: Vec<(f64, f64, usize, bool)> = Vec::new();
                for (edge, cells) in self.arrangement.edges.iter().zip(&beside) {
                    let domain = edge.curve.domain();
                    let places = [0.0, 0.5, 1.0].map(|at| edge.curve.point_at(domain.at(at)));
                    let is_there =
                        places.iter().all(|place| (place[across] - end).abs() <= tolerance);
                    let Some(cell) = cells.left.or(cells.right).filter(|_| is_there) else {
                        continue;
                    };
                    let [from, to] = [places[0][along], places[2][along]];
                    let is_cut = edge.passes.iter().any(|&(group, _)| group != BORDER);
                    found.push((from.min(to), from.max(to), cell, is_cut));
                }
                found
            });
            let [low, high] = stretches;
            for &(from, to, cell, is_cut) in &low {
                for &(start, end, other, is_other_cut) in &high {
                    let shared = to.min(end) - from.max(start);
                    if 4.0 * tolerance < shared && !is_cut && !is_other_cut {
                        self.unite(cell, other);
                    }
                }
            }
        }
    }

    fn root(&self, mut cell: usize) -> usize {
        while self.parts[cell] != cell {
            cell = self.parts[cell];
        }
        cell
    }

    fn unite(&mut self, one: usize, other: usize) {
        let (a, b) = (self.root(one), self.root(other));
        self.parts[a.max(b)] = a.min(b);
    }

    /// The parts: for each the cells that it is made of, in their order.
    fn groups(&self) -> Vec<Vec<usize>> {
        let mut groups: Vec<Vec<usize>> = vec![Vec::new(); self.cells.len()];
        for cell in 0..self.cells.len() {
            groups[self.root(cell)].push(cell);
        }
        groups.retain(|cells| !cells.is_empty());
        groups
    }

    fn regions(&self, cells: &[usize]) -> Vec<Region> {
        cells.iter().map(|&cell| self.cells[cell].region.clone()).collect()
    }

    /// For each of `n_arcs` arcs how it runs by the parts.
    pub(super) fn arc_courses(&self, n_arcs: usize) -> Vec<ArcCourse> {
        let part_of = |cell: Option<usize>| cell.map(|cell| self.root(cell));
        let mut courses = vec![ArcCourse::default(); n_arcs];
        for (number, (edge, cells)) in self.arrangement.edges.iter().zip(self.beside()).enumerate()
        {
            let [left, right] = [cells.left, cells.right].map(part_of);
            let is_along = left.or(right).is_some() || self.slits.binary_search(&number).is_ok();
            for arc in edge.passes.iter().filter_map(|&(group, _)| group.checked_sub(BORDER + 1)) {
                courses[arc].is_along |= is_along;
                courses[arc].is_between |= left != right;
            }
        }
        courses
    }

    /// How many parts there are.
    pub(super) fn n_parts(&self) -> usize {
        self.groups().len()
    }

    /// All parts.
    pub(super) fn all(&self) -> Vec<Vec<Region>> {
        self.groups().iter().map(|cells| self.regions(cells)).collect()
    }

    /// The parts to the left of arcs, those of `n_arcs`; the place of an arc with such a part, or none
    /// of either, on both sides.
    pub(super) fn left_of_arcs(&self) -> Result<Vec<Vec<Region>>, DVec3> {
        let beside = self.beside();
        let mut sides: Vec<Option<bool>> = vec![None; self.cells.len()];
        for (edge, cells) in self.arrangement.edges.iter().zip(&beside) {
            let times: i32 = edge
                .passes
                .iter()
                .filter(|&&(group, _)| group != BORDER)
                .map(|&(_, times)| times.signum())
                .sum();
            if edge.passes.iter().all(|&(group, _)| group == BORDER) {
                continue;
            }
            let place = || edge.curve.point_at(edge.curve.domain().at(0.5));
            if times == 0 {
                return Err(place());
            }
            for (cell, is_left) in [(cells.left, 0 < times), (cells.right, times < 0)] {
                let Some(cell) = cell else { continue };
                let known = &mut sides[self.root(cell)];
                if known.is_some_and(|known| known != is_left) {
                    return Err(place());
                }
                *known = Some(is_left);
            }
        }
        let kept = self.groups().into_iter().filter(|cells| sides[cells[0]] != Some(false));
        Ok(kept.map(|cells| self.regions(&cells)).collect())
    }
}
