//! What each operator means, in one table: for the machine, for lanes, for jets and for
//! enclosures.
//!
//! A row says what an operator does to two plain numbers, to their dimensions and to their
//! derivatives; which kinds it takes, and so how it pairs up coordinates, is a list of [`Sides`].
//! The machine looks a row up for each value, lanes when they are compiled: the loop over a block is
//! made of the row's own function, so that it costs no call for an element.

use super::{
    arithmetic::{Add, ArithmeticMeaning, Divide, Multiply, Power, Remainder, Subtract},
    operand::{OperatorRefusal, Sides},
};
use crate::{
    eval::ir::{BinaryOp, UnaryOp},
    kernel::{Enclosure, GeomError},
    value::{Dimension, Number, Real},
};

/// What a binary operator means.
#[derive(Clone, Copy, Debug)]
pub(in crate::eval) enum BinaryMeaning {
    /// A number or a point, computed from numbers and points.
    Arithmetic(&'static Arithmetic),
    /// A truth about two values.
    Comparison(&'static ComparisonRow),
    /// Whether two values are nearer than the tolerance.
    Near,
    /// The range between two numbers, with its end or without.
    Range { closed: bool },
    /// A truth made of two, which a left side of this truth decides alone.
    Logic { decided_by: bool },
}

/// What a unary operator means.
#[derive(Clone, Copy, Debug)]
pub(in crate::eval) enum UnaryMeaning {
    /// A number or a point, coordinate by coordinate.
    Arithmetic(&'static UnaryArithmetic),
    /// A truth made of one.
    Logic(fn(bool) -> bool),
}

/// The table of binary operators.
pub(in crate::eval) fn binary_meaning(op: BinaryOp) -> BinaryMeaning {
    static ADD: Arithmetic = Arithmetic::of::<Add>();
    static SUBTRACT: Arithmetic = Arithmetic::of::<Subtract>();
    static MULTIPLY: Arithmetic = Arithmetic::of::<Multiply>();
    static DIVIDE: Arithmetic = Arithmetic::of::<Divide>();
    static REMAINDER: Arithmetic = Arithmetic::of::<Remainder>();
    static POWER: Arithmetic = Arithmetic::of::<Power>();
    static EQUAL: ComparisonRow = ComparisonRow::of::<Equal>();
    static NOT_EQUAL: ComparisonRow = ComparisonRow::of::<NotEqual>();
    static LESS: ComparisonRow = ComparisonRow::of::<Less>();
    static LESS_EQUAL: ComparisonRow = ComparisonRow::of::<LessEqual>();
    static GREATER: ComparisonRow = ComparisonRow::of::<Greater>();
    static GREATER_EQUAL: ComparisonRow = ComparisonRow::of::<GreaterEqual>();
    match op {
        BinaryOp::Add => BinaryMeaning::Arithmetic(&ADD),
        BinaryOp::Subtract => BinaryMeaning::Arithmetic(&SUBTRACT),
        BinaryOp::Multiply => BinaryMeaning::Arithmetic(&MULTIPLY),
        BinaryOp::Divide => BinaryMeaning::Arithmetic(&DIVIDE),
        BinaryOp::Remainder => BinaryMeaning::Arithmetic(&REMAINDER),
        BinaryOp::Power => BinaryMeaning::Arithmetic(&POWER),
        BinaryOp::Equal => BinaryMeaning::Comparison(&EQUAL),
        BinaryOp::NotEqual => BinaryMeaning::Comparison(&NOT_EQUAL),
        BinaryOp::Less => BinaryMeaning::Comparison(&LESS),
        BinaryOp::LessEqual => BinaryMeaning::Comparison(&LESS_EQUAL),
        BinaryOp::Greater => BinaryMeaning::Comparison(&GREATER),
        BinaryOp::GreaterEqual => BinaryMeaning::Comparison(&GREATER_EQUAL),
        BinaryOp::Near => BinaryMeaning::Near,
        BinaryOp::Range => BinaryMeaning::Range { closed: true },
        BinaryOp::RangeBelow => BinaryMeaning::Range { closed: false },
        BinaryOp::And => BinaryMeaning::Logic { decided_by: false },
        BinaryOp::Or => BinaryMeaning::Logic { decided_by: true },
    }
}

/// The table of unary operators.
pub(in crate::eval) fn unary_meaning(op: UnaryOp) -> UnaryMeaning {
    static NEGATE: UnaryArithmetic = UnaryArithmetic {
        plain: |a| -a,
        on_lane: |lane| lane.iter_mut().for_each(|a| *a = -*a),
        derivatives: |a| a.scaled(-1.0),
        enclosure: Enclosure::negated,
    };
    match op {
        UnaryOp::Negate => UnaryMeaning::Arithmetic(&NEGATE),
        UnaryOp::Not => UnaryMeaning::Logic(|truth| !truth),
    }
}

/// A row of the table: an operator that computes.
#[derive(Debug)]
pub(in crate::eval) struct Arithmetic {
    /// What is done, as in "cannot be added".
    pub(in crate::eval) verb: &'static str,
    /// Which kinds it takes beside two numbers.
    pub(in crate::eval) sides: &'static [Sides],
    /// The result of two plain numbers; not finite wherever `refusal` has something to say.
    pub(in crate::eval) plain: fn(f64, f64) -> f64,
    /// The same for each element of a lane, with those of another.
    pub(in crate::eval) on_lane: fn(&mut [f64], &[f64]),
    /// The same for each element of a lane, with one number.
    pub(in crate::eval) on_constant: fn(&mut [f64], f64),
    /// The dimension of the result, from those of both sides and the right side's value where it is
    /// known.
    pub(in crate::eval) dimension:
        fn(Dimension, Dimension, Option<f64>) -> Result<Dimension, OperatorRefusal>,
    /// What is wrong with two numbers, whatever their dimensions.
    pub(in crate::eval) refusal: fn(f64, f64) -> Option<OperatorRefusal>,
    /// The result with derivatives, about the plain result, which comes last.
    pub(in crate::eval) derivatives: fn(&Real, &Real, f64) -> Result<Real, GeomError>,
    /// Bounds of the result, from those of both sides; none where there are none, or nobody tells them.
    pub(in crate::eval) enclosure: fn(&Enclosure, &Enclosure) -> Option<Enclosure>,
}

/// A row of the table: an operator that computes from one side. The dimension stays.
#[derive(Debug)]
pub(in crate::eval) struct UnaryArithmetic {
    /// The result of a plain number.
    pub(in crate::eval) plain: fn(f64) -> f64,
    /// The same for each element of a lane.
    pub(in crate::eval) on_lane: fn(&mut [f64]),
    /// The result with derivatives.
    pub(in crate::eval) derivatives: fn(&Real) -> Real,
    /// Bounds of the result.
    pub(in crate::eval) enclosure: fn(&Enclosure) -> Enclosure,
}

/// A row of the table: an operator that compares.
#[derive(Debug)]
pub(in crate::eval) struct ComparisonRow {
    /// Whether it holds for two numbers.
    pub(in crate::eval) numbers: fn(f64, f64) -> bool,
    /// Whether it holds for two texts.
    pub(in crate::eval) texts: fn(&str, &str) -> bool,
    /// Whether it holds for each element of two lanes.
    pub(in crate::eval) lanes: fn(&[f64], &[f64]) -> Vec<bool>,
    /// What it says of equal values of any kind; `None` where only numbers and texts have an order.
    pub(in crate::eval) of_equals: Option<bool>,
}

impl Arithmetic {
    const fn of<M: ArithmeticMeaning>() -> Self {
        Self {
            verb: M::VERB,
            sides: M::SIDES,
            plain: M::plain,
            on_lane: |lane, other| {
                lane.iter_mut().zip(other).for_each(|(a, b)| *a = M::plain(*a, *b));
            },
            on_constant: |lane, b| lane.iter_mut().for_each(|a| *a = M::plain(*a, b)),
            dimension: M::dimension,
            refusal: M::refusal,
            derivatives: M::derivatives,
            enclosure: M::enclosure,
        }
    }

    /// The value and the dimension of two numbers' result.
    pub(in crate::eval) fn numbers(&self, a: Number, b: Number) -> Result<Number, OperatorRefusal> {
        let dim = (self.dimension)(a.dim, b.dim, Some(b.value))?;
        match (self.refusal)(a.value, b.value) {
            Some(refusal) => Err(refusal),
            None => Ok(Number { value: (self.plain)(a.value, b.value), dim }),
        }
    }
}

impl ComparisonRow {
    const fn of<M: ComparisonMeaning>() -> Self {
        Self {
            numbers: |a, b| M::holds(&a, &b),
            texts: |a, b| M::holds(a, b),
            lanes: |a, b| a.iter().zip(b).map(|(a, b)| M::holds(a, b)).collect(),
            of_equals: M::OF_EQUALS,
        }
    }
}

/// What a comparison is made of.
trait ComparisonMeaning {
    const OF_EQUALS: Option<bool>;
    fn holds<T: PartialOrd + ?Sized>(a: &T, b: &T) -> bool;
}

/// Comparisons as Rust has them.
macro_rules! comparisons {
    ($( $name:ident: $sign:tt, $of_equals:expr; )+) => { $(
        struct $name;

        impl ComparisonMeaning for $name {
            const OF_EQUALS: Option<bool> = $of_equals;

            #[inline(always)]
            fn holds<T: PartialOrd + ?Sized>(a: &T, b: &T) -> bool {
                *a $sign *b
            }
        }
    )+ };
}

comparisons! {
    Equal: ==, Some(true);
    NotEqual: !=, Some(false);
    Less: <, None;
    LessEqual: <=, None;
    Greater: >, None;
    GreaterEqual: >=, None;
}
