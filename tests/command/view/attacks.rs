//! Requests that are not the page's: refused, and without harm to it.

use std::{io::Write, net::TcpListener, time::Duration};

use serde_json::json;

use super::client::View;
use crate::support::{Scratch, told as said, virote};

const SCRIPT: &str = "param r = 1\ncurve c = circle((0, 0), r)\n";

#[test]
fn other_pages_and_other_names_are_refused() {
    let view = View::of("attack", SCRIPT);
    view.current();
    let port = view.host.split(':').nth(1).expect("a port").to_owned();
    let status = |path: &str, other: &[(&str, &str)]| view.ask("GET", path, other, b"").status;
    let local = format!("localhost:{port}");
    for (header, value, expected) in [
        ("Host", local.as_str(), 200),
        ("Host", "evil.example", 403),
        ("Host", "127.0.0.1", 403),
        ("Host", "-", 403),
        ("Origin", &format!("http://{local}"), 200),
        ("Origin", "http://evil.example", 403),
        ("Origin", "null", 403),
        ("Origin", &format!("https://{local}"), 403),
        ("X-Virote-Token", "-", 403),
        ("X-Virote-Token", "0", 403),
        ("X-Virote-Token", &view.token[1..], 403),
    ] {
        assert_eq!(status("/api/state", &[(header, value)]), expected, "{header}: {value}");
    }
    assert_eq!(status("/", &[("Host", "evil.example")]), 403, "nor is the page itself shown");
    // Only the stream takes its token from the address.
    let in_address = format!("/api/state?token={}", view.token);
    assert_eq!(status(&in_address, &[("X-Virote-Token", "-")]), 403);
    assert_eq!(status("/api/events", &[("X-Virote-Token", "-")]), 403);
}

#[test]
fn an_address_outside_is_one_more_that_the_page_has() {
    let scratch = Scratch::new("view-outside");
    scratch.file("model.geo", SCRIPT);
    let listener = TcpListener::bind(("127.0.0.1", 0)).expect("a port");
    let port = listener.local_addr().expect("an address").port().to_string();
    drop(listener);
    let outside = ["--port", &port, "--origin", "https://hub.example/me/proxy/81/"];
    let view = View::start(scratch, &outside);
    assert_eq!(view.host, "hub.example");
    view.current();
    let status = |headers: &[(&str, &str)]| view.ask("GET", "/api/state", headers, b"").status;
    for (host, origin, expected) in [
        ("hub.example", "https://hub.example", 200),
        ("hub.example", "http://hub.example", 403),
        ("hub.example.net", "https://hub.example", 403),
        ("example", "https://hub.example", 403),
        (&view.local, &format!("http://{}", view.local), 200),
    ] {
        assert_eq!(status(&[("Host", host), ("Origin", origin)]), expected, "{host} {origin}");
    }
    for text in ["hub.example", "ftp://hub.example", "https://"] {
        let output = virote(&view.scratch.0)
            .args(["view", "model.geo", "--no-open", "--origin", text])
            .output()
            .expect("it runs");
        let (_, err, code) = said(&output);
        assert!(code == 3 && err.contains("is no address of a page"), "{text}: {code} {err}");
    }
}

#[test]
fn nothing_but_the_page_and_its_calls_has_an_address() {
    let view = View::of("paths", SCRIPT);
    view.current();
    for path in [
        "/../model.geo",
        "/%2e%2e/model.geo",
        "/model.geo",
        "//etc/passwd",
        "/api/item/../../model.geo",
        "/api/item/",
        "/api/nothing",
        "/api/set",
        "/app.js/",
    ] {
        assert_eq!(view.get(path).status, 404, "{path}");
    }
    assert_eq!(view.post("/api/nothing", &json!({})).status, 404);
    assert_eq!(view.ask("DELETE", "/api/state", &[], b"").status, 405);
    assert_eq!(view.ask("POST", "/", &[], b"{}").status, 405);
}

#[test]
fn bodies_are_json_and_not_large() {
    let view = View::of("bodies", SCRIPT);
    view.current();
    let post =
        |other: &[(&str, &str)], body: &[u8]| view.ask("POST", "/api/set", other, body).status;
    assert_eq!(post(&[("Content-Type", "text/plain")], b"{}"), 415);
    assert_eq!(post(&[("Content-Type", "-")], b"{}"), 415);
    assert_eq!(post(&[], b"{"), 400);
    assert_eq!(post(&[], &[0xff; 8]), 400);
    assert_eq!(post(&[], &b"[".repeat(100_000)), 400);
    assert_eq!(post(&[], &vec![b' '; (1 << 20) + 1]), 413);
    assert_eq!(post(&[("Content-Length", "99999999999999999999999")], b"{}"), 413);
    assert_eq!(post(&[("Content-Length", "-1")], b"{}"), 400);
    assert_eq!(post(&[("Transfer-Encoding", "chunked")], b"0\r\n\r\n"), 411);
    for text in
        ["\r\n\r\n", "GET\r\n\r\n", "GET / HTTP/9\r\n\r\n", "GET / HTTP/1.1\r\nno colon\r\n\r\n"]
    {
        assert_eq!(view.send(text.as_bytes()).status, 400, "{text:?}");
    }
    let long = format!("GET /{} HTTP/1.1\r\n\r\n", "a".repeat(1 << 16));
    assert_eq!(view.send(long.as_bytes()).status, 431);
    assert_eq!(view.get("/api/state").status, 200, "the server goes on");
}

#[test]
fn who_says_nothing_is_not_waited_for_and_too_many_are_sent_away() {
    let view = View::of("slow", SCRIPT);
    view.current();
    let mut slow: Vec<_> = (0..80).map(|_| view.connect()).collect();
    for stream in &mut slow {
        // Where it was sent away already, that is as good.
        let _ = stream.write_all(b"GET /api/st");
    }
    // Those that wait hold all places; then their time is over.
    let begin = std::time::Instant::now();
    let mut status = 0;
    while status != 200 && begin.elapsed() < Duration::from_secs(40) {
        std::thread::sleep(Duration::from_millis(200));
        status = answered(&view);
    }
    assert_eq!(status, 200, "they were given up");
    drop(slow);
}

/// The status of a question that may be sent away before it was asked.
fn answered(view: &View) -> u16 {
    use std::io::Read;
    let mut stream = view.connect();
    let text = format!(
        "GET /api/state HTTP/1.1\r\nHost: {}\r\nX-Virote-Token: {}\r\n\r\n",
        view.host, view.token
    );
    let mut reply = String::new();
    let _ = stream.write_all(text.as_bytes());
    let _ = stream.read_to_string(&mut reply);
    reply.split(' ').nth(1).and_then(|word| word.parse().ok()).unwrap_or(0)
}
