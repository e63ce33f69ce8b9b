//! Paths of written files: below the output folder, each once, on every system; and names within them.

use std::collections::HashMap;

use crate::diag::{Span, is_hidden};

/// The path in normal form, if it stays below the output folder.
pub(super) fn safe_path(path: &str) -> Result<String, String> {
    let is_absolute = path.starts_with(['/', '\\']) || path.contains(':');
    if is_absolute {
        return Err(format!("`{path}` is not a path below the output folder"));
    }
    if let Some(c) = path.chars().find(|c| c.is_control()) {
        return Err(format!("a path cannot hold the character {:?}", c));
    }
    let mut parts: Vec<&str> = Vec::new();
    for part in path.split(['/', '\\']) {
        match part {
            "" | "." => {}
            ".." => {
                parts.pop().ok_or_else(|| format!("`{path}` leaves the output folder"))?;
            }
            part => parts.push(part),
        }
    }
    if parts.is_empty() { Err(format!("`{path}` names no file")) } else { Ok(parts.join("/")) }
}

/// The paths that a script writes, so that each is compared with those alone that it may clash with.
#[derive(Default)]
pub(super) struct WrittenPaths {
    /// Files by their path in small letters.
    files: HashMap<String, (String, Span)>,
    /// The first file in each folder, by the folder's path in small letters.
    folders: HashMap<String, (String, Span)>,
}

impl WrittenPaths {
    /// Adds a path, unless it cannot stand beside one before: then why, the remedy, and the place of that.
    pub(super) fn add(&mut self, path: &str, span: Span) -> Option<((String, &'static str), Span)> {
        let key = path.to_lowercase();
        let folders = || key.match_indices('/').map(|(end, _)| &key[..end]);
        let first = std::iter::once(key.as_str())
            .chain(folders())
            .find_map(|file| self.files.get(file))
            .or_else(|| self.folders.get(&key));
        if let Some((first, place)) = first {
            return clash(first, path).map(|told| (told, *place));
        }
        for folder in folders() {
            self.folders.entry(folder.to_owned()).or_insert_with(|| (path.to_owned(), span));
        }
        self.files.insert(key, (path.to_owned(), span));
        None
    }
}

/// What keeps a second path from standing beside a first one, and the remedy.
fn clash(first: &str, second: &str) -> Option<(String, &'static str)> {
    let (a, b) = (first.to_lowercase(), second.to_lowercase());
    let lies_in = |a: &str, b: &str| a.strip_prefix(b).is_some_and(|rest| rest.starts_with('/'));
    if first == second {
        let hint = "one statement takes several values: `export a, b to \"both.obj\"`";
        Some((format!("`{second}` is exported twice"), hint))
    } else if a == b {
        let hint = "many systems take capital and small letters for the same: choose another name";
        Some((format!("`{second}` is exported twice: `{first}` differs in capitals alone"), hint))
    } else if lies_in(&a, &b) || lies_in(&b, &a) {
        let (file, inside) = if lies_in(&b, &a) { (first, second) } else { (second, first) };
        let hint = "choose another name for the file or the folder";
        Some((format!("`{file}` cannot be a file and the folder of `{inside}`"), hint))
    } else {
        None
    }
}

/// The first part of a path that Windows can give no file, and why.
pub(super) fn reserved(path: &str) -> Option<(&str, &'static str)> {
    let is_device = |part: &str| {
        let base = part.split('.').next().unwrap_or(part).trim_end().to_ascii_uppercase();
        let numbered = ["COM", "LPT"].iter().any(|device| {
            base.strip_prefix(device).is_some_and(|rest| matches!(rest.as_bytes(), [b'1'..=b'9']))
        });
        numbered || ["CON", "PRN", "AUX", "NUL"].contains(&base.as_str())
    };
    path.split('/').find_map(|part| {
        if is_device(part) {
            Some((part, "is the name of a device"))
        } else if part.ends_with(['.', ' ']) {
            Some((part, "ends with a point or a blank"))
        } else if part.contains(['<', '>', '"', '|', '?', '*']) {
            Some((part, "holds one of `< > \" | ? *`"))
        } else {
            None
        }
    })
}

/// A name with a blank for each character that no line of text, or no XML, can hold.
pub(super) fn printable(text: &str) -> String {
    let is_kept = |c: char| {
        !is_hidden(c)
            && !matches!(c, '\n' | '\t' | '\u{2028}' | '\u{2029}')
            && (c as u32) & 0xFFFE != 0xFFFE
    };
    text.chars().map(|c| if is_kept(c) { c } else { ' ' }).collect()
}

#[cfg(test)]
mod tests {
    use super::safe_path;

    #[test]
    fn paths_stay_below_the_output_folder() {
        assert_eq!(safe_path("a/../b/./c.obj").as_deref(), Ok("b/c.obj"));
        for path in [
            "../a.obj",
            "a/../../b.obj",
            "/etc/a.obj",
            "c:\\a.obj",
            "\\\\host\\a.obj",
            "",
            ".",
            "a/..",
        ] {
            assert!(safe_path(path).is_err(), "{path}");
        }
    }
}
