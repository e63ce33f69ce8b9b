//! How much a search or an approximation looks at, or makes, at most.
//!
//! What ends there says so. Fewer refuse what is possible; more keep people waiting for a refusal.

/// Pieces, patches, columns or control points along one direction that one approximation or search
/// may take: a second's work, and far more than what is smooth needs.
pub const PIECES: usize = 4096;

/// Pieces of one span of a low degree whose length is measured; only noise needs more than some
/// hundred, and has no better answer.
pub(crate) const LENGTH_PIECES: usize = 10_000;

/// Cuts for a span, on average, where the tangent turns; a cusp takes some fifty, and more only
/// what turns at random.
pub(crate) const TURN_CUTS: usize = 200;

/// Cuts beyond which an integral over a surface has the accuracy that it has: only one with folds
/// or edges inside of a piece comes here.
pub(crate) const SURFACE_CUTS: usize = 2000;

/// Pieces looked at for one direction of a box. Only a spline that reaches furthest along a whole
/// curve askew to its parameters comes here, and then the box is loose by 1e-8 of its size.
pub(crate) const HULL_PIECES: usize = 20_000;

/// Control points of pairs of pieces of curves that are looked at before the meetings are too many.
pub(crate) const CURVE_PAIR_WORK: usize = 1_600_000;

/// Stretches that two arcs may share before their meetings are too many.
pub(crate) const SHARED_STRETCHES: usize = 1000;

/// Pairs of parts that are looked at before two surfaces, or a curve and a surface, count as
/// running together.
pub(crate) const SURFACE_PAIRS: usize = 200_000;

/// Coefficients of parts of two surfaces that are kept in a search, some 60 MB; further parts are made anew for each part
/// that they are near to.
pub(crate) const KEPT_COEFFICIENTS: usize = 2_000_000;

/// Pairs in which a contact is looked for before it seems that second derivatives do not tell any.
pub(crate) const CONTACT_LOOKS: usize = 4000;

/// Cells that are looked at on all patches before the zeros of a field count as unresolvable.
pub(crate) const CELLS: usize = 400_000;

/// Cells after which such a search is long.
pub(crate) const MANY_CELLS: usize = 4000;

/// Samples of one curve in which surfaces cross.
pub(crate) const TRACE_SAMPLES: usize = 200_000;

/// Samples of one branch of a zero set: what no tolerance above rounding takes.
pub(crate) const BRANCH_SAMPLES: usize = 1 << 18;

/// Places of one line along which surfaces touch.
pub(crate) const CONTACT_PLACES: usize = 5000;

/// Cells that the stand-in of a function of two parameters may take.
pub const STAND_IN_CELLS: usize = 16_384;

/// Patches that an offset may take.
pub(crate) const OFFSET_PATCHES: usize = 1 << 15;

/// Parts that are looked at for a fold: where Su × Sv vanishes without one there are many.
pub(crate) const FOLD_PARTS: usize = 4000;

/// Parts of one piece in which signs of a polynomial are looked for; only rounding has more changes
/// of sign than that.
pub(crate) const SIGN_PARTS: usize = 2000;

/// Products of two coefficients in the square of a surface's polynomials above which it is not
/// looked at: a moment's work.
pub(crate) const QUADRIC_WORK: usize = 100_000_000;

/// Pairs of curves of a network that do not meet of which the distance is looked for.
pub(crate) const DISTANT_PAIRS: usize = 100;

/// Places at which a function of one number is asked for a change of its sign.
pub(crate) const ROOT_LOOKS: usize = 128;

/// Places at which it is asked for all of them.
pub(crate) const ALL_ROOT_LOOKS: usize = 256;

/// Steps towards a root in its bracket: bisection alone needs some sixty.
pub(crate) const ROOT_STEPS: usize = 300;

/// Parts of an interval at whose ends a function is asked for its least value.
pub(crate) const LEAST_LOOKS: usize = 16;

/// The same where the function turns often between them.
pub(crate) const MOST_LEAST_LOOKS: usize = 256;

/// Steps towards a least value; from a valley that is clear it needs some twenty.
pub(crate) const LEAST_STEPS: usize = 100;

/// Pieces of an interval over which a function is integrated.
pub(crate) const INTEGRAL_PIECES: usize = 4000;

/// Places at which an integral over one range looks at its function once more.
pub const INTEGRAL_LOOKS: usize = 200;
/// Those for each range of several, which are asked at all places of one another.
pub const INTEGRAL_LOOKS_OF_SEVERAL: usize = 16;

/// Questions that one integral puts to its function, those of integrals over integrals counted together: some ten seconds.
pub const INTEGRAL_EVALUATIONS: usize = 5_000_000;

/// Steps over which differences are taken for one slope, each half of the one before.
pub(crate) const SLOPE_STEPS: i32 = 10;

/// Steps of one trajectory: a second's work.
pub const TRAJECTORY_STEPS: usize = 50_000;

/// Times that a trajectory is followed with smaller errors in each step, until it stays the same.
pub(crate) const TRAJECTORY_REFINEMENTS: usize = 5;

/// Steps towards least squares, each with as many questions as there are unknowns, twice.
pub(crate) const LEAST_SQUARES_STEPS: usize = 200;

/// Steps towards a least value under conditions, each with one question for gradients: valleys that are a million
/// times as steep across as along take a thousand.
pub(crate) const CONSTRAINED_STEPS: usize = 5000;

/// Steps of these over which the value has to fall.
pub(crate) const STALLED_STEPS: usize = 100;

