//! Laws of regions of many legs and many borders, and of the straight legs between them.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use proptest::{array::uniform8, prop_assert, prop_assert_eq, proptest};
use virote_kernel::{
    CircleForm, CornerStyle, Frame, GeomError, NurbsCurve, PictureError, Region, RegionSide,
    Tolerance,
};

use crate::crossing_turned::fractions;

const TOLERANCE: Tolerance = Tolerance::DEFAULT;

fn at(x: f64, y: f64) -> DVec3 {
    DVec3::new(x, y, 0.0)
}

fn polar(radius: f64, angle: f64) -> DVec3 {
    at(radius * libm::cos(angle), radius * libm::sin(angle))
}

fn circle(x: f64, y: f64, radius: f64) -> NurbsCurve {
    NurbsCurve::ellipse(Frame::XY.at(at(x, y)), [radius; 2], CircleForm::NinePoint).unwrap()
}

/// The closed polygon with a corner at each even angle.
fn polygon(n: usize, radius: impl Fn(usize) -> f64) -> NurbsCurve {
    let corner = |i: usize| polar(radius(i % n), TAU * (i % n) as f64 / n as f64);
    NurbsCurve::polyline(&(0..=n).map(corner).collect::<Vec<_>>()).unwrap()
}

/// Steps of the work that is counted.
fn steps(work: impl FnOnce()) -> u64 {
    let before = virote_kernel::work::counted();
    work();
    virote_kernel::work::counted() - before
}

#[test]
fn a_polygon_of_many_corners_has_its_area() {
    for n in [100_usize, 1500] {
        let angle = TAU / n as f64;
        let regular = Region::new(&polygon(n, |_| 3.0), &[], TOLERANCE).unwrap();
        let area = 4.5 * n as f64 * libm::sin(angle);
        assert!((regular.area() - area).abs() < 1e-11 * area, "{n} corners");
        let star = polygon(n, |i| if i % 2 == 0 { 3.0 } else { 2.0 });
        let star = Region::new(&star, &[], TOLERANCE).unwrap();
        let area = 3.0 * n as f64 * libm::sin(angle);
        assert!((star.area() - area).abs() < 1e-11 * area, "{n} tips");
    }
}

#[test]
fn circles_about_one_centre_take_turns_as_borders() {
    let n = 60;
    let circles: Vec<NurbsCurve> = (1..=n).map(|i| circle(0.0, 0.0, f64::from(i))).collect();
    let rings = Region::even_odd(&circles, TOLERANCE, 1).unwrap();
    assert_eq!(rings.len(), 30);
    // The largest first: between the radii n and n - 1.
    for (k, ring) in (0..).zip(&rings) {
        let outer = f64::from(n - 2 * k);
        let area = PI * (2.0 * outer - 1.0);
        assert!((ring.area() - area).abs() < 1e-10 * area, "ring {k}");
        assert_eq!(ring.n_holes(), 1);
        assert_eq!(ring.side_of(DVec3::X * (outer - 0.5), 1e-9), RegionSide::Inside);
    }
}

#[test]
fn holes_of_a_plate_are_told_from_holes_in_holes() {
    let side = 12_i32;
    let corners = [(0, 0), (side, 0), (side, side), (0, side), (0, 0)];
    let outline = corners.map(|(x, y)| at(f64::from(x), f64::from(y)));
    let plate = NurbsCurve::polyline(&outline).unwrap();
    let place = |i: i32| f64::from(i) + 0.5;
    let mut holes: Vec<NurbsCurve> =
        (0..side * side).map(|i| circle(place(i % side), place(i / side), 0.3)).collect();
    let area = f64::from(side * side) * (1.0 - 0.09 * PI);
    let region = Region::new(&plate, &holes, TOLERANCE).unwrap();
    assert!((region.area() - area).abs() < 1e-11 * area);
    let discs: Vec<Region> = std::iter::once(&plate)
        .chain(&holes)
        .map(|curve| Region::new(curve, &[], TOLERANCE).unwrap())
        .collect();
    let [cut] = &Region::difference(&discs, TOLERANCE, 1).unwrap()[..] else {
        panic!("a plate with holes is one part")
    };
    assert!((cut.area() - area).abs() < 1e-11 * area);
    assert_eq!(cut.n_holes(), holes.len());
    holes.push(circle(place(5), place(7), 0.1));
    let refused = Region::new(&plate, &holes, TOLERANCE);
    let (index, other) = (holes.len(), 7 * 12 + 5 + 1);
    assert_eq!(refused, Err(GeomError::Picture(PictureError::HoleInHole { index, other })));
}

