//! Virote: an interpreter of a declarative language for exact freeform geometry.
//!
//! The language is a package of its own, whose modules are handed on here, as is the [`kernel`] below it: [`session`]
//! runs a script, [`value`] is what scripts compute with, [`export`] makes files. What this package adds are the
//! doors and what they share: [`docs`] tells of the language, [`ide`] answers editors, `page` a page that shows a
//! script, [`render`] draws diagnostics; `cli`, [`disk`], [`lsp`], [`playground`], [`study`] and [`view`] talk to the
//! world. `ARCHITECTURE.md` has the map.

#[cfg(feature = "cli")]
mod cli;
#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod disk;
pub mod docs;
pub mod ide;
#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod lsp;
mod page;
#[doc(hidden)]
pub mod playground;
pub mod render;
#[cfg(feature = "cli")]
pub mod study;
#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod view;

#[cfg(feature = "cli")]
#[doc(hidden)]
pub use cli::{main as command, main_with as command_with, schema_json};
#[doc(inline)]
pub use virote_language::{diag, eval, export, kernel, limits, ops, session, syntax, value};
