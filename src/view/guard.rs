//! Who may ask: the page that this process serves, and nobody else.
//!
//! Other pages in the same browser can send requests to this machine too. They cannot send our host
//! name (a foreign name that resolves here has its own), nor do they know the token.

use std::{
    hash::{BuildHasher, Hasher, RandomState},
    str::FromStr,
};

use super::http::{HttpError, Request};

/// Where else than at this machine's own address the browser finds the server: what a proxy or a forwarded port is reached
/// by.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct OutsideAddress {
    /// Scheme and host, as a browser names the origin of a request.
    origin: String,
    /// What stands before the paths of the page, without a slash at its end.
    prefix: String,
}

impl FromStr for OutsideAddress {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let bad =
            || format!("`{text}` is no address of a page such as `https://host:8443/proxy/8123/`");
        let is_plain = text.chars().all(|c| c.is_ascii_graphic() && !"\"'<>\\?#@`".contains(c));
        let scheme = ["http://", "https://"].into_iter().find(|scheme| text.starts_with(scheme));
        let scheme = scheme.filter(|_| is_plain).ok_or_else(bad)?;
        let (host, path) =
            text[scheme.len()..].split_once('/').unwrap_or((&text[scheme.len()..], ""));
        let (name, port) = match host.rsplit_once(':') {
            Some((name, port)) if !port.ends_with(']') => (name, Some(port)),
            _ => (host, None),
        };
        let is_name = |c: char| c.is_ascii_alphanumeric() || "-._[:]".contains(c);
        if name.is_empty()
            || !name.chars().all(is_name)
            || port.is_some_and(|port| port.parse::<u16>().is_err())
        {
            return Err(bad());
        }
        let host = as_browsers_say(scheme, host);
        let path = path.trim_end_matches('/');
        let prefix = if path.is_empty() { String::new() } else { format!("/{path}") };
        Ok(Self { origin: format!("{scheme}{host}"), prefix })
    }
}

/// A host as browsers name it: in small letters, without the port that goes with the scheme.
fn as_browsers_say(scheme: &str, host: &str) -> String {
    let usual = if scheme.starts_with("https") { ":443" } else { ":80" };
    host.strip_suffix(usual).unwrap_or(host).to_ascii_lowercase()
}

/// What a request must show.
#[derive(Debug)]
pub(super) struct Guard {
    /// Origins of the page, of which each ends with a host that the page has.
    origins: Vec<String>,
    /// The address of the page, up to its token.
    base: String,
    token: String,
}

impl Guard {
    /// For a server at this port, with a token that nobody can guess.
    pub(super) fn new(port: u16, outside: Option<&OutsideAddress>) -> Self {
        // The keys of a hasher are 128 bits that the system drew.
        let draw = || RandomState::new().build_hasher().finish();
        let token = format!("{:016x}{:016x}", draw(), draw());
        let own = |host: &str| as_browsers_say("http", &format!("{host}:{port}"));
        let mut origins: Vec<String> =
            ["127.0.0.1", "localhost"].map(|host| format!("http://{}", own(host))).into();
        let base = match outside {
            Some(OutsideAddress { origin, prefix }) => {
                origins.push(origin.clone());
                format!("{origin}{prefix}")
            }
            None => origins[0].clone(),
        };
        Self { origins, base, token }
    }

    /// The address of the page.
    pub(super) fn address(&self) -> String {
        format!("{}/?token={}", self.base, self.token)
    }

    /// Whether a request may be answered.
    pub(super) fn check(&self, request: &Request) -> Result<(), HttpError> {
        let is_host = |host: &str| {
            let mut hosts = self.origins.iter().filter_map(|origin| origin.split_once("://"));
            hosts.any(|(scheme, own)| own == as_browsers_say(scheme, host))
        };
        if !request.header("host").is_some_and(is_host) {
            return Err(HttpError(403, "this is another host"));
        }
        let is_own = |origin: &str| self.origins.iter().any(|own| own == origin);
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
    use super::{Guard, OutsideAddress, is_json, is_same};

    #[test]
    fn tokens_are_long_and_new() {
        let [a, b] = [Guard::new(1, None), Guard::new(1, None)];
        assert!(a.token.len() == 32 && a.token != b.token);
        assert!(is_same(&a.token, &a.token) && !is_same(&a.token, &a.token[1..]));
        assert!(is_json("Application/JSON; charset=utf-8") && !is_json("text/plain"));
    }

    #[test]
    fn an_outside_address_has_a_scheme_and_a_host() {
        let address = |text: &str| {
            let outside: OutsideAddress = text.parse().ok()?;
            let guard = Guard::new(1, Some(&outside));
            guard.address().split_once("/?token=").map(|(base, _)| base.to_owned())
        };
        for (text, base) in [
            ("http://127.0.0.1:9", "http://127.0.0.1:9"),
            (
                "https://Hub.example.org:443/user/me/proxy/8123/",
                "https://hub.example.org/user/me/proxy/8123",
            ),
            ("https://h/", "https://h"),
            ("http://[::1]:81/", "http://[::1]:81"),
        ] {
            assert_eq!(address(text).as_deref(), Some(base));
        }
        for text in [
            "",
            "h",
            "ftp://h",
            "http://",
            "http:///x",
            "http://me@h",
            "http://h/?x",
            "http://h/\"",
            "http://h /",
            "https://:443",
            "http://h:abc",
            "http://h:99999",
            "https://*",
            "http://https://h",
        ] {
            assert_eq!(address(text), None, "{text}");
        }
    }
}
