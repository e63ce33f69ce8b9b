//! The language and its built-ins: what scripts say, refuse, draw and write, and the rules of the house.

mod circles;
mod derivatives;
mod docs;
mod documents;
mod errors;
mod faults;
mod fixes;
mod formats;
mod formatting;
mod fresh_names;
mod golden;
mod ide;
mod incremental;
mod kernel_docs;
mod lanes;
mod lanes_points;
mod library;
#[cfg(unix)]
mod lsp;
mod maps;
mod mutations;
mod name_uses;
mod named_paths;
mod quantities;
mod readback;
mod registry;
#[path = "../support/mod.rs"]
mod support;
mod syntax;
mod tidy;
mod unmeasurable;
mod writing;
