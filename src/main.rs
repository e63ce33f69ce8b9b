//! The `virote` command.

fn main() {}
