//! Files that are looked at again and again: which of them is another one now.

use std::{
    fs,
    path::{Path, PathBuf},
    time::{Duration, Instant, SystemTime},
};

/// How long the script may be gone before that is told: editors put a new file in the place of the old.
const MOST_GONE: Duration = Duration::from_millis(24);

/// What tells a file from the one that stood in its place before: when it was written, and its
/// length; nothing where there is none.
pub(crate) type FileStamp = Option<(SystemTime, u64)>;

/// What a file is now.
pub(super) fn stamp(path: &Path) -> FileStamp {
    let data = fs::metadata(path).ok().filter(fs::Metadata::is_file)?;
    Some((data.modified().ok()?, data.len()))
}

/// The script and the files that it reads.
pub(crate) struct WatchedFiles {
    /// As they were when the script was carried out last.
    seen: Vec<(PathBuf, FileStamp)>,
    /// As they were at the last look: who still writes is waited for.
    last: Vec<FileStamp>,
    /// Since when the script is gone, and what was told of it.
    gone: Option<(Instant, Option<Absence>)>,
    is_first: bool,
}

/// What is in the place of a script that is gone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Absence {
    Nothing,
    Folder,
}

/// What became of the files.
pub(crate) enum FileChange {
    Nothing,
    /// The script is gone.
    Gone(Absence),
    /// This file is another one.
    Saved(String),
}

impl WatchedFiles {
    pub(crate) fn new(script: &Path) -> Self {
        let seen = vec![(script.to_path_buf(), None)];
        Self { seen, last: vec![None], gone: None, is_first: true }
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
        self.last = self.seen.iter().map(|(_, mark)| *mark).collect();
    }

    /// What happened since the script was carried out last.
    pub(crate) fn change(&mut self) -> FileChange {
        let now: Vec<FileStamp> = self.seen.iter().map(|(path, _)| stamp(path)).collect();
        let is_still = now == self.last || self.is_first;
        self.last.clone_from(&now);
        if now[0].is_none() {
            let (since, told) = *self.gone.get_or_insert((Instant::now(), None));
            let absence = if self.seen[0].0.is_dir() { Absence::Folder } else { Absence::Nothing };
            if told == Some(absence) || since.elapsed() < MOST_GONE {
                return FileChange::Nothing;
            }
            self.gone = Some((since, Some(absence)));
            // When it comes back it is carried out, even if it is the same.
            self.seen[0].1 = None;
            return FileChange::Gone(absence);
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
