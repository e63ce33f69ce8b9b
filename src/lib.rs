//! Virote: an interpreter of a declarative language for exact freeform geometry.
//!
//! Reading order: [`diag`] and [`limits`] are the ground; [`kernel`] is the geometry, [`syntax`]
//! turns text into a tree; `ARCHITECTURE.md` has the map.

pub mod diag;
pub mod kernel;
pub mod limits;
pub mod syntax;
