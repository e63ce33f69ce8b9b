//! The window through which operations see files. The doors implement it.

use std::{collections::BTreeMap, fmt::Debug};

use crate::diag::{Code, Diagnostic, Fix, Span, nearest};

/// Reads files that a script names.
pub trait Files: Debug + Send + Sync {
    /// The bytes of the file at `path`, which is relative to the script. Of a file of more than
    /// `most` bytes the first of them, and more than `most`: whoever asks knows which ceiling that is.
    ///
    /// # Errors
    /// A sentence for the user: that there is no such file, that it is a folder.
    fn read(&self, path: &str, most: usize) -> Result<Vec<u8>, String>;

    /// The names of files in the folder of `path`, as far as they are known: for whoever misspelt one.
    fn beside(&self, _path: &str) -> Vec<String> {
        Vec::new()
    }
}

/// The finding that a file is missing, with the name of the one in its folder that is most likely meant, which can take
/// the place of the name in the string at `place`; else with the hint `remedy`.
#[must_use]
pub fn missing_file(
    files: &dyn Files,
    path: &str,
    (place, message): (Span, String),
    remedy: &str,
) -> Box<Diagnostic> {
    let found = Diagnostic::error(Code::FileMissing, place, message);
    let name = path.rsplit('/').next().unwrap_or_default();
    let names = files.beside(path);
    let near = nearest(name, names.iter().map(String::as_str)).filter(|near| *near != name);
    Box::new(match near {
        Some(near) => {
            let fix = Fix::file_name(place, name, near);
            fix.into_iter().fold(found.label(format!("did you mean `{near}`?")), Diagnostic::fix)
        }
        None => found.hint(remedy),
    })
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
/// use virote_language::{session::Session, value::MemoryFiles};
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

    fn beside(&self, path: &str) -> Vec<String> {
        let folder = &path[..path.rfind('/').map_or(0, |slash| slash + 1)];
        let names = self.0.keys().filter_map(|known| known.strip_prefix(folder));
        names.filter(|name| !name.contains('/')).map(str::to_owned).collect()
    }
}

fn there_is_no(path: &str) -> String {
    format!("there is no `{path}`")
}
