//! Splines that stand in for a function where all of a curve is asked about.
//!
//! The function is cut where it has no derivatives, at corners and at other singular places, and
//! between those a spline takes its exact derivatives at nodes, which come closer until the pieces
//! between them agree with the function. A function has no hull: what it does between the places
//! that are looked at, and shows in no derivative at a node, stays unknown.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    Bounds, FitError, GeomError, Interval, JumpError,
    ceiling::{FUNCTION_BREAKS, PIECES, SINGULAR_HALVINGS},
    curve::{
        NurbsCurve, ParametricCurve,
        construction::hermite::{self, HermiteNode},
    },
    frame::norm,
    tolerance::{
        KNOT_RELATIVE, LAST_BIT, SINGULAR_RELATIVE, STAND_IN_RELATIVE, SUSPICIOUS_RELATIVE,
    },
};

/// Order of the derivatives that a stand-in takes: pieces of degree 11, which agree to the last
/// digits with a piece of sine of one radian.
const ORDER: usize = 5;

/// Equal parts that the search for a stand-in begins with, so that what repeats itself shows.
const FIRST_PARTS: usize = 8;

/// Places of a piece at which its distance from the function is measured.
const N_PLACES: usize = 16;

/// Part of the tolerance that a piece may use up at those places, so that it holds between them.
const SAFETY: f64 = 0.5;

/// Fractions of a domain at which a function is not singular but by chance.
const PROBES: [f64; 3] = [0.414_213_562, 0.732_050_808, 0.123_105_626];

/// By how much a stand-in becomes coarser where a function computes too few digits.
const COARSER: f64 = 100.0;

/// Halvings that make a smooth piece near.
const SMOOTH_HALVINGS: usize = 6;

/// Widths up to which a piece is not halved, in units of what keeps two knots apart: halves are clearly wider than
/// that, and a spline has its derivatives that far from a knot.
const NARROWEST: f64 = 4.0;

/// What makes a whole number of one with twelve decimals.
const DIGITS: f64 = 1e12;

impl ParametricCurve {
    /// A quintic spline on the same domain whose points are within `tolerance` of the function's
    /// at the same parameters; with the function's point, first and second derivative at each
    /// knot, and C2 but where the function has no such derivatives.
    ///
    /// Hermite interpolation, whose error falls with the sixth power of a piece's width; a piece
    /// is halved until half of the tolerance holds at 16 places of it.
    /// de Boor, *A Practical Guide to Splines*, ch. I.
    ///
    /// # Errors
    /// [`FitError::NoSplineNear`] where [`PIECES`] do not suffice, [`GeomError::Jump`], and as
    /// [`Self::derivatives_at`].
    pub fn to_nurbs(&self, tolerance: f64) -> Result<NurbsCurve, GeomError> {
        self.spline(2, 1, [tolerance; 2])
    }

    /// The spline that questions about all of the curve are put to.
    ///
    /// It agrees with the function to 1e-13 of its size, or to the digits that the function
    /// computes; beside places without derivatives to 1e-6 of it.
    ///
    /// # Errors
    /// As [`Self::to_nurbs`].
    pub(in crate::curve) fn nurbs_approximation(&self) -> Result<Arc<NurbsCurve>, GeomError> {
        if let Some(known) = self.known_stand_in() {
            return Ok(known);
        }
        let bounds = Bounds::of(self.probes().iter().copied());
        let (size, magnitude) =
            bounds.map_or((0.0, 0.0), |bounds| (bounds.diagonal(), bounds.magnitude()));
        let rounding = COARSER * (LAST_BIT * magnitude).max(self.rounding());
        let most = SINGULAR_RELATIVE * size + rounding;
        let mut allowed = STAND_IN_RELATIVE * size + rounding;
        loop {
            match self.spline(ORDER, FIRST_PARTS, [allowed, most]) {
                Err(GeomError::Fit(FitError::NoSplineNear { .. })) if COARSER * allowed < most => {
                    allowed *= COARSER;
                }
                found => return found.map(|spline| self.keep_stand_in(spline)),
            }
        }
    }

    /// A spline of a function, as near as the first number where it is smooth, and as the second
    /// at singular places.
    fn spline(
        &self,
        order: usize,
        n_parts: usize,
        allowed: [f64; 2],
    ) -> Result<NurbsCurve, GeomError> {
        self.check_derivatives(order)?;
        let narrowest = NARROWEST * KNOT_RELATIVE * self.domain().length();
        let mut maker = HermiteFit { curve: self, order, n_parts, allowed, narrowest, n_pieces: 0 };
        hermite::spline(&maker.stretches()?)
    }

    /// Fails with what the function says, where it has derivatives at none of some places: singular ones
    /// are few.
    fn check_derivatives(&self, order: usize) -> Result<(), GeomError> {
        let places = PROBES.map(|share| self.domain().at(share));
        let mut answers = places.into_iter().map(|t| self.derivatives_at(t, order));
        let first = answers.next().unwrap_or(Ok(Vec::new()));
        match first {
            Err(failure) if answers.all(|answer| answer.is_err()) => Err(failure),
            _ => Ok(()),
        }
    }
}

