//! A surface along one of its parameter lines, seen from one side of it.

use glam::DVec3;

use crate::{
    Curve, Direction, GeomError, Interval, KnotVector, Side,
    ceiling::POLISHING_STEPS,
    frame::norm,
    numeric::newton::improved,
    surface::{
        Edge, Surface,
        evaluation::two_sided::{ORDER, TwoSidedSample},
    },
    tolerance::KNOT_RELATIVE,
};

/// Places of one piece of an edge, at least; of a function, in all.
const FEWEST: usize = 33;

/// Places of one piece of an edge, at most.
const MOST: usize = 129;

/// Seeds along the edge of a function for its place nearest to a point.
const SEEDS: usize = 256;

/// A parameter line of a surface, and the side of it on which the surface is looked at.
#[derive(Clone, Copy, Debug)]
pub(in crate::surface) struct SurfaceBorder<'a> {
    surface: &'a Surface,
    /// The direction that leaves the line: the parameter that is constant along it.
    across: Direction,
    /// The parameter that is constant.
    at: f64,
    /// The surface is looked at where this parameter is smaller, left, or larger.
    side: Side,
}

impl<'a> SurfaceBorder<'a> {
    pub(in crate::surface) fn edge(surface: &'a Surface, edge: Edge) -> Self {
        let (u, v) = (surface.domain_u(), surface.domain_v());
        let (across, at, side) = match edge {
            Edge::U0 => (Direction::U, u.start(), Side::Right),
            Edge::U1 => (Direction::U, u.end(), Side::Left),
            Edge::V0 => (Direction::V, v.start(), Side::Right),
            Edge::V1 => (Direction::V, v.end(), Side::Left),
        };
        Self { surface, across, at, side }
    }

    /// Both sides of each inner knot that may be less than C3 across.
    pub(in crate::surface) fn inner_knots(surface: &'a Surface) -> Vec<[Self; 2]> {
        let Surface::Nurbs(nurbs) = surface else { return Vec::new() };
        let mut lines = Vec::new();
        for across in Direction::BOTH {
            let knots = nurbs.knots(across);
            let domain = knots.domain();
            let inner = knots.distinct().into_iter().filter(|&(t, times)| {
                domain.start() < t && t < domain.end() && knots.degree() < times + ORDER
            });
            lines.extend(inner.map(|(at, _)| {
                [Side::Left, Side::Right].map(|side| Self { surface, across, at, side })
            }));
        }
        lines
    }

    /// The parameters along the line.
    pub(in crate::surface) fn along(&self) -> Interval {
        self.surface.domain(self.across.other())
    }

    /// The parameters of the surface at a place of the line.
    pub(in crate::surface) fn place(&self, t: f64) -> (f64, f64) {
        self.across.pair(self.at, t).into()
    }

    fn point(&self, t: f64) -> Result<DVec3, GeomError> {
        let (u, v) = self.place(t);
        self.surface.point_at(u, v)
    }

    fn curve(&self) -> Result<Curve, GeomError> {
        self.surface.isocurve(self.across.other(), self.at)
    }

    /// The length of a polyline along it.
    pub(in crate::surface) fn length(&self) -> Result<f64, GeomError> {
        let mut length = 0.0;
        let mut last = None;
        for t in self.along().steps(FEWEST) {
            let point = self.point(t)?;
            length += last.map_or(0.0, |last: DVec3| last.distance(point));
            last = Some(point);
        }
        Ok(length)
    }

    /// Whether the two lines are nearer to one another when one of them is reversed.
    pub(in crate::surface) fn runs_against(&self, other: &Self) -> Result<bool, GeomError> {
        let [with, against] = self.distances(other)?;
        Ok(against < with)
    }

    /// How far the two lines are apart at equal fractions, and with one of them reversed.
    pub(in crate::surface) fn distances(&self, other: &Self) -> Result<[f64; 2], GeomError> {
        let mut sums = [0.0; 2];
        for fraction in Interval::UNIT.steps(8) {
            let point = self.point(self.along().at(fraction))?;
            for (sum, fraction) in sums.iter_mut().zip([fraction, 1.0 - fraction]) {
                *sum += point.distance(other.point(other.along().at(fraction))?);
            }
        }
        Ok(sums)
    }

    /// The knots along the line; a function has none.
    fn knots(&self) -> Option<&KnotVector> {
        let nurbs = self.surface.nurbs().ok()?;
        Some(nurbs.knots(self.across.other()))
    }

    /// Fractions of the line, so many on each piece that a difference of what is compared between
    /// two splines vanishes if it does so at all of them: with every joint of either line.
    fn fractions(&self, other: &Self, is_reversed: bool) -> Vec<f64> {
        let mut breaks = vec![0.0, 1.0];
        let mut degree = 0;
        for (line, turns) in [(self, false), (other, is_reversed)] {
            let Some(knots) = line.knots() else { continue };
            degree += knots.degree();
            let fractions = knots.breaks().into_iter().map(|t| line.along().fraction_of(t));
            breaks.extend(fractions.map(|f| if turns { 1.0 - f } else { f }));
        }
        breaks.sort_by(f64::total_cmp);
        breaks.dedup_by(|a, b| *a - *b <= KNOT_RELATIVE);
        let n = (4 * degree + 1).clamp(FEWEST, MOST);
        let n = if degree == 0 { MOST } else { n };
        let mut fractions = Vec::new();
        for pair in breaks.windows(2) {
            fractions.extend((0..n - 1).map(|i| {
                let angle = std::f64::consts::PI * i as f64 / (n - 1) as f64;
                pair[0] + (pair[1] - pair[0]) * 0.5 * (1.0 - libm::cos(angle))
            }));
        }
        fractions.push(1.0);
        fractions
    }

