//! Other representations of a curve, and parts of it.

use crate::{
    ConstructionReport, DomainError, GeomError, Interval, bezier,
    curve::NurbsCurve,
    refine::ControlLines,
    tolerance::{KNOT_RELATIVE, PARAMETER_RELATIVE},
};

impl NurbsCurve {
    /// The same curve with more knots; a knot that is to be there twice is given twice.
    ///
    /// # Errors
    /// [`DomainError::ParameterOutside`] the domain; `KnotError::KnotMultiplicity` above p + 1.
    pub fn insert_knots(&self, knots: &[f64]) -> Result<Self, GeomError> {
        self.lines().with_knots(knots).map(Self::from_lines)
    }

    /// The same curve at another degree, not below its own.
    ///
    /// # Errors
    /// `DegreeError::DegreeTooLow`, `DegreeError::DegreeTooHigh`.
    pub fn elevate_degree(&self, degree: usize) -> Result<Self, GeomError> {
        self.lines().elevated(degree).map(Self::from_lines)
    }

    /// The Bézier curves that it consists of, each on its own part of the domain.
    #[must_use]
    pub fn decompose(&self) -> Vec<Self> {
        let piece = |span: usize| {
            let points = bezier::piece(&self.knots, &self.control_points, span);
            let ends = self.knots.span_interval(span);
            let start = vec![ends.start(); points.len()];
            let knots = self.knots.part([&start, &[], &vec![ends.end(); points.len()]]);
            Self::new_unchecked(knots, points)
        };
        self.knots.spans().map(piece).collect()
    }

    /// Both parts at `t`, each on its part of the domain, clamped where they were cut.
    ///
    /// # Errors
    /// [`DomainError::ParameterOutside`] the domain; [`DomainError::ParameterAtEnd`] of it.
    pub fn split(&self, t: f64) -> Result<[Self; 2], GeomError> {
        let domain = self.domain();
        let t = self.knots.snapped(domain.clamp_inside(t)?);
        if t <= domain.start() || domain.end() <= t {
            return Err(DomainError::ParameterAtEnd { parameter: t, domain }.into());
        }
        let (left, right) = self.lines().cut_at(t);
        Ok([left, right].map(Self::from_lines))
    }

    /// The parts between parameters in order, of which those beside its ends or one another are none.
    ///
    /// # Errors
    /// Those of [`Self::split`].
    pub(crate) fn parts_at(&self, places: &[f64]) -> Result<Vec<Self>, GeomError> {
        let (mut rest, mut parts) = (self.clone(), Vec::new());
        let dust = PARAMETER_RELATIVE * self.domain().length();
        for &t in places {
            let domain = rest.domain();
            if domain.start() + dust < t && t < domain.end() - dust {
                let [part, behind] = rest.split(t)?;
                parts.push(part);
                rest = behind;
            }
        }
        parts.push(rest);
        Ok(parts)
    }

    /// The part over an interval, with the parameters that it had, clamped at both ends.
    ///
    /// # Errors
    /// [`DomainError::ParameterOutside`] the domain; [`DomainError::NarrowInterval`] shorter than
    /// a span can be.
    pub fn trimmed(&self, interval: Interval) -> Result<Self, GeomError> {
        let domain = self.domain();
        let inside = |t: f64| domain.clamp_inside(t).map(|t| self.knots.snapped(t));
        let (start, end) = (inside(interval.start())?, inside(interval.end())?);
        if end - start <= KNOT_RELATIVE * domain.length() {
            return Err(DomainError::NarrowInterval { start, end }.into());
        }
        if let Some(part) = self.part_of_piece([start, end]) {
            return Ok(part);
        }
        let (_, rest) = self.lines().cut_at(start);
        Ok(Self::from_lines(rest.cut_at(end).0))
    }

    /// The same of two parameters within one span, where its control points there are those of its Bézier piece.
    fn part_of_piece(&self, [start, end]: [f64; 2]) -> Option<Self> {
        let (degree, knots) = (self.degree(), self.knots.as_slice());
        let span = self.knots.span_at(start);
        let (low, high) = (knots[span], knots[span + 1]);
        let is_piece = low <= knots[span + 1 - degree] && knots[span + degree] <= high;
        if degree == 0 || !is_piece || start < low || high < end {
            return None;
        }
        let mut points = self.control_points[self.knots.support(span)].to_vec();
        if low < start {
            bezier::cut_off(&mut points, (start - low) / (high - low), |_| ());
        }
        if end < high {
            let mut before = Vec::with_capacity(points.len());
            let fraction = (end - start) / (high - start);
            bezier::cut_off(&mut points, fraction, |point| before.push(point));
            points = before;
        }
        let ends = [start, end].map(|t| vec![t; degree + 1]);
        Some(Self::new_unchecked(self.knots.part([&ends[0], &ends[1], &[]]), points))
    }

    /// The same curve with knots that stand p + 1 times at both ends.
    #[must_use]
    pub fn clamped(&self) -> Self {
        Self::from_lines(self.lines().clamped())
    }

    /// The same points run through backwards, on the same domain.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let control_points = self.control_points.iter().rev().copied().collect();
        let knots = self.knots.reversed();
        Self { knots, control_points, report: ConstructionReport::NONE, ..self.clone() }
    }

    /// The same points over another domain.
    #[must_use]
    pub fn reparametrized(&self, domain: Interval) -> Self {
        Self { knots: self.knots.on(domain), ..self.clone() }
    }

    pub(in crate::curve) fn lines(&self) -> ControlLines {
        ControlLines { knots: self.knots.clone(), lines: vec![self.control_points.clone()] }
    }

    pub(in crate::curve) fn from_lines(lines: ControlLines) -> Self {
        let ControlLines { knots, lines } = lines;
        Self::new_unchecked(knots, lines.into_iter().flatten().collect())
    }
}
