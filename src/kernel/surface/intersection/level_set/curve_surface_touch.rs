//! Where a curve comes near a surface without crossing it clearly: touches of any order, ends that are
//! short of the surface, and stretches that the two share.

use super::{
    bezier_segment::LyingPiece, curve_surface_intersection::PiercingSearch, error::PictureError,
    results::CurveSurfaceIntersection,
};
use crate::{
    GeomError, Interval,
    frame::norm,
    sorting::sort_by,
    valley::{FLOOR_ROUNDINGS, Valley, edge, round},
};

/// A touch this many times longer than its parts is looked at for how the distance runs along it.
const LONGEST_TOUCH: f64 = 24.0;

/// A longer share of a stretch, on which the distance is the least, runs along the surface.
const FLOOR_SHARE: f64 = 0.5;

/// A touch leaves its neighbourhood where it is this share of the tolerance away.
const APART_SHARE: f64 = 0.5;

/// Cells of a domain at whose ends it is looked whether the curve is on the surface.
const N_CELLS: usize = 128;

/// Cells between two places at whose ends it is looked whether the curve leaves the surface.
const N_BETWEEN: usize = 16;

/// A place where the curve comes near the surface, and how far it is from it; nothing up to rounding.
#[derive(Clone, Copy)]
pub(super) struct NearPlace {
    place: CurveSurfaceIntersection,
    height: f64,
}

