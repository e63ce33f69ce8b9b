//! What a solid is made of, counted and measured.

use super::{EdgeAngles, Solid, SolidEdge, box_around};
use crate::{
    Face, GeomError, SurfaceCurve, Tolerance, ceiling::VOLUME_REFINEMENTS, mesh::check_rounding,
};

/// Tolerances of which each is so many times finer than the one before, where edges are compared for a better bound.
const FINER: f64 = 10.0;

/// What a solid is made of.
///
/// ```
/// use std::{f64::consts::PI, sync::Arc};
/// use virote_kernel::{Face, Frame, NurbsSurface, Solid, Tolerance};
///
/// let ring = Arc::new(NurbsSurface::torus(Frame::XY, 3.0, 1.0)?);
/// let ring = Solid::new(&[Face::whole(ring, Tolerance::DEFAULT)?], Tolerance::DEFAULT)?;
/// let found = ring.contents(Tolerance::DEFAULT)?;
/// assert_eq!((found.n_faces, found.n_shells, found.n_bodies, found.genus), (1, 1, 1, 1));
/// assert!((found.volume - 6.0 * PI * PI).abs() <= found.volume_error);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidContents {
    /// How many faces it has.
    pub n_faces: usize,
    /// The edges that faces have in common, without seams, each once.
    pub n_edges: usize,
    /// The places where these end.
    pub n_vertices: usize,
    /// Closed sets of faces.
    pub n_shells: usize,
    /// Shells that are no voids.
    pub n_bodies: usize,
    /// How many handles it has, all shells together.
    pub genus: i64,
    /// How much it encloses, cubed model units.
    pub volume: f64,
    /// How far that may be off: by what is known of the integral, and by what faces may miss one another within the
    /// tolerance along their edges.
    pub volume_error: f64,
    /// The area of all faces, squared model units.
    pub area: f64,
    /// The length of the shortest edge, model units; none without edges.
    pub least_edge: Option<f64>,
    /// The sharpest angle between faces along an edge, inside or outside, radians; none without edges.
    pub least_angle: Option<f64>,
    /// A bound of how far an edge is from its faces at most, model units; none where there is no bound.
    pub deviation: Option<f64>,
    /// How far ends of edges that are one vertex are apart at most, model units.
    pub welded: f64,
}

impl Solid {
    /// What it is made of.
    ///
    /// Beside an edge faces may leave a strip no wider than twice the tolerance, through which the flux is no more
    /// than its area times how far it is from the middle.
    ///
    /// # Errors
    /// Those of [`Self::topology`] and [`Self::volume_mass`].
    pub fn contents(&self, tolerance: Tolerance) -> Result<SolidContents, GeomError> {
        let topology = self.topology(tolerance)?;
        let around = box_around(&self.faces);
        let mut is_end = vec![false; topology.vertices.len()];
        let (mut lengths, mut deviation) = (Vec::new(), Some(0.0_f64));
        let mut least_angle: Option<f64> = None;
        for edge in &topology.edges_between_faces(tolerance)? {
            edge.vertices.into_iter().for_each(|end| is_end[end] = true);
            lengths.push(edge.curve.length(edge.curve.domain()));
        }
        for edge in topology.edges.iter().filter(|edge| !edge.is_seam()) {
            let own = self.edge_deviation(edge, tolerance);
            deviation = deviation.zip(own).map(|(known, own)| known.max(own));
            let sharpest = edge.angles(&self.faces).map(EdgeAngles::sharpest);
            least_angle = least_angle.into_iter().chain(sharpest).reduce(f64::min);
        }
        let volume = self.volume_mass()?;
        let strips = tolerance.distance_for(around.diagonal()) * self.flux_beside(&lengths);
        Ok(SolidContents {
            n_faces: self.faces.len(),
            n_edges: lengths.len(),
            n_vertices: is_end.into_iter().filter(|&is_end| is_end).count(),
            n_shells: self.shells.len(),
            n_bodies: self.bodies(tolerance)?.len(),
            genus: topology.genus(),
            volume: volume.amount,
            volume_error: volume.relative_error * volume.amount + strips,
            area: self.area_mass()?.amount,
            least_edge: lengths.into_iter().reduce(f64::min),
            least_angle,
            deviation,
            welded: topology.welded,
        })
    }

    /// A bound of how far the volume may be off, no better than wanted: that of [`SolidContents`], or of finer tolerances
    /// as long as the faces close within these as well.
    ///
    /// ```
    /// use virote_kernel::{Frame, NurbsCurve, Region, Solid, Tolerance, glam::DVec3};
    ///
    /// let [o, x, y] = [DVec3::ZERO, DVec3::X, DVec3::Y];
    /// let triangle = Region::new(&NurbsCurve::polyline(&[o, x, y, o])?, &[], Tolerance::DEFAULT)?;
    /// let prism = Solid::extruded(&triangle, DVec3::Z, Tolerance::DEFAULT)?;
    /// assert!(1e-6 < prism.contents(Tolerance::DEFAULT)?.volume_error);
    /// assert!(prism.volume_error_within(1e-10, Tolerance::DEFAULT)? <= 1e-10);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Self::edges`] and [`Self::volume_mass`]; `GeomError::Ended`.
    pub fn volume_error_within(&self, wanted: f64, tolerance: Tolerance) -> Result<f64, GeomError> {
        let around = box_around(&self.faces);
        let lengths: Vec<f64> = self
            .edges(tolerance)?
            .iter()
            .map(|edge| edge.curve.length(edge.curve.domain()))
            .collect();
        let (volume, beside) = (self.volume_mass()?, self.flux_beside(&lengths));
        let of_integral = volume.relative_error * volume.amount;
        let error = |distance: f64| of_integral + distance * beside;
        let closes = |distance: f64| -> Result<bool, GeomError> {
            GeomError::go_on(1)?;
            let is_told = check_rounding(distance, around.magnitude()).is_ok();
            let finer = tolerance.with_distance(distance);
            Ok(is_told && Face::enclosed_volume(&self.faces, finer).is_ok())
        };
        let mut known = tolerance.distance_for(around.diagonal());
        // Half of it, so that rounding does not matter.
        let enough = 0.5 * (wanted - of_integral) / beside;
        if error(known) <= wanted {
            return Ok(error(known));
        }
        if 0.0 < enough && closes(enough)? {
            return Ok(error(enough));
        }
        for _ in 0..VOLUME_REFINEMENTS {
            let finer = known / FINER;
            if finer <= enough || !closes(finer)? {
                break;
            }
            known = finer;
        }
        Ok(error(known))
    }

    /// The most that the flux through strips beside edges of these lengths is for each unit of the distance within
    /// which faces close there.
    fn flux_beside(&self, lengths: &[f64]) -> f64 {
        let reach = 0.5 * box_around(&self.faces).diagonal();
        2.0 * lengths.iter().sum::<f64>() * reach / 3.0
    }

    /// A bound of how far an edge is from both of its faces; none where there is none.
    fn edge_deviation(&self, edge: &SolidEdge, tolerance: Tolerance) -> Option<f64> {
        let surfaces = edge.faces.map(|face| &**self.faces[face].surface());
        let sizes = surfaces.map(|surface| surface.bounds().diagonal());
        let distance = tolerance.distance_for(sizes[0].min(sizes[1]));
        let found = SurfaceCurve::of(&edge.curve, surfaces, distance).ok()?;
        Some(found.deviation).filter(|deviation| deviation.is_finite())
    }
}
