//! An answer, with the headers that keep the page to itself.

use std::{
    io::{self, Read, Write},
    net::{Shutdown, TcpStream},
    sync::Arc,
    time::{Duration, Instant},
};

use serde_json::Value as Json;

use super::HttpError;

/// How long a client may take to read a part of the answer.
const PATIENCE: Duration = Duration::from_secs(10);

/// How long the rest of a request that was refused is read, so that the answer arrives.
const AFTERWARDS: Duration = Duration::from_secs(1);

/// What the page may load, and from where.
const POLICY: &str = "default-src 'self'; img-src 'self' data: blob:; style-src 'self' 'unsafe-inline'; \
     worker-src 'self' blob:; connect-src 'self'; frame-ancestors 'self' vscode-webview: vscode-file:; base-uri 'none'; form-action 'none'";

/// The body of an answer.
#[derive(Debug)]
enum ResponseBody {
    Owned(Vec<u8>),
    Shared(Arc<Vec<u8>>),
    /// One after the other, each filled up to a multiple of [`ALIGNMENT`].
    Parts(Vec<Arc<Vec<u8>>>),
}

/// Parts of a body begin at a multiple of this.
const ALIGNMENT: usize = 8;

impl ResponseBody {
    fn parts(&self) -> Vec<&[u8]> {
        match self {
            Self::Owned(bytes) => vec![bytes],
            Self::Shared(bytes) => vec![bytes],
            Self::Parts(parts) => {
                let filled =
                    |part: &'_ Arc<Vec<u8>>| part.len().next_multiple_of(ALIGNMENT) - part.len();
                parts.iter().flat_map(|part| [&part[..], &[0; ALIGNMENT][..filled(part)]]).collect()
            }
        }
    }
}

/// An answer.
#[derive(Debug)]
pub(in crate::view) struct Response {
    status: u16,
    kind: &'static str,
    /// Whether the same address always has the same bytes.
    is_lasting: bool,
    is_zipped: bool,
    body: ResponseBody,
}

impl Response {
    /// Bytes of a kind.
    pub(in crate::view) fn new(kind: &'static str, bytes: Vec<u8>) -> Self {
        Self {
            status: 200,
            kind,
            is_lasting: false,
            is_zipped: false,
            body: ResponseBody::Owned(bytes),
        }
    }

    /// The same, compressed by gzip.
    pub(in crate::view) fn zipped(self) -> Self {
        Self { is_zipped: true, ..self }
    }

    /// Bytes that this address will always have.
    pub(in crate::view) fn lasting(bytes: Arc<Vec<u8>>) -> Self {
        let body = ResponseBody::Shared(bytes);
        Self { is_lasting: true, body, ..Self::new("application/octet-stream", Vec::new()) }
    }

    /// Parts one after the other, each filled up to a multiple of 8 bytes.
    pub(in crate::view) fn parts(parts: Vec<Arc<Vec<u8>>>) -> Self {
        let body = ResponseBody::Parts(parts);
        Self { body, ..Self::new("application/octet-stream", Vec::new()) }
    }

    /// Numbers in single precision, little-endian.
    pub(in crate::view) fn numbers(numbers: Vec<f64>) -> Self {
        let bytes = numbers.into_iter().flat_map(|number| (number as f32).to_le_bytes());
        Self::new("application/octet-stream", bytes.collect())
    }

    /// A value.
    pub(in crate::view) fn json(value: &Json) -> Self {
        Self::new("application/json", value.to_string().into_bytes())
    }

    /// Why there is no answer, for the page.
    pub(in crate::view) fn trouble(status: u16, why: &str) -> Self {
        Self { status, ..Self::json(&serde_json::json!({ "error": why })) }
    }

    /// Sends it, and closes.
    pub(in crate::view) fn send(&self, stream: &mut TcpStream) -> io::Result<()> {
        let parts = self.body.parts();
        let length: usize = parts.iter().map(|part| part.len()).sum();
        let mut head = head(self.status, self.kind);
        head.push_str(&format!("Content-Length: {}\r\nConnection: close\r\n", length));
        head.push_str(match self.is_lasting {
            true => "Cache-Control: private, max-age=31536000, immutable\r\n",
            false => "Cache-Control: no-store\r\n",
        });
        if self.is_zipped {
            head.push_str("Content-Encoding: gzip\r\n");
        }
        head.push_str("\r\n");
        stream.set_write_timeout(Some(PATIENCE))?;
        stream.write_all(head.as_bytes())?;
        for part in parts {
            stream.write_all(part)?;
        }
        stream.flush()
    }

    /// Sends a refusal of a request that may not have been read to its end.
    pub(in crate::view) fn refuse(HttpError(status, why): HttpError, stream: &mut TcpStream) {
        if Self::trouble(status, why).send(stream).is_ok() {
            let _ = stream.shutdown(Shutdown::Write);
            read_rest(stream);
        }
    }
}

/// Reads what still comes, for a while: a connection that is closed before loses the answer.
fn read_rest(stream: &mut TcpStream) {
    let deadline = Instant::now() + AFTERWARDS;
    let mut part = [0; 8 << 10];
    let _ = stream.set_read_timeout(Some(AFTERWARDS));
    while Instant::now() < deadline && stream.read(&mut part).is_ok_and(|n| 0 < n) {}
}

/// Begins a stream of events.
pub(in crate::view) fn begin_stream(stream: &mut TcpStream) -> io::Result<()> {
    let mut head = head(200, "text/event-stream");
    head.push_str("Cache-Control: no-store\r\nConnection: close\r\n\r\n");
    stream.set_write_timeout(Some(PATIENCE))?;
    stream.write_all(head.as_bytes())?;
    stream.flush()
}

fn head(status: u16, kind: &str) -> String {
    let reason = match status {
        200 => "OK",
        403 => "Forbidden",
        404 => "Not Found",
        405 => "Method Not Allowed",
        408 => "Request Timeout",
        411 => "Length Required",
        413 => "Content Too Large",
        415 => "Unsupported Media Type",
        431 => "Request Header Fields Too Large",
        503 => "Service Unavailable",
        _ => "Bad Request",
    };
    format!(
        "HTTP/1.1 {status} {reason}\r\nContent-Type: {kind}\r\nContent-Security-Policy: {POLICY}\r\n\
         X-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\n\
         Cross-Origin-Resource-Policy: same-origin\r\n"
    )
}
