//! What an incremental session remembers, for whoever has the session.

use super::Session;

impl Session {
    /// How many results an incremental session remembers.
    #[must_use]
    pub fn n_remembered(&self) -> usize {
        self.memory.as_ref().map_or(0, |memory| memory.results.len())
    }

    /// The same, for runs of a part of a text beside those of all of it: they use what is remembered, and leave it
    /// as it is.
    pub fn aside(&self) -> Self {
        Self { is_aside: true, ..self.clone() }
    }

    /// Forgets what an incremental session remembers; its next run evaluates all anew.
    pub fn forget(&self) {
        if let Some(memory) = &self.memory {
            memory.forget();
        }
    }
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
            let report =
                run(&session.aside(), &format!("let a = 1\nlet last = a - {i}\nprint last"));
            assert_eq!((report.n_with(Work::Reused), report.n_with(Work::Evaluated)), (1, 1));
            assert_eq!(session.n_remembered(), n_remembered);
        }
        assert_eq!(run(&session, all).n_with(Work::Reused), 3);
    }
}
