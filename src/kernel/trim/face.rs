//! The type of faces, and what can be read off them.

use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3};

use super::{FaceError, border::KnownBorder, plane::ParameterPlane};
use crate::{
    Bounds, Direction, Frame, GeomError, Grid, KnotVector, LocalError, NurbsCurve, NurbsSurface,
    Region, RegionSide, Tolerance,
};

/// A surface, and the part of it that loops on it bound.
///
/// The loops run with the face to their left, seen from the tip of Su × Sv, which is its front. A face goes
/// over the seam of a closed surface like over any other place.
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{CircleForm, Face, Frame, NurbsCurve, NurbsSurface, Tolerance, glam::DVec3};
///
/// let [o, x, y] = [DVec3::ZERO, DVec3::X * 4.0, DVec3::Y * 4.0];
/// let plate = Arc::new(NurbsSurface::bilinear(o, y, x, x + y)?);
/// // A hole in it: clockwise around it, with what is left to the left.
/// let hole = NurbsCurve::ellipse(Frame::XY.at(DVec3::new(0.5, 0.5, 0.0)), [0.25; 2], CircleForm::NinePoint)?;
/// let face = Face::within(plate, &[hole.reversed()], Tolerance::DEFAULT)?;
/// assert!((face.mass()?.amount - (16.0 - std::f64::consts::PI)).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    pub(super) plane: ParameterPlane,
    /// Where it is, in the plane of parameters; several parts hang together over seams.
    pub(super) parts: Vec<Region>,
    pub(super) border: KnownBorder,
}

/// A connected part of a face's parameters: the curves of parameters along each of its loops, the
/// outer one first, in the plane z = 0 of u and v.
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{Face, Frame, NurbsSurface, Tolerance};
///
/// let face = Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, 1.0)?), Tolerance::DEFAULT)?;
/// let parts = face.parts();
/// assert_eq!((parts.len(), parts[0].loops.len(), parts[0].loops[0].len()), (1, 1, 4));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct FacePart {
    /// The arcs of each loop.
    pub loops: Vec<Vec<NurbsCurve>>,
}

impl Face {
    /// All of a surface.
    ///
    /// # Errors
    /// `GeomError::Jump` of a surface that is not connected.
    pub fn whole(surface: Arc<NurbsSurface>, tolerance: Tolerance) -> Result<Self, GeomError> {
        surface.check_connected()?;
        let distance = tolerance.distance_for(surface.bounds().diagonal());
        let plane = ParameterPlane::of(surface, distance);
        let border = plane.border()?;
        let whole = Region::of_known_arcs(Frame::XY, vec![border]);
        Ok(Self { plane, parts: vec![whole], border: KnownBorder::default() })
    }

    /// What a region holds, on the part of its plane around it; u and v are coordinates of its frame.
    ///
    /// # Errors
    /// Those of [`Self::whole`].
    pub fn of_region(region: &Region, tolerance: Tolerance) -> Result<Self, GeomError> {
        let arcs: Vec<Vec<NurbsCurve>> = region.arcs().map(<[NurbsCurve]>::to_vec).collect();
        let around = arcs.iter().flatten().map(NurbsCurve::bounds).reduce(Bounds::union);
        let Some(around) = around else { return Err(FaceError::Nothing.into()) };
        let ends = [[around.min.x, around.max.x], [around.min.y, around.max.y]];
        let knots = |[start, end]: [f64; 2]| KnotVector::new(1, vec![start, start, end, end]);
        let corner = |i: usize, j: usize| {
            let local = DVec3::new(ends[0][i], ends[1][j], 0.0);
            region.frame().point(local).extend(1.0)
        };
        let net = Grid::from_fn(2, 2, corner);
        let surface = NurbsSurface::new(knots(ends[0])?, knots(ends[1])?, net)?;
        Self::of_parts(Arc::new(surface), &[FacePart { loops: arcs }], tolerance)
    }

    /// The face with these parts of its parameters, as [`Self::parts`] gives them.
    ///
    /// # Errors
    /// [`FaceError::Nothing`] without parts, [`FaceError::OffDomain`] of one that leaves the domain,
    /// [`FaceError::TouchesItself`]; those of [`Region::of_arcs`] and [`Self::whole`].
    pub fn of_parts(
        surface: Arc<NurbsSurface>,
        parts: &[FacePart],
        tolerance: Tolerance,
    ) -> Result<Self, GeomError> {
        let mut face = Self::whole(surface, tolerance)?;
        let distance = face.distance(tolerance);
        let in_plane = |part: &FacePart| {
            let mut borders = Vec::with_capacity(part.loops.len());
            for (index, arcs) in part.loops.iter().enumerate() {
                let arcs: Vec<NurbsCurve> =
                    arcs.iter().map(|arc| face.plane.to_plane(arc)).collect();
                for arc in &arcs {
                    face.check_within_domain(arc, index, distance)?;
                }
                borders.push(arcs);
            }
            Region::of_arcs(Frame::XY, borders).map_err(face.in_space())
        };
        let parts: Vec<Region> = parts.iter().map(in_plane).collect::<Result<_, _>>()?;
        if parts.is_empty() {
            return Err(FaceError::Nothing.into());
        }
        face.parts = parts;
        Ok(face)
    }

    /// The surface of which it is a part.
    #[must_use]
    pub fn surface(&self) -> &Arc<NurbsSurface> {
        &self.plane.surface
    }

