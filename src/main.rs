//! The `virote` command.

use std::process::ExitCode;

fn main() -> ExitCode {
    virote::cli::main()
}
