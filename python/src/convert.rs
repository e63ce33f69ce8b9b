//! Values on their way between Python and the language.
//!
//! On the way in the type of the parameter decides: a pair of numbers is a point where a point is wanted,
//! and a range where that is; a `virote.Range` is one everywhere. What fits no type goes in as it is, so that the
//! language says what it wants.

use std::sync::Arc;

use numpy::{
    AllowTypeChange, PyArray1, PyArrayDescrMethods, PyArrayLikeDyn, PyArrayMethods, PyUntypedArray,
    PyUntypedArrayMethods,
};
use pyo3::{
    exceptions::{PyTypeError, PyValueError},
    prelude::*,
    sync::PyOnceLock,
    types::{
        PyBool, PyByteArray, PyBytes, PyDict, PyFloat, PyInt, PyList, PyString, PyTuple, PyType,
    },
};
use virote::{
    kernel::glam::DVec3,
    limits::Limits,
    value::{Dimension, List, Number, Range, Record, Type, Value, radians_of},
};

use crate::{arrays, errors::class, geometry::Held};

/// A point as an array.
pub(crate) fn point(py: Python<'_>, point: DVec3) -> Bound<'_, PyArray1<f64>> {
    PyArray1::from_slice(py, &point.to_array())
}

/// A value of the language as Python has it.
pub(crate) fn to_python<'py>(py: Python<'py>, held: &Value) -> PyResult<Bound<'py, PyAny>> {
    Ok(match held {
        Value::None => py.None().into_bound(py),
        Value::Bool(truth) => PyBool::new(py, *truth).to_owned().into_any(),
        Value::Number(number) => PyFloat::new(py, number.value).into_any(),
        Value::Text(text) => PyString::new(py, text).into_any(),
        Value::Point(at) => {
            arrays::load(py)?;
            point(py, *at).into_any()
        }
        Value::Range(range) => {
            range_class(py)?.call1((range.start.value, range.end.value, range.closed))?
        }
        Value::List(items) => list(py, items)?,
        Value::Record(record) => {
            let members = PyDict::new(py);
            for (name, member) in record.iter() {
                members.set_item(name, to_python(py, member)?)?;
            }
            members.into_any()
        }
        Value::Jet(_)
        | Value::JetPoint(_)
        | Value::JetRange(_)
        | Value::JetCurve(_)
        | Value::JetSurface(_)
        | Value::JetRegion(_)
        | Value::JetSolid(_) => to_python(py, &held.looked_at())?,
        Value::Function(_)
        | Value::Curve(_)
        | Value::Surface(_)
        | Value::Region(_)
        | Value::Face(_)
        | Value::Solid(_)
        | Value::Mesh(_)
        | Value::Table(_)
        | Value::Frame(_) => {
            static WRAP: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
            let wrap = WRAP.get_or_try_init(py, || -> PyResult<Py<PyAny>> {
                Ok(py.import("virote._geometry")?.getattr("_wrap")?.unbind())
            })?;
            let inner = Held { value: held.clone() };
            wrap.bind(py).call1((held.kind(), inner))?
        }
    })
}

/// Numbers and points as arrays, all else as a list.
fn list<'py>(py: Python<'py>, items: &List) -> PyResult<Bound<'py, PyAny>> {
    let numbers: Option<Vec<f64>> = items
        .values()
        .map(|item| match item {
            Value::Number(number) => Some(number.value),
            _ => None,
        })
        .collect();
    if let Some(numbers) = numbers.filter(|numbers| !numbers.is_empty()) {
        arrays::load(py)?;
        return Ok(PyArray1::from_vec(py, numbers).into_any());
    }
    let points: Option<Vec<[f64; 3]>> = items
        .values()
        .map(|item| match item {
            Value::Point(at) => Some(at.to_array()),
            _ => None,
        })
        .collect();
    if let Some(points) = points.filter(|points| !points.is_empty()) {
        arrays::load(py)?;
        let flat = PyArray1::from_vec(py, points.concat());
        return Ok(flat.reshape([points.len(), 3])?.into_any());
    }
    let all = PyList::empty(py);
    for item in items.values() {
        all.append(to_python(py, &item)?)?;
    }
    Ok(all.into_any())
}

/// Lists around one another below which more of them are deep.
const DEEP: u32 = 8;

