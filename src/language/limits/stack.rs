//! Threads with stack enough for whatever recurses over what a user wrote.
//!
//! Parsing, lowering and evaluation recurse as deep as the ceilings let a script nest. A thread of the
//! system's own has room for a part of that only, so the work is done on a thread with the stack that
//! the ceilings need. Where none can be had (no room, or a platform without threads), the ceilings come
//! down to what there is ([`Limits::on_stack`](super::Limits::on_stack)).

use std::{cell::Cell, panic::resume_unwind, sync::Mutex, thread};

use super::work::{self, Done};

/// What a thread has that nobody asked for its stack: the half of what Rust gives to threads, and what
/// WebAssembly has by default.
const UNKNOWN: usize = 1 << 20;

/// The smallest stack that is tried, as a part of the one that is wanted.
const SMALLEST_PART: usize = 32;

thread_local! {
    static OWN: Cell<usize> = const { Cell::new(UNKNOWN) };
}

/// Bytes of stack that this thread is known to have.
#[must_use]
pub fn own_bytes() -> usize {
    OWN.get()
}

/// Does the work on this thread, which has so many bytes of stack.
pub fn known<R>(bytes: usize, work: impl FnOnce() -> R) -> R {
    /// Puts back what was known, also where a panic passes.
    struct Before(usize);
    impl Drop for Before {
        fn drop(&mut self) {
            OWN.set(self.0);
        }
    }
    let _before = Before(OWN.replace(bytes));
    work()
}

/// Does the work with so many bytes of stack, on this thread where it has them, else on one of its own;
/// it is told how many it has. A panic passes through, and what is counted goes on to be. The work is
/// done once.
///
/// ```
/// use virote_language::limits::stack;
///
/// fn depth(n: u32) -> u32 {
///     if n == 0 { 0 } else { 1 + depth(n - 1) }
/// }
///
/// let (bytes, deep) = stack::with(64 << 20, |bytes| (bytes, depth(100_000)));
/// assert_eq!((bytes, deep), (64 << 20, 100_000));
/// ```
pub fn with<R: Send>(bytes: usize, work: impl FnMut(usize) -> R + Send) -> R {
    with_room(bytes, 0, work)
}

/// The same, where a stack is taken only if it leaves so many bytes of address space for all else.
pub fn with_room<R: Send>(bytes: usize, room: usize, mut work: impl FnMut(usize) -> R + Send) -> R {
    let watch = work::current();
    let mut tried = bytes;
    while bytes / SMALLEST_PART <= tried && own_bytes() < tried {
        // Held until the thread is there, which waits for that.
        let mut kept: Vec<u8> = Vec::new();
        let has_room = room == 0 || kept.try_reserve_exact(room).is_ok();
        let gate = Mutex::new(());
        let mut serve = || {
            drop(gate.lock());
            let (result, done) = known(tried, || match watch.clone() {
                Some(watch) => work::under(watch, || work(tried)),
                None => (work(tried), Done::default()),
            });
            (result, done, work::counted())
        };
        let finished = thread::scope(|scope| {
            let waits = gate.lock();
            let worker = thread::Builder::new().stack_size(tried);
            let worker = if has_room { worker.spawn_scoped(scope, &mut serve).ok() } else { None };
            drop(kept);
            drop(waits);
            worker.map(thread::ScopedJoinHandle::join)
        });
        match finished {
            Some(Ok((result, done, n_counted))) => {
                work::add(done, n_counted);
                return result;
            }
            Some(Err(panic)) => resume_unwind(panic),
            // No such thread is to be had.
            None => tried /= 2,
        }
    }
    work(own_bytes().min(bytes))
}

#[cfg(test)]
mod tests {
    use super::{known, own_bytes, with};
    use crate::limits::work;

    #[test]
    fn a_thread_with_stack_enough_does_the_work_itself() {
        let here = std::thread::current().id();
        let there = with(8 << 20, |_| (std::thread::current().id(), own_bytes()));
        assert!(there.0 != here && there.1 == 8 << 20);
        known(64 << 20, || {
            assert_eq!(
                with(8 << 20, |bytes| (std::thread::current().id(), bytes)),
                (here, 8 << 20)
            );
        });
        assert!(own_bytes() < 8 << 20, "it was known for a while only");
    }

    #[test]
    fn where_no_such_thread_is_to_be_had_less_has_to_do() {
        // More than any address space has; what is tried is never above what is told.
        let most = with(1 << 50, |bytes| bytes);
        assert!((1 << 20..1 << 50).contains(&most));
    }

    #[test]
    fn what_is_counted_goes_on_to_be() {
        let before = work::counted();
        with(8 << 20, |_| work::count(7));
        assert_eq!(work::counted() - before, 7);
    }
}
