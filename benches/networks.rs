//! What `gordon` makes of six networks of real aircraft parts, as the rows of the table in
//! `docs/numerics.md`: `cargo bench --bench networks`.
//!
//! Below it the time for a network of ten by ten cubics that meet, and for a skin of fifty cubic
//! sections of fifty control points. The bound of the distance of the curves from the surface is the one that `report` tells; what
//! is measured is the distance of some four thousand points of the curves.

#![expect(clippy::unwrap_used, reason = "a network that cannot be made ends the program")]
#![expect(clippy::print_stdout, reason = "it prints a table")]

#[path = "../tests/support/networks.rs"]
mod networks;

use std::time::Instant;

use glam::DVec3;
use networks::{NETWORKS, measured, size};
use virote::kernel::{
    Along, CompatibleSections, Grid, KnotVector, Network, NurbsCurve, NurbsSurface,
    SectionParameters, gordon,
};

/// Points of the curves of each direction.
const N_PLACES: usize = 2000;

/// Runs of which the fastest counts.
const N_RUNS: usize = 3;

/// The shortest time of some runs, in milliseconds.
fn best(n: usize, mut run: impl FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..n {
        let start = Instant::now();
        run();
        best = best.min(start.elapsed().as_secs_f64());
    }
    best * 1e3
}

/// A wavy bicubic sheet of so many control points each way.
fn sheet(n: usize) -> NurbsSurface {
    let knots = || KnotVector::uniform_clamped(3, n, 1.0).unwrap();
    let at = |i: usize, j: usize| {
        let (x, y) = (i as f64, j as f64);
        DVec3::new(x, y, libm::sin(0.7 * x) * libm::cos(0.4 * y))
    };
    NurbsSurface::polynomial(knots(), knots(), &Grid::from_fn(n, n, at)).unwrap()
}

fn print_times() {
    let sheet = sheet(12);
    println!();
    for n in [10, 20, 40, 80] {
        let at = |k: usize| k as f64 / (n - 1) as f64;
        let us: Vec<NurbsCurve> = (0..n).map(|k| sheet.isocurve_v(at(k))).collect();
        let vs: Vec<NurbsCurve> = (0..n).map(|k| sheet.isocurve_u(at(k))).collect();
        let network =
            Network { curves: [&us, &vs], at: [None, None], is_lagrange: false, tolerance: 1e-6 };
        let time = best(10, || drop(gordon(network).unwrap()));
        println!("A network of {n} x {n} cubics that meet: {time:.1} ms");
    }

    let wide = self::sheet(50);
    let sections: Vec<NurbsCurve> = (0..50).map(|k| wide.isocurve_v(k as f64 / 49.0)).collect();
    let time = best(10, || {
        let all = CompatibleSections::new(&sections).unwrap();
        let parameters = all.parameters(SectionParameters::Average, false).unwrap();
        drop(all.skinned(&Along::free(&parameters, 3).unwrap()).unwrap());
    });
    println!("A skin of 50 cubic sections of 50 control points: {time:.1} ms");
}

fn main() {
    println!(
        "| network | tolerance | degrees | control points | of the peer's | ms | bound | measured | peer's | seam |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    for known in NETWORKS {
        let curves = known.curves();
        let size = size(&curves);
        let network = Network {
            curves: [&curves[0], &curves[1]],
            at: [None, None],
            is_lagrange: false,
            tolerance: known.tolerance * size,
        };
        let time = best(N_RUNS, || drop(gordon(network).unwrap()));
        let made = gordon(network).unwrap();
        let surface = &made.surface;
        let net = surface.control_points();
        let (n, m) = (net.n_rows(), net.n_columns());
        let deviations = made.changes.iter().flatten().map(|change| change.deviation);
        let seam = made.seams.iter().flatten().copied().fold(f64::NAN, f64::max);
        println!(
            "| {} | {:e} | {} x {} | {n} x {m} | {:.2} | {:.1} | {:.1e} | {:.1e} | {:.1e} | {} |",
            known.name,
            known.tolerance,
            surface.degree_u(),
            surface.degree_v(),
            (n * m) as f64 / (known.peer[0] * known.peer[1]) as f64,
            time,
            deviations.fold(0.0, f64::max) / size,
            measured(&curves, surface, N_PLACES) / size,
            known.peer_deviation,
            if seam.is_nan() { "open".to_owned() } else { format!("{:.4}°", seam.to_degrees()) },
        );
    }
    print_times();
}
