//! Numbers with a dimension: powers of length and angle, carried along by every operator.
//!
//! Values are held in the document's unit of length and in radians, so that the arithmetic is
//! that of plain numbers and only the powers need care.

use std::fmt;

use super::Real;

/// Powers of length and angle, in sixths so that square and cube roots stay exact.
///
/// The power of length is *open* where nobody has said it: of coordinates, which hold lengths as well as
/// directions, and of data without units. What is computed from it stays open, fits wherever a number
/// without a unit does, and is never told with a unit of length. An angle says its unit always, so that
/// its power is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dimension {
    /// `None` where it is open.
    length: Option<i8>,
    angle: i8,
}

impl Default for Dimension {
    fn default() -> Self {
        Self::NONE
    }
}

/// Sixths in one whole power.
pub(super) const WHOLE: i8 = 6;

impl Dimension {
    /// A bare number.
    pub const NONE: Self = Self::of_powers([0, 0]);
    /// A number of which nobody has said what it measures.
    pub const OPEN: Self = Self { length: None, angle: 0 };
    /// A length.
    pub const LENGTH: Self = Self::of_powers([WHOLE, 0]);
    /// An angle.
    pub const ANGLE: Self = Self::of_powers([0, WHOLE]);

    /// The dimension of these powers of length and angle, in sixths.
    #[must_use]
    pub const fn of_powers([length, angle]: [i8; 2]) -> Self {
        Self { length: Some(length), angle }
    }

    /// The power of length in sixths; `None` where it is open.
    #[must_use]
    pub fn length_power(self) -> Option<i8> {
        self.length
    }

    /// The power of angle in sixths.
    #[must_use]
    pub fn angle_power(self) -> i8 {
        self.angle
    }

    /// Whether it is that of a bare number, and known to be.
    #[must_use]
    pub fn is_none(self) -> bool {
        self == Self::NONE
    }

    /// Whether the number has no unit: because it measures nothing, or because nobody has said what.
    #[must_use]
    pub fn is_bare(self) -> bool {
        self.angle == 0 && matches!(self.length, None | Some(0))
    }

    /// Whether it is an angle, known or made of an open number.
    #[must_use]
    pub fn is_angle(self) -> bool {
        self.angle == WHOLE && matches!(self.length, None | Some(0))
    }

    /// Whether the number may stand where a length is wanted: bare numbers count in the document's unit.
    #[must_use]
    pub fn is_as_length(self) -> bool {
        self == Self::LENGTH || self.is_bare()
    }

    /// The dimension of a product; `None` where a power leaves the range of ±21.
    #[must_use]
    pub fn times(self, other: Self) -> Option<Self> {
        self.combined(other, i8::checked_add)
    }

    /// The dimension of a quotient.
    #[must_use]
    pub fn over(self, other: Self) -> Option<Self> {
        self.combined(other, i8::checked_sub)
    }

    fn combined(self, other: Self, with: fn(i8, i8) -> Option<i8>) -> Option<Self> {
        let length = match (self.length, other.length) {
            (Some(a), Some(b)) => Some(with(a, b)?),
            _ => None,
        };
        Some(Self { length, angle: with(self.angle, other.angle)? })
    }

    /// The dimension raised to `exponent`; `None` where that is no sixth.
    #[must_use]
    pub fn power(self, exponent: f64) -> Option<Self> {
        self.each(|power| {
            let raised = f64::from(power) * exponent;
            (raised.fract() == 0.0 && raised.abs() <= f64::from(i8::MAX)).then_some(raised as i8)
        })
    }

    /// The dimension of a cube root; `None` where that is no sixth.
    #[must_use]
    pub fn cube_root(self) -> Option<Self> {
        self.each(|power| (power % 3 == 0).then_some(power / 3))
    }

    /// Both powers changed; an open one stays open.
    fn each(self, change: impl Fn(i8) -> Option<i8>) -> Option<Self> {
        let length = match self.length {
            Some(power) => Some(change(power)?),
            None => None,
        };
        Some(Self { length, angle: change(self.angle)? })
    }

    /// The common dimension of two sides of a comparison, where a bare number fits anything.
    #[must_use]
    pub fn common(self, other: Self) -> Option<Self> {
        match (self, other) {
            (a, b) if a == b => Some(a),
            (a, Self::NONE) => Some(a),
            (Self::NONE, b) => Some(b),
            (a, b) if a.length.is_some() && b.length.is_some() => None,
            (a, b) if a.angle == b.angle || a.is_bare() || b.is_bare() => {
                Some(Self { length: None, angle: if a.angle == 0 { b.angle } else { a.angle } })
            }
            _ => None,
        }
    }

