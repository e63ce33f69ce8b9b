//! What a mesh of a surface is asked for, and the cells that fulfil it.
//!
//! A triangle over a box of parameters of widths a and b is no further from the surface than
//! `(a²·|Suu| + 2ab·|Suv| + b²·|Svv|) / 8` at equal parameters (Filip, Magedson & Markot 1986), which
//! is one limit of the boxes; where only what lies along the normal counts, `near` has another. A
//! cell keeps to one of the two. Other limits are the length of a box's diagonal and how far the
//! normal turns over it.
//!
//! Of pieces that a cell touches together each second derivative counts where it is largest.

use std::{collections::BTreeMap, f64::consts::PI, ops::Range, sync::Arc};

use super::{
    alike::AlikePieces,
    bend::{DerivativeBounds, PieceBounds},
    compact_rules::CompactRules,
    form::ParameterBoxes,
    near::bend_rules,
    rules::PieceRules,
    turns::turns,
    unfolding::{is_bent, is_regular, may_fold, unfolded},
};
use crate::{
    Direction, GeomError, Grid, InputError, NurbsSurface, Tolerance, ceiling::CELL_PIECES,
    tolerance::BORDER_SHARE, work,
};

/// Pieces along one direction by which the cells are counted, about; those that bound them then are one for each cell,
/// about, up to `CELL_PIECES`.
///
/// Over a piece each second derivative is bounded on its own, where one may be large as another is
/// small: pieces of several cells make more triangles of a wave than it needs.
const FEW_PIECES: usize = 16;

/// How much smaller cells become that break a rule of several pieces together.
const NARROWING: f64 = 0.98;

/// Search for how long cells are in proportion to their width: the first step, how many steps, and
/// the part of the cells that must remain for a step to be one.
const BALANCE_STEP: f64 = 2.0;
const BALANCE_ROUNDS: usize = 5;
const BALANCE_GAIN: f64 = 0.995;

/// What triangles are asked for.
///
/// However flat the surface is, no edge is longer than what is asked for:
///
/// ```
/// use virote_kernel::{NurbsSurface, TessellationOptions, glam::DVec3, tessellate_finely};
///
/// let [o, x, y] = [DVec3::ZERO, DVec3::X, DVec3::Y];
/// let square = NurbsSurface::bilinear(o, y, x, x + y)?;
/// let limits = TessellationOptions { max_edge: 0.25, ..TessellationOptions::within(0.01) };
/// let mesh = tessellate_finely(&square, &limits, 100_000)?;
/// let longest = |[a, b, c]: [DVec3; 3]| a.distance(b).max(b.distance(c)).max(c.distance(a));
/// assert!(mesh.corners().all(|triangle| longest(triangle) <= 0.25 + 1e-12));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TessellationOptions {
    /// No point of the mesh is further from the surface, none of the surface from the mesh.
    pub tolerance: f64,
    /// Normals at the corners of a triangle turn no further from one another; radians.
    pub angle: f64,
    /// No edge is longer.
    pub max_edge: f64,
    /// Corners and edges of surfaces that are no further apart are one, as far as the tolerance
    /// leaves room for that.
    pub weld: f64,
    /// Whether triangles are two for each cell of a grid, also where fewer of another kind would do.
    pub is_grid: bool,
    /// Threads that may work on it; the mesh does not depend on how many.
    pub n_threads: usize,
}

impl TessellationOptions {
    /// A tolerance without other limits.
    #[must_use]
    pub const fn within(tolerance: f64) -> Self {
        let weld = Tolerance::DEFAULT.distance;
        Self { tolerance, angle: PI, max_edge: f64::INFINITY, weld, is_grid: false, n_threads: 1 }
    }

    /// # Errors
    /// [`InputError::NotPositive`] for a limit that allows nothing.
    pub(super) fn check(&self) -> Result<(), GeomError> {
        let is_finite = self.tolerance.is_finite();
        let limits = [
            ("the tolerance", if is_finite { self.tolerance } else { f64::NAN }),
            ("the angle", self.angle),
            ("the longest edge", self.max_edge),
        ];
        match limits.into_iter().find(|&(_, got)| got <= 0.0 || got.is_nan()) {
            Some((what, _)) if what == "the tolerance" => {
                Err(GeomError::Input(InputError::NotPositive { what, got: self.tolerance }))
            }
            Some((what, got)) => Err(GeomError::Input(InputError::NotPositive { what, got })),
            None => Ok(()),
        }
    }

