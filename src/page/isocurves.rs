//! Lines of equal parameter on an item, in another number than it has.

use serde_json::Value as Json;

use super::{
    Known,
    answers::number_of,
    ceilings::within_ceilings,
    scene::{fineness, isolines},
};
use crate::{limits::stack, session::Session};

/// Lines in each direction of which nobody sees more.
const MOST_ISOCURVES: f64 = 100.0;

/// The bytes of an item with the lines of equal parameter of another one, `count` inside in each direction,
/// and their curvatures.
pub(crate) fn isocurves(body: &Json, known: &Known, session: &Session) -> Result<Vec<u8>, String> {
    let key = body["item"].as_str().ok_or("`item` must be a key")?;
    let (item, report) = known.item(key).ok_or("an item is not known any more")?;
    let report = report.ok_or("there is no model yet")?;
    let shape = &item.piece.shape;
    if !shape.is_tessellated() {
        return Err(format!("a {} has no lines of equal parameter", shape.kind()));
    }
    let count = number_of(body, "count")?;
    if !(1.0..=MOST_ISOCURVES).contains(&count) {
        return Err(format!("`count` must be from 1 to {MOST_ISOCURVES}"));
    }
    let fineness = fineness(report, session, known.shown.scene.bounds);
    // Functions of the script need the stack of an evaluation.
    stack::with(session.limits().stack_bytes, |_| {
        within_ceilings(session, || isolines(shape, count as usize, &fineness))
    })
}
