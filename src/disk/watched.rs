//! Files that are looked at again and again: which of them is another one now.

use std::{
    fs::{self, Permissions},
    io::ErrorKind,
    path::{Path, PathBuf},
    time::{Duration, Instant, SystemTime},
};

/// How long the script may be gone before that is told: editors put a new file in the place of the old.
const MOST_GONE: Duration = Duration::from_millis(24);
/// How long a file that has just changed stays as it is before it counts as written.
const REST: Duration = Duration::from_millis(2);

/// What tells that which is at a path from what was there before.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum FileStamp {
    /// A file: when it was written, how long it is, and who may read it.
    File(Option<SystemTime>, u64, Permissions),
    Folder,
    /// A pipe or a device.
    Special,
    /// Nothing that can be reached.
    Absent(ErrorKind),
}

impl FileStamp {
    /// What is at a path now.
    pub(super) fn of(path: &Path) -> Self {
        match fs::metadata(path) {
            Ok(data) if data.is_file() => {
                Self::File(data.modified().ok(), data.len(), data.permissions())
            }
            Ok(data) if data.is_dir() => Self::Folder,
            Ok(_) => Self::Special,
            Err(err) => Self::Absent(err.kind()),
        }
    }

    fn is_file(&self) -> bool {
        matches!(self, Self::File(..))
    }
}

/// The script and the files that it reads.
pub(crate) struct WatchedFiles {
    /// As they were when the script was carried out last.
    seen: Vec<(PathBuf, FileStamp)>,
    /// As they were at the last look: who still writes is waited for.
    last: Vec<FileStamp>,
    /// Since when the script is gone, and what was told to be in its place.
    gone: Option<(Instant, Option<FileStamp>)>,
    is_first: bool,
}

/// What became of the files.
pub(crate) enum FileChange {
    Nothing,
    /// The script is gone; this is in its place.
    Gone(FileStamp),
    /// This file is another one.
    Saved(String),
}

impl WatchedFiles {
    pub(crate) fn new(script: &Path) -> Self {
        let nothing = FileStamp::Absent(ErrorKind::NotFound);
        let seen = vec![(script.to_path_buf(), nothing.clone())];
        Self { seen, last: vec![nothing], gone: None, is_first: true }
    }

    /// Looks at the script and these files from now on, which were so when they were read.
    pub(crate) fn follow(&mut self, inputs: &[(PathBuf, FileStamp)]) {
        // Of a file that was followed the stamp is older than the run, which may have been slow.
        let known = std::mem::take(&mut self.seen);
        let followed = inputs.iter().map(|input| {
            let known = known.iter().find(|(known, _)| *known == input.0);
            known.unwrap_or(input).clone()
        });
        self.seen = known.first().cloned().into_iter().chain(followed).collect();
        self.last = self.seen.iter().map(|(_, mark)| mark.clone()).collect();
    }

    /// When to look again, who looks that often else: sooner where something has changed.
    pub(crate) fn pause(&self, tick: Duration) -> Duration {
        let is_settled = self.seen.iter().zip(&self.last).all(|((_, seen), last)| seen == last);
        if is_settled { tick } else { tick.min(REST) }
    }

    /// What happened since the script was carried out last.
    pub(crate) fn change(&mut self) -> FileChange {
        let now: Vec<FileStamp> = self.seen.iter().map(|(path, _)| FileStamp::of(path)).collect();
        let is_still = now == self.last || self.is_first;
        self.last.clone_from(&now);
        if !now[0].is_file() {
            let (since, told) = self.gone.get_or_insert((Instant::now(), None));
            if told.as_ref() == Some(&now[0]) || since.elapsed() < MOST_GONE {
                return FileChange::Nothing;
            }
            *told = Some(now[0].clone());
            // When it comes back it is carried out, even if it is the same.
            self.seen[0].1 = now[0].clone();
            return FileChange::Gone(now[0].clone());
        }
        self.gone = None;
        let mut apart = self.seen.iter().zip(&now).filter(|((_, seen), now)| seen != *now);
        let Some(((path, _), _)) = apart.next().filter(|_| is_still) else {
            return FileChange::Nothing;
        };
        let what = path.strip_prefix(".").unwrap_or(path).display().to_string();
        self.is_first = false;
        self.seen.iter_mut().zip(now).for_each(|((_, seen), now)| *seen = now);
        FileChange::Saved(what)
    }
}
