//! What shells and manuals are told about the command: completions, and pages for `man`.

use clap::CommandFactory as _;
use clap_complete::Shell;

use super::{
    args::Cli,
    exit_status::ExitStatus,
    standard_streams::{say, say_error},
};
use crate::diag::nearest;

/// The name of the command.
const NAME: &str = "virote";

/// `virote completions SHELL`
pub(super) fn completions(shell: Shell) -> ExitStatus {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), NAME, &mut script);
    say(&String::from_utf8_lossy(&script));
    ExitStatus::Well
}

/// `virote man [VERB]`: the page of the command, or of one of its verbs.
pub(super) fn man(verb: Option<&str>) -> ExitStatus {
    let mut cli = Cli::command();
    // Global names and versions reach the verbs.
    cli.build();
    let page = match verb {
        None => Some(cli.clone()),
        Some(verb) => cli.find_subcommand(verb).cloned(),
    };
    let Some(page) = page else {
        let verb = verb.unwrap_or_default();
        let verbs: Vec<&str> = cli.get_subcommands().map(clap::Command::get_name).collect();
        let remedy = match nearest(verb, verbs.iter().copied()) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("there are {}", verbs.join(", ")),
        };
        say_error(&format!("virote: there is no verb `{verb}`; {remedy}"));
        return ExitStatus::Usage;
    };
    let mut text = Vec::new();
    let source = format!("{NAME} {}", env!("CARGO_PKG_VERSION"));
    match clap_mangen::Man::new(page).source(source).render(&mut text) {
        Ok(()) => {
            say(&String::from_utf8_lossy(&text));
            ExitStatus::Well
        }
        Err(err) => {
            say_error(&format!("virote: the page cannot be written: {err}"));
            ExitStatus::Usage
        }
    }
}
