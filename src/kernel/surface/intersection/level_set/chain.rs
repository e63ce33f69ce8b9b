//! Runs of samples joined end to end.

use glam::DVec3;

use super::{
    branch_sample::BranchSample,
    sample::{BranchSamples, VanishingPlace},
};
use crate::{sorting::sort_by, tolerance::ONE_PLACE_SHARE};

/// Tolerances up to which a run between places where others meet is a part of these places.
const SHORTEST_BETWEEN: f64 = 16.0;

/// Radii of a place up to which a sample is near it: of longer steps a circle says less than the samples in them.
const NEAR_RADII: f64 = 8.0;

/// Radii of a spot within which a run from it back to it is rounding.
const WITHIN_RADII: f64 = 2.0;

/// Lines, and the spots through which none goes.
#[derive(Debug, Default)]
pub(super) struct ChainedLines {
    pub(super) lines: Vec<Vec<BranchSample>>,
    pub(super) isolated: Vec<DVec3>,
}

/// Joins runs where exactly two ends meet, also over a spot; where more meet, all end in one point.
/// Runs that pass through an exact spot end there. Ends that nothing meets are joined to others that are within the
/// tolerance.
pub(super) fn chained(
    runs: Vec<BranchSamples>,
    spots: &[VanishingPlace],
    tolerance: f64,
) -> ChainedLines {
    let mut runs: Vec<BranchSamples> =
        runs.into_iter().flat_map(|run| parted(run, spots, tolerance)).collect();
    let mut groups = EndGroups::new(&runs, spots, ONE_PLACE_SHARE * tolerance);
    let contracted = groups.contract(&runs, SHORTEST_BETWEEN * tolerance);
    // What runs inside a spot says nothing.
    let is_inside = |i: usize, groups: &mut EndGroups| {
        groups.are_joined(2 * i, 2 * i + 1)
            && (contracted.contains(&i)
                || runs[i].length() <= 4.0 * tolerance
                || groups.hold(&runs[i], (i, runs.len()), spots))
    };
    let is_lost: Vec<bool> = (0..runs.len()).map(|i| is_inside(i, &mut groups)).collect();
    let ends: Vec<usize> = (0..2 * runs.len()).filter(|end| !is_lost[end / 2]).collect();

    let mut members: Vec<Vec<usize>> = vec![Vec::new(); groups.parents.len()];
    for &end in &ends {
        members[groups.root(end)].push(end);
    }
    let mut isolated = Vec::new();
    let n_ends = 2 * runs.len();
    let mut spots_of: Vec<Vec<usize>> = vec![Vec::new(); groups.parents.len()];
    for i in 0..spots.len() {
        spots_of[groups.root(n_ends + i)].push(i);
    }
    let mut partner: Vec<Option<usize>> = vec![None; n_ends];
    let mut alone = Vec::new();
    for (members, own_spots) in members.iter().zip(&spots_of) {
        let middle = |points: &mut dyn Iterator<Item = DVec3>| {
            let (sum, n) =
                points.fold((DVec3::ZERO, 0.0), |(sum, n), point| (sum + point, n + 1.0));
            sum / f64::max(n, 1.0)
        };
        let middle_of = |own_spots: &[usize]| {
            let is_exact = own_spots.iter().any(|&i| spots[i].is_exact);
            let own = own_spots.iter().map(|&i| spots[i]);
            middle(&mut own.filter(|spot| spot.is_exact || !is_exact).map(|spot| spot.point))
        };
        match members[..] {
            [] if own_spots.is_empty() => {}
            [] => isolated.push(middle_of(own_spots)),
            [end] => alone.push(end),
            [a, b] => {
                partner[a] = Some(b);
                partner[b] = Some(a);
            }
            _ => {
                let place = if own_spots.is_empty() {
                    middle(&mut members.iter().map(|&end| point(&runs, end)))
                } else {
                    middle_of(own_spots)
                };
                let own = own_spots.iter().map(|&i| spots[i]).filter(|spot| spot.is_exact);
                let radius = own.map(|spot| reach(&spot, tolerance)).fold(0.0, f64::max);
                members.iter().for_each(|&end| move_end(&mut runs, end, place, radius));
            }
        }
    }
    pair_alone(&runs, alone, tolerance, &mut partner);
    ChainedLines { lines: walked(&runs, &is_lost, &partner), isolated }
}

/// How far about an exact spot samples say nothing: rounding makes wide spots of flat places, in which they do.
fn reach(spot: &VanishingPlace, tolerance: f64) -> f64 {
    spot.radius.min(SHORTEST_BETWEEN * tolerance)
}

