//! The four edges of a surface by name.

use crate::{Side, surface::Direction};

/// An edge of a surface.
///
/// ```
/// use virote_kernel::{Direction, Edge, Side};
///
/// assert_eq!(Edge::U1.place(), (Direction::U, Side::Right));
/// assert_eq!(Edge::ALL.map(Edge::word), ["u0", "u1", "v0", "v1"]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edge {
    /// The first u.
    U0,
    /// The last u.
    U1,
    /// The first v.
    V0,
    /// The last v.
    V1,
}

impl Edge {
    /// All of them, in the order in which edges are listed.
    pub const ALL: [Self; 4] = [Self::U0, Self::U1, Self::V0, Self::V1];

    /// The direction that it is an end of, and which end.
    #[must_use]
    pub fn place(self) -> (Direction, Side) {
        match self {
            Self::U0 => (Direction::U, Side::Left),
            Self::U1 => (Direction::U, Side::Right),
            Self::V0 => (Direction::V, Side::Left),
            Self::V1 => (Direction::V, Side::Right),
        }
    }

    /// How scripts call it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::U0 => "u0",
            Self::U1 => "u1",
            Self::V0 => "v0",
            Self::V1 => "v1",
        }
    }
}
