//! How the rows of a study came out.

use std::collections::BTreeMap;

use serde_json::{Value as Json, json};

use crate::study::Row;

/// How rows came out.
#[derive(Default)]
pub(super) struct Tally {
    /// Without an error, but with a check that fails.
    pub(super) n_failed: u64,
    /// By their codes.
    pub(super) errors: BTreeMap<String, u64>,
}

impl Tally {
    /// Counts a row.
    pub(super) fn add(&mut self, row: &Row) {
        if let Some(Json::String(code)) = row.get("code") {
            *self.errors.entry(code.clone()).or_default() += 1;
        } else {
            let fails = |(title, cell): (&String, &Json)| {
                title.starts_with("check ") && *cell == json!(false)
            };
            self.n_failed += u64::from(row.iter().any(fails));
        }
    }
}