/// The parts of a run between the exact spots in which it neither begins nor ends: where the way from one line to
/// another that it crosses is shorter than rounding, a graph may turn from one into the other.
fn parted(run: BranchSamples, spots: &[VanishingPlace], tolerance: f64) -> Vec<BranchSamples> {
    let away = |spot: &VanishingPlace, i: usize| run.samples[i].point.distance(spot.point);
    let last = run.samples.len() - 1;
    let place_within = |spot: &VanishingPlace| {
        let is_within = |&i: &usize| away(spot, i) <= reach(spot, tolerance);
        if [0, last].iter().any(is_within) {
            return None;
        }
        let nearest = (1..last).min_by(|&i, &k| away(spot, i).total_cmp(&away(spot, k)));
        nearest.filter(is_within)
    };
    let exact = spots.iter().filter(|spot| spot.is_exact);
    let mut places: Vec<usize> = exact.filter_map(place_within).collect();
    places.sort_unstable();
    places.dedup();
    let starts = std::iter::once(0).chain(places.iter().copied());
    let ends = places.iter().copied().chain([last]);
    let part = |(start, end)| BranchSamples { samples: run.samples[start..=end].to_vec() };
    starts.zip(ends).map(part).collect()
}

fn point(runs: &[BranchSamples], end: usize) -> DVec3 {
    if end.is_multiple_of(2) { runs[end / 2].start() } else { runs[end / 2].end() }
}

/// The end of a run goes to where several meet; its own tangent there is that of a limit. Within the radius samples
/// tell no direction: where the next one is near, the run comes from there by a circle.
fn move_end(runs: &mut [BranchSamples], end: usize, place: DVec3, radius: f64) {
    let samples = &mut runs[end / 2].samples;
    let is_start = end.is_multiple_of(2);
    if is_start {
        samples.reverse();
    }
    let away = |sample: &BranchSample| sample.point.distance(place);
    if let Some((last, others)) = samples.split_last_mut() {
        last.point = place;
        let before = others.iter().rposition(|sample| radius < away(sample));
        if let Some(before) = before.filter(|&i| away(&others[i]) <= NEAR_RADII * radius) {
            let sample = others[before];
            let chord = (place - sample.point).normalize_or_zero();
            let tangent = if is_start { sample.before } else { sample.behind };
            let tangent = 2.0 * chord.dot(tangent) * chord - tangent;
            (last.before, last.behind) = (tangent, tangent);
            samples.drain(before + 1..samples.len() - 1);
        }
    }
    if is_start {
        samples.reverse();
    }
}

