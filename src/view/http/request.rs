//! A request, read with a ceiling on its size and on the time that it may take.

use std::{
    io::{self, Read},
    net::TcpStream,
    time::{Duration, Instant},
};

/// Bytes of the lines before the body.
const MOST_HEAD: usize = 16 << 10;

/// Bytes of a body.
const MOST_BODY: usize = 1 << 20;

/// How long a request may take to arrive.
const PATIENCE: Duration = Duration::from_secs(10);

/// Why a request is not answered: the status, and a few words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::view) struct HttpError(pub(in crate::view) u16, pub(in crate::view) &'static str);

/// A request.
#[derive(Debug)]
pub(in crate::view) struct Request {
    pub(in crate::view) method: String,
    /// Without what stands behind the question mark.
    pub(in crate::view) path: String,
    query: String,
    headers: Vec<(String, String)>,
    pub(in crate::view) body: Vec<u8>,
}

impl Request {
    /// Reads a request; `None` where the other side only looked whether anybody is there.
    pub(in crate::view) fn read(stream: &mut TcpStream) -> Result<Option<Self>, HttpError> {
        let deadline = Instant::now() + PATIENCE;
        let mut bytes = Vec::new();
        let head = loop {
            if let Some(end) = end_of_head(&bytes) {
                break end;
            }
            if MOST_HEAD < bytes.len() {
                return Err(HttpError(431, "the lines before the body are too long"));
            }
            if read_some(stream, &mut bytes, deadline)? == 0 {
                let is_empty = bytes.is_empty();
                return if is_empty {
                    Ok(None)
                } else {
                    Err(HttpError(400, "the request is cut off"))
                };
            }
        };
        let text = std::str::from_utf8(&bytes[..head]).map_err(|_| HttpError(400, "not UTF-8"))?;
        let mut request = Self::of_head(text)?;
        let length = request.body_length()?;
        request.body = bytes.split_off(head);
        while request.body.len() < length {
            if read_some(stream, &mut request.body, deadline)? == 0 {
                return Err(HttpError(400, "the body is cut off"));
            }
        }
        request.body.truncate(length);
        Ok(Some(request))
    }

    fn of_head(text: &str) -> Result<Self, HttpError> {
        let bad = |what| move || HttpError(400, what);
        let mut lines = text.split("\r\n");
        let mut words = lines.next().unwrap_or_default().split(' ');
        let mut word = || words.next().filter(|word| !word.is_empty());
        let method = word().ok_or_else(bad("no method"))?.to_owned();
        let target = word().ok_or_else(bad("no path"))?.to_owned();
        let version = word().ok_or_else(bad("no version"))?;
        if !version.starts_with("HTTP/1.") || words.next().is_some() {
            return Err(HttpError(400, "not HTTP/1.1"));
        }
        let (path, query) = target.split_once('?').unwrap_or((&target, ""));
        let (path, query) = (path.to_owned(), query.to_owned());
        let mut headers = Vec::new();
        for line in lines.filter(|line| !line.is_empty()) {
            let (name, value) = line.split_once(':').ok_or_else(bad("a header without a colon"))?;
            if name.is_empty() || name.contains(char::is_whitespace) {
                return Err(HttpError(400, "a header with a strange name"));
            }
            headers.push((name.to_ascii_lowercase(), value.trim().to_owned()));
        }
        Ok(Self { method, path, query, headers, body: Vec::new() })
    }

    /// How many bytes the body has.
    fn body_length(&self) -> Result<usize, HttpError> {
        if self.header("transfer-encoding").is_some() {
            return Err(HttpError(411, "a body needs its length"));
        }
        let Some(length) = self.header("content-length") else { return Ok(0) };
        let is_number = !length.is_empty() && length.bytes().all(|byte| byte.is_ascii_digit());
        if !is_number {
            return Err(HttpError(400, "the length is no number"));
        }
        // What is too large for a number is too large for a body as well.
        let length = length.parse().unwrap_or(usize::MAX);
        if length <= MOST_BODY { Ok(length) } else { Err(HttpError(413, "the body is too large")) }
    }

    /// The value of a header, by its name in small letters; none where it is given twice.
    pub(in crate::view) fn header(&self, name: &str) -> Option<&str> {
        let mut found = self.headers.iter().filter(|(known, _)| known == name);
        let value = found.next().map(|(_, value)| value.as_str());
        if found.next().is_some() { Some("") } else { value }
    }

    /// A value behind the question mark.
    pub(in crate::view) fn query(&self, name: &str) -> Option<&str> {
        let mut pairs = self.query.split('&').filter_map(|pair| pair.split_once('='));
        pairs.find(|(known, _)| *known == name).map(|(_, value)| value)
    }
}

/// Where the body begins, if all lines before it are there.
fn end_of_head(bytes: &[u8]) -> Option<usize> {
    bytes.windows(4).position(|four| four == b"\r\n\r\n").map(|at| at + 4)
}

/// Reads what there is, in the time that is left.
fn read_some(
    stream: &mut TcpStream,
    bytes: &mut Vec<u8>,
    deadline: Instant,
) -> Result<usize, HttpError> {
    const LATE: HttpError = HttpError(408, "the request takes too long");
    let mut part = [0; 8 << 10];
    let left = deadline.saturating_duration_since(Instant::now());
    if left.is_zero() || stream.set_read_timeout(Some(left)).is_err() {
        return Err(LATE);
    }
    loop {
        match stream.read(&mut part) {
            Ok(n) => {
                bytes.extend_from_slice(&part[..n]);
                return Ok(n);
            }
            Err(err) if err.kind() == io::ErrorKind::Interrupted => {}
            Err(_) => return Err(LATE),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{HttpError, Request};

    #[test]
    fn a_head_is_read_by_its_lines() {
        let text = "GET /api/events?token=a1&x=2 HTTP/1.1\r\nHost: localhost:1\r\nX-Twice: a\r\nx-twice: b\r\n\r\n";
        let request = Request::of_head(text).unwrap();
        assert_eq!((request.method.as_str(), request.path.as_str()), ("GET", "/api/events"));
        assert_eq!(
            [request.query("token"), request.query("x"), request.query("y")],
            [Some("a1"), Some("2"), None]
        );
        assert_eq!(request.header("host"), Some("localhost:1"));
        assert_eq!(request.header("x-twice"), Some(""), "of two nobody knows which one counts");
    }

    #[test]
    fn what_is_no_request_is_refused() {
        for text in
            ["", "GET", "GET /", "GET / HTTP/2", "GET / HTTP/1.1 x", "GET / HTTP/1.1\r\nno colon"]
        {
            assert!(matches!(Request::of_head(text), Err(HttpError(400, _))), "{text}");
        }
        let long = format!("POST / HTTP/1.1\r\nContent-Length: {}\r\n\r\n", u128::MAX);
        let request = Request::of_head(&long).unwrap();
        assert_eq!(request.body_length().map_err(|refusal| refusal.0), Err(413));
    }
}
