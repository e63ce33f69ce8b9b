//! Units as files write them: `mm`, `deg`, `mm^2`, `1/m`, `mm·rad`.

use std::f64::consts::{PI, TAU};

use super::{Dimension, Number, number::WHOLE};
use crate::kernel::{Column, NamedColumn};

/// Units of length by name, each with its size in micrometres.
const LENGTHS: &[(&str, f64)] = &[
    ("um", 1.0),
    ("mm", 1e3),
    ("cm", 1e4),
    ("m", 1e6),
    ("km", 1e9),
    ("in", 25_400.0),
    ("ft", 304_800.0),
];

/// Units of angle by name, each with its size in radians as a fraction.
const ANGLES: &[(&str, [f64; 2])] =
    &[("rad", [1.0, 1.0]), ("deg", [PI, 180.0]), ("°", [PI, 180.0]), ("turn", [TAU, 1.0])];

/// What a unit that is written as text measures, and its size in the document's unit and radians as a
/// fraction.
#[derive(Clone, Copy, Debug)]
pub(super) struct UnitText {
    dim: Dimension,
    size: [f64; 2],
}

impl UnitText {
    /// The unit that `text` says, in a document whose unit of length is `length`.
    pub(super) fn read(text: &str, length: &str) -> Option<Self> {
        let document = size_of(length)?;
        let (mut powers, mut size) = ([0_i32; 2], [1.0; 2]);
        let mut is_below = false;
        let mut rest = text.trim();
        loop {
            let end = rest.find(['·', '*', '/']).unwrap_or(rest.len());
            // In `mm^(3/6)` the stroke stands within brackets.
            let end = match rest[..end].find('(') {
                Some(open) => open + rest[open..].find(')')? + 1,
                None => end,
            };
            let (name, power) = name_and_power(rest[..end].trim())?;
            let power = if is_below { -power } else { power };
            let (which, [above, below]) = match (size_of(name), name) {
                (Some(micrometres), _) => (Some(0), [micrometres, document]),
                (None, "1" | "-") => (None, [1.0, 1.0]),
                (None, _) => (Some(1), ANGLES.iter().find(|(known, _)| *known == name)?.1),
            };
            if let Some(which) = which {
                powers[which] = i32::checked_add(powers[which], power)?;
                let exponent = f64::from(power.abs()) / f64::from(WHOLE);
                let raised = [above, below].map(|part| libm::pow(part, exponent));
                let turned = usize::from(power < 0);
                size = [size[0] * raised[turned], size[1] * raised[1 - turned]];
            }
            rest = rest[end..].trim_start();
            let Some(sign) = rest.chars().next() else { break };
            is_below = match sign {
                '/' => true,
                '·' | '*' => false,
                _ => return None,
            };
            rest = rest[sign.len_utf8()..].trim_start();
        }
        let [length, angle] = powers.map(|power| i8::try_from(power).ok());
        let dim = Dimension::of_powers([length?, angle?]);
        size.iter().all(|part| part.is_normal()).then_some(Self { dim, size })
    }

    /// What it measures.
    pub(super) fn dim(&self) -> Dimension {
        self.dim
    }

    /// Whether it measures angles, alone or with lengths.
    pub(super) fn has_angle(&self) -> bool {
        self.dim.angle_power() != 0
    }

    /// So many of this unit, in the document's unit and radians.
    fn convert(&self, value: f64) -> f64 {
        scaled(value, self.size)
    }

    /// A number in the document's unit and radians, in this unit.
    pub(super) fn in_this_unit(&self, value: f64) -> f64 {
        scaled(value, [self.size[1], self.size[0]])
    }

    /// The fewest digits of this unit that are the same number in the document's, but for the rounding of its last bit
    /// by which units are converted.
    pub(super) fn shortest_in(&self, value: f64) -> f64 {
        let own = self.in_this_unit(value);
        if own.to_bits() == value.to_bits() {
            return own;
        }
        let last_bit = value.abs().next_up() - value.abs();
        (0..17)
            .filter_map(|digits| format!("{own:.digits$e}").parse::<f64>().ok())
            .find(|&candidate| (self.convert(candidate) - value).abs() <= last_bit)
            .unwrap_or(own)
    }
}

/// So many of a unit as files write it, such as `mm^2`, in a document whose unit of length is `length`;
/// rounded once.
#[must_use]
pub fn in_unit_of(value: f64, unit: &str, length: &str) -> Option<Number> {
    let unit = UnitText::read(unit, length)?;
    Some(Number { value: unit.convert(value), dim: unit.dim })
}

/// The fewest digits of a unit that are the same number in the document's unit of length, or in radians.
pub fn shortest_in(value: f64, unit: &str, length: &str) -> Option<f64> {
    Some(UnitText::read(unit, length)?.shortest_in(value))
}

/// The number times a fraction; whole ratios stay exact.
fn scaled(value: f64, [above, below]: [f64; 2]) -> f64 {
    if above % below == 0.0 {
        value * (above / below)
    } else if below % above == 0.0 {
        value / (below / above)
    } else {
        value * above / below
    }
}

/// The size of a unit of length in micrometres.
fn size_of(name: &str) -> Option<f64> {
    LENGTHS.iter().find(|(known, _)| *known == name).map(|&(_, size)| size)
}

