//! What a picture shows beside the geometry: control polygons and nets, combs of curvature, axes.

use glam::{DVec3, Vec3Swizzles};

use crate::{
    export::{DefinitionLabel, Item, Subject},
    kernel::{Bounds, Curve, GeomError, Interval, LocalError, NurbsCurve, Side, Surface},
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
    /// The directions of x, y and z.
    Axes,
    /// The names of definitions.
    Labels,
    /// How long a round length is.
    Scale,
}

impl Extra {
    /// Every one with its name.
    pub const ALL: &'static [(&'static str, Self)] = &[
        ("control", Self::Control),
        ("comb", Self::Comb),
        ("stripes", Self::Stripes),
        ("axes", Self::Axes),
        ("labels", Self::Labels),
        ("scale", Self::Scale),
    ];
}

/// How control polygons and nets are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ControlStyle {
    /// Red, green and blue.
    pub color: [u8; 3],
    /// How wide lines and points are, as a multiple of the usual.
    pub size: f64,
}

impl Default for ControlStyle {
    fn default() -> Self {
        Self { color: GREY, size: 1.0 }
    }
}

/// Stripes all around, where no number is asked for.
pub const STRIPES: usize = 24;

/// Teeth of a comb.
const N_TEETH: usize = 80;

/// Length of the longest tooth, as a part of the whole's size.
const LONGEST: f64 = 0.12;

/// The colour of control polygons and nets.
const GREY: [u8; 3] = [0x80, 0x80, 0x80];

/// The control polygons and nets of NURBS; functions have none.
pub(super) fn control(items: &[Item], style: ControlStyle) -> Vec<Item> {
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
            color: Some(style.color),
            line_width: style.size,
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
            Err(GeomError::Local(LocalError::VanishingTangent { .. })) => {}
            local => {
                let local = local?;
                bends.extend(local.curvature_vector().map(|bending| (local.point(), bending)));
            }
        }
    }
    Ok(bends)
}

/// Length of an axis, as a part of the whole's size.
const AXIS: f64 = 0.25;
/// The axes stand at the origin where that is no farther from the geometry than this part of its size,
/// else at its lowest corner.
const FAR: f64 = 0.5;
/// Length and half width of an axis's head, as parts of the axis.
const HEAD: [f64; 2] = [0.12, 0.04];
/// The axes with their names and colours.
const AXES: [(&str, DVec3, [u8; 3]); 3] = [
    ("x", DVec3::X, [0xd6, 0x27, 0x28]),
    ("y", DVec3::Y, [0x2c, 0xa0, 0x2c]),
    ("z", DVec3::Z, [0x1f, 0x5f, 0xd4]),
];

/// Arrows along the axes, and their names at the tips; of what lies in a plane across z only those of
/// x and y.
pub(super) fn axes(bounds: Bounds) -> (Vec<Item>, Vec<DefinitionLabel>) {
    let size = if 0.0 < bounds.diagonal() { bounds.diagonal() } else { 1.0 };
    let is_near = bounds.contains(DVec3::ZERO, FAR * size);
    let origin = if is_near { DVec3::ZERO } else { bounds.min };
    let is_flat = bounds.max.z <= bounds.min.z;
    let (mut items, mut labels) = (Vec::new(), Vec::new());
    for (name, along, color) in AXES.into_iter().filter(|axis| !(is_flat && axis.0 == "z")) {
        let tip = origin + AXIS * size * along;
        let [length, half] = HEAD.map(|part| part * AXIS * size);
        let aside = [along.yzx(), along.zxy()].into_iter().filter(|side| !is_flat || side.z == 0.0);
        let barbs = aside.map(|side| {
            let foot = tip - length * along;
            vec![foot + half * side, tip, foot - half * side]
        });
        for line in std::iter::once(vec![origin, tip]).chain(barbs) {
            let Ok(curve) = NurbsCurve::polyline(&line) else { continue };
            let subject = Subject::Curve(curve.into());
            let item = Item::new(format!("axis {name}"), subject);
            items.push(Item { color: Some(color), ..item });
        }
        labels.push(DefinitionLabel { places: vec![tip], text: name.to_owned() });
    }
    (items, labels)
}

/// Places on a surface in each direction beside which its name may stand.
const N_PLACES: usize = 8;

/// A definition's name beside the middle of what is drawn of it, on the side that is seen.
pub(super) fn label(name: &str, items: &[Item]) -> Option<DefinitionLabel> {
    let places = match &items.get(items.len() / 2)?.subject {
        Subject::Point(point) => vec![*point],
        Subject::Curve(curve) => vec![curve.point_at(curve.domain().at(0.5)).ok()?],
        Subject::Surface(surface) => {
            let inner = |domain: Interval| domain.steps(N_PLACES)[1..N_PLACES].to_vec();
            let (us, vs) = (inner(surface.domain_u()), inner(surface.domain_v()));
            let at = |u: f64, v: f64| surface.point_at(u, v).ok();
            us.iter().flat_map(|&u| vs.iter().filter_map(move |&v| at(u, v))).collect()
        }
        Subject::Region(region) => vec![region.mass().centroid],
        Subject::Face(face) => vec![face.mass().ok()?.centroid],
        Subject::Solid(solid) => {
            solid.faces().iter().filter_map(|face| Some(face.mass().ok()?.centroid)).collect()
        }
        Subject::Mesh(mesh) => mesh.vertices().to_vec(),
        Subject::Table(_) | Subject::Data(_) | Subject::Document(_) => return None,
    };
    Some(DefinitionLabel { places, text: name.to_owned() })
}
