//! Cells small enough for their own normal to see the surface around them as a graph.
//!
//! Take a cell of parameters and its normal n. What is between a triangle over it and the surface
//! at equal parameters has a part along n, which the second derivatives along n bound, and a part
//! across, bounded by all of the second derivatives. From the point of the surface at equal
//! parameters goes a path along it that ends over the triangle's: as long, seen along n, as the
//! part across, and rising no more than the slope times that. So the triangle is no further than
//! the part along n and the slope times the part across. The path exists where the surface around
//! the cell, as far as the path is long, has no slope near the vertical; where the surface ends
//! before, the polygon of its border is near. The same holds from the surface to the triangles.
//!
//! The slope is bounded by how far the normal turns: over the cell, which is a rule for its size,
//! and over the path, by the curvature of the pieces around.

use std::f64::consts::PI;

use super::{
    alike::AlikePieces,
    bend::PieceBounds,
    form::ParameterBoxes,
    rules::{BendRules, BendingSide, NormalRules},
};
use crate::{Direction, Grid, tolerance::FLAT_SLOPE};

/// How many times as long as the tolerance the part across may be.
const MAX_SLIDE: f64 = 4.0;

/// How much further the normal may turn over a cell than over one that is as large as can be for
/// what it bends.
const TURN_MARGIN: f64 = 1.1;

/// A bound of what is longer or wider on a surface of slope up to [`FLAT_SLOPE`] than over the
/// plane: √(1 + slope²), and tan(slope)/slope is no more either.
const TILT: f64 = 1.04;

/// What is known of a piece that its middle normal sees all of.
#[derive(Clone, Copy, Debug)]
struct SteadyNormal {
    /// How far the normal may be from that in the middle; radians.
    swing: f64,
    /// How far it turns per step of u and of v.
    turns: [f64; 2],
    /// How far it turns over a path of length 1 along the surface.
    curvature: f64,
    /// How long at least a path across the piece is, the shorter way.
    extent: f64,
}

/// The rules for cells over each piece, along the normal none where they see too much slope; `lines` are those beside
/// lines that keep to the tolerance on their own.
pub(super) fn bend_rules(
    pieces: &Grid<PieceBounds>,
    ends: &[Vec<f64>; 2],
    alike: &AlikePieces,
    breaks: [&[f64]; 2],
    lines: Option<&Grid<ParameterBoxes>>,
    tolerance: f64,
) -> Grid<BendRules> {
    let steady = alike.grid(|i, j| {
        let widths = [ends[0][i + 1] - ends[0][i], ends[1][j + 1] - ends[1][j]];
        steady(&pieces.row(i)[j], widths)
    });
    let slide = MAX_SLIDE * tolerance;
    let around = Direction::BOTH.map(|along| around(alike, along, &ends[along], breaks[along]));
    let [rows, columns] = Direction::BOTH.map(|along| alike.kinds(along));
    let of_normal = |i: usize, j: usize| {
        let this = steady.row(i)[j].as_ref()?;
        let mut curvature = 0.0_f64;
        for &(k, is_row) in &around[0][rows[i]] {
            for &(l, is_column) in &around[1][columns[j]] {
                let beside = steady.row(k)[l].as_ref()?;
                if !(is_row && is_column) && beside.extent < slide {
                    return None;
                }
                curvature = curvature.max(beside.curvature);
            }
        }
        let line = lines.map_or(ParameterBoxes::NONE, |lines| lines.row(i)[j]);
        let rules = near(&pieces.row(i)[j], this, curvature * slide, tolerance)?;
        Some(NormalRules { line, ..rules })
    };
    let per_tolerance = 1.0 / (8.0 * tolerance);
    alike.grid(|i, j| {
        let whole = ParameterBoxes::new(pieces.row(i)[j].second).scaled(per_tolerance);
        BendRules { whole, near: of_normal(i, j) }
    })
}

/// The pieces that each kind touches along a direction, by the first that is like them, but for those behind a line
/// where the surface is broken; and whether it is the piece itself, not one beside it.
fn around(
    alike: &AlikePieces,
    along: Direction,
    ends: &[f64],
    breaks: &[f64],
) -> Vec<Vec<(usize, bool)>> {
    let mut around: Vec<Vec<(usize, bool)>> = vec![Vec::new(); alike.firsts(along).len()];
    for (i, &kind) in alike.kinds(along).iter().enumerate() {
        let first = if i == 0 || breaks.contains(&ends[i]) { i } else { i - 1 };
        let is_last = i + 2 == ends.len() || breaks.contains(&ends[i + 1]);
        for k in first..=if is_last { i } else { i + 1 } {
            let piece = (alike.first_like(along, k), k == i);
            if !around[kind].contains(&piece) {
                around[kind].push(piece);
            }
        }
    }
    around
}

