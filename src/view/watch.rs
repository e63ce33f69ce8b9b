//! Looks at the script and the files that it reads.

use std::{
    path::{Path, PathBuf},
    sync::{Mutex, PoisonError},
    thread,
    time::Duration,
};

use super::hub::Hub;
use crate::disk::{FileChange, FileStamp, WatchedFiles};

/// How often files are looked at while somebody looks at the page, and while nobody does.
const TICKS: [Duration; 2] = [Duration::from_millis(4), Duration::from_millis(100)];

/// The files as they are now: the first run, which is wanted from the beginning, reads them so or newer.
pub(super) fn begin(script: &Path) -> WatchedFiles {
    let mut watched = WatchedFiles::new(script);
    let _ = watched.change();
    watched
}

/// Tells the hub of every change, until all is over.
pub(super) fn watch(
    hub: &Hub,
    mut watched: WatchedFiles,
    followed: &Mutex<Vec<(PathBuf, FileStamp)>>,
) {
    let mut known = Vec::new();
    while !hub.is_over() {
        let now = followed.lock().unwrap_or_else(PoisonError::into_inner).clone();
        if now != known {
            watched.follow(&now);
            known = now;
        }
        match watched.change() {
            FileChange::Nothing => {}
            FileChange::Saved(_) | FileChange::Gone(_) => hub.files_changed(),
        }
        hub.hurry();
        thread::sleep(watched.pause(TICKS[usize::from(!hub.has_listeners())]));
    }
}
