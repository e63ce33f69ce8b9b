//! Addresses of documents as paths and back, and the files of a script with those that are open.

use std::{
    collections::BTreeMap,
    path::{Component, Path, PathBuf},
    sync::Arc,
};

use crate::{
    disk::{ScriptFiles, entries},
    ide::FolderEntry,
    value::Files,
};

/// Scripts of a workspace that are looked through.
const MOST_SCRIPTS: usize = 2000;
/// Folders that are looked into for them.
const MOST_FOLDERS: usize = 2000;

/// The path of an address, if it is one of a file.
pub(super) fn path_of(uri: &str) -> Option<PathBuf> {
    let rest = uri.strip_prefix("file://")?;
    let path = &rest[rest.find('/')?..];
    let mut bytes = Vec::with_capacity(path.len());
    let mut at = 0;
    while at < path.len() {
        let escaped =
            path.get(at + 1..at + 3).and_then(|digits| u8::from_str_radix(digits, 16).ok());
        match (path.as_bytes()[at], escaped) {
            (b'%', Some(byte)) => {
                bytes.push(byte);
                at += 3;
            }
            (byte, _) => {
                bytes.push(byte);
                at += 1;
            }
        }
    }
    let text = String::from_utf8(bytes).ok()?;
    // `/C:/...`
    let is_drive = text.as_bytes().get(2) == Some(&b':') && cfg!(windows);
    Some(normal(Path::new(if is_drive { &text[1..] } else { &text })))
}

/// The address of a path.
pub(super) fn uri_of(path: &Path) -> String {
    let text = path.display().to_string().replace('\\', "/");
    let root = if text.starts_with('/') { "file://" } else { "file:///" };
    format!("{root}{}", escaped(&text))
}

/// A text as a part of an address.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for byte in text.bytes() {
        if byte.is_ascii_alphanumeric() || b"/-._~".contains(&byte) {
            out.push(char::from(byte));
        } else {
            out.push_str(&format!("%{byte:02X}"));
        }
    }
    out
}

/// A path without `.` and, as far as it goes, without `..`.
pub(super) fn normal(path: &Path) -> PathBuf {
    let mut parts = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir
                if matches!(parts.components().next_back(), Some(Component::Normal(_))) =>
            {
                parts.pop();
            }
            part => parts.push(part),
        }
    }
    parts
}

/// The files beside a script; of those that are open in the editor what stands there.
#[derive(Debug)]
pub(super) struct OverlaidFiles {
    folder: PathBuf,
    open: Arc<BTreeMap<PathBuf, Arc<str>>>,
    disk: ScriptFiles,
}

impl OverlaidFiles {
    pub(super) fn new(folder: &Path, open: &Arc<BTreeMap<PathBuf, Arc<str>>>) -> Self {
        let (open, disk) = (Arc::clone(open), ScriptFiles::new(folder));
        Self { folder: folder.to_path_buf(), open, disk }
    }
}

impl Files for OverlaidFiles {
    fn read(&self, path: &str, most: usize) -> Result<Vec<u8>, String> {
        match self.open.get(&normal(&self.folder.join(path))) {
            Some(text) => Ok(text.as_bytes().to_vec()),
            None => self.disk.read(path, most),
        }
    }

    fn beside(&self, path: &str) -> Vec<String> {
        self.disk.beside(path)
    }
}

/// The scripts below these folders, in order; hidden folders, `target` and `node_modules` are left out.
pub(super) fn scripts(roots: &[PathBuf]) -> Vec<PathBuf> {
    let (mut found, mut folders, mut n_folders) = (Vec::new(), roots.to_vec(), 0);
    while let Some(folder) = folders.pop() {
        n_folders += 1;
        if MOST_FOLDERS < n_folders || MOST_SCRIPTS < found.len() {
            break;
        }
        for FolderEntry { name, is_folder } in entries(&folder) {
            let path = folder.join(&name);
            if is_folder && !path.is_symlink() && name != "target" && name != "node_modules" {
                folders.push(path);
            } else if name.ends_with(".geo") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

#[cfg(test)]
mod tests {
    use std::path::{Path, PathBuf};

    use super::{normal, path_of, uri_of};

    #[test]
    fn addresses_and_paths_are_one_another() {
        for path in ["/a/b.geo", "/größe und mehr/#1%20.geo", "/a+b/c:d.geo"] {
            let uri = uri_of(Path::new(path));
            assert_eq!(path_of(&uri), Some(PathBuf::from(path)), "{uri}");
        }
        assert_eq!(uri_of(Path::new("/ü x")), "file:///%C3%BC%20x");
        assert_eq!(path_of("file://localhost/a%2fb"), Some(PathBuf::from("/a/b")));
        assert_eq!((path_of("untitled:Untitled-1"), path_of("file:///%ff")), (None, None));
        assert_eq!(normal(Path::new("/a/./b/../c")), PathBuf::from("/a/c"));
    }
}
