//! Circular arcs as rational curves of degree 2, and the helix.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::{DVec3, DVec4};

use crate::{
    CountError, Frame, GeomError, InputError, Interval, KnotVector,
    curve::NurbsCurve,
    frame::norm,
    tolerance::{KNOT_RELATIVE, LAST_BIT},
};

impl NurbsCurve {
    /// The arc of a circle in the plane of x and y of a frame on 0..1, from the angle `from` on
    /// counter-clockwise over `sweep`, in equal pieces of at most a quarter turn.
    ///
    /// Piegl & Tiller, *The NURBS Book*, A7.1.
    ///
    /// A third of a circle is exact, and as long as it should be:
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use virote_kernel::{Frame, NurbsCurve};
    ///
    /// let arc = NurbsCurve::arc(Frame::XY, 2.0, 0.0, TAU / 3.0)?;
    /// assert!((arc.length(arc.domain()) - 2.0 * TAU / 3.0).abs() < 1e-12);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`InputError::NotPositive`] for a radius or a sweep, [`CountError::TooManyPoints`],
    /// [`InputError::NotFinite`].
    pub fn arc(frame: Frame, radius: f64, from: f64, sweep: f64) -> Result<Self, GeomError> {
        for (what, got) in [("the radius", radius), ("the angle of the arc", sweep)] {
            if !(got.is_finite() && 0.0 < got) {
                return Err(InputError::NotPositive { what, got }.into());
            }
        }
        // A quarter with its rounding is one piece.
        let n_pieces = libm::ceil(sweep / FRAC_PI_2 - KNOT_RELATIVE).max(1.0) as usize;
        check_count(n_pieces.saturating_mul(2).saturating_add(1))?;
        let direction = |k: usize| on_unit_circle(from + sweep * k as f64 / n_pieces as f64);
        let place = |at: DVec3| frame.point(at * radius);
        let mut points = vec![place(direction(0))];
        let mut weights = vec![1.0];
        for k in 0..n_pieces {
            GeomError::go_on(1)?;
            let (start, end) = (direction(k), direction(k + 1));
            let cosine = start.dot(end);
            points.extend([place((start + end) / (1.0 + cosine)), place(end)]);
            weights.extend([libm::sqrt(0.5 * (1.0 + cosine)), 1.0]);
        }
        let inner = (1..n_pieces).flat_map(|k| [k as f64 / n_pieces as f64; 2]);
        let knots = [0.0; 3].into_iter().chain(inner).chain([1.0; 3]).collect();
        Self::rational(KnotVector::new(2, knots)?, &points, &weights)
    }

    /// The arc of a circle from `a` by way of `b` to `c` on 0..1.
    ///
    /// ```
    /// use virote_kernel::{NurbsCurve, glam::DVec3};
    ///
    /// let half = NurbsCurve::arc_through([DVec3::X, DVec3::Y, DVec3::NEG_X], 1e-6)?;
    /// assert!((half.length(half.domain()) - std::f64::consts::PI).abs() < 1e-12);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`InputError::CoincidentPoints`] closer than `distance`; [`InputError::Collinear`] where `b`
    /// is closer than that to the line through the others; [`InputError::NotFinite`].
    pub fn arc_through([a, b, c]: [DVec3; 3], distance: f64) -> Result<Self, GeomError> {
        for (first, second, gap) in [(0, 1, b - a), (1, 2, c - b), (0, 2, c - a)] {
            if norm(gap) <= distance {
                return Err(InputError::CoincidentPoints { first, second }.into());
            }
        }
        // In units of the chord, so that squares of lengths are in range.
        let chord = norm(c - a);
        let (to_b, to_c) = ((b - a) / chord, (c - a) / chord);
        let normal = to_b.cross(to_c);
        if normal.length() * chord <= distance {
            return Err(InputError::Collinear.into());
        }
        let to_center = (normal.cross(to_b) * to_c.length_squared()
            + to_c.cross(normal) * to_b.length_squared())
            / (2.0 * normal.length_squared());
        // The angle at b over the chord is half of what is left of the turn.
        let (back, forth) = (-to_b, to_c - to_b);
        let sweep = 2.0 * libm::atan2(back.cross(forth).length(), -back.dot(forth));
        let frame = Frame::from_normal(a + to_center * chord, normal, Some(-to_center))?;
        let mut arc = Self::arc(frame, norm(to_center) * chord, 0.0, sweep)?;
        let last = arc.control_points.len() - 1;
        arc.control_points[0] = a.extend(1.0);
        arc.control_points[last] = c.extend(1.0);
        Ok(arc)
    }

