//! The nearest point of a curve and of a surface: how long it takes, and how often it is wrong,
//! told by brute force: samples, the best of which are refined.

use std::{hint::black_box, time::Instant};

use geomcore::{Point, PointExtrema, Tolerance, prelude::ParametricSurface};
use glam::DVec3;
use virote::kernel::{Grid, NurbsSurface};

use crate::{
    curve, in_geomcore,
    surfaces::{both, in_glam},
};

/// Places that are asked for.
const N_TRIES_ON_CURVE: usize = 100_000;
const N_TRIES_ON_SURFACE: usize = 10_000;

/// Places that are timed at once, and how often.
const PART: usize = 100;
const N_ROUNDS: usize = 3;

/// Samples of brute force along each direction.
const N_SAMPLES: usize = 3000;
const N_SIDE_SAMPLES: usize = 120;

/// An answer is wrong if it is further away than another by more than this.
const WRONG: f64 = 1e-9;

/// An answer: its distance.
type Ask<'a> = &'a dyn Fn(DVec3) -> f64;

pub(crate) fn on_a_curve() {
    println!("{N_TRIES_ON_CURVE} nearest points on the curve");
    let ours = curve();
    let theirs = in_geomcore(&ours);
    let samples: Vec<(f64, DVec3)> =
        ours.domain().steps(N_SAMPLES).into_iter().map(|t| (t, ours.point_at(t))).collect();
    let by_force = |p: DVec3| {
        let least = |t: f64| ours.point_at(t.clamp(0.0, 1.0)).distance(p);
        best_of(&samples, p)
            .into_iter()
            .map(|(distance, t)| {
                let (mut best, mut t, mut step) = (distance, t, 1.0 / N_SAMPLES as f64);
                for _ in 0..50 {
                    for next in [t - step, t + step] {
                        let distance = least(next);
                        if distance < best {
                            (best, t) = (distance, next.clamp(0.0, 1.0));
                        }
                    }
                    step *= 0.5;
                }
                best
            })
            .fold(f64::INFINITY, f64::min)
    };
    let (low, size) = (DVec3::new(-15.0, -3.0, -3.0), DVec3::new(130.0, 17.0, 19.0));
    let places: Vec<DVec3> = scattered(N_TRIES_ON_CURVE).map(|at| low + size * at).collect();
    let our_answer = |p: DVec3| ours.closest(p, 1e-6).distance;
    let their_answer = |p: DVec3| {
        in_glam(theirs.project_point(in_their_terms(p), Tolerance::DEFAULT).point).distance(p)
    };
    compare(&places, &our_answer, &their_answer, &by_force);
}

pub(crate) fn on_a_surface() {
    let wave = Grid::from_fn(12, 12, |i, j| {
        let height = 2.0 * (1.1 * i as f64).sin() * (0.9 * j as f64).cos();
        (DVec3::new(i as f64, j as f64, height), 1.0)
    });
    let bumps = Grid::from_fn(50, 50, |i, j| {
        let weight = 1.0 + 0.1 * ((3 * i + 5 * j) % 7) as f64;
        (DVec3::new(i as f64, j as f64, 0.1 * ((7 * i + 13 * j) % 11) as f64), weight)
    });
    for (name, net) in [("a wave of 12 x 12", wave), ("a rational surface of 50 x 50", bumps)] {
        println!("{N_TRIES_ON_SURFACE} nearest points on {name}, also from beside it");
        let (ours, theirs) = both(&net);
        let samples = samples(&ours);
        let by_force = |p: DVec3| refined(&ours, best_of(&samples, p), p);
        let side = net.n_rows() as f64;
        let low = DVec3::new(-0.2 * side, -0.2 * side, -4.0);
        let size = DVec3::new(1.4 * side, 1.4 * side, 8.0);
        let places: Vec<DVec3> = scattered(N_TRIES_ON_SURFACE).map(|at| low + size * at).collect();
        let our_answer = |p: DVec3| ours.closest(p).distance;
        let their_answer = |p: DVec3| {
            in_glam(theirs.project_point(in_their_terms(p), Tolerance::DEFAULT).point).distance(p)
        };
        compare(&places, &our_answer, &their_answer, &by_force);
    }
}

