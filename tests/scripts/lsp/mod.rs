//! The language server, driven in the same process: every kind of request over a script with a planted
//! mark, random edits, and what clients do wrong.

mod client;
mod renames;
mod requests;
mod trouble;
