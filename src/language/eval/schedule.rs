//! Who is evaluated when: each component of the graph after those that it uses, independent ones
//! in parallel.
//!
//! A component is one definition, or functions that use one another. The order in which workers
//! take components up does not show: a component sees only finished ones.

use std::{
    cmp::Reverse,
    collections::BinaryHeap,
    sync::{Condvar, Mutex, MutexGuard, PoisonError},
    thread,
};

use super::ir::Program;
use crate::limits::stack;

/// Components for each worker below which another worker does not pay.
const WORTH_A_THREAD: usize = 4;

/// Runs `work` on every component, on up to `n_threads` threads of `stack_bytes` each; a worker
/// keeps a `T` of its own, and all of them are handed back.
pub(super) fn run<T: Send>(
    program: &Program,
    n_threads: usize,
    stack_bytes: usize,
    worker: impl Fn() -> T + Sync,
    work: impl Fn(&mut T, &[usize]) + Sync,
) -> Vec<T> {
    let n_components = program.components.len();
    let n_workers = n_threads.clamp(1, (n_components / WORTH_A_THREAD).max(1));
    if n_workers == 1 {
        let mut own = worker();
        program.components.iter().for_each(|component| work(&mut own, component));
        return vec![own];
    }
    let queue = ComponentQueue::new(program);
    let serve = || {
        let mut own = worker();
        while let Some(component) = queue.next() {
            work(&mut own, &program.components[component]);
            queue.finish(component);
        }
        own
    };
    thread::scope(|scope| {
        // Where no further thread can be had, the others do its work.
        let helpers: Vec<_> = (1..n_workers)
            .filter_map(|_| {
                let serve = || stack::known(stack_bytes, serve);
                thread::Builder::new().stack_size(stack_bytes).spawn_scoped(scope, serve).ok()
            })
            .collect();
        let mut all = vec![serve()];
        for helper in helpers {
            match helper.join() {
                Ok(own) => all.push(own),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
        all
    })
}

/// Components that can be taken up, and what the others wait for.
struct ComponentQueue {
    state: Mutex<ComponentQueueState>,
    changed: Condvar,
    /// The components that use each component.
    users: Vec<Vec<usize>>,
}

struct ComponentQueueState {
    ready: BinaryHeap<Reverse<usize>>,
    /// Components that each component still waits for.
    n_missing: Vec<usize>,
    n_left: usize,
    /// Workers that wait for a component. To wake nobody costs as much as a small definition.
    n_waiting: usize,
}

impl ComponentQueue {
    fn new(program: &Program) -> Self {
        let n_components = program.components.len();
        let mut owner = vec![0; program.definitions.len()];
        for (component, members) in program.components.iter().enumerate() {
            members.iter().for_each(|&idx| owner[idx] = component);
        }
        let (mut users, mut n_missing) = (vec![Vec::new(); n_components], vec![0; n_components]);
        for (component, members) in program.components.iter().enumerate() {
            let uses = members.iter().flat_map(|&idx| &program.definitions[idx].dependencies);
            let mut used: Vec<usize> = uses
                .map(|used| owner[used.definition])
                .filter(|&other| other != component)
                .collect();
            used.sort_unstable();
            used.dedup();
            n_missing[component] = used.len();
            used.into_iter().for_each(|other| users[other].push(component));
        }
        let ready =
            (0..n_components).filter(|&component| n_missing[component] == 0).map(Reverse).collect();
        let state = ComponentQueueState { ready, n_missing, n_left: n_components, n_waiting: 0 };
        Self { state: Mutex::new(state), changed: Condvar::new(), users }
    }

    /// The next component; `None` when all are finished.
    fn next(&self) -> Option<usize> {
        let mut state = self.lock();
        loop {
            if let Some(Reverse(component)) = state.ready.pop() {
                return Some(component);
            }
            if state.n_left == 0 {
                return None;
            }
            state.n_waiting += 1;
            state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
            state.n_waiting -= 1;
        }
    }

    fn finish(&self, component: usize) {
        let mut state = self.lock();
        state.n_left -= 1;
        for &user in &self.users[component] {
            state.n_missing[user] -= 1;
            if state.n_missing[user] == 0 {
                state.ready.push(Reverse(user));
            }
        }
        let is_awaited = 0 < state.n_waiting;
        drop(state);
        if is_awaited {
            self.changed.notify_all();
        }
    }

    fn lock(&self) -> MutexGuard<'_, ComponentQueueState> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