/// Times both in turn, part by part, each as its least of some rounds, and counts wrong answers.
fn compare(places: &[DVec3], ours: Ask<'_>, theirs: Ask<'_>, by_force: Ask<'_>) {
    let mut times = [0.0, 0.0];
    let mut wrong = [0, 0];
    let mut by_force_alone = 0;
    for part in places.chunks(PART) {
        let mut least = [f64::INFINITY; 2];
        let mut answers = [Vec::new(), Vec::new()];
        for _ in 0..N_ROUNDS {
            for (i, ask) in [ours, theirs].into_iter().enumerate() {
                let start = Instant::now();
                answers[i] = black_box(part.iter().map(|&p| ask(p)).collect::<Vec<f64>>());
                least[i] = least[i].min(start.elapsed().as_secs_f64());
            }
        }
        for (i, &p) in part.iter().enumerate() {
            let found = [answers[0][i], answers[1][i]];
            let best = found[0].min(found[1]).min(by_force(p));
            for (wrong, found) in wrong.iter_mut().zip(found) {
                *wrong += usize::from(best + WRONG < found);
            }
            by_force_alone += usize::from(best + WRONG < found[0].min(found[1]));
        }
        times = [times[0] + least[0], times[1] + least[1]];
    }
    let [us, them] = times.map(|time| time * 1e9 / places.len() as f64);
    println!("  virote {us:9.0} ns   geomcore        {them:9.0} ns   {:6.1} times ours", them / us);
    println!("  wrong: virote {}, geomcore {}; both {by_force_alone}", wrong[0], wrong[1]);
}

fn in_their_terms(p: DVec3) -> Point {
    Point::new(p.x, p.y, p.z)
}

/// Numbers on 0..1 in no order.
fn scattered(n: usize) -> impl Iterator<Item = DVec3> {
    let steps = DVec3::new(0.819_172_513_396_164_4, 0.671_043_606_703_789_2, 0.549_700_477_901_97);
    (1..=n).map(move |i| (steps * i as f64).fract())
}

/// The four samples that are nearest, with their distances.
fn best_of<T: Copy>(samples: &[(T, DVec3)], p: DVec3) -> Vec<(f64, T)> {
    let mut best: Vec<(f64, T)> = Vec::new();
    for &(at, point) in samples {
        let distance = point.distance(p);
        if best.len() < 4 || distance < best[3].0 {
            best.truncate(3);
            let place = best.partition_point(|other| other.0 < distance);
            best.insert(place, (distance, at));
        }
    }
    best
}

fn samples(surface: &NurbsSurface) -> Vec<([f64; 2], DVec3)> {
    let ts: Vec<f64> = (0..=N_SIDE_SAMPLES).map(|i| i as f64 / N_SIDE_SAMPLES as f64).collect();
    let grid = surface.points_on_grid(&ts, &ts);
    let at = |i: usize, j: usize| ([ts[i], ts[j]], grid.get(i, j));
    (0..ts.len()).flat_map(|i| (0..ts.len()).map(move |j| (i, j))).map(|(i, j)| at(i, j)).collect()
}

/// Samples improved by a search around them in ever smaller steps.
fn refined(surface: &NurbsSurface, samples: Vec<(f64, [f64; 2])>, p: DVec3) -> f64 {
    let refine = |(mut best, mut at): (f64, [f64; 2])| {
        let mut step = 1.0 / N_SIDE_SAMPLES as f64;
        for _ in 0..40 {
            for (i, j) in [(-1, 0), (1, 0), (0, -1), (0, 1), (-1, -1), (1, 1), (-1, 1), (1, -1)] {
                let next = [at[0] + f64::from(i) * step, at[1] + f64::from(j) * step];
                let next = next.map(|t| t.clamp(0.0, 1.0));
                let distance = surface.point_at(next[0], next[1]).distance(p);
                if distance < best {
                    (best, at) = (distance, next);
                }
            }
            step *= 0.6;
        }
        best
    };
    samples.into_iter().map(refine).fold(f64::INFINITY, f64::min)
}
