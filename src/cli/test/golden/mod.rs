//! Golden folders: what a script says and writes, kept in `NAME.golden/` beside `NAME.geo`.
//!
//! ```text
//! door.golden/golden.json              how it is compared: `header`
//! door.golden/printed.txt              what is printed, line by line: `lines`
//! door.golden/warnings.txt             the warnings, likewise
//! door.golden/files/door.csv           a table, compared column by column: `table`
//! door.golden/files/door.obj.measures  a file of meshes, by measure: `measures`
//! door.golden/files/door.step          other texts line by line, anything else by bytes
//! ```

mod difference;
mod header;
mod keep;
mod lines;
mod measures;
mod table;

use std::{
    fs,
    path::{Path, PathBuf},
};

use self::{header::Header, lines::RelativeTolerance};
use crate::{
    cli::{exit_status::ExitStatus, run},
    diag::{Diagnostic, Severity},
    disk::read_whole,
    export::{self, MeasuredPart, capped, io_reason},
    limits::Limits,
    session::{Event, File, Report},
};

pub(super) use self::difference::Difference;

/// The name of the header.
const HEADER: &str = "golden.json";
/// The name of the file with the printed lines.
const PRINTED: &str = "printed.txt";
/// The name of the file with the warnings.
const WARNINGS: &str = "warnings.txt";
/// The folder of the exported files.
const FILES: &str = "files";
/// What the name of a file of meshes is followed by.
const MEASURES: &str = "measures";

/// What is asked of a golden folder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum GoldenMode {
    /// That nothing changed.
    Compare,
    /// That it holds what the script says and writes now, if there is one.
    Bless,
    /// The same, and that there is one.
    Make,
}

/// How it came out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum GoldenOutcome {
    /// So many files are as they were.
    Same(usize),
    /// Something is not.
    Apart(Vec<Difference>),
    /// So many files were written, with what that changed.
    Blessed(usize, Vec<Difference>),
    /// The script has an error, so that not all of it is known.
    Skipped,
    /// The folder cannot be read or written.
    Unusable(String),
}

/// The golden folder of a script.
pub(super) fn folder(script: &Path) -> PathBuf {
    script.with_extension("golden")
}

/// Compares what a script came to with its golden folder, or rewrites that; none if there is none.
/// What cannot be exported becomes a finding of the report.
pub(super) fn judge(
    report: &mut Report,
    folder: &Path,
    wish: GoldenMode,
    limits: &Limits,
) -> Option<(GoldenOutcome, ExitStatus)> {
    let is_said = |event: &Event| !matches!(event, Event::Checked(_));
    let says_something = report.events.iter().any(is_said) || 0 < report.count(Severity::Warning);
    let is_there = folder.symlink_metadata().is_ok();
    if !is_there && (wish != GoldenMode::Make || !says_something) {
        return None;
    }
    if 0 < report.count_untested_errors() {
        return Some((GoldenOutcome::Skipped, ExitStatus::Wrong));
    }
    let unusable = |message| Some((GoldenOutcome::Unusable(message), ExitStatus::Usage));
    let header = match header(folder, is_there, wish, limits) {
        Ok(header) if wish == GoldenMode::Compare => header,
        Ok(header) => header.newest(),
        Err(message) => return unusable(message),
    };
    let pages = match pages(report, header, limits) {
        Ok(pages) => pages,
        Err((found, ending)) => {
            report.diagnostics.push(*found);
            return Some((GoldenOutcome::Skipped, ending));
        }
    };
    let apart = match compare(&pages, folder, header, wish, limits) {
        Ok(apart) => apart,
        Err(message) => return unusable(message),
    };
    match wish {
        GoldenMode::Compare if apart.is_empty() => {
            Some((GoldenOutcome::Same(pages.len()), ExitStatus::Well))
        }
        GoldenMode::Compare => Some((GoldenOutcome::Apart(apart), ExitStatus::Failed)),
        GoldenMode::Bless | GoldenMode::Make => match keep::write(&pages, folder, header) {
            Ok(()) => Some((GoldenOutcome::Blessed(pages.len(), apart), ExitStatus::Well)),
            Err(message) => unusable(message),
        },
    }
}

