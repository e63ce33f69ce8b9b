//! Plane regions: an outer loop and holes, of exact curves.
//!
//! This file has the type, its constructors and what can be read off it; `measure` what can be asked of
//! it, `checks` what its borders must be, `boolean` unions, intersections, differences and even-odd filling, `offset` what lies within a
//! distance, `corner` how a border turns, `fillet` rounded corners, `strips` what integrals over it go along. All that cuts borders is an `arrange::Arrangement`.

mod boolean;
mod cells;
mod checks;
mod corner;
mod error;
mod fillet;
mod measure;
mod offset;
mod strips;

use glam::{DAffine3, DVec3};

use crate::{
    Bounds, Frame, GeomError, InputError, Mesh, MeshError, NurbsCurve, PictureError, Tolerance,
    arrange::{joined, winding_about},
    curve::facing,
    frame::unit,
    planar_mesh, tessellate_curve,
    tolerance::{DETAIL_RELATIVE, FAR_SHARE, LAST_BIT},
};

pub(crate) use cells::{PlaneCell, cells};
pub use error::RegionError;
pub use measure::RegionSide;
pub use offset::CornerStyle;
pub use strips::RegionStrip;

/// How often the chords of a mesh are taken a quarter as far from the borders until they meet no more.
const CLOSER_CHORDS: usize = 6;

/// What lies within a closed plane curve and outside of others, which are holes.
///
/// The normal of the plane points up; of a vertical plane to where y, else x, grows. Seen from its tip
/// the borders run with the region to their left: the outer one counter-clockwise.
///
/// ```
/// use virote_kernel::{CircleForm, Frame, NurbsCurve, Region, Tolerance, glam::DVec3};
///
/// let disc = |x: f64, radius: f64| NurbsCurve::ellipse(Frame::XY.at(DVec3::X * x), [radius; 2], CircleForm::NinePoint);
/// let ring = Region::new(&disc(0.0, 2.0)?, &[disc(0.0, 1.0)?], Tolerance::DEFAULT)?;
/// assert!((ring.area() - 3.0 * std::f64::consts::PI).abs() < 1e-13);
/// // A bite out of it leaves one part, and its border consists of arcs of both.
/// let bite = Region::new(&disc(2.0, 0.5)?, &[], Tolerance::DEFAULT)?;
/// let rest = Region::difference(&[ring, bite], Tolerance::DEFAULT, 1)?;
/// assert_eq!(rest.len(), 1);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// Its plane, z up.
    frame: Frame,
    /// The outer one first; in coordinates of the frame.
    loops: Vec<PlaneLoop>,
}

/// A closed chain of arcs in the plane z = 0.
#[derive(Clone, Debug, PartialEq)]
struct PlaneLoop {
    arcs: Vec<NurbsCurve>,
}

impl Region {
    /// The region within a closed plane curve and outside of others, in whatever sense they run.
    ///
    /// # Errors
    /// [`PictureError::Open`], [`PictureError::OffPlane`], [`PictureError::NoArea`],
    /// [`PictureError::Crossing`] of curves that meet, [`PictureError::Outside`] and
    /// [`PictureError::HoleInHole`], where curve 0 is the outer one; `GeomError::Jump`.
    pub fn new(
        outer: &NurbsCurve,
        holes: &[NurbsCurve],
        tolerance: Tolerance,
    ) -> Result<Self, GeomError> {
        let curves: Vec<&NurbsCurve> = std::iter::once(outer).chain(holes).collect();
        let of = curves.len();
        let distance = tolerance.distance_for(outer.bounds().diagonal());
        let frame = plane_of(outer, 0, of, distance)?;
        let mut loops = Vec::with_capacity(of);
        for (index, curve) in curves.into_iter().enumerate() {
            let border =
                PlaneLoop::of(curve, frame, [index, of], tolerance.with_distance(distance))?;
            let area = border.area();
            if border.is_strip(area, distance) {
                // An eight goes around as much to the left as to the right.
                let alone = Self { frame, loops: vec![border] };
                let refused = match alone.arrangement(distance)?.knot() {
                    Some((vertex, _)) => {
                        let point = frame.point(vertex);
                        PictureError::Crossing { index, other: index, of, point }
                    }
                    None => PictureError::NoArea { index, of },
                };
                return Err(refused.into());
            }
            let is_right = (0.0 < area) == (index == 0);
            loops.push(if is_right { border } else { border.reversed() });
        }
        let region = Self { frame, loops };
        region.check_given_borders(distance)?;
        region.check_nesting()?;
        Ok(region)
    }

