//! What each address answers.

use std::sync::Arc;

use serde_json::{Value as Json, json};

use super::{
    doors::Doors,
    export,
    http::{Request, Response},
    page, write,
};
use crate::page::{
    Answer, ask::ask, deviation::deviation, isocurves::isocurves, keys_of, measure::measure,
    settings, stripes::stripes,
};

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
    let known = doors.hub.known();
    let found = known.item(key).map(|(item, _)| item.source.item(&doors.session));
    found.map_or_else(not_found, |item| Response::lasting(Arc::clone(&item.bytes)))
}

/// What an address answers with numbers instead of JSON; `None` of any other.
fn bytes(path: &str, body: &Json, doors: &Doors) -> Option<Result<Response, String>> {
    Some(match path {
        "/api/items" => items(body, doors),
        "/api/deviation" => {
            deviation(body, &doors.hub.known(), &doors.session).map(Response::numbers)
        }
        "/api/isocurves" => isocurves(body, &doors.hub.known(), &doors.session)
            .map(|item| Response::new("application/octet-stream", item)),
        "/api/stripes" => stripes(body, &doors.hub.known(), &doors.session).map(Response::numbers),
        _ => return None,
    })
}

/// Many items in one answer: how many, the length of each, and the bytes of each, which begin and end at
/// multiples of 8. An item that is not known any more has the length 0.
fn items(body: &Json, doors: &Doors) -> Result<Response, String> {
    let found = doors.hub.known().bytes(&keys_of(&body["items"])?, &doors.session);
    let mut head: Vec<u8> = (found.len() as u32).to_le_bytes().to_vec();
    head.extend(found.iter().flat_map(|bytes| (bytes.len() as u32).to_le_bytes()));
    Ok(Response::parts(std::iter::once(Arc::new(head)).chain(found).collect()))
}

/// What is done at an address; `None` where there is none.
fn post(path: &str, body: &Json, doors: &Doors) -> Option<Answer> {
    Some(match path {
        "/api/set" => set(body, doors),
        "/api/ask" => ask(body, &doors.hub.known(), &doors.session),
        "/api/measure" => measure(body, &doors.hub.known(), &doors.session),
        "/api/write" => write::write(body, doors),
        "/api/export" => export::export(body, doors),
        "/api/stop" => {
            doors.hub.stop();
            Ok(json!({ "stopped": true }))
        }
        _ => return None,
    })
}

fn set(body: &Json, doors: &Doors) -> Answer {
    doors.hub.set(settings::changed(body, &doors.hub.shown())?);
    Ok(json!({ "accepted": true }))
}
