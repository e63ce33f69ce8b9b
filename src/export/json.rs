//! JSON: any value as exact data, which `load` reads back to the same bits.

use std::io::Write;

use serde_json::{Map, Value as Json, json};

use super::{ExportError, Format, Job, Subject, Summary};

pub(super) static FORMAT: Format = Format {
    ending: "json",
    title: "JSON: any value as exact data",
    options: &[],
    takes: |subject| matches!(subject, Subject::Data(_)),
    takes_data: true,
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
    let document =
        json!({ "virote": "document", "unit": job.unit, "values": Json::Object(values) });
    serde_json::to_writer_pretty(&mut *out, &document).map_err(std::io::Error::from)?;
    out.write_all(b"\n")?;
    Ok(summary)
}
