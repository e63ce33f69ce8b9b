//! Virote: an interpreter of a declarative language for exact freeform geometry.
//!
//! Reading order: [`diag`] and [`limits`] are the ground; [`kernel`] is the geometry, [`syntax`]
//! turns text into a tree; [`value`] is what scripts compute with and how an operation is
//! declared, [`export`] how geometry becomes files; [`ops`] holds the operations, [`eval`] runs
//! the tree; [`session`] puts it all together, [`docs`] tells of it, [`ide`] answers editors `page` a page that shows a
//! script, [`render`] draws diagnostics; and the doors (`cli`, [`disk`], [`lsp`], [`playground`], [`study`], [`view`])
//! talk to the world.
//! `ARCHITECTURE.md` has the map.

#[cfg(feature = "cli")]
mod cli;
pub mod diag;
#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod disk;
pub mod docs;
pub mod eval;
pub mod export;
pub mod ide;
pub mod limits;
#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod lsp;
pub mod ops;
mod page;
#[doc(hidden)]
pub mod playground;
pub mod render;
pub mod session;
#[cfg(feature = "cli")]
pub mod study;
pub mod syntax;
pub mod value;
#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod view;

#[cfg(feature = "cli")]
#[doc(hidden)]
pub use cli::{main as command, main_with as command_with, schema_json};
pub use virote_kernel as kernel;
