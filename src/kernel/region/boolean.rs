//! Unions, intersections and differences of regions in one plane, and even-odd filling.

use glam::DVec3;

use super::{PlaneLoop, Region, RegionError, bounds_of, plane_of};
use crate::{
    Frame, GeomError, NurbsCurve, Tolerance,
    arrange::{Apart, Arrangement, Ring, Windings},
    box_tree::BoxTree,
    sorting::sort_by,
};

impl Region {
    /// What is in any of the regions: its parts, the largest first.
    ///
    /// # Errors
    /// [`RegionError::OtherPlane`]; [`RegionError::Unclear`] and [`RegionError::Thin`] where borders
    /// come within the tolerance of one another without being one; [`RegionError::TooSmall`] where one is a place.
    pub fn union(
        all: &[Self],
        tolerance: Tolerance,
        n_threads: usize,
    ) -> Result<Vec<Self>, GeomError> {
        let is_inside = |windings: &Windings| windings.iter().any(|&(_, winding)| winding != 0);
        combined(all, is_inside, tolerance, n_threads)
    }

    /// What is in all of the regions: its parts, the largest first; none where there is nothing.
    ///
    /// # Errors
    /// Those of [`Self::union`].
    pub fn intersection(
        all: &[Self],
        tolerance: Tolerance,
        n_threads: usize,
    ) -> Result<Vec<Self>, GeomError> {
        let n = all.len();
        let is_inside = |windings: &Windings| {
            windings.iter().filter(|&&(_, winding)| winding != 0).count() == n
        };
        combined(all, is_inside, tolerance, n_threads)
    }

    /// What is in the first of the regions and in none of the others: its parts, the largest first; none
    /// where there is nothing.
    ///
    /// # Errors
    /// Those of [`Self::union`].
    pub fn difference(
        all: &[Self],
        tolerance: Tolerance,
        n_threads: usize,
    ) -> Result<Vec<Self>, GeomError> {
        let is_inside = |windings: &Windings| {
            let mut around = windings.iter().filter(|&&(_, winding)| winding != 0);
            around.clone().count() == 1 && around.any(|&(group, _)| group == 0)
        };
        combined(all, is_inside, tolerance, n_threads)
    }

    /// What an odd number of the closed curves goes around, which lie in one plane and may cross
    /// themselves and one another: its parts, the largest first.
    ///
    /// # Errors
    /// Those of [`Self::new`] but for crossings and nesting; `IntersectionError::RunsAlongItself`.
    pub fn even_odd(
        curves: &[NurbsCurve],
        tolerance: Tolerance,
        n_threads: usize,
    ) -> Result<Vec<Self>, GeomError> {
        let Some(first) = curves.first() else { return Ok(Vec::new()) };
        let of = curves.len();
        let size = curves.iter().map(NurbsCurve::bounds).reduce(crate::Bounds::union);
        let distance = tolerance.distance_for(size.map_or(0.0, crate::Bounds::diagonal));
        let tolerance = tolerance.with_distance(distance);
        let frame = plane_of(first, 0, of, distance)?;
        let mut rings = Vec::with_capacity(of);
        for (index, curve) in curves.iter().enumerate() {
            let border = PlaneLoop::of(curve, frame, [index, of], tolerance)?;
            rings.push(Ring { group: 0, arcs: border.arcs });
        }
        let arrangement = Arrangement::of(&rings, Apart::Nothing, distance, n_threads)?;
        let is_inside = |windings: &Windings| windings.iter().any(|&(_, winding)| winding % 2 != 0);
        let loops = arrangement.loops(is_inside, n_threads).map_err(in_space(frame))?;
        sorted(loops, frame, distance)
    }

    /// The loops in coordinates of another frame of the same plane.
    fn loops_in(&self, frame: Frame) -> Vec<PlaneLoop> {
        if self.frame == frame {
            return self.loops.clone();
        }
        let local = frame.from_space() * self.frame.to_space();
        self.loops.iter().map(|border| border.mapped(&local)).collect()
    }

