//! Questions about one place, answered by the kernel: never by the mesh.

use std::sync::Arc;

use serde_json::{Value as Json, json};

use super::{
    Answer, Known,
    answers::{Fact, Units, number_of},
    ceilings::within_ceilings,
    scene::Shape,
};
use crate::{
    kernel::{Curve, Side, Surface, Tolerance},
    limits::stack,
    session::Session,
};

/// What the surface `item` is at `u`, `v`, the curve `item` at `t`; where the `vertex` of a mesh or of points is.
pub(crate) fn ask(body: &Json, known: &Known, session: &Session) -> Answer {
    let key = body["item"].as_str().ok_or("`item` must be a key")?;
    let at = |name: &str| number_of(body, name);
    let (item, report) = known.item(key).ok_or("the item is not known any more")?;
    let report = report.ok_or("there is no model yet")?;
    let place = AskedPlace {
        path: format!("{}{}", report.definitions[item.definition].name, item.piece.path),
        definition: &report.definitions[item.definition].name,
        units: Units::of(report),
        tolerance: report.document.1,
    };
    // Functions of the script need the stack of an evaluation.
    stack::with(session.limits().stack_bytes, |_| match &item.piece.shape {
        Shape::Surface(surface) => {
            let (u, v) = (at("u")?, at("v")?);
            within_ceilings(session, || place.surface(surface, u, v))
        }
        Shape::Face(face) => {
            let (u, v) = (at("u")?, at("v")?);
            let surface = Surface::Nurbs(Arc::clone(face.surface()));
            within_ceilings(session, || place.surface(&surface, u, v))
        }
        Shape::Curve(curve) => {
            let t = at("t")?;
            within_ceilings(session, || place.curve(curve, t))
        }
        Shape::Mesh(mesh) => place.vertex(mesh.vertices(), at("vertex")?),
        Shape::Points(points) => place.vertex(points, at("vertex")?),
        shape => Err(format!("a {} is asked for no place", shape.kind())),
    })
}

/// What is asked, and how it is told.
struct AskedPlace<'a> {
    path: String,
    definition: &'a str,
    units: Units,
    tolerance: Tolerance,
}

impl AskedPlace<'_> {
    fn surface(&self, surface: &Surface, u: f64, v: f64) -> Result<Json, crate::kernel::GeomError> {
        let (u, v) = (surface.domain_u().clamp_inside(u)?, surface.domain_v().clamp_inside(v)?);
        let point = surface.point_at(u, v)?;
        let normal = surface.normal_at(u, v).ok();
        let mut facts = Vec::new();
        if let Ok(shape) = surface.shape_at(u, v) {
            let principal = shape.principal(self.tolerance);
            let units = &self.units;
            // Rounding is no curvature.
            let (none, most) = (shape.rounding(), principal.k1.abs().max(principal.k2.abs()));
            let settled = |value: f64, none: f64| if value.abs() <= none { 0.0 } else { value };
            let [k1, k2, mean] =
                [principal.k1, principal.k2, shape.mean()].map(|value| settled(value, none));
            let gauss = settled(shape.gaussian(), none * most);
            facts = vec![
                Fact::number("k1", "smallest principal curvature", k1, units.curvature()),
                Fact::number("k2", "largest principal curvature", k2, units.curvature()),
                Fact::number("gauss", "Gaussian curvature", gauss, units.gaussian()),
                Fact::number("mean", "mean curvature", mean, units.curvature()),
            ];
            // Where both are equal within the tolerance's angle, no direction is told from another.
            let is_umbilic = 0.5 * (k2 - k1) <= self.tolerance.angle * most;
            facts.extend(match is_umbilic {
                true => {
                    vec![Fact::said("umbilic", "umbilic point", "every direction is principal")]
                }
                false => vec![
                    Fact::vector("d1", "direction of the smallest", principal.d1),
                    Fact::vector("d2", "direction of the largest", principal.d2),
                ],
            });
        }
        let parameters = [u, v];
        Ok(self.answer(&parameters, json!({ "u": u, "v": v }), point, normal, &facts))
    }

    fn curve(&self, curve: &Curve, t: f64) -> Result<Json, crate::kernel::GeomError> {
        let t = curve.domain().clamp_inside(t)?;
        let local = curve.local_at(t, Side::Right)?;
        let mut facts = vec![Fact::vector("tangent", "tangent", local.tangent())];
        let mut add = |name, label, number: Option<f64>, unit| {
            facts.extend(number.map(|number| Fact::number(name, label, number, unit)));
        };
        add("curvature", "curvature", local.curvature().ok(), self.units.curvature());
        let radius = local.radius_of_curvature().ok().filter(|radius| radius.is_finite());
        add("radius", "radius of curvature", radius, self.units.length());
        add("torsion", "torsion", local.torsion().ok(), self.units.curvature());
        Ok(self.answer(&[t], json!({ "t": t }), local.point(), local.normal().ok(), &facts))
    }

    /// The place of a vertex of a mesh, or of one of several points, by its number.
    fn vertex(&self, places: &[glam::DVec3], number: f64) -> Answer {
        let is_number = 0.0 <= number && number.fract() == 0.0;
        let point = is_number.then(|| places.get(number as usize)).flatten();
        let point = point.ok_or_else(|| format!("there are {} of them", places.len()))?;
        Ok(json!({
            "definition": self.definition,
            "path": self.path,
            "parameters": { "vertex": number },
            "expression": null,
            "point": point.to_array(),
            "normal": null,
            "facts": [],
        }))
    }

    fn answer(
        &self,
        parameters: &[f64],
        named: Json,
        point: glam::DVec3,
        normal: Option<glam::DVec3>,
        facts: &[Fact],
    ) -> Json {
        let written: Vec<String> =
            parameters.iter().map(|&number| crate::value::shortest(number)).collect();
        // What has no name of its own cannot be asked by a script.
        let has_name = !self.path.contains('@');
        json!({
            "definition": self.definition,
            "path": self.path,
            "parameters": named,
            "expression": has_name.then(|| format!("{}({})", self.path, written.join(", "))),
            "point": point.to_array(),
            "normal": normal.map(|normal| normal.to_array()),
            "facts": facts.iter().map(Fact::json).collect::<Vec<_>>(),
        })
    }
}
