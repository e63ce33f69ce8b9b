//! `virote lsp`: the language server, which an editor starts.

use std::num::NonZeroUsize;

use clap::Args;

use super::{
    exit_status::ExitStatus,
    limits::{self, MovedCeiling},
    process,
    standard_streams::say_error,
};
use crate::{
    limits::{Limits, work::StopToken},
    lsp,
};

/// Findings of a document that are told: an editor has room for more than a terminal.
const MOST_FINDINGS: usize = 500;

/// What `virote lsp` is asked for.
#[derive(Debug, Args)]
pub(super) struct LspOptions {
    /// Serves over standard input and output, as it does anyway; some clients insist on saying so
    #[arg(long)]
    stdio: bool,
    /// Moves a ceiling, such as `steps=1_000_000`; may be given several times; `--help` lists them
    #[arg(long = "limit", value_name = "NAME=VALUE", value_parser = limits::limit,
        long_help = limits::help())]
    limits: Vec<MovedCeiling>,
    /// How many threads evaluate [default: one for each processor]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
}

/// `virote lsp`: until the client says goodbye.
pub(super) fn run(asked: &LspOptions) -> ExitStatus {
    let defaults = Limits { diagnostics: MOST_FINDINGS, ..Limits::DEFAULT };
    let limits = limits::moved_from(defaults, &asked.limits);
    let n_threads = asked.threads.or_else(|| std::thread::available_parallelism().ok());
    let n_threads = n_threads.map_or(1, NonZeroUsize::get);
    let session = |stop: StopToken| process::session(limits).on_threads(n_threads).stopped_by(stop);
    match lsp::serve_streams(&session) {
        Ok(()) => ExitStatus::Well,
        Err(err) => {
            say_error(&format!("virote: the language server ended: {err}"));
            ExitStatus::Usage
        }
    }
}
