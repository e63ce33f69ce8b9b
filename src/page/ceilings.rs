//! Questions of the page keep to the ceilings that a script keeps to.

use std::fmt::Display;

use crate::{
    diag::{Diagnostic, Span, fault},
    limits::work,
    session::Session,
};

/// What geometry answers within the ceilings of the session; else why not, in words.
pub(crate) fn within_ceilings<T, E: Display>(
    session: &Session,
    work: impl FnOnce() -> Result<T, E>,
) -> Result<T, String> {
    let guarded = || fault::caught(Span::default(), || Ok(work()));
    let (answer, done) = work::under(session.watch(), guarded);
    if let Some(end) = done.end {
        return Err(match end {
            work::End::Stopped => "it was stopped".to_owned(),
            work::End::Steps => "it takes more steps than the ceiling `steps` allows".to_owned(),
            work::End::Memory => "it takes more memory than the ceiling `memory` allows".to_owned(),
        });
    }
    answer.map_err(|fault: Box<Diagnostic>| fault.message)?.map_err(|err| err.to_string())
}
