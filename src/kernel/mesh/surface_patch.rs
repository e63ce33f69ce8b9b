//! A surface that becomes triangles: its limits, and the lines of its grid.

use std::{borrow::Cow, sync::Arc};

use glam::DVec3;

use super::{
    ball::Ball,
    cell_bounds::{CellBounds, TessellationOptions},
    grid::check_vertices,
    steps::CellWidths,
};
use crate::{
    Direction, GeomError, Interval, KnotVector, NurbsSurface, ParametricSurface, Surface,
    surface::Crease,
};

/// Part of a tolerance that goes to the spline near a function, and as much again to its vertices,
/// which come onto the function.
pub(super) const SHARE: f64 = 0.1;

/// A surface with what its mesh needs.
#[derive(Debug)]
pub(super) struct SurfacePatch<'a> {
    /// The surface, or a spline near the function that it is.
    pub(super) spline: Cow<'a, NurbsSurface>,
    function: Option<&'a Arc<ParametricSurface>>,
    /// Where the derivative jumps along u and along v.
    pub(super) breaks: [Vec<Crease>; 2],
    /// What of the tolerance is left to the triangles.
    tolerance: f64,
}

/// The cells of a sheet.
#[derive(Debug)]
pub(super) struct Cells {
    /// None any more once the edges are divided and nothing is asked of them again.
    limits: Option<CellBounds>,
    ball: Option<Ball>,
    /// Parameters of the lines along u and along v, the ends of the domain among them.
    pub(super) lines: [Vec<f64>; 2],
}

impl<'a> SurfacePatch<'a> {
    /// # Errors
    /// Those of [`ParametricSurface::to_nurbs`].
    pub(super) fn new(surface: &'a Surface, tolerance: f64) -> Result<Self, GeomError> {
        match surface {
            Surface::Nurbs(spline) => Ok(Self::of_spline(spline, tolerance)),
            Surface::Parametric(function) => {
                let spline = function.to_nurbs(SHARE * tolerance)?;
                let breaks = Direction::BOTH.map(|along| spline.breaks_of_derivative(along));
                let tolerance = (1.0 - 2.0 * SHARE) * tolerance;
                Ok(Self { spline: Cow::Owned(spline), function: Some(function), breaks, tolerance })
            }
        }
    }

    pub(super) fn of_spline(spline: &'a NurbsSurface, tolerance: f64) -> Self {
        Self::of(Cow::Borrowed(spline), tolerance)
    }

    pub(super) fn of(spline: Cow<'a, NurbsSurface>, tolerance: f64) -> Self {
        let breaks = Direction::BOTH.map(|along| spline.breaks_of_derivative(along));
        Self { spline, function: None, breaks, tolerance }
    }

    /// That of a sphere, if it is one and no grid is wanted.
    pub(super) fn ball(&self, wanted: &TessellationOptions) -> Option<Ball> {
        let is_smooth = self.breaks.iter().all(Vec::is_empty);
        // A polynomial surface is no sphere.
        let may_be = is_smooth && !wanted.is_grid && self.spline.is_rational();
        if may_be && !self.is_function() {
            return Ball::of(&self.spline, self.tolerance, wanted);
        }
        None
    }

    /// Whether its points are not those of the spline.
    pub(super) fn is_function(&self) -> bool {
        self.function.is_some()
    }

    /// The domains along u and along v.
    pub(super) fn domains(&self) -> [Interval; 2] {
        [self.spline.domain_u(), self.spline.domain_v()]
    }

    /// Gives a part of the tolerance away, to vertices that come onto another surface.
    pub(super) fn reserve(&mut self, gap: f64) {
        self.tolerance = (self.tolerance - gap).max(0.5 * self.tolerance);
    }

    /// What of the tolerance is left to the triangles.
    pub(super) fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// A point of the surface itself.
    ///
    /// # Errors
    /// Those of [`ParametricSurface::point_at`].
    pub(super) fn point_at(&self, u: f64, v: f64) -> Result<DVec3, GeomError> {
        match self.function {
            Some(function) => function.point_at(u, v),
            None => Ok(self.spline.point_at(u, v)),
        }
    }

    /// The limits of its cells.
    pub(super) fn limits(&self, wanted: &TessellationOptions) -> CellBounds {
        let wanted = TessellationOptions { tolerance: self.tolerance, ..*wanted };
        let breaks = self.breaks.each_ref().map(|breaks| breaks.iter().map(|b| b.at).collect());
        CellBounds::new(&self.spline, &wanted, breaks.each_ref().map(Vec::as_slice))
    }

