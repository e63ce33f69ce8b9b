//! The command line: arguments, files, exit codes. With the renderer the only part that reads
//! files, the environment or the terminal.

mod args;
mod fmt;
mod graph;
mod inspect;
mod interrupt;
mod limits;
mod looks;
mod params;
mod process;
mod progress;
mod render;
mod repl;
mod reporter;
mod run;
mod settings;
mod shell;
mod test;
mod view;
mod watch;

use std::{
    io::{self, Write},
    process::ExitCode,
    sync::{
        OnceLock,
        atomic::{AtomicBool, Ordering},
    },
};

use clap::Parser as _;

use self::args::{Cli, CliCommand};
use crate::{
    diag::{Code, Severity, fault, shown},
    docs,
    export::io_reason,
    ops,
    session::Report,
    syntax::{KEYWORDS, ast::Unit},
};

/// How a run ended; the numbers are part of the contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ExitStatus {
    /// All is well.
    Well = 0,
    /// A check or test failed.
    Failed = 1,
    /// The script has an error.
    Wrong = 2,
    /// The command was used wrongly, something could not be read or written, or virote failed.
    Usage = 3,
}

impl ExitStatus {
    /// How a script ended by what was found in it.
    fn of(report: &Report) -> Self {
        if report.diagnostics.iter().any(|found| found.code == Code::Fault) {
            Self::Usage
        } else if report.count(Severity::Error) > 0 {
            Self::Wrong
        } else if report.count(Severity::Failure) > 0 {
            Self::Failed
        } else {
            Self::Well
        }
    }
}

impl From<ExitStatus> for ExitCode {
    fn from(ending: ExitStatus) -> Self {
        Self::from(ending as u8)
    }
}

/// Runs the command with the arguments of the process; `held` tells how many bytes of memory that
/// holds.
#[must_use]
pub fn main(held: fn() -> usize) -> ExitCode {
    fault::listen();
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(err) if err.use_stderr() => {
            let _ = err.print();
            return ExitStatus::Usage.into();
        }
        // Asking for help or the version is no mistake.
        Err(err) => {
            if let Err(err) = err.print().and_then(|()| io::stdout().flush()) {
                miss(&err);
            }
            return spoken(ExitStatus::Well).into();
        }
    };
    process::run(held, || spoken(dispatch(cli.verb)))
}

fn dispatch(verb: CliCommand) -> ExitStatus {
    match verb {
        CliCommand::Run { file, out, only, dry_run, common } => {
            run::run(&file, out.as_deref(), dry_run, &only, &common)
        }
        CliCommand::Check { files, common } => run::check(&files, &common),
        CliCommand::Test(asked) => test::run(&asked),
        CliCommand::Params { file, json, talk } => params::run(&file, json, &talk),
        CliCommand::Graph { file, json, talk } => graph::run(&file, json, &talk),
        CliCommand::Repl { file, out, common } => {
            repl::run(file.as_deref(), out.as_deref(), &common)
        }
        CliCommand::Render { file, out, drawn, common } => {
            render::run(&file, &out, &drawn, &common)
        }
        CliCommand::Fmt { files, check, talk } => fmt::run(&files, check, &talk),
        CliCommand::Watch(asked) => watch::run(&asked),
        CliCommand::View(asked) => view::run(&asked),
        CliCommand::Doc { words, search } => doc(&words, search),
        CliCommand::Explain { code } => explain(code.as_deref()),
        CliCommand::Completions { shell } => shell::completions(shell),
        CliCommand::Man { verb } => shell::man(verb.as_deref()),
    }
}

fn doc(words: &[String], is_search: bool) -> ExitStatus {
    let registry = ops::registry();
    let query = words.join(" ");
    let found = match (query.as_str(), is_search) {
        ("", _) => Some(docs::overview(&registry)),
        (query, false) => docs::entry(&registry, query).or_else(|| docs::chapter(&registry, query)),
        (_, true) => None,
    };
    let language = || docs::language::entry(&query).filter(|_| !is_search);
    // Units and keywords are words of this language, whatever they are elsewhere.
    let is_own = KEYWORDS.contains(&query.as_str()) || Unit::from_name(&query).is_some();
    let foreign =
        crate::eval::foreign_advice(&query).filter(|_| !is_search && !is_own && found.is_none());
    if let Some(advice) = foreign {
        let passage = language().map(|passage| format!("\n{passage}")).unwrap_or_default();
        say(&format!("nothing built in is called `{query}`: {advice}\n{passage}"));
        return ExitStatus::Well;
    }
    let found = found.or_else(language);
    if let Some(text) = found.or_else(|| docs::search(&registry, &query)) {
        say(&text);
        return ExitStatus::Well;
    }
    if words.len() == 1 && !is_search {
        let near = crate::diag::nearest(
            &query,
            registry.names().chain(docs::chapters()).chain(docs::language::words()),
        );
        let near = near.map(|near| format!("; did you mean `{near}`?")).unwrap_or_default();
        say_error(&format!("virote: nothing built in is called `{query}`{near}"));
    } else {
        say_error(&format!("virote: nothing built in is about `{query}`"));
    }
    ExitStatus::Usage
}

fn explain(code: Option<&str>) -> ExitStatus {
    let Some(text) = code else {
        let list: String =
            Code::ALL.iter().map(|code| format!("{}  {}\n", code.id(), code.title())).collect();
        say(&list);
        return ExitStatus::Well;
    };
    match Code::from_id(text) {
        Some(code) => {
            say(&format!(
                "{}: {}\n\n{}\n",
                code.id(),
                code.title(),
                docs::wrap(code.explanation())
            ));
            ExitStatus::Well
        }
        None => {
            let near = crate::diag::nearest(text, Code::ALL.iter().map(|code| code.id()));
            let near = near.map(|near| format!("; did you mean {near}?")).unwrap_or_default();
            say_error(&format!(
                "virote: there is no code `{text}`{near}; `virote explain` lists all"
            ));
            ExitStatus::Usage
        }
    }
}

/// Whether standard output takes no more.
static CLOSED: AtomicBool = AtomicBool::new(false);

/// Why it takes no more, unless its reader went away.
static MISSED: OnceLock<String> = OnceLock::new();

/// Writes text for people to standard output. A reader that went away is no error.
fn say(text: &str) {
    say_exactly(&shown(text));
}

/// Writes what programs read to standard output.
fn say_exactly(text: &str) {
    if is_closed() {
        return;
    }
    let mut out = io::stdout().lock();
    if let Err(err) = out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        miss(&err);
    }
}

/// Keeps why standard output takes no more.
fn miss(err: &io::Error) {
    CLOSED.store(true, Ordering::Relaxed);
    if err.kind() != io::ErrorKind::BrokenPipe {
        MISSED.get_or_init(|| io_reason(err));
    }
}

/// The ending, once all has been said: what could not be written is told.
fn spoken(ending: ExitStatus) -> ExitStatus {
    match MISSED.get() {
        Some(reason) => {
            say_error(&format!("virote: cannot write to standard output: {reason}"));
            ending.max(ExitStatus::Usage)
        }
        None => ending,
    }
}

/// Whether nobody reads standard output any more.
fn is_closed() -> bool {
    CLOSED.load(Ordering::Relaxed)
}

/// Writes a line of text to standard error.
fn say_error(text: &str) {
    say_painted(&shown(text));
}

/// Writes a line that may be coloured to standard error.
fn say_painted(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}