    /// Both sides at equal fractions of the lines.
    pub(in crate::surface) fn pairs(
        &self,
        other: &Self,
        is_reversed: bool,
    ) -> Result<Vec<[TwoSidedSample; 2]>, GeomError> {
        let pair = |fraction: f64| {
            let (beside, side) =
                if is_reversed { (1.0 - fraction, Side::Left) } else { (fraction, Side::Right) };
            let here = self.look(self.along().at(fraction), Side::Right)?;
            Ok([here, other.look(other.along().at(beside), side)?])
        };
        self.fractions(other, is_reversed).into_iter().map(pair).collect()
    }

    /// Both sides at places of this line and those of the other that are nearest to them.
    pub(in crate::surface) fn nearest_pairs(
        &self,
        other: &Self,
    ) -> Result<Vec<[TwoSidedSample; 2]>, GeomError> {
        let nearest = other.nearest()?;
        let pair = |fraction: f64| {
            let here = self.look(self.along().at(fraction), Side::Right)?;
            let beside = nearest.parameter(here.point())?;
            Ok([here, other.look(beside, Side::Right)?])
        };
        self.fractions(other, false).into_iter().map(pair).collect()
    }

    /// The place of this line that is furthest from another, with its distance.
    pub(in crate::surface) fn farthest_from(
        &self,
        other: &Self,
    ) -> Result<Option<(f64, DVec3)>, GeomError> {
        let nearest = other.nearest()?;
        let mut farthest: Option<(f64, DVec3)> = None;
        for fraction in self.fractions(other, false) {
            let point = self.point(self.along().at(fraction))?;
            let distance = point.distance(other.point(nearest.parameter(point)?)?);
            if farthest.is_none_or(|(most, _)| most < distance) {
                farthest = Some((distance, point));
            }
        }
        Ok(farthest)
    }

    /// What finds the place of the line that is nearest to a point.
    pub(in crate::surface) fn nearest(&self) -> Result<LineDistance, GeomError> {
        let curve = self.curve()?;
        let mut seeds = Vec::new();
        if curve.nurbs().is_err() {
            for t in curve.domain().steps(SEEDS) {
                seeds.push((t, curve.point_at(t)?));
            }
        }
        Ok(LineDistance { curve, seeds })
    }

    /// The point at a place of the line, and the derivative along it.
    pub(in crate::surface) fn step(&self, t: f64) -> Result<(DVec3, DVec3), GeomError> {
        let (u, v) = self.place(t);
        let [point, along_u, along_v] = self.surface.tangents_at(u, v)?;
        Ok((point, [along_u, along_v][self.across.other()]))
    }

    fn look(&self, t: f64, along: Side) -> Result<TwoSidedSample, GeomError> {
        let (u, v) = self.place(t);
        let sides = self.across.pair(self.side, along);
        let mut looked = match self.surface {
            Surface::Nurbs(surface) => {
                TwoSidedSample::of_nurbs(surface, [u, v], sides, self.across)
            }
            Surface::Parametric(surface) => {
                let space = surface.derivatives_at(u, v, ORDER)?;
                let widths = [surface.domain_u().length(), surface.domain_v().length()];
                TwoSidedSample::of_function(&space, widths, self.across)
            }
        };
        looked.is_end = self.side == Side::Left;
        Ok(looked)
    }
}

/// A line, ready to be asked for its place nearest to a point.
#[derive(Debug)]
pub(in crate::surface) struct LineDistance {
    curve: Curve,
    /// Parameters and points of a function.
    seeds: Vec<(f64, DVec3)>,
}

impl LineDistance {
    /// The parameter of the nearest place; of a function, by Newton's method from the nearest seed.
    pub(in crate::surface) fn parameter(&self, point: DVec3) -> Result<f64, GeomError> {
        let curve = &self.curve;
        if let Curve::Nurbs(curve) = curve {
            return Ok(curve.closest(point, 0.0).parameter);
        }
        let distance = |seed: &&(f64, DVec3)| seed.1.distance(point);
        let best = self.seeds.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let domain = curve.domain();
        let seed = best.map_or(domain.start(), |&(t, _)| t);
        improved(seed, POLISHING_STEPS, |&t| {
            let d = curve.derivatives_at(t, 2)?;
            let away = d[0] - point;
            let (slope, change) = (away.dot(d[1]), d[1].length_squared() + away.dot(d[2]));
            let next = (t - slope / change).clamp(domain.start(), domain.end());
            let is_nearer = next.is_finite() && curve.point_at(next)?.distance(point) < norm(away);
            Ok(is_nearer.then_some(next))
        })
    }
}
