//! The Python package: sessions, values and studies of the library as Python sees them.
//!
//! The classes that people use are written in Python (`virote/`), with their documentation and types;
//! here is what they stand on: `session` evaluates, `convert` takes values across, `geometry` evaluates
//! over arrays (`arrays`, `blocks`), `picture` draws, `interrupt` lets other threads of Python run meanwhile, and Ctrl-C
//! end it.

mod arrays;
mod blocks;
mod convert;
mod errors;
mod geometry;
mod interrupt;
mod operations;
mod picture;
mod plan;
mod session;
mod study;

use std::{alloc::System, ffi::OsString};

use cap::Cap;
use pyo3::prelude::*;

/// Counts the memory that is held, for the ceiling on it; it refuses none itself.
#[global_allocator]
static MEMORY: Cap<System> = Cap::new(System, usize::MAX);

/// How many bytes are held.
fn held() -> usize {
    MEMORY.allocated()
}

/// Runs the command with these arguments, the name first; its exit code.
#[pyfunction]
fn command(py: Python<'_>, args: Vec<OsString>) -> u8 {
    py.detach(|| virote::command_with(args, held))
}

/// What the classes of the package stand on.
#[pymodule]
mod _virote {
    #[pymodule_export]
    use super::{
        command,
        geometry::{Held, spline},
        operations::operations,
        plan::{PlanVariants, study_plan},
        session::{Results, Session},
        study::{check_wants, read_rows, study_batch, write_rows},
    };
}
