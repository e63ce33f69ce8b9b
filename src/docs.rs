//! The reference, generated from the registry: for the terminal, and as Markdown.

pub mod language;

use std::fmt::Write;

use crate::value::{ExamplePicture, Family, Op, Registry, Type};

/// Columns of text in a terminal.
const WIDTH: usize = 90;
/// Columns before the text in a list of names.
const INDENT: usize = 23;

/// A name with what it is, in lines of a terminal's width.
fn listed(name: &str, text: &str) -> String {
    let text = wrap_at(text, WIDTH - INDENT).replace('\n', &format!("\n{:INDENT$}", ""));
    format!("  {name:<20} {text}\n")
}

/// Every built-in with its first paragraph, by chapter.
#[must_use]
pub fn overview(registry: &Registry) -> String {
    let mut out = String::new();
    for &(family, title) in Family::ALL {
        let ops: Vec<&Op> = registry.iter().filter(|op| op.family == family).collect();
        if ops.is_empty() {
            continue;
        }
        let _ = writeln!(out, "{title}");
        for op in ops {
            out.push_str(&listed(op.name, op.summary()));
        }
        out.push('\n');
    }
    out.push_str("Constants\n");
    for constant in registry.constants() {
        out.push_str(&listed(constant.name, constant.docs));
    }
    out.push_str(
        "\n`virote doc NAME` tells more about one of them, `virote doc WORDS` searches.\n`virote doc language` is the language itself, `virote doc let` one of its words.\n",
    );
    out
}

/// The titles of the chapters.
pub fn chapters() -> impl Iterator<Item = &'static str> {
    Family::ALL.iter().map(|&(_, title)| title)
}

/// The built-ins of a chapter with their first paragraphs; upper and lower case are the same.
#[must_use]
pub fn chapter(registry: &Registry, title: &str) -> Option<String> {
    let is_it = |(_, its): &&(Family, &str)| its.eq_ignore_ascii_case(title);
    let &(family, title) = Family::ALL.iter().find(is_it)?;
    let mut out = format!("{title}\n");
    for op in registry.iter().filter(|op| op.family == family) {
        out.push_str(&listed(op.name, op.summary()));
    }
    Some(out)
}

/// The built-ins that are about all words of a query, the best first, with their first paragraphs; none
/// if there is none.
///
/// A word counts where a word of theirs begins with it: in the name most, then in the first paragraph,
/// in the names of parameters, and in the rest of the documentation.
#[must_use]
pub fn search(registry: &Registry, query: &str) -> Option<String> {
    let query: Vec<String> = words(query).map(str::to_lowercase).collect();
    let mut found: Vec<(u32, &str, &str)> = registry
        .iter()
        .filter_map(|op| {
            let scores: Option<Vec<u32>> = query.iter().map(|word| score(op, word)).collect();
            Some((scores?.into_iter().sum(), op.name, op.summary()))
        })
        .filter(|&(score, ..)| 0 < score)
        .collect();
    found.sort_by(|a, b| b.0.cmp(&a.0).then(a.1.cmp(b.1)));
    // Of several that share a name each is listed by its own paragraph.
    found.dedup();
    let mut out = String::new();
    for (_, name, summary) in &found {
        out.push_str(&listed(name, summary));
    }
    (!found.is_empty()).then_some(out)
}

/// How much an operation is about a word; none if nothing of it begins with the word.
fn score(op: &Op, word: &str) -> Option<u32> {
    let has = |text: &str| words(text).any(|one| one.to_lowercase().starts_with(word));
    let names = || std::iter::once(op.name).chain(op.aliases.iter().copied());
    if names().any(|name| name == word) {
        Some(16)
    } else if names().any(has) {
        Some(8)
    } else if has(op.summary()) {
        Some(4)
    } else if op.params.iter().any(|param| has(param.name)) {
        Some(2)
    } else if has(op.docs) || op.params.iter().any(|param| has(param.docs)) {
        Some(1)
    } else {
        None
    }
}

/// The words of a text or name.
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|character: char| !character.is_alphanumeric()).filter(|word| !word.is_empty())
}

/// All that the registry knows of `name`, for a terminal.
#[must_use]
pub fn entry(registry: &Registry, name: &str) -> Option<String> {
    if let Some(constant) = registry.constant(name) {
        return Some(format!("{} = {}\n\n{}\n", constant.name, (constant.value)(), constant.docs));
    }
    let (_, ops) = registry.get(name)?;
    Some(ops.iter().map(|op| op_entry(op)).collect::<Vec<_>>().join("\n"))
}

