//! Which request is answered where.

use lsp_server::ErrorCode;
use serde::{Serialize, de::DeserializeOwned};
use serde_json::Value as Json;

use super::server::{RequestError, Server, WrittenResult};

/// Whether a request waits for the values of the text as it stands: what it shows would be of another
/// text otherwise, or lack them.
pub(super) fn needs_values(method: &str) -> bool {
    matches!(method, "textDocument/inlayHint" | "textDocument/codeLens" | "textDocument/codeAction")
}

/// The answer to a request.
pub(super) fn answer(server: &mut Server<'_>, method: &str, params: Json) -> WrittenResult {
    match method {
        "textDocument/hover" => with(params, |params| server.hover(&params)),
        "textDocument/completion" => with(params, |params| server.completion(&params)),
        "completionItem/resolve" => with(params, |params| Some(server.completed(params))),
        "textDocument/signatureHelp" => with(params, |params| server.signature_help(&params)),
        "textDocument/definition" => with(params, |params| server.definition(&params)),
        "textDocument/references" => with(params, |params| server.references(&params)),
        "textDocument/documentHighlight" => with(params, |params| server.highlights(&params)),
        "textDocument/prepareRename" => written(&server.prepare_rename(&parsed(params)?)?),
        "textDocument/rename" => written(&server.rename(&parsed(params)?)?),
        "textDocument/documentSymbol" => with(params, |params| server.symbols(&params)),
        "workspace/symbol" => with(params, |params| server.workspace_symbols(&params)),
        "textDocument/foldingRange" => with(params, |params| server.folds(&params)),
        "textDocument/selectionRange" => with(params, |params| server.selections(&params)),
        "textDocument/semanticTokens/full" => with(params, |params| server.tokens(&params)),
        "textDocument/semanticTokens/range" => with(params, |params| server.tokens_within(&params)),
        "textDocument/formatting" => with(params, |params| server.formatted(&params)),
        "textDocument/rangeFormatting" => with(params, |params| server.range_formatted(&params)),
        "textDocument/onTypeFormatting" => with(params, |params| server.formatted_on_type(&params)),
        "textDocument/inlayHint" => with(params, |params| server.hints(&params)),
        "textDocument/codeLens" => with(params, |params| server.lenses(&params)),
        "textDocument/codeAction" => with(params, |params| server.code_actions(&params)),
        "textDocument/documentLink" => with(params, |params| server.links(&params)),
        "textDocument/documentColor" => with(params, |params| server.colors(&params)),
        "textDocument/colorPresentation" => with(params, |params| server.spellings(&params)),
        "textDocument/prepareCallHierarchy" => with(params, |params| server.prepare_calls(&params)),
        "callHierarchy/incomingCalls" => with(params, |params| server.incoming_calls(&params)),
        "callHierarchy/outgoingCalls" => with(params, |params| server.outgoing_calls(&params)),
        "workspace/executeCommand" => written(&server.execute(&params)?),
        _ => Err(RequestError(ErrorCode::MethodNotFound, format!("there is no method `{method}`"))),
    }
}

/// Parameters as their type.
fn parsed<P: DeserializeOwned>(params: Json) -> Result<P, RequestError> {
    serde_json::from_value(params)
        .map_err(|err| RequestError(ErrorCode::InvalidParams, err.to_string()))
}

/// What a request comes to; `null` where there is nothing.
fn with<P: DeserializeOwned, R: Serialize>(
    params: Json,
    look: impl FnOnce(P) -> Option<R>,
) -> WrittenResult {
    written(&look(parsed(params)?))
}

fn written(found: &impl Serialize) -> WrittenResult {
    serde_json::to_string(found)
        .map_err(|err| RequestError(ErrorCode::InternalError, err.to_string()))
}