/// The rules of a piece from where a path turns the normal by no more than `strayed`.
fn near(
    bend: &PieceBounds,
    this: &SteadyNormal,
    strayed: f64,
    tolerance: f64,
) -> Option<NormalRules> {
    let most = |i: usize| bend.lift[i][1].max(-bend.lift[i][0]);
    let per_tolerance = 1.0 / (8.0 * tolerance);
    let about: [f64; 3] = std::array::from_fn(|i| most(i) + this.swing * bend.across[i]);
    let [a, b] = ParameterBoxes::new(about).scaled(per_tolerance).largest(bend.ratio());
    let room = 2.0 * (FLAT_SLOPE / TILT - strayed);
    let wanted = TURN_MARGIN * (a * this.turns[0] + b * this.turns[1]);
    let turn = if wanted < room { wanted } else { room };
    if turn <= 0.0 {
        return None;
    }
    let lean = 0.5 * turn + this.swing;
    let lift: [f64; 3] = std::array::from_fn(|i| most(i) + lean * bend.across[i]);
    let across: [f64; 3] = std::array::from_fn(|i| bend.across[i] + lean * most(i));
    let slope = TILT * (0.5 * turn + strayed);
    let sense = |i: usize| match bend.lift[i] {
        [low, _] if lean * bend.across[i] <= low => Some(BendingSide::Along),
        [_, high] if high <= -lean * bend.across[i] => Some(BendingSide::Against),
        _ => None,
    };
    let saddle = sense(0).filter(|along_u| sense(2).is_some_and(|along_v| along_v != *along_u));
    let [per_u, per_v] = this.turns;
    let across = ParameterBoxes::new(across).scaled(per_tolerance);
    Some(NormalRules {
        lift: ParameterBoxes::new(lift).scaled(per_tolerance),
        saddle,
        slip: across.scaled(slope),
        turn: ParameterBoxes { uu: per_u * per_u, uv: per_u * per_v, vv: per_v * per_v },
        most_turn: turn,
        slide: across.scaled(1.0 / MAX_SLIDE),
        line: ParameterBoxes::NONE,
    })
}

/// What is known of a piece of these widths; none where the slope over the plane of its middle
/// normal is more than [`FLAT_SLOPE`].
fn steady(bend: &PieceBounds, widths: [f64; 2]) -> Option<SteadyNormal> {
    bend.normal?;
    let [along_u, along_v, ..] = bend.middle;
    let lengths = [along_u.length(), along_v.length()];
    let least = [0, 1].map(|i| lengths[i] - bend.spread[i]);
    if !(0.0 < least[0] && 0.0 < least[1]) {
        return None;
    }
    // Between these angles Su and Sv cross, seen along the normal.
    let angle = libm::atan2(along_u.cross(along_v).length(), along_u.dot(along_v));
    let reach: f64 = [0, 1].map(|i| libm::asin(bend.spread[i] / lengths[i])).iter().sum();
    let crossing = [angle - reach, angle + reach];
    if crossing[0] <= 0.0 || PI <= crossing[1] {
        return None;
    }
    let sine = libm::sin(crossing[0]).min(libm::sin(crossing[1]));
    let most: [f64; 3] = std::array::from_fn(|i| bend.lift[i][1].max(-bend.lift[i][0]));
    let rise = |i: usize| 0.5 * (widths[0] * most[i] + widths[1] * most[i + 1]);
    let swing = (rise(0) / least[0] + rise(1) / least[1]) / sine;
    if swing.is_nan() || FLAT_SLOPE < swing {
        return None;
    }
    // Of a tilted plane the angle is smaller than it is seen.
    let sine = sine / (1.0 + swing * swing);
    let bends: [f64; 3] = std::array::from_fn(|i| most[i] + swing * bend.across[i]);
    let turns = [0, 1].map(|i| (bends[i] / least[0] + bends[i + 1] / least[1]) / sine);
    let curvature = TILT * (turns[0] / least[0] + turns[1] / least[1]) / sine;
    let extent = (widths[0] * least[0]).min(widths[1] * least[1]) * sine / TILT;
    Some(SteadyNormal { swing, turns, curvature, extent })
}