/// Pairs ends, the nearest first, up to the tolerance.
fn pair_alone(
    runs: &[BranchSamples],
    alone: Vec<usize>,
    tolerance: f64,
    partner: &mut [Option<usize>],
) {
    let places: Vec<(DVec3, f64)> = alone.iter().map(|&end| (point(runs, end), 0.0)).collect();
    let mut pairs: Vec<(f64, usize, usize)> = near_pairs(&places, tolerance)
        .into_iter()
        .map(|(i, k)| (places[i].0.distance(places[k].0), alone[i], alone[k]))
        .collect();
    sort_by(&mut pairs, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
    for (_, a, b) in pairs {
        if partner[a].is_none() && partner[b].is_none() {
            partner[a] = Some(b);
            partner[b] = Some(a);
        }
    }
}

/// The lines of samples along partners: first those with ends, then the closed ones.
fn walked(
    runs: &[BranchSamples],
    is_lost: &[bool],
    partner: &[Option<usize>],
) -> Vec<Vec<BranchSample>> {
    let mut is_done = is_lost.to_vec();
    let mut lines = Vec::new();
    let with_end = (0..2 * runs.len()).filter(|&end| partner[end].is_none());
    for entry in with_end.chain((0..runs.len()).map(|i| 2 * i)) {
        if is_done[entry / 2] {
            continue;
        }
        let mut line: Vec<BranchSamples> = Vec::new();
        let mut next = Some(entry);
        let mut is_closed = false;
        while let Some(entry) = next {
            if is_done[entry / 2] {
                is_closed = true;
                break;
            }
            is_done[entry / 2] = true;
            let run = runs[entry / 2].clone();
            line.push(if entry.is_multiple_of(2) { run } else { run.turned() });
            // A turned run has its direction against the field.
            next = partner[entry ^ 1];
        }
        let is_turned = entry % 2 == 1;
        let samples = joined(line, is_closed);
        lines.push(if is_turned { turned(samples) } else { samples });
    }
    lines
}

fn turned(mut samples: Vec<BranchSample>) -> Vec<BranchSample> {
    samples.reverse();
    samples.into_iter().map(BranchSample::turned).collect()
}

/// The samples of runs one after the other, each joint once; of a closed line the last is the
/// first.
fn joined(line: Vec<BranchSamples>, is_closed: bool) -> Vec<BranchSample> {
    let mut samples: Vec<BranchSample> = Vec::new();
    for run in line {
        match (samples.last_mut(), run.samples.split_first()) {
            (Some(last), Some((first, others))) => {
                last.behind = first.behind;
                samples.extend_from_slice(others);
            }
            _ => samples.extend(run.samples),
        }
    }
    if is_closed && 1 < samples.len() {
        let start = samples[0];
        if let Some(last) = samples.last_mut() {
            last.point = start.point;
            last.behind = start.behind;
        }
        samples[0].before = samples[samples.len() - 1].before;
    }
    samples
}

/// Pairs of places that are nearer than the distance and their radii, by index.
pub(super) fn near_pairs(places: &[(DVec3, f64)], distance: f64) -> Vec<(usize, usize)> {
    let widest = places.iter().map(|place| place.1).fold(0.0, f64::max);
    let mut order: Vec<usize> = (0..places.len()).collect();
    sort_by(&mut order, |&a, &b| places[a].0.x.total_cmp(&places[b].0.x).then(a.cmp(&b)));
    let mut pairs = Vec::new();
    for (n, &i) in order.iter().enumerate() {
        let (place, radius) = places[i];
        for &k in &order[n + 1..] {
            let (other, other_radius) = places[k];
            if distance + radius + widest < other.x - place.x {
                break;
            }
            if place.distance(other) <= distance + radius + other_radius {
                pairs.push((i.min(k), i.max(k)));
            }
        }
    }
    pairs
}

/// Ends of runs and spots that are one place, as a forest.
struct EndGroups {
    parents: Vec<usize>,
}

impl EndGroups {
    fn new(runs: &[BranchSamples], spots: &[VanishingPlace], distance: f64) -> Self {
        let ends = runs.iter().flat_map(|run| [(run.start(), 0.0), (run.end(), 0.0)]);
        let places: Vec<(DVec3, f64)> =
            ends.chain(spots.iter().map(|spot| (spot.point, spot.radius))).collect();
        let mut groups = Self { parents: (0..places.len()).collect() };
        for (a, b) in near_pairs(&places, distance) {
            let (a, b) = (groups.root(a), groups.root(b));
            groups.parents[a.max(b)] = a.min(b);
        }
        groups
    }

    fn root(&mut self, mut i: usize) -> usize {
        while self.parents[i] != i {
            self.parents[i] = self.parents[self.parents[i]];
            i = self.parents[i];
        }
        i
    }

    /// Makes one place of the ends of each run of at most a length that lies between places where
    /// others meet, or in one, and tells which: rounding parts a place where lines cross at a small angle.
    fn contract(&mut self, runs: &[BranchSamples], length: f64) -> Vec<usize> {
        let mut contracted = Vec::new();
        let mut n_ends = vec![0; self.parents.len()];
        for end in 0..2 * runs.len() {
            n_ends[self.root(end)] += 1;
        }
        for (i, run) in runs.iter().enumerate() {
            if run.start().distance(run.end()) <= length && run.length() <= length {
                let ends = [self.root(2 * i), self.root(2 * i + 1)];
                if ends[0] == ends[1] && 4 <= n_ends[ends[0]] {
                    contracted.push(i);
                } else if ends[0] != ends[1] && ends.iter().all(|&end| 3 <= n_ends[end]) {
                    let [first, second] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
                    self.parents[second] = first;
                    n_ends[first] += n_ends[second];
                    contracted.push(i);
                }
            }
        }
        contracted
    }

    /// Whether all of a run, of its number among so many, is within the spots that it begins and ends in.
    fn hold(
        &mut self,
        run: &BranchSamples,
        (number, n_runs): (usize, usize),
        spots: &[VanishingPlace],
    ) -> bool {
        let own = self.root(2 * number);
        let its: Vec<&VanishingPlace> = spots
            .iter()
            .enumerate()
            .filter(|&(k, _)| self.root(2 * n_runs + k) == own)
            .map(|(_, spot)| spot)
            .collect();
        let is_within = |sample: &BranchSample| {
            its.iter().any(|spot| sample.point.distance(spot.point) <= WITHIN_RADII * spot.radius)
        };
        run.samples.iter().all(is_within)
    }

    fn are_joined(&mut self, a: usize, b: usize) -> bool {
        self.root(a) == self.root(b)
    }
}
