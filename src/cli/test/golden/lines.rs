//! Texts line by line, with numbers within a tolerance.

use super::difference::{Difference, MOST_TOLD};

/// Lines of a text that gained or lost some that are shown.
const MOST_LINES: usize = 6;

/// By how much numbers may differ, as a fraction of the larger one or of 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct RelativeTolerance(pub(super) f64);

impl RelativeTolerance {
    /// Whether two numbers are one result.
    pub(super) fn joins(self, a: f64, b: f64) -> bool {
        (a - b).abs() <= self.0 * a.abs().max(b.abs()).max(1.0)
    }

    /// Whether two texts differ in nothing but numbers, and in these by no more than the tolerance.
    pub(super) fn joins_texts(self, a: &str, b: &str) -> bool {
        if a == b {
            return true;
        }
        let (mut a, mut b) = (pieces(a), pieces(b));
        loop {
            match (a.next(), b.next()) {
                (None, None) => return true,
                (Some(LinePart::Number(a)), Some(LinePart::Number(b))) if self.joins(a, b) => {}
                (Some(LinePart::Text(a)), Some(LinePart::Text(b))) if a == b => {}
                _ => return false,
            }
        }
    }
}

/// Where two texts differ.
pub(super) fn differences(
    expected: &str,
    found: &str,
    tolerance: RelativeTolerance,
) -> Vec<Difference> {
    let (expected, found): (Vec<&str>, Vec<&str>) =
        (expected.lines().collect(), found.lines().collect());
    let joins = |(a, b): &(&&str, &&str)| tolerance.joins_texts(a, b);
    if expected.len() == found.len() {
        let pairs = expected.iter().zip(&found).enumerate();
        let mut apart = pairs.filter(|(_, pair)| !joins(pair));
        let told = |(i, (a, b)): (usize, (&&str, &&str))| {
            Difference::of_texts(format!("line {}", i + 1), a, b)
        };
        let mut told: Vec<Difference> = apart.by_ref().take(MOST_TOLD).map(told).collect();
        let n_more = apart.count();
        if 0 < n_more {
            told.push(Difference::of_whole(format!("and {n_more} more lines")));
        }
        return told;
    }
    let n_before = expected.iter().zip(&found).take_while(joins).count();
    let most_after = expected.len().min(found.len()) - n_before;
    let backwards = expected.iter().rev().zip(found.iter().rev());
    let n_after = backwards.take(most_after).take_while(joins).count();
    let part = |lines: &[&str]| shown(&lines[n_before..lines.len() - n_after]);
    vec![Difference {
        expected: part(&expected),
        found: part(&found),
        ..Difference::of_whole(format!(
            "from line {}: {} lines in all, {} were expected",
            n_before + 1,
            found.len(),
            expected.len()
        ))
    }]
}

/// The first of some lines; none of none.
fn shown(lines: &[&str]) -> Option<String> {
    let n_more = lines.len().saturating_sub(MOST_LINES);
    let mut text = lines.get(..MOST_LINES.min(lines.len()))?.join("\n");
    if 0 < n_more {
        text += &format!("\n... and {n_more} more lines");
    }
    (!lines.is_empty()).then_some(text)
}

/// A part of a line.
#[derive(Debug, PartialEq)]
enum LinePart<'a> {
    Number(f64),
    Text(&'a str),
}

/// A line as numbers and what stands between them. A digit within a word is part of the word.
fn pieces(mut line: &str) -> impl Iterator<Item = LinePart<'_>> {
    // What stands before decides whether a sign or a digit begins a number.
    let mut is_in_word = false;
    std::iter::from_fn(move || {
        if line.is_empty() {
            return None;
        }
        if !is_in_word && let Some(length) = number(line) {
            let (text, rest) = line.split_at(length);
            (line, is_in_word) = (rest, true);
            // What is spelled as a number is one; those beyond an f64 are infinite and unequal.
            return Some(text.parse().map_or(LinePart::Text(text), LinePart::Number));
        }
        let mut end = 0;
        for (i, character) in line.char_indices() {
            if 0 < i && !is_in_word && number(&line[i..]).is_some() {
                break;
            }
            is_in_word = character.is_alphanumeric() || matches!(character, '_' | '.' | ')' | ']');
            end = i + character.len_utf8();
        }
        let (text, rest) = line.split_at(end);
        line = rest;
        Some(LinePart::Text(text))
    })
}

