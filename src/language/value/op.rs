//! What an operation is: name, parameters, documentation, implementation; `op_macro` declares one.

use std::sync::Arc;

use super::{
    Call, Callback, Example, ExamplePicture, Files, OnNumbers, OnVectors, RefusalExample, Settling,
    Switch, Type, Value, Witness,
};
use crate::{
    diag::{Diagnostic, Result, Sources, Span},
    kernel::{CurveFunction, Enclosure, PointEntries, SurfaceFunction, Tolerance},
    limits::Limits,
};

/// What an operation may consult besides its arguments.
pub struct Ctx<'a> {
    /// The document's tolerance.
    pub tolerance: Tolerance,
    /// The document's unit of length, by name.
    pub unit: &'static str,
    /// The ceilings of the run.
    pub limits: &'a Limits,
    /// How many threads may work on the call; its result does not depend on it.
    pub n_threads: usize,
    /// Reads files that the script names.
    pub files: &'a dyn Files,
    /// The call under way, from the function's name to the closing bracket.
    pub span: Span,
    /// The texts that spans point into, if they are at hand.
    pub sources: Option<&'a Sources>,
    /// Calls functions of the script and takes warnings.
    pub caller: &'a mut dyn Caller,
    /// Whether it is asked how the answer is made of the points of the arguments.
    pub making: Making,
}

/// How an answer is made of points, as far as somebody asks and the operation tells.
#[derive(Debug, Default)]
pub enum Making {
    /// Nobody asks.
    #[default]
    Unasked,
    /// Somebody does.
    Asked,
    /// By how much each point of the arguments, one behind the other, counts in those of the answer.
    Told(PointEntries),
}

impl std::fmt::Debug for Ctx<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Ctx").field("span", &self.span).finish_non_exhaustive()
    }
}

impl Ctx<'_> {
    /// Tells by how much the points of the arguments, those of control points as homogeneous ones, count in those of the
    /// answer, where somebody asks. It is held against a step of all of them before anybody is told slopes.
    pub fn made_by(&mut self, entries: &dyn Fn() -> Option<PointEntries>) {
        if matches!(self.making, Making::Asked)
            && let Some(entries) = entries()
        {
            self.making = Making::Told(entries);
        }
    }

    /// Calls a function that was given as an argument. A list that nobody else has may grow in it.
    ///
    /// # Errors
    /// Whatever goes wrong inside it.
    pub fn call(&mut self, function: &Callback, args: impl Into<Vec<Value>>) -> Result<Value> {
        self.caller.call(&function.0, args.into(), self.span)
    }

    /// Tells what decided a test of the elements of a list.
    pub fn decided(&mut self, witness: Witness) {
        self.caller.decided(self.span, witness);
    }

    /// Tells the user that the result needed help.
    pub fn warn(&mut self, warning: Diagnostic) {
        self.caller.warn(warning);
    }
}

/// Bounds of a function of one number from those of the number; none where it has no value or no derivative,
/// or may have none.
pub type EnclosedFunction = fn(&Enclosure) -> Option<Enclosure>;

/// A function of one number whose bounds over an interval can be computed.
pub trait Bounded: std::fmt::Debug {
    /// Bounds of its values and slopes, as for [`EnclosedFunction`].
    fn over(&self, interval: [f64; 2]) -> Option<Enclosure>;
}

/// How the sides of a comparison have to stand to one another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// Their difference is to be zero.
    Equal,
    /// Their difference is not to be negative.
    NotNegative,
}

/// A comparison that a function of the script makes.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// What makes it hold.
    pub relation: Relation,
    /// The difference of both sides.
    pub difference: Value,
    /// Where it stands.
    pub span: Span,
}

/// What the evaluator does for operations.
pub trait Caller {
    /// Calls `function` with positional arguments; `span` is blamed when it cannot be called.
    ///
    /// # Errors
    /// Whatever goes wrong inside it.
    fn call(&mut self, function: &Value, args: Vec<Value>, span: Span) -> Result<Value>;

