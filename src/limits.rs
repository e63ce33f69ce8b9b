//! Every ceiling on what a script may ask for: one field each, with its default and its reason.
//!
//! Algorithms receive the ceiling they obey; none is written where it is used.

pub mod stack;

pub use crate::kernel::work;

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
    /// Lists, records and functions inside one another. Whatever walks through a value recurses.
    pub value_depth: u32,
    /// Values inside one value, shared ones counted each time: what printing or comparing walks
    /// through.
    pub value_size: u64,
    /// Bytes of one text.
    pub text_bytes: usize,
    /// Elements of one list, rows of one table.
    pub list_length: usize,
    /// Steps (an element of a comprehension, a call, a step of a long search in the geometry) of one
    /// definition.
    pub steps: u64,
    /// Vertices of one mesh.
    pub mesh_vertices: usize,
    /// Degree of a curve. Above it, binomial coefficients lose digits and nobody has a use.
    pub degree: usize,
    /// Control points of one curve or surface.
    pub control_points: usize,
    /// Points that a fit to a tolerance may look at, each time counted, to save control points:
    /// below a second. Beyond it the tolerance is kept all the same.
    pub fit_steps: usize,
    /// Bytes of stack of a thread that evaluates: `evaluation_depth` times what a level takes in an
    /// unoptimised build, and as much again. They are reserved, not used.
    pub stack_bytes: usize,
    /// Bytes of one input file read by `load`.
    pub input_bytes: usize,
    /// Files inside one another's imports.
    pub import_nesting: usize,
    /// Bytes of one written file.
    pub output_bytes: u64,
    /// Pixels of one picture. Above it there is no screen and no paper for it.
    pub picture_pixels: usize,
    /// Bytes of memory that a run holds, its text and tree included. One operation may go beyond
    /// by what the other ceilings let its result be; the next one is refused.
    pub memory_bytes: usize,
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
        value_depth: 1_000,
        value_size: 20_000_000,
        text_bytes: 64 << 20,
        list_length: 10_000_000,
        steps: 200_000_000,
        mesh_vertices: 20_000_000,
        degree: 100,
        control_points: 10_000_000,
        fit_steps: 4_000_000,
        stack_bytes: 512 << 20,
        input_bytes: 1 << 30,
        import_nesting: 64,
        output_bytes: 4 << 30,
        picture_pixels: 1 << 25,
        memory_bytes: 4 << 30,
        diagnostics: 20,
    };
}

impl Limits {
    /// The same for threads with another stack: what recurses goes no deeper than that carries.
    #[must_use]
    pub fn on_stack(mut self, stack_bytes: usize) -> Self {
        let share = stack_bytes as u128;
        let fit =
            |most: u64| (u128::from(most) * share / Self::DEFAULT.stack_bytes as u128) as usize;
        self.nesting = self.nesting.min(fit(MOST_NESTING));
        self.chain = self.chain.min(fit(MOST_NESTING));
        self.call_depth = self.call_depth.min(fit(MOST_CALL_DEPTH));
        let most_depth = Self::DEFAULT.evaluation_depth as u64;
        self.evaluation_depth = self.evaluation_depth.min(fit(most_depth));
        self.value_depth = self.value_depth.min(fit(MOST_VALUE_DEPTH) as u32);
        Self { stack_bytes, ..self }
    }
}

impl Default for Limits {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// A ceiling that a run may move.
#[derive(Clone, Copy, Debug)]
pub struct Ceiling {
    /// What the command line calls it.
    pub name: &'static str,
    /// What it limits, in one line.
    pub docs: &'static str,
    /// The highest value: beyond it the stack or the memory of places in a text would not do.
    pub most: u64,
    /// How a message tells that it was crossed: the code, and a word of the message.
    crossed: &'static [(&'static str, &'static str)],
    get: fn(&Limits) -> u64,
    set: fn(&mut Limits, u64),
}

/// A ceiling on the field of its name; `set` is given no more than `most`, which fits the field.
macro_rules! ceiling {
    ($field:ident: $ty:ty, $name:expr, most $most:expr, $crossed:expr, $docs:literal) => {
        Ceiling {
            name: $name,
            docs: $docs,
            most: $most,
            crossed: &$crossed,
            get: |limits| limits.$field as u64,
            set: |limits, value| limits.$field = value as $ty,
        }
    };
}

/// Brackets and operators whose recursion fits into `stack_bytes` six times over.
const MOST_NESTING: u64 = 10_000;
/// `evaluation_depth` ends most recursions before.
const MOST_CALL_DEPTH: u64 = 50_000;
/// Whatever walks through a value: comparing, printing, dropping. Measured like the nesting.
const MOST_VALUE_DEPTH: u64 = 10_000;

impl Ceiling {
    /// The highest value where nothing of ours ends before the machine does.
    pub const OPEN: u64 = 1 << 53;

    /// The name of the ceiling on memory, the one whose crossing depends on what else runs.
    pub const MEMORY: &'static str = "memory";