fn op_entry(op: &Op) -> String {
    let mut out = format!("{}\n", op.signature());
    if !op.aliases.is_empty() {
        let _ = writeln!(out, "also called {}", op.aliases.join(", "));
    }
    let _ = write!(out, "\n{}\n", wrap(&dedent(op.docs)));
    if !op.params.is_empty() {
        out.push('\n');
    }
    for param in op.params {
        let docs = dedent(param.docs);
        let _ = writeln!(out, "  {:<14} {}", param.name, docs.trim().replace('\n', " "));
    }
    for example in op.examples {
        let _ = write!(out, "\n  {}\n  = {}\n", example.code, example.prints);
    }
    for refusal in op.refusals {
        let _ = write!(out, "\n  {}\n  {}\n", refusal.code, refusal.says);
    }
    out
}

/// A picture of the reference.
#[derive(Clone, Debug)]
pub struct Illustration {
    /// What it belongs to.
    pub op: &'static Op,
    /// Its file, in the folder `pictures` beside the reference.
    pub file: String,
    /// What it shows: what the operation declares, or the call in its first example.
    pub picture: ExamplePicture,
}

impl Illustration {
    /// The script whose geometry it shows.
    #[must_use]
    pub fn script(&self) -> String {
        match self.picture {
            ExamplePicture::Value(expression) => format!("let shown = {expression}\n"),
            ExamplePicture::Scene(script) => lines(script),
        }
    }

    /// What stands below it.
    fn caption(&self) -> String {
        match self.picture {
            ExamplePicture::Value(expression) => format!("*`{expression}`*\n"),
            ExamplePicture::Scene(script) => format!("```geo\n{}```\n", lines(script)),
        }
    }
}

/// The lines of a text that is indented, without empty ones.
fn lines(text: &str) -> String {
    let lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
    lines.map(|line| format!("{line}\n")).collect()
}

/// The pictures of the operations that make curves, surfaces or meshes, and of those that declare one.
#[must_use]
pub fn illustrations(registry: &Registry) -> Vec<Illustration> {
    let mut found: Vec<Illustration> = Vec::new();
    for op in registry.iter() {
        let first = || {
            let mut calls = op.examples.iter().filter_map(|one| call_in(one.code, op.name));
            calls.next().filter(|_| makes_shapes(op.returns)).map(ExamplePicture::Value)
        };
        let Some(picture) = op.picture.or_else(first) else { continue };
        let file = match found.iter().filter(|other| other.op.name == op.name).count() {
            0 => format!("{}.png", op.name),
            n => format!("{}-{}.png", op.name, n + 1),
        };
        found.push(Illustration { op, file, picture });
    }
    found
}

/// Whether values of a type are always drawn.
fn makes_shapes(ty: Type) -> bool {
    match ty {
        Type::Curve | Type::Surface | Type::Mesh => true,
        Type::List(of, _) => makes_shapes(*of),
        Type::OneOf(types) => types.iter().all(|ty| makes_shapes(*ty)),
        _ => false,
    }
}

/// The first call of `name` in an example, up to its closing bracket.
fn call_in<'a>(code: &'a str, name: &str) -> Option<&'a str> {
    let is_word = |character: char| character.is_alphanumeric() || character == '_';
    let is_call = |&(start, _): &(usize, &str)| {
        !code[..start].ends_with(is_word) && code[start + name.len()..].starts_with('(')
    };
    let (start, _) = code.match_indices(name).find(is_call)?;
    let (mut depth, mut is_text) = (0_usize, false);
    for (i, character) in code[start..].char_indices() {
        match character {
            '"' => is_text = !is_text,
            '(' if !is_text => depth += 1,
            ')' if !is_text && depth <= 1 => return Some(&code[start..=start + i]),
            ')' if !is_text => depth -= 1,
            _ => {}
        }
    }
    None
}

/// What the reference begins with.
const HEAD: &str = "\
# Reference

Every built-in of the language, by chapter. This page is generated from the declarations
of the operations; `virote doc NAME` shows the same in a terminal.

A signature has the names of the parameters, their types, and the defaults of those that may be
left out, which are always given by name. A `length` may carry a unit of length; without one it
counts in the unit of the document, as points do. An `angle` carries `deg`, `rad` or `turn`.
Questions about geometry answer in the unit of the document, with numbers that carry none.

