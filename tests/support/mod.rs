//! Runs the built command on programs and compares what it says and writes with golden files.
//!
//! `VIROTE_BLESS=1 cargo test` rewrites the golden files. Read the difference before you keep it.

#![allow(dead_code, reason = "each test binary uses its own part")]

use std::{
    env,
    ffi::OsStr,
    fmt::Write as _,
    fs,
    path::{Path, PathBuf},
    process::{Command, Output, Stdio},
    sync::{
        Mutex,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
};

/// Text files up to this size stand in the golden file; of others it tells the size.
const MOST_BYTES_SHOWN: usize = 4096;

/// The environment variable that rewrites golden files.
const BLESS: &str = "VIROTE_BLESS";

/// The command, in a folder, without colour.
pub(crate) fn virote(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_virote"));
    command.current_dir(folder).env("NO_COLOR", "1").stdin(Stdio::null());
    command
}

/// A folder of the repository.
pub(crate) fn folder(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// A new empty folder that is removed with this value.
pub(crate) struct Scratch(pub(crate) PathBuf);

impl Scratch {
    /// `name` tells the folder from those of other tests.
    pub(crate) fn new(name: &str) -> Self {
        let path =
            Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).expect("a scratch folder");
        Self(path)
    }

    /// Writes a file into the folder.
    pub(crate) fn file(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(&path, content).expect("a scratch file");
        path
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// The programs of a folder by name.
pub(crate) fn programs(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .expect("a folder of programs")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension() == Some(OsStr::new("geo")))
        .map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// What is to complain about in the programs of a folder, which are looked at on all processors, in order.
pub(crate) fn complaints_of(
    folder: &Path,
    look: impl Fn(&str) -> Vec<String> + Sync,
) -> Vec<String> {
    let (names, next) = (programs(folder), AtomicUsize::new(0));
    let found = Mutex::new(Vec::new());
    let work = || {
        while let Some(name) = names.get(next.fetch_add(1, Ordering::Relaxed)) {
            let complaints = look(name);
            found.lock().expect("a list").push((name, complaints));
        }
    };
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    let mut found = found.into_inner().expect("a list");
    found.sort();
    found.into_iter().flat_map(|(_, complaints)| complaints).collect()
}

/// Every file below a folder, as paths with `/`, in order.
pub(crate) fn files_below(folder: &Path) -> Vec<String> {
    fn visit(folder: &Path, prefix: &str, found: &mut Vec<String>) {
        let Ok(entries) = fs::read_dir(folder) else { return };
        for entry in entries {
            let entry = entry.expect("an entry");
            let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
            if entry.path().is_dir() {
                visit(&entry.path(), &format!("{name}/"), found);
            } else {
                found.push(name);
            }
        }
    }
    let mut found = Vec::new();
    visit(folder, "", &mut found);
    found.sort();
    found
}

/// Arguments that a program asks for in its first line: `// --set n=3`.
fn arguments(script: &Path) -> Vec<String> {
    let bytes = fs::read(script).expect("a program");
    let text = String::from_utf8_lossy(&bytes);
    let line = text.lines().next().unwrap_or_default();
    match line.strip_prefix("// --") {
        Some(rest) => format!("--{rest}").split_whitespace().map(str::to_owned).collect(),
        None => Vec::new(),
    }
}

/// Runs `NAME.geo` in its folder; the exit code, and everything that it says and writes as text.
pub(crate) fn transcript(folder: &Path, name: &str) -> (i32, String) {
    let out = Scratch::new(&format!("out-{name}"));
    let script = format!("{name}.geo");
    let output = virote(folder)
        .args(["run", &script, "--out"])
        .arg(&out.0)
        .args(arguments(&folder.join(&script)))
        .output()
        .expect("the command runs");
    let code = output.status.code().unwrap_or(-1);
    let mut text = String::new();
    section(&mut text, "standard output", &output.stdout);
    section(&mut text, "standard error", &output.stderr);
    for file in files_below(&out.0) {
        let content = fs::read(out.0.join(&file)).expect("a written file");
        match std::str::from_utf8(&content) {
            Ok(_) if content.len() <= MOST_BYTES_SHOWN => section(&mut text, &file, &content),
            _ => {
                let _ = writeln!(
                    text,
                    "--- {file}: {} bytes, sum {:016x}",
                    content.len(),
                    sum(&content)
                );
            }
        }
    }
    let _ = writeln!(text, "--- exit code {code}");
    // Paths of this machine have no place in a golden file.
    let text = text.replace(&*out.0.to_string_lossy(), "OUT");
    (code, text)
}

/// FNV-1a of the bytes, so that a change of equal length shows.
fn sum(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |sum, &byte| {
        (sum ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

fn section(text: &mut String, title: &str, content: &[u8]) {
    if content.is_empty() {
        return;
    }
    let content = String::from_utf8_lossy(content);
    let _ = write!(text, "--- {title}\n{content}");
    if !content.ends_with('\n') {
        text.push_str("\n(no line break at the end)\n");
    }
}

/// Compares `text` with the golden file, or rewrites that; what is wrong, if anything.
pub(crate) fn compare(golden: &Path, text: &str) -> Option<String> {
    if env::var_os(BLESS).is_some() {
        fs::create_dir_all(golden.parent().expect("a folder")).expect("a folder");
        fs::write(golden, text).expect("a golden file");
        return None;
    }
    let shown = golden.strip_prefix(env!("CARGO_MANIFEST_DIR")).unwrap_or(golden).display();
    match fs::read_to_string(golden) {
        Err(_) => Some(format!(
            "{shown} is missing; {BLESS}=1 cargo test writes it. Read it before you keep it:\n{text}"
        )),
        Ok(expected) if expected == text => None,
        Ok(expected) => Some(format!(
            "{shown} differs; {BLESS}=1 cargo test rewrites it.\n{}",
            difference(&expected, text)
        )),
    }
}

/// The first lines that differ.
fn difference(expected: &str, found: &str) -> String {
    let (expected, found): (Vec<&str>, Vec<&str>) =
        (expected.lines().collect(), found.lines().collect());
    let n_same = expected.iter().zip(&found).take_while(|(a, b)| a == b).count();
    let mut text = format!("from line {}:\n", n_same + 1);
    for (sign, lines) in [('-', &expected), ('+', &found)] {
        for line in lines.iter().skip(n_same).take(12) {
            let _ = writeln!(text, "{sign} {line}");
        }
    }
    text
}

/// Fails with all complaints at once.
#[track_caller]
pub(crate) fn report(complaints: &[String]) {
    assert!(complaints.is_empty(), "{}\n({} in all)", complaints.join("\n"), complaints.len());
}

/// Standard output, standard error and exit code.
pub(crate) fn told(output: &Output) -> (String, String, i32) {
    (
        String::from_utf8_lossy(&output.stdout).into_owned(),
        String::from_utf8_lossy(&output.stderr).into_owned(),
        output.status.code().unwrap_or(-1),
    )
}
