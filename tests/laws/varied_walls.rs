//! Solids between walls that vary: slopes of what they hold against central differences of the solids themselves.

use std::sync::Arc;

use glam::{DMat3, DVec3, DVec4};
use proptest::{
    collection::vec,
    prelude::{ProptestConfig, Strategy, prop_assert, proptest},
};
use virote_kernel::{
    Face, Frame, NurbsSurface, PointSlopes, Solid, Tolerance, VariedSolid, VariedSurface,
    VariedWall,
};

use crate::some;

/// Half the distance between the places of a central difference.
const STEP: f64 = 1e-4;

/// Of what is compared, of sizes up to a hundred.
const NEAR: f64 = 1e-5;

/// A cone's wall: its rims move in their planes as they like, and the planes along and about themselves.
fn moving_cone([below, above]: [f64; 2]) -> impl Strategy<Value = VariedSurface> {
    let cone = NurbsSurface::cone(Frame::XY, [below, above], 3.0).unwrap();
    let net = cone.control_points().clone();
    let n_around = net.n_rows() - 1;
    let in_planes = vec([-0.1..0.1, -0.1..0.1], 2 * n_around);
    (in_planes, vec(some::point(), 2)).prop_map(move |(in_planes, planes)| {
        let slope = |i: usize, j: usize| {
            let (point, [x, y]) = (net.get(i, j), in_planes[2 * (i % n_around) + j]);
            let place = point.truncate() / point.w;
            let rise = planes[j].dot(place.with_z(1.0)) / 30.0;
            (DVec3::new(x, y, rise) * point.w).extend(0.0)
        };
        let all: Vec<DVec4> = (0..=n_around)
            .flat_map(|i| (0..2).map(move |j| (i, j)))
            .map(|(i, j)| slope(i, j))
            .collect();
        let slopes = PointSlopes::new(2, all.len(), vec![(1, all)]).unwrap();
        VariedSurface::new(Arc::new(cone.clone()), slopes).unwrap()
    })
}

fn solid_at(walls: &[&VariedSurface], h: f64) -> Solid {
    let face = |wall: &&VariedSurface| {
        Face::whole(Arc::new(wall.moved(&[(1, h)]).unwrap()), Tolerance::DEFAULT).unwrap()
    };
    let faces: Vec<Face> = walls.iter().map(face).collect();
    Solid::capped(&faces, Tolerance::DEFAULT).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// Of a cone whose ends tilt.
    #[test]
    fn what_walls_enclose_grows_by_their_slopes(outer in moving_cone([2.0, 1.5])) {
        let walls = [&outer];
        let wall = VariedWall::new(outer.clone(), false, false).unwrap();
        let solid = solid_at(&walls, 0.0);
        let varied = VariedSolid::between(Arc::new(solid), vec![wall], 2);
        let [behind, ahead] = [-STEP, STEP].map(|h| solid_at(&walls, h));
        let by = |ask: &dyn Fn(&Solid) -> f64| (ask(&ahead) - ask(&behind)) / (2.0 * STEP);
        let is_near = |found: Vec<f64>, expected: f64| {
            found[0].abs() <= 0.0 && (found[1] - expected).abs() <= NEAR * (1.0 + expected.abs())
        };
        let volume = by(&|solid| solid.volume_mass().unwrap().amount);
        prop_assert!(is_near(varied.volume_slopes().unwrap(), volume));
        let area = by(&|solid| solid.area_mass().unwrap().amount);
        prop_assert!(is_near(varied.area_slopes().unwrap(), area));
        let along = DVec3::new(0.3, -1.0, 0.6);
        let center = by(&|solid| solid.volume_mass().unwrap().centroid.dot(along));
        prop_assert!(is_near(varied.centroid_slopes(along).unwrap(), center));
        let [d, e] = [along, DVec3::new(1.0, 0.2, 0.4)];
        let second = by(&|solid| {
            let tensor = solid.volume_mass().unwrap().inertia;
            let trace = tensor.x_axis.x + tensor.y_axis.y + tensor.z_axis.z;
            d.dot((DMat3::from_diagonal(DVec3::splat(0.5 * trace)) - tensor) * e)
        });
        prop_assert!(is_near(varied.second_moment_slopes([d, e]).unwrap(), second));
    }

    /// What the wall of a hole encloses is missing, whichever way it looks, and its ends.
    #[test]
    fn what_the_walls_of_holes_enclose_is_taken_away(hole in moving_cone([1.0, 1.2])) {
        let [inside, around] = [false, true].map(|is_hole| {
            let wall = VariedWall::new(hole.clone(), is_hole, false).unwrap();
            VariedSolid::between(Arc::new(solid_at(&[&hole], 0.0)), vec![wall], 2)
        });
        let sums = |a: Vec<f64>, b: Vec<f64>| a[1] + b[1];
        let [a, b] = [&inside, &around].map(|solid| solid.volume_slopes().unwrap());
        prop_assert!(sums(a, b).abs() <= 1e-12);
    }
}
