//! How a run ended.

use crate::{
    diag::{Code, Severity},
    session::Report,
};

/// How a run ended; the numbers are part of the contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum ExitStatus {
    /// All is well.
    Well = 0,
    /// A check or test failed.
    Failed = 1,
    /// The script has an error.
    Wrong = 2,
    /// The command was used wrongly, something could not be read or written, or virote failed.
    Usage = 3,
    /// Ctrl-C ended what was under way; by the custom of shells 128 and the number of the signal.
    Interrupted = 130,
}

impl ExitStatus {
    /// How a script ended by what was found in it.
    pub(super) fn of(report: &Report) -> Self {
        if report.diagnostics.iter().any(|found| found.code == Code::Fault) {
            Self::Usage
        } else if report.count(Severity::Error) > 0 {
            Self::Wrong
        } else if report.count(Severity::Failure) > 0 {
            Self::Failed
        } else {
            Self::Well
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        diag::{Diagnostic, Span},
        session::Session,
        value::NoFiles,
    };

    #[test]
    fn a_fault_of_ours_counts_more_than_mistakes_of_the_script() {
        let mut report = Session::default().run("a.geo", b"let a = b", &NoFiles, &[]);
        assert_eq!(ExitStatus::of(&report), ExitStatus::Wrong);
        report.diagnostics.push(Diagnostic::error(Code::Fault, Span::new(0, 0), "a fault"));
        assert_eq!(ExitStatus::of(&report) as u8, 3);
    }
}
