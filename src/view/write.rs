//! Values of parameters written into the script.

use serde_json::{Value as Json, json};

use super::doors::Doors;
use crate::{
    disk::{Script, ScriptFiles, overwrite},
    export::io_reason,
    page::{Answer, defaults::rewritten, settings::to_be_written},
};

/// `/api/write`
pub(super) fn write(body: &Json, doors: &Doors) -> Answer {
    let given = to_be_written(body, &doors.hub.shown(), &doors.hub.settings())?;
    let _alone = doors.alone();
    let script = Script::read(&doors.script, doors.session.limits().source_bytes)?;
    let files = ScriptFiles::new(&script.folder);
    let text = String::from_utf8(script.bytes).map_err(|_| "the script is not UTF-8 text")?;
    let new = rewritten(&text, &given, &doors.session, &files)?;
    overwrite(&doors.script, &new)
        .map_err(|err| format!("cannot write `{}`: {}", script.name, io_reason(&err)))?;
    let names: Vec<String> = given.into_iter().map(|(name, _)| name).collect();
    // What is the default now is set no more.
    doors.hub.set(|settings| settings.retain(|setting| !names.contains(&setting.name)));
    doors.hub.files_changed();
    Ok(json!({ "written": names }))
}
