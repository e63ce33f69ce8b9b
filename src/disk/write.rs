//! Writing: a file appears whole or not at all, and never outside the output folder.
//!
//! Each file is written under a temporary name in its own folder, flushed to the disk, and
//! renamed over its final name once all files of the run are so far. Whatever fails before that
//! leaves the old files as they were.

use std::{
    collections::BTreeSet,
    fs::{self, File},
    io::{self, BufWriter, Write},
    path::{Path, PathBuf},
    sync::{Mutex, PoisonError},
    time::Duration,
};

use crate::export::{ExportError, Summary, capped};

/// A file of the output folder that may be written.
#[derive(Debug)]
pub struct OutputTarget {
    folder: PathBuf,
    path: PathBuf,
}

/// Why a target is refused before anything is written.
#[derive(Debug)]
pub enum TargetRefusal {
    /// The script may not write there.
    Forbidden(String),
    /// The operating system does not let us.
    System(String),
}

impl OutputTarget {
    /// The file `path` below `out`. `inputs` are files that must stay as they are.
    ///
    /// Makes no folder and no file; folders that exist are looked through, so that a symbolic
    /// link cannot lead out of the output folder.
    pub fn new(out: &Path, path: &str, inputs: &[PathBuf]) -> Result<Self, TargetRefusal> {
        let full = out.join(path);
        let folder = full.parent().unwrap_or(out).to_path_buf();
        if full.is_dir() {
            return Err(TargetRefusal::Forbidden(format!("`{path}` is a folder")));
        }
        if let (Ok(root), Some(real)) = (out.canonicalize(), existing(&folder))
            && !real.starts_with(&root)
        {
            return Err(TargetRefusal::Forbidden(format!(
                "`{path}` leads out of the output folder through a link"
            )));
        }
        let same = |input: &PathBuf| match (input.canonicalize(), full.canonicalize()) {
            (Ok(input), Ok(full)) => input == full,
            _ => false,
        };
        if inputs.iter().any(same) {
            return Err(TargetRefusal::Forbidden(format!(
                "`{path}` is the script or one of its inputs"
            )));
        }
        if let Some(obstacle) = obstacle(&folder) {
            let message = format!("`{}` is a file, not a folder", obstacle.display());
            return Err(TargetRefusal::System(message));
        }
        Ok(Self { folder, path: full })
    }

    /// The same, where the file is a link the one behind it, which need not be there.
    ///
    /// # Errors
    /// Links that lead round in a circle.
    pub(crate) fn behind_links(self) -> io::Result<Self> {
        Ok(Self { path: behind_links(&self.path)?, ..self })
    }

    /// Whether it could be written: makes a temporary file in its folder, or in the innermost one on the
    /// way that exists, and takes it away.
    pub(crate) fn probe(&self) -> io::Result<()> {
        let name = self.path.file_name().unwrap_or_default();
        let folder = existing(&self.folder).unwrap_or_default();
        let (_, temporary) = temporary(&folder.join(name))?;
        fs::remove_file(temporary)
    }

    /// Writes the file, of no more than `most` bytes, through `write`, under a temporary name;
    /// tells `progress` how far it is.
    pub(crate) fn stage(
        &self,
        most: u64,
        progress: &dyn Fn(u64),
        write: impl FnOnce(&mut dyn Write) -> Result<Summary, ExportError>,
    ) -> Result<(StagedFile, Summary), ExportError> {
        make_folder(&self.folder)?;
        let staged = StagedFile::new(&self.path, None, |out| capped(out, most, progress, write));
        staged.inspect_err(|_| clear_made(&self.folder))
    }
}

/// A whole file under a temporary name, which goes with it unless it is put into its place.
#[derive(Debug)]
pub(crate) struct StagedFile {
    temporary: PathBuf,
    path: PathBuf,
}

impl StagedFile {
    /// What `write` writes, with what it tells.
    fn new<T, E: From<io::Error>>(
        path: &Path,
        permissions: Option<fs::Permissions>,
        write: impl FnOnce(&mut dyn Write) -> Result<T, E>,
    ) -> Result<(Self, T), E> {
        let (file, temporary) = temporary(path)?;
        let staged = Self { temporary, path: path.to_path_buf() };
        let mut out = BufWriter::with_capacity(1 << 18, file);
        let told = write(&mut out)?;
        let file = out.into_inner().map_err(io::IntoInnerError::into_error)?;
        if let Some(permissions) = permissions {
            file.set_permissions(permissions)?;
        }
        file.sync_all()?;
        Ok((staged, told))
    }

    /// Puts it into its place.
    pub(crate) fn place(self) -> io::Result<()> {
        fs::rename(&self.temporary, &self.path)?;
        // The name itself is on the disk when its folder is; not every system lets one ask.
        if let Some(folder) = self.path.parent()
            && let Ok(folder) =
                File::open(if folder.as_os_str().is_empty() { Path::new(".") } else { folder })
        {
            let _ = folder.sync_all();
        }
        Ok(())
    }
}

