//! Values as text with so many digits, or in a unit: what `format` and `{x:.3mm}` show.

use glam::DVec3;

use super::{Number, Value, radians_of, rounded_to, shortest, unit::UnitText};
use crate::diag::{Code, Diagnostic, Span};

/// Digits behind the point that a number may be written with.
const MOST_DIGITS: usize = 100;

/// How numbers are written.
#[derive(Clone, Debug)]
pub struct NumberFormat {
    /// Digits behind the point; as many as it needs where none.
    digits: Option<usize>,
    /// The unit that they are told in, with its name.
    unit: Option<(String, UnitText)>,
    /// The document's unit of length, for numbers whose unit is not chosen.
    length: &'static str,
}

/// Why a value is not written so: a sentence, and what to do.
#[derive(Clone, Debug)]
pub struct FormatRefusal {
    /// The kind of mistake.
    pub code: Code,
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub hint: &'static str,
}

impl FormatRefusal {
    /// The refusal at its place.
    #[must_use]
    pub fn at(self, span: Span) -> Box<Diagnostic> {
        Box::new(Diagnostic::error(self.code, span, self.message).hint(self.hint))
    }
}

impl NumberFormat {
    /// A format of so many digits and a unit, in a document whose unit of length is `length`.
    ///
    /// # Errors
    /// A unit that is none, or more digits than there may be.
    pub fn new(
        digits: Option<usize>,
        unit: Option<&str>,
        length: &'static str,
    ) -> Result<Self, FormatRefusal> {
        if let Some(digits) = digits.filter(|&digits| MOST_DIGITS < digits) {
            return Err(FormatRefusal {
                code: Code::Domain,
                message: format!("{digits} digits behind the point; there may be {MOST_DIGITS}"),
                hint: "without a number of digits all that matter are written",
            });
        }
        let read = |text: &str| {
            UnitText::read(text, length).filter(|unit| !unit.dim().is_none()).ok_or_else(|| {
                FormatRefusal {
                    code: Code::UnknownUnit,
                    message: format!("`{text}` is no unit that a number could be told in"),
                    hint: "a format is `.3` for digits behind the point, a unit such as `mm`, `m^2`, `1/m` or `deg`, or both, as in `.1mm`",
                }
            })
        };
        let unit = unit.map(|text| Ok((text.to_owned(), read(text)?))).transpose()?;
        Ok(Self { digits, unit, length })
    }

    /// A value with its numbers in this format; texts stay as they are.
    ///
    /// # Errors
    /// A number of another dimension than the unit, or a value that has no numbers to write.
    pub fn text(&self, value: &Value) -> Result<String, FormatRefusal> {
        let all = |items: &mut dyn Iterator<Item = Result<String, FormatRefusal>>| {
            items.collect::<Result<Vec<_>, _>>().map(|items| items.join(", "))
        };
        match value {
            Value::Number(number) => self.number(*number),
            Value::Jet(_) | Value::JetPoint(_) | Value::JetRange(_) => {
                self.text(&value.looked_at())
            }
            Value::Point(point) => self.point(*point),
            Value::List(items) => {
                Ok(format!("[{}]", all(&mut items.iter().map(|item| self.text(item)))?))
            }
            Value::Record(record) => {
                let field = |(label, value): (&str, &Value)| {
                    self.text(value).map(|text| format!("{label}: {text}"))
                };
                Ok(format!("{{{}}}", all(&mut record.iter().map(field))?))
            }
            Value::Text(text) => Ok(text.to_string()),
            Value::Bool(_) | Value::None => Ok(value.to_string()),
            other => Err(FormatRefusal {
                code: Code::WrongKind,
                message: format!("{} has no digits and no unit", other.phrase()),
                hint: "numbers have, and points, lists and records of them",
            }),
        }
    }

    fn point(&self, point: DVec3) -> Result<String, FormatRefusal> {
        let [x, y, z] = point.to_array().map(|part| self.number(Number::open(part)));
        Ok(format!("({}, {}, {})", x?, y?, z?))
    }

