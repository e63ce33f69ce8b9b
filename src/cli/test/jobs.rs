//! Several scripts at a time.

use std::{
    collections::BTreeMap,
    sync::{
        atomic::{AtomicUsize, Ordering},
        mpsc,
    },
    thread,
};

use crate::limits::stack;

/// Does `work` on each of `all`, on `n_jobs` threads; `tell` hears the results in order, each as
/// soon as those before it are there.
pub(super) fn in_order<T: Sync, R: Send>(
    all: &[T],
    n_jobs: usize,
    work: impl Fn(&T) -> R + Sync,
    mut tell: impl FnMut(R),
) {
    let next = AtomicUsize::new(0);
    thread::scope(|scope| {
        let (sender, results) = mpsc::channel();
        let mut n_started = 0;
        for _ in 0..if n_jobs < 2 { 0 } else { n_jobs } {
            let (sender, next, work) = (sender.clone(), &next, &work);
            let serve = move || {
                while let i = next.fetch_add(1, Ordering::Relaxed)
                    && let Some(one) = all.get(i)
                    && sender.send((i, work(one))).is_ok()
                {}
            };
            let stack_bytes = stack::own_bytes();
            let serve = move || stack::known(stack_bytes, serve);
            let started = thread::Builder::new().stack_size(stack_bytes).spawn_scoped(scope, serve);
            n_started += usize::from(started.is_ok());
        }
        drop(sender);
        if n_started == 0 {
            return all.iter().for_each(|one| tell(work(one)));
        }
        let (mut early, mut n_told) = (BTreeMap::new(), 0);
        for (i, result) in results {
            early.insert(i, result);
            while let Some(result) = early.remove(&n_told) {
                tell(result);
                n_told += 1;
            }
        }
    });
}

#[cfg(test)]
mod tests {
    use super::in_order;

    #[test]
    fn results_are_told_in_order_whatever_the_number_of_threads() {
        let all: Vec<u64> = (0..40).collect();
        for n_jobs in [1, 2, 7, 64] {
            let mut told = Vec::new();
            let work = |n: &u64| {
                std::thread::sleep(std::time::Duration::from_millis(n * 7 % 5));
                n * n
            };
            in_order(&all, n_jobs, work, |square| told.push(square));
            assert_eq!(told, all.iter().map(|n| n * n).collect::<Vec<_>>());
        }
    }
}
