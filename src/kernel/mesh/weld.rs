//! Which vertices stand at one place.
//!
//! Space is divided into cubes of many tolerances' width. A vertex looks for an earlier one in its
//! own cube, and in the neighbours that are nearer than the tolerance, which are few.

use std::collections::HashMap;

use glam::DVec3;

/// Tolerances along the side of a cube.
///
/// Larger puts details of the model into one cube, where each is compared with each; smaller lets
/// more vertices look into more cubes.
const CUBE: f64 = 64.0;

/// For each place the index of the first that is no further than `distance` from it and stands for
/// itself; its own where there is none before it.
pub(crate) fn welded(places: &[DVec3], distance: f64) -> Vec<u32> {
    let side = CUBE * distance.max(f64::MIN_POSITIVE);
    // The last of the places that stand for themselves in a cube, and before each the next.
    let mut last_in: HashMap<[i64; 3], u32> = HashMap::with_capacity(places.len());
    let mut before: Vec<u32> = vec![u32::MAX; places.len()];
    let mut first = Vec::with_capacity(places.len());
    for (index, &place) in places.iter().enumerate() {
        let index = index as u32;
        let found = cubes_near(place, distance, side).find_map(|cube| {
            let mut there = last_in.get(&cube).copied();
            while let Some(other) = there {
                if places[other as usize].distance(place) <= distance {
                    return Some(other);
                }
                there = Some(before[other as usize]).filter(|&next| next != u32::MAX);
            }
            None
        });
        first.push(found.unwrap_or(index));
        if found.is_none() {
            let cube = cube_of(place, side);
            if let Some(other) = last_in.insert(cube, index) {
                before[index as usize] = other;
            }
        }
    }
    first
}

fn cube_of(place: DVec3, side: f64) -> [i64; 3] {
    // Beyond 2⁶³ cubes all are one, which compares more and misses nothing.
    (place / side).floor().to_array().map(|number| number as i64)
}

/// The cubes within the distance of a place, its own among them.
fn cubes_near(place: DVec3, distance: f64, side: f64) -> impl Iterator<Item = [i64; 3]> {
    let own = cube_of(place, side);
    let (low, high) = (cube_of(place - distance, side), cube_of(place + distance, side));
    // At the end of the numbers a step out of them is no further than the next cube.
    let along = move |axis: usize| {
        low[axis].max(own[axis].saturating_sub(1))..=high[axis].min(own[axis].saturating_add(1))
    };
    along(0).flat_map(move |x| along(1).flat_map(move |y| along(2).map(move |z| [x, y, z])))
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::welded;

    #[test]
    fn places_within_the_distance_are_one() {
        let x = |x: f64| DVec3::new(x, 0.0, -1.0);
        // The second pair lies on either side of a cube's face.
        let places = [x(0.0), x(1.0), x(0.9e-6), x(64e-6 - 1e-7), x(64e-6 + 1e-7), x(2e-6)];
        assert_eq!(welded(&places, 1e-6), [0, 1, 0, 3, 3, 5]);
    }

    #[test]
    fn without_a_distance_equal_places_are_one() {
        let places = [DVec3::ZERO, DVec3::X, -DVec3::ZERO, DVec3::X, DVec3::MAX];
        assert_eq!(welded(&places, 0.0), [0, 1, 0, 1, 4]);
    }
}
