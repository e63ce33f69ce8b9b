//! Values of parameters as the page sends them.

use serde_json::{Value as Json, json};

use super::Shown;
use crate::eval::Setting;

/// Settings as a page wants them changed: all gone (`reset`), or the values of some.
///
/// # Errors
/// A sentence where there is no such parameter to be set, or a value is no text.
pub(crate) fn changed(
    body: &Json,
    shown: &Shown,
) -> Result<impl FnOnce(&mut Vec<Setting>) + use<>, String> {
    let values = match body["reset"] == json!(true) {
        true => None,
        false => Some(values_of(body, shown)?),
    };
    Ok(move |settings: &mut Vec<Setting>| {
        let Some(values) = values else { return settings.clear() };
        settings.retain(|setting| values.iter().all(|(name, _)| *name != setting.name));
        let new = values.into_iter().filter_map(|(name, text)| Some((name, text?)));
        settings.extend(new.map(|(name, text)| Setting {
            called: format!("`{name} = {text}`"),
            name,
            text,
        }));
    })
}

/// Values to be written into the script: what the page asks for, as the person wrote it where that is set.
///
/// # Errors
/// As [`changed`].
pub(crate) fn to_be_written(
    body: &Json,
    shown: &Shown,
    settings: &[Setting],
) -> Result<Vec<(String, String)>, String> {
    let as_set = |(name, text): (String, String)| {
        let set = settings.iter().rfind(|setting| setting.name == name);
        let text = set.map_or(text, |setting| setting.text.clone());
        (name, text)
    };
    let values = values_of(body, shown)?;
    Ok(values.into_iter().filter_map(|(name, text)| Some(as_set((name, text?)))).collect())
}

/// The member `values` of a body: names of parameters with texts, or null.
fn values_of(body: &Json, shown: &Shown) -> Result<Vec<(String, Option<String>)>, String> {
    let Some(members) = body["values"].as_object() else {
        return Err("`values` must be an object".to_owned());
    };
    let value = |(name, value): (&String, &Json)| {
        match value {
            // Whatever is there no more is set no more.
            Json::Null => Ok((name.clone(), None)),
            _ if !shown.parameters.contains(name) => {
                Err(format!("the script has no parameter `{name}`"))
            }
            Json::String(text) => Ok((name.clone(), Some(text.clone()))),
            _ => Err(format!("the value of `{name}` must be a text or null")),
        }
    };
    members.iter().map(value).collect()
}
