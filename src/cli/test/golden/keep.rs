//! Writes what a golden folder should hold, and takes out of it what no script makes any more.

use std::{fs, path::Path};

use super::{
    FILES, GoldenContent, GoldenFile, HEADER, PRINTED, WARNINGS, header::Header, kept, measures,
};
use crate::{
    disk::{OutputTarget, StagedFile, TargetRefusal},
    export::{ExportError, Summary, io_reason},
};

/// Writes all files of the folder, behind their links, the header last; none is put into its place
/// before all are written. Of a folder that could not be filled nothing stays.
pub(super) fn write(pages: &[GoldenFile<'_>], folder: &Path, header: Header) -> Result<(), String> {
    let mut staged = Vec::with_capacity(pages.len() + 1);
    for page in pages {
        staged.push(stage(folder, &page.path, &page.content.bytes())?);
    }
    staged.push(stage(folder, HEADER, header.text().as_bytes())?);
    for staged in staged {
        staged.place().map_err(|err| cannot(folder, "", &ExportError::Io(err)))?;
    }
    for path in kept(folder)? {
        let is_ours =
            [PRINTED, WARNINGS].contains(&&*path) || path.starts_with(&format!("{FILES}/"));
        if is_ours && !pages.iter().any(|page| page.path == path) {
            let path = folder.join(path);
            fs::remove_file(&path).map_err(|err| {
                format!("cannot remove `{}`: {}", path.display(), io_reason(&err))
            })?;
        }
    }
    Ok(())
}

fn stage(folder: &Path, path: &str, bytes: &[u8]) -> Result<StagedFile, String> {
    let target = OutputTarget::new(folder, path, &[]).map_err(|refusal| match refusal {
        TargetRefusal::Forbidden(message) | TargetRefusal::System(message) => message,
    })?;
    let target = target.behind_links().map_err(|err| cannot(folder, path, &err.into()))?;
    let written = target.stage(u64::MAX, &|_| {}, |out| {
        out.write_all(bytes)?;
        Ok(Summary::default())
    });
    written.map(|(staged, _)| staged).map_err(|err| cannot(folder, path, &err))
}

fn cannot(folder: &Path, path: &str, err: &ExportError) -> String {
    format!("cannot write `{}`: {}", folder.join(path).display(), err.reason())
}

impl GoldenContent<'_> {
    /// As it is kept.
    fn bytes(&self) -> Vec<u8> {
        match self {
            Self::Lines(text) => text.as_bytes().to_vec(),
            Self::Table(bytes) | Self::Bytes(bytes) => bytes.clone(),
            Self::Measures(parts) => measures::text(parts).into_bytes(),
        }
    }
}
