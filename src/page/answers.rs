//! How answers are told: numbers with their units, and what was asked as numbers.

use glam::DVec3;
use serde_json::{Value as Json, json};

use crate::{session::Report, value::rounded};

/// The units of a document.
pub(super) struct Units {
    length: &'static str,
}

impl Units {
    pub(super) fn of(report: &Report) -> Self {
        Self { length: report.document.0.name() }
    }

    /// Of lengths.
    pub(super) fn length(&self) -> String {
        self.length.to_owned()
    }

    /// Of areas.
    pub(super) fn area(&self) -> String {
        format!("{}²", self.length)
    }

    /// Of volumes.
    pub(super) fn volume(&self) -> String {
        format!("{}³", self.length)
    }

    /// Of curvatures.
    pub(super) fn curvature(&self) -> String {
        format!("1/{}", self.length)
    }

    /// Of products of curvatures.
    pub(super) fn gaussian(&self) -> String {
        format!("1/{}²", self.length)
    }
}

/// Something that is so.
pub(super) struct Fact {
    name: &'static str,
    label: &'static str,
    value: Json,
    text: String,
}

impl Fact {
    /// A number with its unit.
    pub(super) fn number(
        name: &'static str,
        label: &'static str,
        value: f64,
        unit: String,
    ) -> Self {
        Self { name, label, value: json!(value), text: with_unit(value, &unit) }
    }

    /// A direction.
    pub(super) fn vector(name: &'static str, label: &'static str, value: DVec3) -> Self {
        let [x, y, z] = value.to_array().map(rounded);
        Self { name, label, value: json!(value.to_array()), text: format!("({x}, {y}, {z})") }
    }

    /// What is no number.
    pub(super) fn said(name: &'static str, label: &'static str, text: &str) -> Self {
        Self { name, label, value: Json::Null, text: text.to_owned() }
    }

    pub(super) fn json(&self) -> Json {
        json!({ "name": self.name, "label": self.label, "value": self.value, "text": self.text })
    }
}

/// A number in six digits with its unit; those before the point are all told where they fit on a line.
pub(super) fn with_unit(value: f64, unit: &str) -> String {
    let size = value.abs();
    let number = if size < 1e6 {
        rounded(value)
    } else if size < 1e12 {
        format!("{value:.0}")
    } else {
        format!("{value:.5e}")
    };
    format!("{number} {unit}")
}

/// A member of what was asked that is a number.
///
/// # Errors
/// What is wrong with it, as a sentence.
pub(super) fn number_of(body: &Json, name: &str) -> Result<f64, String> {
    let number = body[name].as_f64().filter(|number| number.is_finite());
    number.ok_or_else(|| format!("`{name}` must be a number"))
}

#[cfg(test)]
mod tests {
    use super::with_unit;

    #[test]
    fn no_digits_are_made_up() {
        for (value, text) in [
            (25.132_741_2, "25.1327 mm"),
            (7_620_758.652, "7620759 mm"),
            (-999_999_999_999.4, "-999999999999 mm"),
            (1.130_973_355e14, "1.13097e14 mm"),
        ] {
            assert_eq!(with_unit(value, "mm"), text);
        }
    }
}
