//! The window through which operations see files. The doors implement it.

use std::{collections::BTreeMap, fmt::Debug};

/// Reads files that a script names.
pub trait Files: Debug + Send + Sync {
    /// The bytes of the file at `path`, which is relative to the script. Of a file of more than
    /// `most` bytes the first of them, and more than `most`: whoever asks knows which ceiling that is.
    ///
    /// # Errors
    /// A sentence for the user: that there is no such file, that it is a folder.
    fn read(&self, path: &str, most: usize) -> Result<Vec<u8>, String>;
}

/// No files at all: for scripts that read and import nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl Files for NoFiles {
    fn read(&self, path: &str, _: usize) -> Result<Vec<u8>, String> {
        Err(there_is_no(path))
    }
}

/// Files that are held in memory, by their paths relative to the script.
///
/// ```
/// use virote::{session::Session, value::MemoryFiles};
///
/// let files = MemoryFiles::from([("part.geo", "let size = 3mm")]);
/// let report = Session::default().run("demo", b"import \"part.geo\"\nprint part.size", &files, &[]);
/// assert!(report.diagnostics.is_empty());
/// ```
#[derive(Clone, Debug, Default)]
pub struct MemoryFiles(BTreeMap<String, Vec<u8>>);

impl MemoryFiles {
    /// Puts a file there, in the place of one that was.
    pub fn insert(&mut self, path: impl Into<String>, bytes: impl Into<Vec<u8>>) {
        self.0.insert(path.into(), bytes.into());
    }
}

impl<P: Into<String>, B: Into<Vec<u8>>, const N: usize> From<[(P, B); N]> for MemoryFiles {
    fn from(files: [(P, B); N]) -> Self {
        Self(files.into_iter().map(|(path, bytes)| (path.into(), bytes.into())).collect())
    }
}

impl Files for MemoryFiles {
    fn read(&self, path: &str, most: usize) -> Result<Vec<u8>, String> {
        let bytes = self.0.get(path).ok_or_else(|| there_is_no(path))?;
        Ok(bytes[..bytes.len().min(most.saturating_add(1))].to_vec())
    }
}

fn there_is_no(path: &str) -> String {
    format!("there is no `{path}`")
}
