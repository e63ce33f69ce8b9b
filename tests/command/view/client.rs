//! A client of the page's server, and items as they arrive.

use std::{
    io::{BufRead, BufReader, Read, Write},
    net::TcpStream,
    process::{Child, Command, Stdio},
    thread,
    time::{Duration, Instant},
};

use serde_json::{Value as Json, json};

use crate::support::{Scratch, virote};

/// How long anything may take on a machine that does other things too.
const PATIENCE: Duration = Duration::from_secs(100);

/// A viewer of a script in a folder of its own.
pub(super) struct View {
    pub(super) scratch: Scratch,
    pub(super) child: Child,
    /// The host that the page has, as the address says.
    pub(super) host: String,
    /// Where it is served.
    pub(super) local: String,
    pub(super) token: String,
}

/// An answer.
pub(super) struct Reply {
    pub(super) status: u16,
    pub(super) head: String,
    pub(super) body: Vec<u8>,
}

impl Reply {
    pub(super) fn json(&self) -> Json {
        serde_json::from_slice(&self.body).expect("JSON")
    }
}

impl View {
    /// Shows `script`, saved as `model.geo`, in a folder whose name tells the test.
    pub(super) fn of(name: &str, script: &str) -> Self {
        let scratch = Scratch::new(&format!("view-{name}"));
        scratch.file("model.geo", script);
        Self::start(scratch, &[])
    }

    pub(super) fn start(scratch: Scratch, args: &[&str]) -> Self {
        Self::of_file(scratch, "model.geo", args)
    }

    /// Shows the script of this name in the folder.
    pub(super) fn of_file(scratch: Scratch, name: &str, args: &[&str]) -> Self {
        let mut child = virote(&scratch.0)
            .args(["view", name, "--no-open"])
            .args(args)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command starts");
        let mut line = String::new();
        let out = child.stdout.take().expect("a pipe");
        BufReader::new(out).read_line(&mut line).expect("the address");
        let (_, address) = line.trim().split_once("://").expect("an address");
        let (host, token) = address.split_once("/?token=").expect("a token");
        let host = host.split('/').next().unwrap_or_default();
        let (host, token) = (host.to_owned(), token.to_owned());
        // Whoever names another address chooses the port.
        let port = args.windows(2).find(|two| two[0] == "--port").map(|two| two[1]);
        let local = port.map_or_else(|| host.clone(), |port| format!("127.0.0.1:{port}"));
        Self { scratch, child, host, local, token }
    }

    /// At once: of a file that is emptied first and then written two runs may come, the second of which finds nothing new.
    pub(super) fn save(&self, script: &str) {
        let whole = self.scratch.file("model.geo.whole", script);
        std::fs::rename(whole, self.scratch.0.join("model.geo"))
            .expect("it takes the other's place");
    }

    pub(super) fn script(&self) -> String {
        std::fs::read_to_string(self.scratch.0.join("model.geo")).expect("the script")
    }

    pub(super) fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(&self.local).expect("a connection");
        stream.set_read_timeout(Some(PATIENCE)).expect("a time");
        stream
    }

    /// Sends text as it is; the answer.
    pub(super) fn send(&self, text: &[u8]) -> Reply {
        let mut stream = self.connect();
        // A server that refuses need not read all of it.
        let _ = stream.write_all(text);
        let mut bytes = Vec::new();
        stream.read_to_end(&mut bytes).expect("an answer");
        let end = bytes.windows(4).position(|four| four == b"\r\n\r\n").expect("a head");
        let head = String::from_utf8_lossy(&bytes[..end]).into_owned();
        let status = head.split(' ').nth(1).and_then(|word| word.parse().ok()).expect("a status");
        Reply { status, head, body: bytes[end + 4..].to_vec() }
    }

    /// Asks with the headers of the page, and with others in their place.
    pub(super) fn ask(
        &self,
        method: &str,
        path: &str,
        other: &[(&str, &str)],
        body: &[u8],
    ) -> Reply {
        let mut headers = vec![
            ("Host", self.host.clone()),
            ("X-Virote-Token", self.token.clone()),
            ("Content-Type", "application/json".to_owned()),
            ("Content-Length", body.len().to_string()),
        ];
        for &(name, value) in other {
            headers.retain(|(known, _)| *known != name);
            headers.push((name, value.to_owned()));
        }
        let mut text = format!("{method} {path} HTTP/1.1\r\n");
        for (name, value) in headers.iter().filter(|(_, value)| value != "-") {
            text.push_str(&format!("{name}: {value}\r\n"));
        }
        text.push_str("\r\n");
        let mut bytes = text.into_bytes();
        bytes.extend_from_slice(body);
        self.send(&bytes)
    }

    pub(super) fn get(&self, path: &str) -> Reply {
        self.ask("GET", path, &[], b"")
    }

    pub(super) fn post(&self, path: &str, body: &Json) -> Reply {
        self.ask("POST", path, &[], body.to_string().as_bytes())
    }

    pub(super) fn state(&self) -> Json {
        self.get("/api/state").json()
    }

    /// Waits for a state that is as it should be.
    #[track_caller]
    pub(super) fn until(&self, what: &str, is_it: impl Fn(&Json) -> bool) -> Json {
        let begin = Instant::now();
        loop {
            let state = self.state();
            if is_it(&state) {
                return state;
            }
            assert!(begin.elapsed() < PATIENCE, "never {what}: {state:#}");
            thread::sleep(Duration::from_millis(20));
        }
    }

    /// The first state of a script without errors.
    #[track_caller]
    pub(super) fn current(&self) -> Json {
        self.until("current", |state| state["isCurrent"] == json!(true))
    }

    /// The state after the one of this version.
    #[track_caller]
    pub(super) fn after(&self, state: &Json) -> Json {
        self.until("newer", |new| new["version"].as_u64() > state["version"].as_u64())
    }

    /// The item of a path.
    #[track_caller]
    pub(super) fn item(&self, state: &Json, path: &str) -> Item {
        let reply = self.get(&format!("/api/item/{}", key(state, path)));
        assert_eq!(reply.status, 200, "{path}");
        Item::of(reply.body)
    }
}

