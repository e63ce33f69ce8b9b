//! Virote: an interpreter of a declarative language for exact freeform geometry.
//!
//! Reading order: the ground first, then what stands on it; `ARCHITECTURE.md` has the map.

pub mod diag;
pub mod docs;
pub mod eval;
pub mod export;
pub mod kernel;
pub mod limits;
pub mod ops;
pub mod syntax;
pub mod value;
