//! The box of a face's border.

use glam::DVec3;

use super::{Face, lift::spline};
use crate::{
    Bounds, Curve, GeomError, Interval, ParametricCurve, bezier,
    ceiling::NEWTON_STEPS,
    homogeneous::place,
    numeric::newton::try_within_bracket,
    tolerance::{EDGE_SHARE, PLACE_RELATIVE},
};

/// Parts of a piece between whose ends a coordinate turns at most once.
const PIECE_PARTS: usize = 4;

/// A piece of a lifted arc.
struct BorderPiece {
    function: ParametricCurve,
    interval: Interval,
    /// What the spline near it stays inside of.
    hull: Bounds,
}

impl Face {
    /// The box of its border; none without one.
    ///
    /// The extrema of lifted arcs are looked for only where control points of the spline near them come
    /// out of the box of what is known, and are found on the surface itself; what is overlooked comes out by less than
    /// an eighth of the distance.
    pub(super) fn border_bounds(&self, distance: f64) -> Result<Option<Bounds>, GeomError> {
        let (mut whole, mut pieces): (Option<Bounds>, _) = (None, Vec::new());
        for arc in self.border_arcs(distance)?.iter() {
            let mut known = Bounds::of([arc.curve.start(), arc.curve.end()]);
            match &arc.curve {
                Curve::Nurbs(curve) => known = Some(curve.bounds()),
                Curve::Parametric(function) => {
                    let near = spline(&arc.curve, distance)?;
                    for span in near.knots().spans() {
                        let interval = near.knots().span_interval(span);
                        let piece = bezier::piece(near.knots(), near.control_points(), span);
                        let hull = Bounds::of(piece.into_iter().map(place));
                        let end = function.point_at(interval.end())?;
                        known = known.map(|known| known.with(end));
                        let piece =
                            |hull| BorderPiece { function: (**function).clone(), interval, hull };
                        pieces.extend(hull.map(piece));
                    }
                }
            }
            whole = whole.into_iter().chain(known).reduce(Bounds::union);
        }
        for piece in pieces {
            let bounds = match piece.comes_out(whole, EDGE_SHARE * distance) {
                [false, false, false] => continue,
                axes => piece.bounds(axes, distance)?,
            };
            whole = Some(whole.map_or(bounds, |whole| whole.union(bounds)));
        }
        Ok(whole)
    }
}

impl BorderPiece {
    /// Along which axes it may come out of what is known.
    fn comes_out(&self, known: Option<Bounds>, reach: f64) -> [bool; 3] {
        let Some(known) = known else { return [true; 3] };
        let reach = DVec3::splat(reach);
        let out = (self.hull.min - reach).cmplt(known.min) | known.max.cmplt(self.hull.max + reach);
        out.into()
    }

    /// The box of where it begins and ends, and of where a coordinate along one of the axes turns.
    fn bounds(&self, axes: [bool; 3], distance: f64) -> Result<Bounds, GeomError> {
        match self.turns(axes) {
            Ok(bounds) => Ok(bounds),
            // It stands still, or has no derivatives.
            Err(_) => Ok(spline(&self.function.trimmed(self.interval)?.into(), distance)?.bounds()),
        }
    }

    fn turns(&self, axes: [bool; 3]) -> Result<Bounds, GeomError> {
        let mut places = Vec::new();
        for t in self.interval.steps(PIECE_PARTS) {
            GeomError::go_on(1)?;
            places.push((t, self.function.derivatives_at(t, 1)?));
        }
        let start = places[0].1[0];
        let mut bounds = Bounds { min: start, max: start };
        for pair in places.windows(2) {
            let [(low, before), (high, behind)] = [&pair[0], &pair[1]];
            bounds = bounds.with(behind[0]);
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
                bounds = bounds.with(self.function.point_at(t)?);
            }
        }
        Ok(bounds)
    }
}
