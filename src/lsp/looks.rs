//! Requests about one text: what is told, offered, coloured, folded, formatted.

use std::{path::Path, str::FromStr};

use lsp_types::{
    CodeLens, CodeLensParams, Color, ColorInformation, ColorPresentation, ColorPresentationParams,
    Command, DocumentColorParams, DocumentFormattingParams, DocumentLink, DocumentLinkParams,
    DocumentOnTypeFormattingParams, DocumentRangeFormattingParams, Documentation, FoldingRange,
    FoldingRangeKind, FoldingRangeParams, InlayHint, InlayHintKind, InlayHintLabel,
    InlayHintParams, MarkupContent, MarkupKind, ParameterInformation, ParameterLabel,
    SelectionRange, SelectionRangeParams, SemanticToken, SemanticTokens, SemanticTokensParams,
    SemanticTokensRangeParams, SignatureHelp, SignatureHelpParams, SignatureInformation, TextEdit,
    Uri,
};
use serde_json::json;

use super::{capabilities, convert::TextPlaces, documents::OpenDocument, paths, server::Server};
use crate::{
    ide::{self, Document, HintKind, LensKind, TokenKind},
    session::TestVerdict,
};

pub(super) fn markdown(value: String) -> MarkupContent {
    MarkupContent { kind: MarkupKind::Markdown, value }
}

/// Documentation, unless there is none.
pub(super) fn documentation(text: &str) -> Option<Documentation> {
    (!text.is_empty()).then(|| Documentation::MarkupContent(markdown(text.to_owned())))
}

