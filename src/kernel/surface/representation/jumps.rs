//! Where a surface jumps: an inner knot that stands degree + 1 times parts it into pieces whose
//! edges need not meet.

use glam::DVec3;

use crate::{
    GeomError, JumpError, homogeneous,
    surface::{Direction, NurbsSurface, SurfaceClosestPoint},
    tolerance::LAST_BIT,
};

/// Last bits of a coordinate within which two edges meet.
const MOST_ROUNDINGS: f64 = 16.0;

/// An inner line of parameters across which a surface is apart.
#[derive(Clone, Copy, Debug)]
struct JumpLine {
    along: Direction,
    at: f64,
    /// How far the control points of both edges are apart at most.
    gap: f64,
}

impl NurbsSurface {
    fn jump(&self) -> Option<JumpLine> {
        let net = &self.control_points;
        let place = |i: usize, j: usize| homogeneous::place(net.row(i)[j]);
        let size = net.as_slice().iter().map(|&point| homogeneous::place(point).abs());
        let rounding = MOST_ROUNDINGS * LAST_BIT * size.fold(DVec3::ZERO, DVec3::max).max_element();
        Direction::BOTH.into_iter().find_map(|along| {
            let (knots, domain) = (self.knots(along), self.domain(along));
            let inner = knots.full_breaks().into_iter();
            let mut inner = inner.filter(|&t| domain.start() < t && t < domain.end());
            inner.find_map(|at| {
                // The edge behind begins with the control point that its first knot counts.
                let k = knots.as_slice().partition_point(|&knot| knot < at);
                let gap = match along {
                    Direction::U => (0..net.n_columns())
                        .map(|j| place(k - 1, j).distance(place(k, j)))
                        .fold(0.0, f64::max),
                    Direction::V => (0..net.n_rows())
                        .map(|i| place(i, k - 1).distance(place(i, k)))
                        .fold(0.0, f64::max),
                };
                (rounding < gap).then_some(JumpLine { along, at, gap })
            })
        })
    }

    /// # Errors
    /// [`JumpError::Surface`] at the first line across which it is apart.
    pub fn check_connected(&self) -> Result<(), GeomError> {
        match self.jump() {
            Some(JumpLine { along, at, gap }) => {
                Err(JumpError::Surface { along: along.name(), at, gap }.into())
            }
            None => Ok(()),
        }
    }

    /// The nearest point of both sides of a jump; none of a surface that is connected.
    pub(in crate::surface) fn closest_beside_jump(&self, p: DVec3) -> Option<SurfaceClosestPoint> {
        let JumpLine { along, at, .. } = self.jump()?;
        let [before, behind] = self.split(along, at).ok()?.map(|side| side.closest(p));
        if before.distance <= behind.distance {
            let mut foot = before;
            let parameter = &mut foot.parameters[usize::from(along == Direction::V)];
            // At the jump the surface is what is behind it.
            if at <= *parameter {
                *parameter = at.next_down();
            }
            Some(foot)
        } else {
            Some(behind)
        }
    }
}
