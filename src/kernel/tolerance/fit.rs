//! Splines through data and near them.

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

/// [`SLIDE_RELATIVE`] of a search that lets points slide a few times only.
///
/// Larger takes more steps; smaller makes steps that go too far.
pub(crate) const BALANCED_SLIDE_RELATIVE: f64 = 1e-4;

/// A span is taken to miss its points by this share of what the worst one does at least.
///
/// Larger spends knots where none are needed; smaller leaves spans so long that the next curve misses there.
pub(crate) const LEAST_ERROR_SHARE: f64 = 0.02;

/// The least density of knots that are spread by what data or a curve need, as a share of the mean: no
/// part of a curve is left without.
///
/// Larger spends control points where nothing bends; smaller leaves long spans beside short ones, in
/// which a fit swings.
pub(crate) const LEAST_KNOT_DENSITY: f64 = 0.05;

/// Part of the tolerance by which a curve of a network may miss its meetings without a change of
/// parameter.
///
/// Larger uses up what the surface may miss the curve by; smaller changes parameters, and so adds
/// knots, for a rounding.
pub(crate) const UNCHANGED_SHARE: f64 = 1.0 / 16.0;

/// The first pass that removes knots may use this part of the tolerance, each next one four times as
/// much: what costs least goes first.
///
/// Larger removes a knot that costs much before one that costs nothing; smaller makes passes that
/// remove nothing.
pub(crate) const FIRST_REMOVAL_SHARE: f64 = 1.0 / 256.0;

/// With fewer parameters a span than one and this share of the degree's square more, knots that are spread by
/// counting drift against the parameters.
///
/// Larger takes means of parameters for knots where counted ones leave as many in each span; smaller leaves control
/// points to next to nothing.
pub(crate) const SPREADING_SPARE: f64 = 1.0 / 16.0;
