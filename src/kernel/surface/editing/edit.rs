//! Other representations of a surface, and parts of it. What is done along one direction is done
//! to all splines of the net at once.

use crate::{
    ConstructionReport, DomainError, GeomError, Grid, Interval, KnotVector, bezier,
    surface::{Direction, NurbsSurface},
    tolerance::KNOT_RELATIVE,
};

impl NurbsSurface {
    /// The same surface with more knots along a direction; a knot that is to be there twice is
    /// given twice.
    ///
    /// # Errors
    /// [`DomainError::ParameterOutside`] the domain; `KnotError::KnotMultiplicity` above p + 1.
    pub fn insert_knots(&self, along: Direction, knots: &[f64]) -> Result<Self, GeomError> {
        self.lines(along).with_knots(knots).map(|lines| self.with_lines(along, lines))
    }

    /// The same surface at another degree along a direction, not below its own.
    ///
    /// # Errors
    /// `DegreeError::DegreeTooLow`, `DegreeError::DegreeTooHigh`.
    pub fn elevate_degree(&self, along: Direction, degree: usize) -> Result<Self, GeomError> {
        self.lines(along).elevated(degree).map(|lines| self.with_lines(along, lines))
    }

    /// The Bézier patches that it consists of, each on its own part of the domain; row i has those
    /// of the i-th span of u.
    ///
    /// O(p³) a column of a patch and O(q³) a row. Piegl & Tiller, *The NURBS Book*, A5.7.
    #[must_use]
    pub fn decompose(&self) -> Grid<Self> {
        let spans = [&self.knots_u, &self.knots_v].map(|knots| knots.spans().collect::<Vec<_>>());
        Grid::from_fn(spans[0].len(), spans[1].len(), |i, j| self.patch(spans[0][i], spans[1][j]))
    }

    /// The Bézier patch that it is over a pair of spans.
    pub(in crate::surface) fn patch(&self, span_u: usize, span_v: usize) -> Self {
        let knots = [&self.knots_u, &self.knots_v];
        let net = bezier::patch(knots, &self.control_points, span_u, span_v);
        let own = |knots: &KnotVector, span: usize| {
            let (ends, order) = (knots.span_interval(span), knots.degree() + 1);
            knots.part([&vec![ends.start(); order], &[], &vec![ends.end(); order]])
        };
        Self::new_unchecked(own(&self.knots_u, span_u), own(&self.knots_v, span_v), net)
    }

    /// Both parts at a parameter, each on its part of the domain, clamped where they were cut.
    ///
    /// # Errors
    /// [`DomainError::ParameterOutside`] the domain; [`DomainError::ParameterAtEnd`] of it.
    pub fn split(&self, along: Direction, t: f64) -> Result<[Self; 2], GeomError> {
        let domain = self.domain(along);
        let t = self.knots(along).snapped(domain.clamp_inside(t)?);
        if t <= domain.start() || domain.end() <= t {
            return Err(DomainError::ParameterAtEnd { parameter: t, domain }.into());
        }
        let (before, behind) = self.lines(along).cut_at(t);
        Ok([before, behind].map(|lines| self.with_lines(along, lines)))
    }

    /// The part over an interval of one parameter, with the parameters that it had, clamped at
    /// both ends of the interval.
    ///
    /// # Errors
    /// [`DomainError::ParameterOutside`] the domain; [`DomainError::NarrowInterval`] shorter than
    /// a span can be.
    pub fn trimmed(&self, along: Direction, interval: Interval) -> Result<Self, GeomError> {
        let (knots, domain) = (self.knots(along), self.domain(along));
        let inside = |t: f64| domain.clamp_inside(t).map(|t| knots.snapped(t));
        let (start, end) = (inside(interval.start())?, inside(interval.end())?);
        if end - start <= KNOT_RELATIVE * domain.length() {
            return Err(DomainError::NarrowInterval { start, end }.into());
        }
        let (_, rest) = self.lines(along).cut_at(start);
        Ok(self.with_lines(along, rest.cut_at(end).0))
    }

    /// The same surface with knots that stand p + 1 times at both ends of a direction.
    #[must_use]
    pub fn clamped(&self, along: Direction) -> Self {
        self.with_lines(along, self.lines(along).clamped())
    }

    /// The same points run through backwards along a direction, on the same domain: the normal
    /// turns around.
    #[must_use]
    pub fn reversed(&self, along: Direction) -> Self {
        let net = &self.control_points;
        let (last_row, last_column) = (net.n_rows() - 1, net.n_columns() - 1);
        let turned = Grid::from_fn(net.n_rows(), net.n_columns(), |i, j| match along {
            Direction::U => net.get(last_row - i, j),
            Direction::V => net.get(i, last_column - j),
        });
        let surface =
            Self { control_points: turned, report: ConstructionReport::NONE, ..self.clone() };
        surface.on_knots(along, self.knots(along).reversed())
    }

    /// The same points with u and v exchanged: the normal turns around.
    #[must_use]
    pub fn swapped(&self) -> Self {
        Self {
            knots_u: self.knots_v.clone(),
            knots_v: self.knots_u.clone(),
            control_points: self.control_points.transposed(),
            report: ConstructionReport::NONE,
            ..self.clone()
        }
    }

    /// The same points over another domain of one parameter.
    #[must_use]
    pub fn reparametrized(&self, along: Direction, domain: Interval) -> Self {
        let surface = Self { report: ConstructionReport::NONE, ..self.clone() };
        surface.on_knots(along, self.knots(along).on(domain))
    }

    /// The surface on other knots of the same number along a direction.
    fn on_knots(self, along: Direction, knots: KnotVector) -> Self {
        match along {
            Direction::U => Self { knots_u: knots, ..self },
            Direction::V => Self { knots_v: knots, ..self },
        }
    }
}
