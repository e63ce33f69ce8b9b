//! Where requests and the evaluating thread meet: what is wanted, what is running, what is shown.

use std::{
    sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError},
    time::{Duration, Instant},
};

use crate::{
    eval::Setting,
    limits::work::StopToken,
    page::{Known, Shown},
};

/// How long a run may go on when a newer setting waits: what is dragged is to be seen on the way.
const PATIENCE: Duration = Duration::from_secs(1);

/// A run that is wanted.
#[derive(Clone, Debug)]
pub(super) struct RunRequest {
    /// Its place among all that were wanted.
    pub(super) serial: u64,
    /// The version that its state will have.
    pub(super) version: u64,
    pub(super) settings: Vec<Setting>,
    /// Whether files may have changed since the last run.
    pub(super) is_file_new: bool,
}

#[derive(Debug)]
struct HubState {
    settings: Vec<Setting>,
    wanted: u64,
    taken: u64,
    is_file_new: bool,
    is_over: bool,
    was_stopped: bool,
    running: Option<(RunRequest, Instant)>,
    shown: Arc<Shown>,
    before: Arc<Shown>,
    n_listeners: usize,
}

/// The meeting point.
#[derive(Debug)]
pub(super) struct Hub {
    state: Mutex<HubState>,
    changed: Condvar,
    /// Ends the run under way.
    stop: StopToken,
}

/// What a listener is told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct PageUpdate {
    /// The version that is being made.
    pub(super) busy: Option<u64>,
    /// The version that is shown.
    pub(super) version: u64,
    pub(super) is_over: bool,
}

impl Hub {
    pub(super) fn new(settings: Vec<Setting>, first: Shown, stop: StopToken) -> Self {
        let first = Arc::new(first);
        let state = HubState {
            settings,
            wanted: 1,
            taken: 0,
            is_file_new: true,
            is_over: false,
            was_stopped: false,
            running: None,
            shown: Arc::clone(&first),
            before: first,
            n_listeners: 0,
        };
        Self { state: Mutex::new(state), changed: Condvar::new(), stop }
    }

    fn lock(&self) -> MutexGuard<'_, HubState> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn wait<'g>(
        &self,
        guard: MutexGuard<'g, HubState>,
        time: Duration,
    ) -> MutexGuard<'g, HubState> {
        self.changed.wait_timeout(guard, time).unwrap_or_else(PoisonError::into_inner).0
    }

    /// Waits until a run is wanted, and takes it; `None` when all is over.
    pub(super) fn next_job(&self) -> Option<RunRequest> {
        let mut state = self.lock();
        while !state.is_over && state.wanted == state.taken {
            state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
        if state.is_over {
            return None;
        }
        state.taken = state.wanted;
        state.was_stopped = false;
        let job = RunRequest {
            serial: state.wanted,
            version: state.shown.version + 1,
            settings: state.settings.clone(),
            is_file_new: std::mem::take(&mut state.is_file_new),
        };
        state.running = Some((job.clone(), Instant::now()));
        self.stop.reset();
        self.changed.notify_all();
        Some(job)
    }

    /// Whether a run was ended for another one, so that nobody wants to see its end.
    pub(super) fn is_stale(&self, job: &RunRequest) -> bool {
        let state = self.lock();
        self.stop.is_stopped() && !state.was_stopped && state.wanted != job.serial
    }

    /// Shows a state, or nothing where the run was in vain.
    pub(super) fn finish(&self, job: &RunRequest, shown: Option<Shown>) {
        let mut state = self.lock();
        state.running = None;
        match shown {
            Some(shown) => {
                state.settings.retain(|setting| !shown.lost.contains(&setting.name));
                let shown = Arc::new(shown);
                state.before = std::mem::replace(&mut state.shown, shown);
            }
            // Files that a run in vain has not shown are new for the next one too.
            None => state.is_file_new |= job.is_file_new,
        }
        self.changed.notify_all();
    }

    /// The state that is shown.
    pub(super) fn shown(&self) -> Arc<Shown> {
        Arc::clone(&self.lock().shown)
    }

    /// The items of this state and of the one before.
    pub(super) fn known(&self) -> Known {
        let state = self.lock();
        Known { shown: Arc::clone(&state.shown), before: Arc::clone(&state.before) }
    }

    /// The values of parameters that are set.
    pub(super) fn settings(&self) -> Vec<Setting> {
        self.lock().settings.clone()
    }

    /// Changes the settings; a run with them is wanted.
    pub(super) fn set(&self, change: impl FnOnce(&mut Vec<Setting>)) {
        let mut state = self.lock();
        change(&mut state.settings);
        state.wanted += 1;
        self.changed.notify_all();
    }

    /// A file is another one: a run is wanted, and none under way.
    pub(super) fn files_changed(&self) {
        let mut state = self.lock();
        state.wanted += 1;
        state.is_file_new = true;
        if state.running.is_some() {
            self.stop.stop();
        }
        self.changed.notify_all();
    }

    /// Ends the run under way for good.
    pub(super) fn stop(&self) {
        let mut state = self.lock();
        if state.running.is_some() {
            state.was_stopped = true;
            self.stop.stop();
        }
    }

    /// Ends a run that takes long although a newer one waits.
    pub(super) fn hurry(&self) {
        let state = self.lock();
        if let Some((job, since)) = &state.running
            && job.serial != state.wanted
            && PATIENCE < since.elapsed()
        {
            self.stop.stop();
        }
    }

    /// Nobody wants anything any more.
    pub(super) fn close(&self) {
        self.lock().is_over = true;
        self.stop.stop();
        self.changed.notify_all();
    }

    /// Counts a listener until the answer is dropped.
    pub(super) fn listen(&self) -> Listener<'_> {
        self.lock().n_listeners += 1;
        Listener { hub: self }
    }

    pub(super) fn is_over(&self) -> bool {
        self.lock().is_over
    }

    /// Whether anybody looks.
    pub(super) fn has_listeners(&self) -> bool {
        0 < self.lock().n_listeners
    }

    /// What there is to tell, as soon as it is something else than this, or after a time.
    pub(super) fn news(&self, known: Option<PageUpdate>, time: Duration) -> PageUpdate {
        let mut state = self.lock();
        let of = |state: &HubState| PageUpdate {
            busy: state.running.as_ref().map(|(job, _)| job.version),
            version: state.shown.version,
            is_over: state.is_over,
        };
        let deadline = Instant::now() + time;
        while known == Some(of(&state)) {
            let left = deadline.saturating_duration_since(Instant::now());
            if left.is_zero() {
                break;
            }
            state = self.wait(state, left);
        }
        of(&state)
    }
}

/// Somebody who listens.
#[derive(Debug)]
pub(super) struct Listener<'h> {
    hub: &'h Hub,
}

impl Drop for Listener<'_> {
    fn drop(&mut self) {
        self.hub.lock().n_listeners -= 1;
    }
}
