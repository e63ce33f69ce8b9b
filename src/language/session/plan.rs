//! From an `export` to a file: its path, its format, what goes into it.

use std::{collections::HashMap, sync::Arc};

use super::{
    File, Session,
    exact_data::{NoData, data},
    options::options,
    path::{printable, reserved, safe_path},
};
use crate::{
    diag::{Code, Diagnostic, Fix, Span, nearest},
    eval::{self, Exported},
    export::{FORMATS, Format, Item, Job, MeshMemory, Subject},
    kernel::{Face, NurbsCurve, Region, Tolerance},
    limits::{
        Limits,
        work::{self, Watch},
    },
    syntax::ast::Unit,
    value::Value,
};

/// What the files of a script have in common: unit and tolerance, and meshes that are there already.
pub(super) type PlanContext<'a> = ((Unit, Tolerance), &'a MeshMemory);

impl Session {
    /// The file that an export makes; what is wrong with it goes to `diagnostics`.
    pub(super) fn plan(
        &self,
        exported: Exported,
        ((unit, tolerance), meshes): PlanContext<'_>,
        diagnostics: &mut Vec<Diagnostic>,
    ) -> Option<File> {
        let span = exported.path.span;
        if self.limits.memory_bytes < self.gauge.held() {
            diagnostics.push(eval::out_of_memory(&self.limits, span));
            return None;
        }
        let path = safe_path(&exported.path.value);
        if let Ok(path) = &path
            && let Some((part, why)) = reserved(path)
        {
            let message = format!("on Windows this file cannot exist: `{part}` {why}");
            let hint = "choose another name, so that the script runs on every system";
            diagnostics.push(Diagnostic::warning(Code::Unclean, span, message).hint(hint));
        }
        let before = diagnostics.len();
        let path = path.map_err(|message| {
            diagnostics.push(
                Diagnostic::error(Code::PathEscapes, span, message)
                    .hint("paths are relative to the output folder"),
            );
        });
        let Some(format) = Format::of_path(&exported.path.value) else {
            diagnostics.push(unknown_format(&exported.path.value, span));
            return None;
        };
        let items = items_of(&exported, format, diagnostics);
        if items.is_empty() && !exported.is_report && diagnostics.len() == before {
            let hint = match exported.subjects.is_empty() {
                true => {
                    "`export all` takes the definitions that begin with `point`, `curve`, `surface`, `region`, `face`, `solid` or `mesh`"
                }
                false => "what is named is an empty list",
            };
            diagnostics.push(
                Diagnostic::error(Code::CannotExport, span, "there is nothing to export")
                    .label("this file would be empty")
                    .hint(hint),
            );
        }
        let options = options(&exported.options, format, diagnostics);
        if diagnostics.len() > before {
            return None;
        }
        let millimetres = unit.millimetres().unwrap_or(1.0);
        let job = Job {
            unit: unit.name(),
            millimetres,
            precision: tolerance.distance,
            options,
            limits: self.limits,
            n_threads: self.n_threads,
            meshes: meshes.clone(),
            ..Job::new(items)
        };
        let (path, names) = (path.ok()?, exported.names);
        let watch = self.watch();
        Some(File { path, span, names, format, job, watch })
    }

    /// The file that definitions of a report would be exported to.
    ///
    /// # Errors
    /// What is wrong with that, as a run tells it; a name of no definition.
    pub fn file_of(
        &self,
        report: &super::Report,
        names: &[String],
        path: &str,
    ) -> Result<Box<File>, Vec<Diagnostic>> {
        let subject = |name: &String| {
            let defined = report.definitions.iter().find(|defined| defined.name == *name);
            let found = defined.and_then(|defined| Some((defined, defined.value.clone()?)));
            let (defined, value) = found.ok_or_else(|| {
                let message = format!("the script defines no `{name}`");
                vec![Diagnostic::error(Code::CannotExport, Span::default(), message)]
            })?;
            let value = crate::diag::Spanned::new(value, defined.span);
            let (look, identity) = (defined.look.clone(), defined.identity);
            Ok(eval::ExportSubject { name: name.clone(), value, look, identity })
        };
        let subjects = names.iter().map(subject).collect::<Result<_, Vec<Diagnostic>>>()?;
        let path = crate::diag::Spanned::unplaced(path.to_owned());
        let exported = Exported {
            path,
            subjects,
            names: names.to_vec(),
            is_report: false,
            options: Vec::new(),
        };
        let mut found = Vec::new();
        let file = self.plan(exported, (report.document, &report.meshes), &mut found);
        file.map(Box::new).ok_or(found)
    }

    /// What the writing of a file may take.
    pub fn watch(&self) -> Watch {
        let Limits { memory_bytes, steps, .. } = self.limits;
        Watch { gauge: self.gauge.clone(), memory_bytes, stop: self.stop.clone(), steps }
    }
}

