//! Conics in which cylinders and cones cross that go around one sphere.
//!
//! With the origin in the middle of a sphere of radius ρ, a cylinder or cone around it, of half angle α (0 of a cylinder)
//! and with the unit vector a towards the apex, is |x|² − ρ² = w², w = (x·a − ρ sin α) / cos α. Two of them therefore
//! share what two planes cut out of either, w₁ = w₂ and w₁ = −w₂, and nothing else; the planes meet in a line, and the
//! conics in its places on the sphere. That is Monge's theorem; Miller & Goldman, *Geometric algorithms for detecting and
//! calculating all conic sections in the intersection of any two natural quadric surfaces*, Graphical Models and Image
//! Processing 57 (1995).

use glam::DVec3;

use super::{AnalyticForm, AnalyticSurface};
use crate::{
    Frame, Interval, NurbsCurve, NurbsSurface, Tolerance,
    curve::join_chain,
    frame::norm,
    sorting::sort_by,
    tolerance::{COAXIAL_SINE, CONTACT_SHARE, INSCRIBED_SHARE},
};

/// A cylinder or cone around a sphere about the origin.
#[derive(Clone, Copy, Debug)]
struct Around {
    /// The radius of the sphere.
    radius: f64,
    /// Towards the apex; of a cylinder either way along the axis.
    axis: DVec3,
    sine: f64,
    cosine: f64,
}

impl Around {
    /// That of a cylinder or cone around the sphere in a place of its axis; none of another form, or beyond the apex.
    fn of(found: &AnalyticSurface, center: DVec3) -> Option<Self> {
        let (radius, half_angle) = match found.form {
            AnalyticForm::Cylinder { radius } => (radius, 0.0),
            AnalyticForm::Cone { radius, half_angle } => (radius, half_angle),
            _ => return None,
        };
        let height = (center - found.frame.origin()).dot(found.frame.z());
        let (sine, cosine) = libm::sincos(half_angle);
        let radius = radius * cosine + height * sine;
        (0.0 < radius).then_some(Self { radius, axis: -found.frame.z(), sine, cosine })
    }

    /// Where w is, as a plane: n and d of w = n·x − d.
    fn plane(&self) -> (DVec3, f64) {
        (self.axis / self.cosine, self.radius * self.sine / self.cosine)
    }
}

impl NurbsSurface {
    /// The conics in which it crosses another cylinder or cone around the same sphere, along N × N of the two, cut where
    /// they meet; none where there is no such sphere, or a border of either is in their way.
    pub(in crate::surface) fn inscribed_crossings(
        &self,
        other: &Self,
        distance: f64,
    ) -> Option<Vec<NurbsCurve>> {
        let forms = [self.analytic(distance)?, other.analytic(distance)?];
        let center = crossing_of_axes(&forms, distance)?;
        let [one, another] =
            [Around::of(&forms[0], center.point)?, Around::of(&forms[1], center.point)?];
        // Beside where they touch a gap is a long way, as along a circle beside its tangent.
        let gap = center.gap + (one.radius - another.radius).abs();
        let radius = 0.5 * (one.radius + another.radius);
        let reach = INSCRIBED_SHARE * distance;
        if reach * reach < gap * radius {
            return None;
        }
        let ((n, d), (m, e)) = (one.plane(), another.plane());
        let planes = [(n - m, d - e), (n + m, d + e)];
        let mut meetings = meetings(planes, radius, distance)?;
        meetings.iter_mut().for_each(|place| *place += center.point);
        let within = Tolerance::DEFAULT.with_distance(distance);
        let mut arcs = Vec::new();
        for (normal, offset) in planes {
            let origin = center.point + normal * (offset / normal.length_squared());
            let plane = Frame::from_normal(origin, normal, None).ok()?;
            let found = self.section(plane, within).ok()?;
            if !(found.touches.is_empty()
                && found.contacts.is_empty()
                && found.uncertain.is_empty())
            {
                return None;
            }
            for conic in found.curves {
                arcs.extend(cut_at(&conic, &meetings, distance)?);
            }
        }
        let mut crossings = Vec::with_capacity(arcs.len());
        for arc in arcs {
            if !other.has_all_of(&arc, [CONTACT_SHARE * distance, distance])? {
                continue;
            }
            let arc = self.directed_across(other, arc)?;
            // Parametrized by about their length, as all that is found of surfaces.
            let length = arc.length(arc.domain());
            crossings.push(arc.reparametrized(Interval::new(0.0, length).ok()?));
        }
        (!crossings.is_empty()).then_some(crossings)
    }
}

