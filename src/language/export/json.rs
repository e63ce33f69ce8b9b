//! JSON: any value as exact data, which `load` reads back to the same bits.

use std::{collections::BTreeMap, io::Write};

use serde::{Serialize, Serializer, ser::SerializeMap};
use serde_json::{Map, Value as Json, json};

use super::{ExportError, Format, Item, Job, Subject, Summary};

pub(super) static FORMAT: Format = Format {
    ending: "json",
    aliases: &[],
    title: "JSON: any value as exact data",
    options: &[],
    takes: |subject| matches!(subject, Subject::Data(_)),
    takes_data: true,
    is_of_meshes: false,
    wants: "any value but functions",
    write,
};

fn write(job: &Job, out: &mut dyn Write) -> Result<Summary, ExportError> {
    let values = NamedValues::of(&job.items);
    let summary = Summary { values: values.0.len(), ..Summary::default() };
    let looks: Map<String, Json> = job.items.iter().filter_map(look).collect();
    let mut serializer = serde_json::Serializer::pretty(&mut *out);
    let written = (|| {
        let mut document = serializer.serialize_map(None)?;
        document.serialize_entry("virote", "document")?;
        document.serialize_entry("unit", &job.unit)?;
        if !looks.is_empty() {
            document.serialize_entry("presentation", &looks)?;
        }
        document.serialize_entry("values", &values)?;
        document.end()
    })();
    written.map_err(std::io::Error::from)?;
    out.write_all(b"\n")?;
    Ok(summary)
}

/// Values by their names, written where they are: a copy of large ones would be as large.
struct NamedValues<'a>(Vec<(&'a str, &'a Json)>);

impl<'a> NamedValues<'a> {
    /// Those of items. Of several with one name the last one counts, in the place of the first.
    fn of(items: &'a [Item]) -> Self {
        let (mut values, mut places) = (Vec::new(), BTreeMap::new());
        for item in items {
            let Subject::Data(data) = &item.subject else { continue };
            let name = item.name.as_str();
            let place = *places.entry(name).or_insert(values.len());
            if place == values.len() {
                values.push((name, data));
            } else {
                values[place].1 = data;
            }
        }
        Self(values)
    }
}

impl Serialize for NamedValues<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().copied())
    }
}

/// The colour and the layer of an item by its name, if it has any.
fn look(item: &Item) -> Option<(String, Json)> {
    let mut look = Map::new();
    if let Some([r, g, b]) = item.color {
        look.insert("color".to_owned(), json!(format!("#{r:02x}{g:02x}{b:02x}")));
    }
    if let Some(layer) = &item.layer {
        look.insert("layer".to_owned(), json!(layer));
    }
    (!look.is_empty()).then(|| (item.name.clone(), Json::Object(look)))
}
