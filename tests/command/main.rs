//! The built command as people use it: arguments, exit codes, files, pictures, the prompt, the watch.

mod cli;
mod commands;
#[cfg(unix)]
mod doors;
mod golden_folders;
mod looks;
mod lsp;
mod pictures;
#[cfg(unix)]
mod placements;
mod repl;
mod repl_in_part;
mod safety;
#[cfg(unix)]
mod study;
#[cfg(unix)]
mod study_endings;
#[path = "../support/mod.rs"]
mod support;
mod testing;
#[cfg(unix)]
mod view;
#[cfg(unix)]
mod watch;
