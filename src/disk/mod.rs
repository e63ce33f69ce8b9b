//! The files of the system, for the doors: read with a ceiling, watched, and written whole or not at
//! all.

mod read;
mod watched;
mod write;

pub(crate) use read::{Script, ScriptFiles, read_whole};
pub(crate) use watched::{FileChange, FileStamp, WatchedFiles};
pub(crate) use write::{OutputTarget, StagedFile, TargetRefusal, overwrite, replace};
