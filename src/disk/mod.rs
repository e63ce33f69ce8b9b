//! The files of the system, for the doors: read with a ceiling, watched, and written whole or not at
//! all.

mod folder;
mod read;
mod watched;
mod write;

pub(crate) use folder::entries;
pub(crate) use read::read_whole;
pub use read::{Script, ScriptFiles};
pub(crate) use watched::{FileChange, FileStamp, WatchedFiles};
pub use write::{OutputTarget, TargetRefusal, replace};
pub(crate) use write::{StagedFile, overwrite};
