//! Files as a file of another folder names them, with a note of what was read.

use std::sync::PoisonError;

use super::{
    library::{folder, join},
    machine::FileReads,
    memory::FileRead,
};
use crate::value::Files;

/// Files as a file of another folder names them.
#[derive(Debug)]
pub struct RelativeFiles<'a> {
    pub(super) files: &'a dyn Files,
    pub(super) folder: &'a str,
    pub(super) reads: Option<FileReads>,
}

impl<'a> RelativeFiles<'a> {
    /// Files as the file at `path` names them.
    #[must_use]
    pub fn beside(files: &'a dyn Files, path: &'a str) -> Self {
        Self { files, folder: folder(path), reads: None }
    }
}

impl Files for RelativeFiles<'_> {
    fn read(&self, path: &str, most: usize) -> std::result::Result<Vec<u8>, String> {
        let path = join(self.folder, path);
        let outcome = self.files.read(&path, most);
        if let Some(reads) = &self.reads {
            let read = FileRead::new(path, most, &outcome);
            reads.lock().unwrap_or_else(PoisonError::into_inner).insert(read);
        }
        outcome
    }

    fn beside(&self, path: &str) -> Vec<String> {
        self.files.beside(&join(self.folder, path))
    }
}
