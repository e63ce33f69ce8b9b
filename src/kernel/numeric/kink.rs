//! Where a function of one number has a kink or a jump, between stretches in which it is smooth.
//!
//! Halving towards such a place takes the rules of an integral through all digits; what the function is on both sides
//! is known long before, as the polynomials through its samples there. On which side of the kink a place
//! lies is seen by which of them the function follows, so that bisection takes one question a step.

use crate::sorting::sort_by;

/// Components that tell the sides apart.
const COMPONENTS: usize = 8;

/// Questions of one bisection: all bits of a number.
const STEPS: usize = 60;

/// How many times nearer to one polynomial than to the other the function is where it follows it.
const CLEAR: f64 = 8.0;

/// How many times narrower than a piece a search must come down to, to be worth a cut.
const NARROWER: f64 = 16.0;

/// A function's first components at some places.
#[derive(Clone, Debug, Default)]
pub(super) struct SampledPiece(Vec<(f64, [f64; COMPONENTS])>);

/// The polynomial through samples. Berrut & Trefethen, *Barycentric Lagrange interpolation*, SIAM Review 46 (2004).
struct SidePolynomial<'s> {
    samples: &'s SampledPiece,
    weights: Vec<f64>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Follows {
    Left,
    Right,
    Neither,
}

/// Both sides of a kink.
struct KinkSides<'s>([SidePolynomial<'s>; 2]);

impl SampledPiece {
    /// Takes up a sample.
    pub(super) fn push(&mut self, place: f64, value: &[f64]) {
        self.0.push((place, first_components(value)));
    }

    /// The place of the largest value, and its size.
    pub(super) fn greatest(&self) -> Option<(f64, f64)> {
        let size = |value: &[f64]| value.iter().fold(0.0, |most: f64, part| most.max(part.abs()));
        let sizes = self.0.iter().map(|(place, value)| (*place, size(value)));
        sizes.max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// How far a value at another place is from the polynomial through the samples.
    pub(super) fn distance_at(&self, place: f64, value: &[f64]) -> f64 {
        SidePolynomial::through(self).distance(place, &first_components(value))
    }

    /// The narrow interval in which a function kinks that was sampled here, in an interval between two in which
    /// it is smooth: so narrow that what it may be off there, times the width, is within a budget, or that digits end.
    /// None where it follows the polynomials of both sides not clearly enough, or fails.
    pub(super) fn kink<E>(
        &self,
        [from, to]: [f64; 2],
        [left, right]: [&Self; 2],
        budget: f64,
        mut ask: impl FnMut(f64) -> Result<Vec<f64>, E>,
    ) -> Option<[f64; 2]> {
        let sides = KinkSides([left, right].map(SidePolynomial::through));
        let [mut low, mut high] = [from, to];
        let mut own = self.0.clone();
        sort_by(&mut own, |a, b| a.0.total_cmp(&b.0));
        for (place, value) in own {
            match sides.followed(place, &value).0 {
                // It would follow the left one behind where it followed the right one.
                Follows::Left if high < to => return None,
                Follows::Left => low = place,
                Follows::Right => high = high.min(place),
                Follows::Neither => {}
            }
        }
        for _ in 0..STEPS {
            let middle = 0.5 * (low + high);
            if middle <= low || high <= middle {
                break;
            }
            // Where it fails, as at a pole, there is no kink between numbers.
            let Ok(value) = ask(middle) else { return None };
            let (follows, apart) = sides.followed(middle, &first_components(&value));
            match follows {
                Follows::Left => low = middle,
                Follows::Right => high = middle,
                Follows::Neither => break,
            }
            if apart * (high - low) <= budget {
                break;
            }
        }
        (NARROWER * (high - low) <= to - from).then_some([low, high])
    }
}

fn first_components(value: &[f64]) -> [f64; COMPONENTS] {
    let mut first = [0.0; COMPONENTS];
    first.iter_mut().zip(value).for_each(|(first, part)| *first = *part);
    first
}

impl<'s> SidePolynomial<'s> {
    fn through(samples: &'s SampledPiece) -> Self {
        let places = || samples.0.iter().map(|(place, _)| *place);
        let width =
            places().fold(f64::NEG_INFINITY, f64::max) - places().fold(f64::INFINITY, f64::min);
        // Distances as shares of a quarter of the whole, whose products stay among numbers.
        let weight = |at: f64| {
            let others = places().filter(|other| other.to_bits() != at.to_bits());
            1.0 / others.map(|other| (at - other) * (4.0 / width)).product::<f64>()
        };
        Self { samples, weights: places().map(weight).collect() }
    }

    /// Its value outside of the samples.
    fn at(&self, place: f64) -> [f64; COMPONENTS] {
        let (mut sum, mut total) = ([0.0; COMPONENTS], 0.0);
        for ((at, value), weight) in self.samples.0.iter().zip(&self.weights) {
            let share = weight / (place - at);
            total += share;
            sum.iter_mut().zip(value).for_each(|(sum, part)| *sum += share * part);
        }
        sum.map(|sum| sum / total)
    }

    fn distance(&self, place: f64, value: &[f64; COMPONENTS]) -> f64 {
        let apart = self.at(place).into_iter().zip(value).map(|(a, b)| (a - b).abs());
        apart.fold(0.0, f64::max)
    }
}

impl KinkSides<'_> {
    /// Which side a function follows at a place, and how far it is from the other.
    fn followed(&self, place: f64, value: &[f64; COMPONENTS]) -> (Follows, f64) {
        let [left, right] = self.0.each_ref().map(|side| side.distance(place, value));
        let follows = match () {
            () if CLEAR * left < right => Follows::Left,
            () if CLEAR * right < left => Follows::Right,
            () => Follows::Neither,
        };
        (follows, left.max(right))
    }
}