/// Deep lists and records in one value: those that share their parts have more of them than any memory.
const MOST_DEEP: usize = 100_000;

/// Values on their way in.
#[derive(Default)]
pub(crate) struct Intake {
    /// Lists and records around the one that is read.
    depth: u32,
    /// Values that were read, and of these the lists and records that are deep inside.
    n_values: usize,
    n_deep: usize,
}

impl Intake {
    /// Goes into a list or a record, which may hold itself in Python; whoever does comes out again by `leave`.
    fn enter(&mut self) -> PyResult<()> {
        let most = Limits::DEFAULT.value_depth;
        if most <= self.depth {
            let told = format!("a value is nested in itself, or more than {most} lists deep");
            return Err(PyValueError::new_err(told));
        }
        self.depth += 1;
        self.n_deep += usize::from(DEEP < self.depth);
        if MOST_DEEP < self.n_deep {
            let told = format!(
                "more than {MOST_DEEP} lists lie deep in one another, counted wherever they stand"
            );
            return Err(PyValueError::new_err(told));
        }
        Ok(())
    }

    /// Counts one value more, and looks now and then whether somebody wants it to end.
    fn count(&mut self, py: Python<'_>) -> PyResult<()> {
        const STRIDE: usize = 4096;
        self.n_values += 1;
        if self.n_values.is_multiple_of(STRIDE) { py.check_signals() } else { Ok(()) }
    }

    fn leave(&mut self) {
        self.depth -= 1;
    }
}

/// A value of Python for a parameter of a type.
///
/// # Errors
/// `TypeError` of what has no meaning in the language, `ValueError` of numbers that are not finite, of masked
/// elements, and of what is nested too deep.
pub(crate) fn from_python(
    given: &Bound<'_, PyAny>,
    ty: Type,
    intake: &mut Intake,
) -> PyResult<Value> {
    intake.count(given.py())?;
    if given.is_none() {
        return Ok(Value::None);
    }
    if let Some(value) = held(given) {
        return Ok(value);
    }
    if is_bool(given) {
        return Ok(Value::Bool(given.is_truthy()?));
    }
    if let Ok(text) = given.cast::<PyString>() {
        if ty == Type::Function {
            // The text of a function is one.
            let made = given.py().import("virote._session")?.getattr("function")?.call1((text,))?;
            return from_python(&made, Type::Any, intake);
        }
        return Ok(text_value(text.to_str()?, ty));
    }
    if let Some(number) = number(given)? {
        return Ok(number);
    }
    if let Ok(members) = given.cast::<PyDict>() {
        return record(members, ty, intake);
    }
    if given.is_instance(range_class(given.py())?)? {
        let closed = given.getattr("closed")?.is_truthy()?;
        let refused =
            || PyTypeError::new_err("the ends of a range are numbers, or texts with a unit");
        return range(given, closed, intake)?.ok_or_else(refused);
    }
    sequence(given, ty, intake)
}

/// A dictionary, whose keys are the names of fields. Where a record stands for several of what the parameter may be
/// else, such as a range for each unknown, its members are read as that.
fn record(members: &Bound<'_, PyDict>, ty: Type, intake: &mut Intake) -> PyResult<Value> {
    let of = match ty {
        Type::OneOf(types) if types.contains(&Type::Record) => ty,
        _ => Type::Any,
    };
    intake.enter()?;
    let found = fields(members, of, intake);
    intake.leave();
    Ok(Value::Record(Arc::new(Record::new(found?))))
}

/// By a loop, as the elements of lists: each level of a nested value takes its part of a stack that Python made,
/// which iterators inside one another would take several times.
fn fields(
    members: &Bound<'_, PyDict>,
    of: Type,
    intake: &mut Intake,
) -> PyResult<Vec<(Arc<str>, Value)>> {
    let mut found = Vec::with_capacity(members.len());
    for (name, member) in members {
        found.push((field_name(&name)?, from_python(&member, of, intake)?));
    }
    Ok(found)
}

fn field_name(name: &Bound<'_, PyAny>) -> PyResult<Arc<str>> {
    let text = name.extract::<String>().map_err(|_| {
        let found = type_name(name);
        PyTypeError::new_err(format!("the keys of a record are texts, found {found}"))
    });
    Ok(Arc::from(text?))
}

fn type_name(given: &Bound<'_, PyAny>) -> String {
    given.get_type().name().map(|name| name.to_string()).unwrap_or_default()
}

