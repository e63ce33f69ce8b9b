//! The server: a thread for each connection, of which there are only so many.

use std::{
    io::Write,
    net::{TcpListener, TcpStream},
    sync::{
        Arc,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
    time::Duration,
};

use super::{
    doors::Doors,
    guard::Guard,
    http::{HttpError, Request, Response, begin_stream},
    hub::{Hub, PageUpdate},
    routes,
};

/// Connections at a time.
const MOST_CONNECTIONS: usize = 64;

/// How often a stream without news says that it is there.
const HEARTBEAT: Duration = Duration::from_secs(15);

/// Stack of a thread that answers; whoever needs more takes a thread of its own for it.
const STACK: usize = 1 << 20;

/// Serves until the process ends.
pub(super) fn serve(listener: &TcpListener, guard: &Arc<Guard>, doors: &Arc<Doors>) {
    let n_open = Arc::new(AtomicUsize::new(0));
    for stream in listener.incoming() {
        let Ok(mut stream) = stream else {
            // The process has too many files open; some will be closed.
            thread::sleep(Duration::from_millis(20));
            continue;
        };
        let open = OpenConnection::new(&n_open);
        let (guard, doors) = (Arc::clone(guard), Arc::clone(doors));
        if MOST_CONNECTIONS < open.n_open {
            let _ = Response::trouble(503, "too many connections").send(&mut stream);
            continue;
        }
        let answer = move || {
            let _open = open;
            answer(&mut stream, &guard, &doors);
        };
        let _ = thread::Builder::new().stack_size(STACK).spawn(answer);
    }
}

/// A connection that is counted while it is open.
struct OpenConnection {
    counter: Arc<AtomicUsize>,
    /// How many there are with it.
    n_open: usize,
}

impl OpenConnection {
    fn new(counter: &Arc<AtomicUsize>) -> Self {
        let n_open = 1 + counter.fetch_add(1, Ordering::Relaxed);
        Self { counter: Arc::clone(counter), n_open }
    }
}

impl Drop for OpenConnection {
    fn drop(&mut self) {
        self.counter.fetch_sub(1, Ordering::Relaxed);
    }
}

fn answer(stream: &mut TcpStream, guard: &Guard, doors: &Doors) {
    let _ = stream.set_nodelay(true);
    let request = match Request::read(stream) {
        Ok(Some(request)) => request,
        Ok(None) => return,
        Err(refusal) => return Response::refuse(refusal, stream),
    };
    if let Err(refusal) = guard.check(&request) {
        return Response::refuse(refusal, stream);
    }
    if request.path == "/api/events" {
        if request.method != "GET" {
            return Response::refuse(HttpError(405, "only GET"), stream);
        }
        // It ends when nobody reads it any more.
        let _ = tell_events(stream, doors, request.query("states") == Some("whole"));
        return;
    }
    let _ = routes::answer(&request, doors).send(stream);
}

/// The state of a version as a member of an event, if it is still the newest; what it holds is one line.
fn whole(hub: &Hub, news: PageUpdate) -> String {
    let shown = hub.shown();
    let is_it = shown.version == news.version;
    let state = std::str::from_utf8(&shown.state).ok().filter(|_| is_it && 0 < news.version);
    state.map_or_else(String::new, |state| format!(",\"state\":{state}"))
}

/// Tells what happens, until the other side has gone; of states all that there is to tell if they are wanted whole.
fn tell_events(stream: &mut TcpStream, doors: &Doors, is_whole: bool) -> std::io::Result<()> {
    begin_stream(stream)?;
    let hub = &doors.hub;
    let _listener = hub.listen();
    let mut known: Option<PageUpdate> = None;
    loop {
        let news = hub.news(known, HEARTBEAT);
        if news.is_over {
            return Ok(());
        }
        let mut text = String::new();
        let mut event = |name: &str, version: u64, more: &str| {
            text.push_str(&format!("event: {name}\ndata: {{\"version\":{version}{more}}}\n\n"));
        };
        if known.is_none_or(|known| known.version != news.version) {
            event("state", news.version, &if is_whole { whole(hub, news) } else { String::new() });
        }
        if let Some(version) = news.busy
            && known.is_none_or(|known| known.busy != news.busy)
        {
            event("busy", version, "");
        }
        if text.is_empty() {
            text.push_str(": still here\n\n");
        }
        stream.write_all(text.as_bytes())?;
        stream.flush()?;
        known = Some(news);
    }
}
