//! `load`: data from a file beside the script.

use std::sync::Arc;

use serde_json::Value as Json;

use super::{bpt, csv, dat, obj, written_unit::compare_units};
use crate::{
    diag::{Code, Diagnostic, Fix, Result, Span, Spanned, nearest},
    limits::{
        Ceiling, Limits,
        work::{self, End},
    },
    value::{Ctx, Value, decode, from_json, missing_file, op, read_json},
};

op! {
    /// Data from a file, whose path is relative to the script. The ending tells the format.
    ///
    /// `.obj` gives a mesh, whose polygons are its `faces`. `.bpt` gives a list of Bézier surfaces: a
    /// count, then for each patch its two degrees and its points row by row. `.csv` gives a table:
    /// the first line names its columns, with their units as in `x [mm]`, `turn [deg]` or `area [mm^2]`, from which
    /// numbers are brought into the document's unit and radians; an empty cell is none. `.dat` gives the points of an aerofoil, in the form of Selig or of
    /// Lednicer, around the profile from the trailing edge over the upper side. `.json` gives what an
    /// export wrote, to the same bits, or lists and records of other JSON. Of an export in another unit the
    /// columns of tables are brought into the document's, all other numbers are taken as they stand, with a
    /// warning; so are those of a mesh whose `.obj` says `# unit: m`. Files are text in UTF-8, or in UTF-16 with its byte-order mark.
    /// The example's `points.csv` has the lines `x,y`, `0,0`, `1,2` and `4,3`.
    load in Mesh -> Value {
        /// The path.
        path: Spanned<Arc<str>>,
    }
    example "{ let t = load(\"points.csv\")  polyline([for i in 0..<len(t): (t.x[i], t.y[i])]).end }" => "(4, 3, 0)";
    refuses "load(\"points.xyz\")" => "E0703: no data format has the ending `.xyz`";
}

/// A reader of one format, from text: the value, or a sentence on what is wrong and its line. It counts
/// what it makes while it makes it, and leaves when the work is ended.
type Reader = fn(&str, &mut Ctx<'_>) -> std::result::Result<Value, String>;

/// Every format that can be read, by ending.
const READERS: &[(&str, Reader)] = &[
    ("obj", |text, ctx| obj::read(text, ctx)),
    ("bpt", |text, ctx| bpt::read(text, ctx)),
    ("csv", |text, ctx| csv::read(text, ctx)),
    ("dat", |text, ctx| dat::read(text, ctx)),
    ("json", json),
];

/// The endings of the files that can be loaded.
pub fn loaded_endings() -> impl Iterator<Item = &'static str> {
    READERS.iter().map(|&(ending, _)| ending)
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let path: &str = &args.path.value;
    let span = args.path.span;
    let ending = path.rsplit_once('.').map_or("", |(_, ending)| ending);
    let Some((_, reader)) = READERS.iter().find(|(known, _)| known.eq_ignore_ascii_case(ending))
    else {
        let endings: Vec<&str> = loaded_endings().collect();
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
            Some(near) => {
                let diagnostic = diagnostic.label(format!("did you mean `.{near}`?"));
                match Fix::ending(span, path, ending, near) {
                    Some(fix) => diagnostic.fix(fix).fail(),
                    None => diagnostic.fail(),
                }
            }
            None => diagnostic.fail(),
        };
    };
    let bytes = bytes(path, span, ctx)?;
    let value = decode(&bytes).and_then(|text| reader(&text, ctx));
    value.map_err(|message| match work::ended() {
        Some(End::Memory) => no_room(path, span, ctx.limits),
        _ => Box::new(Diagnostic::error(Code::BadData, span, format!("`{path}`: {message}"))),
    })
}

/// The bytes of a file, if there may be so many of them.
fn bytes(path: &str, span: Span, ctx: &Ctx<'_>) -> Result<Vec<u8>> {
    let most = ctx.limits.input_bytes.min(work::room());
    let bytes = ctx.files.read(path, most).map_err(|message| {
        missing_file(ctx.files, path, (span, message), "paths are relative to the script")
    })?;
    if bytes.len() <= most {
        return Ok(bytes);
    }
    if most < ctx.limits.input_bytes {
        // Whoever counts is told too.
        let _ = work::has_room(bytes.len());
        return Err(no_room(path, span, ctx.limits));
    }
    Diagnostic::error(
        Code::FileMissing,
        span,
        format!("`{path}` is larger than the ceiling of {most} bytes"),
    )
    .hint("load a part of it, or thin it out")
    .crossing(Ceiling::INPUT_BYTES)
    .fail()
}

/// The finding that what a file holds does not fit into the memory that the run may hold.
fn no_room(path: &str, span: Span, limits: &Limits) -> Box<Diagnostic> {
    let most = limits.memory_bytes;
    let message = format!(
        "to read `{path}` takes more than {most} bytes of memory, with what the script holds"
    );
    let diagnostic = Diagnostic::error(Code::TooLarge, span, message).label("under way here");
    let diagnostic = diagnostic.crossing(Ceiling::MEMORY);
    Box::new(diagnostic.hint("load a part of it, or thin it out"))
}

/// Tables of a document of another unit come in that of the script, as their columns tell what they
/// measure; all other numbers stay as they are, which is told.
fn json(text: &str, ctx: &mut Ctx<'_>) -> std::result::Result<Value, String> {
    let data = read_json(text)?;
    let value = from_json(&data, ctx.unit)?;
    let is_document = data.get("virote").and_then(Json::as_str) == Some("document");
    let written_in = data.get("unit").and_then(Json::as_str).filter(|_| is_document);
    let stays = || data.get("values").is_none_or(holds_lengths);
    if let Some(unit) = written_in.filter(|_| stays()) {
        compare_units(unit, ctx);
    }
    Ok(value)
}

/// Whether some number may be a length that is not known to be one.
fn holds_lengths(json: &Json) -> bool {
    match json {
        Json::Null | Json::Bool(_) | Json::String(_) => false,
        Json::Number(_) => true,
        Json::Array(items) => items.iter().any(holds_lengths),
        Json::Object(members) => match members.get("virote").and_then(Json::as_str) {
            Some("table" | "angle") => false,
            Some(_) => true,
            None => members.values().any(holds_lengths),
        },
    }
}
