//! From a tree to values: names, then a graph of definitions, then evaluation, then effects.
//!
//! Knows the operations only through the [`Registry`](crate::value::Registry). The session hands
//! in the tree; files come in through [`Files`](crate::value::Files).

mod advice;
mod appearance;
mod autodiff;
mod cache_key;
mod call;
mod caller;
mod ceiling;
mod claim;
mod collection;
mod comparisons;
mod dependencies;
mod env;
mod field;
mod field_memory;
mod file_run;
mod function;
mod geometry_call;
mod globals;
mod import;
mod import_fault;
mod import_instance;
mod imported;
mod index;
mod invoke;
mod ir;
mod items;
mod kind_check;
mod lanes;
mod library;
mod load;
mod lower;
mod machine;
mod memory;
mod meter;
mod name_search;
mod name_uses;
mod number_call;
mod operator;
mod outcome;
mod ownership;
mod param;
mod param_dimension;
mod param_text;
mod parametric;
mod partial;
mod relative_files;
mod run;
mod schedule;
mod schema;
mod settings;
mod test;
mod worker;

pub use appearance::OPTIONS as LOOK_OPTIONS;
pub(crate) use ceiling::out_of_memory;
pub use claim::{ClaimSide, Verdict};
pub use dependencies::{DependencyNode, Graph, graph};
pub(crate) use invoke::invoke;
pub use ir::param_kinds;
pub use lower::foreign_names::advice as foreign_advice;
pub use lower::foreign_names::all as all_foreign;
pub use memory::{CacheRun, Memory, Work};
pub use name_search::name_uses;
pub use name_uses::NameUses;
pub(crate) use outcome::in_order;
pub use outcome::{
    Checked, Defined, EffectOutput, ExpectedMistake, ExportSubject, Exported, Outcome, Printed,
    TestOutcome,
};
pub use param::param_kind;
pub use relative_files::RelativeFiles;
pub use run::evaluate;
pub use schema::{Schema, SchemaParameter, parameters};
pub use settings::{Purpose, Setting, Settings, TestFilter, unknown_parameter};
