//! Work, counted while it is done, and whoever may end it.
//!
//! A long loop tells of each of its steps ([`goes_on`]). Above it whoever started it has said what it
//! may take ([`under`]): so many steps, so much memory, and only as long as somebody wants the answer.
//! When that is over every loop leaves as soon as it can with whatever it has, which is thrown away:
//! whoever started it is told why it ended. The count belongs to the thread, because what is counted
//! lies deep below whoever asks; no result depends on it.

use std::{
    cell::{Cell, RefCell},
    fmt::{self, Debug, Formatter},
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};

/// Steps from one look at memory and the switch to the next.
const BETWEEN_LOOKS: u64 = 32;

/// Parts of a value that are copied or compared in the time of a step.
pub const PARTS_A_STEP: u64 = 16;

/// A switch by which whoever no longer wants an answer ends the work on it, from any thread. Clones are
/// one switch.
///
/// ```
/// use virote_kernel::work::StopToken;
///
/// let stop = StopToken::default();
/// let handed_out = stop.clone();
/// handed_out.stop();
/// assert!(stop.is_stopped());
/// assert!(stop.reset() && !handed_out.is_stopped());
/// ```
#[derive(Clone, Debug, Default)]
pub struct StopToken(Arc<AtomicBool>);

impl StopToken {
    /// Ends the work.
    pub fn stop(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether the work is to end.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// Lets work go on again; whether it was to end.
    pub fn reset(&self) -> bool {
        self.0.swap(false, Ordering::Relaxed)
    }
}

/// Tells how many bytes of memory are held, for the ceiling on them. One that measures nothing tells 0,
/// and the ceiling is not kept.
///
/// ```
/// use virote_kernel::work::MemoryGauge;
///
/// assert_eq!(MemoryGauge::new(|| 1 << 20).held(), 1 << 20);
/// assert_eq!(MemoryGauge::default().held(), 0);
/// ```
#[derive(Clone, Default)]
pub struct MemoryGauge(Option<Arc<dyn Fn() -> usize + Send + Sync>>);

impl MemoryGauge {
    /// Measures by this.
    #[must_use]
    pub fn new(held: impl Fn() -> usize + Send + Sync + 'static) -> Self {
        Self(Some(Arc::new(held)))
    }

    /// Bytes that are held now.
    #[must_use]
    pub fn held(&self) -> usize {
        self.0.as_ref().map_or(0, |held| held())
    }
}

impl Debug for MemoryGauge {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_tuple("MemoryGauge").field(&self.held()).finish()
    }
}

/// What work may take.
///
/// A search may take a hundred steps, and any amount of memory:
///
/// ```
/// use virote_kernel::work::{self, End, MemoryGauge, StopToken, Watch};
///
/// let watch = Watch {
///     gauge: MemoryGauge::default(),
///     memory_bytes: usize::MAX,
///     stop: StopToken::default(),
///     steps: 100,
/// };
/// let (_, done) = work::under(watch, || while work::goes_on(1) {});
/// assert_eq!(done.end, Some(End::Steps));
/// ```
#[derive(Clone, Debug)]
pub struct Watch {
    /// How many bytes of memory are held.
    pub gauge: MemoryGauge,
    /// How many may be.
    pub memory_bytes: usize,
    /// Set by whoever no longer wants the answer.
    pub stop: StopToken,
    /// How many steps may be taken.
    pub steps: u64,
}

/// Why work was ended.
///
/// Whoever asks for something long tells why there is no answer:
///
/// ```
/// use virote_kernel::work;
///
/// let stop = work::StopToken::default();
/// stop.stop();
/// let watch = work::Watch {
///     gauge: work::MemoryGauge::default(),
///     memory_bytes: usize::MAX,
///     stop,
///     steps: u64::MAX,
/// };
/// let (went_on, done) = work::under(watch, || (0..100).all(|_| work::goes_on(1)));
/// assert!(!went_on);
/// assert_eq!(done.end, Some(work::End::Stopped));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Nobody wants the answer.
    Stopped,
    /// It holds too much memory.
    Memory,
    /// It takes too many steps.
    Steps,
}

/// What was done under a watch.
///
/// ```
/// use virote_kernel::work::Done;
///
/// let nothing = Done::default();
/// assert_eq!((nothing.steps, nothing.end), (0, None));
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Done {
    /// Steps, without those under watches inside.
    pub steps: u64,
    /// Why it was ended, if it was.
    pub end: Option<End>,
}

/// What a thread has done under its watch.
#[derive(Clone, Copy, Debug, Default)]
struct ThreadState {
    done: Done,
    next_look: u64,
}

thread_local! {
    static STATE: Cell<ThreadState> = const { Cell::new(ThreadState {
        done: Done { steps: 0, end: None },
        next_look: 0,
    }) };
    static WATCH: RefCell<Option<Watch>> = const { RefCell::new(None) };
    static COUNTED: Cell<u64> = const { Cell::new(0) };
}

/// Puts back what the thread was at, also where a panic passes.
struct RestoredState(ThreadState, Option<Watch>);

impl Drop for RestoredState {
    fn drop(&mut self) {
        STATE.set(self.0);
        WATCH.replace(self.1.take());
    }
}

/// Does work under a watch.
pub fn under<R>(watch: Watch, work: impl FnOnce() -> R) -> (R, Done) {
    let outer = RestoredState(STATE.replace(ThreadState::default()), WATCH.replace(Some(watch)));
    let result = work();
    let done = STATE.get().done;
    drop(outer);
    (result, done)
}

