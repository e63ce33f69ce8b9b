//! Geometry as formats of exact splines hold it: clamped B-splines with positive weights that hang
//! together.

use glam::{DVec3, DVec4};

use super::{ExportError, Item, Job, Subject, shape::size};
use crate::kernel::{
    Curve, Direction, Face, FaceEdge, GeomError, Interval, KnotVector, NurbsCurve, NurbsSurface,
    Solid, SolidBody, SolidTopology, Surface, Tolerance, tolerance::PATH_RELATIVE,
};

/// Rounds of halving spans until all weights are positive: the weights of halved pieces near the
/// denominator's values, which are positive, fourfold with each round.
const MAX_ROUNDS: usize = 12;

/// A part of an item.
pub(super) enum Exact {
    Point(DVec3),
    Curve(NurbsCurve),
    Surface(NurbsSurface),
    /// A part of a surface that has such a form.
    Face(NurbsSurface, Vec<FaceLoops>),
}

/// The loops of a connected part of a face, the outer one first.
pub(super) type FaceLoops = Vec<Vec<FaceEdge>>;

/// The parts of an item: one, or several where it jumps. Functions become splines within the
/// tolerance.
pub(super) fn exact(item: &Item, job: &Job) -> Result<Vec<Exact>, ExportError> {
    let blame = |source: GeomError| ExportError::Geometry { name: item.name.clone(), source };
    let tolerance = || -> Result<f64, ExportError> {
        let size = size(job)?;
        Ok(job.options.tolerance.unwrap_or(PATH_RELATIVE * size))
    };
    Ok(match &item.subject {
        Subject::Point(point) => vec![Exact::Point(*point)],
        Subject::Curve(Curve::Nurbs(curve)) => curves(item, curve)?,
        Subject::Curve(Curve::Parametric(function)) => {
            curves(item, &function.to_nurbs(tolerance()?).map_err(blame)?)?
        }
        Subject::Surface(Surface::Nurbs(surface)) => surfaces(item, surface)?,
        Subject::Surface(Surface::Parametric(function)) => {
            surfaces(item, &function.to_nurbs(tolerance()?).map_err(blame)?)?
        }
        Subject::Region(region) => {
            region.borders().map_err(blame)?.into_iter().map(Exact::Curve).collect()
        }
        Subject::Face(face) => face_parts(item, face, job)?,
        Subject::Solid(solid) => {
            let mut parts = Vec::new();
            for face in solid.faces() {
                parts.extend(face_parts(item, face, job)?);
            }
            parts
        }
        Subject::Mesh(_) | Subject::Table(_) | Subject::Data(_) | Subject::Document(_) => {
            Vec::new()
        }
    })
}

/// The surface of a face, with its loops unless it is all of that.
fn face_parts(item: &Item, face: &Face, job: &Job) -> Result<Vec<Exact>, ExportError> {
    let blame = |source: GeomError| ExportError::Geometry { name: item.name.clone(), source };
    if face.is_whole() {
        return surfaces(item, face.surface());
    }
    let mut parts = face.part_edges(tolerance_of(job)).map_err(blame)?;
    for edge in parts.iter_mut().flatten().flatten() {
        edge.parameters = with_positive_weights(item, edge.parameters.clamped())?;
        if let Some(curve) = edge.curve.take() {
            edge.curve = Some(with_positive_weights(item, curve.clamped())?);
        }
    }
    // A face has no jumps: there is one.
    let carriers = surfaces(item, face.surface())?.into_iter();
    let carrier = carriers.filter_map(|part| match part {
        Exact::Surface(surface) => Some(Exact::Face(surface, parts.clone())),
        _ => None,
    });
    Ok(carrier.collect())
}

/// A solid by splines of the same forms.
pub(super) struct ExactSolid {
    /// The surface of each face.
    pub(super) carriers: Vec<NurbsSurface>,
    pub(super) topology: SolidTopology,
    pub(super) bodies: Vec<SolidBody>,
}

