//! Meshes by measure: counts, bounds, area, volume, and how far places of the golden mesh are from
//! the one that is written now.

use std::fmt::Write as _;

use glam::DVec3;

use super::{
    difference::Difference,
    lines::{self, RelativeTolerance},
};
use crate::export::MeasuredPart;

/// Places of a part that are kept.
const N_PLACES: usize = 12;

/// What a line begins with that holds a place.
const PLACE: &str = "  at ";

/// The text that is kept of the parts of a file.
pub(super) fn text(parts: &[MeasuredPart<'_>]) -> String {
    let mut text = measures(parts);
    for part in parts.iter() {
        let _ = writeln!(text, "places of {}", on_a_line(part.name()));
        for place in part.places(N_PLACES) {
            let _ = writeln!(text, "{PLACE}{} {} {}", place.x, place.y, place.z);
        }
    }
    text
}

/// Where the parts differ from what is kept.
pub(super) fn differences(
    expected: &str,
    parts: &[MeasuredPart<'_>],
    tolerance: RelativeTolerance,
) -> Vec<Difference> {
    let kept = match GoldenMeasures::read(expected) {
        Ok(kept) => kept,
        Err(message) => return vec![Difference::of_whole(message)],
    };
    let mut told = lines::differences(&kept.measures, &measures(parts), tolerance);
    if kept.places.len() != parts.len() {
        return told;
    }
    for (part, places) in parts.iter().zip(&kept.places) {
        let apart = places.iter().map(|&place| (part.distance_to(place).unwrap_or(0.0), place));
        let farthest = apart.reduce(|most, next| if most.0 < next.0 { next } else { most });
        let limit = tolerance.0 * part.size().max(1.0);
        if let Some((deviation, place)) = farthest
            && limit < deviation
        {
            told.push(Difference::of_whole(format!(
                "`{}` is {deviation} away from ({}, {}, {}), where it was; the limit is {limit}",
                part.name(),
                place.x,
                place.y,
                place.z
            )));
        }
    }
    told
}

/// The measures of all parts, line by line.
fn measures(parts: &[MeasuredPart<'_>]) -> String {
    let mut text = String::new();
    for part in parts {
        let _ = writeln!(text, "{}", on_a_line(part.name()));
        for line in part.measures() {
            let _ = writeln!(text, "  {line}");
        }
    }
    text
}

/// A name that an expression of several lines may be.
fn on_a_line(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// What a golden file holds.
struct GoldenMeasures {
    measures: String,
    /// Of each part.
    places: Vec<Vec<DVec3>>,
}

impl GoldenMeasures {
    fn read(text: &str) -> Result<Self, String> {
        let mut kept = Self { measures: String::new(), places: Vec::new() };
        for (i, line) in text.lines().enumerate() {
            if let Some(numbers) = line.strip_prefix(PLACE) {
                let numbers: Result<Vec<f64>, _> = numbers.split(' ').map(str::parse).collect();
                let (Ok(&[x, y, z]), Some(places)) = (numbers.as_deref(), kept.places.last_mut())
                else {
                    return Err(format!("line {}: a place is three numbers", i + 1));
                };
                places.push(DVec3::new(x, y, z));
            } else if line.starts_with("places of ") {
                kept.places.push(Vec::new());
            } else {
                kept.measures += line;
                kept.measures.push('\n');
            }
        }
        Ok(kept)
    }
}
