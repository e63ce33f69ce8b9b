//! Networks of real aircraft parts, which other programs miss, refuse, or make millions of control
//! points of.

use virote_kernel::{Gordon, Network, NetworkError, NurbsCurve, gordon};

use crate::networks::{Known, NETWORKS, measured, size};

fn made(known: &Known, curves: &[Vec<NurbsCurve>; 2]) -> Gordon {
    let tolerance = known.tolerance * size(curves);
    let at = [None, None];
    gordon(Network { curves: [&curves[0], &curves[1]], at, is_lagrange: false, tolerance }).unwrap()
}

/// `occ_gordon` 1.4 misses curves by up to a thousandth of the size; `OpenCASCADE` 8 makes bidegrees
/// up to 15 with up to 9.6 million control points, or refuses.
#[test]
fn every_curve_of_a_real_network_is_within_the_tolerance() {
    for known in NETWORKS {
        let curves = known.curves();
        let (made, allowed) = (made(known, &curves), known.tolerance * size(&curves));
        let bound = made.changes.iter().flatten().map(|c| c.deviation).fold(0.0, f64::max);
        assert!(bound <= allowed, "{}: {bound:e} is not {allowed:e}", known.name);
        let miss = measured(&curves, &made.surface, 300);
        // What is measured is no more than what is proven.
        assert!(miss <= bound + 1e-12 * size(&curves), "{}: {miss:e}, {bound:e}", known.name);
    }
}

#[test]
fn real_networks_become_surfaces_of_their_curves_degree_with_few_control_points() {
    for known in NETWORKS {
        let curves = known.curves();
        let surface = made(known, &curves).surface;
        let degree = curves.iter().flatten().map(NurbsCurve::degree).fold(3, usize::max);
        assert!(surface.degree_u().max(surface.degree_v()) <= degree, "{}", known.name);
        let net = surface.control_points();
        let peer = known.peer[0] * known.peer[1];
        assert!(net.n_rows() * net.n_columns() <= 2 * peer, "{}", known.name);
    }
}

/// `OpenCASCADE` 8 has a kink of 61 degrees in the helicopter's seam. The trailing edges of the
/// wings are sharp.
#[test]
fn a_seam_is_as_smooth_as_the_curves() {
    for known in NETWORKS {
        let curves = known.curves();
        let made = made(known, &curves);
        for (seam, family) in made.seams.iter().zip(&curves) {
            let Some(seam) = seam else { continue };
            let own = family.iter().map(|curve| {
                let domain = curve.domain();
                let ends = [domain.start(), domain.end()].map(|t| curve.derivatives_at(t, 1)[1]);
                ends[0].angle_between(ends[1])
            });
            let least = 0.01_f64.to_radians();
            assert!(least < own.fold(0.0, f64::max) || *seam < least, "{}: {seam}", known.name);
        }
    }
}

/// What is asked beyond what the data hold: two curves of the wing miss each other by more.
#[test]
fn a_gap_beyond_the_tolerance_is_told_with_its_curves() {
    let known = NETWORKS.iter().find(|known| known.name == "spiralwing").unwrap();
    let curves = known.curves();
    let tolerance = 1e-6 * size(&curves);
    let network = Network {
        curves: [&curves[0], &curves[1]],
        at: [None, None],
        is_lagrange: false,
        tolerance,
    };
    let error = gordon(network).unwrap_err();
    let NetworkError::Apart { gap, .. } = error else { unreachable!("{error:?}") };
    assert!(tolerance < gap && gap < 1.4e-4 * size(&curves), "{gap}");
}