/// The header of a folder.
fn header(
    folder: &Path,
    is_there: bool,
    wish: GoldenMode,
    limits: &Limits,
) -> Result<Header, String> {
    let path = folder.join(HEADER);
    if is_there && !folder.is_dir() {
        return Err(format!("`{}` must be a folder", folder.display()));
    }
    if path.symlink_metadata().is_err() {
        return match wish {
            GoldenMode::Compare => Err(format!(
                "`{}` has no `{HEADER}`; `virote test --bless` writes it",
                folder.display()
            )),
            GoldenMode::Bless | GoldenMode::Make => Ok(Header::default()),
        };
    }
    let told = |message: String| format!("`{}` {message}", path.display());
    let bytes = read_whole(&path, limits.input_bytes)
        .map_err(|message| format!("cannot read `{}`: {message}", path.display()))?;
    Header::read(&bytes).map_err(told)
}

/// A file of a golden folder, as it should be.
struct GoldenFile<'a> {
    /// Its path below the folder, with `/` between its parts.
    path: String,
    content: GoldenContent<'a>,
}

/// What it holds, and so how it is compared.
enum GoldenContent<'a> {
    Lines(String),
    Table(Vec<u8>),
    Measures(Vec<MeasuredPart<'a>>),
    Bytes(Vec<u8>),
}

/// What the folder should hold; or what cannot be exported, and how that ends.
fn pages<'a>(
    report: &'a Report,
    header: Header,
    limits: &Limits,
) -> Result<Vec<GoldenFile<'a>>, (Box<Diagnostic>, ExitStatus)> {
    let mut printed = String::new();
    let mut pages = Vec::new();
    for event in &report.events {
        match event {
            Event::Printed(line) => {
                printed += &format!("{line}\n");
            }
            Event::File(file) => {
                let page = page(file, header, limits).map_err(|err| {
                    let (found, ending) = run::refusal(file, &err);
                    (Box::new(found), ending)
                })?;
                pages.push(page);
            }
            Event::Checked(_) | Event::Expected(_) => {}
        }
    }
    let warnings = if header.has_warnings { warnings(report) } else { String::new() };
    let texts = [(PRINTED, printed), (WARNINGS, warnings)].into_iter();
    let mut all: Vec<GoldenFile<'_>> = texts
        .filter(|(_, text)| !text.is_empty())
        .map(|(path, text)| GoldenFile {
            path: path.to_owned(),
            content: GoldenContent::Lines(text),
        })
        .collect();
    all.append(&mut pages);
    Ok(all)
}

/// The warnings of the script and of its tests, a line each, in the order of their places.
fn warnings(report: &Report) -> String {
    let all = report.diagnostics.iter().filter(|found| found.severity == Severity::Warning);
    all.map(|found| format!("{} {}\n", found.code.id(), found.message)).collect()
}

/// A file that the script exports.
fn page<'a>(
    file: &'a File,
    header: Header,
    limits: &Limits,
) -> Result<GoldenFile<'a>, export::ExportError> {
    let path = format!("{FILES}/{}", file.path);
    if !header.by_bytes && file.format.holds_meshes(&file.job.options) {
        let parts = file.watched(|| export::parts(&file.job))?;
        return Ok(GoldenFile {
            path: format!("{path}.{MEASURES}"),
            content: GoldenContent::Measures(parts),
        });
    }
    // It is held in memory, as is what it is compared with.
    let most = file.job.limits.output_bytes.min(limits.input_bytes as u64);
    let mut bytes = Vec::new();
    file.watched(|| capped(&mut bytes, most, &|_| {}, |out| (file.format.write)(&file.job, out)))?;
    let content = if header.by_bytes {
        GoldenContent::Bytes(bytes)
    } else if file.format.takes_tables() {
        GoldenContent::Table(bytes)
    } else {
        match String::from_utf8(bytes) {
            Ok(text) => GoldenContent::Lines(text),
            Err(err) => GoldenContent::Bytes(err.into_bytes()),
        }
    };
    Ok(GoldenFile { path, content })
}

