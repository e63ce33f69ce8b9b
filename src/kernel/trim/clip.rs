//! What of curves on the surface of a face lies on the face.

use super::{
    Face,
    division::BORDER,
    pull::{ArcParameters, arcs_on_surface},
};
use crate::{
    GeomError, Interval, NurbsCurve, Region, RegionSide, Tolerance,
    arrange::{Apart, Arrangement, RaySearch, Ring},
    curve::join_chain,
    sorting::sort_by,
    tolerance::PARAMETER_RELATIVE,
};

impl Face {
    /// The parts of curves on the surface that are on the face, its border included, in their order; the curves
    /// may be off by the tolerance.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use virote_kernel::{CircleForm, Face, Frame, NurbsCurve, NurbsSurface, Tolerance, glam::DVec3};
    ///
    /// let [o, x, y] = [DVec3::ZERO, DVec3::X * 4.0, DVec3::Y * 4.0];
    /// let plate = Arc::new(NurbsSurface::bilinear(o, y, x, x + y)?);
    /// let hole = NurbsCurve::ellipse(Frame::XY.at(DVec3::new(2.0, 2.0, 0.0)), [1.0; 2], CircleForm::NinePoint)?;
    /// let face = Face::bounded(plate, &[hole.reversed()], Tolerance::DEFAULT)?;
    /// let line = NurbsCurve::line(DVec3::Y * 2.0, DVec3::new(4.0, 2.0, 0.0))?;
    /// let parts = face.clipped(&[line], Tolerance::DEFAULT)?;
    /// let lengths: Vec<f64> = parts.iter().map(|part| part.length(part.domain())).collect();
    /// assert!(lengths.len() == 2 && lengths.iter().all(|length| (length - 1.0).abs() < 1e-9));
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// `FaceError::OffSurface`; those of an arrangement of plane arcs, in space.
    pub fn clipped(
        &self,
        curves: &[NurbsCurve],
        tolerance: Tolerance,
    ) -> Result<Vec<NurbsCurve>, GeomError> {
        if self.is_whole() {
            return Ok(curves.to_vec());
        }
        let distance = self.distance(tolerance);
        let mut found = Vec::new();
        for (index, curve) in curves.iter().enumerate() {
            let limits = [distance, tolerance.angle];
            let (named, parameters) = (("curve", index), ArcParameters::OfCurve);
            let arcs = arcs_on_surface(&self.plane, curve, None, named, limits, parameters)?;
            let kept = self.intervals_inside(&arcs, distance).map_err(self.in_space())?;
            found.extend(pieces(curve, &kept, distance)?);
        }
        Ok(found)
    }

    /// Whether a place of the surface is on the face, its border included.
    #[must_use]
    pub fn has(&self, parameters: [f64; 2], tolerance: Tolerance) -> bool {
        self.side_of_parameters(parameters, self.distance(tolerance)) != RegionSide::Outside
    }

    /// The intervals of the arcs' parameters over which these are within the face or on its border.
    fn intervals_inside(
        &self,
        arcs: &[NurbsCurve],
        distance: f64,
    ) -> Result<Vec<Interval>, GeomError> {
        let borders = self.parts.iter().flat_map(Region::arcs);
        let mut rings: Vec<Ring> =
            borders.map(|arcs| Ring { group: BORDER, arcs: arcs.to_vec() }).collect();
        let n_border: usize = rings.iter().map(|ring| ring.arcs.len()).sum();
        rings.extend(arcs.iter().map(|arc| Ring { group: BORDER + 1, arcs: vec![arc.clone()] }));
        let arrangement = Arrangement::of(&rings, Apart::Nothing, distance, 1)?;
        let search = RaySearch::of_groups(&arrangement, |group| group == BORDER);
        let mut found = Vec::new();
        for (number, edge) in arrangement.edges.iter().enumerate() {
            let own = edge.passes.iter().any(|&(group, _)| group != BORDER);
            let is_inside = || {
                search.around(number).is_some_and(|sides| {
                    sides.iter().any(|side| {
                        side.iter().any(|&(group, winding)| group == BORDER && winding != 0)
                    })
                })
            };
            if !own || !is_inside() {
                continue;
            }
            match edge.arc.checked_sub(n_border) {
                Some(_) => found.push(edge.interval),
                // An arc of the border runs there.
                None => found.extend(arcs.iter().find_map(|arc| along(arc, &edge.curve, distance))),
            }
        }
        sort_by(&mut found, |a, b| a.start().total_cmp(&b.start()));
        Ok(found)
    }
}

/// The interval of an arc's parameters over which another curve runs along it, by the ends and the middle of that; none if
/// it runs elsewhere.
fn along(arc: &NurbsCurve, other: &NurbsCurve, distance: f64) -> Option<Interval> {
    let domain = other.domain();
    let feet = [0.0, 0.5, 1.0].map(|at| arc.closest(other.point_at(domain.at(at)), distance));
    if feet.iter().any(|foot| 2.0 * distance < foot.distance) {
        return None;
    }
    let [first, middle, last] = feet.map(|foot| foot.parameter);
    let (low, high) = (first.min(last), first.max(last));
    // A closed arc begins and ends in one place, of which its nearest point names either parameter.
    let [start, end] = match middle {
        middle if middle < low => [arc.domain().start(), low],
        middle if high < middle => [high, arc.domain().end()],
        _ => [low, high],
    };
    Interval::new(start, end).ok()
}

/// The parts of a curve over intervals in their order, those that follow one another as one.
fn pieces(
    curve: &NurbsCurve,
    intervals: &[Interval],
    distance: f64,
) -> Result<Vec<NurbsCurve>, GeomError> {
    let domain = curve.domain();
    let slack = PARAMETER_RELATIVE * domain.length();
    let mut joined: Vec<[f64; 2]> = Vec::new();
    for interval in intervals {
        let start = if interval.start() <= domain.start() + slack {
            domain.start()
        } else {
            interval.start()
        };
        let end =
            if domain.end() - slack <= interval.end() { domain.end() } else { interval.end() };
        match joined.last_mut() {
            Some(last) if start <= last[1] + slack => last[1] = last[1].max(end),
            _ => joined.push([start, end]),
        }
    }
    if let [[start, end]] = joined[..]
        && start <= domain.start()
        && domain.end() <= end
    {
        return Ok(vec![curve.clone()]);
    }
    let mut parts = Vec::with_capacity(joined.len());
    for &[start, end] in &joined {
        parts.push(curve.trimmed(Interval::new(start, end)?)?);
    }
    // What goes on over the end of a closed curve is one.
    if let [[start, _], .., [_, end]] = joined[..]
        && start <= domain.start()
        && domain.end() <= end
        && curve.is_closed(distance)
        && let (Some(last), false) = (parts.pop(), parts.is_empty())
    {
        parts[0] = join_chain(&[last, parts[0].clone()], 2.0 * distance)?;
    }
    Ok(parts)
}