#[test]
fn an_offset_by_less_than_the_tolerance_is_one_up_to_rounding() {
    let disc = Region::new(&circle(0.3, -0.2, 1.0), &[], TOLERANCE).unwrap();
    let square = [at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0), at(0.0, 0.0)];
    let square = Region::new(&NurbsCurve::polyline(&square).unwrap(), &[], TOLERANCE).unwrap();
    for by in [1e-9, 1e-7, 5e-7, 1e-6, 3e-6, 1e-5] {
        let area = |region: &Region, by: f64| {
            let parts = region.offset(by, CornerStyle::Round, TOLERANCE).unwrap();
            parts.iter().map(Region::area).sum::<f64>()
        };
        let (grown, shrunk) = (1.0 + by, 1.0 - by);
        assert!((area(&disc, by) - PI * grown * grown).abs() < 1e-14, "{by}");
        assert!((area(&disc, -by) - PI * shrunk * shrunk).abs() < 1e-14, "{by}");
        assert!((area(&square, by) - (1.0 + 4.0 * by + PI * by * by)).abs() < 1e-14, "{by}");
        let inner = 1.0 - 2.0 * by;
        assert!((area(&square, -by) - inner * inner).abs() < 1e-14, "{by}");
    }
}

/// The area of what discs cover together, by Green's theorem over those parts of each circle that no other disc covers.
fn area_together(discs: &[[f64; 3]]) -> f64 {
    let mut area = 0.0;
    'discs: for (i, &[x, y, radius]) in discs.iter().enumerate() {
        let mut covered = vec![[0.0, 0.0], [TAU, TAU]];
        for &[p, q, other] in discs.iter().enumerate().filter(|&(j, _)| j != i).map(|(_, d)| d) {
            let distance = libm::hypot(p - x, q - y);
            if distance + radius <= other {
                continue 'discs;
            }
            if distance < radius + other && radius < distance + other {
                let cosine = (distance * distance + radius * radius - other * other)
                    / (2.0 * radius * distance);
                let (way, half) = (libm::atan2(q - y, p - x), libm::acos(cosine));
                let from = (way - half).rem_euclid(TAU);
                let to = from + 2.0 * half;
                covered.push([from, to.min(TAU)]);
                covered.push([0.0, (to - TAU).max(0.0)]);
            }
        }
        covered.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut reached = 0.0_f64;
        for [from, to] in covered {
            if reached < from {
                let ((s0, c0), (s1, c1)) = (libm::sincos(reached), libm::sincos(from));
                area += 0.5 * radius * (radius * (from - reached) + x * (s1 - s0) - y * (c1 - c0));
            }
            reached = reached.max(to);
        }
    }
    area
}

#[test]
fn many_discs_cover_what_their_free_arcs_go_around() {
    for n in [30_u64, 120] {
        let discs: Vec<[f64; 3]> = (0..n)
            .map(|i| {
                let [a, b, c, _] = fractions(i);
                [8.0 * a, 8.0 * b, 0.4 + 0.7 * c]
            })
            .collect();
        let regions: Vec<Region> = discs
            .iter()
            .map(|&[x, y, radius]| Region::new(&circle(x, y, radius), &[], TOLERANCE).unwrap())
            .collect();
        let area = area_together(&discs);
        let together = Region::union(&regions, TOLERANCE, 1).unwrap();
        let found: f64 = together.iter().map(Region::area).sum();
        assert!((found - area).abs() < 1e-12 * area, "{n} discs: {found} for {area}");
        let plate = NurbsCurve::polyline(&[
            at(-2.0, -2.0),
            at(10.0, -2.0),
            at(10.0, 10.0),
            at(-2.0, 10.0),
            at(-2.0, -2.0),
        ]);
        let plate = Region::new(&plate.unwrap(), &[], TOLERANCE).unwrap();
        let rest = [&[plate], &regions[..]].concat();
        let rest = Region::difference(&rest, TOLERANCE, 1).unwrap();
        let found: f64 = rest.iter().map(Region::area).sum();
        assert!((found - (144.0 - area)).abs() < 1e-12 * area, "the rest of {n} discs: {found}");
    }
}

