//! What lies in a folder, for who completes a path.

use std::{fs, path::Path};

use crate::ide::FolderEntry;

/// The entries of a folder, but for hidden ones.
pub(crate) fn entries(folder: &Path) -> Vec<FolderEntry> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let mut found: Vec<FolderEntry> = entries
        .flatten()
        .filter_map(|entry| {
            let name = entry.file_name().into_string().ok()?;
            let is_folder = entry.path().is_dir();
            (!name.starts_with('.')).then_some(FolderEntry { name, is_folder })
        })
        .collect();
    found.sort_by(|a, b| a.name.cmp(&b.name));
    found
}
