//! Studies: one script, many variants of its parameters, a row of results for each.
//!
//! A `plan` names the values (`vary` makes a grid of them, `plan_file` reads them), `workers` evaluate
//! variants side by side and give their rows (`row`) in the order of the plan, and a `journal` keeps
//! each as it comes, so that a study that was killed goes on where it ended. When all rows are there
//! their `columns` are known, and `results` (`typed_columns`) writes them.

mod checksum;
mod closed_quotes;
mod columns;
mod contact_sheet;
mod files;
mod journal;
mod plan;
mod plan_column;
mod plan_file;
mod results;
mod row;
mod typed_columns;
mod vary;
mod workers;

pub use checksum::checksum;
pub use columns::ResultColumns;
pub use contact_sheet::contact_sheets;
pub use files::KeptFiles;
pub use journal::Journal;
pub use plan::{Plan, STOPPED, Variant};
pub use results::{ResultFormat, write_results};
pub use row::{Row, RowMaker, check_wants};
pub use typed_columns::read_results;
pub use vary::{VariedParameter, VariedValues};
pub use workers::{Evaluation, StudyPictures, in_order};
