//! Places in an order in which those of a box are found.

use glam::DVec3;

use crate::{Bounds, sorting::sort_by};

/// Some of several places, in their order along the longest side of the box around all.
pub(crate) struct PlacesAlong<'a> {
    places: &'a [DVec3],
    axis: usize,
    order: Vec<u32>,
}

impl<'a> PlacesAlong<'a> {
    /// Those that are wanted by their number.
    pub(crate) fn new(places: &'a [DVec3], is_wanted: impl Fn(u32) -> bool) -> Self {
        let size = Bounds::of(places.iter().copied()).map_or(DVec3::ZERO, Bounds::size);
        let longest = size.to_array().iter().position(|&side| size.max_element() <= side);
        let axis = longest.unwrap_or(0);
        let at = |place: u32| places[place as usize][axis];
        let mut order: Vec<u32> =
            (0..places.len() as u32).filter(|&place| is_wanted(place)).collect();
        sort_by(&mut order, |&a, &b| at(a).total_cmp(&at(b)).then(a.cmp(&b)));
        Self { places, axis, order }
    }

    pub(crate) fn all(&self) -> &[u32] {
        &self.order
    }

    /// Those of a box, and others beside it.
    pub(crate) fn between(&self, low: DVec3, high: DVec3) -> &[u32] {
        let at = |place: u32| self.places[place as usize][self.axis];
        let (low, high) = (low[self.axis], high[self.axis]);
        let first = self.order.partition_point(|&place| at(place) < low);
        let behind = self.order.partition_point(|&place| at(place) <= high);
        &self.order[first..first.max(behind)]
    }
}
