//! How the parameters that a rule finds grow with their points.

use glam::{DVec3, DVec4};

use super::Parametrization;

/// How parameters by a rule grow with their points.
#[derive(Clone, Debug)]
pub(super) struct LegGrowths {
    /// How each step grows with the way from its point to the next one.
    legs: Vec<DVec3>,
    /// All steps together.
    sum: f64,
}

impl Parametrization {
    /// How its steps grow with points that follow one another; none by [`Parametrization::Foley`].
    pub(super) fn leg_growths(self, points: &[DVec3]) -> Option<LegGrowths> {
        let step = |ends: &[DVec3]| {
            let leg = ends[1] - ends[0];
            let length = leg.length();
            match self {
                Self::Uniform => Some((1.0, DVec3::ZERO)),
                Self::Chord => Some((length, leg / length)),
                Self::Centripetal => Some((length.sqrt(), leg / (2.0 * length * length.sqrt()))),
                Self::Foley => None,
            }
        };
        let steps: Vec<(f64, DVec3)> = points.windows(2).map(step).collect::<Option<_>>()?;
        let sum = steps.iter().map(|(length, _)| length).sum();
        Some(LegGrowths { legs: steps.into_iter().map(|(_, growth)| growth).collect(), sum })
    }
}

impl LegGrowths {
    /// Along what each step grows.
    pub(super) fn along(&self) -> &[DVec3] {
        &self.legs
    }

    /// How something grows with each step, from its growths with the parameters, the first and last of which stay.
    pub(super) fn with_steps(&self, parameters: &[f64], growths: &[DVec4]) -> Vec<DVec3> {
        let inner = 1..parameters.len() - 1;
        let held: DVec4 = inner.clone().map(|i| growths[i] * parameters[i]).sum();
        let mut all = vec![-held.truncate() / self.sum; self.legs.len()];
        let mut behind = DVec4::ZERO;
        for i in inner.rev() {
            behind += growths[i];
            all[i - 1] += behind.truncate() / self.sum;
        }
        all
    }
}
