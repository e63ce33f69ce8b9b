//! Faults of the program itself: a panic is caught where it can do no harm, and told like a mistake.

use std::{
    any::Any,
    cell::RefCell,
    panic::{self, AssertUnwindSafe},
};

use super::{Code, Diagnostic, Result, Span};

thread_local! {
    /// Where the program says that the last panic of this thread began.
    static PLACE: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// Whoever reports a fault is asked for this.
pub const REMEDY: &str = concat!(
    "this is a fault of virote, not of the script: please report it with the script; this is virote ",
    env!("CARGO_PKG_VERSION")
);

/// From now on a panic writes nothing by itself; [`caught`] tells of it.
pub fn listen() {
    panic::set_hook(Box::new(|info| {
        let place = info.location().map(|place| format!("{}:{}", place.file(), place.line()));
        PLACE.with_borrow_mut(|kept| *kept = place);
    }));
}

/// What `work` gives.
///
/// # Errors
/// Those of `work`; a fault of the program where it panics, told at `span`.
pub fn caught<T>(span: Span, work: impl FnOnce() -> Result<T>) -> Result<T> {
    panic::catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|payload| {
        Diagnostic::error(Code::Fault, span, message(&*payload)).hint(REMEDY).fail()
    })
}

fn message(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().copied();
    let text = text.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
    let place = PLACE.take().map(|place| format!(" ({place})")).unwrap_or_default();
    format!("virote failed: {}{place}", text.unwrap_or("for a reason it does not tell"))
}

#[cfg(test)]
mod tests {
    use super::{Code, Span, caught};

    #[test]
    fn a_panic_becomes_a_diagnostic_at_its_place() {
        let nothing: Vec<u32> = Vec::new();
        let told = caught(Span::new(3, 5), || Ok(nothing[0])).expect_err("there is no element");
        assert_eq!((told.code, told.primary.span), (Code::Fault, Span::new(3, 5)));
        assert!(told.message.contains("index out of bounds"), "{}", told.message);
    }
}
