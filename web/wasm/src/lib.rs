//! The interpreter as a WebAssembly module: a page writes a message into the module's memory and reads
//! the answer there. `virote::playground` has the messages. The module asks the page for the time alone.
//!
//! ```js
//! const at = exports.make_room(message.length);
//! new Uint8Array(exports.memory.buffer, at, message.length).set(message);
//! const answer = new Uint8Array(exports.memory.buffer, exports.answer(), exports.answer_length());
//! ```

use std::{alloc::System, cell::RefCell};

use cap::Cap;
use virote::{
    limits::{Limits, stack},
    playground::Playground,
    session::Session,
};

/// Counts the memory that is held, for the ceiling on it; it refuses none itself.
#[global_allocator]
static MEMORY: Cap<System> = Cap::new(System, usize::MAX);

#[cfg(target_arch = "wasm32")]
mod page {
    #[link(wasm_import_module = "page")]
    unsafe extern "C" {
        /// Milliseconds since the page began.
        pub(super) safe fn now() -> f64;
    }
}

/// The page's clock; elsewhere there is none.
fn milliseconds() -> f64 {
    #[cfg(target_arch = "wasm32")]
    return page::now();
    #[cfg(not(target_arch = "wasm32"))]
    0.0
}

fn session() -> Session {
    Session::new(Limits::WEB).measured(|| MEMORY.allocated())
}

#[derive(Default)]
struct Module {
    playground: Option<Playground>,
    message: Vec<u8>,
    answer: Vec<u8>,
}

thread_local! {
    static MODULE: RefCell<Module> = RefCell::default();
}

/// Begins anew; `process` tells the keys of items from those of other modules.
#[unsafe(no_mangle)]
pub extern "C" fn begin(process: u32) {
    MODULE.with_borrow_mut(|module| {
        module.playground = Some(Playground::new(&session, u64::from(process), milliseconds));
    });
}

/// Makes room for a message of so many bytes, and tells where.
#[unsafe(no_mangle)]
pub extern "C" fn make_room(length: usize) -> *mut u8 {
    MODULE.with_borrow_mut(|module| {
        module.message.clear();
        module.message.resize(length, 0);
        module.message.as_mut_ptr()
    })
}

/// Answers the message that was written there, and tells where the answer is.
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> *const u8 {
    MODULE.with_borrow_mut(|module| {
        let Module { playground, message, answer } = module;
        let playground =
            playground.get_or_insert_with(|| Playground::new(&session, 0, milliseconds));
        *answer = stack::known(Limits::WEB.stack_bytes, || playground.answer(message));
        answer.as_ptr()
    })
}

/// How long the answer is.
#[unsafe(no_mangle)]
pub extern "C" fn answer_length() -> usize {
    MODULE.with_borrow(|module| module.answer.len())
}
