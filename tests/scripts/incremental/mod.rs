//! An incremental session evaluates what an edit touched, and says what a fresh one says.

mod counter;
mod edits;
mod harness;
