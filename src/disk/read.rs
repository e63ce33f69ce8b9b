//! Reading: scripts, standard input, and the data that scripts name.

use std::{
    collections::BTreeMap,
    fs::File,
    io::{self, Read},
    path::{Path, PathBuf},
    sync::{Mutex, PoisonError},
};

use super::watched::FileStamp;
use crate::{export::io_reason, value::Files};

/// The name of standard input on the command line.
const STDIN: &str = "-";

/// A script on its way in.
#[derive(Debug)]
pub struct Script {
    /// What messages call it.
    pub name: String,
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// The folder that its paths are relative to.
    pub folder: PathBuf,
    /// The file, unless it came through standard input.
    pub path: Option<PathBuf>,
}

impl Script {
    /// Reads a script; one byte more than `most` is enough to know that it is too large.
    pub fn read(path: &Path, most: usize) -> Result<Self, String> {
        if path.as_os_str() == STDIN {
            let bytes = read_some(&mut io::stdin().lock(), most)
                .map_err(|err| format!("standard input: {err}"))?;
            let folder = PathBuf::from(".");
            return Ok(Self { name: "<stdin>".to_owned(), bytes, folder, path: None });
        }
        let name = path.display().to_string();
        if path.is_dir() {
            return Err(format!("`{name}` is a folder, not a script"));
        }
        if may_be_silent(path) {
            return Err(format!(
                "`{name}` is a pipe, which nobody may ever write to; `-` with `< {name}` reads from it"
            ));
        }
        let bytes = File::open(path)
            .and_then(|mut file| read_some(&mut file, most))
            .map_err(|err| format!("cannot read `{name}`: {}", io_reason(&err)))?;
        let folder = match path.parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent.to_path_buf(),
            _ => PathBuf::from("."),
        };
        Ok(Self { name, bytes, folder, path: Some(path.to_path_buf()) })
    }
}

/// Whether it is a pipe with a name, which is opened only when somebody else opens it too. Those that
/// the shell opened, as `/dev/stdin` and `<(...)`, are open already.
fn may_be_silent(path: &Path) -> bool {
    let is_open = path.starts_with("/dev") || path.starts_with("/proc");
    !is_open && path.metadata().is_ok_and(|data| !data.is_file() && !data.is_dir())
}

/// Everything up to `most` bytes and one more.
fn read_some(from: &mut dyn Read, most: usize) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    from.take(most as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// All of a file of no more than `most` bytes.
///
/// # Errors
/// What keeps it from being read, in a few words.
pub(crate) fn read_whole(path: &Path, most: usize) -> Result<Vec<u8>, String> {
    if may_be_silent(path) {
        return Err("it is a pipe, not a file with an end".to_owned());
    }
    let bytes = File::open(path)
        .and_then(|mut file| read_some(&mut file, most))
        .map_err(|e| io_reason(&e))?;
    if bytes.len() > most {
        return Err(format!("it is larger than the ceiling of {most} bytes"));
    }
    Ok(bytes)
}

/// Data files beside a script; remembers which were read.
#[derive(Debug)]
pub struct ScriptFiles {
    folder: PathBuf,
    asked: Mutex<BTreeMap<PathBuf, AskedFile>>,
}

/// A file that a script asked for.
#[derive(Debug)]
struct AskedFile {
    /// As it was before it was read first.
    stamp: FileStamp,
    was_read: bool,
}

impl ScriptFiles {
    /// Files relative to `folder`.
    pub fn new(folder: &Path) -> Self {
        Self { folder: folder.to_path_buf(), asked: Mutex::default() }
    }

    /// The files that were read.
    pub fn inputs(&self) -> Vec<PathBuf> {
        let asked = self.asked.lock().unwrap_or_else(PoisonError::into_inner);
        let read = asked.iter().filter(|(_, file)| file.was_read);
        read.map(|(path, _)| path.clone()).collect()
    }

    /// The files that were asked for, those that are not there among them, as they were then.
    pub(crate) fn stamps(&self) -> Vec<(PathBuf, FileStamp)> {
        let asked = self.asked.lock().unwrap_or_else(PoisonError::into_inner);
        asked.iter().map(|(path, file)| (path.clone(), file.stamp.clone())).collect()
    }

    /// Notes that a file is asked for.
    fn note(&self, path: &Path, stamp: FileStamp, was_read: bool) {
        let mut asked = self.asked.lock().unwrap_or_else(PoisonError::into_inner);
        let file = asked.entry(path.to_path_buf()).or_insert(AskedFile { stamp, was_read });
        file.was_read |= was_read;
    }
}

impl Files for ScriptFiles {
    fn read(&self, path: &str, most: usize) -> Result<Vec<u8>, String> {
        let full = self.folder.join(path);
        // What is written from now on makes it another one.
        let stamp = FileStamp::of(&full);
        self.note(&full, stamp.clone(), false);
        if full.is_dir() {
            return Err(format!("`{path}` is a folder"));
        }
        // A pipe or a device may never come to an end.
        if full.metadata().is_ok_and(|data| !data.is_file()) {
            return Err(format!("`{path}` is a pipe or a device, not a file with an end"));
        }
        let bytes = File::open(&full)
            .and_then(|mut file| read_some(&mut file, most))
            .map_err(|err| format!("cannot read `{path}`: {}", io_reason(&err)))?;
        self.note(&full, stamp, true);
        Ok(bytes)
    }

    fn beside(&self, path: &str) -> Vec<String> {
        let full = self.folder.join(path);
        let beside = full.parent().map(super::entries).unwrap_or_default();
        beside.into_iter().filter(|entry| !entry.is_folder).map(|entry| entry.name).collect()
    }
}
