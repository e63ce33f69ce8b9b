//! Laws of surfaces through sections.

use glam::DVec3;
use proptest::{collection::vec, prelude::Strategy, prop_assert, proptest};
use virote_kernel::{
    Along, CompatibleSections, GeomError, NurbsCurve, NurbsSurface, SectionParameters, WeightError,
};

use crate::some::{affine_map, curve};

/// Curves at heights that keep them apart.
fn sections(n: std::ops::Range<usize>) -> impl Strategy<Value = Vec<NurbsCurve>> {
    vec(curve(), n).prop_map(|curves| {
        let lifted = |(k, curve): (usize, NurbsCurve)| {
            let up = DVec3::new(0.0, 0.0, 30.0 * k as f64);
            curve.transformed(&glam::DAffine3::from_translation(up))
        };
        curves.into_iter().enumerate().map(lifted).collect()
    })
}

/// How far a section is from the isocurve at `v`, as a fraction of the model's size.
fn miss(surface: &NurbsSurface, v: f64, section: &NurbsCurve) -> f64 {
    let (from, to) = (section.domain(), surface.domain_u());
    let places = (0..=40).map(|i| f64::from(i) / 40.0);
    let apart = |f: f64| surface.point_at(to.at(f), v).distance(section.point_at(from.at(f)));
    places.map(apart).fold(0.0, f64::max) / 100.0
}

/// The skin, unless the weights between the sections leave no point.
fn skin(sections: &CompatibleSections, along: &Along) -> Option<NurbsSurface> {
    match sections.skinned(along) {
        Err(GeomError::Weights(WeightError::VanishingWeightsAt { .. })) => None,
        made => Some(made.unwrap().surface),
    }
}

proptest! {
    #[test]
    fn sections_are_isocurves(curves in sections(2..6), degree in 1..=4usize) {
        let all = CompatibleSections::new(&curves).unwrap();
        let parameters = all.parameters(SectionParameters::Average, false).unwrap();
        let Some(s) = skin(&all, &Along::free(&parameters, degree).unwrap()) else { return Ok(()) };
        prop_assert!(s.degree_v() == degree.min(curves.len() - 1));
        for (curve, &v) in curves.iter().zip(&parameters) {
            prop_assert!(miss(&s, v, curve) < 1e-12);
        }
    }

    #[test]
    fn sections_of_closed_and_monotone_skins_are_isocurves(curves in sections(3..6), degree in 1..=5usize, is_monotone in proptest::prelude::any::<bool>()) {
        let all = CompatibleSections::new(&curves).unwrap();
        let parameters = all.parameters(SectionParameters::Centripetal, true).unwrap();
        let along = match is_monotone {
            true => Along::monotone(&parameters, true),
            false => Along::closed(&parameters, degree),
        };
        let Some(s) = skin(&all, &along.unwrap()) else { return Ok(()) };
        for (curve, &v) in curves.iter().chain(&curves[..1]).zip(&parameters) {
            prop_assert!(miss(&s, v, curve) < 1e-12);
        }
    }

    #[test]
    fn monotone_skins_stay_in_the_box_of_two_neighbours(curves in sections(2..6), f in 0.0..1.0, g in 0.0..1.0) {
        let all = CompatibleSections::new(&curves).unwrap();
        let parameters = all.parameters(SectionParameters::Average, false).unwrap();
        let s = skin(&all, &Along::monotone(&parameters, false).unwrap()).unwrap();
        let (u, v) = (s.domain_u().at(f), g);
        let k = parameters.partition_point(|&t| t <= v).clamp(1, curves.len() - 1);
        let places = |k: usize| all.curves()[k].points();
        let all_points: Vec<DVec3> = [places(k - 1), places(k)].concat();
        let low = all_points.iter().copied().fold(DVec3::INFINITY, DVec3::min) - 1e-11;
        let high = all_points.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max) + 1e-11;
        let point = s.point_at(u, v);
        // Of rational sections the homogeneous coordinates are monotone, and points only polynomial ones.
        if !s.is_rational() {
            prop_assert!(point.cmpge(low).all() && point.cmple(high).all());
        }
    }

    #[test]
    fn skins_at_given_parameters_are_affinely_invariant(curves in sections(2..6), map in affine_map()) {
        let parameters: Vec<f64> = (0..curves.len()).map(|k| k as f64).collect();
        let along = Along::free(&parameters, 3).unwrap();
        let made = |curves: &[NurbsCurve]| skin(&CompatibleSections::new(curves).unwrap(), &along);
        let images: Vec<NurbsCurve> = curves.iter().map(|curve| curve.transformed(&map)).collect();
        let (Some(s), Some(image)) = (made(&curves), made(&images)) else { return Ok(()) };
        for (u, v) in [(0.1, 0.3), (0.5, 0.9), (0.8, 0.6)] {
            let (u, v) = (s.domain_u().at(u), s.domain_v().at(v));
            let place = s.point_at(u, v);
            // Weights that swing near zero blow rounding up.
            if place.length() < 1e4 {
                let expected = map.transform_point3(place);
                prop_assert!(image.point_at(u, v).distance(expected) < 1e-9 * (1.0 + place.length()));
            }
        }
    }

    #[test]
    fn derivatives_follow_the_spine(curves in sections(2..5), spine in vec(crate::some::point(), 4), degree in 2..=3usize) {
        let path = NurbsCurve::bezier(&spine).unwrap();
        let all = CompatibleSections::new(&curves).unwrap();
        let n = curves.len();
        let parameters: Vec<f64> = (0..n).map(|k| k as f64 / (n - 1) as f64).collect();
        let Ok(along) = Along::spine(&parameters, degree, &path, false) else { return Ok(()) };
        let Some(s) = skin(&all, &along) else { return Ok(()) };
        for &v in &parameters {
            let tangent = path.derivatives_at(v, 1)[1];
            let slope = s.derivatives_at(s.domain_u().at(0.37), v, 1).get(0, 1);
            if tangent.length() > 0.1 && slope.length() > 1e-3 {
                let angle = slope.cross(tangent).length() / slope.length() / tangent.length();
                prop_assert!(angle < 1e-9, "{angle} at {v}");
            }
        }
    }
}