impl Drop for View {
    fn drop(&mut self) {
        let _ = Command::new("kill").args(["-INT", &self.child.id().to_string()]).status();
        let deadline = Instant::now() + Duration::from_secs(10);
        while Instant::now() < deadline && matches!(self.child.try_wait(), Ok(None)) {
            thread::sleep(Duration::from_millis(10));
        }
        // Where it did not hear.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// What the state tells of an item.
#[track_caller]
pub(super) fn told<'j>(state: &'j Json, path: &str) -> &'j Json {
    let items = state["items"].as_array().expect("items");
    let found = items.iter().find(|item| item["path"] == json!(path));
    assert!(found.is_some(), "no {path} in {state:#}");
    found.expect("it is there")
}

/// The key of an item.
#[track_caller]
pub(super) fn key(state: &Json, path: &str) -> String {
    told(state, path)["key"].as_str().expect("a key").to_owned()
}

/// An item as it arrives.
pub(super) struct Item {
    pub(super) header: Json,
    bytes: Vec<u8>,
}

impl Item {
    pub(super) fn of(bytes: Vec<u8>) -> Self {
        let n = u32::from_le_bytes(bytes[..4].try_into().expect("four bytes")) as usize;
        assert_eq!((4 + n) % 8, 0);
        let header = serde_json::from_slice(&bytes[4..4 + n]).expect("a header");
        Self { header, bytes }
    }

    fn words(&self, place: &Json, size: usize) -> Vec<[u8; 4]> {
        let number = |name: &str| place[name].as_u64().expect("a number") as usize;
        let (start, count) = (number("offset"), number("count"));
        assert_eq!(start % 4, 0);
        let bytes = &self.bytes[start..start + 4 * size * count];
        bytes.chunks_exact(4).map(|four| four.try_into().expect("four bytes")).collect()
    }

    /// Numbers, `N` together.
    pub(super) fn numbers<const N: usize>(&self, place: &Json) -> Vec<[f64; N]> {
        let words = self.words(place, N);
        let number = |word: &[u8; 4]| f64::from(f32::from_le_bytes(*word));
        let numbers: Vec<f64> = words.iter().map(number).collect();
        numbers.chunks_exact(N).map(|some| some.try_into().expect("as many")).collect()
    }

    /// Places in the document's unit.
    pub(super) fn places(&self, place: &Json) -> Vec<[f64; 3]> {
        let center = [0, 1, 2].map(|i| self.header["center"][i].as_f64().expect("a number"));
        let moved = |place: [f64; 3]| [0, 1, 2].map(|i| place[i] + center[i]);
        self.numbers(place).into_iter().map(moved).collect()
    }

    pub(super) fn triangles(&self) -> Vec<[u32; 3]> {
        let words = self.words(&self.header["triangles"], 3);
        let corners: Vec<u32> = words.into_iter().map(u32::from_le_bytes).collect();
        corners.chunks_exact(3).map(|three| three.try_into().expect("three")).collect()
    }
}