    /// Every ceiling with a flag.
    pub const ALL: &'static [Self] = &[
        // Places in all texts together are four bytes.
        ceiling!(source_bytes: usize, "source-bytes", most 1 << 30, [("E0008", "bytes")],
            "bytes of one script"),
        ceiling!(input_bytes: usize, "input-bytes", most Self::OPEN, [("E0701", "ceiling")],
            "bytes of one file that a script reads"),
        ceiling!(output_bytes: u64, "output-bytes", most Self::OPEN, [("E0901", "file of")],
            "bytes of one file that a script writes"),
        ceiling!(memory_bytes: usize, Self::MEMORY, most Self::OPEN, [("E0901", "of memory")],
            "bytes of memory that a run holds"),
        // Each level is loaded inside the one before.
        ceiling!(import_nesting: usize, "import-nesting", most 256, [("E0901", "imports lie")],
            "files inside one another's imports"),
        ceiling!(nesting: usize, "nesting", most MOST_NESTING, [("E0104", "nested")],
            "brackets inside one another"),
        ceiling!(chain: usize, "chain", most MOST_NESTING, [("E0104", "operators")],
            "operators in one expression outside brackets"),
        ceiling!(call_depth: usize, "call-depth", most MOST_CALL_DEPTH, [("E0403", "calls go")],
            "calls of functions inside one another"),
        // The stack is made for the default.
        ceiling!(evaluation_depth: usize, "evaluation-depth",
            most Limits::DEFAULT.evaluation_depth as u64, [("E0403", "expressions lie")],
            "expressions under evaluation inside one another, calls included"),
        ceiling!(value_depth: u32, "value-depth", most MOST_VALUE_DEPTH, [("E0901", "inside one another")],
            "lists, records and functions inside one another"),
        ceiling!(value_size: u64, "value-size", most Self::OPEN, [("E0901", "parts")],
            "values inside one value, shared ones counted each time"),
        ceiling!(text_bytes: usize, "text-bytes", most 1 << 30, [("E0901", "text of")],
            "bytes of one text"),
        ceiling!(list_length: usize, "list-length", most Self::OPEN, [("E0901", "list of")],
            "elements of one list"),
        ceiling!(steps: u64, "steps", most Self::OPEN, [("E0901", "steps")],
            "steps of evaluation of one definition"),
        ceiling!(control_points: usize, "control-points", most Self::OPEN, [("E0901", "control points")],
            "control points of one curve or surface"),
        // Beyond it binomial coefficients lose their digits.
        ceiling!(degree: usize, "degree", most Limits::DEFAULT.degree as u64, [("E0901", "of degree")],
            "degree of a curve or surface"),
        // A triangle names its corners by four bytes.
        ceiling!(mesh_vertices: usize, "mesh-vertices", most 1 << 32, [("E0901", "vertices")],
            "vertices of one mesh"),
        ceiling!(diagnostics: usize, "diagnostics", most 10_000, [],
            "messages that are shown; the rest is counted"),
    ];

    /// The ceiling of this name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<&'static Self> {
        Self::ALL.iter().find(|ceiling| ceiling.name == name)
    }

    /// The ceiling that a message tells to be crossed, by its code and its text.
    #[must_use]
    pub fn crossed(code: &str, message: &str) -> Option<&'static Self> {
        Self::ALL.iter().find(|ceiling| {
            ceiling.crossed.iter().any(|&(its, word)| its == code && message.contains(word))
        })
    }

    /// Its value.
    #[must_use]
    pub fn of(&self, limits: &Limits) -> u64 {
        (self.get)(limits)
    }

    /// Moves it to `value`, from 1 to [`Ceiling::most`]; tells whether that is a value for it.
    #[must_use]
    pub fn move_to(&self, value: u64, limits: &mut Limits) -> bool {
        let is_allowed = (1..=self.most).contains(&value);
        if is_allowed {
            (self.set)(limits, value);
        }
        is_allowed
    }
}

#[cfg(test)]
mod tests {
    use super::{Ceiling, Limits};

    #[test]
    fn every_ceiling_moves_its_own_field() {
        for ceiling in Ceiling::ALL {
            let mut limits = Limits::DEFAULT;
            assert!(ceiling.of(&limits) <= ceiling.most, "{}", ceiling.name);
            for value in [1, ceiling.most] {
                assert!(ceiling.move_to(value, &mut limits), "{}", ceiling.name);
                assert_eq!(ceiling.of(&limits), value, "{}", ceiling.name);
            }
            assert!(!ceiling.move_to(0, &mut limits));
            assert!(!ceiling.move_to(ceiling.most + 1, &mut limits));
            assert_eq!(ceiling.of(&limits), ceiling.most);
            let _ = ceiling.move_to(ceiling.of(&Limits::DEFAULT), &mut limits);
            assert_eq!(limits, Limits::DEFAULT, "{} moves nothing else", ceiling.name);
        }
    }

    #[test]
    fn names_are_unique() {
        let mut names: Vec<&str> = Ceiling::ALL.iter().map(|ceiling| ceiling.name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), Ceiling::ALL.len());
    }
}
