//! What lies far from the origin, as sites do in the coordinates of a survey: the same as beside it, within what
//! the last bit of a coordinate leaves.

use std::f64::consts::PI;

use virote_kernel::{
    CircleForm, CornerStyle, Frame, NurbsCurve, Region, RegionSide, Solid, Tolerance,
    glam::{DAffine3, DVec3},
};

use crate::solid::{TOLERANCE, ball, polygon, region};

/// Places that plans and surveys begin at; the first two are so near that nothing is moved.
const PLACES: [DVec3; 5] = [
    DVec3::new(0.0, 0.0, 0.0),
    DVec3::new(40.0, -30.0, 10.0),
    DVec3::new(400.0, 4320.0, 0.0),
    DVec3::new(5e5, 1.5e6, 0.0),
    DVec3::new(5e5, 5.4e6, 300.0),
];

fn moved(region: &Region, place: DVec3) -> Region {
    region.transformed(&DAffine3::from_translation(place)).expect("a region elsewhere")
}

fn ellipse(radii: [f64; 2]) -> Region {
    region(&NurbsCurve::ellipse(Frame::XY, radii, CircleForm::NinePoint).expect("an ellipse"), &[])
}

fn area(parts: &[Region]) -> f64 {
    parts.iter().map(Region::area).sum()
}

#[track_caller]
fn check(found: f64, expected: f64, place: DVec3) {
    // The border is nowhere known better than to the last bit of its coordinates.
    let near = 1e-8 + 16.0 * f64::EPSILON * place.length();
    assert!((found - expected).abs() <= near * expected, "{found} for {expected} at {place}");
}

#[test]
fn regions_are_combined_and_offset_as_at_the_origin() {
    let discs: Vec<Region> =
        (0..12).map(|i| moved(&ellipse([0.7, 0.5]), DVec3::X * f64::from(i))).collect();
    let union = |all: &[Region]| Region::union(all, TOLERANCE, 1).expect("a union");
    let offset = |region: &Region, distance| {
        region.offset(distance, CornerStyle::Round, TOLERANCE).expect("an offset")
    };
    let body = ellipse([3.0, 1.0]);
    let [grown, shrunk] = [0.5, -0.25].map(|distance| area(&offset(&body, distance)));
    let chain = area(&union(&discs));
    for place in PLACES {
        let there = moved(&body, place);
        check(area(&offset(&there, 0.5)), grown, place);
        check(area(&offset(&there, -0.25)), shrunk, place);
        check(there.area(), 3.0 * PI, place);
        let discs: Vec<Region> = discs.iter().map(|disc| moved(disc, place)).collect();
        let parts = union(&discs);
        assert_eq!(parts.len(), 1, "at {place}");
        check(area(&parts), chain, place);
        assert_eq!(there.side_of(place + DVec3::X * 2.99, 1e-6), RegionSide::Inside);
        assert_eq!(there.side_of(place + DVec3::X * 3.0, 1e-6), RegionSide::Border);
        assert!((there.mass().centroid - place).length() < 1e-8, "at {place}");
    }
}

/// Regions whose planes have origins of their own are in one plane all the same, near or far.
#[test]
fn regions_near_and_far_are_in_one_plane() {
    let (near, far) = (ellipse([2.0, 1.0]), moved(&ellipse([2.0, 1.0]), DVec3::X * 5e5));
    let parts = Region::union(&[near.clone(), far.clone()], TOLERANCE, 1).expect("a union");
    assert_eq!(parts.len(), 2);
    check(area(&parts), 4.0 * PI, DVec3::X * 5e5);
    let beside = moved(&far, DVec3::X);
    let common = Region::intersection(&[far.clone(), beside], TOLERANCE, 1).expect("a lens");
    let here = Region::intersection(&[near.clone(), moved(&near, DVec3::X)], TOLERANCE, 1);
    check(area(&common), area(&here.expect("a lens")), DVec3::X * 5e5);
    assert_eq!(Region::difference(&[far.clone(), near], TOLERANCE, 1).expect("all").len(), 1);
    // There and back again nothing is lost.
    let back = moved(&far, DVec3::X * -5e5);
    assert_eq!(back.bounds(), ellipse([2.0, 1.0]).bounds());
}

#[test]
fn planes_cut_solids_as_at_the_origin() {
    let corners = [[0.0; 3], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0], [0.0, 4.0, 0.0]];
    for place in PLACES {
        let plate = moved(&region(&polygon(&corners), &[]), place);
        let plate = Solid::extruded(&plate, DVec3::Z, TOLERANCE).expect("a plate");
        let level = Frame::XY.at(place + DVec3::Z * 0.25);
        let normal = DVec3::new(1.0, 2.0, 0.5);
        let askew = Frame::from_normal(place + DVec3::new(2.0, 2.0, 0.5), normal, None);
        for (plane, share) in [(level, 0.25), (askew.expect("a plane"), 0.5)] {
            let below = plate.cut(plane, false, TOLERANCE).expect("a side").expect("some of it");
            check(below.volume_mass().expect("a volume").amount, 16.0 * share, place);
        }
        let ball = Solid::new(&[ball(place, 2.0)], TOLERANCE).expect("a ball");
        let half = ball.cut(Frame::XY.at(place), true, TOLERANCE).expect("a side").expect("a dome");
        check(half.volume_mass().expect("a volume").amount, 16.0 / 3.0 * PI, place);
    }
}

#[test]
fn offsets_keep_their_tolerance_in_the_coordinates_of_a_survey() {
    let corners = [[0.0, 0.0], [100.0, 200.0], [300.0, 250.0], [600.0, 100.0]];
    for place in [PLACES[0], PLACES[3], PLACES[4], DVec3::new(1e7, -1e7, 0.0)] {
        let points: Vec<DVec3> =
            corners.iter().map(|&[x, y]| place + DVec3::new(x, y, 0.0)).collect();
        let curve = NurbsCurve::bezier(&points).expect("a curve");
        let tolerance = Tolerance::DEFAULT.with_distance(1e-6);
        let offset = curve.offset(20.0, DVec3::Z, tolerance).expect("an offset");
        let rounding = 128.0 * f64::EPSILON * place.length();
        for k in 0..=400 {
            let t = f64::from(k) / 400.0;
            let miss = (offset.curve.point_at(t).distance(curve.point_at(t)) - 20.0).abs();
            assert!(miss <= offset.deviation + rounding, "{miss} at {t} from {place}");
        }
        assert!(offset.deviation <= 1e-6 + rounding);
    }
}
