//! What an incremental session remembers, for whoever has the session.

use std::sync::Arc;

use super::{Session, text_extent::TextExtent};
use crate::eval::Defined;

impl Session {
    /// How many results an incremental session remembers.
    #[must_use]
    pub fn n_remembered(&self) -> usize {
        self.memory.as_ref().map_or(0, |memory| memory.results.len())
    }

    /// The same, for runs of a part of a text beside those of all of it: they use what is remembered, and leave it
    /// as it is. The part may use definitions that are `known` from a report of this session.
    #[must_use]
    pub fn aside(&self, known: Vec<Defined>) -> Self {
        Self { extent: TextExtent::Aside(identified(known)), ..self.clone() }
    }

    /// The same, for runs of a part that changed: what they give is remembered with all else, until all of the text
    /// is run again. Its definitions take the place of those of an earlier report, and the rest of that holds if
    /// the part has everything that uses a name of its own, if no file has changed, and if nothing is found.
    ///
    /// ```
    /// use virote_language::{eval::Work, session::Session, value::NoFiles};
    ///
    /// let session = Session::default().incremental();
    /// let report = session.run("demo", b"let a = 1  let b = a + 1", &NoFiles, &[]);
    /// let part = session.joining(report.definitions);
    /// let joined = part.run("demo", b"let c = b + 1", &NoFiles, &[]);
    /// assert_eq!(joined.value("c").map(|c| c.to_string()).as_deref(), Some("3"));
    /// let whole = session.run("demo", b"let a = 1  let b = a + 1  let c = b + 1", &NoFiles, &[]);
    /// assert_eq!(whole.n_with(Work::Reused), 3);
    /// ```
    #[must_use]
    pub fn joining(&self, known: Vec<Defined>) -> Self {
        Self { extent: TextExtent::Joining(identified(known)), ..self.clone() }
    }

    /// Forgets what an incremental session remembers; its next run evaluates all anew.
    pub fn forget(&self) {
        if let Some(memory) = &self.memory {
            memory.forget();
        }
    }
}

/// Those definitions that an incremental session can tell from others; what has no identity is not known.
fn identified(known: Vec<Defined>) -> Arc<[Defined]> {
    known.into_iter().filter(|defined| defined.identity.is_some()).collect()
}

#[cfg(test)]
mod tests {
    use crate::{eval::Work, session::Session, value::NoFiles};

    #[test]
    fn a_run_aside_leaves_what_is_remembered() {
        let session = Session::default().incremental();
        let run =
            |session: &Session, text: &str| session.run("demo", text.as_bytes(), &NoFiles, &[]);
        let all = "let a = 1\nlet b = a + 1\nlet c = 3";
        run(&session, all);
        let n_remembered = session.n_remembered();
        for i in 0..3 {
            let report = run(
                &session.aside(Vec::new()),
                &format!("let a = 1\nlet last = a - {i}\nprint last"),
            );
            assert_eq!((report.n_with(Work::Reused), report.n_with(Work::Evaluated)), (1, 1));
            assert_eq!(session.n_remembered(), n_remembered);
        }
        assert_eq!(run(&session, all).n_with(Work::Reused), 3);
    }
}
