//! What ends a run from outside: a switch, and the measure of memory.

use super::Session;
use crate::limits::work::{MemoryGauge, StopToken};

impl Session {
    /// Whether its switch is set.
    pub fn is_stopped(&self) -> bool {
        self.stop.is_stopped()
    }

    /// How many threads it may use.
    pub fn n_threads(&self) -> usize {
        self.n_threads
    }

    /// The same with a measure of the memory that is held, in bytes, for the ceiling on it;
    /// without one that ceiling is not kept.
    #[must_use]
    pub fn measured(self, held: impl Fn() -> usize + Send + Sync + 'static) -> Self {
        Self { gauge: MemoryGauge::new(held), ..self }
    }

    /// The same with a switch: where it is set, a run under way ends at its next step with an error.
    ///
    /// ```
    /// use virote_language::{diag::Code, limits::work::StopToken, session::Session, value::NoFiles};
    ///
    /// let stop = StopToken::default();
    /// let session = Session::default().stopped_by(stop.clone());
    /// // From wherever: a key, a window that closes.
    /// std::thread::spawn(move || stop.stop()).join().unwrap();
    /// let report = session.run("demo", b"print sum([for i in 0..<1000000000: 1])", &NoFiles, &[]);
    /// assert_eq!(report.diagnostics[0].code, Code::Stopped);
    /// ```
    #[must_use]
    pub fn stopped_by(self, stop: StopToken) -> Self {
        Self { stop, ..self }
    }
}
