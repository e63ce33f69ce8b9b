//! The command line: arguments, files, exit codes. With the renderer the only part that reads
//! files, the environment or the terminal.

mod args;
mod doubts;
mod exit_status;
mod explain;
mod fmt;
mod graph;
mod inspect;
mod interrupt;
mod limits;
mod looks;
mod lsp;
mod params;
mod process;
mod progress;
mod render;
mod repl;
mod reporter;
mod run;
mod run_args;
mod settings;
mod shell;
mod standard_streams;
mod study;
mod test;
mod view;
mod watch;

use std::{
    ffi::OsString,
    io::{self, Write},
    process::ExitCode,
};

use clap::Parser as _;

pub use self::params::schema_json;
use self::{
    args::{Cli, CliCommand},
    exit_status::ExitStatus,
    standard_streams::{miss, say, say_error, spoken},
};
use crate::{
    diag::fault,
    docs, ops,
    syntax::{KEYWORDS, ast::Unit},
};

/// Runs the command with the arguments of the process; `held` tells how many bytes of memory that
/// holds.
#[must_use]
pub fn main(held: fn() -> usize) -> ExitCode {
    ExitCode::from(main_with(std::env::args_os(), held))
}

/// The same with other arguments, the name of the command first; the exit code.
#[must_use]
pub fn main_with(args: impl IntoIterator<Item = OsString>, held: fn() -> usize) -> u8 {
    fault::listen();
    let cli = match Cli::try_parse_from(args) {
        Ok(cli) => cli,
        Err(err) if err.use_stderr() => {
            let _ = err.print();
            return ExitStatus::Usage as u8;
        }
        // Asking for help or the version is no mistake.
        Err(err) => {
            if let Err(err) = err.print().and_then(|()| io::stdout().flush()) {
                miss(&err);
            }
            return spoken(ExitStatus::Well) as u8;
        }
    };
    process::run(held, || spoken(dispatch(cli.verb))) as u8
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
        CliCommand::Study(asked) => study::run(&asked),
        CliCommand::Watch(asked) => watch::run(&asked),
        CliCommand::Lsp(asked) => lsp::run(&asked),
        CliCommand::View(asked) => view::run(&asked),
        CliCommand::Doc { words, search } => doc(&words, search),
        CliCommand::Explain { code } => explain::run(code.as_deref()),
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
            registry.names().chain(docs::chapters()).chain(docs::language::topics()),
        );
        let near = near.map(|near| format!("; did you mean `{near}`?")).unwrap_or_default();
        say_error(&format!("virote: nothing built in is called `{query}`{near}"));
    } else {
        say_error(&format!("virote: nothing built in is about `{query}`"));
    }
    ExitStatus::Usage
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use crate::{eval, ops};

    /// Advice is of words that mean nothing here, each once, and tells to call what there is.
    #[test]
    fn words_of_other_programs_lead_to_what_there_is() {
        let registry = ops::registry();
        // Written by whoever asks, or of a statement or field.
        let own = ["f", "c", "s", "name"];
        let mut known = BTreeSet::new();
        for (word, advice) in eval::all_foreign() {
            assert!(known.insert(word), "`{word}` stands twice");
            assert_eq!(word, word.to_lowercase().replace('_', ""), "as names are looked up");
            let is_own = word == "pi" || registry.get(word).is_none();
            assert!(is_own, "`{word}` is built in");
            for code in advice.split('`').skip(1).step_by(2) {
                let mut rest = code;
                while let Some((before, behind)) = rest.split_once('(') {
                    let name = before.rsplit(|c: char| c != '_' && !c.is_alphanumeric()).next();
                    let name = name.unwrap_or_default();
                    let is_known =
                        name.is_empty() || own.contains(&name) || registry.get(name).is_some();
                    assert!(is_known, "`{name}` of `{code}` for `{word}`");
                    rest = behind;
                }
            }
        }
    }
}