Each example, and each error that an entry lists, is a test. Errors that all built-ins have in
common are not listed: an argument that is of another kind (E0301, E0303), an angle without a unit
(E0304), arguments that are missing, repeated or unknown (E0401), a word that is none of those that
can be chosen (E0402), and what is beyond a ceiling (E0901). `virote explain CODE` tells about each.
";

/// The whole reference as Markdown, by chapter and name.
#[must_use]
pub fn reference(registry: &Registry) -> String {
    let mut out = String::from(HEAD);
    let pictures = illustrations(registry);
    for &(family, title) in Family::ALL {
        let ops: Vec<&Op> = registry.iter().filter(|op| op.family == family).collect();
        if ops.is_empty() {
            continue;
        }
        let _ = write!(out, "\n## {title}\n");
        for op in ops {
            let picture = pictures.iter().find(|picture| std::ptr::eq(picture.op, op));
            out.push_str(&markdown_entry(op, picture));
        }
    }
    out.push_str("\n## Constants\n\n");
    for constant in registry.constants() {
        let _ = writeln!(out, "- `{}`: {}", constant.name, constant.docs);
    }
    out
}

/// All that the registry knows of `name`, as Markdown for a small window.
#[must_use]
pub fn markdown(registry: &Registry, name: &str) -> Option<String> {
    if let Some(constant) = registry.constant(name) {
        let value = (constant.value)();
        return Some(format!("```geo\n{} = {value}\n```\n\n{}", constant.name, constant.docs));
    }
    let (_, ops) = registry.get(name)?;
    let entry = |op: &&Op| {
        let mut out = format!("```geo\n{}\n```\n\n{}", op.signature(), paragraph(op.docs));
        out.push_str(if op.params.is_empty() { "" } else { "\n" });
        for param in op.params {
            out.push_str(&format!(
                "\n- `{}`: {}",
                param.name,
                paragraph(param.docs).replace('\n', " ")
            ));
        }
        if let Some(example) = op.examples.first() {
            out.push_str(&format!(
                "\n\n```geo\n{}\n// {}\n```",
                example.code,
                example.prints.replace('\n', "\n// ")
            ));
        }
        out
    };
    Some(ops.iter().map(entry).collect::<Vec<_>>().join("\n\n---\n\n"))
}

/// Documentation as it was written, without the blanks that follow the comment signs.
#[must_use]
pub fn paragraph(docs: &str) -> String {
    dedent(docs).trim().to_owned()
}

fn markdown_entry(op: &Op, picture: Option<&Illustration>) -> String {
    let mut out = format!("\n### `{}`\n\n```text\n{}\n```\n\n", op.name, op.signature());
    if !op.aliases.is_empty() {
        let _ = writeln!(out, "Also called `{}`.\n", op.aliases.join("`, `"));
    }
    let _ = writeln!(out, "{}", dedent(op.docs).trim_end());
    if !op.params.is_empty() {
        out.push('\n');
    }
    for param in op.params {
        let docs = dedent(param.docs);
        let _ =
            writeln!(out, "- `{}` ({}): {}", param.name, param.ty, docs.trim().replace('\n', " "));
    }
    if let Some(picture) = picture {
        let _ = write!(out, "\n![{}](pictures/{})\n\n{}", op.name, picture.file, picture.caption());
    }
    for example in op.examples {
        let _ = write!(
            out,
            "\n```geo\nprint {}\n```\n```text\n{}\n```\n",
            example.code, example.prints
        );
    }
    if !op.refusals.is_empty() {
        out.push_str("\nErrors:\n\n");
    }
    for refusal in op.refusals {
        let _ = writeln!(out, "- `{}`<br>{}", refusal.code, refusal.says);
    }
    out
}

/// Documentation without the blank that follows the comment sign.
fn dedent(docs: &str) -> String {
    docs.lines().map(|line| line.strip_prefix(' ').unwrap_or(line)).collect::<Vec<_>>().join("\n")
}

/// Paragraphs broken into lines of a terminal's width.
#[must_use]
pub fn wrap(text: &str) -> String {
    wrap_at(text, WIDTH)
}

fn wrap_at(text: &str, most: usize) -> String {
    let paragraphs = text.trim().split("\n\n").map(|paragraph| {
        let (mut out, mut column) = (String::new(), 0);
        for word in paragraph.split_whitespace() {
            let width = word.chars().count();
            if column > 0 && column + 1 + width > most {
                out.push('\n');
                column = 0;
            } else if column > 0 {
                out.push(' ');
                column += 1;
            }
            out.push_str(word);
            column += width;
        }
        out
    });
    paragraphs.collect::<Vec<_>>().join("\n\n")
}
