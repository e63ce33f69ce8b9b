//! The window through which operations see files. The doors implement it.

use std::fmt::Debug;

/// Reads files that a script names.
pub trait Files: Debug + Send + Sync {
    /// The bytes of the file at `path`, which is relative to the script. Of a file of more than
    /// `most` bytes the first of them, and more than `most`: whoever asks knows which ceiling that is.
    ///
    /// # Errors
    /// A sentence for the user: that there is no such file, that it is a folder.
    fn read(&self, path: &str, most: usize) -> Result<Vec<u8>, String>;
}
