//! Laws of plane regions: areas in closed form, the algebra of sets, and the definition of an offset.

use std::f64::consts::{PI, TAU};

use glam::{DAffine3, DQuat, DVec3};
use proptest::{collection::vec, prop_assert, prop_assert_eq, proptest};
use virote_kernel::{
    CircleForm, CornerStyle, Frame, GeomError, KnotVector, NurbsCurve, PictureError, Region,
    RegionError, RegionSide, Tolerance,
};

const TOLERANCE: Tolerance = Tolerance::DEFAULT;

fn at(x: f64, y: f64) -> DVec3 {
    DVec3::new(x, y, 0.0)
}

fn polygon(corners: &[(f64, f64)]) -> NurbsCurve {
    let mut points: Vec<DVec3> = corners.iter().map(|&(x, y)| at(x, y)).collect();
    points.push(points[0]);
    NurbsCurve::polyline(&points).unwrap()
}

fn region(outer: &NurbsCurve) -> Region {
    Region::new(outer, &[], TOLERANCE).unwrap()
}

fn square(x: f64, y: f64, side: f64) -> Region {
    region(&polygon(&[(x, y), (x + side, y), (x + side, y + side), (x, y + side)]))
}

fn circle(x: f64, y: f64, radius: f64) -> NurbsCurve {
    NurbsCurve::ellipse(Frame::XY.at(at(x, y)), [radius; 2], CircleForm::NinePoint).unwrap()
}

fn disc(x: f64, y: f64, radius: f64) -> Region {
    region(&circle(x, y, radius))
}

/// A blob: a closed cubic through places on rays.
fn blob(x: f64, y: f64, radii: &[f64]) -> Region {
    let n = radii.len();
    let place = |i: usize| {
        let (angle, radius) = (TAU * i as f64 / n as f64, radii[i % n]);
        at(x + radius * libm::cos(angle), y + radius * libm::sin(angle))
    };
    let points: Vec<DVec3> = (0..n + 3).map(place).collect();
    let knots = KnotVector::uniform(3, points.len()).unwrap();
    region(&NurbsCurve::polynomial(knots, &points).unwrap())
}

fn union(all: &[Region]) -> Vec<Region> {
    Region::union(all, TOLERANCE, 2).unwrap()
}

fn intersection(all: &[Region]) -> Vec<Region> {
    Region::intersection(all, TOLERANCE, 2).unwrap()
}

fn difference(all: &[Region]) -> Vec<Region> {
    Region::difference(all, TOLERANCE, 2).unwrap()
}

fn area(parts: &[Region]) -> f64 {
    parts.iter().map(Region::area).sum()
}

#[track_caller]
fn check(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-9 * expected.abs().max(1.0), "{found}, not {expected}");
}

/// The area that two discs of radius 1 at a distance have in common.
fn lens(distance: f64) -> f64 {
    2.0 * libm::acos(distance / 2.0) - distance / 2.0 * (4.0 - distance * distance).sqrt()
}

#[test]
fn areas_of_discs_that_overlap_are_those_of_the_lens() {
    for distance in [1e-3, 0.1, 1.0, 1.9, 1.999] {
        let both = [disc(0.0, 0.0, 1.0), disc(distance, 0.0, 1.0)];
        check(area(&intersection(&both)), lens(distance));
        check(area(&union(&both)), TAU - lens(distance));
        check(area(&difference(&both)), PI - lens(distance));
        assert_eq!(union(&both).len(), 1);
    }
}

#[test]
fn what_is_the_same_is_one() {
    let (a, b) = (disc(0.0, 0.0, 1.0), disc(0.0, 0.0, 1.0));
    // Another seam and another form of the same circle.
    let turned = NurbsCurve::ellipse(Frame::XY, [1.0, 1.0], CircleForm::NinePoint).unwrap();
    let turned = turned.transformed(&DAffine3::from_rotation_z(0.7));
    for other in [b, region(&turned)] {
        let both = [a.clone(), other];
        check(area(&union(&both)), PI);
        check(area(&intersection(&both)), PI);
        assert!(difference(&both).is_empty());
    }
}