/// What the classes of the package hold.
fn held(given: &Bound<'_, PyAny>) -> Option<Value> {
    let inner = given.getattr_opt("_held").ok()??;
    let inner = inner.cast::<Held>().ok()?;
    Some(inner.get().value.clone())
}

/// A truth value, of Python or of NumPy.
fn is_bool(given: &Bound<'_, PyAny>) -> bool {
    given.is_instance_of::<PyBool>()
        || given.get_type().name().is_ok_and(|name| name == "bool" || name == "bool_")
}

fn is_of_truths(array: &Bound<'_, PyUntypedArray>) -> bool {
    array.dtype().kind() == b'b'
}

/// A text, or the quantity that it says where a number is wanted.
fn text_value(text: &str, ty: Type) -> Value {
    let wants_text = |ty: &Type| matches!(ty, Type::Text | Type::Choice(_));
    let is_text = match ty {
        Type::OneOf(types) => types.iter().any(wants_text),
        other => wants_text(&other),
    };
    match quantity(text) {
        Some(number) if !is_text => Value::Number(number),
        _ => Value::text(text),
    }
}

/// `12mm`, `30deg`, `0.5turn`: a length in millimetres, an angle in radians.
pub(crate) fn quantity(text: &str) -> Option<Number> {
    let text = text.trim();
    let digits = text.trim_end_matches(char::is_alphabetic).len();
    let value: f64 = text[..digits].trim().parse().ok().filter(|value: &f64| value.is_finite())?;
    let unit = virote::syntax::ast::Unit::from_name(&text[digits..])?;
    Some(match (unit.millimetres(), unit.name()) {
        (Some(size), _) => Number { value: value * size, dim: Dimension::LENGTH },
        (None, "deg") => Number::angle(radians_of(value)),
        (None, "turn") => Number::angle(value * std::f64::consts::TAU),
        (None, _) => Number::angle(value),
    })
}

/// A number, if it is one.
fn number(given: &Bound<'_, PyAny>) -> PyResult<Option<Value>> {
    let is_number = given.is_instance_of::<PyFloat>() || given.is_instance_of::<PyInt>();
    let is_scalar = || {
        if !given.hasattr("__float__").unwrap_or(false) {
            return Ok(false);
        }
        PyResult::Ok(match arrays::array(given)? {
            Some(array) => array.ndim() == 0 && !is_of_truths(array),
            None => !given.hasattr("__len__").unwrap_or(true),
        })
    };
    if is_bool(given) || !is_number && !is_scalar()? {
        return Ok(None);
    }
    finite(given.extract::<f64>()?).map(|value| Some(Value::number(value)))
}

fn finite(value: f64) -> PyResult<f64> {
    if value.is_finite() {
        return Ok(value);
    }
    Err(PyValueError::new_err(format!("{value} is no number of the language; numbers are finite")))
}

/// Sequences and arrays.
fn sequence(given: &Bound<'_, PyAny>, ty: Type, intake: &mut Intake) -> PyResult<Value> {
    if given.is_instance_of::<PyBytes>() || given.is_instance_of::<PyByteArray>() {
        let told = "bytes have no meaning in the language; `list(data)` is a list of their numbers";
        return Err(PyTypeError::new_err(told));
    }
    match ty {
        Type::Point => vector(given).or_else(|_| any_sequence(given, intake)),
        Type::Range => match range(given, true, intake)? {
            Some(range) => Ok(range),
            None => any_sequence(given, intake),
        },
        Type::List(of, _) => items(given, *of, intake),
        Type::Grid(of) => {
            let rows = iterate(given)?;
            let rows = rows.into_iter().map(|row| items(&row, *of, intake));
            Ok(Value::list(rows.collect::<PyResult<_>>()?))
        }
        Type::Geometry => vector(given).or_else(|_| items(given, Type::Geometry, intake)),
        Type::OneOf(types) => {
            for one in types {
                if let Ok(value) = from_python(given, *one, intake)
                    && one.accepts(&value)
                {
                    return Ok(value);
                }
            }
            any_sequence(given, intake)
        }
        _ => any_sequence(given, intake),
    }
}

