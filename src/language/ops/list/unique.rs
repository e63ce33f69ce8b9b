//! `unique`: each element once.

use std::collections::HashMap;

use crate::{
    diag::Result,
    kernel::{Surface, sorting::sort_by_key},
    limits::work,
    value::{Ctx, List, Value, equal, op},
};

/// Vertices of a mesh that tell it from most others.
const MOST_VERTICES: usize = 16;

op! {
    /// The elements without those that are equal to an earlier one.
    unique in List -> Vec<Value> {
        /// The list; a range of whole numbers counts as one.
        list: List,
    }
    example "unique([1, 2, 1, 3, 2])" => "[1, 2, 3]";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vec<Value>> {
    let mut seen: HashMap<Vec<u64>, Vec<Value>> = HashMap::new();
    let mut is_new = |item: &Value| {
        let mut key = Vec::new();
        spell(item, &mut key);
        let alike = seen.entry(key).or_default();
        work::count(1 + alike.len() as u64);
        let is_new = !alike.iter().any(|known| equal(known, item) == Some(true));
        if is_new {
            alike.push(item.clone());
        }
        is_new
    };
    Ok(args.list.iter().filter(|item| is_new(item)).cloned().collect())
}

/// Appends what equal values have in common and most others do not.
fn spell(value: &Value, key: &mut Vec<u64>) {
    // Zero of either sign is one number.
    let mut numbers =
        |values: &[f64]| key.extend(values.iter().map(|value| (value + 0.0).to_bits()));
    match value {
        Value::Number(number) => numbers(&[number.value]),
        Value::Point(point) => numbers(&point.to_array()),
        Value::Range(range) => numbers(&[range.start.value, range.end.value]),
        Value::Frame(frame) => numbers(&frame.origin().to_array()),
        Value::Curve(curve) => {
            numbers(&curve.start().to_array());
            numbers(&curve.end().to_array());
        }
        Value::Surface(Surface::Nurbs(surface)) => {
            surface.points().iter().for_each(|point| numbers(&point.to_array()));
        }
        Value::Mesh(mesh) => {
            key.push(mesh.n_triangles() as u64);
            let start = mesh.vertices().iter().take(MOST_VERTICES);
            start.for_each(|point| key.extend(point.to_array().map(|x| (x + 0.0).to_bits())));
        }
        Value::Text(text) => {
            key.push(text.len() as u64);
            key.extend(
                text.as_bytes()
                    .chunks(8)
                    .map(|chunk| chunk.iter().fold(0, |word, &byte| word << 8 | u64::from(byte))),
            );
        }
        Value::Bool(is_true) => key.push(u64::from(*is_true)),
        Value::List(items) => {
            key.push(items.len() as u64);
            items.iter().for_each(|item| spell(item, key));
        }
        Value::Record(record) => {
            let mut fields: Vec<(&str, &Value)> = record.iter().collect();
            sort_by_key(&mut fields, |&(label, _)| label);
            key.push(fields.len() as u64);
            for (label, value) in fields {
                key.extend(label.bytes().map(u64::from));
                spell(value, key);
            }
        }
        _ => {}
    }
}
