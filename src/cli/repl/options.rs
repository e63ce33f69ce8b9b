//! `:set`: the options of the session, told and changed.

use super::{
    super::{
        limits::{limit, moved_from},
        standard_streams::say,
    },
    prompt::Prompt,
};
use crate::limits::Ceiling;

/// Columns that a picture may have.
const COLUMNS: std::ops::RangeInclusive<usize> = 20..=240;

/// Tells all options, or changes the one that stands there: `NAME VALUE` or `NAME = VALUE`.
pub(super) fn set(prompt: &mut Prompt, text: &str) {
    if text.is_empty() {
        return say(&options_with_values(prompt));
    }
    let (name, value) = match text.split_once(|c: char| c == '=' || c.is_whitespace()) {
        Some((name, value)) => (name, value.trim().trim_start_matches('=').trim()),
        None => (text, ""),
    };
    match (name, value) {
        ("color", "on" | "off") => {
            prompt.with_color = value == "on";
            prompt.voice.paint(prompt.with_color);
        }
        ("color", _) => return prompt.refuse("`:set color on` or `:set color off`"),
        ("width", "auto") => prompt.width = None,
        ("width", _) => match value.parse().ok().filter(|width| COLUMNS.contains(width)) {
            Some(width) => prompt.width = Some(width),
            None => {
                let (least, most) = (COLUMNS.start(), COLUMNS.end());
                return prompt.refuse(&format!(
                    "`:set width N` takes {least} to {most} columns, or `auto` for those of the terminal"
                ));
            }
        },
        _ => match limit(&format!("{name}={value}")) {
            Ok(change) => {
                let limits = moved_from(*prompt.limits(), &[change]);
                prompt.engine.set_limits(limits);
            }
            Err(why) if Ceiling::from_name(name).is_some() => return prompt.refuse(&why),
            Err(_) => return prompt.refuse(&unknown(name)),
        },
    }
    prompt.columns = prompt.width.unwrap_or(prompt.columns);
    say(&format!("{}\n", line(prompt, name)));
}

/// That there is no such option.
fn unknown(name: &str) -> String {
    let names = ["color", "width"].into_iter().chain(Ceiling::ALL.iter().map(|one| one.name));
    let near = crate::diag::nearest(name, names);
    let near = near.map_or_else(
        || "; `:set` lists them".to_owned(),
        |near| format!("; did you mean `{near}`?"),
    );
    format!("there is no option `{}`{near}", super::show::cut(name, 40))
}

/// An option with its value, as it is set.
fn line(prompt: &Prompt, name: &str) -> String {
    let value = match name {
        "color" => if prompt.with_color { "on" } else { "off" }.to_owned(),
        "width" => prompt.width.map_or_else(|| "auto".to_owned(), |width| width.to_string()),
        _ => Ceiling::from_name(name)
            .map(|ceiling| ceiling.of(prompt.limits()).to_string())
            .unwrap_or_default(),
    };
    format!("{name} {value}")
}

/// Every option with its value and what it does.
fn options_with_values(prompt: &Prompt) -> String {
    let own = [
        ("color", "whether messages and entries are coloured, on or off"),
        ("width", "columns of pictures and tables, or auto"),
    ];
    let ceilings = Ceiling::ALL.iter().map(|ceiling| (ceiling.name, ceiling.docs));
    own.into_iter()
        .chain(ceilings)
        .map(|(name, docs)| format!("  {:<32} {docs}\n", line(prompt, name)))
        .collect()
}
