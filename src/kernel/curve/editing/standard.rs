//! The standard form of a rational curve: weight one at both ends.
//!
//! A rational linear change of the parameter moves no point of the curve and multiplies its weights.
//! Piegl & Tiller, *The NURBS Book*, §6.4; Lee & Lucian, *Möbius reparametrizations of rational
//! B-splines*, CAGD 8 (1991).

use crate::{ConstructionReport, GeomError, KnotVector, curve::NurbsCurve};

impl NurbsCurve {
    /// The same points over the same domain, with weight one at both ends.
    ///
    /// With x from 0 to 1 along the domain, s = cx/μ(x) and μ(x) = 1 + (c − 1)x. A weight is divided
    /// by μ at each of the p knots that its control point counts, the last one by cᵖ: c is the p-th
    /// root of the last weight over the first. The curve is clamped first.
    ///
    /// # Errors
    /// `InputError::NotFinite`, and as [`KnotVector::new`] where the weights differ so much that
    /// knots fall together.
    pub fn standard_form(&self) -> Result<Self, GeomError> {
        let curve = self.clamped();
        let (p, domain) = (curve.degree(), curve.domain());
        let points = &curve.control_points;
        let [first, last] = [points[0].w, points[points.len() - 1].w];
        if p == 0 {
            return Ok(curve);
        }
        let c = libm::pow(last / first, 1.0 / p as f64);
        let mu = |u: f64| 1.0 + (c - 1.0) * domain.fraction_of(u);
        let moved = |&u: &f64| match u {
            // At the ends of the domain exactly where they were.
            _ if u <= domain.start() => domain.start(),
            _ if domain.end() <= u => domain.end(),
            _ => domain.at(c * domain.fraction_of(u) / mu(u)),
        };
        let old = curve.knots.as_slice();
        let knots = KnotVector::new(p, old.iter().map(moved).collect())?;
        let n = points.len();
        let control_points = points.iter().enumerate().map(|(i, &point)| {
            let divisor = old[i + 1..=i + p].iter().fold(first, |all, &u| all * mu(u));
            // Both ends weigh exactly one.
            let weight = if i == 0 || i + 1 == n { 1.0 } else { point.w / divisor };
            let share = if i == 0 || i + 1 == n { point.w } else { divisor };
            (point.truncate() / share).extend(weight)
        });
        let control_points = control_points.collect();
        let changed = Self::new(knots, control_points)?;
        Ok(Self { report: ConstructionReport::NONE, ..changed })
    }
}
