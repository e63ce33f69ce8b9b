//! From a tree to values: names, then a graph of definitions, then evaluation, then effects.
//!
//! Knows the operations only through the [`Registry`](crate::value::Registry). The session hands
//! in the tree; files come in through [`Files`](crate::value::Files).

mod advice;
mod beside;
mod call;
mod ceiling;
mod claim;
mod collection;
mod dependencies;
mod function;
mod home;
mod index;
mod ir;
mod lanes;
mod library;
mod load;
mod look;
mod lower;
mod machine;
mod memory;
mod operator;
mod outcome;
mod param;
mod parametric;
mod partial;
mod promise;
mod run;
mod schedule;
mod schema;
mod smooth;
mod spelling;
mod test;
mod worker;

pub(crate) use ceiling::out_of_memory;
pub use claim::{Side, Verdict};
pub use dependencies::{Graph, Node, graph};
pub use home::Kept;
pub(crate) use lower::words::advice as foreign_advice;
pub use memory::{Memory, Recall, Work};
pub(crate) use outcome::in_order;
pub use outcome::{
    Checked, Defined, Expected, Exported, Outcome, Output, Printed, Subject, Tested,
};
pub use param::Setting;
pub use run::{Purpose, Settings, evaluate};
pub use schema::{Parameter, Schema, parameters};
