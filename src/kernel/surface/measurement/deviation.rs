//! How far a surface is from another surface, or from a mesh.

use crate::{
    Deviation, DeviationReference, GeomError, KnotVector, ceiling::DEVIATION_PARTS,
    ceiling::SURFACE_CLIMB_STEPS, numeric::pattern_search::climbed, surface::Surface,
};

/// Even parts of a domain, all its pieces together, at whose ends the distance is measured.
const PARTS: usize = 24;

/// The same where the other surface is a function, for which a nearest place is a long search.
const PARTS_BY_FUNCTION: usize = 12;

/// Parts for each triangle of a mesh along one direction, up to `DEVIATION_PARTS` of all of them: between the
/// places are hills of the size of triangles.
const PARTS_OF_TRIANGLE: f64 = 3.0;

impl Surface {
    /// How far this surface is from another one or from a mesh: its places on a grid, and from the
    /// farthest of these on uphill.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn deviation_from(&self, datum: &DeviationReference<'_>) -> Result<Deviation, GeomError> {
        let parts = match datum {
            DeviationReference::Function(_) => PARTS_BY_FUNCTION,
            DeviationReference::Surface(_) => PARTS,
            DeviationReference::Mesh(mesh) => {
                let parts = PARTS_OF_TRIANGLE * (mesh.n_triangles() as f64).sqrt();
                (parts as usize).clamp(PARTS, DEVIATION_PARTS)
            }
        };
        let (us, vs) = self.places_for(parts);
        let distance = |[u, v]: [f64; 2]| datum.distance(self.point_at(u, v)?);
        let (mut max, mut sum) = (f64::NEG_INFINITY, 0.0);
        let mut place = [self.domain_u().start(), self.domain_v().start()];
        for &u in &us {
            for &v in &vs {
                let here = distance([u, v])?;
                sum += here;
                if max < here {
                    (max, place) = (here, [u, v]);
                }
            }
        }
        let mean = sum / (us.len() * vs.len()) as f64;
        let domains = [self.domain_u(), self.domain_v()];
        let counts = [us.len(), vs.len()];
        let steps = [0, 1].map(|i| domains[i].length() / counts[i] as f64);
        let ways = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];
        (place, max) = climbed((place, max), steps, &ways, SURFACE_CLIMB_STEPS, |beside| {
            let inside = |i: usize| beside[i].clamp(domains[i].start(), domains[i].end());
            let there = [inside(0), inside(1)];
            Ok::<_, GeomError>(Some((there, distance(there)?)))
        })?;
        Ok(Deviation { max, mean, at: self.point_at(place[0], place[1])? })
    }

    /// Parameters over all pieces, their ends among them.
    fn places_for(&self, parts: usize) -> (Vec<f64>, Vec<f64>) {
        let of_knots = |knots: &KnotVector| {
            let breaks = knots.breaks();
            let n = (parts / (breaks.len() - 1)).max(2);
            let mut places: Vec<f64> = Vec::new();
            for pair in breaks.windows(2) {
                places.extend((0..n).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / n as f64));
            }
            places.extend(breaks.last());
            places
        };
        match self {
            Self::Nurbs(surface) => (of_knots(surface.knots_u()), of_knots(surface.knots_v())),
            Self::Parametric(_) => (self.domain_u().steps(parts), self.domain_v().steps(parts)),
        }
    }
}
