//! Places by the bits of their coordinates.

use std::hash::{BuildHasher, RandomState};

use glam::DVec3;

/// The places that are one to the last bit, zero without a sign, each once in the order in which they come; and the
/// number of each of those given.
///
/// By sorting parts of their hashes, each with the index of its place: a table would be looked into anywhere, which waits
/// for memory each time. Knuth, *The Art of Computer Programming*, vol. 3, §6.4.
pub(super) fn numbered(mut places: Vec<DVec3>) -> (Vec<DVec3>, Vec<u32>) {
    let hasher = RandomState::new();
    let key =
        |(index, place): (usize, &DVec3)| hasher.hash_one(bits(*place)) >> 32 << 32 | index as u64;
    let mut keys: Vec<u64> = places.iter().enumerate().map(key).collect();
    keys.sort_unstable();

    // The first of each, among those of one hash, whose indices ascend.
    let mut numbers: Vec<u32> = (0..places.len() as u32).collect();
    let mut known: Vec<u32> = Vec::new();
    for alike in keys.chunk_by(|a, b| a >> 32 == b >> 32).filter(|alike| 1 < alike.len()) {
        known.clear();
        for index in alike.iter().map(|key| *key as u32) {
            let own = bits(places[index as usize]);
            match known.iter().find(|first| bits(places[**first as usize]) == own) {
                Some(first) => numbers[index as usize] = *first,
                None => known.push(index),
            }
        }
    }

    let mut n_places = 0;
    for index in 0..places.len() {
        let first = numbers[index] as usize;
        if first == index {
            places[n_places] = places[index];
            numbers[index] = n_places as u32;
            n_places += 1;
        } else {
            numbers[index] = numbers[first];
        }
    }
    places.truncate(n_places);
    (places, numbers)
}

fn bits(place: DVec3) -> [u64; 3] {
    (place + 0.0).to_array().map(f64::to_bits)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::numbered;

    #[test]
    fn places_are_numbered_once_and_zero_has_no_sign() {
        let one = DVec3::new(1.0, 0.0, 2.0);
        let beside = DVec3::new(1.0_f64.next_up(), 0.0, 2.0);
        let given = [one, DVec3::ZERO, beside, -DVec3::ZERO, DVec3::new(1.0, -0.0, 2.0), beside];
        let (places, numbers) = numbered(given.to_vec());
        assert_eq!(numbers, [0, 1, 2, 1, 0, 2]);
        assert_eq!(places, [one, DVec3::ZERO, beside]);
        assert_eq!(numbered(Vec::new()), (Vec::new(), Vec::new()));
    }

    #[test]
    fn places_that_come_again_have_their_numbers() {
        let place = |i: u32| DVec3::new(f64::from(i % 10), f64::from(i / 10), -1.0);
        let given: Vec<DVec3> = (0..2000).map(|i| place(i % 1000)).collect();
        let (places, numbers) = numbered(given.clone());
        assert_eq!(places, given[..1000]);
        assert!((0..2000).all(|i| numbers[i as usize] == i % 1000));
    }
}
