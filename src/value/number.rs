//! Numbers with a dimension: powers of length and angle, carried along by every operator.
//!
//! Values are held in the document's unit of length and in radians, so that the arithmetic is
//! that of plain numbers and only the powers need care.

use std::fmt;

use super::Real;

/// Powers of length and angle, in sixths so that square and cube roots stay exact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Dimension {
    length: i8,
    angle: i8,
}

/// Sixths in one whole power.
pub(super) const WHOLE: i8 = 6;

impl Dimension {
    /// A bare number.
    pub const NONE: Self = Self { length: 0, angle: 0 };
    /// A length.
    pub const LENGTH: Self = Self { length: WHOLE, angle: 0 };
    /// An angle.
    pub const ANGLE: Self = Self { length: 0, angle: WHOLE };

    /// The dimension of these powers of length and angle, in sixths.
    #[must_use]
    pub fn of_powers([length, angle]: [i8; 2]) -> Self {
        Self { length, angle }
    }

    /// The powers of length and angle in sixths.
    #[must_use]
    pub fn powers(self) -> [i8; 2] {
        [self.length, self.angle]
    }

    /// Whether it is that of a bare number.
    #[must_use]
    pub fn is_none(self) -> bool {
        self == Self::NONE
    }

    /// The dimension of a product; `None` where a power leaves the range of ±21.
    #[must_use]
    pub fn times(self, other: Self) -> Option<Self> {
        Some(Self {
            length: self.length.checked_add(other.length)?,
            angle: self.angle.checked_add(other.angle)?,
        })
    }

    /// The dimension of a quotient.
    #[must_use]
    pub fn over(self, other: Self) -> Option<Self> {
        Some(Self {
            length: self.length.checked_sub(other.length)?,
            angle: self.angle.checked_sub(other.angle)?,
        })
    }

    /// The dimension raised to `exponent`; `None` where that is no sixth.
    #[must_use]
    pub fn power(self, exponent: f64) -> Option<Self> {
        let raise = |power: i8| {
            let raised = f64::from(power) * exponent;
            (raised.fract() == 0.0 && raised.abs() <= f64::from(i8::MAX)).then_some(raised as i8)
        };
        Some(Self { length: raise(self.length)?, angle: raise(self.angle)? })
    }

    /// The dimension of a cube root; `None` where that is no sixth.
    #[must_use]
    pub fn cube_root(self) -> Option<Self> {
        let third = |power: i8| (power % 3 == 0).then_some(power / 3);
        Some(Self { length: third(self.length)?, angle: third(self.angle)? })
    }

    /// The common dimension of two sides of a sum or comparison, where a bare number fits
    /// anything.
    #[must_use]
    pub fn common(self, other: Self) -> Option<Self> {
        match (self, other) {
            (a, b) if a == b => Some(a),
            (a, Self::NONE) => Some(a),
            (Self::NONE, b) => Some(b),
            _ => None,
        }
    }
}

impl Dimension {
    /// The unit of numbers as they are kept, in this unit of length and in radians: `mm`, `mm^2`,
    /// `rad`; none of a bare number.
    #[must_use]
    pub fn unit(self, length: &str) -> Option<String> {
        let powers = [(length, self.length), ("rad", self.angle)];
        let parts = powers.into_iter().filter(|&(_, power)| power != 0);
        let parts = parts.map(|(name, power)| format!("{name}{}", exponent(power)));
        (!self.is_none()).then(|| parts.collect::<Vec<_>>().join("·"))
    }
}

/// A power in sixths as it stands behind what is raised; nothing for 1.
fn exponent(power: i8) -> String {
    match (power % WHOLE, power / WHOLE) {
        (0, 1) => String::new(),
        (0, whole) => format!("^{whole}"),
        _ => format!("^({power}/{WHOLE})"),
    }
}

/// As a noun: `a length`, `an area`, `an angle`, `length^-1`.
impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let named = match (self.length, self.angle) {
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
        for (name, power) in [("length", self.length), ("angle", self.angle)] {
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
        (self.dim.is_none() && self.value.fract() == 0.0 && self.value.abs() <= MOST)
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

/// The shortest text that reads back; angles in degrees with their unit.
impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.dim == Dimension::ANGLE {
            write!(f, "{}deg", shortest_degrees(self.value))
        } else {
            f.write_str(&shortest(self.value))
        }
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
}
