//! The language of virote: from a script's text to its values, its claims and its files.
//!
//! Reading order: [`diag`] and [`limits`] are the ground; [`kernel`] is the geometry, [`syntax`]
//! turns text into a tree; [`value`] is what scripts compute with and how an operation is
//! declared, [`export`] how geometry becomes files; [`ops`] holds the operations, [`eval`] runs
//! the tree; [`session`] puts it all together. Programs take the package `virote`, which hands all of this on and
//! adds the doors: what editors, pages and terminals ask.

pub mod diag;
pub mod eval;
pub mod export;
pub mod limits;
pub mod ops;
pub mod session;
pub mod syntax;
pub mod value;

pub use virote_kernel as kernel;
