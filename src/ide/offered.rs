//! What is sent of many completions: those that the word under way could become.

use crate::kernel::sorting::sort_by_key;

use super::Completion;

/// Of completions in their order those that the word `typed` could become, at most so many; whether they are all.
///
/// Whoever types a few letters of a name means it: `wdt` and `wid` both mean `width`. Where there are too many, those
/// that begin with the word stay.
///
/// ```
/// use virote::{ide::{Document, offered}, session::Session, value::NoFiles};
///
/// let session = Session::default();
/// let text = "let width = 1\nlet depth = 2\nlet c = wdt";
/// let document = Document::new(&session, "demo.geo", text, &NoFiles);
/// let all = document.completions(&session, None, &|_| Vec::new(), text.len());
/// let (some, is_whole) = offered(all, "wdt", 100);
/// assert!(!is_whole && some.iter().any(|one| one.label == "width") && !some.iter().any(|one| one.label == "depth"));
/// ```
#[must_use]
pub fn offered(found: Vec<Completion>, typed: &str, most: usize) -> (Vec<Completion>, bool) {
    let n_found = found.len();
    let typed = typed.to_lowercase();
    let mut meant: Vec<(bool, Completion)> = Vec::new();
    for one in found {
        let label = one.label.to_lowercase();
        if is_within(&typed, &label) {
            meant.push((!label.trim_start_matches('"').starts_with(&typed), one));
        }
    }
    if most < meant.len() {
        // Sorting keeps the order of what is alike.
        sort_by_key(&mut meant, |(is_inside, _)| *is_inside);
        meant.truncate(most);
    }
    let is_whole = meant.len() == n_found;
    (meant.into_iter().map(|(_, one)| one).collect(), is_whole)
}

/// Whether the letters of one word stand in another, in their order.
fn is_within(letters: &str, word: &str) -> bool {
    let mut rest = word.chars();
    letters.chars().all(|letter| rest.any(|c| c == letter))
}
