//! Curves near points: of so many control points, or of as few as keep a tolerance.

use glam::DVec3;

use super::{
    Ends, Interpolator, fitted::FittedCurve, interpolate::check_degree, kinks::kinks,
    least::Approximator, parameters::check_loose_parameters, search::FitSearch,
};
use crate::{
    ConstructionReport, GeomError, KnotVector, NurbsCurve, ReportEntry, knots::check_points,
};

/// How often each point may be looked at for a smooth curve across kinks, before corners are made of them.
const LOOKS_ACROSS_KINKS: usize = 10;

/// The curve of `n_control` control points that comes nearest to the points at the parameters,
/// through the first and the last. Its report tells the deviation.
///
/// Least squares over knots that spread the parameters evenly: Piegl & Tiller, *The NURBS Book*,
/// §9.4.1, (9.68) and (9.69); [`KnotVector::spreading`].
///
/// # Errors
/// Those of [`KnotVector::spreading`]; `CountError::WrongCount`; `FitError::Undetermined` many points share few parameters.
pub fn approximate(
    points: &[DVec3],
    parameters: &[f64],
    degree: usize,
    n_control: usize,
) -> Result<NurbsCurve, GeomError> {
    let knots = KnotVector::spreading(degree, n_control, parameters)?;
    let curve = Approximator::new(parameters, knots)?.determined()?.curve(points)?;
    Ok(reporting(curve, points, parameters, &[]))
}

/// A curve with every point within the tolerance, through the first and the last, with as few
/// control points as are found. Its report tells the deviation, the parameters, and the corners.
///
/// Many points are looked at by samples, with knots in places where all spans miss them alike and parameters that begin
/// by affine length. Where that finds no curve, as where points scatter, and for few points, knots are added where points
/// are missed, then spread by what the curve found so needs, then taken away. After each fit the parameters move to the
/// nearest places of the curve unless they are fixed. Where the points turn sharply the curve has a corner, unless one
/// without takes fewer control points. Hoschek & Lasser, *Fundamentals of Computer Aided Geometric
/// Design*, §4.4 (parameter correction); de Boor, *A Practical Guide to Splines*, §XII
/// (spreading); de Boor, Höllig & Sabin, *High accuracy geometric Hermite interpolation*, CAGD 4 (1987) (what sliding
/// gains); Lyche & Mørken, *Knot removal for parametric B-spline curves and surfaces*, CAGD 4
/// (1987).
///
/// Many points of a parabola need three control points:
///
/// ```
/// use virote_kernel::{approximate_within, glam::DVec3};
///
/// let at: Vec<f64> = (0..=40).map(|i| f64::from(i) / 40.0).collect();
/// let points: Vec<DVec3> = at.iter().map(|&t| DVec3::new(t, t * t, 0.0)).collect();
/// let curve = approximate_within(&points, &at, 2, 1e-6, true)?;
/// assert_eq!(curve.control_points().len(), 3);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
///
/// # Errors
/// `DegreeError::BadDegree`, `DegreeError::DegreeTooHigh`; `CountError::CountTooSmall` for degree 0,
/// `CountError::WrongCount`; `InputError::NotFinite`, `FitError::ParametersNotIncreasing`;
/// `FitError::ToleranceNotKept` below the rounding of the coordinates.
pub fn approximate_within(
    points: &[DVec3],
    parameters: &[f64],
    degree: usize,
    tolerance: f64,
    are_fixed: bool,
) -> Result<NurbsCurve, GeomError> {
    check_degree(degree)?;
    check_points(degree, points.len())?;
    check_loose_parameters(parameters, points.len())?;
    let kinks = kinks(points, parameters, tolerance);
    let left = crate::ceiling::FIT_STEPS / if kinks.is_empty() { 1 } else { 2 };
    let are_listed = are_fixed;
    let most = points.len();
    let search =
        |points| FitSearch { points, degree, tolerance, are_fixed, are_listed, most, left };
    if kinks.is_empty() {
        let found = search(points).run(parameters)?;
        return Ok(reporting(found.curve, points, &found.parameters, &[]));
    }

    // With a corner at each kink there are more control points than this.
    let most = degree * (kinks.len() + 1);
    let looks = left.min(LOOKS_ACROSS_KINKS * points.len());
    let mut across = FitSearch { most, left: looks, ..search(points) };
    if let Some(found) =
        across.run_on_balanced_samples(parameters).filter(|f| f.n_control() <= most)
    {
        return Ok(reporting(found.curve, points, &found.parameters, &[]));
    }

    let ends = [&[0], &kinks[..], &[points.len() - 1]].concat();
    let share = |n: usize| left / points.len() * n;
    let part = |pair: &[usize]| {
        let part = pair[0]..=pair[1];
        let (points, parameters) = (&points[part.clone()], &parameters[part]);
        if points.len() <= degree {
            return through(points, parameters, degree);
        }
        let mut search = FitSearch { left: share(points.len()), ..search(points) };
        let trial = search.run_by_thinning(parameters)?;
        Ok((trial.curve, trial.parameters))
    };
    let parts: Vec<(NurbsCurve, Vec<f64>)> =
        ends.windows(2).map(part).collect::<Result<_, GeomError>>()?;
    let corners: Vec<f64> = kinks.iter().map(|&i| parameters[i]).collect();
    let cornered = chained(&parts, degree)?;
    let has_fewer = |smooth: &FittedCurve| {
        smooth.curve.control_points().len() < cornered.control_points().len()
    };
    // What grows to more than twice as many does not come down to fewer.
    let most = 2 * cornered.control_points().len();
    let smooth = FitSearch { most, ..search(points) }.run_by_thinning(parameters);
    match smooth.ok().filter(has_fewer) {
        Some(found) => Ok(reporting(found.curve, points, &found.parameters, &[])),
        None => {
            let moved: Vec<f64> =
                parts.iter().flat_map(|(_, own)| &own[..own.len() - 1]).copied().collect();
            let moved = [&moved[..], &parameters[points.len() - 1..]].concat();
            Ok(reporting(cornered, points, &moved, &corners))
        }
    }
}