impl PiercingSearch<'_> {
    /// The nearest approach within each stretch of pieces.
    pub(super) fn touches(&self, mut pieces: Vec<LyingPiece>) -> Result<Vec<NearPlace>, GeomError> {
        sort_by(&mut pieces, |a, b| a.ends[0].total_cmp(&b.ends[0]));
        let mut stretches: Vec<LyingPiece> = Vec::new();
        for piece in pieces {
            match stretches.last_mut() {
                Some(last) if piece.ends[0] <= last.ends[1] => {
                    last.ends[1] = last.ends[1].max(piece.ends[1]);
                    last.bounds = last.bounds.union(piece.bounds);
                    last.widest = last.widest.max(piece.widest);
                }
                _ => stretches.push(piece),
            }
        }
        let mut found = Vec::new();
        for LyingPiece { ends: [start, end], bounds, widest } in stretches {
            let Ok(stretch) = Interval::new(start, end) else { continue };
            let valley = Valley::of(|t| self.apart(t), stretch, self.rounding);
            let is_long = LONGEST_TOUCH * widest < bounds.diagonal();
            if is_long && !self.is_touch(&valley, bounds.diagonal()) {
                return Err(self.runs_along([start, end]));
            }
            let foot = self.surface.closest(self.curve.point_at(valley.bottom));
            let is_on = foot.distance <= FLOOR_ROUNDINGS * self.rounding;
            let height = if is_on { 0.0 } else { foot.distance };
            let place = self.piercing(valley.bottom, foot.parameters);
            found.extend(place.map(|place| NearPlace { place, height }));
        }
        Ok(found)
    }

    /// How far the curve is from the surface.
    fn apart(&self, t: f64) -> f64 {
        self.surface.closest(self.curve.point_at(t)).distance
    }

    /// Whether a stretch of that size has its floor in one place and rises on both sides of it: a
    /// touch of higher order.
    fn is_touch(&self, valley: &Valley, size: f64) -> bool {
        let start = self.curve.point_at(valley.floor.start());
        let floor = start.distance(self.curve.point_at(valley.floor.end()));
        valley.is_single
            && valley.rises_to(APART_SHARE * self.tolerance, [false; 2])
            && floor <= FLOOR_SHARE * size
    }

    /// The refusal of a curve that runs along the surface: with the longest stretch on which it does so, or where
    /// that is too short to be seen with the one that is given.
    pub(super) fn runs_along(&self, given: [f64; 2]) -> GeomError {
        let is_on = |t: f64| self.apart(t) <= self.tolerance;
        let places = self.curve.domain().steps(N_CELLS);
        let mut longest: Option<(f64, [f64; 2])> = None;
        for run in places.chunk_by(|&a, &b| is_on(a) == is_on(b)).filter(|run| is_on(run[0])) {
            let ends = [run[0], run[run.len() - 1]];
            let length = ends[1] - ends[0];
            if 0.0 < length && longest.is_none_or(|(most, _)| most < length) {
                longest = Some((length, ends));
            }
        }
        let [start, end] = longest.map_or(given, |(_, [start, end])| {
            let domain = self.curve.domain();
            let cell = domain.length() / N_CELLS as f64;
            let out = |inside: f64, step: f64| {
                let outside = (inside + step).clamp(domain.start(), domain.end());
                let last = edge(&is_on, inside, outside);
                // It leaves the tolerance a little after it leaves the surface.
                let speed = norm(self.curve.velocity_at(last)[1]);
                round(last, 4.0 * self.tolerance / speed).clamp(domain.start(), domain.end())
            };
            [out(start, -cell), out(end, cell)]
        });
        PictureError::RunsAlong { start, end }.into()
    }

    /// Crossings and touches; of places between which the curve does not leave the surface's neighbourhood those
    /// on the surface, or where there is none of these the nearest.
    pub(super) fn nearest_places(
        &self,
        crossings: Vec<CurveSurfaceIntersection>,
        touches: Vec<NearPlace>,
    ) -> Vec<CurveSurfaceIntersection> {
        // At a pole or a border a search may stop beside a crossing.
        let on_surface = crossings.into_iter().map(|place| {
            let on_surface = self.surface.point_at(place.uv[0], place.uv[1]);
            let apart = self.curve.point_at(place.t).distance(on_surface);
            let height = if apart <= FLOOR_ROUNDINGS * self.rounding { 0.0 } else { apart };
            NearPlace { place, height }
        });
        let mut places: Vec<NearPlace> = on_surface.chain(touches).collect();
        sort_by(&mut places, |a, b| a.place.t.total_cmp(&b.place.t));
        let is_one = |a: &NearPlace, b: &NearPlace| {
            0.0 < a.height.max(b.height) && self.stays_near([a.place.t, b.place.t])
        };
        let mut groups: Vec<Vec<NearPlace>> =
            places.chunk_by(is_one).map(<[NearPlace]>::to_vec).collect();
        if 1 < groups.len() && self.is_one_over_seam(&places[0], &places[places.len() - 1]) {
            let last = groups.pop().unwrap_or_default();
            groups[0].extend(last);
        }
        let told = |group: Vec<NearPlace>| {
            let lowest = group.iter().map(|near| near.height).fold(f64::INFINITY, f64::min);
            let n_told = if 0.0 < lowest { 1 } else { group.len() };
            let is_lowest = move |near: &NearPlace| near.height <= lowest;
            group.into_iter().filter(is_lowest).map(|near| near.place).take(n_told)
        };
        groups.into_iter().flat_map(told).collect()
    }

    /// Whether the curve closes and stays near the surface from its last place over its end to its first.
    fn is_one_over_seam(&self, first: &NearPlace, last: &NearPlace) -> bool {
        let domain = self.curve.domain();
        0.0 < first.height.max(last.height)
            && self.curve.is_closed(self.tolerance)
            && self.stays_near([last.place.t, domain.end()])
            && self.stays_near([domain.start(), first.place.t])
    }

    /// Whether the curve does not leave the surface's neighbourhood between parameters.
    fn stays_near(&self, [start, end]: [f64; 2]) -> bool {
        let is_near = |t: f64| self.apart(t) <= self.tolerance;
        let between = Interval::new(start, end).map(|between| between.steps(N_BETWEEN));
        between.map_or(true, |places| places.into_iter().all(is_near))
    }
}