    /// Whether the turn of the normal is limited at all.
    pub(super) fn limits_angle(&self) -> bool {
        self.angle < PI
    }
}

/// The limits of the boxes over each piece of a surface.
#[derive(Clone, Debug)]
pub(super) struct CellBounds {
    /// Where the pieces along u and along v begin and end.
    pub(super) ends: [Vec<f64>; 2],
    /// Those whose rules are the same.
    alike: AlikePieces,
    rules: PieceRules,
    /// How many times longer a step along u is than one along v.
    ratios: Arc<Grid<f64>>,
    /// Bounds of the lengths of Su and of Sv, over all pieces.
    pub(super) longest: [f64; 2],
    /// Of a surface with bent lines in a plane that does not fold itself, but whose cells may where they are too wide.
    unfolding: Option<Arc<Grid<ParameterBoxes>>>,
    /// The widths of cells, where somebody has asked for them already.
    widths: Option<PieceWidths>,
}

/// Widths of cells for each piece along u and along v, and about how many cells that makes along each.
pub(super) type PieceWidths = [(Vec<f64>, f64); 2];

impl CellBounds {
    /// Those of a surface, with `breaks` of constant u and of constant v where derivatives jump.
    pub(super) fn new(
        surface: &NurbsSurface,
        wanted: &TessellationOptions,
        breaks: [&[f64]; 2],
    ) -> Self {
        let bounds = |n_pieces| DerivativeBounds::of(surface, n_pieces, wanted.n_threads);
        let few = Self::of(bounds([FEW_PIECES; 2]), surface, wanted, breaks);
        let widths = few.widths();
        let n_cells = widths.each_ref().map(|&(_, n_cells)| n_cells as usize);
        let n_pieces = n_cells.map(|n_cells| n_cells.clamp(FEW_PIECES, CELL_PIECES));
        // Work that was ended left pieces without bounds, by which the cells are countless.
        if n_pieces == [FEW_PIECES; 2] || work::ended().is_some() {
            return Self { widths: Some(widths), ..few };
        }
        Self::of(bounds(n_pieces), surface, wanted, breaks)
    }

    fn of(
        bends: DerivativeBounds,
        surface: &NurbsSurface,
        wanted: &TessellationOptions,
        breaks: [&[f64]; 2],
    ) -> Self {
        let DerivativeBounds { ends, mut alike, pieces, plane } = bends;
        // Beside a break a piece keeps to more than another.
        for along in Direction::BOTH {
            if !breaks[along].is_empty() {
                alike = alike.told_apart(along);
            }
        }
        let per_tolerance = 1.0 / (8.0 * wanted.tolerance);
        let ratios = pieces.map(PieceBounds::ratio);
        let longest = [0, 1].map(|i| pieces.iter().map(|piece| piece.first[i]).fold(0.0, f64::max));
        let are_broken = breaks.iter().any(|breaks| !breaks.is_empty());
        let lines =
            are_broken.then(|| line_forms(&pieces, &ends, breaks, per_tolerance / BORDER_SHARE));
        let chord = 2.0 * libm::sin(0.5 * wanted.angle);
        let angle = match plane {
            // There no normal turns.
            Some(normal) => may_fold(&pieces, normal).then(|| Arc::new(pieces.map(unfolded))),
            None => wanted.limits_angle().then(|| {
                let turns = turns(surface, &ends, &alike, wanted.n_threads);
                Arc::new(turns.map(|turn| turn.scaled(1.0 / (chord * chord))))
            }),
        };
        let unfolding = plane
            .filter(|_| pieces.iter().any(is_bent) && pieces.iter().all(is_regular))
            .map(|_| angle.clone().unwrap_or_else(|| Arc::new(pieces.map(unfolded))));
        let mut others = Vec::new();
        if wanted.max_edge.is_finite() {
            let per_edge = 1.0 / (wanted.max_edge * wanted.max_edge);
            others.push(pieces.map(|bend| diagonal(bend).scaled(per_edge)));
        }
        let bends = match plane {
            Some(_) => {
                others.extend(lines);
                None
            }
            None => {
                let lines = lines.as_ref();
                let tolerance = wanted.tolerance;
                Some(Arc::new(bend_rules(&pieces, &ends, &alike, breaks, lines, tolerance)))
            }
        };
        let rules = PieceRules { bends, angle, others: Arc::new(others) };
        Self { ends, alike, rules, ratios: Arc::new(ratios), longest, unfolding, widths: None }
    }

