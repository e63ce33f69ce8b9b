//! The parts of a report, each as blocks of a document.

use std::collections::HashMap;

use crate::{
    diag::{Severity, Span, shown},
    eval::{self, Checked, Printed, Schema},
    export::{DocumentBlock, DocumentCell, DocumentTable},
    kernel::{Column, Table},
    session::{Event, File, Report},
    syntax::{
        self,
        ast::{Statement, StatementKind},
        is_name,
    },
    value::{MOST_ROWS, NumberFormat, Value, shortest, table_cells},
};

/// Characters of a value that a report shows.
const MOST_SHOWN: usize = 2000;
/// Names that are listed; the rest is counted.
const MOST_NAMES: usize = 8;

/// What a report takes from the text of a script.
pub(super) struct ScriptText {
    /// The file without its folder.
    name: String,
    pub(super) title: String,
    introduction: Vec<DocumentBlock>,
    /// The places of statements that act and have documentation, with it.
    docs: Vec<(Span, String)>,
    schema: Schema,
}

impl ScriptText {
    pub(super) fn new(name: &str, text: &str, settings: eval::Settings<'_>) -> Self {
        let name = name.rsplit(['/', '\\']).next().unwrap_or(name);
        let (tree, _) = syntax::parse(text, settings.limits);
        let mut introduction = prose(header(&tree.statements).unwrap_or_default());
        let title = match introduction.first() {
            Some(DocumentBlock::Heading(title)) => title.clone(),
            Some(DocumentBlock::Paragraph(first)) => {
                first.lines().next().unwrap_or_default().trim_end_matches('.').to_owned()
            }
            _ => name.strip_suffix(".geo").unwrap_or(name).to_owned(),
        };
        match introduction.first_mut() {
            Some(DocumentBlock::Paragraph(first)) if first.contains('\n') => {
                *first = first.lines().skip(1).collect::<Vec<_>>().join("\n");
            }
            Some(_) => drop(introduction.remove(0)),
            None => {}
        }
        let docs = tree.statements.iter().filter(|statement| acts(&statement.kind));
        let docs = docs.filter_map(|statement| Some((statement.span, statement.docs.clone()?)));
        let docs = docs.collect();
        let schema = eval::parameters(name, text, &mut crate::diag::Sources::default(), settings);
        Self { name: name.to_owned(), title, introduction, docs, schema }
    }

    /// The place and the documentation of the statement that a place lies in.
    fn docs_at(&self, span: Span) -> Option<&(Span, String)> {
        let idx = self.docs.partition_point(|(place, _)| place.start <= span.start);
        let (before, docs) = (idx.checked_sub(1)?, &self.docs);
        Some(&docs[before]).filter(|(place, _)| span.start < place.end)
    }
}

/// The documentation of a script: that of its first statement, where this is one about all of it.
fn header<'s>(statements: &'s [Statement<'_>]) -> Option<&'s str> {
    let first = statements.first()?;
    let is_of_all = matches!(
        first.kind,
        StatementKind::Edition(_) | StatementKind::Unit(_) | StatementKind::Tolerance(_)
    );
    first.docs.as_deref().filter(|_| is_of_all)
}

fn acts(kind: &StatementKind<'_>) -> bool {
    matches!(kind, StatementKind::Check { .. } | StatementKind::Print(_) | StatementKind::Export(_))
}

/// Documentation as headings, the lines that begin with `#`, and paragraphs between empty lines.
fn prose(docs: &str) -> Vec<DocumentBlock> {
    let mut blocks = Vec::new();
    let mut lines: Vec<&str> = Vec::new();
    for line in docs.lines().map(str::trim).chain([""]) {
        let heading = line.strip_prefix('#').map(|rest| rest.trim_start_matches('#').trim());
        if (line.is_empty() || heading.is_some()) && !lines.is_empty() {
            blocks.push(DocumentBlock::Paragraph(shown(&lines.join("\n")).into_owned()));
            lines.clear();
        }
        match heading {
            Some(heading) => blocks.push(DocumentBlock::Heading(shown(heading).into_owned())),
            None if !line.is_empty() => lines.push(line),
            None => {}
        }
    }
    blocks
}

/// What tells of a run.
pub(super) struct ReviewedRun<'a> {
    pub(super) report: &'a Report,
    pub(super) script: &'a ScriptText,
    /// Digits behind the point of printed numbers.
    pub(super) decimals: Option<usize>,
}

