//! Which of several surfaces and faces must turn so that all look alike.

use std::sync::Arc;

use super::{
    Face,
    border_edge::{FaceBorderEdge, NeighbourSearch},
    joined::SurfacePiece,
    measure::{arm, flux},
    shell::hanging_together,
};
use crate::{
    Bounds, GeomError, MeasureError, NurbsCurve, Surface, Tolerance, facing_unlike,
    surface::{IntegralValues, ONE_MOMENT, integral},
};

/// For each surface and face, whether it must turn over so that those that hang together look alike: outward where
/// they close, otherwise as the first of them.
///
/// The half of a ball with its floor, of which both look up:
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{
///     CircleForm, Cutter, Face, Frame, NurbsCurve, NurbsSurface, Region, SurfacePiece, Tolerance, glam::DVec3,
///     pieces_facing_unlike,
/// };
///
/// let within = Tolerance::DEFAULT;
/// let sphere = Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, 1.0)?), within)?;
/// let dome = sphere.part_at(&[Cutter::Plane(Frame::XY)], DVec3::Z, within)?;
/// let rim = NurbsCurve::ellipse(Frame::XY, [1.0; 2], CircleForm::NinePoint)?;
/// let floor = Face::of_region(&Region::new(&rim, &[], within)?, within)?;
/// let turns = pieces_facing_unlike(&[SurfacePiece::Part(&dome), SurfacePiece::Part(&floor)], within)?;
/// assert_eq!(turns, [false, true]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
///
/// # Errors
/// `FaceError::CrowdedShell`, `FaceError::OneSided`; without faces those of [`facing_unlike`]; as
/// [`Surface::point_at`].
pub fn pieces_facing_unlike(
    pieces: &[SurfacePiece<'_>],
    tolerance: Tolerance,
) -> Result<Vec<bool>, GeomError> {
    let surface = |piece: &SurfacePiece<'_>| match piece {
        SurfacePiece::Whole(surface) => Some((*surface).clone()),
        SurfacePiece::Part(_) => None,
    };
    let surfaces: Option<Vec<Surface>> = pieces.iter().map(surface).collect();
    if let Some(surfaces) = surfaces {
        return facing_unlike(&surfaces, tolerance);
    }
    let boxes = pieces.iter().map(SurfacePiece::bounds).collect::<Result<Vec<_>, _>>()?;
    let Some(whole) = boxes.into_iter().reduce(Bounds::union) else { return Ok(Vec::new()) };
    let distance = tolerance.distance_for(whole.diagonal());
    let mut edges = Vec::new();
    for (number, piece) in pieces.iter().enumerate() {
        let own = piece.edges(distance, tolerance)?;
        edges.extend(own.into_iter().map(|curve| FaceBorderEdge::new(number, curve)));
    }

    // Find what hangs together, and which pieces have an edge without a neighbour.
    let (mut pairs, mut is_open) = (Vec::new(), vec![false; pieces.len()]);
    let search = NeighbourSearch::new(&edges, distance);
    for (i, edge) in edges.iter().enumerate() {
        for pair in search.neighbours(i)? {
            match pair {
                Ok(pair) => pairs.push(pair),
                Err(_) => is_open[edge.face] = true,
            }
        }
    }
    let mut turns = vec![false; pieces.len()];
    for shell in hanging_together(pieces.len(), &pairs)? {
        let mut outward = 0.0;
        if shell.iter().all(|&(piece, _)| !is_open[piece]) {
            for &(piece, sign) in &shell {
                outward += sign * pieces[piece].flux(whole)?;
            }
        }
        if !f64::is_finite(outward) {
            return Err(MeasureError::TooLargeToMeasure { what: "volume" }.into());
        }
        for (piece, sign) in shell {
            turns[piece] = (sign < 0.0) != (outward < 0.0);
        }
    }
    Ok(turns)
}

impl SurfacePiece<'_> {
    fn bounds(&self) -> Result<Bounds, GeomError> {
        match self {
            Self::Whole(surface) => surface.bounds(),
            Self::Part(face) => Ok(face.surface().bounds()),
        }
    }

    /// Its edges with it to their left; those of a function within half of the distance.
    fn edges(&self, distance: f64, tolerance: Tolerance) -> Result<Vec<NurbsCurve>, GeomError> {
        match self {
            Self::Part(face) => face.edges(tolerance),
            Self::Whole(Surface::Nurbs(surface)) => {
                Face::whole(Arc::clone(surface), tolerance)?.edges(tolerance)
            }
            Self::Whole(surface @ Surface::Parametric(_)) => {
                let mut edges = Vec::new();
                // It is to the left of the last u and of the first v.
                for (number, curve) in surface.edges()?.into_iter().enumerate() {
                    let curve = curve.nurbs_within(0.5 * distance)?;
                    if 2.0 * distance < curve.bounds().diagonal() {
                        let is_left = number == 1 || number == 2;
                        edges.push(if is_left { (*curve).clone() } else { curve.reversed() });
                    }
                }
                Ok(edges)
            }
        }
    }

    /// The flux through it of the way from the middle of a box.
    fn flux(&self, whole: Bounds) -> Result<f64, GeomError> {
        let about = whole.center();
        let density = |point, normal| flux(arm(point, about), normal);
        let IntegralValues { values: [flux], .. } = match self {
            Self::Whole(surface) => integral(surface, ONE_MOMENT, density)?,
            Self::Part(face) => face.integral(ONE_MOMENT, density)?,
        };
        Ok(flux)
    }
}