    /// The cells that keep to limits.
    ///
    /// # Errors
    /// `CountError::TooManyVertices`.
    pub(super) fn cells(&self, limits: CellBounds, most: usize) -> Result<Cells, GeomError> {
        let mut widths = limits.widths().map(|(widths, _)| widths);
        GeomError::go_on(1)?;
        let domains = self.domains();
        let sections = [0, 1].map(|along| {
            let breaks = self.breaks[along].iter().map(|line| line.at);
            let mut ends = vec![domains[along].start(), domains[along].end()];
            ends.extend(breaks.chain(full_knots(self.spline.knots(Direction::BOTH[along]))));
            ends.sort_by(f64::total_cmp);
            ends.dedup();
            ends
        });
        loop {
            let lines = |along: Direction| {
                let widths = CellWidths { ends: &limits.ends[along], widths: &widths[along] };
                widths.lines(&sections[along], most)
            };
            let lines = [lines(Direction::U)?, lines(Direction::V)?];
            check_vertices(lines[0].len() - 1, lines[1].len() - 1, most)?;
            let is_narrowed = limits.narrow(&lines, &mut widths);
            GeomError::go_on(1)?;
            if !is_narrowed {
                return Ok(Cells { limits: Some(limits), ball: None, lines });
            }
        }
    }
}

/// The inner knots at which pieces of their own begin, such as quarters of a circle: lines there
/// make the cells of alike pieces alike. Of degree 1 every knot would be one.
fn full_knots(knots: &KnotVector) -> Vec<f64> {
    let (degree, domain) = (knots.degree(), knots.domain());
    let is_full = |&(t, times): &(f64, usize)| {
        1 < degree && degree <= times && domain.start() < t && t < domain.end()
    };
    knots.distinct().into_iter().filter(is_full).map(|(t, _)| t).collect()
}

impl Cells {
    /// Whether a triangle may reach over these intervals of u and of v.
    pub(super) fn allow(&self, box_of: [[f64; 2]; 2]) -> bool {
        match &self.limits {
            Some(limits) => limits.allow(box_of),
            None => unreachable!("limits are let go of when all edges are divided"),
        }
    }

    /// Those of a ball, if it is one: a mesh of fewer triangles.
    pub(super) fn of_ball(self, ball: Option<Ball>) -> Self {
        Self { ball, ..self }
    }

    pub(super) fn ball(&self) -> Option<&Ball> {
        self.ball.as_ref()
    }

    /// Their limits, as long as they are kept.
    pub(super) fn limits(&self) -> Option<&CellBounds> {
        self.limits.as_ref()
    }

    /// Whether smaller ones do not fold over one another where these do, in a plane.
    pub(super) fn can_unfold(&self) -> bool {
        self.limits.as_ref().is_some_and(CellBounds::can_unfold)
    }

    /// Lets go of the limits, which take most of the memory.
    pub(super) fn let_go(&mut self) {
        self.limits = None;
    }

    /// The first or last step of the lines along a direction.
    pub(super) fn rim(&self, along: Direction, is_last: bool) -> [f64; 2] {
        let lines = &self.lines[along];
        let first = if is_last { lines.len() - 2 } else { 0 };
        [lines[first], lines[first + 1]]
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::{SurfacePatch, TessellationOptions};
    use crate::{
        Frame, NurbsSurface,
        work::{MemoryGauge, StopToken, Watch, under},
    };

    #[test]
    fn work_that_was_ended_leaves_few_pieces() {
        let ball = NurbsSurface::sphere(Frame::XY, 1.0).unwrap();
        let patch = SurfacePatch::of_spline(&ball, 1e-4);
        let wanted = TessellationOptions { angle: 0.1 * PI, ..TessellationOptions::within(1e-4) };
        let n_pieces = |steps: u64| {
            let (gauge, stop) = (MemoryGauge::default(), StopToken::default());
            let watch = Watch { gauge, memory_bytes: usize::MAX, stop, steps };
            let (limits, _) = under(watch, || patch.limits(&wanted));
            limits.ends.map(|ends| ends.len() - 1)
        };
        let whole = n_pieces(u64::MAX);
        let ended = n_pieces(0);
        assert!(ended[0] <= whole[0] && ended[1] <= whole[1], "{ended:?} of {whole:?}");
        assert!(ended[0].max(ended[1]) <= 32, "{ended:?}");
    }
}