    /// The dimension of a sum: the common one, but what holds an angle takes nothing without one.
    #[must_use]
    pub fn sum(self, other: Self) -> Option<Self> {
        if self.angle == other.angle { self.common(other) } else { None }
    }
}

impl Dimension {
    /// The unit of numbers as they are kept, in this unit of length and in radians: `mm`, `mm^2`,
    /// `rad`; none of a bare number, and none where a power is open.
    #[must_use]
    pub fn unit(self, length: &str) -> Option<String> {
        if self.is_angle() {
            return Some("rad".to_owned());
        }
        self.written(length, "·")
    }

    /// What stands behind a number so that it reads back, in this unit of length: `mm^2`, `mm*1rad`.
    #[must_use]
    pub fn suffix(self, length: &str) -> Option<String> {
        self.written(length, "*1")
    }

    fn written(self, length: &str, between: &str) -> Option<String> {
        let powers = [(length, self.length?), ("rad", self.angle)];
        let parts = powers.into_iter().filter(|&(_, power)| power != 0);
        let parts: Vec<String> =
            parts.map(|(name, power)| format!("{name}{}", exponent(power))).collect();
        (!parts.is_empty()).then(|| parts.join(between))
    }
}

/// A power in sixths as it stands behind what is raised; nothing for 1.
fn exponent(power: i8) -> String {
    match (power % WHOLE, power / WHOLE) {
        (0, 1) => String::new(),
        (0, whole) => format!("^{whole}"),
        _ => {
            let common = if power % 3 == 0 {
                3
            } else if power % 2 == 0 {
                2
            } else {
                1
            };
            format!("^({}/{})", power / common, WHOLE / common)
        }
    }
}

/// As a noun: `a length`, `an area`, `an angle`, `length^-1`.
impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(length) = self.length else {
            return f.write_str(match self.angle {
                0 => "a number without a unit",
                WHOLE => "an angle",
                _ => "a quantity in powers of angle",
            });
        };
        let named = match (length, self.angle) {
            (0, 0) => "a number without a unit",
            (WHOLE, 0) => "a length",
            (0, WHOLE) => "an angle",
            (12, 0) => "an area",
            (18, 0) => "a volume",
            _ => "",
        };
        if !named.is_empty() {
            return f.write_str(named);
        }
        f.write_str("a quantity in ")?;
        let mut first = true;
        for (name, power) in [("length", length), ("angle", self.angle)] {
            if power == 0 {
                continue;
            }
            write!(f, "{}{name}", if first { "" } else { "·" })?;
            first = false;
            f.write_str(&exponent(power))?;
        }
        Ok(())
    }
}

/// What to do where a number without a unit meets an angle in a sum.
pub const BARE_AND_ANGLE: &str = "an angle says its unit: write `3deg` or `3rad`, and `x * 1deg` of what was computed or read from a file; `angle / 1rad` is the plain number of radians";

/// A finite number with its dimension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number<T = f64> {
    /// In document units and radians.
    pub value: T,
    /// Its powers of length and angle.
    pub dim: Dimension,
}

impl Number {
    /// A number without a unit.
    #[must_use]
    pub fn bare(value: f64) -> Self {
        Self { value, dim: Dimension::NONE }
    }

    /// A number of which nobody has said what it measures, such as a coordinate.
    #[must_use]
    pub fn open(value: f64) -> Self {
        Self { value, dim: Dimension::OPEN }
    }

    /// An angle in radians.
    #[must_use]
    pub fn angle(value: f64) -> Self {
        Self { value, dim: Dimension::ANGLE }
    }

    /// The whole number it is, if it is one that an index can be.
    #[must_use]
    pub fn as_integer(self) -> Option<i64> {
        /// Up to here every whole number is a double: 2⁵³.
        const MOST: f64 = 9_007_199_254_740_992.0;
        (self.dim.is_bare() && self.value.fract() == 0.0 && self.value.abs() <= MOST)
            .then_some(self.value as i64)
    }
}

impl Number<Real> {
    /// The number alone.
    #[must_use]
    pub fn looked_at(&self) -> Number {
        Number { value: self.value.value(), dim: self.dim }
    }
}

