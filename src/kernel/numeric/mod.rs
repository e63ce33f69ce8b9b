//! Numerical methods, each at one place with its laws: roots, linear equations, eigenvalues, quadrature.
//!
//! They know numbers only; what the numbers mean, whoever calls them knows. Each has a bound on its
//! work that the caller gives or `f64` does, and says what it answers when it gets there.

pub(crate) mod answers;
mod asked_function;
pub(crate) mod banded;
pub(crate) mod bisection;
pub(crate) mod branched_rate;
pub(crate) mod constrained_least;
pub(crate) mod cyclic;
mod dormand_prince;
pub(crate) mod enclosure;
pub(crate) mod gauss_legendre;
pub(crate) mod golden_section;
pub(crate) mod integral;
pub(crate) mod integral_error;
mod integral_growth;
mod integral_kink;
mod integral_look;
mod integral_piece;
mod integral_start;
mod integral_tail;
mod kink;
pub(crate) mod least;
mod least_beside;
mod least_beyond;
mod least_floor;
mod least_kinks;
mod least_line;
mod least_model;
mod least_newton;
pub(crate) mod least_pole;
pub(crate) mod least_problem;
mod least_rounds;
mod least_search;
pub(crate) mod least_squares;
mod least_trail;
mod least_units;
pub(crate) mod linear;
mod narrow_bracket;
pub(crate) mod newton;
pub(crate) mod open_root;
pub(crate) mod pattern_search;
mod pole_search;
pub(crate) mod polynomial_roots;
mod quadratic_program;
pub(crate) mod root;
pub(crate) mod root_error;
pub(crate) mod root_proof;
pub(crate) mod sample;
pub(crate) mod singular_values;
pub(crate) mod slope;
pub(crate) mod symmetric_band;
pub(crate) mod symmetric_eigen;
pub(crate) mod trajectory;
pub(crate) mod trajectory_nodes;
pub(crate) mod triangular_factor;
