//! Where a swept surface crosses itself: the section reaches beyond the centre of curvature of its
//! path, or shrinks to nothing.

use glam::DVec3;

use super::MovingSection;
use crate::{
    ConstructionError, GeomError,
    ceiling::FOLD_BISECTIONS,
    numeric::bisection::try_bisected,
    tolerance::{KNOT_RELATIVE, VANISHING_RELATIVE},
};

/// Places of the path, and steps of each of its spans, at which is asked.
const N_PLACES: usize = 400;
const N_STEPS: usize = 8;

/// Points of the section that are looked at.
const N_POINTS: usize = 65;

/// Stretches with folds, and places where the section shrinks to a line or a point.
type Folds = (Vec<[f64; 2]>, Vec<f64>);

impl MovingSection<'_> {
    /// Where the section reaches beyond the centre of curvature, and where between the ends it
    /// shrinks to nothing or turns inside out.
    ///
    /// # Errors
    /// [`ConstructionError::VanishingSection`] where nothing is left of it anywhere.
    pub(super) fn folds(&mut self) -> Result<Folds, GeomError> {
        let section = self.section.sample(N_POINTS);
        let knots = self.path.knots();
        let spans = knots.spans().flat_map(|span| knots.span_interval(span).steps(N_STEPS));
        let mut places: Vec<f64> =
            self.path.domain().steps(N_PLACES).into_iter().chain(spans).collect();
        places.sort_by(f64::total_cmp);
        places.dedup_by(|later, earlier| *later <= *earlier);

        // How far the section reaches along each of its axes; along some it may not reach at all.
        let extents = section.iter().fold(DVec3::ZERO, |most, p| most.max(p.abs()));
        let size = VANISHING_RELATIVE * extents.max_element();
        let is_flat = extents.to_array().map(|extent| extent <= size);
        let mut largest = 0.0_f64;
        let mut is_fold = Vec::with_capacity(places.len());
        let mut sizes = Vec::with_capacity(places.len());
        for &t in &places {
            is_fold.push(1.0 + KNOT_RELATIVE.sqrt() < self.reach(&section, t)?);
            let axes = self.axes(t)?.0;
            for (axis, extent) in axes.iter().zip(extents.to_array()) {
                largest = largest.max(axis.length() * extent);
            }
            sizes.push(self.factor(t, is_flat)?);
        }
        if largest <= size {
            return Err(ConstructionError::VanishingSection.into());
        }
        let mut folds: Vec<[f64; 2]> = Vec::new();
        for (i, &t) in places.iter().enumerate() {
            let was_fold = 0 < i && is_fold[i - 1];
            match (was_fold, is_fold[i]) {
                (false, true) if i == 0 => folds.push([t, t]),
                (false, true) => folds.push([self.boundary(&section, places[i - 1], t)?, t]),
                (true, _) => {
                    let end = match is_fold[i] {
                        true => t,
                        false => self.boundary(&section, t, places[i - 1])?,
                    };
                    if let Some(last) = folds.last_mut() {
                        last[1] = end;
                    }
                }
                (false, false) => {}
            }
        }
        Ok((folds, collapses(&places, &sizes)))
    }

    /// The factor nearest to zero of those along axes on which the section reaches anywhere; between
    /// rails, which hold it, the volume of its axes.
    fn factor(&mut self, t: f64, is_flat: [bool; 3]) -> Result<f64, GeomError> {
        let (x, point) = (self.frames.at(t)?.x, self.path.point_at(t));
        if let Some(([x, y, z], _)) = self.motion.held(t, point, x)? {
            return Ok(y.cross(z).dot(x));
        }
        let scale = self.motion.scale(t)?.to_array();
        let factors = scale.into_iter().zip(is_flat).filter(|(_, is_flat)| !is_flat);
        let least = factors.map(|(factor, _)| factor).min_by(|a, b| a.abs().total_cmp(&b.abs()));
        Ok(least.unwrap_or(1.0))
    }

    /// How far the section reaches towards the centre of curvature, which is at 1.
    fn reach(&mut self, section: &[DVec3], t: f64) -> Result<f64, GeomError> {
        let derivatives = self.path.derivatives_at(t, 2);
        let speed = derivatives[1].length();
        let along = derivatives[1] / speed;
        let bend = (derivatives[2] - along * along.dot(derivatives[2])) / (speed * speed);
        if !bend.is_finite() {
            return Ok(0.0);
        }
        let ([x, y, z], shift) = self.axes(t)?;
        let reach = |p: &DVec3| (x * p.x + y * p.y + z * p.z + shift).dot(bend);
        Ok(section.iter().map(reach).fold(0.0, f64::max))
    }

    /// Where the reach passes 1, between a place without and one with a fold.
    fn boundary(&mut self, section: &[DVec3], free: f64, folded: f64) -> Result<f64, GeomError> {
        let is_folded = |t: f64| self.reach(section, t).map(|reach| 1.0 < reach);
        let [folded, _] = try_bisected([folded, free], FOLD_BISECTIONS, is_folded)?;
        Ok(folded)
    }
}

/// Where a size vanishes or changes sign between the ends.
fn collapses(places: &[f64], sizes: &[f64]) -> Vec<f64> {
    let largest = sizes.iter().fold(0.0_f64, |most, size| most.max(size.abs()));
    let is_small = |i: usize| sizes[i].abs() <= VANISHING_RELATIVE * largest;
    let mut found: Vec<f64> = Vec::new();
    for i in 1..places.len() {
        if is_small(i) && i + 1 < places.len() && !is_small(i - 1) {
            found.push(places[i]);
        } else if sizes[i - 1] * sizes[i] < 0.0 && !is_small(i) && !is_small(i - 1) {
            let share = sizes[i - 1] / (sizes[i - 1] - sizes[i]);
            found.push(places[i - 1] + (places[i] - places[i - 1]) * share);
        }
    }
    found
}
