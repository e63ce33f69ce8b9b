//! Sessions: scripts evaluated, built-ins called; and what came of a script.

use std::{
    io,
    path::PathBuf,
    process,
    sync::{Arc, Mutex, MutexGuard, OnceLock, TryLockError},
    thread,
    time::Duration,
};

use pyo3::{
    exceptions::{PyKeyError, PyOSError, PyValueError},
    prelude::*,
    types::{PyDict, PyTuple},
};
use serde_json::{Value as Json, json};
use virote::{
    diag::{Diagnostic, Severity, Sources},
    disk::{OutputTarget, ScriptFiles, TargetRefusal, replace},
    eval::{Checked, Printed, Setting},
    kernel::Tolerance,
    limits::{Ceiling, Limits, work::StopToken},
    render,
    session::{self, Arguments, Event, Report},
    syntax::ast::Unit,
    value::{Function, Op, Type, Value},
};

use crate::{
    convert::{Intake, from_python, to_python},
    errors::{geo_error, write_error},
    geometry::Held,
    held,
    interrupt::interruptible,
    picture::{self, Wanted},
};

/// How long a run waits before it asks again whether it is its turn.
const WAIT: Duration = Duration::from_millis(2);

/// A session of the library; one run at a time.
pub(crate) struct Engine {
    session: session::Session,
    turn: Mutex<()>,
}

impl Engine {
    fn new(limits: Limits, n_threads: usize) -> Self {
        let session =
            session::Session::new(limits).on_threads(n_threads).measured(held).incremental();
        Self { session, turn: Mutex::default() }
    }

    /// The session under a switch of its own: Ctrl-C ends what its thread asked for, and nothing else.
    fn under(&self, stop: &StopToken) -> session::Session {
        self.session.clone().stopped_by(stop.clone())
    }

    /// Waits until no other run is under way, or the switch is set.
    fn turn(&self, stop: &StopToken) -> Option<MutexGuard<'_, ()>> {
        loop {
            match self.turn.try_lock() {
                Ok(turn) => return Some(turn),
                Err(TryLockError::Poisoned(turn)) => return Some(turn.into_inner()),
                Err(TryLockError::WouldBlock) if stop.is_stopped() => return None,
                Err(TryLockError::WouldBlock) => thread::sleep(WAIT),
            }
        }
    }
}

/// Evaluates scripts, and remembers what it evaluated.
#[pyclass(frozen, module = "virote._virote")]
pub(crate) struct Session {
    limits: Limits,
    n_threads: usize,
    /// Of the process that made it.
    process: u32,
    own: Arc<Engine>,
    /// Of a process that was forked: a lock may have been held at that moment, for ever.
    forked: OnceLock<(u32, Arc<Engine>)>,
}

/// The ceilings with some of them moved.
pub(crate) fn limits(moved: &[(String, u64)]) -> PyResult<Limits> {
    let mut limits = Limits::DEFAULT;
    for (name, value) in moved {
        let ceiling = Ceiling::from_name(&name.replace('_', "-"));
        let names =
            || Ceiling::ALL.iter().map(|ceiling| ceiling.name).collect::<Vec<_>>().join(", ");
        let ceiling = ceiling.ok_or_else(|| {
            PyValueError::new_err(format!("no ceiling is called `{name}`; there are {}", names()))
        })?;
        if !ceiling.move_to(*value, &mut limits) {
            let most = ceiling.most;
            return Err(PyValueError::new_err(format!("`{name}` is from 1 to {most}")));
        }
    }
    Ok(limits)
}

impl Session {
    fn engine(&self) -> Arc<Engine> {
        let process = process::id();
        if process == self.process {
            return Arc::clone(&self.own);
        }
        let make = || Arc::new(Engine::new(self.limits, self.n_threads));
        match self.forked.get_or_init(|| (process, make())) {
            (its, engine) if *its == process => Arc::clone(engine),
            // The child of a child.
            _ => make(),
        }
    }
}

#[pymethods]
impl Session {
    #[new]
    fn new(moved: Vec<(String, u64)>, n_threads: usize) -> PyResult<Self> {
        let limits = limits(&moved)?;
        let own = Arc::new(Engine::new(limits, n_threads));
        Ok(Self { limits, n_threads, process: process::id(), own, forked: OnceLock::new() })
    }

