//! The page itself: built beforehand and part of the binary.

use std::{env, fs, path::Path, sync::Arc};

use serde_json::{Value as Json, json};

use super::http::Response;
use crate::export::base64;

/// A file of the page as it was built.
struct BuiltFile {
    /// Its address.
    address: &'static str,
    /// Its name in the folder of the build.
    name: &'static str,
    kind: &'static str,
    bytes: &'static [u8],
    is_zipped: bool,
}

const FILES: [BuiltFile; 4] = [
    BuiltFile {
        address: "/",
        name: "index.html",
        kind: "text/html; charset=utf-8",
        bytes: include_bytes!("../../web/dist/index.html"),
        is_zipped: false,
    },
    BuiltFile {
        address: "/app.js",
        name: "app.js",
        kind: "text/javascript; charset=utf-8",
        bytes: include_bytes!("../../web/dist/app.js.gz"),
        is_zipped: true,
    },
    BuiltFile {
        address: "/app.css",
        name: "app.css",
        kind: "text/css; charset=utf-8",
        bytes: include_bytes!("../../web/dist/app.css.gz"),
        is_zipped: true,
    },
    BuiltFile {
        address: "/begin.js",
        name: "begin.js",
        kind: "text/javascript; charset=utf-8",
        bytes: include_bytes!("../../web/dist/begin.js.gz"),
        is_zipped: true,
    },
];

/// The environment variable that names a folder to take the page from while one works at it.
const FOLDER: &str = "VIROTE_WEB";

impl BuiltFile {
    /// Its bytes, and whether they are compressed.
    fn content(&self) -> (Vec<u8>, bool) {
        let in_folder = || {
            let folder = env::var_os(FOLDER)?;
            let path = Path::new(&folder).join(self.name);
            let zipped = path.with_extension(format!("{}.gz", path.extension()?.to_string_lossy()));
            let plain = fs::read(path).ok().map(|bytes| (bytes, false));
            plain.or_else(|| fs::read(zipped).ok().map(|bytes| (bytes, true)))
        };
        in_folder().unwrap_or_else(|| (self.bytes.to_vec(), self.is_zipped))
    }
}

/// The file of the page at an address.
pub(super) fn file(address: &str) -> Option<Response> {
    let file = FILES.iter().find(|file| file.address == address)?;
    let (bytes, is_zipped) = file.content();
    let response = Response::new(file.kind, bytes);
    Some(if is_zipped { response.zipped() } else { response })
}

/// What the page's text holds once each, for a file of its own to have something else there.
const STYLE: &str = r#"<link rel="stylesheet" href="app.css">"#;
const DATA: &str = "<!-- virote-data -->";
const CODE: &str = r#"<script src="app.js" defer></script>"#;
/// What fetches the model while the code is read.
const BEGINNING: &str = r#"<script src="begin.js" async></script>"#;

/// The page with a state and the bytes of its items, as one file that asks nobody.
pub(super) fn single(state: &Json, items: &[(String, Arc<Vec<u8>>)]) -> String {
    let items: serde_json::Map<String, Json> =
        items.iter().map(|(key, bytes)| (key.clone(), json!(base64(bytes)))).collect();
    let data = json!({ "state": state, "items": items }).to_string();
    // Nothing in it ends the element that it stands in.
    let data = data.replace('<', "\\u003c");
    let data = format!(r#"<script type="application/json" id="virote-data">{data}</script>"#);
    let [page, code, style, _] = FILES.each_ref().map(BuiltFile::content);
    let page = String::from_utf8_lossy(&page.0).into_owned();
    let page = page.replacen(STYLE, &element("style", style), 1);
    let page = page.replacen(CODE, &element("script", code), 1);
    page.replacen(BEGINNING, "", 1).replacen(DATA, &data, 1)
}

/// An element with the text of a file; where that is compressed, what takes it apart in the browser.
fn element(name: &str, (bytes, is_zipped): (Vec<u8>, bool)) -> String {
    if !is_zipped {
        return format!("<{name}>{}</{name}>", String::from_utf8_lossy(&bytes));
    }
    format!(
        "<script>(async () => {{ \
         const bytes = Uint8Array.from(atob(\"{}\"), (c) => c.charCodeAt(0)); \
         const text = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(\"gzip\")); \
         const element = document.createElement(\"{name}\"); \
         element.textContent = await new Response(text).text(); \
         document.head.append(element); }})();</script>",
        base64(&bytes)
    )
}
