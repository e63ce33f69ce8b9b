//! `load`: data from a file beside the script.

use std::sync::Arc;

use serde_json::Value as Json;

use super::{bpt, csv, dat, obj};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned, nearest},
    value::{Ctx, Value, from_json, op},
};

op! {
    /// Data from a file, whose path is relative to the script. The ending tells the format.
    ///
    /// `.obj` gives a mesh, polygons in triangles. `.bpt` gives a list of Bézier surfaces: a
    /// count, then for each patch its two degrees and its points row by row. `.csv` gives a table:
    /// the first line names its columns, with their units as in `x [mm]`, `turn [deg]` or `area [mm^2]`, from which
    /// numbers are brought into the document's unit and radians; an empty cell is none. `.dat` gives the points of an aerofoil, in the form of Selig or of
    /// Lednicer, around the profile from the trailing edge over the upper side. `.json` gives what an
    /// export wrote, to the same bits, with a warning where that had another unit, or lists and
    /// records of other JSON.
    /// The example's `points.csv` has the lines `x,y`, `0,0`, `1,2` and `4,3`.
    load in Mesh -> Value {
        /// The path.
        path: Spanned<Arc<str>>,
    }
    example "{ let t = load(\"points.csv\")  polyline([for i in 0..<len(t): (t.x[i], t.y[i])]).end }" => "(4, 3, 0)";
    refuses "load(\"points.xyz\")" => "E0703: no data format has the ending `.xyz`";
}

/// A reader of one format: the value, or a sentence on what is wrong and its line.
type Reader = fn(&[u8], &mut Ctx<'_>) -> std::result::Result<Value, String>;

/// Every format that can be read, by ending.
const READERS: &[(&str, Reader)] = &[
    ("obj", |bytes, ctx| obj::read(bytes, ctx)),
    ("bpt", |bytes, ctx| bpt::read(bytes, ctx)),
    ("csv", |bytes, ctx| csv::read(bytes, ctx)),
    ("dat", |bytes, ctx| dat::read(bytes, ctx)),
    ("json", json),
];

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let path: &str = &args.path.value;
    let span = args.path.span;
    let ending = path.rsplit_once('.').map_or("", |(_, ending)| ending);
    let Some((_, reader)) = READERS.iter().find(|(known, _)| known.eq_ignore_ascii_case(ending))
    else {
        let endings: Vec<&str> = READERS.iter().map(|&(known, _)| known).collect();
        let diagnostic = Diagnostic::error(
            Code::UnknownFormat,
            span,
            if ending.is_empty() {
                format!("`{path}` has no ending, which would choose the format")
            } else {
                format!("no data format has the ending `.{ending}`")
            },
        )
        .hint(format!("formats that can be loaded are .{}", endings.join(", .")));
        return match nearest(ending, endings.iter().copied()) {
            Some(near) => diagnostic.label(format!("did you mean `.{near}`?")).fail(),
            None => diagnostic.fail(),
        };
    };
    let bytes = ctx.files.read(path, ctx.limits.input_bytes).map_err(|message| {
        Box::new(
            Diagnostic::error(Code::FileMissing, span, message)
                .hint("paths are relative to the script"),
        )
    })?;
    reader(&bytes, ctx).map_err(|message| {
        Box::new(Diagnostic::error(Code::BadData, span, format!("`{path}`: {message}")))
    })
}

/// Numbers of a document of another unit stay as they are, which is told.
fn json(bytes: &[u8], ctx: &mut Ctx<'_>) -> std::result::Result<Value, String> {
    let text = super::text(bytes)?;
    let data: Json = serde_json::from_str(text).map_err(|err| err.to_string())?;
    let value = from_json(&data, ctx.unit)?;
    let is_document = data.get("virote").and_then(Json::as_str) == Some("document");
    let written_in = data.get("unit").and_then(Json::as_str).filter(|_| is_document);
    if let Some(unit) = written_in.filter(|unit| *unit != ctx.unit) {
        let message = format!(
            "the file was written in {unit}, and the script's unit is {}: its lengths are taken as they stand",
            ctx.unit
        );
        let hint = "state the file's `unit` in the script, or `scale` what it holds";
        ctx.warn(Diagnostic::warning(Code::Unclean, ctx.span, message).hint(hint));
    }
    Ok(value)
}
