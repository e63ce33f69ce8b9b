//! Every tolerance of the kernel: the only file where a small number may be written.
//!
//! Algorithms that answer to the user's idea of "the same place" take a [`Tolerance`] from their
//! caller and never pick one. The named constants below are different in kind: they say where the
//! digits of an `f64` end, so they are fixed, and all are ratios without a unit.

/// The precision that a computation is asked to reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Points closer than this coincide; model units. Larger merges details of the model; smaller
    /// finds gaps in joints that only rounding has opened.
    pub distance: f64,
    /// Directions closer than this are parallel; radians. Larger calls a slow bend straight;
    /// smaller calls two computed copies of one direction different.
    pub angle: f64,
}

impl Tolerance {
    /// Suits models measured in millimetres, up to some metres.
    pub const DEFAULT: Self = Self { distance: 1e-6, angle: 1e-9 };

    /// The distance for geometry of a size: never more than [`DETAIL_RELATIVE`] of it.
    #[must_use]
    pub fn distance_for(self, size: f64) -> f64 {
        self.distance.min(DETAIL_RELATIVE * size)
    }

    /// The same angle with another distance.
    #[must_use]
    pub const fn with_distance(self, distance: f64) -> Self {
        Self { distance, ..self }
    }
}

impl Default for Tolerance {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// The document's tolerance counts up to this fraction of the size of what is looked at.
///
/// Larger calls a curve of a few micrometres a closed one, and straight; smaller overrules a
/// tolerance that somebody chose for rough work.
pub const DETAIL_RELATIVE: f64 = 1e-3;

/// Two knots closer than this fraction of the domain are one knot, and a parameter that far
/// outside the domain is its end.
///
/// Larger merges knots that somebody placed on purpose; smaller leaves spans of rounding width,
/// where derivatives are noise, and refuses `c(0.1 * 10)` at the end of 0..1.
pub const KNOT_RELATIVE: f64 = 1e-12;

/// Knots of different splines closer than this fraction of the domain become one where the splines
/// get a common basis.
///
/// Twice the 1e-9 within which other kernels write one knot. Moving a knot moves the spline by a like
/// fraction of its size. Larger moves joints visibly; smaller leaves spans so narrow that
/// second derivatives across them are noise.
pub const KNOT_CLUSTER_RELATIVE: f64 = 2e-9;

/// Two parameters of data closer than this fraction of the domain are one.
///
/// A few times [`KNOT_RELATIVE`], because knots are made between them. Larger refuses data whose
/// spacing varies much; smaller lets knots merge that should each have their own datum.
pub const PARAMETER_RELATIVE: f64 = 1e-11;

/// A control point that the data of a fit hold by less than this fraction of what they hold
/// another by is open.
///
/// Larger refuses data that are dense here and sparse there; smaller lets rounding choose where
/// the control point goes.
pub const RANK_RELATIVE: f64 = 1e-8;

/// Where points may slide along the curve that is fitted to them, the square of an error along it
/// counts by this fraction at least.
///
/// Larger holds points to their parameters; smaller lets the curve run to and fro where its points
/// lie on a line.
pub const SLIDE_RELATIVE: f64 = 1e-3;

/// Two ways to write one curve agree when their points differ by less than this fraction of the
/// largest: in another form, or without a knot where two of them were joined.
///
/// Larger loses a corner that somebody placed on purpose; smaller refuses to convert a curve that
/// went through a few knot insertions and elevations.
pub const EXACT_RELATIVE: f64 = 1e-11;

/// Weights that differ by less than this fraction of the largest are equal: the curve is not
/// rational.
///
/// Larger takes a weight written as 1.000001 for 1; smaller calls a polynomial curve rational
/// after a knot was inserted.
pub const WEIGHT_RELATIVE: f64 = 1e-13;

/// A derivative over the whole domain, or the area of two of them, below this fraction of the
/// control polygon's size (squared for areas) has vanished: its direction is rounding.
///
/// Rounding leaves some 1e-16 of the size. Larger takes slow points for singular ones and strips
/// narrower than this fraction of their length for folds; smaller answers with a random direction
/// at a cusp or a pole.
pub const VANISHING_RELATIVE: f64 = 1e-13;

/// A side of a cell may lean from the lines of the parameters by this part of the cell, where two
/// triangles are told to be one quadrilateral.
///
/// Larger joins triangles to slanted quadrilaterals; smaller leaves triangles along edges whose vertices
/// are a little beside the lines inside.
pub const LEAN_SHARE: f64 = 0.25;

/// A parameter that misses a singular place of a curve by less than this fraction of the span is
/// that place, where its kind is told.
///
/// Larger takes a bend beside an inflection for the inflection; smaller misses one whose parameter
/// somebody computed or typed with nine digits.
pub const PLACE_RELATIVE: f64 = 1e-9;

/// Arc length is computed to this fraction of itself.
///
/// Larger shows in the last digits that a report prints; smaller asks for less than the rounding
/// of the sum, so that the subdivision runs to its ceiling everywhere.
pub const LENGTH_RELATIVE: f64 = 1e-13;

/// Areas and volumes are computed to this fraction of themselves, as far as a cell and its quarters
/// tell; the quarters are much nearer than that.
///
/// Larger shows in the last digits that a report prints; smaller asks for less than the rounding
/// of the sum.
pub const QUADRATURE_RELATIVE: f64 = 1e-12;

/// An area or volume of which less than this fraction may be wrong is told without a word.
///
/// Larger hides a fold that the integral misses; smaller warns of digits that nobody reads.
pub const ACCURACY_WORTH_TELLING: f64 = 1e-9;

/// An integral of which a larger fraction than this may be wrong is refused.
///
/// Larger tells numbers of which not two digits are right; smaller refuses what a warning would do
/// for.
pub const ACCURACY_WORTH_HAVING: f64 = 1e-2;

/// A bounding box stops growing when the rest of the hull sticks out by less than this fraction
/// of the largest coordinate.
///
/// Larger leaves a box that is visibly loose on paper; smaller subdivides where the difference is
/// one rounding.
pub const BOUNDS_RELATIVE: f64 = 1e-15;

/// How far into the domain, as a fraction of it, a normal is looked for at a point that has none.
///
/// Larger tilts the shading around the point; smaller asks where the derivatives are still
/// rounding.
pub const NORMAL_STEP: f64 = 1e-6;

/// A number of steps within this fraction of a whole number is that whole number: `range` reaches
/// its end, and a parameter lies on its step.
///
/// Larger takes a value for a step that it misses; smaller calls 0.3 no multiple of 0.1.
pub const STEP_RELATIVE: f64 = 1e-9;

/// Without a tolerance of its own a mesh may be this fraction of its size away from the surface.
///
/// Larger shows facets on a screen; smaller makes files that nobody asked for.
pub const DEFAULT_CHORD_RELATIVE: f64 = 1e-3;

/// Terms of a normal's expansion at a singular place point one way when their unit vectors are
/// nearer than this.
///
/// Larger gives a ridge the normal of one of its sides; smaller finds no normal at a pole that is
/// round up to the rounding of its control points.
pub const NORMAL_AGREEMENT: f64 = 1e-6;

/// The spline that stands in for a function in questions about all of it agrees with it to this
/// fraction of its size.
///
/// Larger shows in the digits of a length; smaller asks for more digits than functions compute, so
/// that no number of pieces suffices.
pub const STAND_IN_RELATIVE: f64 = 1e-13;

/// A piece of this fraction of a function's domain that no spline comes near is looked at for a
/// place without derivatives.
///
/// Larger looks at pieces that are only too wide; smaller overlooks jumps of second derivatives.
pub const SUSPICIOUS_RELATIVE: f64 = 2e-3;

/// Terms of a Taylor series over the last bits of a parameter that grow by more than this are those
/// of a function without derivatives.
///
/// Larger takes the slope of a square root beside zero for one; smaller takes rounding for it.
pub const UNBOUNDED_RELATIVE: f64 = 1e-3;

/// The box around the surface of a function is known to this fraction of its size.
///
/// Larger shows beside a box that is known otherwise; smaller takes seconds for a few bends.
pub const BOX_RELATIVE: f64 = 1e-8;

/// Beside a place where a function has no derivatives, a spline may miss it by this fraction of its
/// size.
///
/// Larger answers for functions that jump; smaller refuses a square root down to zero.
pub const SINGULAR_RELATIVE: f64 = 1e-6;

/// What is computed of a function's derivatives is followed through its zeros with polynomials that
/// agree with it to this fraction of what it is made of.
///
/// Larger takes a touch for two crossings; smaller follows rounding.
pub const FOLLOWED_RELATIVE: f64 = 1e-11;

/// A normal of a mesh counts as a unit vector when its length is this near to one.
///
/// Larger lets unscaled normals pass; smaller refuses those that a file holds with six digits.
pub const UNIT_SLACK: f64 = 1e-4;

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

/// Triangles that decide what a drawing hides may be this fraction of the whole's size away from
/// their surfaces.
///
/// Larger lets lines show through walls thinner than a few times that; smaller takes longer and
/// shows on no paper.
pub const HIDDEN_RELATIVE: f64 = 2.5e-4;

/// A path of a drawing may be this fraction of the whole's size away from a curve that no cubic
/// can be.
///
/// Larger shows when one zooms in; smaller writes more pieces than anybody sees.
pub const PATH_RELATIVE: f64 = 1e-6;

/// No path, polygon or mesh is asked to be nearer to its curve or surface than this fraction of the
/// largest coordinate.
///
/// Larger shows corners on what is small and far from the origin, and refuses meshes of it; smaller
/// asks for less than the rounding of a point, so that pieces are halved to the ceiling everywhere.
pub const PATH_ROUNDING: f64 = 4e-15;

/// Coordinates of a drawing are rounded to this fraction of its size, unless the script says how.
///
/// Larger moves joints that zooming in shows; smaller writes digits that are rounding.
pub const DRAWING_DIGIT: f64 = 1e-9;

/// Derivatives on both sides of a knot are one where they differ by less than this fraction of the
/// largest along it.
///
/// Larger smooths a slight crease; smaller finds one where rounding is, at every full knot.
pub const SMOOTH_RELATIVE: f64 = 1e-9;

/// Part of a mesh's tolerance within which corners and edges of surfaces are one, at most.
///
/// Larger makes finer triangles for the rest of the tolerance; smaller leaves gaps between
/// surfaces that rounding has moved apart.
pub const WELD_SHARE: f64 = 0.05;

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

/// The distance of an offset times the curvature counts as one within this: a cusp.
///
/// Larger reports cusps where the offset is merely tight; smaller misses those where the curvature
/// peaks at just that value.
pub const CUSP_SLACK: f64 = 1e-9;

/// Beside a place where an offset turns back, its two sides run together for a while: this share of
/// the stretch between two such places is not asked where the offset crosses itself.
///
/// Larger misses crossings close to cusps; smaller takes the cusp for a crossing, and long.
pub const TURN_MARGIN: f64 = 1e-3;

/// An arc whose points keep their distance from the centre to this fraction is circular.
///
/// Larger takes a flat ellipse for a circle; smaller takes none for one after a rotation.
pub const ROUND_RELATIVE: f64 = 1e-13;

/// A spline is a line, circle, plane, cylinder, cone, sphere or torus when it is nowhere further from
/// it than this fraction of its largest coordinate.
///
/// Larger writes what somebody moved on purpose as what it is not; smaller takes none for one after
/// it was turned, elevated and given knots.
pub const ANALYTIC_RELATIVE: f64 = 1e-13;

/// Bernstein coefficients of a product of polynomials below this fraction of the factors' largest
/// ones are rounding: they have no sign.
///
/// Larger overlooks a slight S in a nearly straight curve; smaller finds inflections in a circle.
pub const SIGN_RELATIVE: f64 = 1e-12;

/// A polynomial vector whose length has a minimum below this fraction of its largest value
/// vanishes there.
///
/// A minimum is known to the root of the rounding. Larger calls a tight bend a cusp; smaller
/// misses cusps at parameters that are no round numbers.
pub const TOUCH_RELATIVE: f64 = 1e-7;

/// How far from a place, as a fraction of its span, its two sides are looked at.
///
/// Larger looks past features that lie close together; smaller looks at rounding.
pub const SIDE_STEP: f64 = 1e-4;

/// A search for the nearest point is content when nothing is nearer by more than this fraction of
/// the coordinates.
///
/// Larger answers with a place that is visibly not the nearest; smaller looks at ever smaller parts
/// around it, whose distances differ by rounding.
pub const NEAREST_RELATIVE: f64 = 1e-13;

/// Rounding of a coordinate, as a fraction of it: the last bit of an `f64`.
///
/// Larger takes digits for noise; smaller than this nothing is computed.
pub const LAST_BIT: f64 = f64::EPSILON;

/// Two ways to pair the points of two curves count as equally near when the sums over their
/// products differ by less than this fraction.
///
/// Larger leaves a section that runs against its neighbour; smaller turns sections around whose
/// two directions are one to rounding.
pub const TURN_RELATIVE: f64 = 1e-6;

/// Steps along a path are halved until the frame at its end turns by less than this, radians.
///
/// Larger leaves a twist that a long section shows; smaller asks for more steps than rounding
/// allows.
pub const TURN_ACCURACY: f64 = 1e-10;

/// Ends of pieces of a line on a surface that are nearer than this fraction of the tolerance are one
/// place.
///
/// Larger joins lines that only pass one another; smaller leaves gaps where a patch ends, whose two
/// sides rounding tells apart.
pub const ONE_PLACE_SHARE: f64 = 1e-2;

/// Unit tangents of a line on a surface that differ by less than this make no corner.
///
/// Larger rounds off a slight kink; smaller keeps a triple knot at each end of a patch.
pub const CORNER_RELATIVE: f64 = 1e-4;

/// Part of the tolerance within which surfaces whose normals are parallel touch, and cross only
/// where they part beside that.
///
/// Larger joins curves that pass one another; smaller follows rounding, and needs splines in the
/// place of functions that are nearer still.
pub const CONTACT_SHARE: f64 = 1e-2;

/// Where two surfaces touch they part along two directions; along one in which they do so by less
/// than this fraction of the other they may touch further on.
///
/// Larger follows a line of contact where there is a crossing at a flat angle, and finds that there
/// is none; smaller takes a line of contact that rounding bends for a crossing.
pub const BEND_RELATIVE: f64 = 1e-3;

/// Part of the tolerance within which a spline stands in for a function where light is followed:
/// lines of light move with the normals, which are less near than the points.
///
/// Larger shifts the lines visibly; smaller asks for more patches than anybody sees.
pub const LIGHT_SHARE: f64 = 1e-3;

/// Numbers of two runs of a script that differ by less than this, as a fraction of the larger one or
/// of 1, are one result; whoever keeps results may say otherwise.
///
/// Larger lets a change of the geometry pass unseen; smaller tells of roundings that come out
/// otherwise where an algorithm takes its steps in another order.
pub const SAME_RESULT: f64 = 1e-9;