    /// Evaluates a script that lies in a folder, with values for its parameters.
    fn run(
        &self,
        py: Python<'_>,
        name: String,
        text: Vec<u8>,
        folder: PathBuf,
        parameters: Vec<(String, String)>,
    ) -> PyResult<Results> {
        let engine = self.engine();
        let settings: Vec<Setting> = parameters
            .into_iter()
            .map(|(name, text)| Setting { called: format!("{name}={text}"), name, text })
            .collect();
        let files = ScriptFiles::new(&folder);
        let stop = StopToken::default();
        let report = interruptible(py, &stop, || {
            let _turn = engine.turn(&stop);
            engine.under(&stop).run(&name, &text, &files, &settings)
        })?;
        if let Some(unknown) = report.unknown_settings.first() {
            return Err(PyKeyError::new_err(unknown.clone()));
        }
        let inputs = files.inputs();
        Ok(Results {
            report: Arc::new(report),
            engine,
            stop,
            inputs,
            script: folder.join(name),
            settings,
        })
    }

    /// The parameters of a script, as `virote params --json` has them.
    fn parameters(
        &self,
        py: Python<'_>,
        name: &str,
        text: &[u8],
        folder: PathBuf,
    ) -> PyResult<String> {
        let engine = self.engine();
        let files = ScriptFiles::new(&folder);
        let stop = StopToken::default();
        let found = interruptible(py, &stop, || {
            let _turn = engine.turn(&stop);
            engine.under(&stop).parameters(name, text, &files)
        })?;
        match found {
            Ok(schema) => Ok(virote::schema_json(name, &schema).to_string()),
            Err(report) => Err(first_error(py, &report)),
        }
    }

    /// Calls a built-in by name, or a function that a value holds.
    #[pyo3(signature = (function, args, named, folder))]
    fn call<'py>(
        &self,
        py: Python<'py>,
        function: &Bound<'py, PyAny>,
        args: &Bound<'py, PyTuple>,
        named: &Bound<'py, PyDict>,
        folder: PathBuf,
    ) -> PyResult<Bound<'py, PyAny>> {
        let engine = self.engine();
        let callee = match function.cast::<Held>() {
            Ok(held) => held.get().value.clone(),
            Err(_) => engine
                .session
                .builtin(&function.extract::<String>()?)
                .map_err(|found| geo_error(py, &found, &Sources::default()))?,
        };
        let arguments = arguments(&callee, args, named)?;
        let files = ScriptFiles::new(&folder);
        let stop = StopToken::default();
        let (answer, warnings) = interruptible(py, &stop, || {
            let document = (Unit::Mm, Tolerance::DEFAULT);
            engine.under(&stop).call(&callee, arguments, document, &files)
        })?;
        for warning in warnings {
            let text = format!("[{}] {}", warning.code.id(), warning.message);
            py.import("virote._findings")?.getattr("_warn")?.call1((text,))?;
        }
        let answer = answer.map_err(|found| geo_error(py, &found, &Sources::default()))?;
        to_python(py, &answer)
    }
}

/// The exception for the first error of a report.
fn first_error(py: Python<'_>, report: &Report) -> PyErr {
    let error = report.diagnostics.iter().find(|found| found.severity == Severity::Error);
    match error {
        Some(error) => geo_error(py, error, &report.sources),
        None => PyValueError::new_err("the script has no value"),
    }
}

/// Arguments as the types of the built-in read them: of several of one name that which the language calls,
/// by the first argument and the places for all of them.
fn arguments(
    callee: &Value,
    args: &Bound<'_, PyTuple>,
    named: &Bound<'_, PyDict>,
) -> PyResult<Arguments> {
    let Value::Function(Function::Builtin(_, ops)) = callee else {
        return read(None, args, named);
    };
    let mut taken = None;
    if let [_, _, ..] = ops[..] {
        let first_name = ops[0].params.first().map(|param| param.name);
        for op in ops.iter() {
            let Ok(read) = read(Some(op), args, named) else { continue };
            let by_name = || read.named.iter().find(|(name, _)| Some(name.as_str()) == first_name);
            let first = read.positional.first().or_else(|| by_name().map(|(_, value)| value));
            if first.is_some_and(|first| !op.takes_first(first)) {
                continue;
            }
            let labels = read.named.iter().map(|(name, _)| name.as_str());
            if op.has_places(read.positional.len(), labels) {
                return Ok(read);
            }
            taken.get_or_insert(read);
        }
    }
    match taken {
        Some(read) => Ok(read),
        None => read(ops.first().copied(), args, named),
    }
}