/// `mm^2` is `mm` to the power 12 in sixths; `mm²` says the same.
fn name_and_power(text: &str) -> Option<(&str, i32)> {
    let whole = i32::from(WHOLE);
    if let Some(name) = text.strip_suffix('²') {
        return Some((name, 2 * whole));
    }
    if let Some(name) = text.strip_suffix('³') {
        return Some((name, 3 * whole));
    }
    let Some((name, power)) = text.split_once('^') else { return Some((text, whole)) };
    let power = match power.strip_prefix('(').and_then(|power| power.strip_suffix(')')) {
        Some(fraction) => {
            let (above, below) = fraction.split_once('/').unwrap_or((fraction, "1"));
            let sixths = above.parse::<i32>().ok()?.checked_mul(whole)?;
            let below = below.parse::<i32>().ok().filter(|below| 0 < *below)?;
            (sixths % below == 0).then_some(sixths / below)?
        }
        None => power.parse::<i32>().ok()?.checked_mul(whole)?,
    };
    Some((name.trim(), power)).filter(|_| power.abs() <= i32::from(i8::MAX))
}

/// What the numbers of a column measure; of one without a unit nobody has said it.
pub(super) fn dim_of(column: &NamedColumn) -> Dimension {
    // Columns are kept in the document's unit, so that only the powers are left to read.
    let unit = column.unit.as_deref().and_then(|unit| UnitText::read(unit, "mm"));
    unit.map_or(Dimension::OPEN, |unit| unit.dim)
}

/// A column as a file gives it, in a document whose unit of length is `length`.
///
/// # Errors
/// A sentence, where the unit is none, where it measures texts, or where a number in it is out of
/// range.
pub fn in_document_unit(column: NamedColumn, length: &str) -> Result<NamedColumn, String> {
    let Some(text) = &column.unit else { return Ok(column) };
    let name = &column.name;
    let unit = UnitText::read(text, length).ok_or_else(|| {
        let lengths = LENGTHS.iter().map(|(name, _)| *name);
        let angles = ANGLES.iter().map(|(name, _)| *name).filter(|name| name.is_ascii());
        let known: Vec<&str> = lengths.chain(angles).collect();
        format!(
            "column `{name}` has the unit `{text}`, which is not known; units are {}, their powers and products such as `mm^2` and `1/m`, and what else is told of a column stands in its name without square brackets",
            known.join(" ")
        )
    })?;
    let Column::Numbers(numbers) = &column.column else {
        return Err(format!("column `{name}` has the unit `{text}`, but holds texts"));
    };
    let converted: Vec<f64> = numbers.iter().map(|&number| unit.convert(number)).collect();
    let is_lost = |(new, old): (&f64, &f64)| old.is_finite() && !new.is_finite();
    if let Some(row) = converted.iter().zip(numbers).position(is_lost) {
        return Err(format!("row {row} of column `{name}` is out of range in the document's unit"));
    }
    Ok(NamedColumn { unit: unit.dim.unit(length), ..NamedColumn::numbers(name, converted) })
}

#[cfg(test)]
mod tests {
    use super::{Dimension, UnitText};

    #[test]
    fn what_exports_write_is_read() {
        for [length, angle] in [[6, 0], [0, 6], [12, 0], [-6, 0], [3, 0], [-12, 6], [-3, -9]] {
            let dim = Dimension::of_powers([length, angle]);
            let text = dim.unit("cm").unwrap_or_default();
            let unit = UnitText::read(&text, "cm").expect("it is a unit");
            assert_eq!(unit.dim, dim, "{text}");
            assert_eq!(unit.convert(0.1).to_bits(), 0.1_f64.to_bits(), "{text}");
        }
    }

    #[test]
    fn what_is_shown_in_a_unit_has_the_digits_that_were_written_in_it() {
        for (text, value) in [("in", 0.1), ("ft", 3.7), ("deg", 12.3), ("m^2", 1e-7), ("1/in", 0.3)]
        {
            let unit = UnitText::read(text, "mm").expect("it is a unit");
            let shown = unit.shortest_in(unit.convert(value));
            assert_eq!(shown.to_bits(), f64::to_bits(value), "{shown} {text}");
        }
    }

    #[test]
    fn powers_convert_by_their_power() {
        let convert = |text: &str, value: f64| {
            UnitText::read(text, "mm").map(|unit| {
                (
                    (unit.dim.length_power().unwrap_or(0), unit.dim.angle_power()),
                    unit.convert(value),
                )
            })
        };
        assert_eq!(convert("cm^2", 2.0), Some(((12, 0), 200.0)));
        assert_eq!(convert("m³", 1.0), Some(((18, 0), 1e9)));
        assert_eq!(convert("cm²", 2.0), Some(((12, 0), 200.0)));
        let (powers, root) = convert("m^(1/3)", 2.0).expect("it is a unit");
        assert_eq!(powers, (2, 0));
        assert!((root - 20.0).abs() <= 40.0 * f64::EPSILON);
        assert_eq!(convert("m^(-2)", 4.0), Some(((-12, 0), 4e-6)));
        assert_eq!(convert("cm*m/m^2", 3.0), Some(((0, 0), 0.03)));
        assert_eq!(convert("1/m", 5.0), Some(((-6, 0), 0.005)));
        let (powers, turn) = convert("deg/mm", 180.0).expect("it is a unit");
        assert_eq!(powers, (-6, 6));
        assert!((turn - std::f64::consts::PI).abs() <= 2.0 * f64::EPSILON);
        assert_eq!(convert("1", 7.0), Some(((0, 0), 7.0)));
        for text in ["kg", "mm^", "mm^x", "mm mm", "^2", "mm^(1/0)", "mm^(1/4", "mm^99", "/"] {
            assert_eq!(convert(text, 1.0), None, "{text}");
        }
    }
}