#[test]
fn the_work_of_many_corners_grows_with_their_number() {
    let work = |n: usize| {
        let outline = polygon(n, |_| 1.0);
        steps(|| drop(Region::new(&outline, &[], TOLERANCE).unwrap()))
    };
    let [few, many] = [200, 800].map(work);
    assert!(many < 5 * few, "{few} steps, of four times as many corners {many}");
}

#[test]
fn legs_at_any_small_angle_meet_in_their_joint() {
    for exponent in 1..=4 {
        let slope = libm::pow(10.0, -f64::from(exponent));
        let first = NurbsCurve::line(at(-1.0, 0.3), at(0.2, 0.3)).unwrap();
        let second = NurbsCurve::line(at(0.2, 0.3), at(2.0, 0.3 + slope)).unwrap();
        let [meeting] = first.intersections(&second, 1e-6).unwrap()[..] else {
            panic!("neighbours of slope {slope} meet once")
        };
        let joint = [meeting.first, meeting.second].map(f64::to_bits);
        assert_eq!(joint, [1.0, 0.0].map(f64::to_bits), "{meeting:?}");
    }
}

#[test]
fn sides_that_go_on_in_round_corners_meet_them_in_their_ends() {
    // A slot: two straight sides and two half circles, in whatever sense each runs.
    let turned = Frame::from_axes(at(2.0, 0.0), -DVec3::Y, DVec3::X).unwrap();
    let round = NurbsCurve::arc(turned, 1.0, 0.0, PI).unwrap();
    let side = NurbsCurve::line(at(-2.0, -1.0), at(2.0, -1.0)).unwrap();
    let ways = |curve: &NurbsCurve| [curve.clone(), curve.reversed()];
    for (i, round) in ways(&round).into_iter().enumerate() {
        for (j, side) in ways(&side).into_iter().enumerate() {
            let [meeting] = side.intersections(&round, 1e-6).unwrap()[..] else {
                panic!("one meeting of {i} and {j}")
            };
            let ends = [side.domain(), round.domain()];
            let first = if j == 0 { ends[0].end() } else { ends[0].start() };
            let second = if i == 0 { ends[1].start() } else { ends[1].end() };
            let bits = |ends: [f64; 2]| ends.map(f64::to_bits);
            assert_eq!(bits([meeting.first, meeting.second]), bits([first, second]));
        }
    }
}

proptest! {
    /// Legs that are halves of polylines go through the search; both ways tell the same places.
    #[test]
    fn two_legs_meet_where_the_search_says(numbers in uniform8(-1.0..1.0)) {
        let numbers: [f64; 8] = numbers;
        let [a, b, c, d] = [0, 2, 4, 6].map(|i| at(numbers[i], numbers[i + 1]));
        let legs = [[a, b], [c, d]].map(|[start, end]| NurbsCurve::line(start, end).unwrap());
        let halves = [[a, b], [c, d]].map(|[start, end]| {
            NurbsCurve::polyline(&[start, start.lerp(end, 0.37), end]).unwrap()
        });
        let told = legs[0].intersections(&legs[1], 1e-9).unwrap();
        let searched = halves[0].intersections(&halves[1], 1e-9).unwrap();
        prop_assert_eq!(told.len(), searched.len());
        for (told, searched) in told.iter().zip(&searched) {
            prop_assert!(told.point.distance(searched.point) < 1e-9);
        }
        // Ends on either side of the other's line, or not.
        let side = |from: DVec3, to: DVec3, p: DVec3| {
            (to - from).truncate().perp_dot((p - from).truncate())
        };
        let parts = |from, to, p, q| side(from, to, p) * side(from, to, q) < 0.0;
        let crosses = parts(a, b, c, d) && parts(c, d, a, b);
        prop_assert!(!crosses || told.len() == 1);
    }
}