impl ReviewedRun<'_> {
    fn unit(&self) -> &'static str {
        self.report.document.0.name()
    }

    /// What the script says of itself, and whether its claims hold.
    pub(super) fn introduction(&self) -> Vec<DocumentBlock> {
        let checks = self.report.events.iter().filter_map(|event| match event {
            Event::Checked(checked) => Some(checked.verdict.holds),
            _ => None,
        });
        let verdicts: Vec<bool> = checks.collect();
        let n_failed = verdicts.iter().filter(|holds| !**holds).count();
        let text = match (n_failed, verdicts.len()) {
            (0, 0) => "The script makes no claims.".to_owned(),
            (0, 1) => "The one check holds.".to_owned(),
            (0, n) => format!("All {n} checks hold."),
            (1, 1) => "The one check fails.".to_owned(),
            (1, n) => format!("1 of {n} checks fails."),
            (n_failed, n) => format!("{n_failed} of {n} checks fail."),
        };
        let mut blocks = self.script.introduction.clone();
        blocks.push(match verdicts.is_empty() {
            true => DocumentBlock::Paragraph(text),
            false => DocumentBlock::Verdict(n_failed == 0, text),
        });
        blocks
    }

    /// What the script was given.
    pub(super) fn parameters(&self) -> Vec<DocumentBlock> {
        let unit = self.unit();
        let definitions = self.report.definitions.iter();
        let values: HashMap<&str, Option<&Value>> =
            definitions.map(|defined| (&*defined.name, defined.value.as_ref())).collect();
        let row = |parameter: &eval::SchemaParameter| {
            let value = values.get(&*parameter.name).copied().flatten();
            let written = |value: &Value| parameter.written(value, unit);
            let (value, default) = (value.map(written), written(&parameter.default));
            let is_default = value.as_ref() == Some(&default);
            // As the script says it.
            let allowed = parameter.allowed.as_ref().map(written);
            let step = parameter.step.map(|step| format!("step {}", written(&Value::Number(step))));
            let about = parameter.label.iter().chain(&parameter.docs);
            vec![
                code(&parameter.name),
                code(&value.unwrap_or_default()),
                code(if is_default { "" } else { &default }),
                code(&[allowed, step].into_iter().flatten().collect::<Vec<_>>().join(" ")),
                text(&about.map(String::as_str).collect::<Vec<_>>().join("; ")),
            ]
        };
        let rows = self.script.schema.parameters.iter().map(row).collect();
        titled("Parameters", table(&["Parameter", "Value", "Default", "Allowed", "Meaning"], rows))
    }

    /// What the script prints and claims, in its order.
    pub(super) fn results(&self) -> Vec<DocumentBlock> {
        let mut blocks = Vec::new();
        let mut told: Option<Span> = None;
        for event in &self.report.events {
            let span = match event {
                Event::Printed(printed) => printed.span,
                Event::Checked(checked) => checked.span,
                Event::File(_) | Event::Expected(_) => continue,
            };
            if let Some((place, docs)) = self.script.docs_at(span)
                && told != Some(*place)
            {
                told = Some(*place);
                blocks.extend(prose(docs));
            }
            match event {
                Event::Printed(printed) => self.print(printed, &mut blocks),
                Event::Checked(checked) => check(checked, &mut blocks),
                Event::File(_) | Event::Expected(_) => {}
            }
        }
        if blocks.first().is_some_and(|first| !matches!(first, DocumentBlock::Heading(_))) {
            blocks.insert(0, DocumentBlock::Heading("Results".to_owned()));
        }
        for block in &mut blocks {
            match block {
                DocumentBlock::Table(table)
                    if table.rows.first().is_some_and(|first| is_check(first)) =>
                {
                    leave_out_empty(table);
                }
                _ => {}
            }
        }
        blocks
    }

    fn print(&self, printed: &Printed, blocks: &mut Vec<DocumentBlock>) {
        match &printed.value {
            Value::Text(said) if printed.is_text => {
                blocks.push(DocumentBlock::Paragraph(shown(said).into_owned()));
            }
            Value::Table(table) => {
                // A table that has no name stands for itself.
                let caption = is_name(&printed.source).then(|| printed.source.clone());
                blocks.push(DocumentBlock::Table(self.cells(table, caption)));
            }
            value => {
                let format = NumberFormat::new(self.decimals, None, self.unit()).ok();
                let decimals = self.decimals.filter(|_| !is_count(value));
                let rounded = decimals.and(format).and_then(|it| it.text(value).ok());
                let told = rounded.unwrap_or_else(|| printed.value_text());
                let row = vec![code(&printed.source), code(&cut(&told))];
                add_row(&["Quantity", "Value"], row, blocks);
            }
        }
    }

    fn cells(&self, table: &Table, caption: Option<String>) -> DocumentTable {
        let n_rows = table.n_rows().min(MOST_ROWS);
        let columns = table.columns().iter();
        let columns: Vec<Vec<String>> =
            columns.map(|column| table_cells(column, n_rows, self.decimals)).collect();
        let is_number = |idx: usize| matches!(&table.columns()[idx].column, Column::Numbers(_));
        let head = columns.iter().enumerate();
        let head = head.map(|(idx, column)| (column[0].clone(), is_number(idx))).collect();
        let row = |row: usize| {
            columns.iter().map(|column| DocumentCell::Text(column[row].clone())).collect()
        };
        let rows = (1..=n_rows).map(row).collect();
        DocumentTable { caption, head, rows, n_more: table.n_rows() - n_rows }
    }

    /// What the script writes beside its reports.
    pub(super) fn files(&self) -> Vec<DocumentBlock> {
        let files = self.report.events.iter().filter_map(|event| match event {
            Event::File(file) if document_file(event).is_none() => Some(&**file),
            _ => None,
        });
        let row = |file: &File| {
            let format = file.format.title.split(':').next().unwrap_or_default();
            let mut names: Vec<&str> =
                file.job.items.iter().map(|item| item.group.as_str()).collect();
            names.dedup();
            let docs = self.script.docs_at(file.span).map(|(_, docs)| docs.as_str());
            let content = listed(names.into_iter());
            vec![code(&file.path), text(format), code(&content), text(docs.unwrap_or_default())]
        };
        titled("Files", table(&["File", "Format", "Content", "Meaning"], files.map(row).collect()))
    }

    /// What the run warns of.
    pub(super) fn warnings(&self) -> Vec<DocumentBlock> {
        let found = self.report.diagnostics.iter();
        let warnings = found.filter(|found| found.severity == Severity::Warning);
        let row = |found: &crate::diag::Diagnostic| {
            let source = self.report.sources.at(found.primary.span);
            let line = source.map(|source| source.line_column(found.primary.span.start).0);
            let line = line.map(|line| line.to_string()).unwrap_or_default();
            vec![text(&line), text(&found.message)]
        };
        titled("Warnings", table(&["Line", "Warning"], warnings.map(row).collect()))
    }

    /// Where all this is from, and what its numbers are told in.
    pub(super) fn origin(&self) -> DocumentBlock {
        let (unit, tolerance) = (self.unit(), shortest(self.report.document.1.distance));
        let name = shown(&self.script.name);
        DocumentBlock::Paragraph(format!(
            "From {name}. Lengths without a unit are in {unit}; points closer than {tolerance}{unit} are one."
        ))
    }
}

