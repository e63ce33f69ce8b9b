//! What is to be said about solids that are made of walls.

use crate::{
    diag::{Code, Diagnostic, Result, Span},
    kernel::{GeomError, Solid, SolidError},
    value::{Ctx, blamed_on},
};

/// A solid, with a warning where it was not looked at whether it goes through itself; or why it is none, with what helps
/// where walls go through one another.
pub(super) fn of_walls(
    ctx: &mut Ctx<'_>,
    made: std::result::Result<Solid, GeomError>,
    span: Span,
    help: &str,
) -> Result<Solid> {
    let solid = made.map_err(|error| {
        let is_crossing = matches!(error, GeomError::Solid(SolidError::CrossesItself { .. }));
        let mut diagnostic = blamed_on(error, span);
        if is_crossing {
            diagnostic.hints = vec![help.to_owned()];
        }
        diagnostic
    })?;
    if solid.may_cross() {
        let message = "whether the faces go through one another was not looked at: what it takes has too many triangles";
        let hint = "a solid of fewer faces, or with fewer bends, is looked at";
        ctx.warn(Diagnostic::warning(Code::Unclean, span, message).hint(hint));
    }
    Ok(solid)
}
