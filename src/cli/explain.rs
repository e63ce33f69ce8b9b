//! `virote explain`: what a code means.

use super::{
    exit_status::ExitStatus,
    standard_streams::{say, say_error},
};
use crate::{
    diag::{Code, RETIRED, nearest},
    docs,
};

/// `virote explain [CODE]`
pub(super) fn run(code: Option<&str>) -> ExitStatus {
    let Some(text) = code else {
        let list: String =
            Code::ALL.iter().map(|code| format!("{}  {}\n", code.id(), code.title())).collect();
        say(&list);
        return ExitStatus::Well;
    };
    match entry(text) {
        Some(entry) => {
            say(&entry);
            ExitStatus::Well
        }
        None => {
            let near = nearest(text, Code::ALL.iter().map(|code| code.id()));
            let near = near.map(|near| format!("; did you mean {near}?")).unwrap_or_default();
            say_error(&format!(
                "virote: there is no code `{text}`{near}; `virote explain` lists all"
            ));
            ExitStatus::Usage
        }
    }
}

/// What is told of a code, also of one that no mistake has any more.
pub(super) fn entry(id: &str) -> Option<String> {
    let told =
        |id: &str, title: &str, text: &str| format!("{id}: {title}\n\n{}\n", docs::wrap(text));
    let known = Code::from_id(id).map(|code| told(code.id(), code.title(), code.explanation()));
    let retired = || RETIRED.iter().find(|(retired, ..)| retired.eq_ignore_ascii_case(id));
    known.or_else(|| retired().map(|&(id, title, text)| told(id, title, text)))
}
