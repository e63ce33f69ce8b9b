//! What is told of a place while somebody writes: what stands there, and what could.

use lsp_types::{
    CompletionItem, CompletionItemKind, CompletionList, CompletionParams, CompletionTextEdit,
    Hover, HoverContents, HoverParams, InsertTextFormat, MarkupContent, MarkupKind, TextEdit,
};

use super::{
    closer_look::LookKey,
    convert,
    looks::{documentation, markdown},
    server::Server,
};
use crate::{
    disk::entries,
    docs,
    export::base64,
    ide::{self, CloserLook, Completion},
};

/// Completions that are sent at most; a letter more makes them fewer.
const MOST_OFFERED: usize = 400;

impl Server<'_> {
    pub(super) fn hover(&mut self, params: &HoverParams) -> Option<Hover> {
        let at = &params.text_document_position_params;
        let (open, document, places) = self.open(&at.text_document.uri)?;
        let offset = places.offset(at.position);
        let (mut text, range) = document.hover(&self.session, open.last_values(), offset)?;
        let shown = places.range(&range);
        let has_picture = self.client.reads_markdown && self.client.shows_pictures;
        let known = open.values.as_ref().and_then(|(serial, values)| {
            let value = document.shown_geometry(&self.session, values, offset)?;
            let key = LookKey {
                uri: open.uri.clone(),
                serial: open.serial,
                values: *serial,
                place: range,
            };
            CloserLook::is_worth_it(value, has_picture)
                .then(|| (key, value.clone(), values.report().document))
        });
        if let Some((key, value, document)) = known {
            let limits = *self.session.limits();
            let look = self
                .looks
                .of(key, move |stop| CloserLook::at(&value, document, &limits, has_picture, stop));
            let CloserLook { measures, picture } = look.unwrap_or_default();
            if !measures.is_empty() {
                text.push_str(&format!("\n\n{measures}"));
            }
            if let Some(png) = picture {
                text.push_str(&format!("\n\n![](data:image/png;base64,{})", base64(&png)));
            }
        }
        let contents = if self.client.reads_markdown {
            markdown(text)
        } else {
            MarkupContent { kind: MarkupKind::PlainText, value: without_fences(&text) }
        };
        Some(Hover { contents: HoverContents::Markup(contents), range: Some(shown) })
    }

    pub(super) fn completion(&self, params: &CompletionParams) -> Option<CompletionList> {
        let at = &params.text_document_position;
        let (open, document, places) = self.open(&at.text_document.uri)?;
        let folder = open.folder();
        let list = |below: &str| entries(&folder.join(below));
        let offset = places.offset(at.position);
        let found = document.completions(&self.session, open.last_values(), &list, offset);
        // All are of one place.
        let range = found.first().map(|first| first.range.clone()).unwrap_or_default();
        let typed = places.text.get(range.start..offset).unwrap_or_default();
        let (found, is_whole) = ide::offered(found, typed, MOST_OFFERED);
        let range = places.range(&range);
        let item = |one: Completion| {
            let snippet = one.snippet.filter(|_| self.client.snippets);
            CompletionItem {
                kind: Some(convert::completion_kind(one.kind)),
                detail: (!one.detail.is_empty()).then_some(one.detail),
                documentation: documentation(&one.docs),
                // The order of kinds is that of what is likelier.
                sort_text: Some(format!(
                    "{}{:02}{}",
                    u8::from(!one.is_fitting),
                    one.kind as u8,
                    one.label
                )),
                insert_text_format: snippet.as_ref().map(|_| InsertTextFormat::SNIPPET),
                text_edit: Some(CompletionTextEdit::Edit(TextEdit::new(
                    range,
                    snippet.unwrap_or(one.insert),
                ))),
                label: one.label,
                ..CompletionItem::default()
            }
        };
        let items = found.into_iter().map(item).collect();
        Some(CompletionList { is_incomplete: !is_whole, items })
    }

    /// A completion that somebody looks at: of a built-in with its page, which makes up half of a list.
    pub(super) fn completed(&self, item: CompletionItem) -> CompletionItem {
        let is_built_in = item.documentation.is_none()
            && matches!(
                item.kind,
                Some(CompletionItemKind::FUNCTION | CompletionItemKind::CONSTANT)
            );
        let page = is_built_in.then(|| docs::markdown(self.session.registry(), &item.label));
        match page.flatten() {
            Some(page) => CompletionItem { documentation: documentation(&page), ..item },
            None => item,
        }
    }
}

/// Markdown for whom reads it as it stands: without the lines around code.
fn without_fences(text: &str) -> String {
    let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with("```")).collect();
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::without_fences;

    #[test]
    fn plain_text_has_no_fences() {
        assert_eq!(without_fences("```geo\nlet a\n```\n\n3 mm"), "let a\n\n3 mm");
    }
}
