//! Regions as strips between two arcs of their borders, for integrals over them.
//!
//! Borders are cut where they turn from up to down. Between two neighbouring ends of what is left no two of
//! them change places, so that what lies to the right of every other one is inside: the vertical
//! decomposition of de Berg, Cheong, van Kreveld & Overmars, *Computational Geometry*, §6.1, turned on its side.

use std::{collections::BTreeMap, sync::Arc};

use glam::DVec3;

use super::{Region, RegionError};
use crate::{
    GeomError, Interval, NurbsCurve, Tolerance,
    numeric::{root::find_root, root_error::RootError},
    sorting::sort_by,
    tolerance::LAST_BIT,
};

/// Last bits of its coordinates within which a piece of a border has no height.
const FLAT_ROUNDINGS: f64 = 8.0;

/// Part of a region between two y, from an arc of its border to another one, in coordinates of its frame.
///
/// ```
/// use virote_kernel::{CircleForm, Frame, NurbsCurve, Region, Tolerance};
///
/// let circle = NurbsCurve::ellipse(Frame::XY, [5.0, 5.0], CircleForm::NinePoint)?;
/// let disc = Region::new(&circle, &[], Tolerance::DEFAULT)?;
/// let strips = disc.strips()?;
/// let strip = strips.iter().find(|strip| strip.across().contains(3.0)).expect("a strip at this height");
/// let [left, right] = strip.ends_at(3.0);
/// assert!((left + 4.0).abs() < 1e-14 && (right - 4.0).abs() < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct RegionStrip {
    across: Interval,
    sides: [Arc<RisingPiece>; 2],
}

/// A piece of a border along which y grows.
#[derive(Debug)]
struct RisingPiece {
    /// The curve and its parameters at both ends; none of a straight leg.
    curve: Option<(Arc<NurbsCurve>, [f64; 2])>,
    /// The lower end and the upper one.
    ends: [DVec3; 2],
    /// Whether the border runs down along it, with the region to its right.
    is_left: bool,
}

impl RegionStrip {
    /// Between which y it lies.
    #[must_use]
    pub fn across(&self) -> Interval {
        self.across
    }

    /// Between which x it lies at a y; in the wrong order only by rounding.
    #[must_use]
    pub fn ends_at(&self, y: f64) -> [f64; 2] {
        self.sides.each_ref().map(|side| side.x_at(y))
    }

    /// The same between two other y.
    pub(crate) fn between(&self, across: Interval) -> Self {
        Self { across, sides: self.sides.clone() }
    }
}

impl RisingPiece {
    fn new(curve: Option<(Arc<NurbsCurve>, [f64; 2])>, [start, end]: [DVec3; 2]) -> Option<Self> {
        let size = start.y.abs().max(end.y.abs());
        if (end.y - start.y).abs() <= FLAT_ROUNDINGS * LAST_BIT * size {
            return None;
        }
        if start.y < end.y {
            return Some(Self { curve, ends: [start, end], is_left: false });
        }
        let curve = curve.map(|(curve, [from, to])| (curve, [to, from]));
        Some(Self { curve, ends: [end, start], is_left: true })
    }

    fn x_at(&self, y: f64) -> f64 {
        let [low, high] = self.ends;
        if y <= low.y {
            return low.x;
        }
        if high.y <= y {
            return high.x;
        }
        match &self.curve {
            None => low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y)),
            Some((curve, parameters)) => {
                let height = |t| Ok::<_, ()>(curve.point_at(t).y - y);
                let [from, to] = match find_root(height, *parameters) {
                    Ok(root) => [root.at; 2],
                    Err(RootError::Flat { stretch }) => stretch,
                    Err(_) => *parameters,
                };
                let t = 0.5 * (from + to);
                curve.point_at(t).x
            }
        }
    }
}

impl Region {
    /// The strips that the region consists of, from below to above.
    ///
    /// # Errors
    /// [`RegionError::Unclear`] of borders that do not keep apart; those of a search that was ended.
    pub fn strips(&self) -> Result<Vec<RegionStrip>, GeomError> {
        let mut pieces = Vec::new();
        for border in self.arcs() {
            for (i, arc) in border.iter().enumerate() {
                GeomError::go_on(1)?;
                rising_pieces(arc, &mut pieces);
                let next = border[(i + 1) % border.len()].start();
                pieces.extend(RisingPiece::new(None, [arc.end(), next]));
            }
        }
        sort_by(&mut pieces, |a, b| a.ends[0].y.total_cmp(&b.ends[0].y));
        let pieces: Vec<Arc<RisingPiece>> = pieces.into_iter().map(Arc::new).collect();
        let mut heights: Vec<f64> =
            pieces.iter().flat_map(|piece| piece.ends.map(|end| end.y)).collect();
        heights.sort_by(f64::total_cmp);
        self.strips_between(&pieces, &heights)
    }

