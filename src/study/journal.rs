//! The journal of a study: a line for each row as soon as it is there.
//!
//! The first line tells what the study is of; a study that was killed goes on behind the last whole line
//! if it is still the same. While a study runs its journal is locked, so that no other one writes into it.

use std::{
    collections::BTreeMap,
    fs::{self, File, TryLockError},
    io::{self, BufRead, BufReader, Seek, SeekFrom, Write},
    path::{Path, PathBuf},
};

use serde_json::{Map, Value as Json, json};

use super::row::Row;
use crate::export::io_reason;

/// The journal of a study under way.
#[derive(Debug)]
pub struct Journal {
    file: File,
    path: PathBuf,
    /// Rows that are in it.
    pub n_rows: u64,
    /// Files that the kept rows came from, with their sums.
    pub files: BTreeMap<String, String>,
}

/// A line that tells of a file, by its member.
const FILE: &str = "file";
/// One that tells that the rows before it may be of another plan.
const SPOILED: &str = "spoiled";

impl Journal {
    /// The journal at `path` of the study that `header` tells of: a new one, or that of a run that was
    /// ended. With `is_fresh` what was there is given up.
    ///
    /// # Errors
    /// That another study is there or under way, or that it cannot be read or written.
    pub fn open(path: &Path, header: &Map<String, Json>, is_fresh: bool) -> Result<Self, String> {
        let name = path.display();
        let cannot = |err: &io::Error| format!("cannot write `{name}`: {}", io_reason(err));
        if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
            fs::create_dir_all(folder).map_err(|err| cannot(&err))?;
        }
        let open = File::options().read(true).write(true).create(true).truncate(false).open(path);
        let file = open.map_err(|err| cannot(&err))?;
        match file.try_lock() {
            Err(TryLockError::WouldBlock) => {
                return Err(format!(
                    "another study is writing `{name}` now; wait until it is done"
                ));
            }
            // Some network drives have no locks.
            Ok(()) | Err(TryLockError::Error(_)) => {}
        }
        let mut journal = Self { file, path: path.to_owned(), n_rows: 0, files: BTreeMap::new() };
        let end = if is_fresh { 0 } else { journal.read(header)? };
        journal.file.set_len(end).map_err(|err| cannot(&err))?;
        journal.file.seek(SeekFrom::End(0)).map_err(|err| cannot(&err))?;
        if end == 0 {
            journal.line(&Json::Object(header.clone()))?;
        }
        Ok(journal)
    }

    /// Reads what is there; the byte behind the last whole line.
    fn read(&mut self, header: &Map<String, Json>) -> Result<u64, String> {
        let name = self.path.display().to_string();
        let mut end = 0;
        for line in lines(&self.file, &self.path)? {
            let (line, bytes) = line?;
            let Some(line) = line else { break };
            match (end, &line) {
                (0, Json::Object(kept)) if kept == header => {}
                (0, Json::Object(kept)) => return Err(other_study(&name, kept, header)),
                (0, _) => return Err(no_journal(&name)),
                (_, Json::Object(line)) => match (line.get(FILE), line.get("sum")) {
                    (Some(Json::String(path)), Some(Json::String(sum))) => {
                        self.files.insert(path.clone(), sum.clone());
                    }
                    _ if line.contains_key(SPOILED) => return Err(spoiled(&name)),
                    _ => return Err(no_journal(&name)),
                },
                (_, Json::Array(_)) => self.n_rows += 1,
                _ => return Err(no_journal(&name)),
            }
            end += bytes;
        }
        let n_bytes = self.file.metadata().map_or(0, |data| data.len());
        if end == 0 && 0 < n_bytes {
            return Err(no_journal(&name));
        }
        Ok(end)
    }

    /// Adds a row.
    ///
    /// # Errors
    /// That it cannot be written; what was there before is still there.
    pub fn add(&mut self, row: &Row) -> Result<(), String> {
        self.line(&Json::Array(vec![Json::Object(row.clone())]))?;
        self.n_rows += 1;
        Ok(())
    }

    /// Notes a file that rows come from.
    ///
    /// # Errors
    /// That it cannot be written.
    pub fn note(&mut self, path: &str, sum: &str) -> Result<(), String> {
        self.line(&json!({ FILE: path, "sum": sum }))
    }

    /// Notes that the plan was changed while its rows were made: no study goes on from them.
    ///
    /// # Errors
    /// That it cannot be written.
    pub fn spoil(&mut self) -> Result<(), String> {
        self.line(&json!({ SPOILED: true }))
    }

    fn line(&mut self, line: &Json) -> Result<(), String> {
        let line = format!("{line}\n");
        self.file
            .write_all(line.as_bytes())
            .map_err(|err| format!("cannot write `{}`: {}", self.path.display(), io_reason(&err)))
    }

    /// The rows in their order.
    ///
    /// # Errors
    /// That they cannot be read any more.
    pub fn rows(&self) -> Result<impl Iterator<Item = Result<Row, String>> + use<>, String> {
        let rows = lines(&self.file, &self.path)?.filter_map(|line| match line {
            Ok((Some(Json::Array(mut row)), _)) => match row.pop() {
                Some(Json::Object(row)) => Some(Ok(row)),
                _ => None,
            },
            Ok(_) => None,
            Err(message) => Some(Err(message)),
        });
        Ok(rows)
    }

    /// Removes it: all of it stands elsewhere now.
    pub fn remove(self) {
        // One that stays behind is of the same study, and does no harm.
        let _ = fs::remove_file(&self.path);
    }
}

/// The lines of a journal with their lengths; none for one that is not whole.
fn lines(
    file: &File,
    path: &Path,
) -> Result<impl Iterator<Item = Result<(Option<Json>, u64), String>> + use<>, String> {
    let name = path.display().to_string();
    let cannot = move |err: &io::Error| format!("cannot read `{name}`: {}", io_reason(err));
    // The same file, since on some systems its lock keeps others from reading.
    let mut file = file.try_clone().map_err(|err| cannot(&err))?;
    file.rewind().map_err(|err| cannot(&err))?;
    let mut reader = BufReader::new(file);
    Ok(std::iter::from_fn(move || {
        let mut line = Vec::new();
        match reader.read_until(b'\n', &mut line) {
            Ok(0) => None,
            Ok(n_bytes) => {
                let whole =
                    line.strip_suffix(b"\n").and_then(|line| serde_json::from_slice(line).ok());
                Some(Ok((whole, n_bytes as u64)))
            }
            Err(err) => Some(Err(cannot(&err))),
        }
    }))
}

fn spoiled(name: &str) -> String {
    format!(
        "the plan was changed while the rows of `{name}` were made, which may be of either; `--fresh` gives them up, and another name for the results keeps them"
    )
}

fn no_journal(name: &str) -> String {
    format!("`{name}` is not what a study left; remove it, or take another name for the results")
}

/// What makes the study of the journal another one.
fn other_study(name: &str, kept: &Map<String, Json>, wanted: &Map<String, Json>) -> String {
    let members = wanted.iter().filter(|(member, value)| kept.get(*member) != Some(value));
    let differ: Vec<&str> = members.map(|(member, _)| member.as_str()).collect();
    if !kept.contains_key("virote study") {
        return no_journal(name);
    }
    format!(
        "`{name}` was left by a study with another {}; `--fresh` gives up its rows, and another name for the results keeps them",
        differ.join(" and another ")
    )
}
