//! Axis-aligned boxes.

use glam::DVec3;

/// The box between two corners; `min <= max` in every coordinate.
///
/// The box of a diagonal whose sides are 3 and 4 is 5 across:
///
/// ```
/// use virote_kernel::{Bounds, glam::DVec3};
///
/// let found = Bounds::of([DVec3::ZERO, DVec3::new(3.0, 4.0, 0.0)]).ok_or("no points")?;
/// assert_eq!(found.diagonal(), 5.0);
/// assert_eq!(found.center(), DVec3::new(1.5, 2.0, 0.0));
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Smallest coordinates.
    pub min: DVec3,
    /// Largest coordinates.
    pub max: DVec3,
}

impl Bounds {
    /// The smallest box around the points; none around no points.
    #[must_use]
    pub fn of(points: impl IntoIterator<Item = DVec3>) -> Option<Self> {
        let mut points = points.into_iter();
        let first = points.next()?;
        let grow = |bounds: Self, point: DVec3| bounds.with(point);
        Some(points.fold(Self { min: first, max: first }, grow))
    }

    /// The smallest box around this one and a point.
    #[must_use]
    pub fn with(self, point: DVec3) -> Self {
        Self { min: self.min.min(point), max: self.max.max(point) }
    }

    /// The smallest box around both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Width, depth and height.
    #[must_use]
    pub fn size(self) -> DVec3 {
        self.max - self.min
    }

    /// The middle.
    #[must_use]
    pub fn center(self) -> DVec3 {
        0.5 * self.min + 0.5 * self.max
    }

    /// Its eight corners.
    #[must_use]
    pub fn corners(self) -> [DVec3; 8] {
        let ends = [self.min, self.max];
        std::array::from_fn(|i| DVec3::new(ends[i & 1].x, ends[i >> 1 & 1].y, ends[i >> 2].z))
    }

    /// Length of the diagonal.
    #[must_use]
    pub fn diagonal(self) -> f64 {
        self.size().length()
    }

    /// How far a point is from it; 0 inside.
    #[must_use]
    pub fn distance(self, point: DVec3) -> f64 {
        (self.min - point).max(point - self.max).max(DVec3::ZERO).length()
    }

    /// The largest coordinate by absolute value: what rounding is relative to.
    #[must_use]
    pub fn magnitude(self) -> f64 {
        self.min.abs().max(self.max.abs()).max_element()
    }

    /// Whether the point is inside or on the boundary, or outside by no more than `slack`.
    #[must_use]
    pub fn contains(self, point: DVec3, slack: f64) -> bool {
        (self.min - slack).cmple(point).all() && point.cmple(self.max + slack).all()
    }

    /// Whether another box is within this one, up to a distance.
    #[must_use]
    pub(crate) fn holds(self, other: Self, distance: f64) -> bool {
        (self.min - distance).cmple(other.min).all() && other.max.cmple(self.max + distance).all()
    }

    /// Whether both boxes are within the distance of one another along every axis.
    #[must_use]
    pub fn is_near(self, other: Self, distance: f64) -> bool {
        self.min.cmple(other.max + distance).all() && other.min.cmple(self.max + distance).all()
    }
}