    /// What a function of the script compares when it is called with these arguments.
    ///
    /// # Errors
    /// A function whose value is no comparison, and whatever goes wrong inside it.
    fn comparisons(
        &mut self,
        function: &Value,
        args: &[Value],
        span: Span,
    ) -> Result<Vec<Comparison>>;

    /// A function of the script of which bounds over intervals can be computed; none where it does what tells
    /// no bounds.
    fn bounded(&self, function: &Value) -> Option<Box<dyn Bounded>>;

    /// Whether a function took something that carries derivatives from around it.
    fn is_varying(&self, function: &Value) -> bool;

    /// A function of the script as that of a curve; `span` is the call that makes the curve.
    ///
    /// # Errors
    /// Where it uses a parameter of a function that is differentiated.
    fn curve_function(&self, function: &Value, span: Span) -> Result<Arc<dyn CurveFunction>>;

    /// A function of the script as that of a surface.
    ///
    /// # Errors
    /// As for [`Self::curve_function`].
    fn surface_function(&self, function: &Value, span: Span) -> Result<Arc<dyn SurfaceFunction>>;

    /// Takes what decided a test of the elements of a list, by the call at `span`.
    fn decided(&mut self, span: Span, witness: Witness);

    /// Begins to note what decides which way functions go of what carries derivatives, or ends it with `None`; what
    /// was noted before.
    fn note_switches(&mut self, noted: Option<Vec<Switch>>) -> Option<Vec<Switch>>;

    /// Takes notice that a text was made of what carries derivatives, which no number that it spells has.
    fn made_varying_text(&mut self);

    /// Whether texts may be made of what carries derivatives.
    fn has_varying_texts(&self) -> bool;

    /// Takes a warning.
    fn warn(&mut self, warning: Diagnostic);

    /// How many warnings it has taken.
    fn n_warnings(&self) -> usize;

    /// Forgets all warnings but the first so many.
    fn keep_warnings(&mut self, n: usize);
}

/// Chapter of the reference in which an operation is listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Family {
    /// Curves.
    Curve,
    /// Surfaces.
    Surface,
    /// Curves and surfaces made of others.
    Edit,
    /// Transformations of anything geometric.
    Transform,
    /// Regions.
    Region,
    /// Parts of surfaces.
    Face,
    /// Solids.
    Solid,
    /// Questions about geometry.
    Measure,
    /// Meshes and files.
    Mesh,
    /// Tables.
    Table,
    /// Numbers.
    Math,
    /// Points and vectors.
    Vector,
    /// Lists.
    List,
    /// Text, and whatever steers evaluation.
    Text,
}

impl Family {
    /// Every family with its heading, in the order of the reference.
    pub const ALL: &'static [(Self, &'static str)] = &[
        (Self::Curve, "Curves"),
        (Self::Surface, "Surfaces"),
        (Self::Edit, "Edits"),
        (Self::Transform, "Transformations"),
        (Self::Region, "Regions"),
        (Self::Face, "Parts of surfaces"),
        (Self::Solid, "Solids"),
        (Self::Measure, "Questions about geometry"),
        (Self::Mesh, "Meshes and files"),
        (Self::Table, "Tables"),
        (Self::Math, "Numbers"),
        (Self::Vector, "Points and vectors"),
        (Self::List, "Lists"),
        (Self::Text, "Text"),
    ];
}

/// One parameter.
#[derive(Clone, Copy, Debug)]
pub struct OpParameter {
    /// Its label.
    pub name: &'static str,
    /// What it means.
    pub docs: &'static str,
    /// Its type.
    pub ty: Type,
    /// Value when left out; `None` for a required or an optional parameter.
    pub default: Option<fn() -> Value>,
    /// Whether it may be left out although it has no default.
    pub optional: bool,
    /// Whether its elements may stand as the arguments themselves.
    pub spreads: bool,
    /// Whether it may stand by position although it may be left out.
    pub by_position: bool,
}

