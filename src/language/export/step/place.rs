//! Points, directions and placements.

use glam::DVec3;

use super::entity::{Id, Records};
use crate::kernel::Frame;

/// The origin of a frame with its directions.
pub(super) fn placement(frame: Frame, file: &mut Records) -> Id {
    let origin = point("", frame.origin(), file);
    let [z, x] = [frame.z(), frame.x()].map(|axis| direction(axis, file));
    file.add(|r| {
        r.text("AXIS2_PLACEMENT_3D('',").id(origin).text(",").id(z).text(",").id(x).text(")");
    })
}

/// A unit vector.
pub(super) fn direction(direction: DVec3, file: &mut Records) -> Id {
    file.add(|r| {
        r.text("DIRECTION('',").place(direction).text(")");
    })
}

/// A point by its name.
pub(super) fn point(name: &str, point: DVec3, file: &mut Records) -> Id {
    file.add(|r| {
        r.text("CARTESIAN_POINT(").string(name).text(",").place(point).text(")");
    })
}