/// What goes into a file; what the format does not take goes to `diagnostics`.
fn items_of(
    exported: &Exported,
    format: &'static Format,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<Item> {
    let mismatch = |span: Span, found: &str, hint: String| {
        let message = format!("`.{}` takes {}, found {found}", format.ending, format.wants);
        Diagnostic::error(Code::CannotExport, span, message).hint(hint)
    };
    let mut gathering = GatheredItems::new(format);
    for subject in &exported.subjects {
        if let Err(FormatMismatch { found, hint }) = gathering.add_all_of(subject) {
            let hint = if format.takes_documents() { REPORT_HINT.to_owned() } else { hint };
            diagnostics.push(mismatch(subject.value.span, &found, hint));
        }
    }
    if exported.is_report && !format.takes_documents() {
        let hint = format!("a report can go into {}", endings(Format::takes_documents));
        diagnostics.push(mismatch(exported.path.span, "the report of the script", hint));
    }
    gathering.items
}

/// What to do with values that are exported as a document.
const REPORT_HINT: &str =
    "write `export report to ...`: values are in a report where the script prints or checks them";

fn unknown_format(path: &str, span: Span) -> Diagnostic {
    let file = path.rsplit(['/', '\\']).next().unwrap_or(path);
    let ending = file.rsplit_once('.').map_or("", |(_, ending)| ending);
    let known = FORMATS
        .iter()
        .flat_map(|format| std::iter::once(format.ending).chain(format.aliases.iter().copied()));
    let (message, near) = match ending {
        "" => (format!("`{path}` has no ending, which would choose the format"), None),
        _ => (format!("no format has the ending `.{ending}`"), nearest(ending, known)),
    };
    let diagnostic = Diagnostic::error(Code::UnknownFormat, span, message)
        .hint(format!("formats are {}", endings(|_| true)));
    match near {
        Some(near) => {
            let diagnostic = diagnostic.label(format!("did you mean `.{near}`?"));
            match Fix::ending(span, path, ending, near) {
                Some(fix) => diagnostic.fix(fix),
                None => diagnostic,
            }
        }
        None => diagnostic,
    }
}

/// What a format has no place for, and where it could go instead.
pub(super) struct FormatMismatch {
    pub(super) found: String,
    pub(super) hint: String,
}

impl FormatMismatch {
    fn of(value: &Value) -> Self {
        let hint = match value {
            Value::Function(_) => "export what the function yields".to_owned(),
            _ => match subject(value) {
                Some(subject) => {
                    format!(
                        "a {} can go into {}",
                        value.kind(),
                        endings(|format| { format.takes_data || (format.takes)(&subject) })
                    )
                }
                None => format!(
                    "geometry goes into {}, tables into {}, and everything into {}",
                    endings(Format::takes_shapes),
                    endings(|format| (format.takes)(&Subject::Table(Arc::default()))),
                    endings(|format| format.takes_data),
                ),
            },
        };
        Self { found: value.phrase(), hint }
    }

    fn of_no_data(found: NoData<'_>) -> Self {
        match found {
            NoData::Function(function) => {
                let found = format!("the function `{}`", function.signature());
                Self { found, ..Self::of(&Value::Function(function.clone())) }
            }
            NoData::Parametric => Self {
                found: "a parametric curve or surface, which is a function".to_owned(),
                hint: "`to_nurbs(g, tolerance)` makes a NURBS of it".to_owned(),
            },
        }
    }
}

/// The endings of some formats as a list for a sentence.
fn endings(which: impl Fn(&Format) -> bool) -> String {
    let chosen = FORMATS.iter().filter(|format| which(format));
    let names: Vec<String> = chosen.map(|format| format!("`.{}`", format.ending)).collect();
    match names.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, before)) => format!("{} and {last}", before.join(", ")),
        None => String::new(),
    }
}

/// What a file could hold of a value that is one thing.
fn subject(value: &Value) -> Option<Subject> {
    Some(match value {
        Value::Point(point) => Subject::Point(*point),
        Value::Curve(curve) => Subject::Curve(curve.clone()),
        Value::Surface(surface) => Subject::Surface(surface.clone()),
        Value::Region(region) => Subject::Region(Arc::clone(region)),
        Value::Face(face) => Subject::Face(Arc::clone(face)),
        Value::Solid(solid) => Subject::Solid(Arc::clone(solid)),
        Value::Mesh(mesh) => Subject::Mesh(Arc::clone(mesh)),
        Value::Table(table) => Subject::Table(Arc::clone(table)),
        _ => return None,
    })
}

/// Values on their way into a file.
pub(super) struct GatheredItems {
    format: &'static Format,
    pub(super) items: Vec<Item>,
    /// Names that are taken, each with the number to try next for another thing of that name.
    names: HashMap<String, usize>,
}

impl GatheredItems {
    pub(super) fn new(format: &'static Format) -> Self {
        Self { format, items: Vec::new(), names: HashMap::new() }
    }

