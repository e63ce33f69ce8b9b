//! Texts beside places of a drawing, and the scale: where they stand, without a word about how they are
//! written.

use glam::{DVec2, DVec3};

use super::{legend::digits, projection::Projection};

/// A text beside a place.
#[derive(Clone, Debug, PartialEq)]
pub struct DefinitionLabel {
    /// Places in space, of which the one nearest to the viewer is meant.
    pub places: Vec<DVec3>,
    /// What stands there.
    pub text: String,
}

impl DefinitionLabel {
    /// The place beside which it stands, as it is drawn.
    pub(super) fn place_seen(&self, view: &Projection) -> DVec3 {
        let seen = self.places.iter().map(|&place| view.project(place));
        seen.max_by(|a, b| a.z.total_cmp(&b.z)).unwrap_or_default()
    }
}

/// Free space between labels, and between a label and its place, in heights of its letters.
const GAP: f64 = 0.5;
/// A label is moved down past at most so many others.
const MOST_MOVES: usize = 100;

/// The upper left corners of labels beside their places, right and above, moved down where one would
/// stand on another; x goes to the right and y down. Each has its place, and its width.
pub(super) fn arranged(labels: &[(DVec2, f64)], letter: f64) -> Vec<DVec2> {
    let gap = GAP * letter;
    let mut corners: Vec<DVec2> = Vec::with_capacity(labels.len());
    for (i, &(place, width)) in labels.iter().enumerate() {
        let mut corner = place + DVec2::new(gap, -gap - letter);
        for _ in 0..MOST_MOVES {
            let meets = |&(other, &(_, its)): &(&DVec2, &(DVec2, f64))| {
                corner.x < other.x + its + gap
                    && other.x < corner.x + width + gap
                    && (corner.y - other.y).abs() < letter + gap
            };
            let Some((other, _)) = corners.iter().zip(&labels[..i]).find(meets) else { break };
            corner.y = other.y + letter + gap;
        }
        corners.push(corner);
    }
    corners
}

/// The largest of 1, 2 and 5 times a power of ten that is no longer than a length.
pub(super) fn round_length(most: f64) -> f64 {
    let exponent = libm::floor(libm::log10(most)) as i32;
    let lengths = [exponent - 1, exponent, exponent + 1].into_iter().flat_map(|exponent| {
        ["1", "2", "5"].map(|digit| format!("{digit}e{exponent}").parse().unwrap_or(0.0))
    });
    lengths.filter(|length| *length <= most).fold(0.0, f64::max)
}

/// What stands beside a scale.
pub(super) fn scale_text(length: f64, unit: &str) -> String {
    format!("{} {unit}", digits(length))
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::{arranged, round_length};

    #[test]
    fn labels_at_one_place_stand_below_one_another() {
        let place = DVec2::new(5.0, 50.0);
        let corners = arranged(&[(place, 30.0), (place, 10.0), (DVec2::ZERO, 10.0)], 8.0);
        assert_eq!(corners[0], DVec2::new(9.0, 38.0));
        assert_eq!(corners[1], DVec2::new(9.0, 50.0));
        assert_eq!(corners[2], DVec2::new(4.0, -12.0));
    }

    #[test]
    fn lengths_of_scales_are_round() {
        for (most, length) in [
            (1.0, 1.0),
            (1.99, 1.0),
            (2.0, 2.0),
            (4.9, 2.0),
            (77.0, 50.0),
            (1e-7, 1e-7),
            (0.3, 0.2),
        ] {
            assert_eq!(round_length(most).to_bits(), f64::to_bits(length), "{most}");
        }
    }
}
