//! The lines of a face as the page draws them: its edges, and lines of equal parameter.

use std::sync::Arc;

use glam::DVec3;

use super::encode::{EncodingItem, N_ISOCOMB, bending};
use crate::kernel::{
    Curve, Direction, Face, GeomError, Surface, Tolerance,
    tolerance::{DRAWING_DIGIT, PATH_RELATIVE},
};

impl EncodingItem {
    /// The edges of a face, and what of the lines of its surface is on it.
    pub(super) fn add_face_lines(&mut self, face: &Face) -> Result<(), GeomError> {
        let surface = Surface::Nurbs(Arc::clone(face.surface()));
        if face.is_whole() {
            return self.add_surface_lines(&[surface]);
        }
        // What a picture shows is within a part of its size; the document's tolerance is tried first.
        let seen = self.fineness.weld.max(PATH_RELATIVE * self.size);
        let tolerances =
            [self.fineness.weld, seen].map(|near| Tolerance::DEFAULT.with_distance(near));
        let mut edges = Vec::new();
        match first_of(tolerances, |tolerance| face.edges(tolerance)) {
            Ok(found) => {
                for edge in found {
                    let points = self.polyline(&edge.into())?.1;
                    edges.push(self.writer.places(&points));
                }
            }
            Err(why) => self.trouble = Some(format!("its edges are not drawn: {why}")),
        }
        self.writer.set("edges", edges.into());
        self.add_face_isocurves(face, tolerances)
    }

    /// What of the lines of a face's surface is on it.
    fn add_face_isocurves(
        &mut self,
        face: &Face,
        tolerances: [Tolerance; 2],
    ) -> Result<(), GeomError> {
        let (mut isocurves, mut isocombs) = (Vec::new(), Vec::new());
        for along in Direction::BOTH {
            let steps = face.surface().domain(along.other()).steps(self.n_isocurves + 1);
            for &at in &steps[1..steps.len() - 1] {
                let line = match along {
                    Direction::U => face.surface().isocurve_v(at),
                    Direction::V => face.surface().isocurve_u(at),
                };
                if line.bounds().diagonal() <= DRAWING_DIGIT * self.size {
                    continue;
                }
                let lines = std::slice::from_ref(&line);
                let parts = match first_of(tolerances, |tolerance| face.clipped(lines, tolerance)) {
                    Ok(parts) => parts,
                    // The face is there without a line that is drawn to please.
                    Err(why) => {
                        let told = || format!("some lines of equal parameter are not drawn: {why}");
                        self.trouble.get_or_insert_with(told);
                        continue;
                    }
                };
                for part in parts {
                    let part = Curve::from(part);
                    let (parameters, points) = self.finely(&part, N_ISOCOMB)?;
                    isocurves.push(self.writer.places(&points));
                    let bends: Vec<DVec3> = parameters.iter().map(|&t| bending(&part, t)).collect();
                    isocombs.push(self.writer.vectors(&bends));
                }
            }
        }
        self.writer.set("isocurves", isocurves.into());
        self.writer.set("isocombs", isocombs.into());
        Ok(())
    }
}

/// What is found within the first of these tolerances that it can be found within.
fn first_of<T>(
    [fine, rough]: [Tolerance; 2],
    find: impl Fn(Tolerance) -> Result<T, GeomError>,
) -> Result<T, GeomError> {
    find(fine).or_else(|why| if fine == rough { Err(why) } else { find(rough) })
}