    /// Whether it lies in a plane, and smaller cells do not fold over one another where these do.
    pub(super) fn can_unfold(&self) -> bool {
        self.unfolding.is_some()
    }

    /// The same for an angle that is smaller by a factor, that of normals or, in a plane, that of directions.
    pub(super) fn sharpened(&self, sharpness: f64) -> Self {
        if sharpness <= 1.0 {
            return self.clone();
        }
        let sharper = |angle: &Arc<Grid<ParameterBoxes>>| {
            Arc::new(angle.map(|turn| turn.scaled(sharpness * sharpness)))
        };
        let angle = self.unfolding.as_ref().or(self.rules.angle.as_ref()).map(sharper);
        Self { rules: PieceRules { angle, ..self.rules.clone() }, widths: None, ..self.clone() }
    }

    /// Whether a box keeps to the limits of all pieces that it touches.
    pub(super) fn allow(&self, box_of: [[f64; 2]; 2]) -> bool {
        let [rows, columns] = Direction::BOTH.map(|along| self.touched(along, box_of[along]));
        self.rules.allow(&rows, &columns, box_of.map(|[low, high]| high - low))
    }

    /// The pieces that an interval along a direction touches.
    pub(super) fn touched(&self, along: Direction, [low, high]: [f64; 2]) -> Range<usize> {
        let ends = &self.ends[along];
        let first = ends.partition_point(|&t| t <= low).saturating_sub(1);
        let behind = ends.partition_point(|&t| t < high).min(ends.len() - 1);
        first.min(behind.saturating_sub(1))..behind.max(first + 1).min(ends.len() - 1)
    }

    /// Makes the widths a little smaller where cells between these lines break a rule, which those
    /// can that touch several pieces; whether there are such.
    pub(super) fn narrow(&self, lines: &[Vec<f64>; 2], widths: &mut [Vec<f64>; 2]) -> bool {
        let [steps_u, steps_v] = Direction::BOTH.map(|along| -> Vec<(f64, Range<usize>)> {
            let steps = lines[along].windows(2).map(|pair| [pair[0], pair[1]]);
            steps.map(|step| (step[1] - step[0], self.touched(along, step))).collect()
        });
        let mut is_faulty = [vec![false; widths[0].len()], vec![false; widths[1].len()]];
        let [faulty_rows, faulty_columns] = &mut is_faulty;
        let kinds = self.alike.kinds(Direction::U);
        let mut alike: BTreeMap<&[usize], Vec<&(f64, Range<usize>)>> = BTreeMap::new();
        for step in &steps_u {
            alike.entry(&kinds[step.1.clone()]).or_default().push(step);
        }
        let mut room = Vec::new();
        for mut steps in alike.into_values() {
            let mut faults = |(height, rows): &(f64, Range<usize>)| {
                self.rules.faults(rows, *height, &steps_v, &mut room)
            };
            steps.sort_by(|a, b| a.0.total_cmp(&b.0));
            let (lowest, highest) = (steps[0], steps[steps.len() - 1]);
            // What a row breaks a higher one of alike pieces breaks as well.
            let mut found = faults(lowest);
            let is_of_all = steps.len() == 1 || found == faults(highest);
            for step in steps {
                // Whoever asked looks at that as well.
                if !work::goes_on(1) {
                    return false;
                }
                if !is_of_all {
                    found = faults(step);
                }
                for columns in &found {
                    faulty_rows[step.1.clone()].fill(true);
                    faulty_columns[columns.clone()].fill(true);
                }
            }
        }
        for (widths, is_faulty) in widths.iter_mut().zip(&is_faulty) {
            for (width, _) in widths.iter_mut().zip(is_faulty).filter(|(_, is_faulty)| **is_faulty)
            {
                *width *= NARROWING;
            }
        }
        is_faulty[0].contains(&true)
    }