/// Where axes cross, and by how much they miss one another.
struct AxisCrossing {
    point: DVec3,
    gap: f64,
}

/// Where the axes of two surfaces cross clearly, within the tolerance.
fn crossing_of_axes(forms: &[AnalyticSurface; 2], distance: f64) -> Option<AxisCrossing> {
    let [one, another] = forms.each_ref().map(|found| found.frame);
    let across = one.z().cross(another.z());
    let sine = norm(across);
    if sine < COAXIAL_SINE {
        return None;
    }
    let way = another.origin() - one.origin();
    let [s, t] = [another.z(), one.z()].map(|axis| way.cross(axis).dot(across) / (sine * sine));
    let [p, q] = [one.origin() + one.z() * s, another.origin() + another.z() * t];
    let gap = p.distance(q);
    (gap <= distance).then_some(AxisCrossing { point: p.midpoint(q), gap })
}

/// The places of a sphere about the origin that two planes n·x = d have in common; nothing where these touch it.
fn meetings(planes: [(DVec3, f64); 2], radius: f64, distance: f64) -> Option<Vec<DVec3>> {
    let [(n, d), (m, e)] = planes;
    let line = n.cross(m);
    let foot = (m.cross(line) * d - n.cross(line) * e) / line.length_squared();
    let away = norm(foot);
    if away.is_nan() || (away - radius).abs() <= distance {
        return None;
    }
    let half = (radius - away) * (radius + away);
    if half < 0.0 {
        return Some(Vec::new());
    }
    let along = line * (libm::sqrt(half) / norm(line));
    Some(vec![foot - along, foot + along])
}

/// The parts of a curve between places on it; none where one is beside it, or beside its end.
fn cut_at(curve: &NurbsCurve, places: &[DVec3], distance: f64) -> Option<Vec<NurbsCurve>> {
    let domain = curve.domain();
    let is_closed = curve.start().distance(curve.end()) <= 0.0;
    let is_end = |place: DVec3| {
        [curve.start(), curve.end()].iter().any(|end| end.distance(place) <= distance)
    };
    let mut cuts = Vec::with_capacity(places.len());
    for &place in places {
        let nearest = curve.closest(place, distance);
        // A border beside the place hides where it is.
        if distance < nearest.distance {
            continue;
        }
        if !is_end(place) {
            cuts.push(nearest.parameter);
        } else if !is_closed {
            return None;
        } else {
            cuts.push(domain.start());
        }
    }
    if cuts.is_empty() {
        return Some(vec![curve.clone()]);
    }
    sort_by(&mut cuts, f64::total_cmp);
    let part = |from: f64, to: f64| curve.trimmed(Interval::new(from, to).ok()?).ok();
    let (first, last) = (cuts[0], cuts[cuts.len() - 1]);
    let mut parts = Vec::with_capacity(cuts.len() + 1);
    for pair in cuts.windows(2) {
        parts.push(part(pair[0], pair[1])?);
    }
    match (is_closed, domain.start() < first) {
        (true, true) => {
            let both = [part(last, domain.end())?, part(domain.start(), first)?];
            parts.push(join_chain(&both, distance).ok()?);
        }
        (true, false) => parts.push(part(last, domain.end())?),
        (false, _) => {
            parts.push(part(last, domain.end())?);
            parts.push(part(domain.start(), first)?);
        }
    }
    Some(parts)
}
