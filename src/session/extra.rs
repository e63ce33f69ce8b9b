//! What a picture shows beside the geometry: control polygons and nets, combs of curvature.

use glam::DVec3;

use crate::{
    export::{Item, Subject},
    kernel::{Bounds, Curve, GeomError, NurbsCurve, Side, Surface},
};

/// What can be shown beside the geometry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extra {
    /// The control polygons of curves, the control nets of surfaces, with their points.
    Control,
    /// The combs of curves, all to one scale.
    Comb,
    /// The stripes that surfaces mirror toward the viewer.
    Stripes,
}

impl Extra {
    /// Every one with its name.
    pub const ALL: &'static [(&'static str, Self)] =
        &[("control", Self::Control), ("comb", Self::Comb), ("stripes", Self::Stripes)];
}

/// Stripes all around.
pub(super) const STRIPES: usize = 24;

/// Teeth of a comb.
const N_TEETH: usize = 80;

/// Length of the longest tooth, as a part of the whole's size.
const LONGEST: f64 = 0.12;

/// The colour of control polygons and nets.
const GREY: [u8; 3] = [0x80, 0x80, 0x80];

/// The control polygons and nets of NURBS; functions have none.
pub(super) fn control(items: &[Item]) -> Vec<Item> {
    let mut added = Vec::new();
    for item in items {
        let (lines, points) = match &item.subject {
            Subject::Curve(Curve::Nurbs(curve)) => (vec![curve.points()], curve.points()),
            Subject::Surface(Surface::Nurbs(surface)) => {
                let net = surface.points();
                let row = |i: usize| (0..net.n_columns()).map(|j| net.get(i, j)).collect();
                let column = |j: usize| (0..net.n_rows()).map(|i| net.get(i, j)).collect();
                let rows = (0..net.n_rows()).map(row);
                let lines = rows.chain((0..net.n_columns()).map(column)).collect();
                (lines, net.iter().copied().collect())
            }
            _ => continue,
        };
        let of = |subject: Subject| Item {
            name: format!("control points of {}", item.name),
            color: Some(GREY),
            subject,
            ..item.clone()
        };
        let polygons = lines.iter().filter_map(|line: &Vec<DVec3>| NurbsCurve::polyline(line).ok());
        added.extend(polygons.map(|polygon| of(Subject::Curve(polygon.into()))));
        added.extend(points.into_iter().map(|point| of(Subject::Point(point))));
    }
    added
}

/// The combs of the curves, on the side away from the centres of curvature.
///
/// # Errors
/// The item and what is wrong with it, where a curve cannot be asked.
pub(super) fn combs(items: &[Item]) -> Result<Vec<Item>, (String, GeomError)> {
    let mut bent = Vec::new();
    let mut whole: Option<Bounds> = None;
    for item in items {
        let Subject::Curve(curve) = &item.subject else { continue };
        let blame = |err: GeomError| (item.name.clone(), err);
        let bounds = curve.bounds().map_err(blame)?;
        whole = Some(whole.map_or(bounds, |whole| whole.union(bounds)));
        bent.push((item, bends(curve).map_err(blame)?));
    }
    let all = || bent.iter().flat_map(|(_, bends)| bends).map(|(_, bending)| bending.length());
    let scale = LONGEST * whole.map_or(0.0, Bounds::diagonal) / all().fold(0.0, f64::max);
    // Where nothing bends there is nothing to show.
    let scale = if scale.is_finite() { scale } else { 0.0 };
    let mut added = Vec::new();
    for (item, bends) in bent {
        let of = |curve: NurbsCurve| Item {
            name: format!("comb of {}", item.name),
            subject: Subject::Curve(curve.into()),
            ..item.clone()
        };
        let teeth = bends.iter().map(|&(foot, bending)| [foot, foot - scale * bending]);
        let tips: Vec<DVec3> = teeth.clone().map(|[_, tip]| tip).collect();
        let lines = teeth.filter(|[foot, tip]| foot != tip);
        added.extend(lines.filter_map(|tooth| NurbsCurve::polyline(&tooth).ok()).map(of));
        added.extend(NurbsCurve::polyline(&tips).ok().map(of));
    }
    Ok(added)
}

/// Points of a curve with their curvature vectors, but those where that has no bound.
fn bends(curve: &Curve) -> Result<Vec<(DVec3, DVec3)>, GeomError> {
    let mut bends = Vec::new();
    for t in curve.domain().steps(N_TEETH) {
        match curve.local_at(t, Side::Right) {
            Err(GeomError::VanishingTangent { .. }) => {}
            local => {
                let local = local?;
                bends.extend(local.curvature_vector().map(|bending| (local.point(), bending)));
            }
        }
    }
    Ok(bends)
}
