//! What a run came to, as an editor shows it: values with units, claims with margins.

use std::{
    collections::{BTreeMap, HashMap},
    ops::Range,
    sync::Arc,
};

use super::{Document, measured::measured};
use crate::{
    diag::{Diagnostic, Span},
    eval::{Checked, Defined},
    session::{Event, Report, TestReport},
    value::{Number, Value, rounded},
};

/// Characters of a value that stand on one line.
const MOST_CHARS: usize = 80;
/// Elements of a list that are shown.
const MOST_ELEMENTS: usize = 8;

/// The last run of a script.
#[derive(Debug)]
pub struct Values {
    report: Arc<Report>,
    /// What tests of the same text came to, as far as they were run, by the places of their names.
    tested: BTreeMap<Span, (Arc<Report>, usize)>,
    /// The numbers of the definitions, by name.
    numbers: HashMap<String, usize>,
}

impl Values {
    /// The values of a report.
    #[must_use]
    pub fn new(report: Arc<Report>) -> Self {
        let names = report.definitions.iter().enumerate();
        let numbers = names.map(|(idx, defined)| (defined.name.clone(), idx)).collect();
        Self { report, tested: BTreeMap::new(), numbers }
    }

    /// Takes in the report of tests of the same text.
    pub fn take_tests(&mut self, report: &Arc<Report>) {
        for (idx, test) in report.tests.iter().enumerate() {
            self.tested.insert(test.span, (Arc::clone(report), idx));
        }
    }

    /// What the test whose name stands at a place came to, if it was run.
    #[must_use]
    pub fn tested(&self, place: &Range<usize>) -> Option<&TestReport> {
        let (report, idx) = self.tested.get(&Span::new(place.start as u32, place.end as u32))?;
        report.tests.get(*idx)
    }

    /// The findings of the last run, and those of the tests that were run since.
    #[must_use]
    pub fn findings(&self) -> Vec<&Diagnostic> {
        let mut found: Vec<&Diagnostic> = self.report.diagnostics.iter().collect();
        for (report, _) in self.tested.values() {
            for other in &report.diagnostics {
                let is_it = |known: &&Diagnostic| {
                    (known.code, known.primary.span, &known.message)
                        == (other.code, other.primary.span, &other.message)
                };
                if !found.iter().any(is_it) {
                    found.push(other);
                }
            }
        }
        found
    }

    /// Puts what a part of the text came to into the place of what the names in it had, at the end what is new;
    /// some names are `lost`. Whether it can be done, which needs that nobody else has the report, is what it
    /// returns.
    #[cfg(feature = "cli")]
    pub(crate) fn take_in(&mut self, part: &Report, lost: &[String]) -> bool {
        let Some(report) = Arc::get_mut(&mut self.report) else { return false };
        let mut leaving: Vec<usize> =
            lost.iter().filter_map(|name| self.numbers.remove(name)).collect();
        leaving.sort_unstable();
        if let Some(&first) = leaving.first() {
            let mut number = 0;
            report.definitions.retain(|_| {
                number += 1;
                leaving.binary_search(&(number - 1)).is_err()
            });
            let later = self.numbers.values_mut().filter(|number| first < **number);
            later.for_each(|number| *number -= leaving.partition_point(|left| left < number));
        }
        for defined in &part.definitions {
            match self.numbers.get(&defined.name) {
                Some(&number) => report.definitions[number] = defined.clone(),
                None => {
                    self.numbers.insert(defined.name.clone(), report.definitions.len());
                    report.definitions.push(defined.clone());
                }
            }
        }
        true
    }

    /// What the run came to.
    #[must_use]
    pub fn report(&self) -> &Arc<Report> {
        &self.report
    }

    /// Whether they are of this very text.
    #[must_use]
    pub fn are_of(&self, document: &Document) -> bool {
        self.report.sources.iter().next().is_some_and(|source| source.text == *document.text())
    }

    /// The value of a definition of the script.
    #[must_use]
    pub fn value(&self, name: &str) -> Option<&Value> {
        self.defined(name)?.value.as_ref()
    }

    /// A definition of the script.
    pub(crate) fn defined(&self, name: &str) -> Option<&Defined> {
        Some(&self.report.definitions[*self.numbers.get(name)?])
    }

    /// The claim at a place of the script.
    #[must_use]
    pub fn checked(&self, place: &Range<usize>) -> Option<&Checked> {
        let span = Span::new(place.start as u32, place.end as u32);
        let of_tests = self.tested.values().filter_map(|(report, idx)| report.tests.get(*idx));
        let of_tests = of_tests.flat_map(|test| &test.events);
        self.report.events.iter().chain(of_tests).find_map(|event| match event {
            Event::Checked(checked) if checked.span == span => Some(checked),
            _ => None,
        })
    }

    /// A value in a few words, with its unit: `27.2 mm`, `curve of degree 3 with 7 control points on
    /// 0..1, length 124.6 mm`.
    #[must_use]
    pub fn description(&self, value: &Value) -> String {
        let unit = self.report.document.0.name();
        let text = brief(value, unit).unwrap_or_else(|| sized(value));
        format!("{text}{}", measured(value, unit))
    }

    /// A value that fits behind its definition; none where it has no short form.
    #[must_use]
    pub fn brief(&self, value: &Value) -> Option<String> {
        brief(value, self.report.document.0.name())
    }
}

/// A number with six digits and its unit.
fn number(number: &Number, unit: &str) -> String {
    if number.dim.is_angle() {
        return format!("{}deg", rounded(number.value.to_degrees()));
    }
    let unit = number.dim.unit(unit).map(|unit| format!(" {unit}")).unwrap_or_default();
    format!("{}{unit}", rounded(number.value))
}

/// The value itself where it is small and can be written on a line.
fn brief(value: &Value, unit: &'static str) -> Option<String> {
    let text = match value {
        Value::Number(one) => number(one, unit),
        Value::Point(point) => {
            let [x, y, z] = [point.x, point.y, point.z].map(rounded);
            format!("({x}, {y}, {z})")
        }
        Value::None | Value::Bool(_) => value.to_string(),
        Value::Range(_) => value.in_unit(unit).to_string(),
        Value::Text(text) if text.len() <= MOST_CHARS => value.to_string(),
        Value::List(items) if items.len() <= MOST_ELEMENTS => {
            let items: Option<Vec<String>> = items.iter().map(|item| brief(item, unit)).collect();
            format!("[{}]", items?.join(", "))
        }
        Value::Record(record) => {
            let fields: Option<Vec<String>> = record
                .iter()
                .map(|(label, value)| Some(format!("{label}: {}", brief(value, unit)?)))
                .collect();
            format!("{{{}}}", fields?.join(", "))
        }
        _ => return None,
    };
    (text.chars().count() <= MOST_CHARS).then_some(text)
}

/// Kind and size.
pub(crate) fn sized(value: &Value) -> String {
    match value {
        Value::Record(record) => {
            let labels: Vec<&str> = record.iter().map(|(label, _)| label).collect();
            format!("record of {}", labels.join(", "))
        }
        Value::List(_) => value.phrase().trim_start_matches("a ").to_owned(),
        Value::Text(text) => format!("string of {} bytes", text.len()),
        _ => value.to_string(),
    }
}
