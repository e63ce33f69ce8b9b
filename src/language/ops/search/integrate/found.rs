//! What an integral comes to, how exact it is to be, and where it stands in messages.

use crate::{
    kernel::glam::DVec3,
    value::{Switch, Value, rounded},
};

/// How far an integral may be off: by a fraction of the integral of the function's size, or by so much.
pub(super) type Tolerances = [f64; 2];

/// The components of an integral, how far they may be off, and the integral of the function's size.
#[derive(Default)]
pub(super) struct Found {
    pub(super) value: Vec<f64>,
    pub(super) error: f64,
    pub(super) size: f64,
    /// What decided which way the function goes, where derivatives are carried along; of several places those of the first.
    pub(super) switches: Vec<Switch>,
}

impl Found {
    /// Values that are no integrals.
    pub(super) fn exact(value: Vec<f64>) -> Self {
        let size = value.iter().fold(0.0, |most: f64, part| most.max(part.abs()));
        Self { value, error: 0.0, size, switches: Vec::new() }
    }

    pub(super) fn plus(mut self, other: Self) -> Self {
        if self.value.is_empty() {
            return other;
        }
        self.value.iter_mut().zip(other.value).for_each(|(a, b)| *a += b);
        self.error += other.error;
        self.size += other.size;
        self
    }
}

/// The tolerances of each of several integrals that are added up.
pub(super) fn shared([relative, absolute]: Tolerances, n_parts: usize) -> Tolerances {
    [relative, absolute / n_parts.max(1) as f64]
}

/// The tolerances of an integral over a length of integrals, which have errors of their own, and of these.
pub(super) fn nested([relative, absolute]: Tolerances, length: f64) -> [Tolerances; 2] {
    [[10.0 * relative, 0.5 * absolute], [relative, 0.5 * absolute / length.abs()]]
}

/// A number as messages tell it.
pub(super) fn six_digit_place(at: f64) -> String {
    rounded(at)
}

/// A point as messages tell it, with six digits.
pub(super) fn place_text(point: DVec3) -> String {
    let six = |part: f64| rounded(part).parse().unwrap_or(part);
    Value::Point(DVec3::from_array(point.to_array().map(six))).to_string()
}