impl NurbsCurve {
    /// Inner parameters where it is only continuous: the singular places of what it stands in for.
    pub(in crate::curve) fn breaks(&self) -> Vec<f64> {
        let domain = self.domain();
        let is_break = |&(t, times): &(f64, usize)| {
            self.degree() <= times && domain.start() < t && t < domain.end()
        };
        self.knots().distinct().into_iter().filter(is_break).map(|(t, _)| t).collect()
    }
}

/// The search for nodes.
struct HermiteFit<'c> {
    curve: &'c ParametricCurve,
    order: usize,
    n_parts: usize,
    allowed: [f64; 2],
    /// The width below which no piece is halved.
    narrowest: f64,
    n_pieces: usize,
}

/// Why there are no nodes.
enum HermiteFailure {
    /// The function has no derivatives at a parameter, or different ones on both sides.
    Break(f64),
    Error(GeomError),
}

impl From<GeomError> for HermiteFailure {
    fn from(error: GeomError) -> Self {
        Self::Error(error)
    }
}

/// On which side of a parameter derivatives are taken.
#[derive(Clone, Copy)]
enum DerivativeSide {
    Before,
    There,
    Behind,
}

impl HermiteFit<'_> {
    /// Nodes between which pieces are near the function, cut at singular places.
    fn stretches(&mut self) -> Result<Vec<Vec<HermiteNode>>, GeomError> {
        let domain = self.curve.domain();
        let mut breaks = vec![domain.start(), domain.end()];
        let mut stretches: Vec<Vec<HermiteNode>> = Vec::new();
        while stretches.len() + 1 < breaks.len() {
            let i = stretches.len();
            let (start, end) = (breaks[i], breaks[i + 1]);
            match self.stretch(start, end) {
                Ok(nodes) => stretches.push(nodes),
                Err(HermiteFailure::Error(error)) => return Err(error),
                Err(HermiteFailure::Break(at)) if FUNCTION_BREAKS < breaks.len() => {
                    return Err(self.not_near(at));
                }
                Err(HermiteFailure::Break(at)) => breaks.insert(i + 1, at),
            }
        }
        for pair in stretches.windows(2) {
            let gap = hermite::gap(&pair[0], &pair[1]);
            if self.allowed[1] < gap {
                return Err(JumpError::Function { parameter: pair[1][0].parameter, gap }.into());
            }
        }
        Ok(stretches)
    }

    /// Nodes from one break to the next.
    fn stretch(&mut self, start: f64, end: f64) -> Result<Vec<HermiteNode>, HermiteFailure> {
        let (first, last) = (
            self.end_node(start, DerivativeSide::Behind)?,
            self.end_node(end, DerivativeSide::Before)?,
        );
        // Between breaks that are hardly apart there is no room for all parts.
        let n_parts = self.n_parts.min(((end - start) / self.narrowest) as usize).max(1);
        let mut inner = Vec::new();
        for i in 1..n_parts {
            let fraction = i as f64 / n_parts as f64;
            let t = start * (1.0 - fraction) + end * fraction;
            inner.push(self.inner_node(t)?);
        }
        let corners: Vec<HermiteNode> = [first].into_iter().chain(inner).chain([last]).collect();
        let mut todo: Vec<(HermiteNode, HermiteNode)> =
            corners.windows(2).rev().map(|pair| (pair[0].clone(), pair[1].clone())).collect();
        let mut nodes = vec![corners[0].clone()];
        while let Some((a, b)) = todo.pop() {
            GeomError::go_on(1)?;
            let width = b.parameter - a.parameter;
            if self.is_near(&a, &b, self.allowed[0])? {
                nodes.push(b);
            } else if width <= self.narrowest {
                let (a, b) = self.calmed(a, b, [start, end])?;
                if let Some(before) = nodes.last_mut() {
                    *before = a;
                }
                nodes.push(b);
            } else {
                if width <= SUSPICIOUS_RELATIVE * (end - start) {
                    self.look_for_break(&a, &b, [start, end])?;
                }
                let middle = self.inner_node(0.5 * (a.parameter + b.parameter))?;
                todo.push((middle.clone(), b));
                todo.push((a, middle));
            }
            self.n_pieces += 1;
            if PIECES < self.n_pieces {
                let parameter = nodes[nodes.len() - 1].parameter;
                return Err(self.not_near(parameter).into());
            }
        }
        Ok(nodes)
    }

    /// Fails with a singular place between two nodes, unless it is at an end of the stretch or
    /// there is none: halves of a smooth piece are near after a few halvings.
    fn look_for_break(
        &self,
        a: &HermiteNode,
        b: &HermiteNode,
        ends: [f64; 2],
    ) -> Result<(), HermiteFailure> {
        let whole = b.parameter - a.parameter;
        let (mut low, mut high) = (a.clone(), b.clone());
        for n_halvings in 0..SINGULAR_HALVINGS {
            let middle = 0.5 * (low.parameter + high.parameter);
            let width = high.parameter - low.parameter;
            if width <= LAST_BIT * middle.abs().max(ends[1] - ends[0]) {
                break;
            }
            let middle = match self.inner_node(middle) {
                Err(HermiteFailure::Break(at)) => return self.told_break(at, ends),
                found => found?,
            };
            if !self.is_near(&low, &middle, self.allowed[0])? {
                high = middle;
            } else if !self.is_near(&middle, &high, self.allowed[0])? {
                low = middle;
            } else if n_halvings < SMOOTH_HALVINGS {
                return Ok(());
            } else if low.jump(&middle, whole) < middle.jump(&high, whole) {
                low = middle;
            } else {
                high = middle;
            }
        }
        self.told_break(shortest_between(low.parameter, high.parameter), ends)
    }

    /// Fails with a singular place where there is room for a stretch on both sides of it.
    fn told_break(&self, at: f64, ends: [f64; 2]) -> Result<(), HermiteFailure> {
        let is_inside = self.narrowest < at - ends[0] && self.narrowest < ends[1] - at;
        if is_inside { Err(HermiteFailure::Break(at)) } else { Ok(()) }
    }

    /// The nodes of a piece that cannot be halved, which at an end of the stretch has a straight
    /// end; at such a singular place the larger tolerance holds.
    fn calmed(
        &self,
        a: HermiteNode,
        b: HermiteNode,
        ends: [f64; 2],
    ) -> Result<(HermiteNode, HermiteNode), HermiteFailure> {
        let (at, is_first, is_last) = (a.parameter, a.parameter <= ends[0], ends[1] <= b.parameter);
        let start = if is_first { a.towards(&b) } else { a.clone() };
        let end = if is_last { b.towards(&a) } else { b };
        if (is_first || is_last) && self.is_near(&start, &end, self.allowed[1])? {
            return Ok((start, end));
        }
        Err(self.not_near(at).into())
    }

    /// A node at an end of a stretch, with derivatives from inside; where there are none it
    /// stands still.
    fn end_node(&self, t: f64, from: DerivativeSide) -> Result<HermiteNode, GeomError> {
        let domain = self.curve.domain();
        let is_end = t <= domain.start() || domain.end() <= t;
        if is_end && let Ok(node) = self.node(t, DerivativeSide::There) {
            return Ok(node);
        }
        if let Ok(mut node) = self.node(t, from) {
            if is_end {
                node.derivatives[0] = self.curve.point_at(t)?;
            }
            return Ok(node);
        }
        let mut derivatives = vec![DVec3::ZERO; self.order + 1];
        derivatives[0] = self.curve.point_at(t)?;
        Ok(HermiteNode { parameter: t, derivatives })
    }

    /// A node where the function goes on.
    fn inner_node(&self, t: f64) -> Result<HermiteNode, HermiteFailure> {
        self.node(t, DerivativeSide::There).map_err(|error| {
            // With a point, but without derivatives, it is a singular place.
            if self.curve.point_at(t).is_ok() { HermiteFailure::Break(t) } else { error.into() }
        })
    }

    fn node(&self, t: f64, from: DerivativeSide) -> Result<HermiteNode, GeomError> {
        let step = 2.0 * LAST_BIT * t.abs().max(self.curve.domain().length());
        let place = match from {
            DerivativeSide::Before => t - step,
            DerivativeSide::There => t,
            DerivativeSide::Behind => t + step,
        };
        let derivatives = self.curve.derivatives_at(place, self.order)?;
        Ok(HermiteNode { parameter: t, derivatives })
    }

    /// Whether the piece between two nodes is as near as that to the function.
    fn is_near(&self, a: &HermiteNode, b: &HermiteNode, allowed: f64) -> Result<bool, GeomError> {
        let piece = hermite::piece(a, b);
        let part = match Interval::new(a.parameter, b.parameter) {
            Ok(part) => part,
            Err(_) => return Ok(true),
        };
        for i in 0..N_PLACES {
            // No place at an end, where both agree, nor at the middle alone.
            let fraction = (i as f64 + 0.5) / N_PLACES as f64;
            let point = self.curve.point_at(part.at(fraction))?;
            let apart = norm(point - hermite::point_of(&piece, fraction));
            let is_near = apart <= SAFETY * allowed;
            if !is_near {
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn not_near(&self, parameter: f64) -> GeomError {
        GeomError::Fit(FitError::NoSplineNear { tolerance: self.allowed[1], parameter })
    }
}

/// A number between two that are rounding apart: one with few digits, if there is any, because
/// that is what somebody wrote.
fn shortest_between(low: f64, high: f64) -> f64 {
    let rounded = (high * DIGITS).round() / DIGITS;
    if low <= rounded && rounded <= high { rounded } else { high }
}
