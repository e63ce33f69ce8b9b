//! The tangents of a curve, as a curve in the plane of lines.
//!
//! The line Lx·x + Ly·y + Lc = 0 through a place C of a curve along its velocity is C × C′ in homogeneous
//! coordinates, of a Bézier piece of degree p a polynomial of degree 2p − 2. A line that is not steep is y = m·x + q,
//! and (m, q) = (−Lx, −Lc) / Ly is a rational curve; steep ones are x = m·y + q. Lines through a point are a line.
//! Farin, *NURBS: from Projective Geometry to Practical Use*, §3.7.

use glam::{DVec3, DVec4};

use crate::{
    Bounds, GeomError, Interval, KnotVector, NurbsCurve,
    bernstein::product,
    ceiling::DUAL_HALVINGS,
    curve::part::{CurvePart, parts},
    frame::widest_angle,
    tolerance::{ANALYTIC_RELATIVE, DUAL_CONE},
};

/// Which lines a part of the plane of lines has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Chart {
    /// No steeper than half a right angle.
    Flat,
    Steep,
}

impl Chart {
    pub(super) const BOTH: [Self; 2] = [Self::Flat, Self::Steep];
}

/// The tangents over a part of a curve; or the lines through a point.
#[derive(Clone, Debug)]
pub(super) struct DualPiece {
    pub(super) curve: NurbsCurve,
    pub(super) bounds: Bounds,
    /// Of which part of a curve it is, and over which parameters; none of a point.
    pub(super) of: Option<(usize, Interval)>,
}

/// The steepest that lines through a point are looked at in a chart: beyond 1, so that none is lost between charts.
const STEEPEST: f64 = 1.0625;

impl DualPiece {
    fn new(curve: NurbsCurve, of: Option<(usize, Interval)>) -> Self {
        let bounds = curve.bounds();
        Self { curve, bounds, of }
    }

    /// The lines through a point.
    ///
    /// # Errors
    /// Those of [`NurbsCurve::line`].
    pub(super) fn of_point(point: DVec3, chart: Chart) -> Result<Vec<Self>, GeomError> {
        let [x, y] = match chart {
            Chart::Flat => [point.x, point.y],
            Chart::Steep => [point.y, point.x],
        };
        let end = |m: f64| DVec3::new(m, y - m * x, 0.0);
        Ok(vec![Self::new(NurbsCurve::line(end(-STEEPEST), end(STEEPEST))?, None)])
    }

    /// The tangents of parts of a curve in z = 0 of a size about 1, for both charts. What is straight has none.
    ///
    /// # Errors
    /// `GeomError::Ended`; those of [`NurbsCurve::new`].
    pub(super) fn of_parts(smooth: &[NurbsCurve]) -> Result<[Vec<Self>; 2], GeomError> {
        let mut found = [Vec::new(), Vec::new()];
        let pieces = smooth
            .iter()
            .enumerate()
            .flat_map(|(i, own)| parts(own).into_iter().map(move |part| (i, part)));
        let is_bent = |part: &CurvePart| ANALYTIC_RELATIVE < part.deviation_from_chord();
        for (number, whole) in pieces.filter(|(_, part)| is_bent(part)) {
            let mut todo = vec![(whole, 0)];
            while let Some((part, depth)) = todo.pop() {
                GeomError::go_on(1)?;
                let lines = tangents(&part.points);
                let Some(axis) = axis(&lines) else {
                    // Beside a place where the curve stands still nothing is looked for.
                    if depth < DUAL_HALVINGS {
                        todo.extend(part.halves().map(|half| (half, depth + 1)));
                    }
                    continue;
                };
                for (chart, pieces) in Chart::BOTH.into_iter().zip(&mut found) {
                    if reaches(&lines, chart) {
                        let curve = in_chart(&lines, axis, chart)?;
                        pieces.push(Self::new(curve, Some((number, part.interval))));
                    }
                }
            }
        }
        Ok(found)
    }
}

/// The tangents of a Bézier piece.
fn tangents(points: &[DVec4]) -> Vec<DVec3> {
    let flat: Vec<DVec3> =
        points.iter().map(|point| DVec3::new(point.x, point.y, point.w)).collect();
    let n = flat.len() - 1;
    product(&flat[..n], &flat[1..], DVec3::cross)
}

/// The middle of the normals of lines, if all are within [`DUAL_CONE`] of it.
fn axis(lines: &[DVec3]) -> Option<DVec3> {
    let normals = || lines.iter().map(|line| line.with_z(0.0));
    let longest = normals().map(DVec3::length).fold(0.0, f64::max);
    if normals().any(|normal| normal.length() <= ANALYTIC_RELATIVE * longest) {
        return None;
    }
    let axis = normals().map(DVec3::normalize).sum::<DVec3>().try_normalize()?;
    (widest_angle(normals(), axis) <= DUAL_CONE).then_some(axis)
}

/// Whether some of lines, which turn by less than half a right angle, belong to a chart.
fn reaches(lines: &[DVec3], chart: Chart) -> bool {
    let steepness = |line: &DVec3| match chart {
        Chart::Flat => line.x.abs() - line.y.abs(),
        Chart::Steep => line.y.abs() - line.x.abs(),
    };
    lines.iter().any(|line| steepness(line) <= 0.0)
}

/// Lines with normals about an axis, as places of a chart.
fn in_chart(lines: &[DVec3], axis: DVec3, chart: Chart) -> Result<NurbsCurve, GeomError> {
    let weighted = |line: &DVec3| match chart {
        Chart::Flat => DVec4::new(-line.x, -line.z, 0.0, line.y) * axis.y.signum(),
        Chart::Steep => DVec4::new(-line.y, -line.z, 0.0, line.x) * axis.x.signum(),
    };
    let points: Vec<DVec4> = lines.iter().map(weighted).collect();
    NurbsCurve::new(KnotVector::bezier(points.len() - 1)?, points)
}
