//! The options of an export: each is declared once, with what it takes and what it sets.

use super::View;

/// Options of an export.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// How far a mesh may lie from its surface, a polyline or path from its curve; without one a
    /// small part of the whole's size.
    pub tolerance: Option<f64>,
    /// How far the normal may turn over a triangle, in radians; any angle without one.
    pub angle: Option<f64>,
    /// The form of a format that has a binary one and a text.
    pub binary: Option<bool>,
    /// Digits after the point, where numbers are text; without a count as many as they have.
    pub decimals: Option<usize>,
    /// From where a drawing looks.
    pub view: View,
    /// Whether curves and surfaces are written exactly by a format that also holds meshes.
    pub free_form: bool,
}

/// A value for an option, as far as options tell values apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OptionValue<'a> {
    /// A number without a unit.
    Number(f64),
    /// A length in the document's unit.
    Length(f64),
    /// An angle in radians.
    Angle(f64),
    /// True or false.
    Bool(bool),
    /// A text.
    Text(&'a str),
    /// Whatever no option takes.
    Other,
}

/// An option that formats may know.
#[derive(Debug)]
pub struct ExportOption {
    /// Its name in scripts.
    pub name: &'static str,
    /// What it takes, as the end of a sentence.
    pub wants: &'static str,
    /// The words that it takes, if it takes words.
    pub words: fn() -> Vec<&'static str>,
    /// Sets it; whether the value is one for it.
    pub set: fn(&mut Options, OptionValue<'_>) -> bool,
}

/// Digits after the point that an f64 can have any use for.
const MOST_DECIMALS: f64 = 17.0;

pub(super) static TOLERANCE: ExportOption = ExportOption {
    name: "tolerance",
    wants: "a positive length",
    words: Vec::new,
    set: |options, value| match value {
        OptionValue::Number(distance) | OptionValue::Length(distance) if 0.0 < distance => {
            options.tolerance = Some(distance);
            true
        }
        _ => false,
    },
};

pub(super) static ANGLE: ExportOption = ExportOption {
    name: "angle",
    wants: "a positive angle, such as `15deg`",
    words: Vec::new,
    set: |options, value| match value {
        OptionValue::Angle(angle) if 0.0 < angle => {
            options.angle = Some(angle);
            true
        }
        _ => false,
    },
};

pub(super) static BINARY: ExportOption = ExportOption {
    name: "binary",
    wants: "true or false",
    words: Vec::new,
    set: |options, value| {
        let OptionValue::Bool(is_binary) = value else { return false };
        options.binary = Some(is_binary);
        true
    },
};

pub(super) static FREE_FORM: ExportOption = ExportOption {
    name: "free_form",
    wants: "true or false",
    words: Vec::new,
    set: |options, value| {
        let OptionValue::Bool(is_free_form) = value else { return false };
        options.free_form = is_free_form;
        true
    },
};

pub(super) static DECIMALS: ExportOption = ExportOption {
    name: "decimals",
    wants: "a whole number from 0 to 17",
    words: Vec::new,
    set: |options, value| match value {
        OptionValue::Number(n) if (0.0..=MOST_DECIMALS).contains(&n) && n.fract() <= 0.0 => {
            options.decimals = Some(n as usize);
            true
        }
        _ => false,
    },
};

pub(super) static VIEW: ExportOption = ExportOption {
    name: "view",
    wants: "the name of a view, such as `\"front\"`",
    words: || View::ALL.iter().map(|&(name, _)| name).collect(),
    set: |options, value| {
        let OptionValue::Text(name) = value else { return false };
        let view = View::from_name(name);
        options.view = view.unwrap_or(options.view);
        view.is_some()
    },
};

#[cfg(test)]
mod tests {
    use super::{
        super::{FORMATS, PICTURES},
        OptionValue, Options,
    };

    #[test]
    fn every_option_that_a_format_lists_takes_something_and_sets_it() {
        let values = [
            OptionValue::Number(3.0),
            OptionValue::Length(3.0),
            OptionValue::Angle(0.5),
            OptionValue::Bool(true),
            OptionValue::Text("front"),
        ];
        for option in FORMATS.iter().chain(PICTURES).flat_map(|format| format.options) {
            let sets = |value: &OptionValue<'_>| {
                let mut options = Options::default();
                (option.set)(&mut options, *value) && options != Options::default()
            };
            assert!(values.iter().any(sets), "{}", option.name);
            assert!(!(option.set)(&mut Options::default(), OptionValue::Other), "{}", option.name);
        }
    }
}
