//! Curves on a surface as curves of its parameters.
//!
//! Where a curve runs over a seam or through a pole its parameters jump: there it is cut. Between jumps a
//! polynomial of degree 11, or of 6 where pieces are many, goes through places that were solved for at Chebyshev's points,
//! and a piece is halved until it agrees with the solution between them: far beyond the tolerance, so that areas are
//! those of the true curve. Trefethen, *Approximation Theory and Approximation Practice*, ch. 2 and 8.

use std::f64::consts::PI;

use glam::DVec3;

use super::{FaceError, plane::ParameterPlane};
use crate::{
    FitError, GeomError, Interval, NurbsCurve,
    ceiling::{PARAMETER_HALVINGS, PIECES, SEAM_JUMPS},
    curve::join_pieces,
    frame::norm,
    lagrange,
    tolerance::{PARAMETER_RELATIVE, PULL_RELATIVE, PULL_SHARE, SLOWEST_SHARE, STRAIGHT_REACH},
};

/// The degree of pieces.
const DEGREE: usize = 11;

/// That of the pieces of a curve of many spans, which are short: fewer places are as near.
const SHORT_DEGREE: usize = 6;

/// So many ends of pieces are many.
const MANY_STOPS: usize = 32;

/// Even parts of each span of a curve between which jumps are looked for.
const PARTS: usize = 8;

/// Reaches of the ends of a piece beyond which what is between them is no part of them.
const LOOP_REACH: f64 = 4.0;

/// Last bits of where a surface lies that pieces are given at least.
const PIECE_BITS: f64 = 64.0;

/// Where a piece is compared between the points that it goes through.
pub(super) const COMPARED: [f64; 4] = [0.12, 0.36, 0.64, 0.95];

/// Part of the accuracy that a joint of pieces may use up.
pub(super) const JOINT_SHARE: f64 = 0.125;

/// Newton's method goes no further beside a curve than so many tolerances.
pub(super) const MOST_BESIDE: f64 = 4.0;

/// How far from a second surface a point is, signed, and the direction that leads away from it.
pub(super) type Height<'a> = dyn Fn(DVec3) -> (f64, DVec3) + 'a;

/// How arcs on a surface are parametrized.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ArcParameters {
    /// As the curve is: a parameter of an arc is one of the curve.
    OfCurve,
    /// In any way: straight arcs are lines between two points.
    Any,
}

/// A curve that is followed on a surface.
pub(super) struct PulledCurve<'a> {
    pub(super) plane: &'a ParameterPlane,
    pub(super) curve: &'a NurbsCurve,
    pub(super) height: Option<&'a Height<'a>>,
    pub(super) what: &'static str,
    pub(super) index: usize,
    pub(super) tolerance: f64,
    /// How near pieces come to what is solved for.
    pub(super) accuracy: f64,
    /// That of the plane.
    pub(super) last_bit: f64,
    pub(super) parameters: ArcParameters,
}

