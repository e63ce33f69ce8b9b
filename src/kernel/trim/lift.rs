//! Arcs of parameters in space.

use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3};

use super::{Face, conic::conic_of};
use crate::{
    Curve, CurveFunction, Direction, Frame, FunctionFailure, GeomError, Interval, Jet, NurbsCurve,
    NurbsSurface, ParametricCurve, Tolerance,
    curve::join_pieces,
    frame::{norm, unit},
    jet,
    tolerance::{EDGE_SHARE, LAST_BIT, PARAMETER_RELATIVE},
};

/// Parts of each span of an arc whose ends tell whether it is a point.
const SPAN_PARTS: usize = 8;

/// An arc of parameters, in space.
#[derive(Debug)]
struct LiftedArc {
    surface: Arc<NurbsSurface>,
    /// In the plane z = 0 of u and v.
    arc: NurbsCurve,
    /// Where between creases of the surface it lies, by u and v.
    cell: [Interval; 2],
    /// The last bit of the plane.
    rounding: f64,
}

impl CurveFunction for LiftedArc {
    fn derivatives_at(&self, t: f64, order: usize) -> Result<Vec<DVec3>, FunctionFailure> {
        let derivatives = self.arc.derivatives_at(t, order);
        let [domain_u, domain_v] = [self.surface.domain_u(), self.surface.domain_v()];
        let inside = |value: f64, domain: Interval| value.clamp(domain.start(), domain.end());
        let at = [inside(derivatives[0].x, domain_u), inside(derivatives[0].y, domain_v)];
        if order == 0 {
            // Series of no order are the point; what is no number they refuse.
            let point = self.surface.point_within(self.cell, at);
            if point.is_finite() {
                return Ok(vec![point]);
            }
        }
        let lift = || -> Result<[Jet; 3], GeomError> {
            let [u, v, _] = jet::along(&derivatives, &Jet::variable(t, order))?;
            let [u, v] = [u.with_value(at[0]), v.with_value(at[1])];
            jet::across(&self.surface.derivatives_within(self.cell, at, order), &u, &v)
        };
        let point = lift().map_err(FunctionFailure::new)?;
        let of_order = |k| DVec3::from(point.each_ref().map(|jet| jet.derivative(k, 0)));
        Ok((0..=order).map(of_order).collect())
    }

    fn rounding(&self) -> f64 {
        self.rounding
    }
}

impl Face {
    /// An arc of parameters in space as a spline on a domain of the same proportions, within an eighth of a distance.
    ///
    /// # Errors
    /// Those of [`Face::edges`].
    pub(crate) fn lifted_spline(
        &self,
        arc: &NurbsCurve,
        distance: f64,
    ) -> Result<NurbsCurve, GeomError> {
        joined_spline(&self.lifted_parts(arc, distance)?, distance)
    }

    /// The parts of an arc of parameters between creases of the surface, with each in space, where it has a corner there.
    /// What goes over a crease by less than an eighth of a distance ends on it.
    ///
    /// # Errors
    /// Those of [`Face::edges`].
    pub(super) fn lifted_parts(
        &self,
        arc: &NurbsCurve,
        distance: f64,
    ) -> Result<Vec<(NurbsCurve, Curve)>, GeomError> {
        if let Some(exact) = self.lifted_exactly(arc)? {
            return Ok(vec![(arc.clone(), exact.into())]);
        }
        let bounds = arc.bounds();
        let mut places = Vec::new();
        for (i, creases) in self.plane.creases.iter().enumerate() {
            let dust = EDGE_SHARE * distance / self.plane.scales[i];
            let (low, high) = (bounds.min[i] + dust, bounds.max[i] - dust);
            for &crease in creases {
                if low < crease && crease < high {
                    let axis = DVec3::AXES[i];
                    let across = Frame::from_axes(axis * crease, DVec3::AXES[1 - i], DVec3::Z)?;
                    let near = Tolerance::DEFAULT.with_distance(dust);
                    places.extend(arc.plane_parameters(across, near));
                }
            }
        }
        places.sort_by(f64::total_cmp);
        let rounding = self.plane.last_bit();
        let lifted = |part: NurbsCurve| {
            let function = LiftedArc {
                surface: Arc::clone(&self.plane.surface),
                cell: self.cell_of(&part, distance),
                arc: part.clone(),
                rounding,
            };
            let curve = ParametricCurve::new(part.domain(), Arc::new(function))?;
            Ok((part, curve.into()))
        };
        arc.parts_at(&places)?.into_iter().map(lifted).collect()
    }

    /// An arc of parameters in space along a line of constant parameters or on a plane patch, and where it is a conic.
    fn lifted_exactly(&self, arc: &NurbsCurve) -> Result<Option<NurbsCurve>, GeomError> {
        let surface = &self.plane.surface;
        if let Some(map) = affine_map(surface) {
            return Ok(Some(arc.transformed(&map)));
        }
        let (start, end) = (arc.start(), arc.end());
        if arc.degree() == 1 && arc.control_points().len() == 2 {
            for along in Direction::BOTH {
                let [i, across] = match along {
                    Direction::U => [0, 1],
                    Direction::V => [1, 0],
                };
                let domain = surface.domain(along);
                let inside = |t: f64| t.clamp(domain.start(), domain.end());
                let [from, to] = [inside(start[i]), inside(end[i])];
                let is_even = (start[across] - end[across]).abs()
                    <= PARAMETER_RELATIVE * surface.domain(along.other()).length();
                if is_even && let Ok(interval) = Interval::new(from.min(to), from.max(to)) {
                    let other = surface.domain(along.other());
                    let at = start[across].clamp(other.start(), other.end());
                    let line = match along {
                        Direction::U => surface.isocurve_v(at),
                        Direction::V => surface.isocurve_u(at),
                    };
                    let line = line.trimmed(interval)?;
                    return Ok(Some(if from < to { line } else { line.reversed() }));
                }
            }
        }
        Ok(conic_of(surface, arc))
    }

