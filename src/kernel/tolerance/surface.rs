//! Normals and curvatures of surfaces.

/// How far into the domain, as a fraction of it, a normal is looked for at a point that has none.
///
/// Larger tilts the shading around the point; smaller asks where the derivatives are still
/// rounding.
pub const NORMAL_STEP: f64 = 1e-6;

/// What rounding may leave in a curvature, over the size of the surface there, without the place being looked at from
/// a pole beside it.
///
/// Larger answers beside poles with fewer digits; smaller asks for derivatives of high order where all digits are there.
pub(crate) const CLEAR_SHAPE: f64 = 1e-9;

/// How near to a collapsed edge, as a share of the piece, a surface's shape is told by the series at the edge.
///
/// Larger asks for series that take more terms than there are; smaller leaves the digits that rounding takes there.
pub(crate) const NEAR_POLE_SHARE: f64 = 1.0 / 64.0;

/// The share of a series that its last term is at most.
///
/// Larger answers with what the series lacks; smaller leaves what rounding takes from derivatives at the place.
pub(crate) const NEAR_POLE_REST: f64 = 1e-13;

/// Terms of a normal's expansion at a singular place point one way when their unit vectors are
/// nearer than this.
///
/// Larger gives a ridge the normal of one of its sides; smaller finds no normal at a pole that is
/// round up to the rounding of its control points.
pub const NORMAL_AGREEMENT: f64 = 1e-6;

/// How unequally a surface bends changes by differences over this part of a rectangle of parameters.
///
/// Larger looks over bends; smaller differences rounding.
pub const UMBILIC_DIFFERENCE: f64 = 1e-5;

/// Where the two changes of that are this far from parallel, an umbilic is isolated.
///
/// Larger looks around more umbilics to tell; smaller takes places of a line of umbilics for single
/// ones.
pub const UMBILIC_CLEAR: f64 = 1e-6;

/// Another umbilic is isolated if on a circle around it, this part of a rectangle wide, the surface
/// bends unequally everywhere, and where least by the next constant of where most.
///
/// Larger circles meet neighbours; smaller ones rounding.
pub const UMBILIC_CIRCLE: f64 = 1e-3;

/// Larger overlooks umbilics of narrow patches; smaller tells places of lines of umbilics.
pub const UMBILIC_SHARE: f64 = 0.02;

/// Where the curvatures of a surface differ by less than this fraction of the strongest, a map of
/// them has one colour.
///
/// Larger hides how an almost round surface bends; smaller paints rounding.
pub const SHADE_RELATIVE: f64 = 1e-10;

/// The scale of a map of radii of curvature ends at this many sizes of the surface.
///
/// Larger spends the colours on what looks flat; smaller has one colour for what visibly bends.
pub const FLAT_SIZES: f64 = 10.0;

/// How far inside of a part of a patch, as a fraction of it, its corners are looked at for a fold.
///
/// Larger misses folds along an edge; smaller looks at normals where two parts, or an edge that is a
/// point, make them rounding.
pub(crate) const INSIDE_SHARE: f64 = 1.0 / 1024.0;
