//! The shape of a surface near a pole, where its own derivatives no longer tell it.
//!
//! At the distance w from a collapsed edge Su = w·T and Suu = w·R, so that II(Su, Su)/|Su|² is
//! n·R/(w·|T|²): of order one, where rounding of derivatives at the place leaves some 1e-16/w². With the
//! Taylor series of T, R and Sv at the edge (T × Sv)·R is a series in w whose first coefficient is zero at
//! a pole, and w divides what is left without rounding.

use glam::DVec3;

use crate::{
    Direction, Grid,
    frame::{norm, unit},
    surface::{Surface, SurfaceShape},
    tolerance::{NEAR_POLE_REST, NEAR_POLE_SHARE, VANISHING_RELATIVE},
};

/// Coefficients of each series.
const N_TERMS: usize = 7;

/// Taylor coefficients by the distance from the edge.
type Series = [DVec3; N_TERMS];

/// How a surface leaves a place of a collapsed edge: T, R and Sv of the header.
struct EdgeSeries {
    turn: Series,
    bend: Series,
    leg: Series,
    /// What rounding leaves in their first coefficients.
    rounding: [f64; 3],
    /// The width of the piece across the edge, in its parameter.
    reach: f64,
}

impl Surface {
    /// The shape at a place from the series at a collapsed edge beside it; `None` beside the tip of a cone, and where
    /// there is no such edge so near.
    pub(in crate::surface) fn shape_near_pole(&self, u: f64, v: f64) -> Option<SurfaceShape> {
        let edges = [(Direction::U, v, self.domain_v()), (Direction::V, u, self.domain_u())];
        edges.into_iter().find_map(|(along, t, domain)| {
            [domain.start(), domain.end()].into_iter().find_map(|end| {
                let [edge_u, edge_v] = match along {
                    Direction::U => [u, end],
                    Direction::V => [end, v],
                };
                let (w, widths) = (t - end, self.widths_at(edge_u, edge_v));
                let [width, reach] = [widths[along], widths[along.other()]];
                if w == 0.0 || NEAR_POLE_SHARE * reach < w.abs() {
                    return None;
                }
                let found = self.derivatives_at(edge_u, edge_v, N_TERMS + 1).ok()?;
                let derivatives = match along {
                    Direction::U => found,
                    Direction::V => found.transposed(),
                };
                let series = EdgeSeries::new(&derivatives, [width, reach], w)?;
                series.shape(self.point_at(u, v).ok()?, w, along)
            })
        })
    }
}

impl EdgeSeries {
    /// From derivatives at the edge, first index along it; `None` where it is not collapsed, or where the series
    /// take more terms.
    fn new(derivatives: &Grid<DVec3>, [width, reach]: [f64; 2], w: f64) -> Option<Self> {
        let size = derivatives.get(0, 0).abs().max_element() + norm(derivatives.get(0, 1)) * reach;
        let is_still = |step: DVec3| norm(step) <= VANISHING_RELATIVE * size;
        if !(is_still(derivatives.get(1, 0) * width)
            && is_still(derivatives.get(2, 0) * (width * width)))
        {
            return None;
        }
        let coefficients = |along: usize, factorial: usize| -> Series {
            let mut divisor = 1.0;
            std::array::from_fn(|k| {
                divisor *= if k == 0 { 1.0 } else { (k + factorial) as f64 };
                derivatives.get(along, k + 1) / divisor
            })
        };
        let rounding =
            [width, width * width, 1.0].map(|step| VANISHING_RELATIVE * size / (step * reach));
        let [turn, bend, leg] = [(1, 1), (2, 1), (0, 0)].map(|(k, first)| coefficients(k, first));
        let found = Self { turn, bend, leg, rounding, reach };
        let last = [&found.turn, &found.bend, &found.leg].map(|series| {
            let power = (1..N_TERMS).fold(1.0, |power, _| power * w.abs());
            norm(series[N_TERMS - 1]) * power
        });
        let [turn, _, leg] = found.values(w).map(norm);
        let is_enough = last[0].max(last[1] * width) <= NEAR_POLE_REST * turn
            && last[2] <= NEAR_POLE_REST * leg;
        is_enough.then_some(found)
    }

    fn values(&self, w: f64) -> [DVec3; 3] {
        [&self.turn, &self.bend, &self.leg]
            .map(|series| series.iter().rev().fold(DVec3::ZERO, |sum, &term| sum * w + term))
    }