/// Where a folder differs from what it should hold.
fn compare(
    pages: &[GoldenFile<'_>],
    folder: &Path,
    header: Header,
    wish: GoldenMode,
    limits: &Limits,
) -> Result<Vec<Difference>, String> {
    let called = folder.file_name().unwrap_or_default().to_string_lossy();
    let mut apart = Vec::new();
    for page in pages {
        let path = folder.join(&page.path);
        let found = if path.is_file() {
            let bytes = read_whole(&path, limits.input_bytes)
                .map_err(|message| format!("cannot read `{}`: {message}", path.display()))?;
            page.differences(&bytes, header, limits)
        } else {
            vec![Difference::of_whole(if wish == GoldenMode::Compare {
                "is missing"
            } else {
                "is new"
            })]
        };
        let file = format!("{called}/{}", page.path);
        apart.extend(found.into_iter().map(|found| found.in_file(&file)));
    }
    for path in kept(folder)? {
        if !pages.iter().any(|page| page.path == path) {
            let stray = Difference::of_whole("nothing of the script makes this file any more");
            apart.push(stray.in_file(&format!("{called}/{path}")));
        }
    }
    Ok(apart)
}

impl GoldenFile<'_> {
    fn differences(&self, bytes: &[u8], header: Header, limits: &Limits) -> Vec<Difference> {
        let tolerance = RelativeTolerance(header.tolerance);
        let text = std::str::from_utf8(bytes);
        match (&self.content, text) {
            (GoldenContent::Lines(found), Ok(expected)) => {
                lines::differences(expected, found, tolerance)
            }
            (GoldenContent::Measures(parts), Ok(expected)) => {
                measures::differences(expected, parts, tolerance)
            }
            (GoldenContent::Table(found), _) => {
                table::differences(bytes, found, limits.list_length, tolerance)
            }
            (GoldenContent::Bytes(found), _) => of_bytes(bytes, found),
            (_, Err(err)) => {
                let at = err.valid_up_to() + 1;
                vec![Difference::of_whole(format!("byte {at} is not UTF-8 text"))]
            }
        }
    }
}

/// Where bytes differ.
fn of_bytes(expected: &[u8], found: &[u8]) -> Vec<Difference> {
    if expected == found {
        return Vec::new();
    }
    let n_same = expected.iter().zip(found).take_while(|(a, b)| a == b).count();
    let side = |bytes: &[u8]| match bytes.get(n_same) {
        Some(byte) => format!("{byte:#04x} of {} bytes", bytes.len()),
        None => format!("the end of {} bytes", bytes.len()),
    };
    let place = format!("byte {}", n_same + 1);
    vec![Difference::of_texts(place, &side(expected), &side(found))]
}

/// The files that a folder holds besides its header, without those that begin with a point.
fn kept(folder: &Path) -> Result<Vec<String>, String> {
    let mut found = Vec::new();
    let mut folders = vec![String::new()];
    while let Some(prefix) = folders.pop() {
        let place = folder.join(&prefix);
        if !place.is_dir() {
            continue;
        }
        let told = |err| format!("cannot look into `{}`: {}", place.display(), io_reason(&err));
        for entry in fs::read_dir(&place).map_err(told)? {
            let entry = entry.map_err(told)?;
            let name = entry.file_name().to_string_lossy().into_owned();
            let path = format!("{prefix}{name}");
            if name.starts_with('.') || path == HEADER {
                continue;
            }
            // Links to folders are not followed.
            if entry.file_type().map_err(told)?.is_dir() {
                folders.push(format!("{path}/"));
            } else {
                found.push(path);
            }
        }
    }
    found.sort();
    Ok(found)
}