impl Drop for StagedFile {
    fn drop(&mut self) {
        // The temporary file is ours alone; of one that is in its place there is none.
        let _ = fs::remove_file(&self.temporary);
        self.path.parent().into_iter().for_each(clear_made);
    }
}

/// Rewrites a file, behind its links and with its permissions.
pub(crate) fn overwrite(path: &Path, text: &str) -> io::Result<()> {
    let real = path.canonicalize()?;
    let permissions = fs::metadata(&real)?.permissions();
    // The new file takes the place of the old one, which asks only for the folder's permission.
    if permissions.readonly() {
        return Err(io::Error::other("the file may only be read"));
    }
    replace(&real, Some(permissions), |out| out.write_all(text.as_bytes()))
}

/// Puts what `write` writes in the place of the file `path`, behind its links, which is there whole or
/// not at all.
pub fn replace<T, E: From<io::Error>>(
    path: &Path,
    permissions: Option<fs::Permissions>,
    write: impl FnOnce(&mut dyn Write) -> Result<T, E>,
) -> Result<T, E> {
    let (staged, told) = StagedFile::new(&behind_links(path)?, permissions, write)?;
    staged.place()?;
    Ok(told)
}

/// The file that a path leads to by the links at its end, whether it is there or not.
fn behind_links(path: &Path) -> io::Result<PathBuf> {
    /// Links that lead to one another; systems allow no more.
    const MOST_LINKS: usize = 40;
    let mut path = path.to_path_buf();
    for _ in 0..MOST_LINKS {
        let Ok(next) = fs::read_link(&path) else { return Ok(path) };
        path = path.parent().unwrap_or(Path::new("")).join(next);
    }
    Err(io::Error::other("its links lead round in a circle"))
}

/// Folders that this process made.
static MADE: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// Makes a folder and those around it, and notes which were made.
fn make_folder(folder: &Path) -> io::Result<()> {
    let missing = folder.ancestors().filter(|part| !part.as_os_str().is_empty() && !part.exists());
    let missing: Vec<PathBuf> = missing.map(Path::to_path_buf).collect();
    let made = fs::create_dir_all(folder);
    MADE.lock().unwrap_or_else(PoisonError::into_inner).extend(missing);
    made.inspect_err(|_| clear_made(folder))
}

/// Removes a folder and those around it as far as this process made them and nothing is in them.
fn clear_made(folder: &Path) {
    let mut made = MADE.lock().unwrap_or_else(PoisonError::into_inner);
    for part in folder.ancestors() {
        let is_gone = || fs::remove_dir(part).is_ok() || !part.exists();
        if made.contains(part) && is_gone() {
            made.remove(part);
        }
    }
}

/// A new file beside `path` that nobody else has.
fn temporary(path: &Path) -> io::Result<(File, PathBuf)> {
    /// Names tried before giving up.
    const MOST_TRIES: u32 = 1000;
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    clear_old(path, &name);
    let process = std::process::id();
    for attempt in 0..MOST_TRIES {
        let path = path.with_file_name(format!(".{name}.{process}-{attempt}.tmp"));
        match File::options().write(true).create_new(true).open(&path) {
            Ok(file) => return Ok((file, path)),
            Err(err) if err.kind() == io::ErrorKind::AlreadyExists => {}
            Err(err) => return Err(err),
        }
    }
    Err(io::Error::new(io::ErrorKind::AlreadyExists, "no free name for a temporary file"))
}

/// Removes temporary files for `path` that runs left which were killed long ago.
fn clear_old(path: &Path, name: &str) {
    /// No run takes so long between two writes.
    const OLD: Duration = Duration::from_secs(24 * 60 * 60);
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let Ok(entries) = fs::read_dir(folder.unwrap_or(Path::new("."))) else { return };
    let is_count = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    for entry in entries.flatten() {
        let found = entry.file_name();
        let marks = found.to_str().and_then(|found| {
            let rest = found.strip_prefix('.')?.strip_prefix(name)?.strip_prefix('.')?;
            rest.strip_suffix(".tmp")?.split_once('-')
        });
        let is_ours =
            marks.is_some_and(|(process, attempt)| is_count(process) && is_count(attempt));
        let age =
            || entry.metadata().ok().filter(fs::Metadata::is_file)?.modified().ok()?.elapsed().ok();
        if is_ours && age().is_some_and(|age| OLD < age) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// The real path of the innermost folder on the way that exists.
fn existing(folder: &Path) -> Option<PathBuf> {
    folder.ancestors().find_map(|folder| {
        let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        folder.canonicalize().ok()
    })
}

/// A file that stands where a folder is needed, a device as well.
fn obstacle(folder: &Path) -> Option<&Path> {
    folder.ancestors().find(|part| part.exists() && !part.is_dir())
}
