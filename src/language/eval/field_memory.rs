//! Fields of geometry and tables that a loop asks for again and again.

use std::sync::Arc;

use crate::{
    kernel::{Curve, Surface},
    value::Value,
};

/// Lists that were asked for last as fields of geometry and tables, which are made anew for each question: an element
/// of one in a loop would take as long as all of them.
#[derive(Debug, Default)]
pub(super) struct FieldMemory(Vec<KnownField>);

#[derive(Debug)]
struct KnownField {
    of: Value,
    name: Box<str>,
    value: Value,
}

/// How many are known at a time: a loop rarely asks for more.
const N_FIELDS: usize = 4;

/// Elements below which a list is as soon made as found.
const MANY_ELEMENTS: usize = 16;

impl FieldMemory {
    pub(super) fn find(&self, of: &Value, name: &str) -> Option<Value> {
        let is_it = |known: &&KnownField| &*known.name == name && is_same(&known.of, of);
        self.0.iter().find(is_it).map(|known| known.value.clone())
    }

    pub(super) fn keep(&mut self, of: Value, name: &str, value: &Value) {
        let is_worth = matches!(value, Value::List(list) if MANY_ELEMENTS <= list.len());
        if !is_worth || !is_same(&of, &of) {
            return;
        }
        if self.0.len() == N_FIELDS {
            self.0.remove(0);
        }
        self.0.push(KnownField { of, name: name.into(), value: value.clone() });
    }
}

/// Whether two values are one curve, surface, mesh or table in memory.
fn is_same(one: &Value, other: &Value) -> bool {
    match (one, other) {
        (Value::Table(one), Value::Table(other)) => Arc::ptr_eq(one, other),
        (Value::Mesh(one), Value::Mesh(other)) => Arc::ptr_eq(one, other),
        (Value::Curve(Curve::Nurbs(one)), Value::Curve(Curve::Nurbs(other))) => {
            Arc::ptr_eq(one, other)
        }
        (Value::Surface(Surface::Nurbs(one)), Value::Surface(Surface::Nurbs(other))) => {
            Arc::ptr_eq(one, other)
        }
        _ => false,
    }
}