#[test]
fn squares_that_share_a_side_or_a_corner() {
    let beside = [square(0.0, 0.0, 1.0), square(1.0, 0.25, 1.0)];
    let found = union(&beside);
    assert_eq!((found.len(), found[0].n_holes()), (1, 0));
    check(area(&found), 2.0);
    assert!(intersection(&beside).is_empty());
    check(area(&difference(&beside)), 1.0);

    let at_corner = [square(0.0, 0.0, 1.0), square(1.0, 1.0, 1.0)];
    assert_eq!(union(&at_corner).len(), 2);
    assert!(intersection(&at_corner).is_empty());

    let inside = [square(0.0, 0.0, 2.0), square(0.0, 0.0, 1.0)];
    check(area(&difference(&inside)), 3.0);
    check(area(&union(&inside)), 4.0);
    // A frame around a hole, put together of four bars that share parts of their sides.
    let bars =
        [(0.0, 0.0, 3.0, 1.0), (0.0, 2.0, 3.0, 1.0), (0.0, 1.0, 1.0, 1.0), (2.0, 1.0, 1.0, 1.0)];
    let bars = bars
        .map(|(x, y, w, h)| region(&polygon(&[(x, y), (x + w, y), (x + w, y + h), (x, y + h)])));
    let found = union(&bars);
    assert_eq!((found.len(), found[0].n_holes()), (1, 1));
    check(area(&found), 8.0);
}

#[test]
fn circles_that_touch() {
    let outside = [disc(0.0, 0.0, 1.0), disc(2.0, 0.0, 1.0)];
    assert_eq!(union(&outside).len(), 2);
    assert!(intersection(&outside).is_empty());
    let inside = [disc(0.0, 0.0, 2.0), disc(1.0, 0.0, 1.0)];
    let found = difference(&inside);
    check(area(&found), 3.0 * PI);
    assert_eq!(found.len(), 1);
    check(area(&union(&inside)), 4.0 * PI);
    check(area(&intersection(&inside)), PI);
}

#[test]
fn many_holes_in_a_plate() {
    let mut all = vec![square(0.0, 0.0, 11.0)];
    for i in 1..=10 {
        all.extend((1..=10).map(|j| disc(f64::from(i), f64::from(j), 0.3)));
    }
    let found = difference(&all);
    assert_eq!((found.len(), found[0].n_holes()), (1, 100));
    check(area(&found), 121.0 - 100.0 * PI * 0.09);
}

#[test]
fn borders_that_are_none_are_refused_by_their_number() {
    let new = |outer: &NurbsCurve, holes: &[NurbsCurve]| Region::new(outer, holes, TOLERANCE);
    let eight = polygon(&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)]);
    let Err(GeomError::Picture(PictureError::Crossing { index: 0, other: 0, point, .. })) =
        new(&eight, &[])
    else {
        panic!("it crosses itself")
    };
    assert!(point.distance(at(1.0, 1.0)) < 1e-6);
    let outer = circle(0.0, 0.0, 2.0);
    let found = new(&outer, &[circle(2.0, 0.0, 1.0)]);
    assert!(matches!(
        found,
        Err(GeomError::Picture(PictureError::Crossing { index: 0, other: 1, .. }))
    ));
    let found = new(&outer, &[circle(5.0, 0.0, 1.0)]);
    assert!(matches!(found, Err(GeomError::Picture(PictureError::Outside { index: 1 }))));
    let found = new(&outer, &[circle(0.0, 0.0, 1.0), circle(0.0, 0.0, 0.5)]);
    assert!(matches!(
        found,
        Err(GeomError::Picture(PictureError::HoleInHole { index: 2, other: 1 }))
    ));
    let open = NurbsCurve::line(at(0.0, 0.0), at(1.0, 0.0)).unwrap();
    assert!(new(&open, &[]).is_err());
    let there_and_back = polygon(&[(0.0, 0.0), (1.0, 0.0)]);
    assert!(matches!(
        new(&there_and_back, &[]),
        Err(GeomError::Picture(PictureError::NoArea { .. }))
    ));
}