impl Server<'_> {
    /// An open document with its names and its lines.
    pub(super) fn open(&self, uri: &Uri) -> Option<(&OpenDocument, &Document, TextPlaces<'_>)> {
        let open = self.documents.get(uri.as_str())?;
        let document = open.document(&self.session, &self.files(open));
        Some((open, document, open.places(self.client.unit)))
    }

    pub(super) fn signature_help(&self, params: &SignatureHelpParams) -> Option<SignatureHelp> {
        let at = &params.text_document_position_params;
        let (open, document, places) = self.open(&at.text_document.uri)?;
        let at = places.offset(at.position);
        let found = document.signatures(&self.session, open.last_values(), at);
        let active = found.first()?.active;
        let signatures = found.into_iter().map(|one| SignatureInformation {
            documentation: documentation(&one.docs),
            parameters: Some(
                one.parameters
                    .iter()
                    .map(|parameter| ParameterInformation {
                        label: ParameterLabel::Simple(parameter.label.clone()),
                        documentation: documentation(&parameter.docs),
                    })
                    .collect(),
            ),
            active_parameter: one.active.map(|idx| idx as u32),
            label: one.label,
        });
        Some(SignatureHelp {
            signatures: signatures.collect(),
            active_signature: Some(0),
            active_parameter: active.map(|idx| idx as u32),
        })
    }

    pub(super) fn tokens(&self, params: &SemanticTokensParams) -> Option<SemanticTokens> {
        let (_, document, places) = self.open(&params.text_document.uri)?;
        Some(self.tokens_of(document, &places, &(0..places.text.len())))
    }

    pub(super) fn tokens_within(
        &self,
        params: &SemanticTokensRangeParams,
    ) -> Option<SemanticTokens> {
        let (_, document, places) = self.open(&params.text_document.uri)?;
        Some(self.tokens_of(document, &places, &places.bytes(&params.range)))
    }

    fn tokens_of(
        &self,
        document: &Document,
        places: &TextPlaces<'_>,
        within: &std::ops::Range<usize>,
    ) -> SemanticTokens {
        let mut data = Vec::new();
        let (mut line, mut column) = (0, 0);
        let tokens = document.tokens(self.session.registry());
        for token in tokens
            .iter()
            .filter(|token| token.range.start < within.end && within.start < token.range.end)
        {
            let kind =
                TokenKind::ALL.iter().position(|kind| *kind == token.kind).unwrap_or_default();
            let is_fixed = matches!(token.kind, TokenKind::Variable);
            let modifiers = [token.is_declaration, token.is_built_in, is_fixed];
            let modifiers =
                modifiers.iter().enumerate().map(|(bit, &is_on)| u32::from(is_on) << bit).sum();
            // A comment over several lines is a token on each.
            let mut start = token.range.start;
            for part in places.text[token.range.clone()].split_inclusive('\n') {
                let text = part.trim_end_matches(['\n', '\r']);
                let (begin, end) = (places.position(start), places.position(start + text.len()));
                start += part.len();
                if begin.character == end.character {
                    continue;
                }
                let delta_start =
                    if begin.line == line { begin.character - column } else { begin.character };
                data.push(SemanticToken {
                    delta_line: begin.line - line,
                    delta_start,
                    length: end.character - begin.character,
                    token_type: kind as u32,
                    token_modifiers_bitset: modifiers,
                });
                (line, column) = (begin.line, begin.character);
            }
        }
        SemanticTokens { result_id: None, data }
    }

    pub(super) fn folds(&self, params: &FoldingRangeParams) -> Option<Vec<FoldingRange>> {
        let (_, document, places) = self.open(&params.text_document.uri)?;
        let fold = |fold: ide::FoldingRange| {
            let (start, end) = (places.position(fold.range.start), places.position(fold.range.end));
            let kind = match (fold.is_comment, fold.is_imports) {
                (true, _) => Some(FoldingRangeKind::Comment),
                (_, true) => Some(FoldingRangeKind::Imports),
                _ => None,
            };
            FoldingRange {
                start_line: start.line,
                end_line: end.line,
                kind,
                ..FoldingRange::default()
            }
        };
        Some(
            document
                .folds()
                .into_iter()
                .map(fold)
                .filter(|fold| fold.start_line < fold.end_line)
                .collect(),
        )
    }

    pub(super) fn selections(&self, params: &SelectionRangeParams) -> Option<Vec<SelectionRange>> {
        let (_, document, places) = self.open(&params.text_document.uri)?;
        let nested = |at: &lsp_types::Position| {
            let ranges = document.selections(places.offset(*at));
            let around = |parent: Option<Box<SelectionRange>>, range: &std::ops::Range<usize>| {
                Some(Box::new(SelectionRange { range: places.range(range), parent }))
            };
            let innermost = ranges.iter().rev().fold(None, around);
            innermost.map_or(
                SelectionRange { range: lsp_types::Range::new(*at, *at), parent: None },
                |range| *range,
            )
        };
        Some(params.positions.iter().map(nested).collect())
    }

    pub(super) fn formatted(&self, params: &DocumentFormattingParams) -> Option<Vec<TextEdit>> {
        let (open, document, places) = self.open(&params.text_document.uri)?;
        if let Some(fault) = document.outline().faults.first() {
            let line = places.position(fault.primary.span.range().start).line + 1;
            let why = format!(
                "{}: not formatted because of a mistake in line {line}: {}",
                open.name(),
                fault.message
            );
            self.notify("window/showMessage", json!({ "type": 2, "message": why }));
        }
        Some(places.edits(&ide::formatted(&self.session, &open.text)))
    }

    pub(super) fn range_formatted(
        &self,
        params: &DocumentRangeFormattingParams,
    ) -> Option<Vec<TextEdit>> {
        let (start, end) = (params.range.start.line as usize, params.range.end.line as usize);
        self.lines_formatted(&params.text_document.uri, start.min(end)..start.max(end) + 1)
    }

    pub(super) fn formatted_on_type(
        &self,
        params: &DocumentOnTypeFormattingParams,
    ) -> Option<Vec<TextEdit>> {
        let at = &params.text_document_position;
        let line = at.position.line as usize;
        if params.ch != "\n" {
            return self.lines_formatted(&at.text_document.uri, line..line + 1);
        }
        // After a line break the line that was finished; from the new one on all is being written.
        let finished = line.checked_sub(1)?;
        let mut edits = self.lines_formatted(&at.text_document.uri, finished..line)?;
        let written = lsp_types::Position::new(at.position.line, 0);
        edits.retain(|edit| edit.range.end <= written);
        Some(edits)
    }

    fn lines_formatted(&self, uri: &Uri, lines: std::ops::Range<usize>) -> Option<Vec<TextEdit>> {
        let open = self.documents.get(uri.as_str())?;
        let edits = ide::formatted_lines(&self.session, &open.text, &lines);
        Some(open.places(self.client.unit).edits(&edits))
    }

    pub(super) fn hints(&self, params: &InlayHintParams) -> Option<Vec<InlayHint>> {
        let (open, document, places) = self.open(&params.text_document.uri)?;
        let within = places.bytes(&params.range);
        let found =
            document.hints(self.session.registry(), open.values(), &within, self.client.shown);
        let hint = |hint: ide::Hint| InlayHint {
            position: places.position(hint.at),
            label: InlayHintLabel::String(hint.text),
            kind: match hint.kind {
                HintKind::Parameter => Some(InlayHintKind::PARAMETER),
                HintKind::Kind | HintKind::Value => Some(InlayHintKind::TYPE),
                HintKind::Margin => None,
            },
            text_edits: None,
            tooltip: None,
            padding_left: None,
            padding_right: None,
            data: None,
        };
        Some(found.into_iter().map(hint).collect())
    }

    pub(super) fn lenses(&self, params: &CodeLensParams) -> Option<Vec<CodeLens>> {
        let (open, document, places) = self.open(&params.text_document.uri)?;
        if !self.client.has_lenses {
            return Some(Vec::new());
        }
        let lens = |lens: ide::CodeLens| {
            let (title, command, name) = match lens.kind {
                LensKind::Test { name, verdict } => {
                    let title = match verdict {
                        Some(TestVerdict::Passed) => "run (✓ passed)".to_owned(),
                        Some(verdict) => format!("run (✗ {})", verdict.word()),
                        None => "run".to_owned(),
                    };
                    (title, capabilities::TEST, name)
                }
                LensKind::View(name) => ("open in view".to_owned(), capabilities::VIEW, name),
                LensKind::Check { holds, figures } => {
                    let sign = if holds { "✓" } else { "✗" };
                    (format!("{sign} {figures}"), "", String::new())
                }
            };
            let arguments = (!command.is_empty()).then(|| vec![json!(open.uri), json!(name)]);
            let command = Command { title, command: command.to_owned(), arguments };
            CodeLens { range: places.range(&lens.range), command: Some(command), data: None }
        };
        Some(document.lenses(open.values()).into_iter().map(lens).collect())
    }

    pub(super) fn links(&self, params: &DocumentLinkParams) -> Option<Vec<DocumentLink>> {
        let (open, document, places) = self.open(&params.text_document.uri)?;
        let folder = open.folder();
        let link = |range: &std::ops::Range<usize>, path: &str| {
            let path = paths::normal(&folder.join(Path::new(path)));
            let uri =
                path.is_file().then(|| Uri::from_str(&paths::uri_of(&path)).ok()).flatten()?;
            let inside = range.start + 1..range.end.saturating_sub(1).max(range.start + 1);
            Some(DocumentLink {
                range: places.range(&inside),
                target: Some(uri),
                tooltip: None,
                data: None,
            })
        };
        let mut found: Vec<DocumentLink> =
            document.imports().iter().filter_map(|(range, path)| link(range, path)).collect();
        // A string that is the path of a file.
        let paths = document
            .outline()
            .texts
            .iter()
            .filter(|(_, text, _)| text.contains('.') && !text.contains('\n'));
        found.extend(paths.filter_map(|(range, text, _)| link(range, text)));
        Some(found)
    }

    pub(super) fn colors(&self, params: &DocumentColorParams) -> Option<Vec<ColorInformation>> {
        let (_, document, places) = self.open(&params.text_document.uri)?;
        let color = |(range, color): (std::ops::Range<usize>, ide::Color)| {
            let [red, green, blue] = color.map(|part| f32::from(part) / 255.0);
            ColorInformation {
                range: places.range(&range),
                color: Color { red, green, blue, alpha: 1.0 },
            }
        };
        Some(ide::colors(document).into_iter().map(color).collect())
    }

    pub(super) fn spellings(
        &self,
        params: &ColorPresentationParams,
    ) -> Option<Vec<ColorPresentation>> {
        let Color { red, green, blue, .. } = params.color;
        let color = [red, green, blue].map(|part| (part * 255.0).round() as u8);
        let spelling = |text: String| ColorPresentation {
            text_edit: Some(TextEdit::new(params.range, text.clone())),
            label: text,
            additional_text_edits: None,
        };
        Some(ide::spellings(color).into_iter().map(spelling).collect())
    }
}
