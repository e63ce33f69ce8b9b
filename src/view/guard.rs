//! Who may ask: the page that this process serves, and nobody else.
//!
//! Other pages in the same browser can send requests to this machine too. They cannot send our host
//! name (a foreign name that resolves here has its own), nor do they know the token.

use std::hash::{BuildHasher, Hasher, RandomState};

use super::http::{HttpError, Request};

/// What a request must show.
#[derive(Debug)]
pub(super) struct Guard {
    hosts: [String; 2],
    token: String,
}

impl Guard {
    /// For a server at this port, with a token that nobody can guess.
    pub(super) fn new(port: u16) -> Self {
        // The keys of a hasher are 128 bits that the system drew.
        let draw = || RandomState::new().build_hasher().finish();
        let token = format!("{:016x}{:016x}", draw(), draw());
        Self { hosts: [format!("127.0.0.1:{port}"), format!("localhost:{port}")], token }
    }

    /// The address of the page.
    pub(super) fn address(&self) -> String {
        format!("http://{}/?token={}", self.hosts[0], self.token)
    }

    /// Whether a request may be answered.
    pub(super) fn check(&self, request: &Request) -> Result<(), HttpError> {
        let is_host = |host: &str| self.hosts.iter().any(|own| own == host);
        if !request.header("host").is_some_and(is_host) {
            return Err(HttpError(403, "this is another host"));
        }
        let is_own = |origin: &str| origin.strip_prefix("http://").is_some_and(is_host);
        if !request.header("origin").is_none_or(is_own) {
            return Err(HttpError(403, "this is for the page of this server alone"));
        }
        if !request.path.starts_with("/api/") {
            return if request.method == "GET" { Ok(()) } else { Err(HttpError(405, "only GET")) };
        }
        let token = match request.header("x-virote-token") {
            Some(token) => Some(token),
            None if request.path == "/api/events" => request.query("token"),
            None => None,
        };
        if !token.is_some_and(|token| is_same(token, &self.token)) {
            return Err(HttpError(403, "the token is missing or wrong"));
        }
        match request.method.as_str() {
            "GET" => Ok(()),
            "POST" if is_json(request.header("content-type").unwrap_or_default()) => Ok(()),
            "POST" => Err(HttpError(415, "the body must be JSON")),
            _ => Err(HttpError(405, "only GET and POST")),
        }
    }
}

fn is_json(kind: &str) -> bool {
    kind.split(';').next().is_some_and(|kind| kind.trim().eq_ignore_ascii_case("application/json"))
}

/// Whether two texts are the same, in a time that does not tell where they differ.
fn is_same(a: &str, b: &str) -> bool {
    let differ = a.bytes().zip(b.bytes()).fold(0, |differ, (a, b)| differ | (a ^ b));
    a.len() == b.len() && differ == 0
}

#[cfg(test)]
mod tests {
    use super::{Guard, is_json, is_same};

    #[test]
    fn tokens_are_long_and_new() {
        let [a, b] = [Guard::new(1), Guard::new(1)];
        assert!(a.token.len() == 32 && a.token != b.token);
        assert!(is_same(&a.token, &a.token) && !is_same(&a.token, &a.token[1..]));
        assert!(is_json("Application/JSON; charset=utf-8") && !is_json("text/plain"));
    }
}
