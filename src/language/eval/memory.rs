//! What an incremental session remembers between runs: the results of definitions under their keys.
//!
//! A result has an identity, a number that is given once; whoever uses a definition has that number
//! in its own key. A key is found again when nothing that it spells has changed; a result that read
//! files is good as long as they hold what they held. Values with functions of the script and
//! results that came with warnings are made again, since they hold places of the text; their
//! identity stays, so that whatever uses them is found again.

use std::{
    collections::{BTreeMap, BTreeSet, HashMap},
    hash::{DefaultHasher, Hasher},
    sync::{Arc, Mutex, MutexGuard, PoisonError},
};

use crate::value::{Files, Value};

/// How a definition came by its value in a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    /// It was evaluated: it is new, or something changed that it uses.
    Evaluated,
    /// It was evaluated although nothing changed, because it holds functions of the script or gave a
    /// warning, which point into the text. Whatever uses it is not evaluated for that.
    Renewed,
    /// It has the value of a run before.
    Reused,
    /// It has no value.
    Failed,
}

/// The identity of a definition's result.
#[derive(Debug)]
pub(crate) struct ResultId {
    pub(crate) result: u64,
    pub(crate) work: Work,
    /// Of an import, the results under the names that its file shows.
    pub(crate) fields: Fields,
}

/// Names with the identities of their results.
pub(crate) type Fields = Arc<[(Arc<str>, u64)]>;

impl ResultId {
    /// The identity of a result that is no import.
    pub(super) fn new(result: u64, work: Work) -> Self {
        Self { result, work, fields: Fields::default() }
    }

    /// The result under a name that an imported file shows.
    pub(crate) fn field(&self, name: &str) -> Option<u64> {
        self.fields.iter().find(|(known, _)| **known == *name).map(|&(_, result)| result)
    }
}

/// Results of earlier runs. Belongs to one set of built-ins.
#[derive(Debug, Default)]
pub struct Memory(Mutex<MemoryState>);

#[derive(Debug, Default)]
struct MemoryState {
    results: HashMap<Box<[u8]>, MemoryEntry>,
    n_results: u64,
    n_runs: u64,
}

/// A remembered result.
#[derive(Debug)]
struct MemoryEntry {
    result: u64,
    /// Missing where it must be made again.
    value: Option<Value>,
    reads: Arc<BTreeSet<FileRead>>,
    /// The steps that it took.
    n_steps: u64,
    /// The run that gave the identity.
    first_run: u64,
    last_run: u64,
    /// Whether the last run of a text without errors used it.
    is_settled: bool,
}

/// A file that a definition read, and what it held.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct FileRead {
    path: String,
    most: usize,
    print: Fingerprint,
}

/// The length and 128 bits of hash of a file's content, or of the message that there is none.
///
/// Two contents of one length, made without intent, agree by a chance of 2⁻¹²⁸.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Fingerprint {
    is_there: bool,
    len: usize,
    hashes: [u64; 2],
}

impl Fingerprint {
    fn of(outcome: &Result<Vec<u8>, String>) -> Self {
        let bytes = match outcome {
            Ok(bytes) => bytes.as_slice(),
            Err(message) => message.as_bytes(),
        };
        let hash = |seed: u8| {
            let mut hasher = DefaultHasher::new();
            hasher.write_u8(seed);
            hasher.write(bytes);
            hasher.finish()
        };
        Self { is_there: outcome.is_ok(), len: bytes.len(), hashes: [hash(0), hash(1)] }
    }
}

impl FileRead {
    /// What was read of a file.
    pub(crate) fn new(path: String, most: usize, outcome: &Result<Vec<u8>, String>) -> Self {
        Self { path, most, print: Fingerprint::of(outcome) }
    }
}

/// A result that is known from an earlier run.
pub(crate) struct CachedResult {
    pub(crate) result: u64,
    pub(crate) value: Option<Value>,
    /// The files that it read.
    pub(crate) reads: Arc<BTreeSet<FileRead>>,
    /// The steps that it took.
    pub(crate) n_steps: u64,
}

