//! What the client can do and wants, and what the server offers.

use lsp_types::{InitializeParams, PositionEncodingKind};
use serde_json::{Value as Json, json};

use super::paths;
use crate::ide::{ColumnUnit, HintOptions, TokenKind};

/// Runs a test: address of the document, name of the test.
pub(super) const TEST: &str = "virote.runTest";
/// Shows the script in a browser: address of the document, name of a definition.
pub(super) const VIEW: &str = "virote.openView";
/// Every command.
const COMMANDS: [&str; 2] = [TEST, VIEW];

/// The parser of Markdown in VS Code and what is made of it, where pictures in a hover are shown. Editors in a terminal
/// take Markdown too, and would show the text of a picture.
const PICTURE_PARSER: &str = "marked";

/// What the client can do and wants.
#[derive(Debug, Default)]
pub(super) struct Client {
    pub(super) unit: ColumnUnit,
    pub(super) snippets: bool,
    pub(super) refreshes_hints: bool,
    pub(super) refreshes_lenses: bool,
    pub(super) shows_documents: bool,
    pub(super) watches_files: bool,
    /// The folders of its workspace.
    pub(super) roots: Vec<std::path::PathBuf>,
    pub(super) shown: HintOptions,
    pub(super) has_lenses: bool,
    /// Whether what a hover shows is Markdown there.
    pub(super) reads_markdown: bool,
    /// Whether pictures in it are shown.
    pub(super) shows_pictures: bool,
}

impl Client {
    /// From the parameters of `initialize`, whatever they are.
    pub(super) fn of(params: &Json) -> Self {
        let params: InitializeParams = serde_json::from_value(params.clone()).unwrap_or_default();
        let can = |pointer: &str| {
            let all = serde_json::to_value(&params.capabilities).unwrap_or_default();
            all.pointer(pointer).and_then(Json::as_bool).unwrap_or(false)
        };
        let encodings = params
            .capabilities
            .general
            .as_ref()
            .and_then(|general| general.position_encodings.clone());
        let offered =
            |kind: &PositionEncodingKind| encodings.iter().flatten().any(|one| one == kind);
        let unit = if offered(&PositionEncodingKind::UTF8) {
            ColumnUnit::Utf8
        } else if offered(&PositionEncodingKind::UTF32) && !offered(&PositionEncodingKind::UTF16) {
            ColumnUnit::Utf32
        } else {
            ColumnUnit::Utf16
        };
        let folders = params.workspace_folders.iter().flatten().map(|folder| folder.uri.as_str());
        #[expect(deprecated, reason = "older clients tell their root so")]
        let root = params.root_uri.iter().map(|uri| uri.as_str());
        let mut roots: Vec<_> = folders.chain(root).filter_map(paths::path_of).collect();
        roots.dedup();
        let formats = params
            .capabilities
            .text_document
            .as_ref()
            .and_then(|documents| documents.hover.as_ref()?.content_format.clone());
        let reads_markdown =
            formats.is_none_or(|formats| formats.contains(&lsp_types::MarkupKind::Markdown));
        let markdown = params.capabilities.general.as_ref();
        let markdown = markdown.and_then(|general| general.markdown.as_ref());
        let mut client = Self {
            reads_markdown,
            shows_pictures: markdown.is_some_and(|markdown| markdown.parser == PICTURE_PARSER),
            unit,
            snippets: can("/textDocument/completion/completionItem/snippetSupport"),
            refreshes_hints: can("/workspace/inlayHint/refreshSupport"),
            refreshes_lenses: can("/workspace/codeLens/refreshSupport"),
            shows_documents: can("/window/showDocument/support"),
            watches_files: can("/workspace/didChangeWatchedFiles/dynamicRegistration"),
            roots,
            shown: HintOptions::default(),
            has_lenses: true,
        };
        client.set(params.initialization_options.as_ref().unwrap_or(&Json::Null));
        client
    }

    /// Takes the settings that it knows: those of `virote`, or the object itself.
    pub(super) fn set(&mut self, settings: &Json) {
        let settings = settings.get("virote").unwrap_or(settings);
        let switch = |pointer: &str, place: &mut bool| {
            if let Some(is_on) = settings.pointer(pointer).and_then(Json::as_bool) {
                *place = is_on;
            }
        };
        switch("/inlayHints/values", &mut self.shown.values);
        switch("/inlayHints/kinds", &mut self.shown.kinds);
        switch("/inlayHints/parameterNames", &mut self.shown.parameters);
        switch("/inlayHints/margins", &mut self.shown.margins);
        switch("/codeLens", &mut self.has_lenses);
        switch("/hover/pictures", &mut self.shows_pictures);
    }
}

/// The name of a kind of words.
fn token_type(kind: TokenKind) -> &'static str {
    match kind {
        TokenKind::Keyword => "keyword",
        TokenKind::Variable | TokenKind::Setting => "variable",
        TokenKind::Parameter => "parameter",
        TokenKind::Function => "function",
        TokenKind::Property => "property",
        TokenKind::Namespace => "namespace",
        TokenKind::Number => "number",
        TokenKind::Text => "string",
        TokenKind::Comment => "comment",
        TokenKind::Operator => "operator",
    }
}

/// What the server offers, as the result of `initialize`.
pub(super) fn initialize_result(client: &Client) -> Json {
    let encoding = match client.unit {
        ColumnUnit::Utf8 => "utf-8",
        ColumnUnit::Utf16 => "utf-16",
        ColumnUnit::Utf32 => "utf-32",
    };
    let incremental = 2;
    let capabilities = json!({
        "positionEncoding": encoding,
        "textDocumentSync": { "openClose": true, "change": incremental, "save": true },
        "hoverProvider": true,
        "completionProvider": {
            "triggerCharacters": [".", "\"", "/", "(", ","],
            "resolveProvider": true,
        },
        "signatureHelpProvider": {
            "triggerCharacters": ["(", ","],
            "retriggerCharacters": ["=", ")"],
        },
        "definitionProvider": true,
        "referencesProvider": true,
        "documentHighlightProvider": true,
        "documentSymbolProvider": true,
        "workspaceSymbolProvider": true,
        "renameProvider": { "prepareProvider": true },
        "codeActionProvider": { "codeActionKinds": ["quickfix"] },
        "codeLensProvider": {},
        "documentFormattingProvider": true,
        "documentRangeFormattingProvider": true,
        "documentOnTypeFormattingProvider": {
            "firstTriggerCharacter": "}",
            "moreTriggerCharacter": ["\n"],
        },
        "foldingRangeProvider": true,
        "selectionRangeProvider": true,
        "inlayHintProvider": true,
        "documentLinkProvider": {},
        "colorProvider": true,
        "callHierarchyProvider": true,
        "semanticTokensProvider": {
            "legend": {
                "tokenTypes": TokenKind::ALL.map(token_type),
                "tokenModifiers": ["declaration", "defaultLibrary", "readonly"],
            },
            "range": true,
            "full": true,
        },
        "executeCommandProvider": { "commands": COMMANDS },
        "workspace": { "workspaceFolders": { "supported": true, "changeNotifications": true } },
    });
    json!({
        "capabilities": capabilities,
        "serverInfo": { "name": "virote", "version": env!("CARGO_PKG_VERSION") },
    })
}
