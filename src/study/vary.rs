//! `NAME=FROM..TO:COUNT` and `NAME=A,B,C`: the values of one parameter in a grid.

use super::checksum::Checksum;
use crate::value::shortest;

/// A parameter with the values that it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct VariedParameter {
    /// The parameter.
    pub name: String,
    /// Its values, in order.
    pub values: VariedValues,
}

/// Values of a parameter, as a script or a setting writes them.
#[derive(Clone, Debug, PartialEq)]
pub enum VariedValues {
    /// These.
    List(Vec<String>),
    /// Evenly spaced ones, both ends among them. Each is made when it is asked for: they may be many.
    Spread {
        /// The first.
        start: f64,
        /// The last.
        end: f64,
        /// What all have behind them.
        unit: String,
        /// How many there are, 1 or more.
        n_values: u64,
    },
}

impl VariedValues {
    /// How many there are.
    #[must_use]
    pub fn count(&self) -> u64 {
        match self {
            Self::List(values) => values.len() as u64,
            Self::Spread { n_values, .. } => *n_values,
        }
    }

    /// The one of a number, from 0.
    #[must_use]
    pub fn get(&self, idx: u64) -> Option<String> {
        if self.count() <= idx {
            return None;
        }
        Some(match self {
            Self::List(values) => values[idx as usize].clone(),
            Self::Spread { start, end, unit, n_values } => {
                let (last, idx) = (n_values.saturating_sub(1).max(1) as f64, idx as f64);
                // So that 0..1:11 has 0.3, and both ends to the last digit.
                let value = ((last - idx) * start + idx * end) / last;
                format!("{}{unit}", shortest(value))
            }
        })
    }

    /// Adds to a sum what tells them from others, not each of them.
    pub(super) fn add_to(&self, sum: &mut Checksum) {
        sum.add_text(&self.count().to_string());
        match self {
            Self::List(values) => values.iter().for_each(|value| sum.add_text(value)),
            Self::Spread { start, end, unit, .. } => {
                let texts = [&shortest(*start), &shortest(*end), unit];
                texts.into_iter().for_each(|text| sum.add_text(text));
            }
        }
    }

    /// Those that stand for all: what a spread is made of differs in numbers alone.
    pub(super) fn kinds(&self) -> impl Iterator<Item = String> {
        let n_kinds = match self {
            Self::List(values) => values.len() as u64,
            Self::Spread { .. } => 1,
        };
        (0..n_kinds).filter_map(|idx| self.get(idx))
    }
}

/// Values of one parameter in a grid; a finer one is a plan in a file.
const MOST_VALUES: u64 = 10_000_000;

impl VariedParameter {
    /// Reads `neck=10mm..20mm:11` or `rise=15mm,20mm,25mm`.
    ///
    /// ```
    /// use virote::study::VariedParameter;
    ///
    /// let varied = VariedParameter::read("neck=10..12mm:5")?;
    /// assert_eq!(varied.values.count(), 5);
    /// assert_eq!(varied.values.get(1).as_deref(), Some("10.5mm"));
    /// # Ok::<(), String>(())
    /// ```
    ///
    /// # Errors
    /// What to write instead.
    pub fn read(text: &str) -> Result<Self, String> {
        let usage = "write NAME=FROM..TO:COUNT or NAME=A,B,C, for example neck=10mm..20mm:11";
        let Some((name, values)) = text.split_once('=') else { return Err(usage.to_owned()) };
        let name = name.trim();
        if name.is_empty() || values.trim().is_empty() {
            return Err(usage.to_owned());
        }
        let values = match values.split_once("..") {
            Some((from, rest)) => spread(name, from.trim_start(), rest.trim_end())?,
            // Blanks beside a comma belong to it.
            None if values.contains(',') => {
                let values: Vec<&str> = values.split(',').map(str::trim).collect();
                if values.contains(&"") {
                    return Err(format!("`{name}` has an empty value; {usage}"));
                }
                VariedValues::List(values.into_iter().map(str::to_owned).collect())
            }
            None => VariedValues::List(vec![values.to_owned()]),
        };
        Ok(Self { name: name.to_owned(), values })
    }
}