impl Memory {
    /// Begins a run.
    #[must_use]
    pub fn begin(&self) -> CacheRun<'_> {
        let mut state = self.lock();
        state.n_runs += 1;
        CacheRun { memory: self, run: state.n_runs, prints: Mutex::default() }
    }

    /// How many results are remembered.
    #[must_use]
    pub fn len(&self) -> usize {
        self.lock().results.len()
    }

    /// Whether nothing is remembered.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Forgets every result.
    pub fn forget(&self) {
        self.lock().results.clear();
    }

    fn lock(&self) -> MutexGuard<'_, MemoryState> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A memory in use by one run.
#[derive(Debug)]
pub struct CacheRun<'m> {
    memory: &'m Memory,
    run: u64,
    /// Files that were looked at again, each once a run.
    prints: Mutex<BTreeMap<(String, usize), Fingerprint>>,
}

impl CacheRun<'_> {
    /// Ends the run, and forgets what it did not use. After a run with errors also the results of the
    /// last one without are kept, for when the errors are mended.
    pub fn end(self, has_errors: bool) {
        let mut state = self.memory.lock();
        state.results.retain(|_, entry| {
            let is_used = entry.last_run == self.run;
            if has_errors {
                return is_used || entry.is_settled;
            }
            entry.is_settled = true;
            is_used
        });
    }

    /// Ends a run of a part of a text, the rest of which is as it was: what that gave is kept.
    pub fn end_joining(self, has_errors: bool) {
        let mut state = self.memory.lock();
        for entry in state.results.values_mut().filter(|entry| entry.first_run == self.run) {
            entry.is_settled = !has_errors;
        }
    }

    /// Ends a run beside those of a whole text, and forgets what it evaluated itself.
    pub fn end_aside(self) {
        self.memory.lock().results.retain(|_, entry| entry.first_run != self.run);
    }

    /// The identity of a key that is no definition's.
    pub(super) fn intern(&self, key: Box<[u8]>) -> u64 {
        self.keep(key, None, BTreeSet::new(), 0)
    }

    /// The result of an earlier run under this key, if the files that it read hold what they held.
    pub(super) fn find(&self, key: &[u8], files: &dyn Files) -> Option<CachedResult> {
        let known = {
            let mut state = self.memory.lock();
            let entry = state.results.get_mut(key)?;
            entry.last_run = self.run;
            // What two definitions share within a run is evaluated by both: who comes first may
            // depend on the threads, and must not show.
            if entry.first_run == self.run {
                return None;
            }
            let (value, reads) = (entry.value.clone(), Arc::clone(&entry.reads));
            CachedResult { result: entry.result, value, reads, n_steps: entry.n_steps }
        };
        known.reads.iter().all(|read| self.print(read, files) == read.print).then_some(known)
    }

    /// Remembers a result; its identity, which is the one that it had if it is the same.
    pub(super) fn keep(
        &self,
        key: Box<[u8]>,
        value: Option<Value>,
        reads: BTreeSet<FileRead>,
        n_steps: u64,
    ) -> u64 {
        let mut state = self.memory.lock();
        if let Some(entry) = state.results.get_mut(&key)
            && *entry.reads == reads
        {
            entry.last_run = self.run;
            // A twin of this run may have been evaluated without a warning, which goes by the spelling.
            if value.is_none() {
                entry.value = None;
            }
            return entry.result;
        }
        state.n_results += 1;
        let entry = MemoryEntry {
            result: state.n_results,
            value,
            reads: Arc::new(reads),
            n_steps,
            first_run: self.run,
            last_run: self.run,
            is_settled: false,
        };
        let result = entry.result;
        state.results.insert(key, entry);
        result
    }

    /// What a file holds now.
    fn print(&self, read: &FileRead, files: &dyn Files) -> Fingerprint {
        let name = (read.path.clone(), read.most);
        let prints = || self.prints.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(&print) = prints().get(&name) {
            return print;
        }
        let print = Fingerprint::of(&files.read(&read.path, read.most));
        *prints().entry(name).or_insert(print)
    }
}