    fn number(&self, number: Number) -> Result<String, FormatRefusal> {
        let Some((name, unit)) = &self.unit else {
            return Ok(match self.digits {
                None => number.text(Some(self.length)),
                Some(_) if number.dim.is_angle() => {
                    format!("{}deg", self.digits(number.value / radians_of(1.0)))
                }
                Some(_) => {
                    let suffix = number.dim.suffix(self.length).unwrap_or_default();
                    format!("{}{suffix}", self.digits(number.value))
                }
            });
        };
        let fits = number.dim == unit.dim()
            || number.dim.is_angle() && unit.dim().is_angle()
            || number.dim.is_bare() && !unit.has_angle();
        if fits {
            // `8.1 1/m`: a unit that begins with a digit stands apart.
            let gap = if name.starts_with(|c: char| c.is_ascii_digit()) { " " } else { "" };
            let value = match self.digits {
                None => unit.shortest_in(number.value),
                Some(_) => unit.in_this_unit(number.value),
            };
            return Ok(format!("{}{gap}{name}", self.digits(value)));
        }
        Err(FormatRefusal {
            code: Code::UnitMismatch,
            message: format!("{} is not told in `{name}`, which is for {}", number.dim, unit.dim()),
            hint: "a product with a unit such as `1mm` or `1deg` gives a number its dimension",
        })
    }

    /// The number alone; what is written as zero has no sign.
    fn digits(&self, value: f64) -> String {
        let Some(digits) = self.digits else { return shortest(value) };
        // As `round` does it: `2.675` has three digits for who reads it, whatever its bits are.
        let rounded = i64::try_from(digits).map_or(value, |digits| rounded_to(value, digits));
        let text = format!("{rounded:.digits$}");
        match text.strip_prefix('-') {
            Some(rest) if rest.bytes().all(|byte| matches!(byte, b'0' | b'.')) => rest.to_owned(),
            _ => text,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{NumberFormat, Value};
    use crate::value::{Dimension, IntoValue, Number, radians_of};

    fn text(digits: Option<usize>, unit: Option<&str>, value: Value) -> String {
        let format = NumberFormat::new(digits, unit, "mm");
        format.and_then(|format| format.text(&value)).unwrap_or_else(|refusal| refusal.message)
    }

    #[test]
    fn digits_stand_behind_the_point() {
        let of = |value: f64, digits| text(Some(digits), None, Value::number(value));
        assert_eq!(of(7.7654, 3), "7.765");
        assert_eq!(of(2.0, 2), "2.00");
        assert_eq!(of(2.5, 0), "3");
        assert_eq!(of(-0.125, 2), "-0.13");
        assert_eq!(of(1.005, 2), "1.01");
        assert_eq!(of(f64::MAX, 1), format!("{:.1}", f64::MAX));
        assert_eq!(of(-0.0004, 3), "0.000");
        assert_eq!(of(-0.0006, 3), "-0.001");
        assert_eq!(of(1e21, 0), "1000000000000000000000");
    }

    #[test]
    fn units_are_told_behind_the_number() {
        let length = |value| Number { value, dim: Dimension::LENGTH }.into_value();
        assert_eq!(text(None, Some("m"), length(1250.0)), "1.25m");
        assert_eq!(text(Some(1), Some("in"), length(25.4)), "1.0in");
        assert_eq!(text(None, Some("cm"), Value::number(12.0)), "1.2cm");
        assert_eq!(
            text(Some(0), Some("deg"), Number::angle(radians_of(30.0)).into_value()),
            "30deg"
        );
        assert_eq!(text(Some(1), None, Number::angle(radians_of(30.0)).into_value()), "30.0deg");
        assert_eq!(text(None, Some("m^3"), Value::number(2e9)), "2m^3");
        assert!(text(None, Some("deg"), length(1.0)).contains("a length is not told in `deg`"));
        assert!(text(None, Some("deg"), Value::number(1.0)).contains("is not told in `deg`"));
        assert!(text(None, Some("kg"), Value::number(1.0)).contains("`kg` is no unit"));
    }
}