/// Evenly spaced values, both ends among them.
fn spread(name: &str, from: &str, rest: &str) -> Result<VariedValues, String> {
    let Some((to, count)) = rest.rsplit_once(':') else {
        return Err(format!("say how many values there are: `{name}={from}..{rest}:11`"));
    };
    let n_values = count.trim().replace('_', "").parse::<u64>().ok();
    let n_values = n_values.filter(|n| (1..=MOST_VALUES).contains(n)).ok_or_else(|| {
        format!("`{count}` is no count of values; it is a whole number from 1 to {MOST_VALUES}")
    })?;
    let [(start, start_unit), (end, end_unit)] =
        [from, to].map(|text| number_and_unit(text.trim()));
    let wrong = |text: &str| format!("`{text}` is no number such as `10` or `10mm`");
    let start = start.ok_or_else(|| wrong(from))?;
    let end = end.ok_or_else(|| wrong(to))?;
    let unit = match (start_unit, end_unit) {
        (a, b) if a == b => a,
        ("", unit) | (unit, "") => unit,
        (a, b) => {
            return Err(format!("`{name}` begins in {a} and ends in {b}; write both in one unit"));
        }
    };
    if n_values == 1 && start < end {
        return Err(format!("one value cannot be both {from} and {to}; write `{name}={from}`"));
    }
    Ok(VariedValues::Spread { start, end, unit: unit.to_owned(), n_values })
}

/// All combinations; the last list runs fastest.
pub(super) fn combinations(
    values: &[VariedValues],
) -> impl Iterator<Item = Vec<Option<String>>> + Send + '_ {
    let n_all: u64 = values.iter().map(VariedValues::count).product();
    (0..n_all).map(move |number| {
        let mut left = number;
        let mut cells: Vec<Option<String>> = Vec::with_capacity(values.len());
        for list in values.iter().rev() {
            cells.push(list.get(left % list.count()));
            left /= list.count();
        }
        cells.reverse();
        cells
    })
}

/// `15mm` as 15 and `mm`; no number where there is none before the unit.
pub(super) fn number_and_unit(text: &str) -> (Option<f64>, &str) {
    let end = text.trim_end_matches(|c: char| c.is_alphabetic() || c == '°').len();
    let number = text[..end].trim().replace('_', "").parse::<f64>().ok();
    (number.filter(|number| number.is_finite()), text[end..].trim())
}

/// The same of units with a power: `5mm^2` as 5 and `mm^2`.
pub(super) fn number_and_power(text: &str) -> (Option<f64>, &str) {
    let base = text.split_once('^').map_or(text, |(base, _)| base);
    let (number, unit) = number_and_unit(base);
    (number, text[base.len() - unit.len()..].trim())
}

#[cfg(test)]
mod tests {
    use super::{VariedParameter, VariedValues, combinations};

    fn list(values: [&str; 2]) -> VariedValues {
        VariedValues::List(values.map(str::to_owned).into())
    }

    #[test]
    fn the_last_parameter_varies_fastest() {
        let values = [list(["1", "2"]), list(["a", "b"])];
        let all: Vec<String> =
            combinations(&values).map(|cells| cells.into_iter().flatten().collect()).collect();
        assert_eq!(all, ["1a", "1b", "2a", "2b"]);
    }

    #[test]
    fn grids_are_read_and_mistakes_told() {
        let values = |text: &str| {
            VariedParameter::read(text).map(|VariedParameter { values, .. }| {
                let all = (0..values.count()).filter_map(|idx| values.get(idx));
                all.collect::<Vec<_>>().join(" ")
            })
        };
        assert_eq!(values("n=1..4:4"), Ok("1 2 3 4".to_owned()));
        assert_eq!(values("x=0..1:11").unwrap_or_default().split(' ').nth(3), Some("0.3"));
        assert_eq!(values("x = -5deg .. 5deg : 3"), Ok("-5deg 0deg 5deg".to_owned()));
        assert_eq!(values("shape=flat, round"), Ok("flat round".to_owned()));
        assert_eq!(values("shape= flat "), Ok(" flat ".to_owned()));
        assert_eq!(values("x=20..10:2"), Ok("20 10".to_owned()));
        for (text, told) in [
            ("neck", "NAME=FROM..TO:COUNT"),
            ("neck=", "NAME=FROM..TO:COUNT"),
            ("neck=1..2", "say how many values there are: `neck=1..2:11`"),
            ("neck=1..2:x", "`x` is no count of values"),
            ("neck=1..2:0", "`0` is no count of values"),
            ("neck=1..2:1", "one value cannot be both 1 and 2"),
            ("neck=1mm..2deg:3", "`neck` begins in mm and ends in deg"),
            ("neck=a..2:3", "`a` is no number"),
            ("neck=1,,2", "`neck` has an empty value"),
        ] {
            let err = values(text).expect_err(text);
            assert!(err.contains(told), "{text}: {err}");
        }
    }
}
