//! Documents for people: headings, prose, tables, verdicts and pictures, as Markdown and as HTML.
//!
//! Who makes a document decides what stands in it; the two formats only write it down. A document is
//! one file: pictures are drawn when it is written, and stand in it as data (RFC 2397), so that it can
//! be mailed and read without a network.

mod html;
mod markdown;
mod markup;

use std::sync::Arc;

pub use self::markup::{DocumentCell, DocumentTable};
use self::{html::Html, markdown::Markdown, markup::Markup};
use super::{
    ExportError, Format, Job, Subject, Summary,
    options::{
        CAMERA, DECIMALS, EDGES, ExportOption, ISOCURVES, LOOK_AT, OBLIQUE_ANGLE, OBLIQUE_RATIO,
        PERSPECTIVE, PICTURE, TITLE, VIEW,
    },
    raster,
};
use crate::limits::work;

/// Something to be read from top to bottom.
#[derive(Clone, Debug, Default)]
pub struct ReportDocument {
    /// What stands above it.
    pub title: String,
    /// Its content.
    pub blocks: Vec<DocumentBlock>,
}

/// A part of a document.
#[derive(Clone, Debug)]
pub enum DocumentBlock {
    /// The title of what follows.
    Heading(String),
    /// A text; its line breaks are kept.
    Paragraph(String),
    /// What all claims together came to: whether they hold, and a sentence.
    Verdict(bool, String),
    /// Cells in rows.
    Table(DocumentTable),
    /// A picture, and what it shows.
    Picture(Box<Job>, String),
}

static OPTIONS: &[&ExportOption] = &[
    &TITLE,
    &DECIMALS,
    &PICTURE,
    &VIEW,
    &OBLIQUE_ANGLE,
    &OBLIQUE_RATIO,
    &CAMERA,
    &LOOK_AT,
    &PERSPECTIVE,
    &EDGES,
    &ISOCURVES,
];

pub(super) static HTML: Format = Format {
    ending: "html",
    aliases: &["htm"],
    title: "HTML: the report of the script as one page, for any browser and for paper",
    options: OPTIONS,
    takes,
    takes_data: false,
    is_of_meshes: false,
    wants: "the report of the script",
    write: |job, out| write(job, &mut Html::new(out)),
};

pub(super) static MARKDOWN: Format = Format {
    ending: "md",
    aliases: &["markdown"],
    title: "Markdown: the report of the script as text with tables",
    options: OPTIONS,
    takes,
    takes_data: false,
    is_of_meshes: false,
    wants: "the report of the script",
    write: |job, out| write(job, &mut Markdown::new(out)),
};

fn takes(subject: &Subject) -> bool {
    matches!(subject, Subject::Document(_))
}

fn write(job: &Job, markup: &mut dyn Markup) -> Result<Summary, ExportError> {
    let mut summary = Summary::default();
    for item in &job.items {
        if let Subject::Document(document) = &item.subject {
            summary.count(&item.subject);
            write_document(document, markup)?;
        }
    }
    Ok(summary)
}

fn write_document(
    document: &Arc<ReportDocument>,
    markup: &mut dyn Markup,
) -> Result<(), ExportError> {
    markup.begin(&document.title)?;
    for block in &document.blocks {
        work::count(1);
        match block {
            DocumentBlock::Heading(text) => markup.heading(text)?,
            DocumentBlock::Paragraph(text) => markup.paragraph(text)?,
            DocumentBlock::Verdict(holds, text) => markup.verdict(*holds, text)?,
            DocumentBlock::Table(table) => markup.table(table)?,
            DocumentBlock::Picture(job, shows) => {
                let mut png = Vec::new();
                (raster::FORMAT.write)(job, &mut png)?;
                markup.picture(&png, shows)?;
            }
        }
    }
    Ok(markup.end()?)
}
