//! The two directions of a surface, and what is done along either: a net is a bundle of splines,
//! its columns along u, its rows along v.

use std::ops::{Index, IndexMut};

use glam::DVec4;

use crate::{Grid, Interval, KnotVector, refine::ControlLines, surface::NurbsSurface};

/// A direction of a surface.
///
/// ```
/// use virote_kernel::{Direction, NurbsSurface, glam::DVec3};
///
/// let patch = NurbsSurface::bilinear(DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::ONE)?;
/// let [left, right] = patch.split(Direction::U, 0.5)?;
/// assert_eq!(left.domain(Direction::U).end(), right.domain(Direction::U).start());
/// assert_eq!(left.domain(Direction::V), patch.domain_v());
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Along u: i counts.
    U,
    /// Along v: j counts.
    V,
}

impl Direction {
    /// Both, u first.
    pub const BOTH: [Self; 2] = [Self::U, Self::V];

    /// `u` or `v`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::U => "u",
            Self::V => "v",
        }
    }

    /// The other one.
    #[must_use]
    pub fn other(self) -> Self {
        match self {
            Self::U => Self::V,
            Self::V => Self::U,
        }
    }

    /// What belongs to u and to v, of what belongs to this direction and to the other one.
    #[must_use]
    pub fn pair<T>(self, own: T, other: T) -> [T; 2] {
        match self {
            Self::U => [own, other],
            Self::V => [other, own],
        }
    }
}

/// What there is for u and for v.
impl<T> Index<Direction> for [T; 2] {
    type Output = T;

    fn index(&self, along: Direction) -> &T {
        let [u, v] = self;
        match along {
            Direction::U => u,
            Direction::V => v,
        }
    }
}

impl<T> IndexMut<Direction> for [T; 2] {
    fn index_mut(&mut self, along: Direction) -> &mut T {
        let [u, v] = self;
        match along {
            Direction::U => u,
            Direction::V => v,
        }
    }
}

impl NurbsSurface {
    /// All knots along a direction.
    #[must_use]
    pub fn knots(&self, along: Direction) -> &KnotVector {
        match along {
            Direction::U => &self.knots_u,
            Direction::V => &self.knots_v,
        }
    }

    /// The parameters along a direction that have points.
    #[must_use]
    pub fn domain(&self, along: Direction) -> Interval {
        self.knots(along).domain()
    }

    /// The control points as splines along a direction.
    pub(crate) fn lines(&self, along: Direction) -> ControlLines {
        let net = &self.control_points;
        let lines = match along {
            Direction::U => (0..net.n_columns()).map(|j| net.column(j)).collect(),
            Direction::V => (0..net.n_rows()).map(|i| net.row(i).to_vec()).collect(),
        };
        ControlLines { knots: self.knots(along).clone(), lines }
    }

    /// The surface with other splines along a direction, as many as it has.
    pub(crate) fn with_lines(&self, along: Direction, lines: ControlLines) -> Self {
        let ControlLines { knots, lines } = lines;
        let n_points = knots.n_points();
        let points: Vec<DVec4> = lines.into_iter().flatten().collect();
        let net = Grid::from_rows_of(n_points, points);
        match along {
            Direction::U => Self::new_unchecked(knots, self.knots_v.clone(), net.transposed()),
            Direction::V => Self::new_unchecked(self.knots_u.clone(), knots, net),
        }
    }
}
