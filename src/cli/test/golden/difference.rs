//! Where a golden file and what the script says or writes now are not the same.

use serde_json::{Value as Json, json};

/// Differences of one file that are told one by one.
pub(super) const MOST_TOLD: usize = 8;

/// Characters of a line that are shown.
const MOST_CHARS: usize = 120;

/// Characters before the first that differs, where a line is too long to be shown.
const CHARS_BEFORE: usize = 40;

/// A difference, in the words of whoever reads the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::cli::test) struct Difference {
    /// The file, below the folder of the script.
    pub(super) file: String,
    /// Where in it, or what is wrong with the whole of it.
    pub(super) place: String,
    /// What stands in the golden file.
    pub(super) expected: Option<String>,
    /// What is there now.
    pub(super) found: Option<String>,
}

impl Difference {
    /// One that is told in a sentence.
    pub(super) fn of_whole(place: impl Into<String>) -> Self {
        Self { file: String::new(), place: place.into(), expected: None, found: None }
    }

    /// One of two texts; of long lines the part is shown where they differ.
    pub(super) fn of_texts(place: impl Into<String>, expected: &str, found: &str) -> Self {
        let is_same = |(a, b): &(char, char)| a == b;
        let n_same = expected.chars().zip(found.chars()).take_while(is_same).count();
        let shown = |text: &str| Some(excerpt(text, n_same));
        Self {
            file: String::new(),
            place: place.into(),
            expected: shown(expected),
            found: shown(found),
        }
    }

    /// The same in a file.
    pub(super) fn in_file(self, file: &str) -> Self {
        Self { file: file.to_owned(), ..self }
    }

    /// For people.
    pub(in crate::cli::test) fn text(&self) -> String {
        let side = |word: &str, text: &Option<String>| match text {
            Some(text) => format!("\n    {word:<9} {}", text.replace('\n', "\n              ")),
            None => String::new(),
        };
        let sides = side("expected", &self.expected) + &side("found", &self.found);
        format!("{}: {}{sides}", self.file, self.place)
    }

    /// For programs.
    pub(in crate::cli::test) fn json(&self) -> Json {
        json!({
            "file": self.file,
            "place": self.place,
            "expected": self.expected,
            "found": self.found,
        })
    }
}

/// The lines of a text as far as they are shown around its character `at`.
fn excerpt(text: &str, at: usize) -> String {
    if text.chars().count() <= MOST_CHARS || text.contains('\n') {
        return text.to_owned();
    }
    let n_left_out = at.saturating_sub(CHARS_BEFORE);
    let shown: String = text.chars().skip(n_left_out).take(MOST_CHARS).collect();
    let is_cut = n_left_out + MOST_CHARS < text.chars().count();
    format!("{}{shown}{}", if 0 < n_left_out { "..." } else { "" }, if is_cut { "..." } else { "" })
}