    /// The region with these arcs along its borders, in coordinates of a frame, the outer one first: what
    /// [`Self::arcs`] gives.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    pub fn of_arcs(frame: Frame, borders: Vec<Vec<NurbsCurve>>) -> Result<Self, GeomError> {
        let of = borders.len();
        let loops: Vec<PlaneLoop> = borders.into_iter().map(|arcs| PlaneLoop { arcs }).collect();
        if loops.is_empty() || loops.iter().any(|border| border.arcs.is_empty()) {
            return Err(PictureError::NoArea { index: 0, of }.into());
        }
        let distance = Tolerance::DEFAULT.distance_for(loops[0].bounds().diagonal());
        for (index, border) in loops.iter().enumerate() {
            let ends = border.arcs.iter().zip(border.arcs.iter().cycle().skip(1));
            let gap = ends.map(|(arc, next)| arc.end().distance(next.start())).fold(0.0, f64::max);
            if distance < gap {
                return Err(PictureError::Open { index, of, gap }.into());
            }
            let points = border.arcs.iter().flat_map(NurbsCurve::points);
            let by = points.map(|point| point.z.abs()).fold(0.0, f64::max);
            if distance < by {
                return Err(PictureError::OffPlane { index, of, by }.into());
            }
            if (0.0 < border.area()) != (index == 0) {
                return Err(PictureError::NoArea { index, of }.into());
            }
        }
        let region = Self { frame, loops };
        region.check_borders(distance)?;
        region.check_nesting()?;
        Ok(region)
    }

    /// The region with arcs along its borders that are known to be some.
    pub(crate) fn of_known_arcs(frame: Frame, borders: Vec<Vec<NurbsCurve>>) -> Self {
        Self { frame, loops: borders.into_iter().map(|arcs| PlaneLoop { arcs }).collect() }
    }

    /// The plane: its origin is nearest to that of space, or beside the region where that is far away.
    #[must_use]
    pub fn frame(&self) -> Frame {
        self.frame
    }

    /// The border around it, counter-clockwise.
    ///
    /// # Errors
    /// Those of [`crate::join`].
    pub fn outer(&self) -> Result<NurbsCurve, GeomError> {
        self.border(&self.loops[0])
    }

    /// The borders of the holes, clockwise.
    ///
    /// # Errors
    /// Those of [`crate::join`].
    pub fn holes(&self) -> Result<Vec<NurbsCurve>, GeomError> {
        self.loops[1..].iter().map(|border| self.border(border)).collect()
    }

    /// How many holes there are.
    #[must_use]
    pub fn n_holes(&self) -> usize {
        self.loops.len() - 1
    }

    /// The arcs of each border in coordinates of the frame, the outer border first.
    pub fn arcs(&self) -> impl Iterator<Item = &[NurbsCurve]> {
        self.loops.iter().map(|border| &border.arcs[..])
    }

    /// The borders as curves in space, the outer one first.
    ///
    /// # Errors
    /// Those of [`crate::join`].
    pub fn borders(&self) -> Result<Vec<NurbsCurve>, GeomError> {
        self.loops.iter().map(|border| self.border(border)).collect()
    }

    /// The border that a region has along a closed curve, with its parts between corners as those of
    /// [`Self::borders`]: backwards where the region is to the right of the curve. Corners turn by more than an angle.
    ///
    /// # Errors
    /// Those of [`crate::join`]; `LocalError::VanishingTangent` where the curve stands still.
    pub fn border_along(
        curve: &NurbsCurve,
        is_backward: bool,
        angle: f64,
    ) -> Result<NurbsCurve, GeomError> {
        let border = PlaneLoop { arcs: smooth_arcs(curve, angle)? };
        joined(&if is_backward { border.reversed() } else { border }.arcs)
    }

    fn border(&self, border: &PlaneLoop) -> Result<NurbsCurve, GeomError> {
        Ok(joined(&border.arcs)?.transformed(&self.frame.to_space()))
    }

    /// The region mapped.
    ///
    /// # Errors
    /// [`InputError::ZeroAxis`] for a map that leaves no area.
    pub fn transformed(&self, map: &DAffine3) -> Result<Self, GeomError> {
        let to_space = *map * self.frame.to_space();
        let normal = to_space.matrix3.x_axis.cross(to_space.matrix3.y_axis);
        let frame = upward(to_space.translation, normal)?;
        let moved = bounds_of(&self.loops)
            .map(|bounds| bounds.corners().map(|p| to_space.transform_point3(p)));
        let frame = beside(frame, moved.unwrap_or_default());
        let local = frame.from_space() * to_space;
        let mut loops: Vec<PlaneLoop> =
            self.loops.iter().map(|border| border.mapped(&local)).collect();
        if loops[0].area() < 0.0 {
            loops = loops.iter().map(PlaneLoop::reversed).collect();
        }
        Ok(Self { frame, loops })
    }

    /// Its mesh, whose borders are within the tolerance of the curves; closer where chords would meet, as those of
    /// both sides of a sliver.
    ///
    /// # Errors
    /// Those of [`planar_mesh`] and [`tessellate_curve`].
    pub fn mesh(&self, tolerance: f64, distance: f64, most: usize) -> Result<Mesh, GeomError> {
        let mut chord = tolerance;
        for _ in 0..CLOSER_CHORDS {
            match self.mesh_within(chord, distance, most) {
                Err(GeomError::Picture(_)) => chord *= 0.25,
                found => return found,
            }
        }
        self.mesh_within(chord, distance, most)
    }

    fn mesh_within(&self, tolerance: f64, distance: f64, most: usize) -> Result<Mesh, GeomError> {
        let polygon = |border: &PlaneLoop| {
            let mut points = Vec::new();
            for arc in &border.arcs {
                let arc = arc.transformed(&self.frame.to_space());
                points.extend(tessellate_curve(&arc, tolerance, most)?);
                points.pop();
            }
            Ok(points)
        };
        let polygons: Result<Vec<_>, GeomError> = self.loops.iter().map(polygon).collect();
        planar_mesh(&polygons?, distance)
    }
}