/// The shortest text of the number in document units, without its unit; angles in degrees with it.
impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(None))
    }
}

impl Number {
    /// The shortest text that reads back; where the document's unit of length is given, with its unit.
    #[must_use]
    pub fn text(&self, unit: Option<&str>) -> String {
        if self.dim.is_angle() {
            return format!("{}deg", shortest_degrees(self.value));
        }
        let suffix = unit.and_then(|unit| self.dim.suffix(unit)).unwrap_or_default();
        format!("{}{suffix}", shortest(self.value))
    }
}

/// The shortest decimal text of `value` that reads back to the same bits; zero has no sign.
#[must_use]
pub fn shortest(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let mut buffer = ryu::Buffer::new();
    let text = buffer.format(value);
    text.strip_suffix(".0").unwrap_or(text).to_owned()
}

/// A measured number with six digits.
#[must_use]
pub fn rounded(value: f64) -> String {
    shortest(format!("{value:.5e}").parse().unwrap_or(value))
}

/// The fewest digits of degrees that read back to the same radians.
fn shortest_degrees(radians: f64) -> String {
    let degrees = radians * 180.0 / std::f64::consts::PI;
    (0..17)
        .filter_map(|digits| format!("{degrees:.digits$e}").parse::<f64>().ok())
        .find(|&candidate| radians_of(candidate).to_bits() == radians.to_bits())
        .map_or_else(|| shortest(degrees), shortest)
}

/// Degrees to radians, the one way in which literals are read.
#[must_use]
pub fn radians_of(degrees: f64) -> f64 {
    degrees * std::f64::consts::PI / 180.0
}

#[cfg(test)]
mod tests {
    use super::{Dimension, Number, radians_of, shortest};

    #[test]
    fn degrees_print_as_they_were_written() {
        for text in ["30", "45", "90", "0.1", "12.345", "359.9", "-60", "1e-7"] {
            let degrees: f64 = text.parse().unwrap();
            assert_eq!(Number::angle(radians_of(degrees)).to_string(), format!("{text}deg"));
        }
    }

    #[test]
    fn whole_numbers_print_without_a_point() {
        assert_eq!([3.0, -0.0, 0.1, 1e21].map(shortest), ["3", "0", "0.1", "1e21"]);
    }

    #[test]
    fn dimensions_speak() {
        let area = Dimension::LENGTH.power(2.0).unwrap();
        assert_eq!(area.to_string(), "an area");
        assert_eq!(area.power(0.5), Some(Dimension::LENGTH));
        assert_eq!(
            Dimension::NONE.over(Dimension::LENGTH).unwrap().to_string(),
            "a quantity in length^-1"
        );
        assert_eq!(Dimension::LENGTH.power(0.3), None);
    }

    #[test]
    fn what_is_open_stays_open_and_has_no_unit() {
        let (open, length, angle) = (Dimension::OPEN, Dimension::LENGTH, Dimension::ANGLE);
        assert_eq!(open.times(length), Some(open));
        assert_eq!(length.over(open), Some(open));
        assert_eq!(open.power(2.0), Some(open));
        assert_eq!(open.common(length), Some(open));
        assert_eq!(length.sum(open), Some(open));
        assert_eq!(open.unit("mm"), None);
        let turn = open.times(angle).unwrap();
        assert!(turn.is_angle() && turn.length_power().is_none());
        assert_eq!(turn.unit("mm").as_deref(), Some("rad"));
        assert_eq!(turn.common(length), None);
    }

    #[test]
    fn an_angle_is_added_to_nothing_without_one() {
        let angle = Dimension::ANGLE;
        for bare in [Dimension::NONE, Dimension::OPEN] {
            assert_eq!(bare.sum(angle), None);
            assert!(bare.common(angle).is_some_and(Dimension::is_angle));
        }
        assert_eq!(angle.sum(angle), Some(angle));
    }

    #[test]
    fn numbers_are_told_with_their_unit() {
        let told =
            |value, powers| Number { value, dim: Dimension::of_powers(powers) }.text(Some("mm"));
        assert_eq!(told(12.4, [18, 0]), "12.4mm^3");
        assert_eq!(told(0.5, [-6, 0]), "0.5mm^-1");
        assert_eq!(told(2.0, [3, 6]), "2mm^(1/2)*1rad");
        assert_eq!(told(2.0, [0, 12]), "2rad^2");
        assert_eq!(Number::open(2.0).text(Some("mm")), "2");
    }
}
