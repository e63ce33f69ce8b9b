//! The borders of stripes on an item, exactly: where a shader over the mesh shows them, the kernel has curves.

use std::{f64::consts::FRAC_PI_2, sync::Arc};

use glam::DVec3;
use serde_json::Value as Json;

use super::{Known, answers::number_of, ceilings::within_ceilings, scene::Shape};
use crate::{
    kernel::{
        Face, GeomError, NurbsCurve, Surface, Tolerance, tessellate_curve,
        tolerance::SEEN_LINE_RELATIVE,
    },
    limits::stack,
    session::Session,
};

/// Stripes of which nobody sees more.
const MOST_STRIPES: f64 = 100.0;

/// What is asked.
struct StripeQuestion {
    is_zebra: bool,
    light: DVec3,
    /// About which the sectors of zebra stripes lie.
    axis: DVec3,
    /// Dark stripes in a right angle of normals, or in half a turn of mirrored rays.
    n_stripes: usize,
    /// How far the answer may be from the curves.
    near: f64,
}

/// The borders of the stripes on the surfaces of an item, as pairs of places, relative to the centre of
/// its bytes.
pub(crate) fn stripes(body: &Json, known: &Known, session: &Session) -> Result<Vec<f64>, String> {
    let key = body["item"].as_str().ok_or("`item` must be a key")?;
    let (item, _) = known.item(key).ok_or("an item is not known any more")?;
    let shape = &item.piece.shape;
    if !shape.is_tessellated() {
        return Err(format!("a {} has no exact stripes", shape.kind()));
    }
    let bounds = shape.bounds().ok_or("it has no end")?;
    let n_stripes = number_of(body, "stripes")?;
    if !(1.0..=MOST_STRIPES).contains(&n_stripes) {
        return Err(format!("`stripes` must be from 1 to {MOST_STRIPES}"));
    }
    let question = StripeQuestion {
        is_zebra: body["kind"] == "zebra",
        light: direction(body, "light")?,
        axis: direction(body, "axis")?,
        n_stripes: n_stripes as usize,
        near: SEEN_LINE_RELATIVE * bounds.diagonal(),
    };
    let most = session.limits().mesh_vertices;
    // Functions of the script need the stack of an evaluation.
    let lines = stack::with(session.limits().stack_bytes, |_| {
        within_ceilings(session, || question.lines(shape, most))
    })?;
    let center = bounds.center();
    let legs = lines.iter().flat_map(|line| line.windows(2)).flatten();
    Ok(legs.flat_map(|place| (*place - center).to_array()).collect())
}

fn direction(body: &Json, name: &str) -> Result<DVec3, String> {
    let numbers = body[name].as_array().map(Vec::as_slice).unwrap_or_default();
    let numbers: Vec<f64> = numbers.iter().filter_map(Json::as_f64).collect();
    match numbers[..] {
        [x, y, z] => Ok(DVec3::new(x, y, z)),
        _ => Err(format!("`{name}` must be three numbers")),
    }
}

impl StripeQuestion {
    fn lines(&self, shape: &Shape, most: usize) -> Result<Vec<Vec<DVec3>>, GeomError> {
        let mut curves = Vec::new();
        match shape {
            Shape::Face(face) => {
                let surface = Surface::Nurbs(Arc::clone(face.surface()));
                curves = self.on_face(face, self.curves(&surface)?)?;
            }
            shape => {
                for surface in shape.surfaces() {
                    curves.extend(self.curves(surface)?);
                }
            }
        }
        let mut lines = Vec::new();
        for curve in &curves {
            for part in curve.connected_parts() {
                lines.push(tessellate_curve(&part, self.near, most)?);
            }
        }
        Ok(lines)
    }

    fn on_face(&self, face: &Face, curves: Vec<NurbsCurve>) -> Result<Vec<NurbsCurve>, GeomError> {
        if face.is_whole() { Ok(curves) } else { face.clipped(&curves, self.tolerance()) }
    }

    fn curves(&self, surface: &Surface) -> Result<Vec<NurbsCurve>, GeomError> {
        let sets = if self.is_zebra {
            surface.zebra_about(self.axis, self.light, 4 * self.n_stripes, self.tolerance())?
        } else {
            // A stripe is dark in its middle: from a quarter of it to three.
            let angle = |i: usize| (0.5 * i as f64 + 0.25) * FRAC_PI_2 / self.n_stripes as f64;
            let angles: Vec<f64> = (0..4 * self.n_stripes).map(angle).collect();
            surface.isophotes(self.light, &angles, self.tolerance())?
        };
        Ok(sets.into_iter().flat_map(|set| set.curves).collect())
    }

    fn tolerance(&self) -> Tolerance {
        Tolerance::DEFAULT.with_distance(self.near)
    }
}
