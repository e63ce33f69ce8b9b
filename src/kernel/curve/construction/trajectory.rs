//! Curves of what is followed by its rate.

use glam::DVec3;

use super::hermite::{self, HermiteNode};
use crate::{CountError, GeomError, NurbsCurve, numeric::trajectory_nodes::Trajectory};

impl NurbsCurve {
    /// The curve over the range of a trajectory along which three components of its state run, from the one
    /// at `first` on: C2, of degree five, with a knot of multiplicity three at each node. Components that the
    /// state does not have are 0.
    ///
    /// ```
    /// use virote_kernel::{NurbsCurve, find_trajectory};
    ///
    /// let rate = |_: f64, p: &[f64]| Ok::<_, ()>(vec![-p[1], p[0], 0.0]);
    /// let turned = find_trajectory(rate, &[1.0, 0.0, 0.0], [0.0, 3.0], 1e-9).map_err(|_| "no trajectory")?;
    /// let curve = NurbsCurve::of_trajectory(&turned, 0).map_err(|_| "no curve")?;
    /// assert!((curve.point_at(2.0).length() - 1.0).abs() < 1e-9);
    /// # Ok::<(), &str>(())
    /// ```
    ///
    /// # Errors
    /// [`CountError::TooFewPoints`] below two nodes; [`crate::InputError::NotFinite`] where it is too large.
    pub fn of_trajectory(trajectory: &Trajectory, first: usize) -> Result<Self, GeomError> {
        let got = trajectory.nodes.len();
        if got < 2 {
            return Err(CountError::TooFewPoints { got, needed: 2 }.into());
        }
        let part =
            |parts: &[f64], i: usize| parts.get(first.saturating_add(i)).copied().unwrap_or(0.0);
        let point = |parts: &[f64]| DVec3::from([0, 1, 2].map(|i| part(parts, i)));
        let nodes = trajectory.nodes.iter().map(|node| HermiteNode {
            parameter: node.place,
            derivatives: vec![point(&node.state), point(&node.rate), point(&node.second)],
        });
        hermite::spline(&[nodes.collect()])
    }
}
