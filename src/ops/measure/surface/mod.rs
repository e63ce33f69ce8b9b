//! Questions about surfaces.

pub(super) mod at;
pub(super) mod closest;
pub(super) mod derivative;
pub(super) mod normal;

use crate::{
    diag::{Result, Spanned},
    kernel::Surface,
    value::At,
};

/// Parameters of a surface, inside its domains.
fn inside(surface: &Surface, u: Spanned<f64>, v: Spanned<f64>) -> Result<(f64, f64)> {
    let inside_u = surface.domain_u().clamp_inside(u.value).at(u.span)?;
    let inside_v = surface.domain_v().clamp_inside(v.value).at(v.span)?;
    Ok((inside_u, inside_v))
}
