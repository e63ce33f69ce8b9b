//! Text to tree and back. Pure, and never fails: any text gives a tree and diagnostics.

pub mod ast;
