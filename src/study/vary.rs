//! `NAME=FROM..TO:COUNT` and `NAME=A,B,C`: the values of one parameter in a grid.

use crate::value::shortest;

/// A parameter with the values that it takes, as a script or a setting writes them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VariedParameter {
    /// The parameter.
    pub name: String,
    /// Its values, in order.
    pub values: Vec<String>,
}

/// Values of one parameter in a grid; a finer one is a plan in a file.
const MOST_VALUES: usize = 10_000_000;

impl VariedParameter {
    /// Reads `neck=10mm..20mm:11` or `rise=15mm,20mm,25mm`.
    ///
    /// ```
    /// use virote::study::VariedParameter;
    ///
    /// let varied = VariedParameter::read("neck=10..12mm:5")?;
    /// assert_eq!(varied.values, ["10mm", "10.5mm", "11mm", "11.5mm", "12mm"]);
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
                values.split(',').map(|value| value.trim().to_owned()).collect()
            }
            None => vec![values.to_owned()],
        };
        if values.iter().any(String::is_empty) {
            return Err(format!("`{name}` has an empty value; {usage}"));
        }
        Ok(Self { name: name.to_owned(), values })
    }
}

/// Evenly spaced values, both ends among them.
fn spread(name: &str, from: &str, rest: &str) -> Result<Vec<String>, String> {
    let Some((to, count)) = rest.rsplit_once(':') else {
        return Err(format!("say how many values there are: `{name}={from}..{rest}:11`"));
    };
    let n_values = count.trim().replace('_', "").parse::<usize>().ok();
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
    let last = n_values.saturating_sub(1).max(1) as f64;
    // So that 0..1:11 has 0.3, and both ends to the last digit.
    let at = |i: usize| ((last - i as f64) * start + i as f64 * end) / last;
    Ok((0..n_values).map(|i| format!("{}{unit}", shortest(at(i)))).collect())
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
    use super::VariedParameter;

    #[test]
    fn grids_are_read_and_mistakes_told() {
        let values = |text: &str| VariedParameter::read(text).map(|varied| varied.values.join(" "));
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
