//! Every ceiling on what a script may ask for: one field each, with its default and its reason.
//!
//! Algorithms receive the ceiling they obey; none is written where it is used.

/// The ceilings of one run.
///
/// Each default is far above honest use and far below what would hurt the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Bytes of one source file. A script of this size is generated, and then it is data.
    pub source_bytes: usize,
    /// Brackets and right-nesting operators inside one another. Every later pass recurses over
    /// the tree, so this bounds their stack.
    pub nesting: usize,
    /// Operators, calls, indices and fields in one expression outside brackets. A chain of them
    /// is a left-deep tree, which is recursed over like nesting.
    pub chain: usize,
    /// Calls of functions inside one another. Above it a recursion has no end.
    pub call_depth: usize,
    /// Expressions under evaluation inside one another, calls included. Bounds the stack: with
    /// two kilobytes each, 120 MB.
    pub evaluation_depth: usize,
    /// Elements of one list, rows of one table.
    pub list_length: usize,
    /// Evaluation steps (an element of a comprehension, a call) of one run.
    pub steps: u64,
    /// Vertices of one mesh.
    pub mesh_vertices: usize,
    /// Degree of a curve. Above it, binomial coefficients lose digits and nobody has a use.
    pub degree: usize,
    /// Control points of one curve or surface.
    pub control_points: usize,
    /// Bytes of one input file read by `load`.
    pub input_bytes: usize,
    /// Diagnostics shown in one run; the rest is counted.
    pub diagnostics: usize,
}

impl Limits {
    /// The documented defaults.
    pub const DEFAULT: Self = Self {
        source_bytes: 64 << 20,
        nesting: 256,
        chain: 4_000,
        call_depth: 10_000,
        evaluation_depth: 60_000,
        list_length: 20_000_000,
        steps: 2_000_000_000,
        mesh_vertices: 20_000_000,
        degree: 100,
        control_points: 10_000_000,
        input_bytes: 1 << 30,
        diagnostics: 20,
    };
}

impl Default for Limits {
    fn default() -> Self {
        Self::DEFAULT
    }
}