    /// The same with its front where its back was: v runs backwards.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let surface = Arc::new(self.plane.surface.reversed(Direction::V));
        let plane = ParameterPlane { surface, ..self.plane.clone() };
        let v = plane.scales[1] * (plane.domains()[1].start() + plane.domains()[1].end());
        let turned = DAffine3 {
            matrix3: DMat3::from_diagonal(DVec3::new(1.0, -1.0, 1.0)),
            translation: DVec3::Y * v,
        };
        let parts = self.parts.iter().map(|part| {
            let back = |arcs: &[NurbsCurve]| {
                arcs.iter().rev().map(|arc| arc.transformed(&turned).reversed()).collect()
            };
            Region::of_known_arcs(Frame::XY, part.arcs().map(back).collect())
        });
        Self { parts: parts.collect(), plane, border: KnownBorder::default() }
    }

    /// Whether it is all of its surface.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        let [part] = &self.parts[..] else { return false };
        let bounds = self.plane.bounds();
        part.n_holes() == 0
            && part.arcs().next().is_some_and(|arcs| {
                let is_corner = |point: DVec3| {
                    let corner = DVec3::new(
                        if point.x <= bounds.min.x { bounds.min.x } else { bounds.max.x },
                        if point.y <= bounds.min.y { bounds.min.y } else { bounds.max.y },
                        0.0,
                    );
                    point == corner
                };
                arcs.len() == 4
                    && arcs.iter().all(|arc| arc.degree() == 1 && is_corner(arc.start()))
            })
    }

    /// The parts of its parameters.
    #[must_use]
    pub fn parts(&self) -> Vec<FacePart> {
        let part = |region: &Region| {
            let loops = region.arcs().map(|arcs| {
                arcs.iter().map(|arc| self.plane.to_parameters(arc)).collect::<Vec<_>>()
            });
            FacePart { loops: loops.collect() }
        };
        self.parts.iter().map(part).collect()
    }

    /// Where parameters are, the border as wide as the tolerance on either side of the curves.
    #[must_use]
    pub fn side_of_parameters(&self, [u, v]: [f64; 2], tolerance: f64) -> RegionSide {
        let place = self.plane.place([u, v]);
        let [domain_u, domain_v] = self.plane.domains();
        if !domain_u.contains(u) || !domain_v.contains(v) {
            return RegionSide::Outside;
        }
        let mut on_border = false;
        for part in &self.parts {
            match part.side_of(place, tolerance) {
                RegionSide::Inside => return RegionSide::Inside,
                RegionSide::Border => on_border = true,
                RegionSide::Outside => {}
            }
        }
        // Both sides of a seam inside: no border is there.
        match on_border {
            true if self.is_on_inner_seam([u, v], tolerance) => RegionSide::Inside,
            true => RegionSide::Border,
            false => RegionSide::Outside,
        }
    }

    /// The point at parameters inside.
    ///
    /// # Errors
    /// [`LocalError::OffFace`].
    pub fn point_at(&self, u: f64, v: f64, tolerance: f64) -> Result<DVec3, GeomError> {
        self.check_inside([u, v], tolerance)?;
        Ok(self.plane.surface.point_at(u, v))
    }

    /// # Errors
    /// [`LocalError::OffFace`].
    pub fn check_inside(&self, [u, v]: [f64; 2], tolerance: f64) -> Result<(), GeomError> {
        match self.side_of_parameters([u, v], tolerance) {
            RegionSide::Outside => Err(LocalError::OffFace { u, v }.into()),
            _ => Ok(()),
        }
    }

    /// The image under an affine map.
    ///
    /// # Errors
    /// `InputError::ZeroAxis` for a map that leaves no area.
    pub fn transformed(&self, map: &DAffine3) -> Result<Self, GeomError> {
        let surface = Arc::new(self.plane.surface.transformed(map));
        let is_closed = self.plane.is_closed;
        let plane = ParameterPlane { is_closed, ..ParameterPlane::of(surface, 0.0) };
        let stretch = [0, 1].map(|i| plane.scales[i] / self.plane.scales[i]);
        let stretch = DAffine3::from_scale(DVec3::new(stretch[0], stretch[1], 1.0));
        let parts = self.parts.iter().map(|part| part.transformed(&stretch));
        let parts = parts.collect::<Result<Vec<_>, _>>()?;
        Ok(Self { plane, parts, border: KnownBorder::default() })
    }

    /// Whether a place at an end of a closed direction is inside on either side of it.
    pub(super) fn is_on_inner_seam(&self, [u, v]: [f64; 2], tolerance: f64) -> bool {
        let beside = 2.0 * tolerance;
        let is_inside = |place: DVec3| {
            self.parts.iter().any(|part| part.side_of(place, 0.0) == RegionSide::Inside)
        };
        let (place, bounds) = (self.plane.place([u, v]), self.plane.bounds());
        (0..2).any(|i| {
            let (low, high) = (bounds.min[i], bounds.max[i]);
            let is_near = place[i] - low <= tolerance || high - place[i] <= tolerance;
            let at = |x: f64| if i == 0 { place.with_x(x) } else { place.with_y(x) };
            self.plane.is_closed[i]
                && is_near
                && is_inside(at(low + beside))
                && is_inside(at(high - beside))
        })
    }
}