    /// The helix around the z direction of a frame on 0..1, from `origin + radius·x`
    /// counter-clockwise, `pitch` a turn along z, nowhere further off than `distance`.
    ///
    /// No rational curve is a helix. These are pieces of degree 5 that share point and first two
    /// derivatives with it at their ends. The remainder of that interpolation is at most
    /// radius·angle⁶/(6!·2⁶) in a piece; the parameter is proportional to the angle, so that this
    /// bounds the distance of equal parameters.
    ///
    /// A turn of a helix is as long as the hypotenuse over its unrolled cylinder:
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use virote_kernel::{Frame, NurbsCurve};
    ///
    /// let helix = NurbsCurve::helix(Frame::XY, 1.0, 3.0, 1.0, 1e-6)?;
    /// assert!((helix.length(helix.domain()) - TAU.hypot(3.0)).abs() < 1e-5);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`InputError::NotPositive`] for the radius, the turns or the distance;
    /// [`CountError::TooManyPoints`]; [`InputError::NotFinite`].
    pub fn helix(
        frame: Frame,
        radius: f64,
        pitch: f64,
        turns: f64,
        distance: f64,
    ) -> Result<Self, GeomError> {
        let positive =
            [("the radius", radius), ("the number of turns", turns), ("the tolerance", distance)];
        for (what, got) in positive {
            if !(got.is_finite() && 0.0 < got) {
                return Err(InputError::NotPositive { what, got }.into());
            }
        }
        // Half of the distance is left to rounding.
        let allowed = (0.5 * distance / radius).max(LAST_BIT);
        let step = libm::pow(46080.0 * allowed, 1.0 / 6.0).min(FRAC_PI_2);
        let n_pieces = libm::ceil(turns * TAU / step);
        // As a number of points it may be as good as infinite.
        check_count((6.0 * n_pieces) as usize)?;
        let n_pieces = n_pieces as usize;
        let angle = turns * TAU / n_pieces as f64;
        let piece = |k: usize| {
            let fraction = |k: usize| k as f64 / n_pieces as f64;
            let ends = [k, k + 1].map(|k| on_unit_circle(turns * TAU * fraction(k)));
            let along = |end: DVec3| DVec3::new(-end.y, end.x, 0.0) * (angle / 5.0);
            let inward = |end: DVec3| end * (-angle * angle / 20.0);
            let [start, end] = ends;
            let around = [
                start,
                start + along(start),
                start + along(start) * 2.0 + inward(start),
                end - along(end) * 2.0 + inward(end),
                end - along(end),
                end,
            ];
            let height = |j: usize| pitch * turns * (k as f64 + j as f64 / 5.0) / n_pieces as f64;
            let point = |(j, at): (usize, DVec3)| (at * radius).with_z(height(j));
            let points: Vec<DVec4> = around
                .into_iter()
                .enumerate()
                .map(point)
                .map(|local| frame.point(local).extend(1.0))
                .collect();
            points
        };
        let breaks = Interval::UNIT.steps(n_pieces);
        let pieces = (0..n_pieces).map(piece).collect();
        Self::of_pieces(&breaks, pieces, &vec![3; n_pieces - 1])
    }
}

/// # Errors
/// [`CountError::TooManyPoints`].
fn check_count(got: usize) -> Result<(), GeomError> {
    let most = crate::ceiling::CONTROL_POINTS;
    if got <= most { Ok(()) } else { Err(CountError::TooManyPoints { got, most }.into()) }
}

/// `(cos, sin)` of an angle, exact at whole quarters.
fn on_unit_circle(angle: f64) -> DVec3 {
    let quarters = angle / FRAC_PI_2;
    let nearest = libm::round(quarters);
    if (quarters - nearest).abs() <= 2.0 * LAST_BIT * nearest.abs() {
        return match nearest.rem_euclid(4.0) as u8 {
            0 => DVec3::X,
            1 => DVec3::Y,
            2 => DVec3::NEG_X,
            _ => DVec3::NEG_Y,
        };
    }
    let (sine, cosine) = libm::sincos(angle.rem_euclid(2.0 * PI));
    DVec3::new(cosine, sine, 0.0)
}
