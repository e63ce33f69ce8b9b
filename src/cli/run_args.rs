//! The arguments that several verbs take.

use std::{
    io::{self, IsTerminal},
    num::NonZeroUsize,
    path::PathBuf,
};

use clap::{Args, ValueEnum};

use super::{
    limits::{self, MovedCeiling},
    process,
};
use crate::{eval::Setting, limits::Limits, session::Session};

/// What every verb that evaluates takes.
#[derive(Debug, Args)]
pub(super) struct RunArgs {
    /// Replaces a parameter of the script; may be given several times
    #[arg(long = "set", short = 'D', value_name = "NAME=VALUE", value_parser = setting)]
    pub(super) settings: Vec<Setting>,
    /// Replaces parameters by those of a JSON object, `{"neck": "15mm", "n": 7}`; `--set` wins
    #[arg(long, value_name = "FILE.json")]
    pub(super) params: Option<PathBuf>,
    /// Moves a ceiling, such as `steps=1_000_000`; may be given several times; `--help` lists them
    #[arg(long = "limit", value_name = "NAME=VALUE", value_parser = limits::limit,
        long_help = limits::help())]
    limits: Vec<MovedCeiling>,
    /// How many threads evaluate [default: one for each processor]
    #[arg(long, value_name = "N", value_parser = threads)]
    threads: Option<NonZeroUsize>,
    /// Writes and draws nothing of a script with errors; else what no error touches is
    #[arg(long)]
    pub(super) strict: bool,
    #[command(flatten)]
    pub(super) talk: OutputArgs,
}

/// How the command speaks.
#[derive(Debug, Args)]
pub(super) struct OutputArgs {
    /// Says nothing but what the script prints, and errors
    #[arg(long, short)]
    pub(super) quiet: bool,
    /// How messages are written
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    pub(super) message_format: MessageFormat,
    /// When messages are coloured
    #[arg(long, value_name = "WHEN", default_value = "auto")]
    color: ColorWhen,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum MessageFormat {
    /// Pictures of the source, on standard error
    Human,
    /// One JSON object a line, on standard output
    Json,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum ColorWhen {
    /// On a terminal, unless NO_COLOR is set
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

impl RunArgs {
    /// A session as these options want it.
    pub(super) fn session(&self) -> Session {
        self.session_for(1)
    }

    /// The same for `n_jobs` runs side by side, which share the threads unless their number is given.
    pub(super) fn session_for(&self, n_jobs: usize) -> Session {
        let n_threads = match self.threads {
            Some(n_threads) => n_threads.get(),
            None => self.n_threads() / n_jobs,
        };
        process::session(self.ceilings()).on_threads(n_threads)
    }

    /// The ceilings.
    pub(super) fn ceilings(&self) -> Limits {
        limits::moved(&self.limits)
    }

    /// How many threads may evaluate.
    pub(super) fn n_threads(&self) -> usize {
        let n_threads = self.threads.or_else(|| std::thread::available_parallelism().ok());
        n_threads.map_or(1, NonZeroUsize::get)
    }
}

impl OutputArgs {
    /// Whether findings are coloured.
    pub(super) fn with_color(&self) -> bool {
        match self.color {
            ColorWhen::Always => true,
            ColorWhen::Never => false,
            ColorWhen::Auto => io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none(),
        }
    }
}

/// Reads `NAME=VALUE`.
fn setting(text: &str) -> Result<Setting, String> {
    match text.split_once('=') {
        Some((name, value)) if !name.trim().is_empty() => {
            // A text is what stands there, blanks and all.
            let (name, text) = (name.trim().to_owned(), value.to_owned());
            Ok(Setting { called: format!("`--set {name}={text}`"), name, text })
        }
        _ => Err("write NAME=VALUE, for example neck=15mm".to_owned()),
    }
}

/// Reads a number of threads.
fn threads(text: &str) -> Result<NonZeroUsize, String> {
    text.parse().map_err(|_| "write a whole number of threads, 1 or more".to_owned())
}