/// Times that one of these steps is shortened.
pub(crate) const CONSTRAINED_HALVINGS: usize = 40;

/// Times that broken conditions count ten times more where no step leads lower.
pub(crate) const HEAVIER_CONDITIONS: usize = 6;

/// Times that a place beside conditions is led back onto them, each with one question.
pub(crate) const CONDITION_CORRECTIONS: usize = 4;

/// Ever wider brackets in which slopes are asked for the last digits of the place of a least value, at most.
pub(crate) const LEAST_BRACKETS: usize = 6;

/// Steps of Newton's method for the last digits of the place where such a search settled, at most.
pub(crate) const LEAST_REFINEMENTS: usize = 6;

/// Unknowns of such a search whose curvature is looked at where it ends, by half their square of questions at most.
pub(crate) const CURVATURE_UNKNOWNS: usize = 200;

/// Times that such a search goes on from a better place beside its end, such as beside a saddle.
pub(crate) const CONSTRAINED_RESTARTS: usize = 4;

/// Times that such a search begins anew with the sizes that its last place tells.
pub(crate) const CONSTRAINED_ROUNDS: usize = 12;

/// Halvings of the way along which it came, for where the function became level.
pub(crate) const EDGE_HALVINGS: usize = 40;

/// Places within bounds from the best of which such a search begins.
pub(crate) const CONSTRAINED_LOOKS: usize = 32;

/// Parts of an interval of which bounds tell whether they hold a root: a fraction of a second's work.
pub(crate) const PROOF_PIECES: usize = 20_000;

/// Pieces of one curve with its parameters on two surfaces.
pub(crate) const EDGE_PIECES: usize = 100_000;

/// Vertices of the mesh that tells whether a solid crosses itself: below a second's work.
pub(crate) const CROSSING_VERTICES: usize = 200_000;

/// Directions of planes in which faces of two meshes coincide, that are told apart: three are served, and those of one prism.
pub(crate) const COINCIDENT_DIRECTIONS: usize = 64;

/// Strips of a plane in which pieces of edges are looked up.
pub(crate) const RAY_STRIPS: usize = 4096;

/// Places where a function may lack derivatives.
pub(crate) const FUNCTION_BREAKS: usize = 64;

/// Control points, along one direction of a surface, up to which knots are taken away one by one; of more that is seldom
/// worth the time.
pub(crate) const SINGLE_REMOVALS: usize = 64;

/// So many knots that cost least are tried: if none of them can go, another one seldom can.
pub(crate) const KNOTS_TRIED: usize = 16;

/// The same where all spans miss alike, and knots go by more than one at a time.
pub(crate) const BALANCED_KNOTS_TRIED: usize = 4;

/// Pieces along one direction by which the cells of a tessellation are bounded.
pub(crate) const CELL_PIECES: usize = 128;

/// Lines of a function of two parameters along which its derivatives may jump.
pub(crate) const CREASES: usize = 32;

/// Lines across a surface on which the knots of its offset are looked for at first.
pub(crate) const OFFSET_LINES: usize = 17;

/// Places along a direction of an offset beyond which a span has but one.
pub(crate) const OFFSET_PLACES: usize = 128;

/// Even parts of a domain at whose ends points of a quadric are taken.
pub(crate) const QUADRIC_PARTS: usize = 24;

/// Contacts of two surfaces that make up touches in points; more make up areas or lines.
pub(crate) const CONTACTS: usize = 1000;

/// Folds that are told; more are more of the same.
pub(crate) const FOLDS_TOLD: usize = 8;

/// Parts of a surface along one direction that are compared with a mesh.
pub(crate) const DEVIATION_PARTS: usize = 1000;

/// Places of a patch in each direction, at most: more than eight times the degree up to 8.
pub(crate) const PATCH_PLACES: usize = 65;

/// Spans of an arc of which a conic is made.
pub(crate) const CONIC_SPANS: usize = 256;

/// Places within each span of an arc in which the conic is compared at most.
pub(crate) const CONIC_PLACES: usize = 16;

/// Steps towards the least value between kinks, each with one question for gradients.
pub(crate) const KINK_STEPS: usize = 300;

/// Steps of these among which a kink has to be seen.
pub(crate) const KINK_LOOKS: usize = 20;

/// Unknowns of such a search: each of its steps takes work with their third power and more.
pub(crate) const KINK_UNKNOWNS: usize = 60;

/// Planes for each unknown of which such a search keeps the last.
pub(crate) const KINK_PLANES: usize = 3;

/// Times that such a search gives planes up because they contradict one another by rounding.
pub(crate) const KINK_GIVEN_UP: usize = 3;

/// Planes for each unknown by which a place beside kinks is shown to be one of the least; of how many unknowns at most, by
/// gradients and by differences; and how many planes there are in all of more: enough to tell that there is no kink.
pub(crate) const KINK_HULL_PLANES: usize = 4;
pub(crate) const KINK_HULL_UNKNOWNS: [usize; 2] = [16, 12];
pub(crate) const KINK_HULL_FEW: usize = 8;

/// Halvings of a way that does not lead as low as planes promised, and doublings of one that does.
pub(crate) const KINK_HULL_HALVINGS: usize = 30;

/// Steps back to the kinks that a place beside a saddle between them takes.
pub(crate) const KINK_HULL_RETURNS: usize = 3;

/// Last steps of a descent that tell whether its slopes become less.
pub(crate) const SETTLING_STEPS: usize = 8;
