//! Work side by side, on threads with the stack that functions of a script need.

use std::{
    sync::{
        Mutex, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
};

use crate::{limits::stack, session::Session};

/// What `work` gives for each of `all`, on as many threads as the session may use; `None` where somebody
/// stopped the session.
pub(super) fn side_by_side<T: Sync, R: Send>(
    all: &[T],
    session: &Session,
    work: impl Fn(&T) -> R + Sync,
) -> Option<Vec<R>> {
    let next = AtomicUsize::new(0);
    let done: Mutex<Vec<(usize, R)>> = Mutex::new(Vec::with_capacity(all.len()));
    let serve = || {
        while !session.is_stopped() {
            let place = next.fetch_add(1, Ordering::Relaxed);
            let Some(one) = all.get(place) else { return };
            let result = work(one);
            done.lock().unwrap_or_else(PoisonError::into_inner).push((place, result));
        }
    };
    let serve = &serve;
    let bytes = session.limits().stack_bytes;
    thread::scope(|scope| {
        for _ in 1..session.n_threads().min(all.len()) {
            // Without it the others do its work.
            let builder = thread::Builder::new().stack_size(bytes);
            let _ = builder.spawn_scoped(scope, || stack::known(bytes, serve));
        }
        stack::with(bytes, |_| serve());
    });
    let mut done = done.into_inner().unwrap_or_else(PoisonError::into_inner);
    done.sort_by_key(|(place, _)| *place);
    // What was at work when it was stopped came to less than it should.
    (done.len() == all.len() && !session.is_stopped())
        .then(|| done.into_iter().map(|(_, result)| result).collect())
}
