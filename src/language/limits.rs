//! Every ceiling on what a script may ask for: one field each, with its default and its reason.
//!
//! Algorithms receive the ceiling they obey; none is written where it is used.

pub mod stack;

use crate::kernel::ceiling;
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
    /// Degree of a curve or surface: [`ceiling::DEGREE`] at most.
    pub degree: usize,
    /// Control points of one curve or surface: [`ceiling::CONTROL_POINTS`] at most.
    pub control_points: usize,
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

/// Findings of one document that an editor is told; the last one counts those behind it. Thousands take seconds to
/// send, during which nothing else is answered, and nobody reads them.
pub const MOST_FINDINGS: usize = 1_000;

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
        degree: ceiling::DEGREE,
        control_points: ceiling::CONTROL_POINTS,
        stack_bytes: 512 << 20,
        input_bytes: 1 << 30,
        import_nesting: 64,
        output_bytes: 4 << 30,
        picture_pixels: 1 << 25,
        memory_bytes: at_most(4 << 30),
        diagnostics: 20,
    };
}

impl Limits {
    /// The ceilings of a module in a page. The stack of WebAssembly's own calls belongs to the browser,
    /// is about a megabyte, cannot be asked for, and is not seen from inside: these keep to a part of it,
    /// which a test of the module walks up to. `stack_bytes` is what the module's linker sets aside.
    pub const WEB: Self = Self {
        nesting: 128,
        chain: 250,
        call_depth: 160,
        evaluation_depth: 800,
        value_depth: 200,
        stack_bytes: 64 << 20,
        memory_bytes: 2 << 30,
        ..Self::DEFAULT
    };
}

/// So many bytes, or all that the platform can count.
const fn at_most(bytes: u64) -> usize {
    if usize::BITS < u64::BITS && bytes > u32::MAX as u64 { usize::MAX } else { bytes as usize }
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
    get: fn(&Limits) -> u64,
    set: fn(&mut Limits, u64),
}

/// A ceiling on the field of its name; `set` is given no more than `most`, which fits the field.
macro_rules! ceiling {
    ($field:ident: $ty:ty, $name:expr, most $most:expr, $docs:literal) => {
        Ceiling {
            name: $name,
            docs: $docs,
            most: $most,
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
    /// See [`Self::ALL`].
    pub const SOURCE_BYTES: &'static str = "source-bytes";
    /// See [`Self::ALL`].
    pub const INPUT_BYTES: &'static str = "input-bytes";
    /// See [`Self::ALL`].
    pub const OUTPUT_BYTES: &'static str = "output-bytes";
    /// See [`Self::ALL`].
    pub const IMPORT_NESTING: &'static str = "import-nesting";
    /// See [`Self::ALL`].
    pub const NESTING: &'static str = "nesting";
    /// See [`Self::ALL`].
    pub const CHAIN: &'static str = "chain";
    /// See [`Self::ALL`].
    pub const CALL_DEPTH: &'static str = "call-depth";
    /// See [`Self::ALL`].
    pub const EVALUATION_DEPTH: &'static str = "evaluation-depth";
    /// See [`Self::ALL`].
    pub const VALUE_DEPTH: &'static str = "value-depth";
    /// See [`Self::ALL`].
    pub const VALUE_SIZE: &'static str = "value-size";
    /// See [`Self::ALL`].
    pub const TEXT_BYTES: &'static str = "text-bytes";
    /// See [`Self::ALL`].
    pub const LIST_LENGTH: &'static str = "list-length";
    /// See [`Self::ALL`].
    pub const STEPS: &'static str = "steps";
    /// See [`Self::ALL`].
    pub const CONTROL_POINTS: &'static str = "control-points";
    /// See [`Self::ALL`].
    pub const DEGREE: &'static str = "degree";
    /// See [`Self::ALL`].
    pub const MESH_VERTICES: &'static str = "mesh-vertices";

    /// Every ceiling with a flag.
    pub const ALL: &'static [Self] = &[
        // Places in all texts together are four bytes.
        ceiling!(source_bytes: usize, Self::SOURCE_BYTES, most 1 << 30,
            "bytes of one script"),
        ceiling!(input_bytes: usize, Self::INPUT_BYTES, most Self::OPEN,
            "bytes of one file that a script reads"),
        ceiling!(output_bytes: u64, Self::OUTPUT_BYTES, most Self::OPEN,
            "bytes of one file that a script writes"),
        ceiling!(memory_bytes: usize, Self::MEMORY, most Self::OPEN,
            "bytes of memory that a run holds"),
        // Each level is loaded inside the one before.
        ceiling!(import_nesting: usize, Self::IMPORT_NESTING, most 256,
            "files inside one another's imports"),
        ceiling!(nesting: usize, Self::NESTING, most MOST_NESTING,
            "brackets inside one another"),
        ceiling!(chain: usize, Self::CHAIN, most MOST_NESTING,
            "operators in one expression outside brackets"),
        ceiling!(call_depth: usize, Self::CALL_DEPTH, most MOST_CALL_DEPTH,
            "calls of functions inside one another"),
        // The stack is made for the default.
        ceiling!(evaluation_depth: usize, Self::EVALUATION_DEPTH,
            most Limits::DEFAULT.evaluation_depth as u64,
            "expressions under evaluation inside one another, calls included"),
        ceiling!(value_depth: u32, Self::VALUE_DEPTH, most MOST_VALUE_DEPTH,
            "lists, records and functions inside one another"),
        ceiling!(value_size: u64, Self::VALUE_SIZE, most Self::OPEN,
            "values inside one value, shared ones counted each time"),
        ceiling!(text_bytes: usize, Self::TEXT_BYTES, most 1 << 30,
            "bytes of one text"),
        ceiling!(list_length: usize, Self::LIST_LENGTH, most Self::OPEN,
            "elements of one list"),
        ceiling!(steps: u64, Self::STEPS, most Self::OPEN,
            "steps of evaluation of one definition"),
        // The geometry makes no more.
        ceiling!(control_points: usize, Self::CONTROL_POINTS, most ceiling::CONTROL_POINTS as u64,
            "control points of one curve or surface"),
        ceiling!(degree: usize, Self::DEGREE, most ceiling::DEGREE as u64,
            "degree of a curve or surface"),
        // A triangle names its corners by four bytes.
        ceiling!(mesh_vertices: usize, Self::MESH_VERTICES, most 1 << 32,
            "vertices of one mesh"),
        ceiling!(diagnostics: usize, "diagnostics", most 10_000,
            "messages that are shown; the rest is counted"),
    ];

    /// The ceiling of this name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<&'static Self> {
        Self::ALL.iter().find(|ceiling| ceiling.name == name)
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
