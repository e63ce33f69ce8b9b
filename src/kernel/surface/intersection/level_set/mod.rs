//! Lines on a surface along which a polynomial of its parameters vanishes: plane sections,
//! contours, isophotes.
//!
//! On each Bézier patch the field has Bernstein coefficients, whose signs are certain: `cell` cuts
//! the patch until each part has no zeros, or graphs of one parameter over the other between roots
//! on its sides (`branch`), or is smaller than the tolerance. So no loop is lost, however small, and
//! nothing is followed from a start that had to be found. Sides along which the field vanishes are
//! divided out first. `sample` turns branches into points with tangents, `chain` joins these,
//! `cubic` lays splines through them. `plane` has the fields of planes, `shade` those of normals and
//! of what they mirror. `surface_intersection` has the curves in which two surfaces cross,
//! by parts of both (`pair`, `share`) and by following what is found (`trace`), also where they touch (`tangential_contact`, seen by
//! `parallel_pair`), in a small loop (`small_loop`),
//! along lines (`tangency`) or are neighbours (`seam`), `curve_surface_intersection` the places that a curve shares with a surface
//! (pieces of it in `bezier_segment`, what does not cross clearly in `curve_surface_touch`).
//! `beside` sees edges and corners that lie on the other surface beside these,
//! `verify` looks at every curve before it is told. `scaled` has all of that for the largest and the smallest, `far` for parameters
//! far from zero.
//!
//! Sederberg & Meyers, *Loop detection in surface patch intersections*, CAGD 5 (1988); Patrikalakis &
//! Maekawa, *Shape Interrogation for Computer Aided Design and Manufacturing*, §4.

mod beside;
mod bezier_segment;
mod branch;
mod branch_sample;
mod cell;
mod chain;
mod collapsed;
mod cubic;
mod curve_surface_intersection;
mod curve_surface_touch;
mod elsewhere;
mod error;
mod far;
mod pair;
mod parallel_pair;
mod plane;
mod resting_place;
mod results;
mod sample;
mod scaled;
mod seam;
mod shade;
mod share;
mod small_loop;
mod sphere;
mod surface_intersection;
mod surface_pair;
mod surface_pair_touch;
mod tangency;
mod tangential_contact;
mod trace;
mod verify;

use glam::DVec3;

pub use error::PictureError;
pub(in crate::surface) use pair::SurfacePart;
pub use results::{CurveSurfaceIntersection, LevelSet};
pub(in crate::surface) use verify::ClosestPointTracker;

use branch::Branch;
use cell::{PositivityCondition, SearchResolution};
use resting_place::FieldSlopes;
use sample::{BranchSamples, VanishingPlace};
use scaled::CommonScale;

use crate::{
    Bounds, GeomError, Grid, NurbsCurve, Tolerance,
    ceiling::CELLS,
    mesh::check_rounding,
    surface::{NurbsSurface, Surface, intersection::square},
    tolerance::{LAST_BIT, TOUCH_RELATIVE},
};

/// A field on a Bézier patch.
struct ScalarField<'p> {
    patch: &'p NurbsSurface,
    values: Grid<f64>,
    /// Coefficients up to this are rounding.
    rounding: f64,
    /// Whether it is zero within the tolerance all over the patch.
    is_zero: bool,
    /// Where its zeros count.
    conditions: Vec<PositivityCondition>,
    /// What it is made of vanishes with this, and tells nothing there.
    basis: Option<&'p Grid<f64>>,
}

/// A side of a patch along which the field vanishes.
struct ZeroSide {
    run: BranchSamples,
    is_of_zero: bool,
}

/// The parts of a zero set, as they are found.
struct ZeroSetParts {
    tolerance: f64,
    n_cells_left: usize,
    runs: Vec<BranchSamples>,
    sides: Vec<ZeroSide>,
    spots: Vec<VanishingPlace>,
}

/// Fraction of the tolerance within which samples determine their branch.
const SAMPLING: f64 = 0.25;

/// Fraction of the tolerance within which a spline keeps to samples.
const FITTING: f64 = 0.5;

impl ZeroSetParts {
    fn new(tolerance: f64) -> Self {
        Self {
            tolerance,
            n_cells_left: CELLS,
            runs: Vec::new(),
            sides: Vec::new(),
            spots: Vec::new(),
        }
    }