fn check(checked: &Checked, blocks: &mut Vec<DocumentBlock>) {
    let verdict = &checked.verdict;
    let sides = verdict.brief_sides();
    let side = |idx: usize| match sides.get(idx) {
        Some(side) if side.path.is_empty() => code(&side.value),
        Some(side) => code(&format!("{} = {}", side.path, side.value)),
        None => code(""),
    };
    let row = vec![
        DocumentCell::Verdict(verdict.holds),
        text(checked.message.as_deref().unwrap_or_default()),
        code(&checked.source),
        side(0),
        side(1),
        text(&verdict.figures()),
    ];
    add_row(&["Check", "Claim", "As written", "Left", "Right", "Finding"], row, blocks);
}

/// Adds a row to the table at the end, or to a new one where there is none of this head.
fn add_row(head: &[&str], row: Vec<DocumentCell>, blocks: &mut Vec<DocumentBlock>) {
    let is_same = |table: &DocumentTable| {
        table.head.iter().map(|(title, _)| title.as_str()).eq(head.iter().copied())
    };
    match blocks.last_mut() {
        Some(DocumentBlock::Table(table)) if is_same(table) => table.rows.push(row),
        _ => blocks.push(DocumentBlock::Table(DocumentTable {
            head: head.iter().map(|&title| (title.to_owned(), false)).collect(),
            rows: vec![row],
            ..DocumentTable::default()
        })),
    }
}

