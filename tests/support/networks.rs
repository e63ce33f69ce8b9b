//! Networks of curves of real aircraft parts, from `tests/data/networks`.

#![allow(dead_code, clippy::unwrap_used, reason = "each user has its own part; data are there")]

use std::{fs, path::Path};

use glam::DVec3;
use serde_json::Value;
use virote_kernel::{Bounds, KnotVector, NurbsCurve, NurbsSurface};

/// A network, and what another program makes of it.
pub(crate) struct Known {
    /// The name of its file.
    pub(crate) name: &'static str,
    /// Control points along u and v of the surface of degree 3 that `occ_gordon` 1.4 makes.
    pub(crate) peer: [usize; 2],
    /// How far that surface is from the curves, as a fraction of the size.
    pub(crate) peer_deviation: f64,
    /// The tolerance for ours, as a fraction of the size: beyond the gaps of the curves.
    pub(crate) tolerance: f64,
}

const fn known(name: &'static str, peer: [usize; 2], peer_deviation: f64, tolerance: f64) -> Known {
    Known { name, peer, peer_deviation, tolerance }
}

/// All of them.
pub(crate) const NETWORKS: &[Known] = &[
    known("bellyfairing", [76, 20], 4e-6, 1e-6),
    known("helibody", [148, 73], 1.5e-4, 1e-6),
    known("nacelle", [22, 61], 1e-3, 1e-6),
    // Its curves miss each other by 1.3e-4.
    known("spiralwing", [81, 64], 1.6e-4, 1.35e-4),
    known("test_surface4", [16, 17], 5e-4, 1e-6),
    known("wing3", [54, 25], 2.6e-4, 1e-6),
];

impl Known {
    /// The profiles and the guides; of guides that close, the first is not repeated.
    pub(crate) fn curves(&self) -> [Vec<NurbsCurve>; 2] {
        // Laws are built in the kernel's package, benches in the one above it.
        let above = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
        let mut folders = above.map(|folder| folder.join("tests/data/networks"));
        let folder = folders.find(|folder| folder.is_dir()).unwrap();
        let data = fs::read(folder.join(format!("{}.json", self.name))).unwrap();
        let data: Value = serde_json::from_slice(&data).unwrap();
        let family =
            |name: &str| data[name].as_array().unwrap().iter().map(curve).collect::<Vec<_>>();
        let (profiles, mut guides) = (family("profiles"), family("guides"));
        if guides[0].points() == guides[guides.len() - 1].points() {
            guides.pop();
        }
        [profiles, guides]
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

fn curve(data: &Value) -> NurbsCurve {
    let knots = numbers(&data["knots"]).into_iter().zip(numbers(&data["mults"]));
    let knots = knots.flat_map(|(t, times)| vec![t; times as usize]).collect();
    let poles = data["poles"].as_array().unwrap();
    let points: Vec<DVec3> = poles.iter().map(|p| DVec3::from_slice(&numbers(p))).collect();
    let degree = data["degree"].as_u64().unwrap() as usize;
    let knots = KnotVector::new(degree, knots).unwrap();
    NurbsCurve::rational(knots, &points, &numbers(&data["weights"])).unwrap()
}

/// The diagonal of the box around the control points.
pub(crate) fn size(families: &[Vec<NurbsCurve>; 2]) -> f64 {
    Bounds::of(families.iter().flatten().flat_map(NurbsCurve::points)).unwrap().diagonal()
}

/// The largest distance of about so many points of the curves from the surface.
pub(crate) fn measured(families: &[Vec<NurbsCurve>; 2], surface: &NurbsSurface, n: usize) -> f64 {
    let places = |family: &Vec<NurbsCurve>| n / family.len() + 2;
    let points = families.iter().flat_map(|family| {
        let n = places(family);
        family.iter().flat_map(move |curve| curve.sample(n))
    });
    points.map(|p| surface.closest(p).distance).fold(0.0, f64::max)
}
