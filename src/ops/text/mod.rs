//! Text, and conditions that must hold.

mod assert;
mod num;
mod str;

use crate::value::Op;

pub(super) static OPS: &[&Op] = &[&assert::OP, &num::OP, &str::OP];
