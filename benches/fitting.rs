//! How fast curves are fitted to points.

#![expect(clippy::unwrap_used, reason = "an example that cannot be built ends the benchmark")]

use divan::{Bencher, counter::ItemsCount};
use glam::DVec3;
use virote::kernel::{Ends, Interpolator, Parametrization, approximate, approximate_within};

fn main() {
    divan::main();
}

/// Points of a wave that winds upward.
fn wave(n: usize) -> Vec<DVec3> {
    let point = |i: usize| {
        let t = i as f64 * 0.01;
        DVec3::new(t, libm::sin(t), libm::cos(2.0 * t))
    };
    (0..n).map(point).collect()
}

/// The same with noise of a few hundredths.
fn noisy_wave(n: usize) -> Vec<DVec3> {
    let noise = |i: usize| 0.03 * libm::sin((i * i % 1009) as f64);
    wave(n).into_iter().enumerate().map(|(i, point)| point + DVec3::Y * noise(i)).collect()
}

/// A wave that is cut off at the top and at the bottom: four corners a turn.
fn clipped_wave(n: usize) -> Vec<DVec3> {
    wave(n).into_iter().map(|point| DVec3::new(point.x, point.y.clamp(-0.7, 0.7), 0.0)).collect()
}

/// The outline of the NACA 0012 at 69 points.
fn aerofoil() -> Vec<DVec3> {
    let half = |x: f64| {
        let tail = x * (-0.126 + x * (-0.3516 + x * (0.2843 - 0.1036 * x)));
        0.6 * (0.2969 * x.sqrt() + tail)
    };
    let station = |i: i32| 0.5 - 0.5 * libm::cos(f64::from(i) * std::f64::consts::PI / 34.0);
    let side = |sign: f64| move |i: i32| DVec3::new(station(i), sign * half(station(i)), 0.0);
    (0..=34).rev().map(side(1.0)).chain((1..=34).map(side(-1.0))).collect()
}

#[divan::bench(args = [1_000, 100_000])]
fn interpolate_by_chord_length(bencher: Bencher<'_, '_>, n: usize) {
    let points = wave(n);
    bencher.counter(ItemsCount::new(n)).bench(|| {
        let parameters = Parametrization::Chord.parameters(&points).unwrap();
        Interpolator::new(&parameters, 3, Ends::Bessel).unwrap().curve(&points).unwrap()
    });
}

#[divan::bench(args = [1_000, 100_000])]
fn interpolate_closed(bencher: Bencher<'_, '_>, n: usize) {
    let mut points = wave(n);
    points.push(points[0]);
    bencher.counter(ItemsCount::new(n)).bench(|| {
        let parameters = Parametrization::Chord.parameters(&points).unwrap();
        Interpolator::periodic(&parameters, 3).unwrap().curve(&points[..n]).unwrap()
    });
}

#[divan::bench(args = [1_000, 100_000])]
fn least_squares(bencher: Bencher<'_, '_>, n: usize) {
    let points = wave(n);
    let parameters = Parametrization::Chord.parameters(&points).unwrap();
    bencher
        .counter(ItemsCount::new(n))
        .bench(|| approximate(&points, &parameters, 3, n / 10).unwrap());
}

#[divan::bench(args = [1e-3, 1e-4, 1e-5])]
fn aerofoil_within(bencher: Bencher<'_, '_>, tolerance: f64) {
    let points = aerofoil();
    let parameters = Parametrization::Chord.parameters(&points).unwrap();
    bencher.bench(|| approximate_within(&points, &parameters, 3, tolerance, false).unwrap());
}

#[divan::bench(args = [1_000, 10_000, 100_000], sample_count = 5)]
fn wave_within_a_thousandth(bencher: Bencher<'_, '_>, n: usize) {
    let points = wave(n);
    let parameters = Parametrization::Chord.parameters(&points).unwrap();
    bencher.bench(|| approximate_within(&points, &parameters, 3, 1e-3, false).unwrap());
}

#[divan::bench(args = [1_000, 100_000], sample_count = 5)]
fn noisy_wave_within_a_tenth(bencher: Bencher<'_, '_>, n: usize) {
    let points = noisy_wave(n);
    let parameters = Parametrization::Chord.parameters(&points).unwrap();
    bencher.bench(|| approximate_within(&points, &parameters, 3, 0.1, false).unwrap());
}

#[divan::bench(args = [1_000, 100_000], sample_count = 5)]
fn clipped_wave_within_a_thousandth(bencher: Bencher<'_, '_>, n: usize) {
    let points = clipped_wave(n);
    let parameters = Parametrization::Chord.parameters(&points).unwrap();
    bencher.bench(|| approximate_within(&points, &parameters, 3, 1e-3, false).unwrap());
}
