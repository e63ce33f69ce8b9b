//! Lengths, areas and volumes of geometry, and pictures of it: at once what is quick, else what a closer look tells.

use super::Values;
use crate::{
    kernel::{Curve, Face, Mesh, Region, Surface, Tolerance},
    limits::{
        Limits,
        work::{self, MemoryGauge, StopToken, Watch},
    },
    session,
    syntax::ast::Unit,
    value::{Value, rounded},
};

/// Control points up to which a curve or surface is measured and drawn.
const MOST_MEASURED: usize = 1000;
/// Faces up to which a solid is measured and drawn.
const MOST_FACES: usize = 24;
/// Triangles up to which a mesh is measured and drawn.
const MOST_TRIANGLES: usize = 20_000;
/// Steps of measuring while somebody waits: some milliseconds.
const STEPS_AT_ONCE: u64 = 20_000;
/// Steps of a closer look, which takes a second at most.
const STEPS_OF_A_LOOK: u64 = 1_000_000;
/// Width and height of a picture in pixels.
const PICTURE_SIZE: [usize; 2] = [160, 120];
/// Bytes of a picture that is shown; as text they take a third more.
const MOST_PICTURE_BYTES: usize = 15_000;

/// What work comes to that takes no more than so many steps, and is not stopped.
fn within<T>(steps: u64, stop: StopToken, work: impl FnOnce() -> Option<T>) -> Option<T> {
    let watch = Watch { gauge: MemoryGauge::default(), memory_bytes: usize::MAX, stop, steps };
    let (found, done) = work::under(watch, work);
    found.filter(|_| done.end.is_none())
}

/// Whether a value has few of the parts that measuring and drawing take their time for.
fn is_small(value: &Value) -> bool {
    match value {
        Value::Curve(Curve::Nurbs(curve)) => curve.control_points().len() <= MOST_MEASURED,
        Value::Surface(Surface::Nurbs(surface)) => {
            surface.control_points().as_slice().len() <= MOST_MEASURED
        }
        Value::Region(_) | Value::Face(_) => true,
        Value::Solid(solid) => solid.faces().len() <= MOST_FACES,
        Value::Mesh(mesh) => mesh.triangles().len() <= MOST_TRIANGLES,
        _ => false,
    }
}

/// Whether measuring takes a closer look: areas of surfaces and of what is trimmed take long.
fn is_slow(value: &Value) -> bool {
    matches!(value, Value::Surface(_) | Value::Face(_) | Value::Solid(_))
}

/// `, length 124.6 mm`; nothing where that takes long, or cannot be told.
pub(super) fn measured(value: &Value, unit: &str) -> String {
    if !is_small(value) || is_slow(value) {
        return String::new();
    }
    let told = within(STEPS_AT_ONCE, StopToken::default(), || measures(value, unit));
    told.map(|told| format!(", {told}")).unwrap_or_default()
}

/// `volume 8 mm^3, area 24 mm^2`
fn measures(value: &Value, unit: &str) -> Option<String> {
    let length = |amount: f64| format!("length {} {unit}", rounded(amount));
    let area = |amount: f64| format!("area {} {unit}^2", rounded(amount));
    Some(match value {
        Value::Curve(curve) => length(curve.length(curve.domain()).ok()?),
        Value::Surface(surface) => area(surface.area().ok()?.0),
        Value::Region(region) => area(Region::area(region)),
        Value::Face(face) => area(Face::mass_of(&[(**face).clone()]).ok()?.amount),
        Value::Solid(solid) => {
            let volume = rounded(solid.volume_mass().ok()?.amount);
            format!("volume {volume} {unit}^3, {}", area(solid.area_mass().ok()?.amount))
        }
        Value::Mesh(mesh) => area(Mesh::area(mesh)),
        _ => return None,
    })
}

/// What a closer look at geometry tells: it may take up to a second, and can be stopped.
///
/// ```
/// use std::sync::Arc;
/// use virote::{ide::{CloserLook, Values}, limits::{Limits, work::StopToken}, session::Session, value::NoFiles};
///
/// let script = b"solid s = extrude(region(circle((0, 0), 1)), (0, 0, 2))  let n = 3";
/// let report = Arc::new(Session::default().run("demo", script, &NoFiles, &[]));
/// let values = Values::new(Arc::clone(&report));
/// let look = |name: &str| {
///     let value = values.value(name).expect("a value");
///     CloserLook::at(value, report.document, &Limits::DEFAULT, true, &StopToken::default())
/// };
/// assert_eq!(look("s").measures, "volume 6.28319 mm^3, area 18.8496 mm^2");
/// let png = look("s").picture.expect("a picture");
/// assert!(png.starts_with(b"\x89PNG") && png.len() < 15_000);
/// assert_eq!(look("n"), CloserLook::default());
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CloserLook {
    /// Area and volume, where a hover does not tell them at once.
    pub measures: String,
    /// A small picture as a PNG, as `virote render` draws it.
    pub picture: Option<Vec<u8>>,
}

impl CloserLook {
    /// Whether there is something to look at.
    #[must_use]
    pub fn is_worth_it(value: &Value, with_picture: bool) -> bool {
        is_small(value) && (with_picture || is_slow(value))
    }

    /// Looks at a value of a document with this unit and tolerance.
    #[must_use]
    pub fn at(
        value: &Value,
        document: (Unit, Tolerance),
        limits: &Limits,
        with_picture: bool,
        stop: &StopToken,
    ) -> Self {
        if !Self::is_worth_it(value, with_picture) {
            return Self::default();
        }
        let measures = is_slow(value)
            .then(|| within(STEPS_OF_A_LOOK, stop.clone(), || measures(value, document.0.name())))
            .flatten();
        let picture = with_picture
            .then(|| {
                within(STEPS_OF_A_LOOK, stop.clone(), || {
                    session::small_picture(value, document, limits, PICTURE_SIZE)
                })
            })
            .flatten();
        Self {
            measures: measures.unwrap_or_default(),
            picture: picture.filter(|bytes| bytes.len() <= MOST_PICTURE_BYTES),
        }
    }
}

impl Values {
    /// The area and volume of a value, where [`Self::description`] leaves them to a closer look.
    #[must_use]
    pub fn measures(&self, value: &Value) -> String {
        let look = CloserLook::at(
            value,
            self.report().document,
            &Limits::DEFAULT,
            false,
            &StopToken::default(),
        );
        look.measures
    }
}
