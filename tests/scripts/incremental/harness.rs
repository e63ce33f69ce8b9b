//! Runs of one document after another, with an operation that counts its calls.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::{
        Mutex,
        atomic::{AtomicUsize, Ordering},
    },
};

use virote::{
    diag::{Code, Diagnostic, Severity, Sources},
    eval::{self, Memory, Outcome, Purpose, Setting, Settings, Work},
    limits::{
        Limits,
        work::{MemoryGauge, StopToken},
    },
    ops,
    value::{Call, Ctx, Family, Files, Op, OpParameter, Registry, Type, Value},
};

/// Calls of `counted`, by what they were given.
static CALLS: Mutex<BTreeMap<String, usize>> = Mutex::new(BTreeMap::new());

fn parameter(name: &'static str) -> OpParameter {
    OpParameter {
        name,
        docs: "",
        ty: Type::Any,
        default: None,
        optional: false,
        spreads: false,
        by_position: false,
    }
}

fn operation(name: &'static str, run: fn(&mut Ctx<'_>, Call) -> virote::diag::Result<Value>) -> Op {
    let params = Box::leak(Box::new([parameter("label"), parameter("x")]));
    let (family, returns) = (Family::Text, Type::Any);
    Op {
        name,
        aliases: &[],
        family,
        docs: "",
        params,
        returns,
        examples: &[],
        refusals: &[],
        enclosed: None,
        on_numbers: None,
        on_vectors: None,
        is_affine: false,
        is_of_shape: false,
        derives_itself: None,
        settling: None,
        picture: None,
        names_script: false,
        has_given_control_points: false,
        run,
    }
}

/// The second argument; counts the call under the first one.
fn counted(_: &mut Ctx<'_>, call: Call) -> virote::diag::Result<Value> {
    let label = call.positional[0].value.to_string();
    *CALLS.lock().expect("no call panics").entry(label).or_default() += 1;
    Ok(call.positional[1].value.clone())
}

/// The same with a warning.
fn doubtful(ctx: &mut Ctx<'_>, call: Call) -> virote::diag::Result<Value> {
    ctx.warn(Diagnostic::warning(Code::Unclean, call.span, "this is doubtful"));
    counted(ctx, call)
}

fn registry() -> Registry {
    let own: [&'static Op; 2] = [
        Box::leak(Box::new(operation("counted", counted))),
        Box::leak(Box::new(operation("doubtful", doubtful))),
    ];
    let built_in = ops::registry();
    let constants = built_in.constants();
    built_in.iter().chain(own).collect::<Registry>().with_constants(constants)
}

/// Files in memory.
#[derive(Debug, Default)]
pub(crate) struct Shelf(pub(crate) BTreeMap<String, String>);

impl Files for Shelf {
    fn read(&self, path: &str, _: usize) -> Result<Vec<u8>, String> {
        let text = self.0.get(path).ok_or_else(|| format!("there is no file `{path}`"))?;
        Ok(text.clone().into_bytes())
    }
}

/// A document under edit. In its text `@(x)` stands for `counted(label, x)` with the label of this
/// document.
pub(crate) struct Desk {
    label: String,
    registry: Registry,
    memory: Memory,
    pub(crate) files: Shelf,
    pub(crate) settings: Vec<Setting>,
    pub(crate) limits: Limits,
    pub(crate) n_threads: usize,
}

/// What a run came to.
pub(crate) struct Run {
    pub(crate) outcome: Outcome,
    /// How often `counted` was called.
    pub(crate) n_calls: usize,
}

impl Run {
    /// The names of the definitions with this work.
    pub(crate) fn with(&self, work: Work) -> BTreeSet<String> {
        let those = self.outcome.definitions.iter().filter(|defined| defined.work == work);
        those.map(|defined| defined.name.clone()).collect()
    }

    /// The value of a definition as text.
    pub(crate) fn value(&self, name: &str) -> String {
        let found = self.outcome.definitions.iter().find(|defined| defined.name == name);
        let value = found.and_then(|defined| defined.value.as_ref());
        value.map_or("nothing".to_owned(), ToString::to_string)
    }
}

impl Desk {
    pub(crate) fn new(n_threads: usize) -> Self {
        static DESKS: AtomicUsize = AtomicUsize::new(0);
        Self {
            label: format!("desk {}", DESKS.fetch_add(1, Ordering::Relaxed)),
            registry: registry(),
            memory: Memory::default(),
            files: Shelf::default(),
            settings: Vec::new(),
            limits: Limits::DEFAULT,
            n_threads,
        }
    }

    /// Another desk with the same label and files, that remembers nothing.
    pub(crate) fn fresh(&self) -> Self {
        Self {
            label: self.label.clone(),
            files: Shelf(self.files.0.clone()),
            settings: self.settings.clone(),
            ..Self::new(1)
        }
    }

    /// Runs the next state of the document.
    pub(crate) fn run(&self, text: &str) -> Run {
        let text = text.replace("@(", &format!("counted(\"{}\", ", self.label));
        let calls =
            || CALLS.lock().expect("no call panics").get(&format!("\"{}\"", self.label)).copied();
        let before = calls().unwrap_or(0);
        let recall = self.memory.begin();
        let settings = Settings {
            registry: &self.registry,
            limits: &self.limits,
            files: &self.files,
            overrides: &self.settings,
            n_threads: self.n_threads,
            purpose: Purpose::Run,
            recall: Some(&recall),
            known: &[],
            gauge: &MemoryGauge::default(),
            stop: &StopToken::default(),
        };
        let mut sources = Sources::default();
        let outcome = eval::evaluate("document", &text, &mut sources, settings);
        recall.end(outcome.diagnostics.iter().any(|found| found.severity == Severity::Error));
        Run { outcome, n_calls: calls().unwrap_or(0) - before }
    }

    /// How many results are remembered.
    pub(crate) fn n_remembered(&self) -> usize {
        self.memory.len()
    }
}