    fn strips_between(
        &self,
        pieces: &[Arc<RisingPiece>],
        heights: &[f64],
    ) -> Result<Vec<RegionStrip>, GeomError> {
        // Where borders meet they may miss one another by the tolerance, and change places before they end.
        let slack = Tolerance::DEFAULT.distance_for(self.bounds().diagonal());
        let mut strips: Vec<RegionStrip> = Vec::new();
        // The strips that go on, by their sides.
        let mut open: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        let (mut active, mut n_begun): (Vec<usize>, usize) = (Vec::new(), 0);
        for pair in heights.windows(2) {
            let (low, high) = (pair[0], pair[1]);
            if high - low <= FLAT_ROUNDINGS * LAST_BIT * low.abs().max(high.abs()) {
                continue;
            }
            let middle = low + 0.5 * (high - low);
            while pieces.get(n_begun).is_some_and(|piece| piece.ends[0].y < middle) {
                active.push(n_begun);
                n_begun += 1;
            }
            active.retain(|&piece| middle < pieces[piece].ends[1].y);
            GeomError::go_on(1 + active.len())?;
            let mut crossed: Vec<(f64, usize)> =
                active.iter().map(|&piece| (pieces[piece].x_at(middle), piece)).collect();
            sort_by(&mut crossed, |a, b| a.0.total_cmp(&b.0));
            let mut going_on = BTreeMap::new();
            let is_low = high - low <= slack;
            let Some(pairs) = pairs(pieces, &crossed, is_low) else {
                let x = crossed.first().map_or(0.0, |crossing| crossing.0);
                let point = self.frame.point(DVec3::new(x, middle, 0.0));
                return Err(RegionError::Unclear { point }.into());
            };
            for key in pairs {
                let number = match open.get(&key) {
                    Some(&number) => {
                        let across = Interval::new(strips[number].across.start(), high)?;
                        strips[number].across = across;
                        number
                    }
                    None => {
                        let sides = key.map(|piece| Arc::clone(&pieces[piece]));
                        strips.push(RegionStrip { across: Interval::new(low, high)?, sides });
                        strips.len() - 1
                    }
                };
                going_on.insert(key, number);
            }
            open = going_on;
        }
        Ok(strips)
    }
}

/// The pieces on either side of what is inside, of those that are crossed from the left to the right; none where they
/// do not take turns, unless that is allowed and as many lead in as out.
fn pairs(
    pieces: &[Arc<RisingPiece>],
    crossed: &[(f64, usize)],
    may_change_places: bool,
) -> Option<Vec<[usize; 2]>> {
    let (mut found, mut depth, mut start) = (Vec::new(), 0_i32, 0);
    for &(_, piece) in crossed {
        if pieces[piece].is_left {
            depth += 1;
            if depth == 1 {
                start = piece;
            }
        } else {
            if depth == 1 {
                found.push([start, piece]);
            }
            depth -= 1;
        }
        if !may_change_places && !(0..=1).contains(&depth) {
            return None;
        }
    }
    (depth == 0).then_some(found)
}

/// The pieces of an arc along which y grows or falls.
fn rising_pieces(arc: &NurbsCurve, pieces: &mut Vec<RisingPiece>) {
    if arc.degree() == 1 {
        let points = arc.points();
        pieces.extend(
            points.windows(2).filter_map(|pair| RisingPiece::new(None, [pair[0], pair[1]])),
        );
        return;
    }
    let mut cuts = arc.knots().breaks();
    cuts.extend(arc.extrema(DVec3::Y, Tolerance::DEFAULT));
    cuts.sort_by(f64::total_cmp);
    let curve = Arc::new(arc.clone());
    let mut start = arc.start();
    for (idx, pair) in cuts.windows(2).enumerate() {
        let end = if idx + 2 == cuts.len() { arc.end() } else { arc.point_at(pair[1]) };
        let own = (Arc::clone(&curve), [pair[0], pair[1]]);
        pieces.extend(RisingPiece::new(Some(own), [start, end]));
        start = end;
    }
}
