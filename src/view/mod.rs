//! `virote view`: a server on this machine that shows a script in the browser while it is written.
//!
//! `hub` is where all meet: the page asks through `server` (`http`, `guard`, `routes`), `watch` looks
//! at the files, and `worker`, the one thread that evaluates, takes the newest run that is wanted. What
//! it comes to and what the page asks about it is the business of `crate::page`.

mod doors;
mod export;
mod guard;
mod http;
mod hub;
mod page;
mod routes;
mod server;
mod watch;
mod worker;
mod write;

use std::{
    hash::{BuildHasher, Hasher, RandomState},
    io,
    net::{Ipv4Addr, TcpListener},
    path::PathBuf,
    sync::{Arc, Mutex},
    thread,
};

pub(crate) use self::guard::OutsideAddress;
use self::{doors::Doors, guard::Guard, hub::Hub, worker::PageWorker};
use crate::{
    eval::Setting,
    limits::{stack, work::StopToken},
    page::{Model, SceneItem, Shown},
    session::{Report, Session},
};

/// What is to be shown.
pub(crate) struct ViewedScript<'a> {
    pub(crate) path: PathBuf,
    /// The folder for exported files.
    pub(crate) out: PathBuf,
    pub(crate) settings: Vec<Setting>,
    /// Makes a session that a switch stops.
    pub(crate) session: &'a dyn Fn(StopToken) -> Session,
}

/// A script that is shown.
pub(crate) struct Viewer {
    address: String,
    hub: Arc<Hub>,
}

impl ViewedScript<'_> {
    fn worker(&self) -> PageWorker {
        let stop = StopToken::default();
        let first = Model::empty(&self.path, &self.out);
        let hub = Arc::new(Hub::new(self.settings.clone(), first, stop.clone()));
        PageWorker {
            hub,
            model: Model::new((self.session)(stop), RandomState::new().build_hasher().finish()),
            script: self.path.clone(),
            out: self.out.clone(),
            followed: Arc::default(),
        }
    }
}

/// The page of a script with these settings, which shows its model anywhere; none where it has errors or
/// nothing to show. `session` makes a session that a switch stops.
#[must_use]
pub fn single_page(
    path: PathBuf,
    settings: Vec<Setting>,
    session: &dyn Fn(StopToken) -> Session,
) -> Option<String> {
    let out = path.parent().map(std::path::Path::to_path_buf).unwrap_or_default();
    SinglePage::of(&ViewedScript { path, out, settings, session }).text
}

/// A page with a model in it, which asks nobody.
pub(crate) struct SinglePage {
    /// None where the script has errors, or cannot be drawn.
    pub(crate) text: Option<String>,
    /// What became of the script, if it was there.
    pub(crate) report: Option<Arc<Report>>,
    /// The files that it read.
    pub(crate) inputs: Vec<PathBuf>,
}

impl SinglePage {
    /// The page of a script as it is now.
    pub(crate) fn of(script: &ViewedScript<'_>) -> Self {
        let mut worker = script.worker();
        let shown = worker.hub.next_job().and_then(|job| worker.run(&job));
        let page = |shown: &Shown| {
            let state = serde_json::from_slice(&shown.state).unwrap_or_default();
            let items = shown.scene.items.iter();
            let bytes = |item: &SceneItem| {
                let made = item.source.item(&worker.model.session);
                (item.key.to_string(), Arc::clone(&made.bytes))
            };
            page::single(&state, &items.map(bytes).collect::<Vec<_>>())
        };
        let text = shown.as_ref().filter(|shown| shown.is_current).map(page);
        let inputs = shown.map(|shown| shown.inputs).unwrap_or_default();
        Self { text, report: worker.model.last, inputs }
    }
}

impl Viewer {
    /// Serves a script at a port of this machine; at 0 the system chooses. The browser finds it at the address outside, or at
    /// the port itself.
    ///
    /// # Errors
    /// Where the port is not to be had.
    pub(crate) fn start(
        script: &ViewedScript<'_>,
        port: u16,
        outside: Option<&OutsideAddress>,
    ) -> io::Result<Self> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        let guard = Arc::new(Guard::new(listener.local_addr()?.port(), outside));
        let worker = script.worker();
        let hub = Arc::clone(&worker.hub);
        let followed = Arc::clone(&worker.followed);
        // A file that is saved after this look is seen as another one.
        let watched = watch::begin(&script.path);
        let bytes = worker.model.session.limits().stack_bytes;
        let evaluate = move || stack::known(bytes, || worker.work());
        thread::Builder::new().stack_size(bytes).spawn(evaluate)?;
        let doors = Arc::new(Doors {
            hub: Arc::clone(&hub),
            session: (script.session)(StopToken::default()),
            script: script.path.clone(),
            out: script.out.clone(),
            writing: Mutex::default(),
        });
        let told = Arc::clone(&hub);
        thread::Builder::new().spawn(move || watch::watch(&told, watched, &followed))?;
        let address = guard.address();
        thread::Builder::new().spawn(move || server::serve(&listener, &guard, &doors))?;
        Ok(Self { address, hub })
    }

    /// The address of the page.
    pub(crate) fn address(&self) -> &str {
        &self.address
    }
}

impl Drop for Viewer {
    fn drop(&mut self) {
        self.hub.close();
    }
}
