//! Large tables that several threads fill, and lists that they make. What they hold does not depend on
//! how many.

use std::{
    sync::{
        Mutex, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
};

use crate::{
    sorting::sort_by_key,
    work::{self, Done},
};

/// Values for which a further thread pays.
const WORTH_A_THREAD: usize = 50_000;

/// Some rows of a table.
pub(super) struct RowBlock<'a, T> {
    /// The number of the first.
    pub(super) first: usize,
    /// Their values, row after row.
    pub(super) values: &'a mut [T],
}

/// A table with rows of `n_columns` values, in parts for up to `n_threads` threads.
pub(super) fn parts<T>(
    values: &mut [T],
    n_columns: usize,
    n_threads: usize,
) -> Vec<RowBlock<'_, T>> {
    let n_parts = n_threads.clamp(1, (values.len() / WORTH_A_THREAD).max(1));
    let n_columns = n_columns.max(1);
    let n_rows = (values.len() / n_columns).div_ceil(n_parts).max(1);
    let chunks = values.chunks_mut(n_rows * n_columns).enumerate();
    chunks.map(|(i, values)| RowBlock { first: i * n_rows, values }).collect()
}

/// Does `serve_one` on all parts, each on a thread of its own as far as there are threads to be had.
pub(super) fn each<P: Send>(parts: Vec<P>, serve_one: impl Fn(P) + Sync) {
    let n_parts = parts.len();
    let waiting = Mutex::new(parts);
    let next = || waiting.lock().unwrap_or_else(PoisonError::into_inner).pop();
    let serve = || {
        while let Some(part) = next() {
            serve_one(part);
        }
    };
    // Further threads work under the watch of this one.
    let watch = work::current();
    let helped = Mutex::new(Vec::new());
    let help = || {
        let done = match watch.clone() {
            Some(watch) => work::under(watch, serve).1,
            None => {
                serve();
                Done::default()
            }
        };
        helped.lock().unwrap_or_else(PoisonError::into_inner).push((done, work::counted()));
    };
    thread::scope(|scope| {
        for _ in 1..n_parts {
            // Without it the others do its work.
            let _ = thread::Builder::new().spawn_scoped(scope, help);
        }
        serve();
    });
    for (done, n_counted) in helped.into_inner().unwrap_or_else(PoisonError::into_inner) {
        work::add(done, n_counted);
    }
}

/// What `make` gives for each of all, in their order, on up to `n_threads` threads.
pub(super) fn map<T: Sync, R: Send>(
    all: &[T],
    n_threads: usize,
    make: impl Fn(&T) -> R + Sync,
) -> Vec<R> {
    let n_threads = n_threads.min(all.len());
    if n_threads <= 1 {
        return all.iter().map(make).collect();
    }
    let next = AtomicUsize::new(0);
    let made = Mutex::new(Vec::with_capacity(all.len()));
    each(vec![(); n_threads], |()| {
        let mut own = Vec::new();
        loop {
            let place = next.fetch_add(1, Ordering::Relaxed);
            let Some(one) = all.get(place) else { break };
            own.push((place, make(one)));
        }
        made.lock().unwrap_or_else(PoisonError::into_inner).extend(own);
    });
    let mut made = made.into_inner().unwrap_or_else(PoisonError::into_inner);
    sort_by_key(&mut made, |&(place, _)| place);
    made.into_iter().map(|(_, made)| made).collect()
}

#[cfg(test)]
mod tests {
    use super::{each, map, parts};

    #[test]
    fn a_list_is_made_in_its_order() {
        for (n, n_threads) in [(0, 3), (1, 2), (1000, 1), (1000, 4)] {
            let all: Vec<usize> = (0..n).collect();
            let made = map(&all, n_threads, |&i| 3 * i);
            assert!(made.into_iter().eq((0..n).map(|i| 3 * i)), "{n} by {n_threads}");
        }
    }

    #[test]
    fn every_row_is_filled_once() {
        for (n_rows, n_columns, n_threads) in
            [(1000, 301, 3), (7, 3, 4), (0, 5, 2), (2, 200_000, 8)]
        {
            let mut values = vec![0; n_rows * n_columns];
            each(parts(&mut values, n_columns, n_threads), |rows| {
                for (i, row) in rows.values.chunks_mut(n_columns).enumerate() {
                    row.iter_mut().for_each(|value| *value += rows.first + i + 1);
                }
            });
            let expected = (0..n_rows).flat_map(|i| vec![i + 1; n_columns]);
            assert!(values.into_iter().eq(expected), "{n_rows} x {n_columns} by {n_threads}");
        }
    }
}
