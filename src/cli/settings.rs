//! Values for parameters: `--set NAME=VALUE` and `--params FILE.json`.

use std::path::Path;

use serde_json::{Deserializer, Value as Json};

use super::{exit_status::ExitStatus, reporter::Reporter, run_args::RunArgs};
use crate::{disk::Script, eval::Setting, value::decode};

/// The settings that the options give, those of `--params` first; what is wrong is told.
///
/// # Errors
/// How the command ends then.
pub(super) fn given(
    common: &RunArgs,
    most: usize,
    voice: &Reporter,
) -> Result<Vec<Setting>, ExitStatus> {
    let mut settings = match &common.params {
        None => Vec::new(),
        Some(path) => read(path, most).map_err(|message| {
            voice.trouble(&message);
            ExitStatus::Usage
        })?,
    };
    // Of two settings the last one counts.
    settings.extend(common.settings.iter().cloned());
    Ok(settings)
}

/// The settings of a file: a JSON object of numbers, strings and truth values.
///
/// # Errors
/// What is wrong with the file, and where.
fn read(path: &Path, most: usize) -> Result<Vec<Setting>, String> {
    let script = Script::read(path, most)?;
    if script.bytes.len() > most {
        return Err(format!("`{}` is larger than the ceiling of {most} bytes", script.name));
    }
    let text = decode(&script.bytes).map_err(|what| format!("{}: {what}", script.name))?;
    members(&text)
        .and_then(|members| settings(members, &script.name))
        .map_err(|(place, message)| message_at(&script.name, &text, place, &message))
}

/// A byte of the text, and what is wrong there.
type SettingsFault = (usize, String);

/// A member of an object, and where its name stands.
struct JsonMember {
    name: String,
    value: Json,
    place: usize,
}

/// The members of the object that the text is, in its order, those of one name included.
fn members(text: &str) -> Result<Vec<JsonMember>, SettingsFault> {
    let whole: Json = serde_json::from_str(text).map_err(|err| {
        let message = err.to_string();
        let message = message.split(" at line ").next().unwrap_or_default().to_owned();
        (byte_of(text, err.line(), err.column()), message)
    })?;
    let start = text.len() - text.trim_start().len();
    if !whole.is_object() {
        return Err((start, "parameters are an object, `{\"neck\": \"15mm\"}`".to_owned()));
    }
    // The text is known to be an object, so that each part is where it must be.
    let mut found = Vec::new();
    let mut at = start + 1;
    loop {
        at += text[at..].len() - text[at..].trim_start_matches([' ', '\t', '\r', '\n', ',']).len();
        let place = at;
        let Some(Json::String(name)) = next(text, &mut at) else { return Ok(found) };
        at += text[at..].find(':').map_or(0, |colon| colon + 1);
        let Some(value) = next(text, &mut at) else { return Ok(found) };
        found.push(JsonMember { name, value, place });
    }
}

/// The value that begins at byte `at`, which moves behind it.
fn next(text: &str, at: &mut usize) -> Option<Json> {
    let mut values = Deserializer::from_str(&text[*at..]).into_iter::<Json>();
    let value = values.next()?.ok()?;
    *at += values.byte_offset();
    Some(value)
}

fn settings(members: Vec<JsonMember>, file: &str) -> Result<Vec<Setting>, SettingsFault> {
    let mut settings: Vec<Setting> = Vec::new();
    for JsonMember { name, value, place } in members {
        if settings.iter().any(|setting| setting.name == name) {
            return Err((place, format!("`{name}` is given twice")));
        }
        let text = match value {
            Json::String(text) => text,
            Json::Number(number) => number.to_string(),
            Json::Bool(truth) => truth.to_string(),
            Json::Null | Json::Array(_) | Json::Object(_) => {
                let message =
                    format!("`{name}` must be a number, a string such as \"15mm\", true or false");
                return Err((place, message));
            }
        };
        settings.push(Setting { called: format!("`{name}` of `{file}`"), name, text });
    }
    Ok(settings)
}

/// The byte of a line and column as the reader of JSON counts them: from 1, in bytes; column 0 is
/// the end of the line before.
fn byte_of(text: &str, line: usize, column: usize) -> usize {
    let before: usize = text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
    text.floor_char_boundary((before + column).saturating_sub(1).min(text.len()))
}

fn message_at(name: &str, text: &str, place: usize, message: &str) -> String {
    let before = &text[..place];
    let line = 1 + before.matches('\n').count();
    let column = 1 + before.rsplit('\n').next().map_or(0, |line| line.chars().count());
    format!("{name}:{line}:{column}: {message}")
}

#[cfg(test)]
mod tests {
    use super::members;

    #[test]
    fn members_come_with_their_places() {
        let text = " {\"a\" : 1.5,\n  \"b{,\": \"x:\\\"\" , \"a\":true}";
        let found: Vec<(String, String, usize)> = members(text)
            .unwrap_or_default()
            .into_iter()
            .map(|member| (member.name, member.value.to_string(), member.place))
            .collect();
        let expected = [("a", "1.5", 2), ("b{,", "\"x:\\\"\"", 15), ("a", "true", 31)];
        assert_eq!(found, expected.map(|(name, value, at)| (name.into(), value.into(), at)));
        assert!(members("{}").is_ok_and(|members| members.is_empty()));
        assert!(members("[]").is_err() && members("{\"a\":}").is_err());
    }
}
