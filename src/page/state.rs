//! The state as the page reads it: items, parameters, claims, findings.

use std::path::Path;

use serde_json::{Value as Json, json};

use super::{
    RunPlace, parameters,
    scene::{Scene, SceneItem, bounds_json},
};
use crate::{
    diag::{Diagnostic, Severity, Sources, Span},
    eval::{Checked, Schema, Work},
    render,
    session::{Event, Report},
};

/// What holds beside the run itself.
pub(super) struct Setup<'a> {
    pub(super) place: RunPlace<'a>,
    pub(super) schema: Option<&'a Schema>,
    /// The parameters of imported files.
    pub(super) imports: &'a Json,
    /// The run whose items are shown.
    pub(super) drawn: Option<(&'a Report, &'a Scene)>,
    /// Whether that one had errors.
    pub(super) is_partial: bool,
}

/// What a run came to.
pub(super) struct RunOutcome<'a> {
    /// None where there is no script.
    pub(super) report: Option<&'a Report>,
    pub(super) is_current: bool,
    /// What is wrong beside the script.
    pub(super) troubles: &'a [String],
    /// How long evaluation and meshes took.
    pub(super) milliseconds: [f64; 2],
}

/// The whole state.
pub(super) fn json(setup: &Setup<'_>, told: &RunOutcome<'_>) -> Json {
    let document = setup.drawn.map(|(report, _)| report.document);
    let (unit, tolerance) =
        document.map_or(("mm", None), |(unit, tolerance)| (unit.name(), Some(tolerance.distance)));
    let millimetres = document.and_then(|(unit, _)| unit.millimetres()).unwrap_or(1.0);
    let of_run = |of: fn(&Report) -> Json| told.report.map_or_else(|| json!([]), of);
    let n_with = |work| told.report.map_or(0, |report| report.n_with(work));
    let file = setup.place.script.file_name().unwrap_or_default().to_string_lossy();
    json!({
        "version": setup.place.version,
        "script": file,
        "exportFolder": setup.place.out.display().to_string(),
        "unit": unit,
        "millimetres": millimetres,
        "tolerance": tolerance,
        "isCurrent": told.is_current,
        "isPartial": setup.is_partial,
        "bounds": bounds_json(setup.drawn.and_then(|(_, scene)| scene.bounds)),
        "items": setup.drawn.map_or_else(|| json!([]), |(report, scene)| items(report, scene)),
        "parameters": parameters::json(setup.schema, told.report, setup.place.settings),
        "imports": setup.imports,
        "checks": of_run(checks),
        "prints": of_run(prints),
        "exports": of_run(exports),
        "diagnostics": diagnostics(setup, told),
        "milliseconds": { "evaluate": told.milliseconds[0], "mesh": told.milliseconds[1] },
        "definitions": {
            "evaluated": n_with(Work::Evaluated) + n_with(Work::Failed) + n_with(Work::Renewed),
            "reused": n_with(Work::Reused),
        },
    })
}

/// The state before the first run.
pub(super) fn empty(script: &Path, out: &Path) -> Json {
    let place = RunPlace { version: 0, script, out, settings: &[] };
    let imports = json!([]);
    let setup = Setup { place, schema: None, imports: &imports, drawn: None, is_partial: false };
    json(
        &setup,
        &RunOutcome { report: None, is_current: false, troubles: &[], milliseconds: [0.0; 2] },
    )
}

/// A place as line and column; null where it has none.
fn place(span: Span, sources: &Sources) -> Json {
    let Some(source) = sources.at(span) else { return Json::Null };
    let (line, column) = source.line_column(span.start);
    json!({ "line": line, "column": column })
}

fn line(span: Span, sources: &Sources) -> Json {
    sources.at(span).map_or(Json::Null, |source| json!(source.line_column(span.start).0))
}