#[test]
fn borders_that_share_a_slanted_line_have_corners_on_it() {
    let with_corner = [(2.7, 2.1), (3.6, 2.8), (6.3, 4.9), (-0.1, 5.7)];
    let beside = region(&polygon(&[(0.0, 0.0), (9.0, 7.0), (7.8, -2.6)]));
    check(area(&union(&[region(&polygon(&with_corner)), beside])), 49.4);
}

#[test]
fn a_star_is_hollow_by_the_even_odd_rule() {
    let corner = |i: usize| {
        let angle = TAU * (2 * i) as f64 / 5.0;
        (libm::sin(angle), libm::cos(angle))
    };
    let star = polygon(&[0, 1, 2, 3, 4].map(corner));
    let found = Region::even_odd(&[star], TOLERANCE, 1).unwrap();
    assert_eq!(found.len(), 5);
    // Each point is a triangle between its corner and two of the inner pentagon.
    let r = libm::cos(TAU / 5.0) / libm::cos(TAU / 10.0);
    let expected = 5.0 * (r * libm::sin(PI / 5.0) * (1.0 - r * libm::cos(PI / 5.0)));
    check(area(&found), expected);
    let rings = Region::even_odd(
        &[circle(0.0, 0.0, 1.0), circle(0.0, 0.0, 3.0), circle(0.0, 0.0, 2.0)],
        TOLERANCE,
        1,
    );
    let rings = rings.unwrap();
    assert_eq!(rings.iter().map(Region::n_holes).collect::<Vec<_>>(), [1, 0]);
    check(area(&rings), PI * (9.0 - 4.0 + 1.0));
}

#[test]
fn offsets_of_a_square_have_the_areas_of_their_corners() {
    let side = 4.0;
    let plate = square(0.0, 0.0, side);
    let d = 0.5;
    let grown = |corners| area(&plate.offset(d, corners, TOLERANCE).unwrap());
    let sides = side * side + 4.0 * side * d;
    check(grown(CornerStyle::Round), sides + PI * d * d);
    check(grown(CornerStyle::Miter), sides + 4.0 * d * d);
    check(grown(CornerStyle::Bevel), sides + 2.0 * d * d);
    for corners in [CornerStyle::Round, CornerStyle::Miter, CornerStyle::Bevel] {
        check(area(&plate.offset(-d, corners, TOLERANCE).unwrap()), 9.0);
        assert!(plate.offset(-2.5, corners, TOLERANCE).unwrap().is_empty());
    }
}

/// Whether a point lies inside of a polygon, by the crossings of a ray.
fn is_inside(corners: &[(f64, f64)], (x, y): (f64, f64)) -> bool {
    let sides = corners.iter().zip(corners.iter().cycle().skip(1));
    let crosses = |&(&(x0, y0), &(x1, y1)): &(&(f64, f64), &(f64, f64))| {
        (y < y0) != (y < y1) && x < x0 + (y - y0) * (x1 - x0) / (y1 - y0)
    };
    sides.filter(crosses).count() % 2 == 1
}

/// What an offset of a polygon covers beside it: strips along its sides and wedges at the corners that are torn
/// open, a corner beyond ten times the distance cut off across.
fn strips_and_wedges(corners: &[(f64, f64)], d: f64, style: CornerStyle) -> Vec<Vec<(f64, f64)>> {
    let n = corners.len();
    let along = |i: usize| {
        let ((x0, y0), (x1, y1)) = (corners[i % n], corners[(i + 1) % n]);
        let length = libm::hypot(x1 - x0, y1 - y0);
        ((x1 - x0) / length, (y1 - y0) / length)
    };
    let mut covered = Vec::new();
    for i in 0..n {
        let (a, b) = (along(i), along(i + 1));
        let (start, corner) = (corners[i], corners[(i + 1) % n]);
        let beside = |(x, y): (f64, f64), (ax, ay): (f64, f64)| (x + ay * d, y - ax * d);
        covered.push(vec![start, corner, beside(corner, a), beside(start, a)]);
        if (a.0 * b.1 - a.1 * b.0) * d < 0.0 {
            continue;
        }
        let (from, to) = (beside(corner, a), beside(corner, b));
        let half = 0.5 * libm::acos((a.0 * b.0 + a.1 * b.1).clamp(-1.0, 1.0));
        let on = d.abs() * libm::tan(half).min((10.0 - libm::cos(half)) / libm::sin(half));
        covered.push(match style {
            CornerStyle::Miter => {
                let tips =
                    [(from.0 + a.0 * on, from.1 + a.1 * on), (to.0 - b.0 * on, to.1 - b.1 * on)];
                vec![corner, from, tips[0], tips[1], to]
            }
            _ => vec![corner, from, to],
        });
    }
    covered
}