    /// Widths of cells for each piece along u and along v, so that every cell of one piece keeps to
    /// every limit, and about how many cells that makes along each.
    pub(super) fn widths(&self) -> PieceWidths {
        if let Some(widths) = &self.widths {
            return widths.clone();
        }
        let wholes = self.ends.each_ref().map(|ends| ends[ends.len() - 1] - ends[0]);
        // Of each kind of rows and of columns.
        let [rows, columns] = Direction::BOTH.map(|along| self.alike.firsts(along));
        let mut widths = vec![wholes[1]; columns.len()];
        for &i in rows {
            for (&j, width) in columns.iter().zip(&mut widths) {
                let [_, b] = self.rules.largest([i, j], self.ratios.row(i)[j]);
                *width = width.min(b);
            }
        }
        let rules = CompactRules::new(&self.rules, [rows, columns]);
        let balanced = |factor: f64| {
            let mut columns: Vec<f64> =
                widths.iter().map(|width| (factor * width).min(wholes[1])).collect();
            let rows = rules.widest_rows(&columns, wholes[0]);
            for (width, wider) in columns.iter_mut().zip(rules.widest_columns(&rows, wholes[1])) {
                *width = width.max(wider);
            }
            let counts = [self.count(Direction::U, &rows), self.count(Direction::V, &columns)];
            [(rows, counts[0]), (columns, counts[1])]
        };
        let cost = |found: &PieceWidths| found[0].1 * found[1].1;
        let mut best = (1.0, balanced(1.0));
        let mut step = BALANCE_STEP;
        'search: for _ in 0..BALANCE_ROUNDS {
            let (middle, mut is_best): (f64, bool) = (best.0, true);
            for factor in [middle / step, middle * step] {
                if !work::goes_on(rows.len() as u64) {
                    break 'search;
                }
                let found = balanced(factor);
                if cost(&found) < BALANCE_GAIN * cost(&best.1) {
                    (best, is_best) = ((factor, found), false);
                }
            }
            if is_best {
                step = step.sqrt();
            }
        }
        let [rows, columns] = best.1;
        [(Direction::U, rows), (Direction::V, columns)].map(|(along, (widths, n_cells))| {
            let kinds = self.alike.kinds(along).iter();
            (kinds.map(|&kind| widths[kind]).collect(), n_cells)
        })
    }

    /// How many cells of these widths, one for each kind of pieces, there are along a direction.
    fn count(&self, along: Direction, widths: &[f64]) -> f64 {
        let pieces = self.ends[along].windows(2).zip(self.alike.kinds(along));
        pieces.map(|(ends, &kind)| (ends[1] - ends[0]) / widths[kind]).sum()
    }
}

/// The limits beside lines that keep to the tolerance on their own.
fn line_forms(
    pieces: &Grid<PieceBounds>,
    ends: &[Vec<f64>; 2],
    lines: [&[f64]; 2],
    per_tolerance: f64,
) -> Grid<ParameterBoxes> {
    let [beside_u, beside_v] = Direction::BOTH.map(|along| -> Vec<bool> {
        let is_line = |t: f64| lines[along].contains(&t);
        ends[along].windows(2).map(|ends| is_line(ends[0]) || is_line(ends[1])).collect()
    });
    Grid::from_fn(beside_u.len(), beside_v.len(), |i, j| {
        let [uu, _, vv] = pieces.row(i)[j].second;
        let of = |is_beside: bool, bend: f64| if is_beside { bend } else { 0.0 };
        ParameterBoxes::new([of(beside_v[j], uu), 0.0, of(beside_u[i], vv)]).scaled(per_tolerance)
    })
}

/// The square of the length of a box's diagonal.
fn diagonal(bend: &PieceBounds) -> ParameterBoxes {
    let [along_u, along_v, ..] = bend.middle;
    let ([u, v], [spread_u, spread_v]) = (bend.first, bend.spread);
    let product = along_u.dot(along_v).abs()
        + spread_u * along_v.length()
        + spread_v * along_u.length()
        + spread_u * spread_v;
    ParameterBoxes { uu: u * u, uv: product.min(u * v), vv: v * v }
}