    /// The part of the domain between creases in which an arc of parameters lies, but for an eighth of a distance;
    /// all of it in a direction in which the arc goes over one.
    fn cell_of(&self, arc: &NurbsCurve, distance: f64) -> [Interval; 2] {
        let (bounds, middle) = (arc.bounds(), arc.point_at(arc.domain().at(0.5)));
        let domains = self.plane.domains();
        [0, 1].map(|i| {
            let (domain, ends) = (domains[i], &self.plane.creases[i]);
            let behind = ends.partition_point(|&end| end <= middle[i]);
            let low = behind.checked_sub(1).map_or(domain.start(), |k| ends[k]);
            let high = ends.get(behind).map_or(domain.end(), |&end| end);
            let dust = EDGE_SHARE * distance / self.plane.scales[i];
            let is_inside = low - dust <= bounds.min[i] && bounds.max[i] <= high + dust;
            Interval::new(low, high).ok().filter(|_| is_inside).unwrap_or(domain)
        })
    }
}

/// The map from u and v to a surface on which they are even everywhere.
pub(crate) fn affine_map(surface: &NurbsSurface) -> Option<DAffine3> {
    let net = surface.control_points();
    if [surface.degree_u(), surface.degree_v(), net.n_rows(), net.n_columns()] != [1, 1, 2, 2]
        || surface.is_rational()
    {
        return None;
    }
    let points = surface.points();
    let corner = |i, j| points.get(i, j);
    let (origin, along_u) = (corner(0, 0), corner(1, 0) - corner(0, 0));
    let along_v = corner(0, 1) - origin;
    let skew = (corner(1, 1) - origin - along_u - along_v).abs().max_element();
    if 4.0 * LAST_BIT * surface.bounds().magnitude() < skew {
        return None;
    }
    let (u, v) = (surface.domain_u(), surface.domain_v());
    let (by_u, by_v) = (along_u / u.length(), along_v / v.length());
    let translation = origin - by_u * u.start() - by_v * v.start();
    let matrix3 = DMat3::from_cols(by_u, by_v, DVec3::ZERO);
    Some(DAffine3 { matrix3, translation })
}

/// The map to u and v of a surface on which they are even everywhere, and to how far a place is from its plane.
pub(super) fn parameters_map(surface: &NurbsSurface) -> Option<DAffine3> {
    let DAffine3 { matrix3, translation } = affine_map(surface)?;
    let [by_u, by_v] = [matrix3.x_axis, matrix3.y_axis];
    let normal = unit(by_u.cross(by_v))?;
    let back = DMat3::from_cols(by_u, by_v, normal).inverse();
    let map = DAffine3 { matrix3: back, translation: -(back * translation) };
    map.is_finite().then_some(map)
}

/// The parts of a lifted arc as one spline, within an eighth of a distance.
pub(super) fn joined_spline(
    parts: &[(NurbsCurve, Curve)],
    distance: f64,
) -> Result<NurbsCurve, GeomError> {
    if let [(_, curve)] = parts {
        return spline(curve, distance);
    }
    let piece = |(part, curve): &(NurbsCurve, Curve)| {
        Ok(spline(curve, distance)?.reparametrized(part.domain()))
    };
    let pieces: Vec<NurbsCurve> = parts.iter().map(piece).collect::<Result<_, GeomError>>()?;
    join_pieces(&pieces, EDGE_SHARE * distance)
}

/// A lifted arc as a spline, within an eighth of a distance.
pub(super) fn spline(curve: &Curve, distance: f64) -> Result<NurbsCurve, GeomError> {
    spline_near(curve, EDGE_SHARE * distance)
}

/// A lifted arc as a spline that is no further away than that.
pub(super) fn spline_near(curve: &Curve, deviation: f64) -> Result<NurbsCurve, GeomError> {
    match curve {
        Curve::Nurbs(curve) => Ok((**curve).clone()),
        Curve::Parametric(function) => function.to_nurbs(deviation),
    }
}

/// Whether a lifted arc stays within a distance of where it starts, by places of each of its spans: the approximation that
/// its box comes from would be far nearer than an answer needs.
pub(super) fn is_point(curve: &Curve, arc: &NurbsCurve, distance: f64) -> Result<bool, GeomError> {
    if let Curve::Nurbs(curve) = curve {
        return Ok(curve.bounds().diagonal() <= distance);
    }
    let start = curve.start();
    for span in arc.knots().spans() {
        for t in arc.knots().span_interval(span).steps(SPAN_PARTS) {
            if distance < norm(curve.point_at(t)? - start) {
                return Ok(false);
            }
        }
    }
    Ok(true)
}
