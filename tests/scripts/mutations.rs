//! Every example, torn: cut at every byte, and with each token lost, doubled, or swapped with the next.
//! Whatever is left is read and evaluated, or refused by messages that point into the text.
//!
//! Evaluation has small ceilings here. `VIROTE_MUTATIONS=all cargo test --test scripts mutations` evaluates
//! every torn script that can be read; without it one of [`READ`] is read, and one of [`EVALUATED`] is evaluated.

use std::{
    env, fs,
    panic::{AssertUnwindSafe, catch_unwind},
    path::PathBuf,
    sync::{
        Mutex,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
    time::{Duration, Instant},
};

use virote::{
    limits::Limits,
    session::{Report, Session},
    syntax,
    value::Files,
};

use crate::support::{folder, programs, report};

/// Of so many torn scripts one is read: no multiple of the three that are made of a token.
const READ: usize = 7;

/// Of so many torn scripts one is evaluated, if it can be read.
const EVALUATED: usize = 70;

/// After so many complaints no more are looked for.
const MOST_COMPLAINTS: usize = 5;

/// Far more than any of the scripts takes with these ceilings.
const PATIENCE: Duration = Duration::from_secs(60);

const LIMITS: Limits = Limits {
    list_length: 20_000,
    steps: 20_000,
    mesh_vertices: 2_000,
    call_depth: 200,
    evaluation_depth: 2_000,
    control_points: 10_000,
    text_bytes: 1 << 20,
    ..Limits::DEFAULT
};

#[derive(Debug)]
struct Examples(PathBuf);

impl Files for Examples {
    fn read(&self, path: &str, _: usize) -> Result<Vec<u8>, String> {
        fs::read(self.0.join(path)).map_err(|_| format!("there is no `{path}`"))
    }
}

/// The texts of the examples.
fn examples() -> Vec<String> {
    let folder = folder("examples");
    let path = |name: &String| folder.join(format!("{name}.geo"));
    programs(&folder).iter().map(|name| fs::read_to_string(path(name)).expect("a script")).collect()
}

/// The tokens of a script and what stands between them: strings and comments whole.
fn tokens(source: &str) -> Vec<&str> {
    let mut tokens = Vec::new();
    let mut rest = source;
    while !rest.is_empty() {
        let (token, behind) = rest.split_at(token_len(rest));
        tokens.push(token);
        rest = behind;
    }
    tokens
}

fn token_len(rest: &str) -> usize {
    let first = rest.chars().next().unwrap_or(' ');
    let while_it = |is: &dyn Fn(char) -> bool| rest.find(|c| !is(c)).unwrap_or(rest.len());
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    if rest.starts_with("//") {
        return while_it(&|c| c != '\n');
    }
    match first {
        '"' => rest[1..].find('"').map_or(rest.len(), |end| end + 2),
        c if c.is_whitespace() => while_it(&char::is_whitespace),
        c if c.is_ascii_digit() => {
            let len = while_it(&|c| is_word(c) || c == '.');
            rest[..len].find("..").unwrap_or(len)
        }
        c if is_word(c) => while_it(&is_word),
        _ => {
            let marks = ["..<", "...", "..", "=>", "|>", "==", "!=", "<=", ">=", "~="];
            marks.iter().find(|mark| rest.starts_with(**mark)).map_or(first.len_utf8(), |m| m.len())
        }
    }
}

/// Reads a torn script, and evaluates it if `is_evaluated` and it can be read; what is wrong with the answer.
fn complaint(
    session: &Session,
    files: &Examples,
    source: &str,
    is_evaluated: bool,
) -> Option<String> {
    let start = Instant::now();
    let (_, found) = syntax::parse(source, &LIMITS);
    let (found, sources) = if found.is_empty() && is_evaluated {
        let Report { diagnostics, .. } = session.run("torn", source.as_bytes(), files, &[]);
        (diagnostics, "evaluated")
    } else {
        (found, "read")
    };
    let labels = found.iter().flat_map(|one| one.others.iter().chain([&one.primary]));
    let outside = labels.map(|label| label.span).find(|span| source.get(span.range()).is_none());
    if let Some(span) = outside {
        return Some(format!("{span:?} lies outside of the text, {sources}:\n{found:#?}"));
    }
    if found.iter().any(|one| one.message.is_empty()) {
        return Some(format!("a message without words: {found:#?}"));
    }
    (start.elapsed() > PATIENCE).then(|| format!("{sources} for {:?}", start.elapsed()))
}

/// Looks into every text of `torn(example)`, on all processors.
fn check(torn: impl Fn(&str) -> Vec<String>) {
    let all: Vec<String> = examples().iter().flat_map(|source| torn(source)).collect();
    assert!(all.len() > 10_000, "{} torn scripts", all.len());
    let is_all = env::var_os("VIROTE_MUTATIONS").is_some();
    let (read, evaluated) = if is_all { (1, 1) } else { (READ, EVALUATED) };
    let next = AtomicUsize::new(0);
    let complaints = Mutex::new(Vec::new());
    let work = || {
        let session = Session::new(LIMITS);
        let files = Examples(folder("examples"));
        loop {
            let at = next.fetch_add(read, Ordering::Relaxed);
            let Some(source) = all.get(at) else { return };
            let look = || complaint(&session, &files, source, at.is_multiple_of(evaluated));
            let found = catch_unwind(AssertUnwindSafe(look));
            let found = found.unwrap_or_else(|_| Some("a panic, told above".to_owned()));
            if let Some(found) = found {
                let mut complaints = complaints.lock().expect("a list");
                complaints.push(format!("{found}\n{source}"));
                if complaints.len() == MOST_COMPLAINTS {
                    return;
                }
            }
        }
    };
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            let thread = thread::Builder::new().stack_size(LIMITS.stack_bytes);
            thread.spawn_scoped(scope, work).expect("a thread");
        }
    });
    report(&complaints.into_inner().expect("a list"));
}

#[test]
fn a_script_that_is_cut_anywhere_is_read_or_refused() {
    check(|source| {
        let cuts = source.char_indices().map(|(at, _)| source[..at].to_owned());
        cuts.collect()
    });
}

#[test]
fn a_script_with_a_token_lost_doubled_or_swapped_is_read_or_refused() {
    check(|source| {
        let whole = tokens(source);
        let is_code = |token: &str| !token.trim().is_empty() && !token.starts_with("//");
        let places: Vec<usize> = (0..whole.len()).filter(|&at| is_code(whole[at])).collect();
        let mut torn = Vec::new();
        for (index, &at) in places.iter().enumerate() {
            let mut lost = whole.clone();
            lost.remove(at);
            torn.push(lost.concat());
            let mut doubled = whole.clone();
            doubled.splice(at..at, [whole[at], " "]);
            torn.push(doubled.concat());
            if let Some(&next) = places.get(index + 1) {
                let mut swapped = whole.clone();
                swapped.swap(at, next);
                torn.push(swapped.concat());
            }
        }
        torn
    });
}