impl OpParameter {
    /// Whether a call may leave it out; most such parameters are given by name only.
    #[must_use]
    pub fn may_be_left_out(&self) -> bool {
        self.optional || self.default.is_some()
    }

    /// How it is declared: `radius: Number`, with its default where it may be left out.
    #[must_use]
    pub fn signature(&self) -> String {
        match self.default {
            Some(default) => format!("{}: {} = {}", self.name, self.ty, default()),
            None if self.optional => format!("{}: {} = none", self.name, self.ty),
            None => format!("{}: {}", self.name, self.ty),
        }
    }
}

/// A built-in operation, as every reader of the registry sees it.
#[derive(Debug)]
pub struct Op {
    /// What scripts call it.
    pub name: &'static str,
    /// Other names for it.
    pub aliases: &'static [&'static str],
    /// Its chapter.
    pub family: Family,
    /// What it does: a sentence, then the rest, last the source.
    pub docs: &'static str,
    /// Its parameters.
    pub params: &'static [OpParameter],
    /// What it yields.
    pub returns: Type,
    /// Tested samples of use.
    pub examples: &'static [Example],
    /// Tested samples of misuse.
    pub refusals: &'static [RefusalExample],
    /// Bounds of its values, of a function of one number that tells them.
    pub enclosed: Option<EnclosedFunction>,
    /// What it does to plain numbers, of an operation on these alone.
    pub on_numbers: Option<OnNumbers>,
    /// What it does to plain vectors, of an operation on these alone.
    pub on_vectors: Option<OnVectors>,
    /// Whether its result is affine in what it is made of, or bends by the product of two of them, so that
    /// derivatives pass through it: see [`through_affine`](super::through_affine).
    pub is_affine: bool,
    /// Whether all that it answers depends on the shape of curves and surfaces alone, not on the knots and control
    /// points that these have, so that derivatives pass through it where knots move too.
    pub is_of_shape: bool,
    /// Whether its answer's control points are the points of its first parameter, in their order and with weights of
    /// their own, so that they have the same slopes: see [`with_slopes_of_points`](super::with_slopes_of_points).
    pub has_given_control_points: bool,
    /// Of which calls it finds the derivatives itself, as one that takes a `Real` does.
    pub derives_itself: Option<fn(&Call) -> bool>,
    /// What it finds by a rule, and how that moves.
    pub settling: Option<&'static Settling>,
    /// What its picture in the reference shows, where that is more than its first example.
    pub picture: Option<ExamplePicture>,
    /// Whether its argument names a script, whose parameters are the other arguments: the files of a script
    /// are found before anything is evaluated, so that a call is no call of `run`.
    pub names_script: bool,
    /// Its implementation.
    pub run: fn(&mut Ctx<'_>, Call) -> Result<Value>,
}

impl Op {
    /// First paragraph of the documentation, as it stands in the source.
    #[must_use]
    pub fn summary(&self) -> &'static str {
        self.docs.split("\n\n").next().unwrap_or_default().trim()
    }

    /// Whether its first argument can neither be such a value nor a list of such.
    #[must_use]
    pub fn is_foreign_to(&self, value: &Value) -> bool {
        let takes = |param: &OpParameter| param.ty.accepts(value) || param.ty.is_list_of(value);
        self.params.first().is_some_and(|param| !takes(param))
    }

    /// `name(a: T, b: U = d) -> R`, one line.
    #[must_use]
    pub fn signature(&self) -> String {
        let mut params: Vec<String> = self.params.iter().map(OpParameter::signature).collect();
        if self.names_script {
            params.push("PARAM = value, ...".to_owned());
        }
        format!("{}({}) -> {}", self.name, params.join(", "), self.returns)
    }
}