    /// Makes items of a value, lists and records of geometry element by element; else tells what
    /// was found.
    pub(super) fn add_all_of(
        &mut self,
        subject: &eval::ExportSubject,
    ) -> Result<(), FormatMismatch> {
        let eval::ExportSubject { name, value, .. } = subject;
        if self.format.takes_data {
            let data = data(&value.value).map_err(FormatMismatch::of_no_data)?;
            self.push(name, subject, data);
            return Ok(());
        }
        self.add((name, false), &value.value, subject)
    }

    fn add(
        &mut self,
        (name, is_in_record): (&str, bool),
        value: &Value,
        whole: &eval::ExportSubject,
    ) -> Result<(), FormatMismatch> {
        match value {
            Value::List(elements) => elements
                .iter()
                .enumerate()
                .filter(|(_, element)| !is_in_record || has_place(element))
                .try_for_each(|(i, element)| {
                    self.add((&format!("{name}[{i}]"), is_in_record), element, whole)
                }),
            // Such as the teeth and the envelope of a comb; what a record tells beside is left out.
            Value::Record(record) if record.iter().any(|(_, member)| has_place(member)) => {
                record.iter().filter(|(_, member)| has_place(member)).try_for_each(
                    |(label, member)| self.add((&format!("{name}.{label}"), true), member, whole),
                )
            }
            Value::Region(region) if let Some(borders) = self.borders_of(region) => {
                for (i, border) in borders.into_iter().enumerate() {
                    let own =
                        if i == 0 { ".outer".to_owned() } else { format!(".holes[{}]", i - 1) };
                    self.push(&format!("{name}{own}"), whole, Subject::Curve(border.into()));
                }
                Ok(())
            }
            Value::Face(face) if let Some(edges) = self.edges_of(face) => {
                for (i, edge) in edges.into_iter().enumerate() {
                    let subject = Subject::Curve(edge.into());
                    self.push(&format!("{name}.edges[{i}]"), whole, subject);
                }
                Ok(())
            }
            _ => {
                let subject = subject(value).ok_or_else(|| FormatMismatch::of(value))?;
                if !(self.format.takes)(&subject) {
                    return Err(FormatMismatch::of(value));
                }
                if matches!(subject, Subject::Table(_)) && !self.items.is_empty() {
                    let found = "a second table".to_owned();
                    return Err(FormatMismatch { found, ..FormatMismatch::of(value) });
                }
                self.push(name, whole, subject);
                Ok(())
            }
        }
    }

    /// The borders of a region for a format that has lines and no areas.
    fn borders_of(&self, region: &Arc<Region>) -> Option<Vec<NurbsCurve>> {
        let takes = |subject: &Subject| (self.format.takes)(subject);
        let borders = region.borders().ok()?;
        let first = Subject::Curve(borders.first()?.clone().into());
        (!takes(&Subject::Region(Arc::clone(region))) && takes(&first)).then_some(borders)
    }

    /// The edges of a face for a format that has lines and no faces.
    fn edges_of(&self, face: &Arc<Face>) -> Option<Vec<NurbsCurve>> {
        let takes = |subject: &Subject| (self.format.takes)(subject);
        let edges = face.edges(Tolerance::DEFAULT).ok()?;
        let first = Subject::Curve(edges.first()?.clone().into());
        (!takes(&Subject::Face(Arc::clone(face))) && takes(&first)).then_some(edges)
    }

    fn push(&mut self, name: &str, whole: &eval::ExportSubject, subject: Subject) {
        // Data are kept as they are; other files have lines and XML, which names must not break.
        let kept = |text: &str| {
            if self.format.takes_data { text.to_owned() } else { printable(text) }
        };
        let (own, group) = (kept(name), kept(&whole.name));
        let layer = whole.look.layer.as_deref().map(kept);
        let name = self.unused(&own);
        self.names.insert(name.clone(), 2);
        let color = whole.look.color;
        let identity = whole.identity;
        self.items.push(Item { group, color, layer, identity, ..Item::new(name, subject) });
    }

    /// The name, numbered where another item has it already.
    fn unused(&mut self, name: &str) -> String {
        let Some(&first) = self.names.get(name) else { return name.to_owned() };
        let numbered = |i: usize| format!("{name}-{i}");
        let is_free = |i: &usize| {
            work::count(1);
            !self.names.contains_key(&numbered(*i))
        };
        let free = (first..=first + self.items.len()).find(is_free).unwrap_or(first);
        self.names.insert(name.to_owned(), free + 1);
        numbered(free)
    }
}

/// Whether a value is geometry, a list that holds some, or a record with more than places.
fn has_place(value: &Value) -> bool {
    match value {
        Value::List(items) => items.numbers().is_none() && items.iter().any(has_place),
        Value::Record(record) => record.iter().any(|(_, member)| has_shape(member)),
        other => subject(other).is_some_and(|subject| subject.is_geometry()),
    }
}

/// The same without single places, which a record within a record tells beside, such as where a deviation is largest.
fn has_shape(value: &Value) -> bool {
    match value {
        Value::Point(_) => false,
        Value::List(items) => items.numbers().is_none() && items.iter().any(has_shape),
        other => has_place(other),
    }
}
