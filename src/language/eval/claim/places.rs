//! The points that a report of a failed claim shows.

use glam::DVec3;

use crate::value::Value;

/// Points that a claim tells of.
#[derive(Default)]
pub(super) struct ClaimPlaces {
    points: Vec<DVec3>,
}

/// Points of one claim that are kept.
const MOST_PLACES: usize = 16;

impl ClaimPlaces {
    pub(super) fn add(&mut self, point: DVec3) {
        let is_known = |known: &DVec3| {
            known.to_array().map(f64::to_bits) == point.to_array().map(f64::to_bits)
        };
        if self.points.len() < MOST_PLACES && point.is_finite() && !self.points.iter().any(is_known)
        {
            self.points.push(point);
        }
    }

    /// A point itself, or those of a record.
    pub(super) fn note(&mut self, value: &Value) {
        match value {
            Value::Point(point) => self.add(*point),
            Value::Record(record) => {
                for (_, member) in record.iter() {
                    if let Value::Point(point) = member {
                        self.add(*point);
                    }
                }
            }
            _ => {}
        }
    }

    pub(super) fn of_failure(self, holds: bool) -> Vec<DVec3> {
        if holds { Vec::new() } else { self.points }
    }
}
