//! Triangles in the place of surfaces.

/// Without a tolerance of its own a mesh may be this fraction of its size away from the surface.
///
/// Larger shows facets on a screen; smaller makes files that nobody asked for.
pub const DEFAULT_CHORD_RELATIVE: f64 = 1e-3;

/// On a screen the normals at the corners of a triangle turn no further from one another: 5 degrees.
///
/// Larger lets stripes and highlights between the corners waver, where normals are taken for linear;
/// smaller makes triangles that take longer to send than to see.
pub const VIEW_ANGLE: f64 = 0.087;

/// A side of a cell may lean from the lines of the parameters by this part of the cell, where two
/// triangles are told to be one quadrilateral.
///
/// Larger joins triangles to slanted quadrilaterals; smaller leaves triangles along edges whose vertices
/// are a little beside the lines inside.
pub const LEAN_SHARE: f64 = 0.25;

/// A normal of a mesh counts as a unit vector when its length is this near to one.
///
/// Larger lets unscaled normals pass; smaller refuses those that a file holds with six digits.
pub const UNIT_SLACK: f64 = 1e-4;

/// Part of a mesh's tolerance within which corners and edges of surfaces are one, at most.
///
/// Larger makes finer triangles for the rest of the tolerance; smaller leaves gaps between
/// surfaces that rounding has moved apart.
pub const WELD_SHARE: f64 = 0.05;

/// The height of a triangle in a mesh of a sphere is at least this part of its longest side.
///
/// Larger gives spheres beside whose edges rows do not fit to a grid of more triangles; smaller lets slivers pass.
pub const LEAST_HEIGHT: f64 = 0.06;

/// Where a surface, around a cell of its mesh, has no more slope over the plane of the cell's normal,
/// only what bends along that normal decides the cell's size.
///
/// Larger lets heights count that slopes make, which bounds overrate; smaller divides what is
/// coarsely meshed for what happens across the normal.
pub const FLAT_SLOPE: f64 = 0.25;

/// Part of the tolerance that the lines where a surface ends, or has a crease, may be away from
/// their polygons.
///
/// Together with [`FLAT_SLOPE`] it must not exceed the whole, 1 / (1 + slope): there what is between
/// the line and the polygon is seen along the slope.
pub const BORDER_SHARE: f64 = 0.8;

/// Part of the tolerance that the border of a part of a surface may be away from its polygon, along the
/// surface; the rest is for triangles.
pub(crate) const LEG_SHARE: f64 = 0.25;

/// How far from its ends, as a fraction of it, the normals of a piece of an edge are compared.
///
/// Larger misses what turns near an end; smaller looks where poles and corners have no normal.
pub(crate) const END_LOOK: f64 = 0.01;

/// Vertices that a boolean of meshes makes are misplaced by up to this fraction of the size of the
/// coordinates, and its edges shorter than that are gone.
///
/// Larger lets a lost sliver pass the check of volumes; smaller refuses what is only rounded.
pub const BOOLEAN_RELATIVE: f64 = 1e-11;

/// Two triangles at an edge lie on one another where the sine of the angle between them is less than this.
///
/// Larger flattens wedges that are meant; smaller leaves sheets without thickness where rounding has bent them.
pub(crate) const FOLD_SINE: f64 = 1e-3;

/// Planes in which triangles coincide are parallel where the sine of the angle between them is at most this.
///
/// Larger takes facets of fine meshes for one plane, which then are not equal to the last bit; smaller takes what
/// rounding turns for many.
pub(crate) const PARALLEL_SINE: f64 = 1e-6;

/// Directions whose angle has a sine above this serve as coordinates.
///
/// Larger leaves planes out that meet at an acute angle; smaller makes coordinates that lose digits.
pub(crate) const CLEAR_SINE: f64 = 0.1;

/// Nearer to an end of a leg than this part of it none is divided at the foot of a vertex.
///
/// Larger leaves legs that cross beside their ends; smaller makes legs as short as rounding.
pub(crate) const LEG_MARGIN: f64 = 0.02;

/// The mesh that tells where a solid may go through itself is no further than this part of its size from its faces.
/// What goes through by more than twice as much is seen.
///
/// Larger misses more; smaller makes more triangles, in proportion.
pub(crate) const CROSSING_CHORD_RELATIVE: f64 = 5e-4;

/// Triangles may lie on one another where the cosine of the angle between them is this or more.
///
/// Larger misses facets of two meshes of one bent surface, which lean by as much as they bend; smaller looks at
/// more pairs that only come near one another.
pub(crate) const OVERLAID_COSINE: f64 = 0.8;

/// Triangles lie on one another where their common part is larger than this part of the smaller one.
///
/// Larger misses narrow strips; smaller looks at neighbours that rounding lets overlap.
pub(crate) const OVERLAID_SHARE: f64 = 0.01;

/// An edge comes to a triangle where the weights of its corners are no less than this below zero.
///
/// Larger looks at edges that pass by; smaller lets edges through between two triangles.
pub(crate) const WEIGHT_SLACK: f64 = 1e-9;

/// Part of a cell within which the side of a border beside it may be in it.
///
/// Larger triangulates cells that are whole; smaller takes one for whole into which rounding puts a side.
pub(crate) const CELL_HAIR: f64 = 1e-6;
