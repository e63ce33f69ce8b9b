//! Legs of the borders of parts of a surface, and the lines that parts share.

use glam::{DVec2, DVec3};

use super::{
    arc_places::{SharedLine, at},
    chord::chord_deviation,
    surface_patch::Cells,
    trimmed::PartsTessellation,
};
use crate::{CountError, GeomError, NurbsCurve, bezier, ceiling::PARAMETER_HALVINGS};

/// By how much more than a leg's box must be allowed, for the triangles on it.
const LEG_ROOM: f64 = 1.3;

impl PartsTessellation<'_> {
    /// The line of constant parameter along which an arc runs that both of its sides share.
    pub(super) fn shared_line(&self, arc: &NurbsCurve) -> Option<SharedLine> {
        let points = arc.points();
        let is = |a: f64, b: f64| (a - b).abs() <= 0.0;
        (0..2).find_map(|across| {
            let value = points[0][across];
            let domain = self.sheet.domains()[across];
            let is_end = is(value, domain.start()) || is(value, domain.end());
            let is_seam = self.is_closed[across] && is_end;
            let is_crease = self.sheet.breaks[across].iter().any(|line| is(line.at, value));
            let is_line = points.iter().all(|point| is(point[across], value));
            let key = if is_seam { domain.start() } else { value };
            (is_line && (is_seam || is_crease)).then_some((across, key.to_bits()))
        })
    }

    /// Parameters of an arc between which legs may run, its ends among them.
    pub(super) fn stops(&self, arc: &NurbsCurve) -> Result<Vec<f64>, GeomError> {
        let most = self.most;
        let [longest_u, longest_v] = self.limits.longest;
        let stretch = DVec3::new(longest_u, longest_v, 0.0);
        let stretched = arc.transformed(&glam::DAffine3::from_scale(stretch));
        let mut stops = vec![arc.domain().start()];
        for span in arc.knots().spans() {
            let piece = bezier::piece(arc.knots(), stretched.control_points(), span);
            let mut todo = vec![(piece, arc.knots().span_interval(span), 0)];
            while let Some((piece, interval, n_halvings)) = todo.pop() {
                GeomError::go_on(1)?;
                let ends = [interval.start(), interval.end()].map(|t| at(arc, t));
                let is_near = chord_deviation(&piece, [piece[0], piece[piece.len() - 1]]);
                let fits = is_near <= self.leg_tolerance && leg_fits(&self.cells, ends);
                if fits || PARAMETER_HALVINGS <= n_halvings {
                    stops.push(interval.end());
                } else {
                    let (left, right) = bezier::cut_at(&piece, 0.5);
                    let [before, behind] = interval.halves();
                    todo.extend([(right, behind, n_halvings + 1), (left, before, n_halvings + 1)]);
                }
                let got = stops.len() + todo.len();
                if most < got {
                    return Err(CountError::TooManyVertices { got, most }.into());
                }
            }
        }
        Ok(stops)
    }
}

/// Whether limits allow a leg, and triangles on it.
fn leg_fits(cells: &Cells, [a, b]: [DVec2; 2]) -> bool {
    let (low, high) = (a.min(b), a.max(b));
    let wider = |low: f64, high: f64| {
        let room = 0.5 * (LEG_ROOM - 1.0) * (high - low);
        [low - room, high + room]
    };
    cells.allow([wider(low.x, high.x), wider(low.y, high.y)])
}
