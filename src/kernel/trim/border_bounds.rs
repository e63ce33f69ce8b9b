//! The box of a face's border.

use glam::DVec3;

use super::{Face, lift::spline};
use crate::{
    Bounds, Curve, GeomError, Interval, NurbsCurve, ParametricCurve,
    ceiling::NEWTON_STEPS,
    numeric::newton::try_within_bracket,
    tolerance::{EDGE_SHARE, PLACE_RELATIVE},
};

/// Parts of a piece between whose ends it is looked for turns.
const PIECE_PARTS: usize = 4;

/// Halvings of a piece of a border.
const HALVINGS: usize = 24;

/// A piece of a lifted arc.
struct BorderPiece<'c> {
    function: &'c ParametricCurve,
    /// A spline within an eighth of the distance.
    near: &'c NurbsCurve,
    interval: Interval,
    n_halvings: usize,
}

impl Face {
    /// The box of its border; none without one.
    ///
    /// The extrema of lifted arcs are looked for where control points of the spline near them come out of the box of
    /// what is known, and are found on the surface itself. Pieces are halved until none of their control points comes
    /// out by an eighth of the distance, so that what is overlooked comes out by less than a quarter of it.
    ///
    /// # Errors
    /// Those of [`Face::edges`].
    pub(super) fn border_bounds(&self, distance: f64) -> Result<Option<Bounds>, GeomError> {
        let arcs = self.border_arcs(distance)?;
        let mut found = BoxSoFar { known: None, reach: EDGE_SHARE * distance };
        let mut lifted = Vec::new();
        for arc in arcs.iter() {
            found.take([arc.curve.start(), arc.curve.end()]);
            match &arc.curve {
                Curve::Nurbs(curve) => found.take(curve.bounds().corners()),
                Curve::Parametric(function) => {
                    lifted.push((function, spline(&arc.curve, distance)?));
                }
            }
        }
        let mut pieces = Vec::new();
        for (function, near) in &lifted {
            for span in near.knots().spans() {
                let interval = near.knots().span_interval(span);
                found.take([function.point_at(interval.end())?]);
                pieces.push(BorderPiece { function, near, interval, n_halvings: 0 });
            }
        }
        while let Some(piece) = pieces.pop() {
            GeomError::go_on(1)?;
            let Some(hull) = piece.hull()? else { continue };
            let axes = found.comes_out(hull, 1.0);
            if axes == [false; 3] {
                continue;
            }
            match piece.turns(axes) {
                Ok(places) => found.take(places),
                // It stands still, or has no derivatives: what the spline knows.
                Err(_) => found.take(piece.near.trimmed(piece.interval)?.bounds().corners()),
            }
            if found.comes_out(hull, -1.0) != [false; 3] && piece.n_halvings < HALVINGS {
                let n_halvings = piece.n_halvings + 1;
                let halves = piece.interval.halves();
                pieces.extend(halves.map(|interval| BorderPiece { interval, n_halvings, ..piece }));
            }
        }
        Ok(found.known)
    }
}

/// The box of the places that were found.
struct BoxSoFar {
    known: Option<Bounds>,
    reach: f64,
}

impl BoxSoFar {
    fn take(&mut self, places: impl IntoIterator<Item = DVec3>) {
        self.known = self.known.into_iter().chain(Bounds::of(places)).reduce(Bounds::union);
    }

    /// Along which axes a box, which is larger by so many reaches, comes out of it.
    fn comes_out(&self, hull: Bounds, n_reaches: f64) -> [bool; 3] {
        let Some(known) = self.known else { return [true; 3] };
        let reach = DVec3::splat(n_reaches * self.reach);
        let out = (hull.min - reach).cmplt(known.min) | known.max.cmplt(hull.max + reach);
        out.into()
    }
}

impl BorderPiece<'_> {
    /// The box of the control points of the spline near it; none of what is too narrow to be cut out.
    fn hull(&self) -> Result<Option<Bounds>, GeomError> {
        GeomError::go_on(1)?;
        let part = self.near.trimmed(self.interval);
        Ok(part.ok().and_then(|part| Bounds::of(part.points())))
    }

    /// Places of it, and those where a coordinate along one of the axes turns between them.
    fn turns(&self, axes: [bool; 3]) -> Result<Vec<DVec3>, GeomError> {
        let mut looks = Vec::new();
        for t in self.interval.steps(PIECE_PARTS) {
            looks.push((t, self.function.derivatives_at(t, 1)?));
        }
        let mut places: Vec<DVec3> = looks.iter().map(|(_, derivatives)| derivatives[0]).collect();
        for pair in looks.windows(2) {
            let [(low, before), (high, behind)] = [&pair[0], &pair[1]];
            for axis in (0..3).filter(|&axis| axes[axis]) {
                let [from, to] = [before[1][axis], behind[1][axis]];
                if 0.0 <= from * to {
                    continue;
                }
                let is_still =
                    |a: f64, b: f64| (a - b).abs() <= PLACE_RELATIVE * self.interval.length();
                let middle = 0.5 * (low + high);
                let t = try_within_bracket([*low, *high], middle, NEWTON_STEPS, is_still, |t| {
                    let found = self.function.derivatives_at(t, 2)?;
                    Ok::<_, GeomError>(Some([1, 2].map(|k| to.signum() * found[k][axis])))
                })?;
                places.push(self.function.point_at(t)?);
            }
        }
        Ok(places)
    }
}
