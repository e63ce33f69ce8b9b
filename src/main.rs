//! The `virote` command.

use std::{alloc::System, process::ExitCode};

use cap::Cap;

/// Counts the memory that is held, for the ceiling on it; it refuses none itself.
#[global_allocator]
static MEMORY: Cap<System> = Cap::new(System, usize::MAX);

fn main() -> ExitCode {
    virote::command(|| MEMORY.allocated())
}