    /// How far it is from a plane at most.
    fn distance_from(&self, frame: Frame) -> f64 {
        let corners = self.bounds().corners();
        let apart = |point: DVec3| frame.from_space().transform_point3(point).z.abs();
        // A box in a plane askew reaches out of it: the corners of the plane box are in it.
        let local = bounds_of(&self.loops)
            .map_or(corners, |bounds| bounds.corners().map(|corner| self.frame.point(corner)));
        local.into_iter().map(apart).fold(0.0, f64::max)
    }
}

/// The parts of where `is_inside` holds of how often the regions' borders go around.
fn combined(
    all: &[Region],
    is_inside: impl Fn(&Windings) -> bool + Sync,
    tolerance: Tolerance,
    n_threads: usize,
) -> Result<Vec<Region>, GeomError> {
    let Some(first) = all.first() else { return Ok(Vec::new()) };
    let frame = first.frame;
    let mut rings = Vec::new();
    let mut size = 0.0_f64;
    for (group, region) in all.iter().enumerate() {
        size = size.max(bounds_of(&region.loops).map_or(0.0, crate::Bounds::diagonal));
        let by = region.distance_from(frame);
        if tolerance.distance < by {
            return Err(RegionError::OtherPlane { index: group, by }.into());
        }
        let loops = region.loops_in(frame);
        rings.extend(loops.into_iter().map(|border| Ring { group, arcs: border.arcs }));
    }
    let distance = tolerance.distance_for(size);
    let arrangement =
        Arrangement::of(&rings, Apart::Groups, distance, n_threads).map_err(in_space(frame))?;
    // What is one place within the tolerance would be left out in silence.
    if let Some(point) = arrangement.swallowed {
        let point = frame.point(point);
        return Err(RegionError::TooSmall { point, tolerance: distance }.into());
    }
    let loops = arrangement.loops(is_inside, n_threads).map_err(in_space(frame))?;
    sorted(loops, frame, distance)
}

/// Loops as regions, each hole in the smallest one around it; the largest region first.
pub(super) fn sorted(
    loops: Vec<Vec<NurbsCurve>>,
    frame: Frame,
    distance: f64,
) -> Result<Vec<Region>, GeomError> {
    let (mut outer, mut holes) = (Vec::new(), Vec::new());
    for arcs in loops {
        GeomError::go_on(1)?;
        let border = PlaneLoop { arcs };
        let area = border.area();
        // A strip is as wide as its area over half of its border.
        if border.is_strip(area, 0.5 * distance) {
            let width = 2.0 * area.abs() / border.length();
            let point = frame.point(border.arcs[0].start());
            return Err(RegionError::Thin { point, width, tolerance: distance }.into());
        }
        if 0.0 < area { outer.push((area, border)) } else { holes.push((area, border)) }
    }
    sort_by(&mut outer, |(a, one), (b, other)| {
        let [p, q] = [one, other].map(|border| border.bounds().min);
        b.total_cmp(a).then(p.x.total_cmp(&q.x)).then(p.y.total_cmp(&q.y))
    });
    let tree = BoxTree::new(outer.iter().map(|(_, border)| border.bounds()).collect());
    // Of each part its area, and its borders.
    let mut parts: Vec<(f64, Vec<PlaneLoop>)> =
        outer.into_iter().map(|(area, border)| (area, vec![border])).collect();
    for (area, hole) in holes {
        let bounds = hole.bounds();
        let mut around = None;
        for part in tree.near(bounds, 0.0).into_iter().rev() {
            GeomError::go_on(1)?;
            if tree.bounds(part).holds(bounds, 0.0) && parts[part].1[0].holds(&hole)? {
                around = Some(part);
                break;
            }
        }
        let Some(around) = around else {
            let point = frame.point(hole.arcs[0].start());
            return Err(RegionError::Unclear { point }.into());
        };
        parts[around].0 += area;
        parts[around].1.push(hole);
    }
    // Those before are larger where that is all the same.
    sort_by(&mut parts, |a, b| b.0.total_cmp(&a.0));
    Ok(parts.into_iter().map(|(_, loops)| Region { frame, loops }).collect())
}

/// Places of what was found in a plane, in space.
pub(super) fn in_space(frame: Frame) -> impl Fn(GeomError) -> GeomError {
    move |error| match error {
        GeomError::Region(RegionError::Unclear { point }) => {
            RegionError::Unclear { point: frame.point(point) }.into()
        }
        other => other,
    }
}