/// The polynomial through no more points than the degree.
fn through(
    points: &[DVec3],
    parameters: &[f64],
    degree: usize,
) -> Result<(NurbsCurve, Vec<f64>), GeomError> {
    let polynomial = Interpolator::new(parameters, points.len() - 1, Ends::Averaged)?;
    Ok((polynomial.curve(points)?.elevate_degree(degree)?, parameters.to_vec()))
}

/// Clamped curves of one degree, each of which starts with the last control point and the last
/// parameter of the one before.
fn chained(parts: &[(NurbsCurve, Vec<f64>)], degree: usize) -> Result<NurbsCurve, GeomError> {
    let (mut knots, mut points) = (Vec::new(), Vec::new());
    for (part, _) in parts {
        let own = part.knots().as_slice();
        let is_first = points.is_empty();
        // All copies of the start, then those inside.
        knots.extend_from_slice(&own[usize::from(!is_first)..part.control_points().len()]);
        points.truncate(points.len().saturating_sub(1));
        points.extend_from_slice(part.control_points());
    }
    if let Some((last, _)) = parts.last() {
        knots.extend_from_slice(&last.knots().as_slice()[last.control_points().len()..]);
    }
    NurbsCurve::new(KnotVector::for_points(degree, points.len(), knots)?, points)
}

/// The curve with a report.
fn reporting(
    curve: NurbsCurve,
    points: &[DVec3],
    parameters: &[f64],
    corners: &[f64],
) -> NurbsCurve {
    let (mut worst, mut sum) = ((0.0, parameters[0]), 0.0);
    let mut pairs = points.iter().zip(parameters);
    curve.evaluator().each_point(parameters, |found| {
        let Some((point, &t)) = pairs.next() else { return };
        let miss = found.distance(*point);
        sum += miss;
        if worst.0 < miss {
            worst = (miss, t);
        }
    });
    let mean = sum / points.len() as f64;
    let deviation = ConstructionReport::default()
        .with("max", ReportEntry::Length(worst.0))
        .with("mean", ReportEntry::Length(mean))
        .with("at", worst.1);
    let report = ConstructionReport::of("approximate")
        .with("control_points", curve.control_points().len())
        .with("deviation", deviation)
        .with("corners", corners.to_vec())
        .with("parameters", ReportEntry::Numbers(parameters.into()));
    curve.with_report(report)
}