fn items(report: &Report, scene: &Scene) -> Json {
    let item = |item: &SceneItem| {
        let defined = &report.definitions[item.definition];
        json!({
            "key": &*item.key,
            "definition": defined.name,
            "path": format!("{}{}", defined.name, item.piece.path),
            "kind": item.piece.shape.kind(),
            "form": item.piece.shape.form(),
            "owner": item.piece.owner.as_ref().map(|owner| {
                json!({ "path": format!("{}{}", defined.name, owner.path), "kind": owner.kind })
            }),
            "color": defined.look.color,
            "opacity": null,
            "layer": defined.look.layer.as_deref(),
            "isHidden": defined.look.is_hidden,
            "isExported": item.is_exported,
            "isShown": item.is_shown,
            "facts": item.source.facts(),
            "bounds": bounds_json(item.source.bounds()),
            "span": place(defined.span, &report.sources),
        })
    };
    scene.items.iter().map(item).collect()
}

fn checks(report: &Report) -> Json {
    let check = |checked: &Checked| {
        let verdict = &checked.verdict;
        let side = |i: usize| verdict.sides.get(i).map(|side| side.value.as_str());
        let number = |number: Option<f64>| number.map(crate::value::shortest);
        json!({
            "text": checked.source,
            "message": checked.message,
            "verdict": if verdict.holds { "pass" } else { "fail" },
            "left": side(0),
            "right": side(1),
            "distance": number(verdict.apart),
            "limit": number(verdict.limit),
            "figures": verdict.figures(),
            "places": verdict.places.iter().map(glam::DVec3::to_array).collect::<Vec<_>>(),
            "line": line(checked.span, &report.sources),
        })
    };
    let checked =
        |event: &Event| if let Event::Checked(its) = event { Some(check(its)) } else { None };
    report.events.iter().filter_map(checked).collect()
}

fn prints(report: &Report) -> Json {
    let print = |event: &Event| match event {
        // A text that is written as one stands for itself.
        Event::Printed(printed) => Some(json!({
            "text": if printed.is_text { printed.to_string() } else { printed.source.clone() },
            "value": if printed.is_text { String::new() } else { printed.value_text() },
            "line": line(printed.span, &report.sources),
        })),
        _ => None,
    };
    report.events.iter().filter_map(print).collect()
}

fn exports(report: &Report) -> Json {
    let export = |event: &Event| match event {
        Event::File(file) => {
            Some(json!({ "path": file.path, "line": line(file.span, &report.sources) }))
        }
        _ => None,
    };
    report.events.iter().filter_map(export).collect()
}

fn diagnostics(setup: &Setup<'_>, told: &RunOutcome<'_>) -> Json {
    let mut all = Vec::new();
    let trouble = |severity: &str, text: &str, at: Json| {
        json!({
            "severity": severity,
            "code": null,
            "message": text,
            "text": text,
            "line": at["line"],
            "column": at["column"],
            "file": null,
        })
    };
    let severity = if told.is_current { "warning" } else { "error" };
    all.extend(told.troubles.iter().map(|text| trouble(severity, text, Json::Null)));
    if let Some(report) = told.report {
        let found = |found: &Diagnostic| finding(found, &report.sources);
        all.extend(report.diagnostics.iter().map(found));
    }
    let is_of_run = |report: &Report| told.report.is_some_and(|its| std::ptr::eq(its, report));
    if let Some((report, scene)) = setup.drawn.filter(|(report, _)| is_of_run(report)) {
        let undrawn = scene.troubles.iter();
        all.extend(
            undrawn.map(|(span, text)| trouble("warning", text, place(*span, &report.sources))),
        );
    }
    all.into()
}

fn finding(found: &Diagnostic, sources: &Sources) -> Json {
    let at = place(found.primary.span, sources);
    json!({
        "severity": match found.severity {
            Severity::Error => "error",
            Severity::Failure => "failure",
            Severity::Warning => "warning",
        },
        "code": found.code.id(),
        "message": found.message,
        "text": render::picture(found, sources, false),
        "line": at["line"],
        "column": at["column"],
        "file": sources.at(found.primary.span).map(|source| source.name.as_str()),
    })
}
