//! Layers of a DXF: names that scripts give, as the file can hold them.

use std::collections::HashSet;

use super::super::{Item, unique_values::UniqueValues};

/// The layers of a file by the names that scripts give them: how each is called in the file, and the
/// colour of what came first. Names that differ in their case alone are one, as everywhere in DXF; those
/// that differ in what the file cannot hold get a number.
pub(super) struct Layers {
    by_name: UniqueValues<String, (String, Option<[u8; 3]>)>,
}

impl Layers {
    /// The layer that every file has.
    const ZERO: &'static str = "0";

    pub(super) fn of(items: &[Item]) -> Self {
        let mut by_name: UniqueValues<String, _> = UniqueValues::default();
        by_name.entry(Self::ZERO, || (Self::ZERO.to_owned(), None));
        let mut taken = HashSet::from([Self::ZERO.to_owned()]);
        for item in items {
            let (key, held) = (key(item), as_held(layer(item)));
            by_name.entry(key.as_str(), || {
                let numbered = (2..).map(|n| format!("{held}_{n}"));
                let free = |name: &String| taken.insert(name.to_ascii_lowercase());
                let mut names = std::iter::once(held.clone()).chain(numbered);
                (names.find(free).unwrap_or_default(), item.color)
            });
        }
        Self { by_name }
    }

    /// How each layer is called in the file, with its colour.
    pub(super) fn all(&self) -> impl Iterator<Item = &(String, Option<[u8; 3]>)> {
        self.by_name.pairs().iter().map(|(_, layer)| layer)
    }

    /// How the layer of an item is called.
    pub(super) fn name(&self, item: &Item) -> &str {
        self.by_name.get(key(item).as_str()).map_or(Self::ZERO, |(name, _)| name)
    }
}

/// The layer of an item: its own, or the name of its definition; one without a name is that of all files.
fn layer(item: &Item) -> &str {
    let name = item.layer.as_deref().unwrap_or(&item.group);
    if name.trim().is_empty() { Layers::ZERO } else { name }
}

fn key(item: &Item) -> String {
    layer(item).to_ascii_lowercase()
}

/// A name as the file holds it: some characters are not allowed.
fn as_held(name: &str) -> String {
    let allowed = |c: char| if "<>/\\\":;?*|=`,".contains(c) { '_' } else { c };
    let name: String = name.chars().map(allowed).collect();
    readable(&name)
}

/// Text in the code page of the file; other characters by their number, and so those that begin such a
/// number or a control character, `^J`.
pub(super) fn readable(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if (c.is_ascii_graphic() || c == ' ') && !matches!(c, '\\' | '^') {
            out.push(c);
        } else if !c.is_control() && (c as u32) <= 0xFFFF {
            out.push_str(&format!("\\U+{:04X}", c as u32));
        } else {
            out.push('_');
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::{Item, Layers};
    use crate::export::Subject;

    #[test]
    fn names_that_differ_in_forbidden_characters_stay_apart() {
        let item = |name| Item::new(name, Subject::Point(DVec3::ZERO));
        let items = ["a:b", "a/b", "A:B", "", "a_b", "0", "é"].map(item);
        let layers = Layers::of(&items);
        let names: Vec<&str> = items.iter().map(|item| layers.name(item)).collect();
        assert_eq!(names, ["a_b", "a_b_2", "a_b", "0", "a_b_3", "0", "\\U+00E9"]);
        assert_eq!(layers.all().count(), 5);
    }
}