/// The class of ranges, which are told apart from points.
fn range_class(py: Python<'_>) -> PyResult<&Bound<'_, PyType>> {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    class(py, &CLASS, "virote._geometry", "Range")
}

/// Two numbers as a range.
fn range(given: &Bound<'_, PyAny>, closed: bool, intake: &mut Intake) -> PyResult<Option<Value>> {
    let ends: Vec<Bound<'_, PyAny>> = given.extract().unwrap_or_default();
    let [start, end] = &ends[..] else { return Ok(None) };
    let start = from_python(start, Type::Number, intake)?;
    let end = from_python(end, Type::Number, intake)?;
    Ok(match (start, end) {
        (Value::Number(start), Value::Number(end)) => {
            Some(Value::Range(Range { start, end, closed }))
        }
        _ => None,
    })
}

/// A list of elements of a type.
fn items(given: &Bound<'_, PyAny>, of: Type, intake: &mut Intake) -> PyResult<Value> {
    let is_number = matches!(of, Type::Number | Type::Ratio | Type::Count | Type::Integer);
    if is_number && let Some(array) = arrays::array(given)?.filter(|array| !is_of_truths(array)) {
        return numbers(array);
    }
    intake.enter()?;
    let found = elements(given, of, intake);
    intake.leave();
    found.map(Value::list)
}

fn elements(given: &Bound<'_, PyAny>, of: Type, intake: &mut Intake) -> PyResult<Vec<Value>> {
    let all = iterate(given)?;
    let mut found = Vec::with_capacity(all.len());
    for item in &all {
        found.push(from_python(item, of, intake)?);
    }
    Ok(found)
}

fn iterate<'py>(given: &Bound<'py, PyAny>) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let refused = |_| {
        let name = type_name(given);
        PyTypeError::new_err(format!("a value of the type {name} has no meaning in the language"))
    };
    check_mask(given)?;
    given.try_iter().map_err(refused)?.collect()
}

/// Refuses arrays that have masked elements, whose numbers mean nothing.
fn check_mask(given: &Bound<'_, PyAny>) -> PyResult<()> {
    if arrays::array(given)?.is_none_or(|array| array.is_exact_instance_of::<PyUntypedArray>()) {
        return Ok(());
    }
    match given.getattr_opt("mask")? {
        Some(mask) if mask.call_method0("any")?.is_truthy()? => Err(PyValueError::new_err(
            "the array has masked elements; `.compressed()` leaves them out, `.filled(x)` puts a number there",
        )),
        _ => Ok(()),
    }
}

/// All numbers of something like an array, whatever its strides and its type: data of which nobody has said what
/// they measure, as a column without a unit.
fn numbers(given: &Bound<'_, PyAny>) -> PyResult<Value> {
    check_mask(given)?;
    let array: PyArrayLikeDyn<'_, f64, AllowTypeChange> = given.extract()?;
    let all: PyResult<Vec<f64>> = array.as_array().iter().map(|&value| finite(value)).collect();
    Ok(Value::List(List::of_numbers(all?, Dimension::OPEN)))
}

/// Two or three numbers as a point.
fn vector(given: &Bound<'_, PyAny>) -> PyResult<Value> {
    let wrong = || PyTypeError::new_err("a point is two or three numbers");
    let parts = iterate(given)?;
    let mut point = [0.0; 3];
    if parts.len() < 2 || point.len() < parts.len() {
        return Err(wrong());
    }
    for (slot, part) in point.iter_mut().zip(&parts) {
        *slot = match (number(part)?, part.cast::<PyString>()) {
            (Some(Value::Number(number)), _) => number.value,
            (None, Ok(text)) => quantity(text.to_str()?).ok_or_else(wrong)?.value,
            _ => return Err(wrong()),
        };
    }
    Ok(Value::Point(DVec3::from(point)))
}

/// What nobody said anything about: a tuple of numbers is a point, rows of two or three numbers are
/// points, and all else is a list.
fn any_sequence(given: &Bound<'_, PyAny>, intake: &mut Intake) -> PyResult<Value> {
    if let Some(array) = arrays::array(given)? {
        let shape = array.shape().to_vec();
        return match shape[..] {
            [_] if !is_of_truths(array) => numbers(given),
            [_, 2 | 3] => items(given, Type::Point, intake),
            _ => items(given, Type::Any, intake),
        };
    }
    if given.is_instance_of::<PyTuple>()
        && let Ok(point) = vector(given)
    {
        return Ok(point);
    }
    items(given, Type::Any, intake)
}
