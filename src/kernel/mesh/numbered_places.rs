//! Places by the bits of their coordinates.

use std::hash::{BuildHasher, RandomState};

use glam::DVec3;

/// Places in the order in which they come, each once: those that are one to the last bit are one, and zero has no sign.
///
/// A table of numbers with open addressing: the places themselves stand beside it, and are looked at only where a part
/// of the hash agrees. Knuth, *The Art of Computer Programming*, vol. 3, §6.4, algorithm L.
pub(super) struct NumberedPlaces {
    places: Vec<DVec3>,
    /// In the upper half a part of the hash, in the lower one more than the number of the place; zero where it is free.
    slots: Vec<u64>,
    hasher: RandomState,
}

impl NumberedPlaces {
    /// None yet, with room for so many.
    pub(super) fn with_room_for(most: usize) -> Self {
        Self {
            places: Vec::with_capacity(most),
            slots: vec![0; (2 * most + 1).next_power_of_two()],
            hasher: RandomState::new(),
        }
    }

    /// The number of a place, a new one where it is not known. There must be room for it.
    pub(super) fn number(&mut self, place: DVec3) -> u32 {
        let bits = bits(place);
        let hash = self.hasher.hash_one(bits);
        let (last, part) = (self.slots.len() - 1, hash >> 32);
        let mut at = hash as usize & last;
        loop {
            let slot = self.slots[at];
            if slot == 0 {
                self.places.push(place);
                self.slots[at] = part << 32 | self.places.len() as u64;
                return self.places.len() as u32 - 1;
            }
            let number = slot as u32 - 1;
            if slot >> 32 == part && self::bits(self.places[number as usize]) == bits {
                return number;
            }
            at = (at + 1) & last;
        }
    }

    /// The places by their numbers.
    pub(super) fn into_places(self) -> Vec<DVec3> {
        self.places
    }
}

fn bits(place: DVec3) -> [u64; 3] {
    (place + 0.0).to_array().map(f64::to_bits)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::NumberedPlaces;

    #[test]
    fn places_are_numbered_once_and_zero_has_no_sign() {
        let mut numbered = NumberedPlaces::with_room_for(4);
        let one = DVec3::new(1.0, 0.0, 2.0);
        let beside = DVec3::new(1.0_f64.next_up(), 0.0, 2.0);
        let places = [one, DVec3::ZERO, beside, -DVec3::ZERO, DVec3::new(1.0, -0.0, 2.0), beside];
        let numbers = places.map(|place| numbered.number(place));
        assert_eq!(numbers, [0, 1, 2, 1, 0, 2]);
        assert_eq!(numbered.into_places(), [one, DVec3::ZERO, beside]);
    }

    #[test]
    fn as_many_as_there_is_room_for_find_themselves_again() {
        let place = |i: u32| DVec3::new(f64::from(i % 10), f64::from(i / 10), -1.0);
        let mut numbered = NumberedPlaces::with_room_for(1000);
        for round in 0..2 {
            assert!((0..1000).all(|i| numbered.number(place(i)) == i), "round {round}");
        }
        assert_eq!(NumberedPlaces::with_room_for(0).into_places(), []);
    }
}
