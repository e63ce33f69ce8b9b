//! The report of a script as a document: what it is given, says, claims and writes, and a picture.

mod sections;

use std::sync::Arc;

use self::sections::{ReviewedRun, ScriptText, document_file};
use super::{Event, File, PictureContent, Report, Session, drawable};
use crate::{
    diag::{Code, Diagnostic, Result, Severity, shown},
    export::{DocumentBlock, Item, PNG, ReportDocument, Subject},
    limits::Limits,
    value::Files,
};

/// The size of the picture in pixels: legible across a page.
const PICTURE_SIZE: [usize; 2] = [1200, 800];

impl Session {
    /// Puts the report into the files that are to hold it. Of a script with errors there is none, since
    /// nobody knows what would be missing from it.
    pub(super) fn compose(
        &self,
        report: &mut Report,
        (name, text): (&str, &str),
        (files, limits): (&dyn Files, &Limits),
    ) {
        if !report.events.iter().any(|event| document_file(event).is_some()) {
            return;
        }
        if report.count(Severity::Error) == 0 {
            let script = ScriptText::new(name, text, self.settings(files, limits));
            let compose = |file| self.document(report, &script, file);
            let documents: Vec<Option<Result<ReportDocument>>> =
                report.events.iter().map(|event| document_file(event).map(compose)).collect();
            for (event, document) in report.events.iter_mut().zip(documents) {
                match (event, document) {
                    (Event::File(file), Some(Ok(document))) => {
                        let name = document.title.clone();
                        let subject = Subject::Document(Arc::new(document));
                        file.job.items = vec![Item::new(name, subject)];
                    }
                    (_, Some(Err(found))) => report.diagnostics.push(*found),
                    _ => {}
                }
            }
        }
        let is_whole =
            |event: &Event| document_file(event).is_none_or(|file| !file.job.items.is_empty());
        report.events.retain(is_whole);
    }

    fn document(
        &self,
        report: &Report,
        script: &ScriptText,
        file: &File,
    ) -> Result<ReportDocument> {
        let options = &file.job.options;
        let telling = ReviewedRun { report, script, decimals: options.decimals };
        let title = options.title.clone().unwrap_or_else(|| script.title.clone());
        let mut blocks = telling.introduction();
        blocks.extend(self.picture_of(report, file)?);
        blocks.extend(telling.parameters());
        blocks.extend(telling.results());
        blocks.extend(telling.files());
        blocks.extend(telling.warnings());
        blocks.push(telling.origin());
        Ok(ReportDocument { title: shown(&title).into_owned(), blocks })
    }

    /// The picture of what the script exports or defines, unless it is not wanted; where nobody asked for
    /// one, also not of a script without geometry.
    fn picture_of(&self, report: &Report, file: &File) -> Result<Option<DocumentBlock>> {
        let options = &file.job.options;
        let has_geometry = || drawable(report).any(|(defined, _)| !defined.look.is_hidden);
        if !options.has_picture.unwrap_or_else(has_geometry) {
            return Ok(None);
        }
        let [width, height] = PICTURE_SIZE;
        let most = self.limits.picture_pixels;
        if most < width * height {
            let message = format!(
                "the picture of a report has {width}x{height} pixels; the ceiling is {most} pixels"
            );
            return Diagnostic::error(Code::TooLarge, file.span, message)
                .hint("`with (picture = false)` makes a report without one")
                .fail();
        }
        let content =
            PictureContent { options: options.clone(), ..PictureContent::new(PICTURE_SIZE) };
        let job = self.picture(report, &content, &PNG).map_err(|sentence| {
            Diagnostic::error(Code::CannotExport, file.span, sentence)
                .hint("`with (picture = false)` makes a report without a picture")
        })?;
        let mut names: Vec<&str> = job.items.iter().map(|item| item.group.as_str()).collect();
        names.dedup();
        let shows = sections::listed(names.into_iter());
        Ok(Some(DocumentBlock::Picture(Box::new(job), format!("Picture of {shows}"))))
    }
}
