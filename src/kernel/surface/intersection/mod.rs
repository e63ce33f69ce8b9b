//! Lines on a surface along which something vanishes, by polynomials on squares or in closed form.

pub(super) mod analytic;
pub(super) mod level_set;
pub(crate) mod square;
