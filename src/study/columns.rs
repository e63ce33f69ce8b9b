//! The columns of a study, known when all rows are: a variant that fails lacks some.

use std::collections::HashMap;

use serde_json::Value as Json;

use super::row::Row;

/// What the cells of a column are, as far as they are there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellKind {
    /// Nothing is in it.
    Empty,
    /// Whole numbers.
    Integer,
    /// Numbers.
    Number,
    /// Truth values.
    Bool,
    /// Texts, or several kinds.
    Text,
}

/// Titles in their order, each with what its cells are.
#[derive(Debug, Default)]
pub struct ResultColumns {
    titles: Vec<String>,
    kinds: HashMap<String, CellKind>,
}

impl ResultColumns {
    /// Adds the columns of a row: one that is new comes behind the one before it in the row.
    pub fn add(&mut self, row: &Row) {
        let mut behind = 0;
        for (title, cell) in row {
            let kind = kind_of(cell);
            if let Some(known) = self.kinds.get_mut(title) {
                *known = known.with(kind);
                // The titles of most rows are those of the one before.
                if self.titles.get(behind).is_some_and(|next| next == title) {
                    behind += 1;
                } else if let Some(place) = self.titles.iter().position(|known| known == title) {
                    behind = place + 1;
                }
                continue;
            }
            self.titles.insert(behind, title.clone());
            self.kinds.insert(title.clone(), kind);
            behind += 1;
        }
    }

    /// The columns in their order.
    pub fn iter(&self) -> impl Iterator<Item = (&str, CellKind)> {
        let kind = |title: &String| self.kinds.get(title).copied().unwrap_or(CellKind::Empty);
        self.titles.iter().map(move |title| (title.as_str(), kind(title)))
    }
}

impl CellKind {
    fn with(self, other: Self) -> Self {
        match (self, other) {
            (Self::Empty, kind) | (kind, Self::Empty) => kind,
            (a, b) if a == b => a,
            (Self::Integer | Self::Number, Self::Integer | Self::Number) => Self::Number,
            _ => Self::Text,
        }
    }
}

fn kind_of(cell: &Json) -> CellKind {
    match cell {
        Json::Null => CellKind::Empty,
        Json::Bool(_) => CellKind::Bool,
        Json::Number(number) if number.is_i64() => CellKind::Integer,
        Json::Number(_) => CellKind::Number,
        _ => CellKind::Text,
    }
}

/// A cell of a column of texts.
pub(super) fn text_of(cell: &Json) -> Option<String> {
    match cell {
        Json::Null => None,
        Json::String(text) => Some(text.clone()),
        other => Some(other.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value as Json, json};

    use super::{CellKind, ResultColumns};

    #[test]
    fn columns_of_rows_that_lack_some_come_in_order() {
        let mut columns = ResultColumns::default();
        let rows = [
            json!({"id": 1, "code": "E0802"}),
            json!({"id": 2, "area": 1, "check": true, "code": null}),
            json!({"id": "b", "area": 2.5, "volume": 3, "check": false, "code": null}),
        ];
        for row in &rows {
            if let Json::Object(row) = row {
                columns.add(row);
            }
        }
        let found: Vec<(&str, CellKind)> = columns.iter().collect();
        assert_eq!(
            found,
            [
                ("id", CellKind::Text),
                ("area", CellKind::Number),
                ("volume", CellKind::Integer),
                ("check", CellKind::Bool),
                ("code", CellKind::Text),
            ]
        );
    }
}