impl PlaneLoop {
    /// A closed curve in the plane of a frame; `index` is its number among `of`.
    ///
    /// # Errors
    /// [`MeshError::BelowRounding`]; [`PictureError::Open`], [`PictureError::OffPlane`], [`PictureError::NoArea`].
    fn of(
        curve: &NurbsCurve,
        frame: Frame,
        [index, of]: [usize; 2],
        tolerance: Tolerance,
    ) -> Result<Self, GeomError> {
        curve.check_connected()?;
        // Where its shape is rounding nothing can be told of it.
        let (bounds, finest) = (curve.bounds(), tolerance.distance);
        let rounding = LAST_BIT * bounds.magnitude();
        if finest.max(DETAIL_RELATIVE * bounds.diagonal()) < rounding {
            return Err(MeshError::BelowRounding { tolerance: finest, rounding }.into());
        }
        let gap = curve.start().distance(curve.end());
        if tolerance.distance < gap {
            return Err(PictureError::Open { index, of, gap }.into());
        }
        let local = curve.transformed(&frame.from_space());
        let by = local.points().into_iter().map(|point| point.z.abs()).fold(0.0, f64::max);
        if tolerance.distance < by {
            return Err(PictureError::OffPlane { index, of, by }.into());
        }
        let arcs = smooth_arcs(&flattened(&local), tolerance.angle)?;
        if arcs.is_empty() {
            return Err(PictureError::NoArea { index, of }.into());
        }
        Ok(Self { arcs })
    }

