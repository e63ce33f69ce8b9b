//! Built-in values with a name.

use std::sync::Arc;

use crate::{
    kernel::Frame,
    value::{Constant, Value},
};

/// Every constant, in the order of the reference.
pub(super) static CONSTANTS: &[Constant] = &[
    Constant {
        name: "pi",
        docs: "The ratio of a circle's circumference to its diameter.",
        value: || Value::number(std::f64::consts::PI),
    },
    Constant {
        name: "tau",
        docs: "A full turn in radians, twice pi.",
        value: || Value::number(std::f64::consts::TAU),
    },
    Constant {
        name: "e",
        docs: "The base of natural logarithms.",
        value: || Value::number(std::f64::consts::E),
    },
    Constant {
        name: "XY",
        docs: "The plane of x and y through the origin, normal along z.",
        value: || Value::Frame(Arc::new(Frame::XY)),
    },
    Constant {
        name: "YZ",
        docs: "The plane of y and z through the origin, normal along x.",
        value: || Value::Frame(Arc::new(Frame::YZ)),
    },
    Constant {
        name: "ZX",
        docs: "The plane of z and x through the origin, normal along y.",
        value: || Value::Frame(Arc::new(Frame::ZX)),
    },
];
