//! Sections that rails hold on their way: one that z points to, or two that both ends run along.

use std::sync::Arc;

use glam::DVec3;

use super::{Motion, PlacedAxes};
use crate::{GeomError, InputError, Interval, NurbsCurve, tolerance::VANISHING_RELATIVE};

/// A motion on rails: none, one or two, at equal fractions of their domains.
pub(super) struct RailedMotion<'a> {
    pub(super) motion: &'a mut dyn Motion,
    pub(super) rails: Vec<Arc<NurbsCurve>>,
    /// The section's ends, which two rails hold.
    pub(super) ends: [DVec3; 2],
    /// The path's.
    pub(super) domain: Interval,
}

impl Motion for RailedMotion<'_> {
    fn scale(&mut self, t: f64) -> Result<DVec3, GeomError> {
        self.motion.scale(t)
    }

    fn twist(&mut self, t: f64) -> Result<f64, GeomError> {
        self.motion.twist(t)
    }

    fn upwards(&mut self, t: f64, point: DVec3, x: DVec3) -> Result<Option<DVec3>, GeomError> {
        let [rail] = &self.rails[..] else { return self.motion.upwards(t, point, x) };
        let to_rail = rail.point_at(rail.domain().at(self.domain.fraction_of(t))) - point;
        let across = to_rail - x * to_rail.dot(x);
        match across.try_normalize() {
            Some(z) => Ok(Some(z)),
            None => Err(GeomError::Input(InputError::ParallelAxes {
                first: "the path",
                second: "the direction to the rail",
            })),
        }
    }

    fn held(&mut self, t: f64, point: DVec3, x: DVec3) -> Result<Option<PlacedAxes>, GeomError> {
        let [first, second] = &self.rails[..] else { return self.motion.held(t, point, x) };
        let f = self.domain.fraction_of(t);
        let [p, q] = [first, second].map(|rail| rail.point_at(rail.domain().at(f)));
        let (chord, span) = (self.ends[1] - self.ends[0], q - p);
        // Of both: along the chord, across it and the path, and the third.
        let basis = |along: DVec3, path: DVec3| {
            let along = along.try_normalize()?;
            let across = path.cross(along).try_normalize()?;
            Some([along, across, along.cross(across)])
        };
        let factor = span.length() / chord.length();
        let axes = match (basis(chord, DVec3::X), basis(span, x)) {
            (Some(own), Some(held)) => {
                let image = |axis: DVec3| {
                    (0..3).map(|i| held[i] * (factor * axis.dot(own[i]))).sum::<DVec3>()
                };
                [DVec3::X, DVec3::Y, DVec3::Z].map(image)
            }
            // Where the rails meet, the section is a point.
            _ if span.length() <= VANISHING_RELATIVE * chord.length() => [DVec3::ZERO; 3],
            _ => {
                return Err(InputError::ParallelAxes {
                    first: "the path",
                    second: "the direction from rail to rail",
                }
                .into());
            }
        };
        let [ax, ay, az] = axes;
        let start = ax * self.ends[0].x + ay * self.ends[0].y + az * self.ends[0].z;
        Ok(Some((axes, p - point - start)))
    }
}