    fn mapped(&self, map: &DAffine3) -> Self {
        Self { arcs: self.arcs.iter().map(|arc| flattened(&arc.transformed(map))).collect() }
    }

    fn reversed(&self) -> Self {
        Self { arcs: self.arcs.iter().rev().map(NurbsCurve::reversed).collect() }
    }

    /// Whether another loop, which does not cross it, is within it.
    ///
    /// # Errors
    /// [`RegionError::Unclear`].
    fn holds(&self, other: &Self) -> Result<bool, GeomError> {
        let own = || std::iter::once(&self.arcs[..]);
        let places = other.arcs.iter().flat_map(|arc| {
            let domain = arc.domain();
            [0.5, 0.25, 0.75].map(|fraction| arc.point_at(domain.at(fraction)))
        });
        // Where they touch in a point rounding may tell either; two places more tell what holds.
        let (mut first, mut lead) = (None, 0_i32);
        for place in places {
            first.get_or_insert(place);
            if let Some(winding) = winding_about(own(), place) {
                lead += if winding == 0 { -1 } else { 1 };
            }
            if 1 < lead.abs() {
                break;
            }
        }
        if lead != 0 {
            return Ok(0 < lead);
        }
        Err(RegionError::Unclear { point: first.unwrap_or(DVec3::ZERO) }.into())
    }
}

/// A curve brought into the plane z = 0.
fn flattened(curve: &NurbsCurve) -> NurbsCurve {
    curve.transformed(&DAffine3::from_scale(DVec3::new(1.0, 1.0, 0.0)))
}

/// The parts of a curve between its corners.
///
/// # Errors
/// `LocalError::VanishingTangent` where it stands still.
pub(crate) fn smooth_arcs(curve: &NurbsCurve, angle: f64) -> Result<Vec<NurbsCurve>, GeomError> {
    if 1 < curve.degree() {
        return curve.smooth_parts(angle);
    }
    let mut points = curve.points();
    points.dedup();
    points.windows(2).map(|pair| NurbsCurve::line(pair[0], pair[1])).collect()
}

/// The plane of a curve that is a border.
fn plane_of(
    curve: &NurbsCurve,
    index: usize,
    of: usize,
    distance: f64,
) -> Result<Frame, GeomError> {
    use crate::{ConstructionError, FormError};
    let plane = curve.plane_across(DVec3::Z, distance).map_err(|error| match error {
        GeomError::Form(FormError::NotPlanar { by }) => {
            PictureError::OffPlane { index, of, by }.into()
        }
        GeomError::Input(InputError::ZeroAxis { .. })
        | GeomError::Construction(ConstructionError::NoTurn) => {
            PictureError::NoArea { index, of }.into()
        }
        other => other,
    })?;
    Ok(beside(plane, curve.bounds().corners()))
}

/// The plane with its origin beside these corners of a box where that is far away: there coordinates would have few
/// digits left for what lies in the box. It is moved by so few digits that they lose none.
fn beside(plane: Frame, corners: [DVec3; 8]) -> Frame {
    let local = corners.map(|corner| plane.from_space().transform_point3(corner));
    let Some(bounds) = Bounds::of(local) else { return plane };
    let size = bounds.diagonal();
    if bounds.magnitude() <= FAR_SHARE * size || !size.is_normal() {
        return plane;
    }
    let step = libm::exp2(libm::log2(size).ceil());
    let origin = (bounds.center().with_z(0.0) / step).round() * step;
    plane.at(plane.point(origin))
}

/// The plane through a point with this normal or its opposite, whichever points up.
///
/// # Errors
/// [`InputError::ZeroAxis`].
fn upward(point: DVec3, normal: DVec3) -> Result<Frame, GeomError> {
    let normal = unit(normal).ok_or(InputError::ZeroAxis { what: "the normal of the plane" })?;
    let normal = facing(normal, DVec3::Z);
    Frame::from_normal(normal * point.dot(normal), normal, None)
}

/// The box around regions, in coordinates of the first one's frame.
fn bounds_of(loops: &[PlaneLoop]) -> Option<Bounds> {
    loops.iter().map(PlaneLoop::bounds).reduce(Bounds::union)
}
