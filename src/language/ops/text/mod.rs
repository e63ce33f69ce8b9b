//! Text, and conditions that must hold.

mod assert;
mod contains;
mod format;
mod index_of;
mod join;
mod lower;
mod num;
mod pad;
mod replace;
mod split;
mod str;
mod substring;
mod upper;

use crate::value::Op;

pub(super) static OPS: &[&Op] = &[
    &assert::OP,
    &contains::OP,
    &format::OP,
    &index_of::OP,
    &join::OP,
    &lower::OP,
    &num::OP,
    &pad::OP,
    &replace::OP,
    &split::OP,
    &str::OP,
    &substring::OP,
    &upper::OP,
];