#[test]
fn offsets_of_polygons_are_made_of_strips_and_wedges() {
    let mut state = 1_u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut stars: Vec<Vec<(f64, f64)>> = vec![
        vec![(0.0, -0.9), (1.7, -0.9), (1.0, -0.5), (1.2, -0.2)],
        vec![(1.6, 0.2), (0.7, 0.1), (1.2, 1.0), (-1.5, -1.2)],
        vec![(0.0, 0.0), (20.0, -0.5), (20.0, 0.5)],
        vec![(0.0, -0.9), (1.1, -0.6), (1.7, -0.9), (1.0, -0.5), (1.7, -0.5), (1.2, -0.2)],
        vec![(0.0, -0.9), (1.5, -1.2), (1.1, -0.6), (1.7, -0.9), (1.2, -0.2)],
        vec![(-0.04, -0.93), (1.68, -0.9), (0.97, -0.49), (1.7, -0.53), (1.2, -0.21)],
        // With corners that go on straight.
        vec![(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0), (0.0, 1.5)],
        vec![(1.0, 0.0), (1.3, 0.0), (2.0, 0.0), (0.0, 2.0), (-0.5, 2.0)],
        vec![(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)],
    ];
    for _ in 0..40 {
        let n = 5 + (random() * 8.0) as usize;
        let star = (0..n).map(|i| {
            let (angle, radius) =
                (TAU * (i as f64 + 0.8 * random()) / n as f64, 0.3 + 1.7 * random());
            (radius * libm::cos(angle), radius * libm::sin(angle))
        });
        stars.push(star.collect());
    }
    for star in &stars {
        for d in [0.1, 0.5, 3.0, -0.1, -0.3] {
            for style in [CornerStyle::Miter, CornerStyle::Bevel] {
                let parts = region(&polygon(star)).offset(d, style, TOLERANCE);
                let parts =
                    parts.unwrap_or_else(|error| panic!("{star:?} by {d}, {style:?}: {error}"));
                let covered = strips_and_wedges(star, d, style);
                for _ in 0..60 {
                    let place = (4.0 - 8.0 * random(), 4.0 - 8.0 * random());
                    let is_beside = covered.iter().any(|part| is_inside(part, place));
                    let is_in = match 0.0 < d {
                        true => is_inside(star, place) || is_beside,
                        false => is_inside(star, place) && !is_beside,
                    };
                    let point = DVec3::new(place.0, place.1, 0.0);
                    let sides = parts.iter().map(|part| part.side_of(point, 1e-6));
                    let found = sides.fold(RegionSide::Outside, |found, side| match side {
                        RegionSide::Outside => found,
                        side => side,
                    });
                    assert!(
                        found == RegionSide::Border || (found == RegionSide::Inside) == is_in,
                        "{star:?} by {d}, {style:?}: {place:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn offsets_fall_apart_close_and_vanish() {
    // A dumbbell of two squares and a narrow bar.
    let dumbbell = union(&[
        square(0.0, 0.0, 4.0),
        square(8.0, 0.0, 4.0),
        region(&polygon(&[(3.0, 1.5), (9.0, 1.5), (9.0, 2.5), (3.0, 2.5)])),
    ]);
    let [dumbbell] = &dumbbell[..] else { panic!("one part") };
    let parts = dumbbell.offset(-0.6, CornerStyle::Round, TOLERANCE).unwrap();
    assert_eq!(parts.len(), 2);
    // A letter C closes to a ring.
    let c = [
        (0.0, 0.0),
        (4.0, 0.0),
        (4.0, 1.9),
        (3.0, 1.9),
        (3.0, 1.0),
        (1.0, 1.0),
        (1.0, 3.0),
        (3.0, 3.0),
        (3.0, 2.1),
        (4.0, 2.1),
        (4.0, 4.0),
        (0.0, 4.0),
    ];
    let parts = region(&polygon(&c)).offset(0.2, CornerStyle::Round, TOLERANCE).unwrap();
    assert_eq!(parts.iter().map(Region::n_holes).collect::<Vec<_>>(), [1]);
    // A disc shrinks to nothing, a hole closes.
    assert!(disc(0.0, 0.0, 1.0).offset(-1.0, CornerStyle::Round, TOLERANCE).unwrap().is_empty());
    assert!(disc(0.0, 0.0, 1.0).offset(-1.5, CornerStyle::Round, TOLERANCE).unwrap().is_empty());
    let ring = Region::new(&circle(0.0, 0.0, 3.0), &[circle(0.5, 0.0, 1.0)], TOLERANCE).unwrap();
    let grown = ring.offset(1.2, CornerStyle::Round, TOLERANCE).unwrap();
    assert_eq!(grown[0].n_holes(), 0);
    check(area(&grown), PI * 4.2 * 4.2);
}

#[test]
fn an_ellipse_shrinks_beyond_its_evolute() {
    let ellipse = NurbsCurve::ellipse(Frame::XY, [3.0, 1.0], CircleForm::NinePoint).unwrap();
    let ellipse = region(&ellipse);
    for d in [-0.2, -0.3, -0.5, -0.8, -0.95] {
        let parts = ellipse.offset(d, CornerStyle::Round, TOLERANCE).unwrap();
        let [part] = &parts[..] else { panic!("one part at {d}") };
        let outer = part.outer().unwrap();
        for point in outer.sample(200) {
            let near = ellipse.outer().unwrap().closest(point, 1e-9).distance;
            assert!((near + d).abs() < 1e-5, "{near} at {d}");
        }
    }
}

#[test]
fn fillets_take_corners_and_fill_them() {
    let side = 4.0;
    let r = 0.5;
    let rounded = square(0.0, 0.0, side).filleted(r, None, TOLERANCE).unwrap();
    check(rounded.area(), side * side - (4.0 - PI) * r * r);
    let l =
        region(&polygon(&[(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (1.0, 1.0), (1.0, 4.0), (0.0, 4.0)]));
    let inner = l.filleted(r, Some(&[at(1.0, 1.0)]), TOLERANCE).unwrap();
    check(inner.area(), 7.0 + (1.0 - PI / 4.0) * r * r);
    let found = l.filleted(r, Some(&[at(1.5, 1.0)]), TOLERANCE);
    assert!(matches!(found, Err(GeomError::Region(RegionError::NoCorner { .. }))));
    let found = l.filleted(0.75, None, TOLERANCE);
    assert!(matches!(found, Err(GeomError::Region(RegionError::NoRoom { .. }))));
    let Err(GeomError::Region(RegionError::NoRoom { most: Some(most), .. })) =
        square(0.0, 0.0, 4.0).filleted(5.0, Some(&[at(0.0, 0.0)]), TOLERANCE)
    else {
        panic!("there is no room")
    };
    assert!((most - 4.0).abs() < 1e-3, "{most}");
}

#[test]
fn a_place_is_inside_outside_or_on_the_border() {
    let ring = Region::new(&circle(0.0, 0.0, 2.0), &[circle(0.0, 0.0, 1.0)], TOLERANCE).unwrap();
    let side = |x: f64, y: f64, z: f64| ring.side_of(DVec3::new(x, y, z), 1e-6);
    assert_eq!(side(1.5, 0.0, 0.0), RegionSide::Inside);
    assert_eq!(side(0.0, -1.5, 0.0), RegionSide::Inside);
    assert_eq!(side(0.0, 0.0, 0.0), RegionSide::Outside);
    assert_eq!(side(2.5, 0.0, 0.0), RegionSide::Outside);
    assert_eq!(side(2.0, 1e-8, 0.0), RegionSide::Border);
    assert_eq!(side(0.0, 1.0, 0.0), RegionSide::Border);
    assert_eq!(side(1.5, 0.0, 0.1), RegionSide::Outside);
}

#[test]
fn mass_is_that_of_the_textbook() {
    let half = region(&polygon(&[(0.0, 0.0), (3.0, 0.0), (0.0, 6.0)]));
    let mass = half.mass();
    check(mass.amount, 9.0);
    assert!(mass.centroid.distance(at(1.0, 2.0)) < 1e-12);
    // About the centroid of a triangle: b·h³/36.
    check(mass.inertia.x_axis.x, 3.0 * 216.0 / 36.0);
    let circle = disc(5.0, -3.0, 2.0).mass();
    check(circle.inertia.x_axis.x, PI * 16.0 / 4.0);
    check(circle.inertia.z_axis.z, PI * 16.0 / 2.0);
}

/// What a small hole far from the middle takes away is that by the theorem of Steiner.
#[test]
fn mass_is_that_without_small_holes_at_the_border() {
    let holes = [circle(19.0, 14.0, 0.1), circle(-19.5, 3.0, 0.05)];
    let corners = [(-20.0, -15.0), (20.0, -15.0), (20.0, 15.0), (-20.0, 15.0)];
    let mass = Region::new(&polygon(&corners), &holes, TOLERANCE).unwrap().mass();
    let [a, b] = [PI * 0.01, PI * 0.0025];
    let area = 1200.0 - a - b;
    let center = -(at(19.0, 14.0) * a + at(-19.5, 3.0) * b) / area;
    check(mass.amount, area);
    assert!(mass.centroid.distance(center) < 1e-14);
    let own = 0.5 * (a * 0.01 + b * 0.0025);
    let moved = a * (19.0 * 19.0 + 14.0 * 14.0) + b * (19.5 * 19.5 + 9.0);
    let polar = 1200.0 * (1600.0 + 900.0) / 12.0 - own - moved - area * center.length_squared();
    assert!((mass.inertia.z_axis.z / polar - 1.0).abs() < 1e-14);
    let mixed = -(a * 19.0 * 14.0 - b * 19.5 * 3.0) - area * center.x * center.y;
    assert!((mass.inertia.x_axis.y + mixed).abs() < 1e-9, "{}", mass.inertia.x_axis.y);
}

proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig::with_cases(64))]

    #[test]
    fn sets_keep_their_algebra(
        a in vec(0.4..1.6_f64, 7),
        b in vec(0.4..1.6_f64, 5),
        x in -1.5..1.5_f64,
        y in -1.5..1.5_f64,
    ) {
        let both = [blob(0.0, 0.0, &a), blob(x, y, &b)];
        let swapped = [both[1].clone(), both[0].clone()];
        let (joint, common) = (area(&union(&both)), area(&intersection(&both)));
        let near = |p: f64, q: f64| (p - q).abs() <= 1e-9 * (1.0 + p.abs());
        prop_assert!(near(joint + common, both[0].area() + both[1].area()));
        prop_assert!(near(area(&difference(&both)) + common, both[0].area()));
        prop_assert!(near(area(&union(&swapped)), joint));
        prop_assert!(near(area(&intersection(&swapped)), common));
        // What is taken away and put back.
        let mut parts = difference(&both);
        parts.extend(intersection(&both));
        prop_assert!(near(area(&union(&parts)), both[0].area()));
        prop_assert!(difference(&[both[0].clone(), both[0].clone()]).is_empty());
    }

    #[test]
    fn placing_makes_no_difference(
        angle in 0.0..TAU,
        tilt in 0.0..1.5_f64,
        x in -50.0..50.0_f64,
        scale in -3..4_i32,
    ) {
        let scale = libm::exp10(f64::from(scale));
        let map = DAffine3::from_scale_rotation_translation(
            DVec3::splat(scale),
            DQuat::from_rotation_z(angle) * DQuat::from_rotation_x(tilt),
            DVec3::new(x, -x, x) * scale,
        );
        let plain = [square(0.0, 0.0, 2.0), square(1.0, 0.0, 1.0), disc(2.0, 1.0, 0.75)];
        let moved: Vec<Region> = plain.iter().map(|region| region.transformed(&map).unwrap()).collect();
        let tolerance = TOLERANCE.with_distance(1e-6 * scale.max(1.0));
        let found = Region::union(&moved, tolerance, 1).unwrap();
        let expected = area(&union(&plain)) * scale * scale;
        prop_assert_eq!(found.len(), 1);
        prop_assert!((area(&found) / expected - 1.0).abs() < 1e-9);
        let found = Region::difference(&moved, tolerance, 1).unwrap();
        let expected = area(&difference(&plain)) * scale * scale;
        prop_assert!((area(&found) / expected - 1.0).abs() < 1e-9);
    }

    #[test]
    fn threads_make_no_difference(places in vec((0.0..4.0_f64, 0.0..4.0_f64, 0.2..0.8_f64), 12)) {
        let discs: Vec<Region> = places.iter().map(|&(x, y, r)| disc(x, y, r)).collect();
        let alone = Region::union(&discs, TOLERANCE, 1).unwrap();
        prop_assert_eq!(alone, Region::union(&discs, TOLERANCE, 4).unwrap());
    }

    /// Sides that lie along one another, corners on sides and in corners: the areas by counting squares.
    #[test]
    fn rectangles_on_a_grid_have_as_many_squares_as_are_counted(
        all in vec((0..6_i32, 0..6_i32, 1..4_i32, 1..4_i32), 2..8),
    ) {
        let within = |&(x, y, w, h): &(i32, i32, i32, i32), i, j| {
            x <= i && i < x + w && y <= j && j < y + h
        };
        let count = |is_counted: &dyn Fn(i32, i32) -> bool| {
            let squares = (0..9).flat_map(|i| (0..9).map(move |j| (i, j)));
            squares.filter(|&(i, j)| is_counted(i, j)).count() as f64
        };
        let rectangle = |&(x, y, w, h): &(i32, i32, i32, i32)| {
            let [a, b, c, d] = [x, y, x + w, y + h].map(f64::from);
            region(&polygon(&[(a, b), (c, b), (c, d), (a, d)]))
        };
        let regions: Vec<Region> = all.iter().map(rectangle).collect();
        let near = |found: f64, counted: f64| (found - counted).abs() <= 1e-9;
        let any = count(&|i, j| all.iter().any(|one| within(one, i, j)));
        let every = count(&|i, j| all.iter().all(|one| within(one, i, j)));
        let first = count(&|i, j| {
            within(&all[0], i, j) && !all[1..].iter().any(|one| within(one, i, j))
        });
        prop_assert!(near(area(&union(&regions)), any));
        prop_assert!(near(area(&intersection(&regions)), every));
        prop_assert!(near(area(&difference(&regions)), first));
    }
}

/// The ray by which the inside of an edge is told begins on it, and may pass its own ends or begin beside its own
/// box by rounding: a ring of one edge, and edges along the box.
#[test]
fn rings_that_rounding_takes_out_of_their_box_have_an_inside() {
    for i in 0..400 {
        let shift = at(0.1 * f64::from(i), 0.37 * f64::from(i % 7));
        let skew = [(0.0, 0.0), (0.37, 0.0), (0.67, 1.0), (0.3, 1.0)];
        let corners = skew.map(|(x, y)| shift + at(x, y)).to_vec();
        let border = NurbsCurve::polyline(&[corners.clone(), vec![corners[0]]].concat()).unwrap();
        let border = border.elevate_degree(7).unwrap();
        for border in [border.reversed(), border] {
            let found = Region::even_odd(&[border], TOLERANCE, 1).unwrap();
            assert!((found[0].area() - 0.37).abs() < 1e-9, "{i}: {}", found[0].area());
        }
        let ring = circle(shift.x, shift.y, 0.6241).elevate_degree(7).unwrap();
        let found = Region::even_odd(&[ring], TOLERANCE, 1).unwrap();
        assert!((found[0].area() - PI * 0.6241 * 0.6241).abs() < 1e-9, "{i}: {}", found[0].area());
    }
}
