//! The options of an export: each is declared once, with what it takes and what it sets.

use glam::DVec3;

use super::{Oblique, View, Viewpoint};

/// Options of an export.
#[derive(Clone, Debug, PartialEq)]
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
    pub viewpoint: Viewpoint,
    /// Whether borders and outlines of surfaces and edges of meshes are drawn.
    pub has_edges: bool,
    /// How many lines of equal parameter are drawn inside a surface in each direction.
    pub n_isocurves: usize,
    /// Whether all lines of a drawing are as thin as what machines that cut take for a path.
    pub is_hairline: bool,
    /// Whether curves and surfaces are written exactly by a format that also holds meshes.
    pub free_form: bool,
    /// What stands above a document.
    pub title: Option<String>,
    /// Whether a document has a picture; without a wish where there is something to draw.
    pub has_picture: Option<bool>,
}

impl Options {
    /// The most lines inside a surface that a drawing has any use for.
    pub const MOST_ISOCURVES: usize = 1000;
}

impl Default for Options {
    fn default() -> Self {
        Self {
            tolerance: None,
            angle: None,
            binary: None,
            decimals: None,
            viewpoint: Viewpoint::default(),
            has_edges: true,
            n_isocurves: N_ISOCURVES,
            is_hairline: false,
            free_form: false,
            title: None,
            has_picture: None,
        }
    }
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
    /// A point or vector.
    Point(DVec3),
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

/// Puts what an option takes into its place; whether the value was such.
fn put<T>(place: &mut T, taken: Option<T>) -> bool {
    let is_taken = taken.is_some();
    if let Some(taken) = taken {
        *place = taken;
    }
    is_taken
}

impl OptionValue<'_> {
    const fn truth(self) -> Option<bool> {
        if let Self::Bool(truth) = self { Some(truth) } else { None }
    }

    const fn point(self) -> Option<DVec3> {
        if let Self::Point(point) = self { Some(point) } else { None }
    }

    const fn angle(self) -> Option<f64> {
        if let Self::Angle(angle) = self { Some(angle) } else { None }
    }

    /// A whole number no larger than this.
    fn count(self, most: usize) -> Option<usize> {
        match self {
            Self::Number(n) if (0.0..=most as f64).contains(&n) && n.fract() <= 0.0 => {
                Some(n as usize)
            }
            _ => None,
        }
    }
}

/// Digits after the point that an f64 can have any use for.
const MOST_DECIMALS: usize = 17;

/// Lines inside a surface in each direction, where no number is asked for.
pub const N_ISOCURVES: usize = 7;

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
    set: |options, value| {
        put(&mut options.angle, value.angle().filter(|angle| 0.0 < *angle).map(Some))
    },
};

pub(super) static BINARY: ExportOption = ExportOption {
    name: "binary",
    wants: "true or false",
    words: Vec::new,
    set: |options, value| put(&mut options.binary, value.truth().map(Some)),
};

pub(super) static FREE_FORM: ExportOption = ExportOption {
    name: "free_form",
    wants: "true or false",
    words: Vec::new,
    set: |options, value| put(&mut options.free_form, value.truth()),
};

pub(super) static DECIMALS: ExportOption = ExportOption {
    name: "decimals",
    wants: "a whole number from 0 to 17",
    words: Vec::new,
    set: |options, value| put(&mut options.decimals, value.count(MOST_DECIMALS).map(Some)),
};

pub(super) static VIEW: ExportOption = ExportOption {
    name: "view",
    wants: "the name of a view, such as `\"front\"`",
    words: || View::ALL.iter().map(|&(name, _)| name).collect(),
    set: |options, value| {
        let OptionValue::Text(name) = value else { return false };
        let view = View::from_name(name);
        options.viewpoint.view = view.or(options.viewpoint.view);
        view.is_some()
    },
};

pub(super) static OBLIQUE_ANGLE: ExportOption = ExportOption {
    name: "oblique_angle",
    wants: "an angle, such as `30deg`",
    words: Vec::new,
    set: |options, value| put(&mut options.viewpoint.oblique_angle, value.angle().map(Some)),
};

pub(super) static OBLIQUE_RATIO: ExportOption = ExportOption {
    name: "oblique_ratio",
    wants: "a number above 0 and at most 2",
    words: Vec::new,
    set: |options, value| match value {
        OptionValue::Number(ratio) if 0.0 < ratio && ratio <= Oblique::MOST_RATIO => {
            options.viewpoint.oblique_ratio = Some(ratio);
            true
        }
        _ => false,
    },
};

pub(super) static CAMERA: ExportOption = ExportOption {
    name: "camera",
    wants: "a point, such as `(300, -400, 250)`",
    words: Vec::new,
    set: |options, value| put(&mut options.viewpoint.camera, value.point().map(Some)),
};

pub(super) static LOOK_AT: ExportOption = ExportOption {
    name: "look_at",
    wants: "a point, such as `(0, 0, 50)`",
    words: Vec::new,
    set: |options, value| put(&mut options.viewpoint.look_at, value.point().map(Some)),
};

pub(super) static PERSPECTIVE: ExportOption = ExportOption {
    name: "perspective",
    wants: "true or false",
    words: Vec::new,
    set: |options, value| put(&mut options.viewpoint.is_perspective, value.truth()),
};

pub(super) static EDGES: ExportOption = ExportOption {
    name: "edges",
    wants: "true or false",
    words: Vec::new,
    set: |options, value| put(&mut options.has_edges, value.truth()),
};

pub(super) static ISOCURVES: ExportOption = ExportOption {
    name: "isocurves",
    wants: "a whole number from 0 to 1000",
    words: Vec::new,
    set: |options, value| put(&mut options.n_isocurves, value.count(Options::MOST_ISOCURVES)),
};

pub(super) static HAIRLINE: ExportOption = ExportOption {
    name: "hairline",
    wants: "true or false",
    words: Vec::new,
    set: |options, value| put(&mut options.is_hairline, value.truth()),
};

pub(super) static TITLE: ExportOption = ExportOption {
    name: "title",
    wants: "a text, such as `\"Hull, second review\"`",
    words: Vec::new,
    set: |options, value| match value {
        OptionValue::Text(title) if !title.trim().is_empty() => {
            options.title = Some(title.trim().to_owned());
            true
        }
        _ => false,
    },
};

pub(super) static PICTURE: ExportOption = ExportOption {
    name: "picture",
    wants: "true or false",
    words: Vec::new,
    set: |options, value| put(&mut options.has_picture, value.truth().map(Some)),
};

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::{
        super::{FORMATS, PICTURES},
        OptionValue, Options,
    };

    #[test]
    fn every_option_that_a_format_lists_takes_something_and_sets_it() {
        let values = [
            OptionValue::Number(3.0),
            OptionValue::Length(3.0),
            OptionValue::Number(0.25),
            OptionValue::Angle(0.5),
            OptionValue::Bool(true),
            OptionValue::Bool(false),
            OptionValue::Point(DVec3::ONE),
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
