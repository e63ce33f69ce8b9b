//! Names as XML can hold them. W3C, *Extensible Markup Language 1.0*, fifth edition, §2.2 and §2.3.

use std::collections::HashSet;

/// Identifiers that were given: each stands once in a document.
#[derive(Default)]
pub(super) struct Ids(HashSet<String>);

impl Ids {
    /// A name as an identifier that no other has: what a name of XML cannot hold becomes a point or a
    /// hyphen, and a number tells those apart that look alike then.
    pub(super) fn next(&mut self, name: &str) -> String {
        let plain = id(name);
        let mut id = plain.clone();
        let mut n_alike = self.0.len();
        while !self.0.insert(id.clone()) {
            n_alike += 1;
            id = format!("{plain}-{n_alike}");
        }
        id
    }
}

fn id(name: &str) -> String {
    let mut id = String::with_capacity(name.len());
    for c in name.chars() {
        match c {
            ']' => {}
            '[' => id.push('.'),
            c if begins_name(c) || c.is_ascii_digit() || "-.\u{b7}".contains(c) => id.push(c),
            _ => id.push('-'),
        }
    }
    if id.starts_with(begins_name) { id } else { format!("_{id}") }
}

/// Whether a name may begin with it (production 4), but for the colon of name spaces.
fn begins_name(c: char) -> bool {
    matches!(c,
        'A'..='Z' | '_' | 'a'..='z' | '\u{c0}'..='\u{d6}' | '\u{d8}'..='\u{f6}'
        | '\u{f8}'..='\u{2ff}' | '\u{370}'..='\u{37d}' | '\u{37f}'..='\u{1fff}'
        | '\u{200c}'..='\u{200d}' | '\u{2070}'..='\u{218f}' | '\u{2c00}'..='\u{2fef}'
        | '\u{3001}'..='\u{d7ff}' | '\u{f900}'..='\u{fdcf}' | '\u{fdf0}'..='\u{fffd}'
        | '\u{10000}'..='\u{effff}')
}

/// Text as XML can hold it: what it cannot is a space.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\u{fffe}' | '\u{ffff}' => out.push(' '),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{Ids, escaped};

    #[test]
    fn identifiers_hold_what_xml_allows_and_stand_once() {
        let mut ids = Ids::default();
        let found = ["hull[2]", "é漢", "2½", "a\nb\u{fffe}", "a b", "a-b", "a·b", "", "-"];
        let found = found.map(|name| ids.next(name));
        assert_eq!(found[..4], ["hull.2", "é漢", "_2-", "a-b-"]);
        let all: std::collections::HashSet<&String> = found.iter().collect();
        assert_eq!(all.len(), found.len(), "{found:?}");
    }

    #[test]
    fn text_holds_no_character_that_xml_forbids() {
        assert_eq!(
            escaped("<a & \"b\">\u{0}\u{fffe}\u{ffff}\n🦆"),
            "&lt;a &amp; &quot;b&quot;&gt;    🦆"
        );
    }
}
