//! JSON: any value as exact data, which `load` reads back to the same bits.

use std::io::Write;

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
    let mut values = Map::new();
    for item in &job.items {
        if let Subject::Data(data) = &item.subject {
            values.insert(item.name.clone(), data.clone());
        }
    }
    let summary = Summary { values: values.len(), ..Summary::default() };
    let mut document = json!({ "virote": "document", "unit": job.unit });
    let looks: Map<String, Json> = job.items.iter().filter_map(look).collect();
    if !looks.is_empty() {
        document["presentation"] = Json::Object(looks);
    }
    document["values"] = Json::Object(values);
    serde_json::to_writer_pretty(&mut *out, &document).map_err(std::io::Error::from)?;
    out.write_all(b"\n")?;
    Ok(summary)
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