    /// Adds the zero set on a patch.
    fn add(&mut self, field: ScalarField<'_>) -> Result<(), GeomError> {
        let ScalarField { patch, values, rounding, is_zero, conditions, basis } = field;
        let [least, most] = square::range(&values);
        let fails = |condition: &PositivityCondition| {
            square::range(&condition.values)[1] < -condition.rounding
        };
        if !is_zero && (rounding < least || most < -rounding) || conditions.iter().any(fails) {
            return Ok(());
        }
        let is_small = |value: &f64| value.abs() <= rounding;
        let factors = if is_zero { None } else { cell::without_sides(&values, is_small) };
        let is_of_zero = factors.is_none();
        let all_sides = || vec![(0, 0.0), (0, 1.0), (1, 0.0), (1, 1.0)];
        let (rest, sides) = match factors {
            Some((rest, sides)) => (Some(rest), sides),
            None => (None, all_sides()),
        };
        self.add_sides(patch, sides, is_of_zero, &conditions)?;
        let Some(rest) = rest else { return Ok(()) };
        let extents = extents(patch);
        let fineness = SearchResolution { rounding, extents, tolerance: self.tolerance };
        let at = |place: [f64; 2]| {
            let domains = [patch.domain_u(), patch.domain_v()];
            [0, 1].map(|i| domains[i].at(place[i]))
        };
        let found = cell::search(rest.clone(), conditions, fineness, &mut self.n_cells_left);
        let found = found.map_err(|failure| match failure {
            cell::SearchFailure::Ended => GeomError::Ended,
            cell::SearchFailure::Unresolved(place) => {
                let [u, v] = at(place);
                PictureError::Unresolved { u, v }.into()
            }
        })?;
        for branch in &found.branches {
            let run = BranchSamples::of(branch, patch, SAMPLING * self.tolerance)?;
            // A graph that touches its cell in a corner.
            if self.tolerance * LAST_BIT.sqrt() < run.length() {
                self.runs.push(run);
            }
        }
        let least = basis.map_or(0.0, |basis| TOUCH_RELATIVE * square::largest(basis));
        let slopes = (!found.rest.is_empty()).then(|| FieldSlopes::of(&rest));
        for [middle, widths] in found.rest {
            if basis.is_some_and(|basis| square::value(basis, middle) <= least) {
                continue;
            }
            let resting = slopes.as_ref().and_then(|slopes| slopes.resting_place(middle, widths));
            let [center, point] = [middle, resting.unwrap_or(middle)].map(|place| {
                let [u, v] = at(place);
                patch.point_at(u, v)
            });
            // All of the cell is one place with it: ends of curves lie on its sides.
            let radius = extents[0] * widths[0] + extents[1] * widths[1] + point.distance(center);
            self.spots.push(VanishingPlace { point, radius, is_exact: resting.is_some() });
        }
        Ok(())
    }

    /// Adds sides of a patch along which the field vanishes, where the conditions hold.
    fn add_sides(
        &mut self,
        patch: &NurbsSurface,
        sides: cell::PatchSides,
        is_of_zero: bool,
        conditions: &[PositivityCondition],
    ) -> Result<(), GeomError> {
        for (constant, end) in sides {
            let branch = Branch::side(constant, end);
            let middle = branch.place(0.5);
            let holds = |condition: &PositivityCondition| {
                -condition.rounding <= square::value(&condition.values, middle)
            };
            if !conditions.iter().all(holds) {
                continue;
            }
            let run = BranchSamples::of(&branch, patch, SAMPLING * self.tolerance)?;
            if run.length() <= self.tolerance {
                self.spots.push(VanishingPlace { point: run.start(), radius: 0.0, is_exact: true });
            } else {
                self.sides.push(ZeroSide { run, is_of_zero });
            }
        }
        Ok(())
    }

    fn finish(mut self) -> Result<LevelSet, GeomError> {
        let sides = std::mem::take(&mut self.sides);
        self.runs.extend(single_sides(sides, self.tolerance));
        let chained = chain::chained(self.runs, &self.spots, self.tolerance);
        let spline =
            |line: Vec<branch_sample::BranchSample>| cubic::spline(&line, FITTING * self.tolerance);
        let curves: Result<Vec<NurbsCurve>, GeomError> =
            chained.lines.into_iter().map(spline).collect();
        let curves = verify::without_crumbs(curves?, self.tolerance);
        Ok(LevelSet { curves, touches: chained.isolated, ..LevelSet::default() })
    }
}

impl Surface {
    /// The surface, or a spline within the tolerance of a function.
    fn splined(&self, tolerance: f64) -> Result<std::sync::Arc<NurbsSurface>, GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(std::sync::Arc::clone(surface)),
            Self::Parametric(surface) => surface.to_nurbs(tolerance).map(std::sync::Arc::new),
        }
    }
}

impl NurbsSurface {
    /// The tolerance for lines on a surface of this size.
    ///
    /// # Errors
    /// [`crate::MeshError::BelowRounding`].
    fn line_tolerance(&self, tolerance: Tolerance) -> Result<f64, GeomError> {
        let Some(bounds) = Bounds::of(self.points().iter().copied()) else {
            return Ok(tolerance.distance);
        };
        let distance = tolerance.distance_for(bounds.diagonal());
        check_rounding(distance, bounds.magnitude())?;
        Ok(distance)
    }
}

/// How far the parameters lead over the whole of a Bézier patch, in space, at most.
fn extents(patch: &NurbsSurface) -> [f64; 2] {
    let points = patch.points();
    let longest = |points: &Grid<DVec3>| {
        let n = points.n_rows();
        let steps = (1..n).flat_map(|i| {
            (0..points.n_columns()).map(move |j| points.get(i, j).distance(points.get(i - 1, j)))
        });
        (n - 1) as f64 * steps.fold(0.0, f64::max)
    };
    [longest(&points), longest(&points.transposed())]
}

/// Sides of patches, each once. Where the field is zero on both sides of one, it is no border.
fn single_sides(sides: Vec<ZeroSide>, tolerance: f64) -> Vec<BranchSamples> {
    let middle = |run: &BranchSamples| run.samples[run.samples.len() / 2].point;
    let places: Vec<(DVec3, f64)> = sides.iter().map(|side| (middle(&side.run), 0.0)).collect();
    let is_same = |a: &BranchSamples, b: &BranchSamples| {
        let near = |p: DVec3, q: DVec3| p.distance(q) <= tolerance;
        near(a.start(), b.start()) && near(a.end(), b.end())
            || near(a.start(), b.end()) && near(a.end(), b.start())
    };
    let mut is_kept = vec![true; sides.len()];
    for (i, k) in chain::near_pairs(&places, tolerance) {
        if is_same(&sides[i].run, &sides[k].run) {
            is_kept[k] = false;
            if sides[i].is_of_zero && sides[k].is_of_zero {
                is_kept[i] = false;
            }
        }
    }
    sides.into_iter().zip(is_kept).filter(|(_, kept)| *kept).map(|(side, _)| side.run).collect()
}
