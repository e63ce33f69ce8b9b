//! What the borders of a region must be: apart from one another and from themselves, holes within the outer one.

use glam::DVec3;

use super::{PlaneLoop, Region};
use crate::{
    GeomError, PictureError,
    arrange::{Apart, Arrangement, Ring},
    box_tree::BoxTree,
};

impl Region {
    /// Its borders, cut where they meet.
    ///
    /// # Errors
    /// Those of [`Arrangement::of`].
    pub(super) fn arrangement(&self, distance: f64) -> Result<Arrangement, GeomError> {
        let rings = self.loops.iter().enumerate();
        let rings: Vec<Ring> =
            rings.map(|(group, border)| Ring { group, arcs: border.arcs.clone() }).collect();
        Arrangement::of(&rings, Apart::Nothing, distance, 1)
    }

    /// # Errors
    /// [`PictureError::Crossing`].
    pub(super) fn check_borders(&self, distance: f64) -> Result<(), GeomError> {
        self.check_apart(self.arrangement(distance)?.knot())
    }

    /// The same of borders that are given, which do not run along themselves either.
    ///
    /// # Errors
    /// [`PictureError::Crossing`].
    pub(super) fn check_given_borders(&self, distance: f64) -> Result<(), GeomError> {
        let arrangement = self.arrangement(distance)?;
        self.check_apart(arrangement.knot().or_else(|| arrangement.repeated()))
    }

    fn check_apart(&self, meeting: Option<(DVec3, Vec<usize>)>) -> Result<(), GeomError> {
        match meeting {
            None => Ok(()),
            Some((vertex, groups)) => {
                let (index, other) = (groups[0], groups[groups.len() - 1]);
                let point = self.frame.point(vertex);
                let of = self.loops.len();
                Err(PictureError::Crossing { index, other, of, point }.into())
            }
        }
    }

    /// # Errors
    /// [`PictureError::Outside`], [`PictureError::HoleInHole`].
    pub(super) fn check_nesting(&self) -> Result<(), GeomError> {
        let holes = &self.loops[1..];
        let tree = BoxTree::new(holes.iter().map(PlaneLoop::bounds).collect());
        for (number, hole) in holes.iter().enumerate() {
            GeomError::go_on(1)?;
            let index = number + 1;
            if !self.loops[0].holds(hole)? {
                return Err(PictureError::Outside { index }.into());
            }
            let bounds = tree.bounds(number);
            for other in tree.near(bounds, 0.0) {
                let may = number != other && tree.bounds(other).holds(bounds, 0.0);
                if may && holes[other].holds(hole)? {
                    return Err(PictureError::HoleInHole { index, other: other + 1 }.into());
                }
            }
        }
        Ok(())
    }
}
