//! What each address answers.

use std::{
    path::PathBuf,
    sync::{Arc, PoisonError},
};

use serde_json::{Value as Json, json};

use super::{
    ask, defaults, deviation, export,
    http::{Request, Response},
    hub::Hub,
    measure, page,
};
use crate::{eval::Setting, session::Session};

/// What answers need.
#[derive(Debug)]
pub(super) struct Doors {
    pub(super) hub: Arc<Hub>,
    /// For questions; without a memory, and nobody stops it.
    pub(super) session: Session,
    pub(super) script: PathBuf,
    /// The folder for exported files.
    pub(super) out: PathBuf,
    /// One writes at a time.
    pub(super) writing: std::sync::Mutex<()>,
}

/// An answer for the page, or a sentence why there is none.
pub(super) type Answer = Result<Json, String>;

/// The answer to a request that may be asked.
pub(super) fn answer(request: &Request, doors: &Doors) -> Response {
    let answer = match (request.method.as_str(), request.path.as_str()) {
        ("GET", "/api/state") => {
            return Response::new("application/json", doors.hub.shown().state.clone());
        }
        ("GET", path) => {
            return match path.strip_prefix("/api/item/") {
                Some(key) => item(key, doors),
                None => page::file(path).unwrap_or_else(not_found),
            };
        }
        ("POST", path) => {
            let Ok(body) = serde_json::from_slice::<Json>(&request.body) else {
                return Response::trouble(400, "the body is no JSON");
            };
            if let Some(answer) = bytes(path, &body, doors) {
                return answer.unwrap_or_else(|why| Response::trouble(400, &why));
            }
            post(path, &body, doors)
        }
        _ => None,
    };
    match answer {
        Some(Ok(value)) => Response::json(&value),
        Some(Err(why)) => Response::trouble(400, &why),
        None => not_found(),
    }
}

fn not_found() -> Response {
    Response::trouble(404, "there is nothing at this address")
}

fn item(key: &str, doors: &Doors) -> Response {
    let found = doors.hub.with_item(key, |item, _| item.source.item(&doors.session));
    found.map_or_else(not_found, |item| Response::lasting(Arc::clone(&item.bytes)))
}

/// What an address answers with numbers instead of JSON; `None` of any other.
fn bytes(path: &str, body: &Json, doors: &Doors) -> Option<Result<Response, String>> {
    Some(match path {
        "/api/items" => items(body, doors),
        "/api/deviation" => deviation::deviation(body, doors).map(Response::numbers),
        _ => return None,
    })
}

/// Many items in one answer: how many, the length of each, and the bytes of each, which begin and end at
/// multiples of 8. An item that is not known any more has the length 0.
fn items(body: &Json, doors: &Doors) -> Result<Response, String> {
    let known = doors.hub.items_by_key();
    let found: Vec<Arc<Vec<u8>>> = keys_of(&body["items"])?
        .iter()
        .map(|key| known.get(*key))
        .map(|source| {
            let item = source.map(|source| source.item(&doors.session));
            item.map_or_else(Arc::default, |item| Arc::clone(&item.bytes))
        })
        .collect();
    let mut head: Vec<u8> = (found.len() as u32).to_le_bytes().to_vec();
    head.extend(found.iter().flat_map(|bytes| (bytes.len() as u32).to_le_bytes()));
    Ok(Response::parts(std::iter::once(Arc::new(head)).chain(found).collect()))
}

/// A list of keys.
pub(super) fn keys_of(list: &Json) -> Result<Vec<&str>, String> {
    let keys = list.as_array().filter(|keys| !keys.is_empty());
    let keys = keys.and_then(|keys| keys.iter().map(Json::as_str).collect());
    keys.ok_or_else(|| "the items must be a list of keys".to_owned())
}

/// What is done at an address; `None` where there is none.
fn post(path: &str, body: &Json, doors: &Doors) -> Option<Answer> {
    Some(match path {
        "/api/set" => set(body, doors),
        "/api/ask" => ask::ask(body, doors),
        "/api/measure" => measure::measure(body, doors),
        "/api/write" => defaults::write(body, doors),
        "/api/export" => export::export(body, doors),
        "/api/stop" => {
            doors.hub.stop();
            Ok(json!({ "stopped": true }))
        }
        _ => return None,
    })
}

fn set(body: &Json, doors: &Doors) -> Answer {
    if body["reset"] == json!(true) {
        doors.hub.set(Vec::clear);
        return Ok(json!({ "accepted": true }));
    }
    let values = values_of(body, doors)?;
    doors.hub.set(|settings| {
        settings.retain(|setting| values.iter().all(|(name, _)| *name != setting.name));
        let new = values.into_iter().filter_map(|(name, text)| Some((name, text?)));
        settings.extend(new.map(|(name, text)| Setting {
            called: format!("`{name} = {text}`"),
            name,
            text,
        }));
    });
    Ok(json!({ "accepted": true }))
}

/// The member `values` of a body: names of parameters with texts, or null.
pub(super) fn values_of(
    body: &Json,
    doors: &Doors,
) -> Result<Vec<(String, Option<String>)>, String> {
    let Some(members) = body["values"].as_object() else {
        return Err("`values` must be an object".to_owned());
    };
    let shown = doors.hub.shown();
    let value = |(name, value): (&String, &Json)| {
        if !shown.parameters.contains(name) {
            return Err(format!("the script has no parameter `{name}`"));
        }
        match value {
            Json::Null => Ok((name.clone(), None)),
            Json::String(text) => Ok((name.clone(), Some(text.clone()))),
            _ => Err(format!("the value of `{name}` must be a text or null")),
        }
    };
    members.iter().map(value).collect()
}

/// Waits until nobody else writes.
pub(super) fn alone(doors: &Doors) -> std::sync::MutexGuard<'_, ()> {
    doors.writing.lock().unwrap_or_else(PoisonError::into_inner)
}