    /// The shape at a point at the distance w; `None` where the normals of the edge differ.
    fn shape(&self, point: DVec3, w: f64, along: Direction) -> Option<SurfaceShape> {
        let [turn, _, leg] = self.values(w);
        let (x, normal) = (unit(turn)?, unit(turn.cross(leg))?);
        let y = normal.cross(x);
        let (skew, height) = (leg.dot(x), leg.dot(y));
        // What steps along the edge, one along and one across, and steps across give.
        let bent = self.divided_product(w)? / (norm(turn.cross(leg)) * turn.length_squared());
        let twist = normal.dot(slope(&self.turn, w)) / norm(turn);
        let rise = normal.dot(slope(&self.leg, w));
        let across = [-skew / height, 1.0 / height];
        let side = if along == Direction::U { w.signum() } else { -w.signum() };
        let [a, b, c] = [
            bent,
            across[0] * bent + across[1] * twist,
            across[0] * (across[0] * bent + 2.0 * across[1] * twist) + across[1] * across[1] * rise,
        ]
        .map(|entry| side * entry);
        // Along Su, and at right angles to it about the surface's normal.
        let (cosine, sine) = match along {
            Direction::U => (w.signum(), 0.0),
            Direction::V => (skew / norm(leg), height / norm(leg)),
        };
        let tensor = [
            a * cosine * cosine + 2.0 * b * cosine * sine + c * sine * sine,
            side * ((c - a) * cosine * sine + b * (cosine * cosine - sine * sine)),
            a * sine * sine - 2.0 * b * cosine * sine + c * cosine * cosine,
        ];
        let (normal, first) = (side * normal, cosine * x + sine * y);
        let extent = norm(leg) * self.reach;
        let coordinates = point.abs().max_element() + extent;
        let rounding = VANISHING_RELATIVE * coordinates / extent / extent;
        let axes = [first, normal.cross(first)];
        let shape = SurfaceShape { point, normal, axes, tensor, extent, rounding };
        tensor.iter().all(|entry| entry.is_finite()).then_some(shape)
    }

    /// (T × Sv)·R/w; `None` where it does not vanish at the edge.
    fn divided_product(&self, w: f64) -> Option<f64> {
        let coefficient = |k: usize| -> f64 {
            let pairs = (0..=k).flat_map(|i| (0..=k - i).map(move |j| (i, j)));
            pairs.map(|(i, j)| self.turn[i].cross(self.leg[j]).dot(self.bend[k - i - j])).sum()
        };
        let [turn, bend, leg] = [&self.turn, &self.bend, &self.leg].map(|series| norm(series[0]));
        let [turn_off, bend_off, leg_off] = self.rounding;
        let rounding = turn_off * bend * leg + turn * bend_off * leg + turn * bend * leg_off;
        if rounding < coefficient(0).abs() {
            return None;
        }
        Some((1..N_TERMS).rev().fold(0.0, |sum, k| sum * w + coefficient(k)))
    }
}

/// The derivative of a series.
fn slope(series: &Series, w: f64) -> DVec3 {
    (1..N_TERMS).rev().fold(DVec3::ZERO, |sum, k| sum * w + series[k] * k as f64)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use crate::{Frame, GeomError, NurbsSurface, Surface};

    fn worst(surface: &Surface, curvature: f64, place: impl Fn(f64) -> [f64; 2]) -> f64 {
        let distances = (1..60).map(|k| libm::exp2(-0.85 * f64::from(k)));
        let off = |w: f64| {
            let [u, v] = place(w);
            let shape = surface.shape_at(u, v).map(|shape| shape.curvatures());
            shape.map_or(f64::INFINITY, |[k1, k2]| {
                (k1 - curvature).abs().max((k2 - curvature).abs())
            })
        };
        distances.map(off).fold(0.0, f64::max) / curvature.abs()
    }

    #[test]
    fn the_curvature_of_a_ball_has_its_digits_up_to_the_poles() -> Result<(), GeomError> {
        let frame =
            Frame::from_normal(DVec3::new(100.0, -3.0, 7.0), DVec3::new(1.0, 2.0, -0.5), None)?;
        let ball = Surface::from(NurbsSurface::sphere(frame, 10.0)?);
        let swapped = ball.swapped()?;
        for u in [0.0, 0.07, 0.25, 0.6, 0.999] {
            assert!(worst(&ball, -0.1, |w| [u, 1.0 - w]) < 1e-8);
            assert!(worst(&ball, -0.1, |w| [u, w]) < 1e-8);
            assert!(worst(&swapped, 0.1, |w| [1.0 - w, u]) < 1e-8);
            assert!(worst(&swapped, 0.1, |w| [w, u]) < 1e-8);
        }
        Ok(())
    }
}