/// The arcs in the plane of parameters along a curve that lies on the surface within the tolerance, of the
/// number that is named in errors. With a height the arcs are those where it vanishes, beside the curve.
///
/// # Errors
/// [`FaceError::OffSurface`]; `FitError::NoSplineNear`; those of [`NurbsCurve::smooth_parts`].
pub(super) fn arcs_on_surface(
    plane: &ParameterPlane,
    curve: &NurbsCurve,
    height: Option<&Height<'_>>,
    (what, index): (&'static str, usize),
    [tolerance, angle]: [f64; 2],
    parameters: ArcParameters,
) -> Result<Vec<NurbsCurve>, GeomError> {
    let (size, last_bit) = (plane.surface.bounds().diagonal(), plane.last_bit());
    let accuracy = (PULL_RELATIVE * size).max(PIECE_BITS * last_bit).min(PULL_SHARE * tolerance);
    let mut arcs = Vec::new();
    for part in curve.smooth_parts(angle)? {
        let pulled = PulledCurve {
            plane,
            curve: &part,
            height,
            what,
            index,
            tolerance,
            accuracy,
            last_bit,
            parameters,
        };
        arcs.extend(pulled.arcs()?);
    }
    Ok(arcs)
}

/// A stretch between jumps: its ends with their places in the plane.
pub(super) type Section = [(f64, DVec3); 2];

impl PulledCurve<'_> {
    /// All arcs, in order.
    pub(super) fn arcs(&self) -> Result<Vec<NurbsCurve>, GeomError> {
        if self.parameters == ArcParameters::Any
            && let Some(arcs) = self.arcs_into_pole()?
        {
            return Ok(arcs);
        }
        if let Some(arc) = self.arc_on_plane()? {
            let is_place = self.curve.bounds().diagonal() <= self.tolerance;
            return Ok(if is_place { Vec::new() } else { vec![arc] });
        }
        self.sections()?.into_iter().map(|section| self.fitted(section)).collect()
    }

    /// The place in the plane of the nearest point of the surface.
    fn foot(&self, t: f64) -> Result<DVec3, GeomError> {
        GeomError::go_on(1)?;
        let point = self.curve.point_at(t);
        let foot = self.plane.surface.closest(point);
        if self.tolerance < foot.distance {
            let (what, index, distance) = (self.what, self.index, foot.distance);
            return Err(FaceError::OffSurface { what, index, point, distance }.into());
        }
        Ok(self.plane.place(foot.parameters))
    }

    /// The same where a descent from a place beside it goes; from an end of a closed direction, and where
    /// it ends away from the curve, that of the whole surface.
    fn foot_beside(&self, t: f64, near: DVec3) -> Result<DVec3, GeomError> {
        GeomError::go_on(1)?;
        let surface = &self.plane.surface;
        let foot = surface.foot_from(self.plane.parameters(near), self.curve.point_at(t));
        // Beside a pole a descent hardly moves along it.
        let [_, along_u, along_v] = surface.tangents_at(foot.parameters[0], foot.parameters[1]);
        let slowest =
            (norm(along_u) / self.plane.scales[0]).min(norm(along_v) / self.plane.scales[1]);
        let [u, v] = self.plane.domains();
        let is_at_end = [(u, foot.parameters[0]), (v, foot.parameters[1])]
            .iter()
            .any(|&(domain, t)| t <= domain.start() || domain.end() <= t);
        if is_at_end || slowest < SLOWEST_SHARE || self.tolerance < foot.distance {
            return self.foot(t);
        }
        Ok(self.plane.place(foot.parameters))
    }

    /// The place at a parameter, on the side of the plane where `near` is.
    pub(super) fn place(&self, t: f64, near: DVec3) -> Result<DVec3, GeomError> {
        Ok(self.place_and_rounding(t, near)?.0)
    }

    /// The same, and how far rounding may move it.
    pub(super) fn place_and_rounding(
        &self,
        t: f64,
        near: DVec3,
    ) -> Result<(DVec3, f64), GeomError> {
        let (place, rounding) = match self.crossing_near(t, near) {
            Some(found) => found,
            None => self.improved(t, self.on_side_of(self.foot_beside(t, near)?, near)),
        };
        let mut place = self.on_side_of(place, near);
        // At a pole any parameter along it is as good as another: that of what is beside it is taken.
        let point = self.plane.point(place);
        for i in 0..2 {
            let mut other = place;
            other[i] = near[i];
            if norm(self.plane.point(other) - point) <= self.accuracy {
                place = other;
            }
        }
        Ok((place, rounding))
    }

    /// The stretches between jumps of the parameters.
    fn sections(&self) -> Result<Vec<Section>, GeomError> {
        let spans = self.curve.knots().spans();
        let steps = spans.flat_map(|span| self.curve.knots().span_interval(span).steps(PARTS));
        let mut ts: Vec<f64> = steps.collect();
        ts.dedup();
        let least = PARAMETER_RELATIVE * self.curve.domain().length();
        // An end on a seam goes with what is beside it.
        let inner = self.foot(self.curve.domain().at(0.5 / PARTS as f64))?;
        let first = self.place(ts[0], inner)?;
        let mut start = self.through_pole(first, [ts[0], ts[1]])?.map_or((ts[0], first), |p| p[1]);
        let mut before = start;
        let mut sections = Vec::new();
        let mut todo = ts.clone();
        todo.reverse();
        todo.pop();
        while let Some(t) = todo.pop() {
            let mut here = (t, self.place(t, before.1)?);
            if let Some(&next) = todo.last()
                && let Some((on_seam, depth)) = self.on_seam_beside(here.1, before.1)
                && depth <= self.tolerance
                && !self.is_jump(on_seam, self.place(next, on_seam)?)
            {
                here.1 = on_seam;
            } else if !self.is_jump(before.1, here.1)
                && let Some(dip) = self.dip_between(before, here)?
            {
                todo.push(t);
                todo.push(dip);
                continue;
            }
            let from = before.0;
            // Where seams cross one jump comes close behind another.
            for _ in 0..SEAM_JUMPS {
                let Some((low, high)) = self.jump_between(before, here)? else { break };
                // Up to the last digits of a pole either place is as good, so that a jump seen there comes late.
                let pole = self.through_pole(low.1, [from, t])?;
                let [end, next] = pole
                    .unwrap_or_else(|| [low, high].map(|(t, place)| (t, self.at_border(place))));
                sections.push([start, end]);
                start = next;
                before = next;
                here = (t, self.place(t, next.1)?);
                if pole.is_some() {
                    break;
                }
            }
            before = here;
        }
        let last = [ts[ts.len() - 2], ts[ts.len() - 1]];
        let end = self.through_pole(before.1, last)?.map_or(before, |both| both[0]);
        sections.push([start, end]);
        // What begins or ends beside a seam leaves a crumb behind it, which is one place.
        let mut kept = Vec::with_capacity(sections.len());
        for section in sections {
            let [from, to] = section.map(|(t, _)| t);
            if least < to - from {
                let part = self.curve.trimmed(Interval::new(from, to)?)?;
                if self.tolerance < part.bounds().diagonal() {
                    self.check_beyond_seam(section)?;
                    kept.push(section);
                }
            }
        }
        Ok(kept)
    }

    /// The arc along a stretch.
    fn fitted(&self, [start, end]: Section) -> Result<NurbsCurve, GeomError> {
        if self.parameters == ArcParameters::Any
            && let Some(line) = self.straight([start, end])?
        {
            return Ok(line);
        }
        let mut pieces = Vec::new();
        // At its knots a curve is less smooth than between them.
        let mut stops = vec![start];
        let slack = PARAMETER_RELATIVE * self.curve.domain().length();
        for t in self.curve.knots().breaks() {
            let (last, place) = stops[stops.len() - 1];
            if last + slack < t && t < end.0 - slack {
                stops.push((t, self.place_between(t, place)?.0));
            }
        }
        stops.push(end);
        let stops = self.with_knots(stops)?;
        let degree = if MANY_STOPS < stops.len() { SHORT_DEGREE } else { DEGREE };
        let mut todo = Vec::with_capacity(stops.len());
        for pair in stops.windows(2).rev() {
            todo.push((Interval::new(pair[0].0, pair[1].0)?, pair[0].1, pair[1].1, 0));
        }
        while let Some((interval, first, last, n_halvings)) = todo.pop() {
            GeomError::go_on(1)?;
            let piece = self.piece(interval, [first, last], degree)?;
            let is_near = |&fraction: &f64| -> Result<bool, GeomError> {
                let t = interval.at(fraction);
                let fitted = piece.point_at(t);
                let (place, rounding) = self.place_between(t, fitted)?;
                let apart = norm(self.plane.point(place) - self.plane.point(fitted));
                Ok(apart <= self.accuracy.max(rounding))
            };
            let mut fits = true;
            for fraction in &COMPARED {
                fits = fits && is_near(fraction)?;
            }
            // Where surfaces hardly cross, as beside a junction, places tell no more than the tolerance does.
            let is_short = self.is_within(interval, [first, last], STRAIGHT_REACH * self.tolerance);
            if !fits && is_short {
                pieces.push(lagrange(&[first, last], &[interval.start(), interval.end()])?);
            } else if fits || piece.degree() == 1 {
                pieces.push(piece);
            } else if PARAMETER_HALVINGS <= n_halvings || PIECES <= pieces.len() + todo.len() {
                let (tolerance, parameter) = (self.tolerance, interval.at(0.5));
                return Err(FitError::NoSplineNear { tolerance, parameter }.into());
            } else {
                let [before, behind] = interval.halves();
                let middle = self.place_between(before.end(), first.lerp(last, 0.5))?.0;
                todo.push((behind, middle, last, n_halvings + 1));
                todo.push((before, first, middle, n_halvings + 1));
            }
        }
        match &pieces[..] {
            [piece] => Ok(piece.clone()),
            _ => join_pieces(&pieces, JOINT_SHARE * self.accuracy),
        }
    }

    /// Whether a piece and both of its ends are no further apart than `reach`: of a closed curve the ends alone are.
    fn is_within(&self, interval: Interval, [first, last]: [DVec3; 2], reach: f64) -> bool {
        let start = self.curve.point_at(interval.start());
        let is_beside = |fraction: f64| {
            norm(self.curve.point_at(interval.at(fraction)) - start) <= LOOP_REACH * reach
        };
        norm(last - first) <= reach && COMPARED.into_iter().all(is_beside)
    }

    fn piece(
        &self,
        interval: Interval,
        [first, last]: [DVec3; 2],
        degree: usize,
    ) -> Result<NurbsCurve, GeomError> {
        // Beside a jump the last digits of a parameter tell where it is.
        let is_line = self.is_within(interval, [first, last], PULL_SHARE * self.tolerance);
        if is_line || interval.length() <= PARAMETER_RELATIVE * self.curve.domain().length() {
            return lagrange(&[first, last], &[interval.start(), interval.end()]);
        }
        let mut ts = vec![interval.start()];
        let mut places = vec![first];
        for i in 1..degree {
            let fraction = chebyshev_fraction(i, degree);
            let t = interval.at(fraction);
            ts.push(t);
            places.push(self.place_between(t, first.lerp(last, fraction))?.0);
        }
        ts.push(interval.end());
        places.push(last);
        lagrange(&places, &ts)
    }
}

/// Where between the ends of a piece of a degree the inner places of a number are that it goes through.
pub(super) fn chebyshev_fraction(number: usize, degree: usize) -> f64 {
    0.5 * (1.0 - libm::cos(PI * number as f64 / degree as f64))
}
