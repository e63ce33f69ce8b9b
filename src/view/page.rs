//! The page itself: built beforehand and part of the binary.

use std::{env, fs, path::Path};

use super::http::Response;

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

const FILES: [BuiltFile; 3] = [
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