fn read(
    op: Option<&'static Op>,
    args: &Bound<'_, PyTuple>,
    named: &Bound<'_, PyDict>,
) -> PyResult<Arguments> {
    let parameters = op.map_or(&[][..], |op| op.params);
    let mut intake = Intake::default();
    let is_named = |name: &str| named.contains(name).unwrap_or(false);
    let open = parameters.iter().filter(|parameter| {
        (!parameter.may_be_left_out() || parameter.by_position) && !is_named(parameter.name)
    });
    let open: Vec<Type> = open.map(|parameter| parameter.ty).collect();
    let spreads = parameters.first().filter(|parameter| parameter.spreads);
    let element = match spreads.map(|parameter| parameter.ty) {
        // More arguments than places are the elements of the first.
        Some(Type::List(of, _)) if open.len() < args.len() => Some(*of),
        _ => None,
    };
    let mut positional = Vec::with_capacity(args.len());
    for (i, given) in args.iter().enumerate() {
        let ty = element.or_else(|| open.get(i).copied()).unwrap_or(Type::Any);
        positional.push(from_python(&given, ty, &mut intake)?);
    }
    let mut by_name = Vec::with_capacity(named.len());
    for (name, given) in named.iter() {
        // Words that Python keeps for itself have a stroke behind them.
        let name: String = name.extract::<String>()?.trim_end_matches('_').to_owned();
        let parameter = parameters.iter().find(|parameter| parameter.name == name);
        let ty = parameter.map_or(Type::Any, |parameter| parameter.ty);
        by_name.push((name, from_python(&given, ty, &mut intake)?));
    }
    Ok(Arguments { positional, named: by_name })
}

/// What came of a script.
#[pyclass(frozen, module = "virote._virote")]
pub(crate) struct Results {
    report: Arc<Report>,
    engine: Arc<Engine>,
    /// The switch that its files go by.
    stop: StopToken,
    inputs: Vec<PathBuf>,
    script: PathBuf,
    settings: Vec<Setting>,
}

/// Why a file could not be written.
enum WriteFailure {
    /// The value, or a ceiling.
    Refused(Box<Diagnostic>),
    /// The system.
    System(io::Error),
}

impl From<io::Error> for WriteFailure {
    fn from(err: io::Error) -> Self {
        Self::System(err)
    }
}

#[pymethods]
impl Results {
    /// Names of definitions that have a value, in the order of the script.
    fn names(&self) -> Vec<String> {
        let definitions = self.report.definitions.iter();
        definitions.filter(|its| its.value.is_some()).map(|its| its.name.clone()).collect()
    }