/// Counts steps; whether to go on. Whoever is told not to leaves at once, with anything.
#[must_use]
pub fn goes_on(n_steps: u64) -> bool {
    count(n_steps);
    let mut state = STATE.get();
    state.done.steps += n_steps;
    if state.next_look <= state.done.steps && state.done.end.is_none() {
        state.next_look = state.done.steps + BETWEEN_LOOKS;
        state.done.end = WATCH.with_borrow(|watch| watch.as_ref()?.look(state.done.steps));
    }
    STATE.set(state);
    state.done.end.is_none()
}

/// Counts the copying or the comparing of so many parts; whether to go on, as [`goes_on`] does.
#[must_use]
pub fn passes(n_parts: usize) -> bool {
    match n_parts as u64 / PARTS_A_STEP {
        0 => true,
        n_steps => goes_on(n_steps),
    }
}

/// Bytes that may be held besides those that are.
#[must_use]
pub fn room() -> usize {
    WATCH.with_borrow(|watch| {
        let left = |watch: &Watch| watch.memory_bytes.saturating_sub(watch.gauge.held());
        watch.as_ref().map_or(usize::MAX, left)
    })
}

/// Whether so many more bytes may be held. Whoever is told not leaves at once, with anything.
#[must_use]
pub fn has_room(n_bytes: usize) -> bool {
    let mut state = STATE.get();
    if state.done.end.is_none() && room() < n_bytes {
        state.done.end = Some(End::Memory);
        STATE.set(state);
    }
    state.done.end.is_none()
}

/// Adds to a list and counts a step; asks for room before the list grows. Whether to go on.
#[must_use]
pub fn push<T>(items: &mut Vec<T>, item: T) -> bool {
    /// Lists below this grow without asking.
    const SMALL: usize = 1 << 12;
    // It doubles.
    let n_bytes = size_of::<T>() * items.len();
    let is_small = items.len() < items.capacity() || n_bytes < SMALL;
    if !is_small && !has_room(n_bytes) {
        return false;
    }
    items.push(item);
    goes_on(1)
}

/// What an iterator gives as a list; none when the work was ended.
pub fn collect<T>(items: impl IntoIterator<Item = T>) -> Option<Vec<T>> {
    let mut list = Vec::new();
    items.into_iter().all(|item| push(&mut list, item)).then_some(list)
}

/// What was done so far under the innermost watch.
#[must_use]
pub fn done() -> Done {
    STATE.get().done
}

/// Why the work was ended, if it was.
#[must_use]
pub fn ended() -> Option<End> {
    STATE.get().done.end
}

/// Counts steps of work that has an end in sight.
pub fn count(n_steps: u64) {
    COUNTED.set(COUNTED.get() + n_steps);
}

/// Steps that this thread has counted since it began, and those of threads that worked for it.
#[must_use]
pub fn counted() -> u64 {
    COUNTED.get()
}

/// What a further thread needs to work for this one.
#[must_use]
pub fn current() -> Option<Watch> {
    WATCH.with_borrow(Clone::clone)
}

/// Counts what a further thread has done for this one.
pub fn add(done: Done, n_counted: u64) {
    count(n_counted);
    let mut state = STATE.get();
    state.done.steps += done.steps;
    state.done.end = state.done.end.or(done.end);
    STATE.set(state);
}

impl Watch {
    fn look(&self, n_steps: u64) -> Option<End> {
        if self.stop.is_stopped() {
            Some(End::Stopped)
        } else if self.steps < n_steps {
            Some(End::Steps)
        } else if self.memory_bytes < self.gauge.held() {
            Some(End::Memory)
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{
        End, MemoryGauge, StopToken, Watch, collect, counted, goes_on, has_room, room, under,
    };

    /// A watch under which so many bytes are held.
    fn watch(held: usize, memory_bytes: usize, steps: u64) -> Watch {
        let (gauge, stop) = (MemoryGauge::new(move || held), StopToken::default());
        Watch { gauge, memory_bytes, stop, steps }
    }

    #[track_caller]
    fn check(watch: Watch, end: End) {
        let ((), done) = under(watch, || while goes_on(1) {});
        assert_eq!(done.end, Some(end));
        assert!(goes_on(1), "nobody watches any more");
    }

    #[test]
    fn each_watch_ends_work_that_has_no_end() {
        check(watch(0, 1, 1000), End::Steps);
        check(watch(2, 1, 1000), End::Memory);
        let stopped = watch(0, 1, 1000);
        stopped.stop.stop();
        check(stopped, End::Stopped);
    }

    #[test]
    fn a_list_asks_for_room_before_it_grows() {
        let (list, done) = under(watch(0, 1 << 20, 1 << 30), || collect(0_u64..));
        assert_eq!((list, done.end), (None, Some(End::Memory)), "though nothing seems to be held");
        let ((), done) = under(watch(1 << 19, 1 << 20, 1 << 30), || {
            assert_eq!(room(), 1 << 19);
            assert!(has_room(1 << 19) && !has_room((1 << 19) + 1) && !has_room(0));
        });
        assert_eq!(done.end, Some(End::Memory));
    }

    #[test]
    fn work_inside_work_is_counted_once() {
        let open = || watch(0, 1, 1000);
        let before = counted();
        let (inner, outer) = under(open(), || {
            assert!(goes_on(5));
            under(open(), || assert!(goes_on(7))).1
        });
        assert_eq!((inner.steps, outer.steps, counted() - before), (7, 5, 12));
    }
}
