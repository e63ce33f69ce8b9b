//! The language's own words, from the one text that tells of them: `docs/language.md`.
//!
//! A word is told by the sections that have it in their headings, else by the rows, list items and
//! paragraphs that have it as code, else by the paragraphs that use it.

/// The language, section by section, as Markdown.
pub const LANGUAGE: &str = include_str!("../../docs/language.md");

/// The name under which all of it is printed.
pub const TITLE: &str = "language";

/// Letters from which a word may be the beginning of a heading's.
const FEWEST_LETTERS: usize = 4;

/// Words of the language that are no names of built-ins, for "did you mean".
pub fn topics() -> impl Iterator<Item = &'static str> {
    let headings = LANGUAGE.lines().filter(|line| level(line).is_some());
    let headings = headings.flat_map(|line| line.split(|c: char| !c.is_alphabetic()));
    headings.filter(|word| FEWEST_LETTERS <= word.len()).chain([TITLE])
}

/// What the language says of a word, for a terminal; none where it says nothing.
#[must_use]
pub fn entry(word: &str) -> Option<String> {
    if word == TITLE {
        return Some(LANGUAGE.to_owned());
    }
    let found = about(word)?;
    Some(found.iter().map(|passage| shown(passage)).collect::<Vec<_>>().join("\n"))
}

/// The same as Markdown.
#[must_use]
pub fn markdown(word: &str) -> Option<String> {
    Some(about(word)?.join("\n"))
}

/// The passages about a word.
fn about(word: &str) -> Option<Vec<String>> {
    let word = word.to_lowercase();
    if word.split_whitespace().count() != 1 {
        return None;
    }
    let sections = sections();
    let titled: Vec<&HeadedSection<'_>> =
        sections.iter().filter(|section| section.has(&word)).collect();
    let coded = || passages(&sections, |text| in_code(text, &word));
    let plain = || passages(&sections, |text| words_of(text).any(|one| is_form_of(&one, &word)));
    let is_word = word.chars().any(char::is_alphabetic);
    let mut found = coded();
    if !titled.is_empty() {
        // The row of a statement, then its section.
        found.retain(|passage| passage.contains("| `"));
        found.extend(titled.iter().map(|section| section.text()));
    } else if found.is_empty() && is_word {
        found = plain();
    }
    (!found.is_empty()).then_some(found)
}

/// A heading with the paragraphs below it, down to the next heading.
struct HeadedSection<'a> {
    heading: &'a str,
    blocks: Vec<&'a str>,
}

impl HeadedSection<'_> {
    /// Whether the heading has the word, or one that begins with it.
    fn has(&self, word: &str) -> bool {
        words_of(self.heading).any(|one| is_form_of(&one, word))
    }

    fn text(&self) -> String {
        format!("{}\n\n{}\n", self.heading, self.blocks.join("\n\n"))
    }
}

/// Whether a word of the text is this one, in the plural or with another end.
fn is_form_of(one: &str, word: &str) -> bool {
    let is_plural = |long: &str, short: &str| long.strip_suffix('s') == Some(short);
    one == word
        || is_plural(one, word)
        || is_plural(word, one)
        || (FEWEST_LETTERS <= word.len() && one.starts_with(word))
}

fn words_of(text: &str) -> impl Iterator<Item = String> {
    text.split(|c: char| !c.is_alphanumeric()).filter(|one| !one.is_empty()).map(str::to_lowercase)
}

/// The level of a heading.
fn level(line: &str) -> Option<usize> {
    let signs = line.chars().take_while(|&c| c == '#').count();
    (0 < signs && line[signs..].starts_with(' ')).then_some(signs)
}

/// The text by headings; a block of code is one paragraph.
fn sections() -> Vec<HeadedSection<'static>> {
    let mut sections: Vec<HeadedSection<'_>> = Vec::new();
    let (mut from, mut at, mut is_code) = (0, 0, false);
    for line in LANGUAGE.split_inclusive('\n') {
        let end = at + line.len();
        is_code ^= line.starts_with("```");
        let heading = level(line).filter(|_| !is_code);
        if heading.is_some() || (line.trim().is_empty() && !is_code) {
            let block = LANGUAGE[from..at].trim();
            if let Some(section) = sections.last_mut().filter(|_| !block.is_empty()) {
                section.blocks.push(block);
            }
            from = end;
        }
        if heading.is_some() {
            sections.push(HeadedSection { heading: line.trim(), blocks: Vec::new() });
        }
        at = end;
    }
    if let Some(section) = sections.last_mut() {
        section.blocks.push(LANGUAGE[from..].trim());
    }
    sections
}

/// Rows of tables, items of lists and paragraphs that hold, each below its heading.
fn passages(sections: &[HeadedSection<'_>], holds: impl Fn(&str) -> bool) -> Vec<String> {
    let mut found = Vec::new();
    for section in sections {
        let mut text = String::new();
        for block in section.blocks.iter().filter(|block| !block.starts_with("```")) {
            for part in parts(block).iter().filter(|part| holds(part)) {
                text.push_str(&format!("{part}\n"));
            }
        }
        if !text.is_empty() {
            found.push(format!("{}\n\n{text}", section.heading));
        }
    }
    found
}

/// The rows of a table, the items of a list, or the paragraph itself.
fn parts(block: &str) -> Vec<String> {
    let begins = |line: &str| line.starts_with("| ") || line.starts_with("- ");
    let mut parts: Vec<String> = Vec::new();
    for line in block.lines() {
        match parts.last_mut() {
            Some(last) if !begins(line) => last.push_str(&format!("\n{line}")),
            _ => parts.push(line.to_owned()),
        }
    }
    parts
}

/// Whether code of the text has the word, a sign anywhere.
fn in_code(text: &str, word: &str) -> bool {
    let mut codes = text.split('`').skip(1).step_by(2);
    if word.chars().any(char::is_alphanumeric) {
        codes.any(|code| words_of(code).any(|one| one == word))
    } else {
        codes.any(|code| code.split_whitespace().any(|sign| sign == word))
    }
}

/// Markdown for a terminal: code is indented, and its fences are gone.
fn shown(text: &str) -> String {
    let (mut out, mut is_code) = (String::new(), false);
    for line in text.lines() {
        if line.starts_with("```") {
            is_code = !is_code;
        } else if is_code {
            out.push_str(&format!("    {line}\n"));
        } else if !line.starts_with("| ---") {
            out.push_str(&format!("{line}\n"));
        }
    }
    out
}