pub(super) fn exact_solid(
    item: &Item,
    solid: &Solid,
    job: &Job,
) -> Result<ExactSolid, ExportError> {
    let blame = |source: GeomError| ExportError::Geometry { name: item.name.clone(), source };
    let mut topology = solid.topology(tolerance_of(job)).map_err(blame)?;
    for edge in &mut topology.edges {
        edge.curve = with_positive_weights(item, edge.curve.clamped())?;
    }
    let mut carriers = Vec::with_capacity(solid.faces().len());
    for face in solid.faces() {
        // A face has no jumps: there is one.
        let carrier = surfaces(item, face.surface())?.into_iter();
        carriers.extend(carrier.take(1).filter_map(|part| match part {
            Exact::Surface(surface) => Some(surface),
            _ => None,
        }));
    }
    Ok(ExactSolid { carriers, topology, bodies: solid.bodies(tolerance_of(job)).map_err(blame)? })
}

/// The tolerance of the document.
fn tolerance_of(job: &Job) -> Tolerance {
    Tolerance::DEFAULT.with_distance(job.precision)
}

fn curves(item: &Item, curve: &NurbsCurve) -> Result<Vec<Exact>, ExportError> {
    if curve.degree() == 0 {
        return Ok(curve.points().into_iter().map(Exact::Point).collect());
    }
    let mut parts = Vec::new();
    let mut rest = curve.clamped();
    for at in jumps(curve.knots()) {
        if let Ok([part, behind]) = rest.split(at) {
            parts.push(part);
            rest = behind;
        }
    }
    parts.push(rest);
    parts.into_iter().map(|part| with_positive_weights(item, part).map(Exact::Curve)).collect()
}

fn surfaces(item: &Item, surface: &NurbsSurface) -> Result<Vec<Exact>, ExportError> {
    let mut parts = vec![surface.clamped(Direction::U).clamped(Direction::V)];
    for along in [Direction::U, Direction::V] {
        if surface.knots(along).degree() == 0 {
            let problem = format!("has degree 0 along {}; `elevate` it", along.name());
            return Err(ExportError::Unfit { name: item.name.clone(), problem });
        }
        for at in jumps(surface.knots(along)) {
            let cut = |part: NurbsSurface| match part.split(along, at) {
                Ok(parts) => parts.to_vec(),
                Err(_) => vec![part],
            };
            parts = parts.into_iter().flat_map(cut).collect();
        }
    }
    let positive = |part| surface_with_positive_weights(item, part).map(Exact::Surface);
    parts.into_iter().map(positive).collect()
}

/// The knots inside the domain where a spline may jump.
fn jumps(knots: &KnotVector) -> Vec<f64> {
    let domain = knots.domain();
    let is_jump = |&(at, times): &(f64, usize)| {
        knots.degree() < times && domain.start() < at && at < domain.end()
    };
    knots.distinct().into_iter().filter(is_jump).map(|(at, _)| at).collect()
}

/// The same curve, with knots in the middle of its spans until no weight is zero or negative.
pub(super) fn with_positive_weights(
    item: &Item,
    mut curve: NurbsCurve,
) -> Result<NurbsCurve, ExportError> {
    for _ in 0..MAX_ROUNDS {
        if are_positive(curve.control_points().iter()) {
            return Ok(curve);
        }
        curve = curve.insert_knots(&middles(curve.knots())).map_err(|_| unfit(item))?;
    }
    Err(unfit(item))
}

fn surface_with_positive_weights(
    item: &Item,
    mut surface: NurbsSurface,
) -> Result<NurbsSurface, ExportError> {
    for _ in 0..MAX_ROUNDS {
        if are_positive(surface.control_points().iter()) {
            return Ok(surface);
        }
        for along in [Direction::U, Direction::V] {
            let knots = middles(surface.knots(along));
            surface = surface.insert_knots(along, &knots).map_err(|_| unfit(item))?;
        }
    }
    Err(unfit(item))
}

fn are_positive<'a>(mut points: impl Iterator<Item = &'a DVec4>) -> bool {
    points.all(|point| 0.0 < point.w)
}

fn middles(knots: &KnotVector) -> Vec<f64> {
    let middle = |interval: Interval| interval.at(0.5);
    knots.spans().map(|span| middle(knots.span_interval(span))).collect()
}

fn unfit(item: &Item) -> ExportError {
    let problem = "has weights of zero or below that stay when knots are inserted".to_owned();
    ExportError::Unfit { name: item.name.clone(), problem }
}
