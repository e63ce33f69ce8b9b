//! Discs that touch, or overlap or miss one another by next to nothing: within the tolerance they touch; and offsets whose
//! sides cross next to their ends.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use virote_kernel::{
    CircleForm, CornerStyle, Frame, GeomError, NurbsCurve, Region, RegionError, Tolerance,
};

const TOLERANCE: Tolerance = Tolerance::DEFAULT;

/// By how much discs overlap, in tolerances; negative where they miss one another.
const WITHIN: [f64; 7] = [0.0, 1e-3, -1e-3, 0.1, -0.1, 0.9, -0.9];

const SCALES: [f64; 3] = [1e-3, 1.0, 1e3];

/// What is one at a scale.
fn distance_at(scale: f64) -> f64 {
    TOLERANCE.distance_for(2.0 * 2.0_f64.sqrt() * scale)
}

fn disc(x: f64, y: f64, radius: f64) -> Region {
    let frame = Frame::XY.at(DVec3::new(x, y, 0.0));
    let circle = NurbsCurve::ellipse(frame, [radius; 2], CircleForm::NinePoint).unwrap();
    Region::new(&circle, &[], TOLERANCE).unwrap()
}

/// The number of parts and their area over that of a disc of radius 1.
fn parts(found: Result<Vec<Region>, GeomError>, scale: f64, case: &str) -> (usize, f64) {
    assert!(found.is_ok(), "{case}: {found:?}");
    let found = found.unwrap();
    let area: f64 = found.iter().map(Region::area).sum();
    (found.len(), area / (PI * scale * scale))
}

#[track_caller]
fn check(found: Result<Vec<Region>, GeomError>, scale: f64, expected: (usize, f64), case: &str) {
    let (n, area) = parts(found, scale, case);
    assert!(n == expected.0 && (area - expected.1).abs() < 1e-8, "{case}: {n} parts, {area}");
}

#[test]
fn discs_side_by_side_within_the_tolerance_touch() {
    for scale in SCALES {
        for overlap in WITHIN {
            for angle in [0.0, 0.3, 1.0, 2.5, 4.0] {
                let case = format!("scale {scale}, overlap {overlap}, angle {angle}");
                let away = 2.0 * scale - overlap * distance_at(scale);
                let (x, y) = (away * libm::cos(angle), away * libm::sin(angle));
                let both = [disc(0.0, 0.0, scale), disc(x, y, scale)];
                check(Region::union(&both, TOLERANCE, 1), scale, (2, 2.0), &case);
                check(Region::intersection(&both, TOLERANCE, 1), scale, (0, 0.0), &case);
                check(Region::difference(&both, TOLERANCE, 1), scale, (1, 1.0), &case);
            }
        }
    }
}

#[test]
fn discs_that_overlap_by_more_have_their_lens_in_common_or_are_refused_there() {
    for overlap in [1.1e-6, 1e-5, 1e-3] {
        let both = [disc(0.0, 0.0, 1.0), disc(2.0 - overlap, 0.0, 1.0)];
        // Of radius 1, by the distance of a centre from the chord: 2(acos d - d √(1 - d²)).
        let d = 1.0 - overlap / 2.0;
        let lens = 2.0 * (libm::acos(d) - d * (1.0 - d * d).sqrt()) / PI;
        check(Region::union(&both, TOLERANCE, 1), 1.0, (1, 2.0 - lens), "union");
        match Region::intersection(&both, TOLERANCE, 1) {
            Err(GeomError::Region(RegionError::Thin { point, .. })) => {
                assert!(overlap < 2e-6 && (point.x - 1.0).abs() < 1e-5, "{overlap}: {point}");
            }
            found => check(found, 1.0, (1, lens), "intersection"),
        }
    }
}

#[test]
fn a_disc_that_touches_another_from_inside_is_whole_or_refused_where_it_comes_out() {
    for scale in SCALES {
        for out in WITHIN {
            let case = format!("scale {scale}, out {out}");
            let x = scale / 2.0 + out * distance_at(scale);
            let both = [disc(0.0, 0.0, scale), disc(x, 0.0, scale / 2.0)];
            let unions = Region::union(&both, TOLERANCE, 1);
            let commons = Region::intersection(&both, TOLERANCE, 1);
            let rests = Region::difference(&both, TOLERANCE, 1);
            for (found, expected) in [(unions, 1.0), (commons, 0.25), (rests, 0.75)] {
                match found {
                    Err(GeomError::Region(RegionError::Unclear { point })) if 0.0 < out => {
                        let off = point.distance(DVec3::X * scale);
                        assert!(off < 1e-2 * scale, "{case}: {point}");
                    }
                    found => check(found, scale, (1, expected), &case),
                }
            }
        }
    }
}

#[test]
fn polygons_of_many_sides_shrink_to_polygons() {
    for n in [50_u32, 100, 200, 360, 500, 1000] {
        let angle = TAU / f64::from(n);
        let corner = |i: u32| {
            let (y, x) = libm::sincos(f64::from(i % n) * angle);
            DVec3::new(x, y, 0.0)
        };
        let points: Vec<DVec3> = (0..=n).map(corner).collect();
        let polygon = Region::new(&NurbsCurve::polyline(&points).unwrap(), &[], TOLERANCE).unwrap();
        for distance in [0.01, 0.1] {
            let parts = polygon.offset(-distance, CornerStyle::Round, TOLERANCE).unwrap();
            let [part] = &parts[..] else { panic!("{n}: {} parts", parts.len()) };
            // A regular polygon of that many sides, at a distance from its middle.
            let apothem = libm::cos(0.5 * angle) - distance;
            let wanted = f64::from(n) * apothem * apothem * libm::tan(0.5 * angle);
            let found = part.area();
            assert!(
                (found - wanted).abs() < TOLERANCE.distance,
                "{n}, {distance}: {found} for {wanted}"
            );
        }
    }
}

/// A corner that turns by θ loses r²(tan(θ/2) − θ/2), next to nothing where it is nearly straight.
#[test]
fn corners_that_are_nearly_straight_are_rounded() {
    let radius = 0.5;
    for turn in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5] {
        let (sine, cosine) = libm::sincos(turn);
        let points =
            [[0.0, 0.0], [2.0, 0.0], [2.0 + 2.0 * cosine, 2.0 * sine], [4.0, 3.0], [0.0, 3.0]];
        let mut points = points.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
        points.push(points[0]);
        let whole = Region::new(&NurbsCurve::polyline(&points).unwrap(), &[], TOLERANCE).unwrap();
        let rounded = whole.filleted(radius, Some(&[points[1]]), TOLERANCE).unwrap();
        let lost = radius * radius * (libm::tan(0.5 * turn) - 0.5 * turn);
        let found = whole.area() - rounded.area();
        assert!((found - lost).abs() < 1e-12, "{turn}: {found} for {lost}");
        assert_eq!(rounded.arcs().next().unwrap().len(), 6);
    }
}
