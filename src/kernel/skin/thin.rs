//! Sections on fewer knots.

use super::CompatibleSections;
use crate::{NurbsCurve, tolerance::FIRST_REMOVAL_SHARE, work};

impl CompatibleSections {
    /// The sections without the inner knots that none of them needs to stay within the tolerance
    /// of where it was.
    ///
    /// Piegl & Tiller, *Surface skinning revisited* (2002), ask for the same with other means.
    #[must_use]
    pub fn thinned(&self, tolerance: f64) -> Self {
        let mut curves = self.curves().to_vec();
        let mut part = FIRST_REMOVAL_SHARE;
        loop {
            let domain = curves[0].domain();
            let mut is_changed = false;
            for (t, times) in curves[0].knots().distinct() {
                if !work::goes_on(1) {
                    return Self::of(curves);
                }
                if t <= domain.start() || domain.end() <= t {
                    continue;
                }
                for _ in 0..times {
                    let Some(thin) = self.without(&curves, t, part * tolerance) else { break };
                    curves = thin;
                    is_changed = true;
                }
            }
            if is_changed {
                continue;
            }
            if 1.0 <= part {
                return Self::of(curves);
            }
            part = (4.0 * part).min(1.0);
        }
    }

    /// All curves with one knot less, if each stays that near to its section.
    fn without(&self, curves: &[NurbsCurve], t: f64, allowed: f64) -> Option<Vec<NurbsCurve>> {
        let one = |(curve, section): (&NurbsCurve, &NurbsCurve)| {
            // A removal beyond twice of what is allowed cannot be made up for.
            let thin = curve.without_knot(t, 1, 2.0 * allowed).ok()?;
            (section.deviation_from(&thin) <= allowed).then_some(thin)
        };
        curves.iter().zip(self.curves()).map(one).collect()
    }
}