/// A table of words and code, without columns that are empty.
fn table(head: &[&str], rows: Vec<Vec<DocumentCell>>) -> DocumentTable {
    let head = head.iter().map(|&title| (title.to_owned(), false)).collect();
    let mut table = DocumentTable { head, rows, ..DocumentTable::default() };
    leave_out_empty(&mut table);
    table
}

/// Whether a row tells of a check.
fn is_check(row: &[DocumentCell]) -> bool {
    matches!(row.first(), Some(DocumentCell::Verdict(_)))
}

/// Takes out the columns of a table in which no row has anything.
fn leave_out_empty(table: &mut DocumentTable) {
    let is_blank = |cell: &DocumentCell| match cell {
        DocumentCell::Text(text) | DocumentCell::Code(text) => text.is_empty(),
        DocumentCell::Verdict(_) => false,
    };
    for idx in (0..table.head.len()).rev() {
        if table.rows.iter().all(|row| is_blank(&row[idx])) {
            table.head.remove(idx);
            table.rows.iter_mut().for_each(|row| drop(row.remove(idx)));
        }
    }
}

/// A table under its title, if it has rows.
fn titled(title: &str, table: DocumentTable) -> Vec<DocumentBlock> {
    match table.rows.is_empty() {
        true => Vec::new(),
        false => vec![DocumentBlock::Heading(title.to_owned()), DocumentBlock::Table(table)],
    }
}

fn text(text: &str) -> DocumentCell {
    DocumentCell::Text(shown(text).into_owned())
}

fn code(text: &str) -> DocumentCell {
    DocumentCell::Code(shown(text).into_owned())
}

/// A value in no more characters than a reader looks at.
fn cut(text: &str) -> String {
    match text.char_indices().nth(MOST_SHOWN) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

/// Names behind one another, the first of many.
pub(super) fn listed<'n>(names: impl ExactSizeIterator<Item = &'n str>) -> String {
    let n_more = names.len().saturating_sub(MOST_NAMES);
    let shown: Vec<&str> = names.take(MOST_NAMES).collect();
    let more = if n_more == 0 { String::new() } else { format!(" and {n_more} more") };
    format!("{}{more}", shown.join(", "))
}

/// The file of an event that is to hold the report.
pub(super) fn document_file(event: &Event) -> Option<&File> {
    match event {
        Event::File(file) if file.format.takes_documents() => Some(file),
        _ => None,
    }
}

/// Whether a value is a whole number without a unit, which counts something.
fn is_count(value: &Value) -> bool {
    matches!(value, Value::Number(number) if number.dim.is_bare() && number.value.fract() == 0.0)
}
