//! What a page shows of a script, and what it answers: knows no server, no file and no clock.
//!
//! A [`Model`] evaluates a script again and again and keeps what its last good run drew. What a run came
//! to is [`Shown`]: a `state` (JSON) and a `scene`, whose items have keys. Questions about items
//! (`ask`, `measure`, `deviation`, `stripes`) are asked of those that are [`Known`]. The doors bring texts in and
//! carry answers out: `view` by HTTP, `playground` by messages.

mod answers;
pub(crate) mod ask;
mod ceilings;
pub(crate) mod defaults;
pub(crate) mod deviation;
pub(crate) mod export;
mod imports;
pub(crate) mod isocurves;
pub(crate) mod measure;
mod model;
mod parameters;
mod scene;
pub(crate) mod settings;
mod shown;
pub(crate) mod state;
pub(crate) mod stripes;
mod threads;

use serde_json::Value as Json;

#[cfg(feature = "cli")]
pub(crate) use self::scene::SceneItem;
pub(crate) use self::{
    model::{Model, PageRun, RunPlace},
    shown::{Known, Shown},
};

/// An answer for the page, or a sentence why there is none.
pub(crate) type Answer = Result<Json, String>;

/// A list of keys.
pub(crate) fn keys_of(list: &Json) -> Result<Vec<&str>, String> {
    let keys = list.as_array().filter(|keys| !keys.is_empty());
    let keys = keys.and_then(|keys| keys.iter().map(Json::as_str).collect());
    keys.ok_or_else(|| "the items must be a list of keys".to_owned())
}