/// The length of the number that the text begins with: digits with a sign, a point, an exponent.
fn number(text: &str) -> Option<usize> {
    let bytes = text.as_bytes();
    let digits =
        |from: usize| bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let sign = usize::from(matches!(bytes.first(), Some(b'-' | b'+')));
    let mut end = sign + digits(sign);
    let mut n_digits = end - sign;
    if bytes.get(end) == Some(&b'.') {
        let n_decimals = digits(end + 1);
        // The point of `1..3` is none of the number's.
        if 0 < n_decimals || bytes.get(end + 1) != Some(&b'.') && 0 < n_digits {
            end += 1 + n_decimals;
            n_digits += n_decimals;
        }
    }
    if n_digits == 0 {
        return None;
    }
    if let Some(b'e' | b'E') = bytes.get(end) {
        let signed = end + 1 + usize::from(matches!(bytes.get(end + 1), Some(b'-' | b'+')));
        let n_power = bytes.get(signed..).map_or(0, |_| digits(signed));
        if 0 < n_power {
            end = signed + n_power;
        }
    }
    Some(end)
}

#[cfg(test)]
mod tests {
    use super::{RelativeTolerance, differences};

    #[track_caller]
    fn check(a: &str, b: &str, tolerance: f64, expected: bool) {
        assert_eq!(RelativeTolerance(tolerance).joins_texts(a, b), expected, "{a:?} and {b:?}");
        assert_eq!(RelativeTolerance(tolerance).joins_texts(b, a), expected, "{b:?} and {a:?}");
    }

    #[test]
    fn numbers_agree_within_the_tolerance() {
        check("x = 1.0", "x = 1", 0.0, true);
        check("x = 1", "x = 1.001", 0.001, true);
        check("x = 1", "x = 1.0021", 0.001, false);
        check("x = 1000", "x = 1000.9", 0.001, true);
        check("x = -1e-9", "x = 1e-9", 1e-8, true);
        check("(1.5e3, -2)", "(1500, -2.0)", 0.0, true);
        check("x = .5", "x = 0.5", 0.0, true);
        check("p = [1, 2]", "p = [1, 2, 3]", 1.0, false);
        check("1.", "1", 0.0, true);
    }

    #[test]
    fn words_agree_to_the_letter() {
        check("a1 = 2", "a2 = 2", 1.0, false);
        check("E0501", "E0502", 1.0, false);
        check("x = 1 mm", "x = 1 cm", 1.0, false);
        check("x = true", "x = 1", 1.0, false);
        check("inf", "nan", 1.0, false);
        check("1e999", "1e998", 1.0, false);
        // A sign behind a number is a sign of subtraction.
        check("3-2", "3 -2", 1.0, false);
        check("a-2", "a-2.0", 0.0, true);
        check("1..3", "1..3", 0.0, true);
        check("héllo 1é", "héllo 2é", 0.0, false);
    }

    #[test]
    fn differences_name_their_lines() {
        let found =
            differences("a = 1\nb = 2\nc = 3\n", "a = 1\nb = 5\nc = 3\n", RelativeTolerance(0.0));
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].text(), ": line 2\n    expected  b = 2\n    found     b = 5");
        let found = differences("a = 1\nc = 3\n", "a = 1\nb = 2\nc = 3\n", RelativeTolerance(0.0));
        assert_eq!(
            found[0].text(),
            ": from line 2: 3 lines in all, 2 were expected\n    found     b = 2"
        );
        assert_eq!(differences("", "", RelativeTolerance(0.0)), []);
    }
}