    /// The value of a definition, or nothing where there is none.
    fn value<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.report.value(name).map(|value| to_python(py, &value)).transpose()
    }

    /// The unit of a definition that is a number; nothing where it has none.
    fn unit(&self, name: &str) -> Option<String> {
        let defined = self.report.definitions.iter().find(|defined| defined.name == name)?;
        match defined.value.as_ref()? {
            Value::Number(number) => number.dim.unit(self.report.document.0.name()),
            _ => None,
        }
    }

    /// The name nearest to one that is not defined.
    fn nearest(&self, name: &str) -> Option<String> {
        let names = self.report.definitions.iter().map(|defined| defined.name.as_str());
        virote::diag::nearest(name, names).map(str::to_owned)
    }

    /// Findings: JSON and the picture of the terminal of each.
    fn findings(&self) -> Vec<(String, String)> {
        let sources = &self.report.sources;
        let told = |found: &Diagnostic| {
            (render::json(found, sources).to_string(), render::picture(found, sources, false))
        };
        self.report.diagnostics.iter().map(told).collect()
    }

    /// The exception for the first error, if there is one.
    fn error(&self, py: Python<'_>) -> Option<Py<PyAny>> {
        let has_error = 0 < self.report.count(Severity::Error);
        has_error.then(|| first_error(py, &self.report).into_value(py).into_any())
    }

    /// Judged claims as JSON.
    fn checks(&self) -> String {
        let checks = self.report.events.iter().filter_map(|event| match event {
            Event::Checked(checked) => Some(self.check(checked)),
            _ => None,
        });
        Json::Array(checks.collect()).to_string()
    }

    /// Printed lines: the expression, the line, the value.
    fn prints<'py>(&self, py: Python<'py>) -> PyResult<Vec<(String, String, Bound<'py, PyAny>)>> {
        let prints = self.report.events.iter().filter_map(|event| match event {
            Event::Printed(printed) => Some(printed),
            _ => None,
        });
        let told = |printed: &Printed| {
            let value = to_python(py, &printed.value)?;
            Ok((printed.source.clone(), printed.to_string(), value))
        };
        prints.map(told).collect()
    }

    /// Names of the files that the script exports.
    fn exports(&self) -> Vec<String> {
        let files = self.report.events.iter().filter_map(|event| match event {
            Event::File(file) => Some(file.path.clone()),
            _ => None,
        });
        files.collect()
    }

    /// Writes the exported files below a folder; their paths.
    fn write(&self, py: Python<'_>, out: PathBuf) -> PyResult<Vec<PathBuf>> {
        let mut inputs = self.inputs.clone();
        inputs.push(self.script.clone());
        let files = self.report.events.iter().filter_map(|event| match event {
            Event::File(file) => Some(file),
            _ => None,
        });
        let (files, sources) = (files.collect::<Vec<_>>(), &self.report.sources);
        for file in &files {
            let refused = |refusal| match refusal {
                TargetRefusal::Forbidden(why) => PyOSError::new_err(why),
                TargetRefusal::System(why) => {
                    write_error(py, &file.refusal(&io::Error::other(why).into()), sources, None)
                }
            };
            OutputTarget::new(&out, &file.path, &inputs).map_err(refused)?;
        }
        let mut written = Vec::new();
        for file in files {
            let path = out.join(&file.path);
            let made = interruptible(py, &self.stop, || {
                let mut bytes = Vec::new();
                file.write(&mut bytes).map_err(WriteFailure::Refused)?;
                let folder = path.parent().unwrap_or(&out);
                std::fs::create_dir_all(folder)?;
                replace(&path, None, |out| out.write_all(&bytes))?;
                Ok(())
            })?;
            made.map_err(|failure| match failure {
                WriteFailure::Refused(found) => geo_error(py, &found, sources),
                WriteFailure::System(err) => {
                    let number = err.raw_os_error();
                    write_error(py, &file.refusal(&err.into()), sources, number)
                }
            })?;
            written.push(path);
        }
        Ok(written)
    }

    /// A shaded picture in PNG; of these definitions, or of what the script exports.
    fn picture(
        &self,
        py: Python<'_>,
        size: [usize; 2],
        view: Option<String>,
        only: Vec<String>,
    ) -> PyResult<Vec<u8>> {
        let stop = StopToken::default();
        let wanted = Wanted { size, view: view.as_deref(), only: &only };
        picture::draw(py, &self.engine.under(&stop), &stop, &self.report, wanted)
    }

    /// The page of the viewer with this model, which asks nobody; nothing where there is none.
    fn page(&self, py: Python<'_>) -> PyResult<Option<String>> {
        let stop = StopToken::default();
        let limits = *self.engine.session.limits();
        let make = |stop: StopToken| session::Session::new(limits).measured(held).stopped_by(stop);
        let (script, settings) = (self.script.clone(), self.settings.clone());
        interruptible(py, &stop, || virote::view::single_page(script, settings, &make))
    }
}

impl Results {
    fn check(&self, checked: &Checked) -> Json {
        let source = self.report.sources.at(checked.span);
        let verdict = &checked.verdict;
        json!({
            "claim": checked.source,
            "holds": verdict.holds,
            "margin": verdict.margin(),
            "message": checked.message,
            "file": source.map(|source| source.name.as_str()),
            "line": source.map(|source| source.line_column(checked.span.start).0),
            "figures": verdict.figures(),
        })
    }
}
