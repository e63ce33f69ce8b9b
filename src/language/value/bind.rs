//! Arguments meet parameters: by position or by name, every mistake told together.
//!
//! Required parameters take arguments by position or by name, optional ones by name only. One
//! call yields one diagnostic, with a label for each mistake and the signature as a hint.

use std::sync::Arc;

use super::{
    FromValue, Mismatch, Op, OpParameter, Type, Value,
    affine::varies,
    bind_names::{ParameterPlaces, half_of, meant_by, only_missing},
    element::element_span,
    misplaced,
    variation::looked_at,
};
use crate::{
    diag::{Code, Diagnostic, Fix, Sources, Span, Spanned},
    limits::Ceiling,
};

/// Evaluated arguments on their way into a function.
#[derive(Clone, Debug)]
pub struct Call {
    /// From the function's name to the closing bracket.
    pub span: Span,
    /// Arguments without a label.
    pub positional: Vec<Spanned<Value>>,
    /// Arguments with a label.
    pub named: Vec<(Spanned<Arc<str>>, Spanned<Value>)>,
}

/// A parameter as binding sees it.
#[derive(Clone, Copy, Debug)]
pub struct FormalParameter<'a> {
    /// Its label.
    pub name: &'a str,
    /// Whether it may be left out.
    pub optional: bool,
    /// Whether it may stand by position although it may be left out.
    pub by_position: bool,
    /// What it takes; of a function of the script nobody knows.
    pub ty: Option<Type>,
}

/// One mistake in a call.
#[derive(Clone, Debug)]
struct Mistake {
    code: Code,
    span: Span,
    text: String,
    hint: Option<String>,
    /// An edit that mends it.
    fix: Option<Fix>,
    /// The ceiling that was crossed.
    ceiling: Option<&'static str>,
}

/// What is wrong with a call, collected.
#[derive(Clone, Debug, Default)]
pub struct Mistakes(Vec<Mistake>);

impl Mistakes {
    pub(super) fn add(&mut self, code: Code, span: Span, text: String, hint: Option<String>) {
        self.0.push(Mistake { code, span, text, hint, fix: None, ceiling: None });
    }

    /// The mistake that was added last is a slip for `word`.
    fn meant(&mut self, word: Option<String>) {
        if let (Some(last), Some(word)) = (self.0.last_mut(), word) {
            last.fix = Some(Fix::replace(last.span, word));
        }
    }

    /// The edit mends the mistake that was added last.
    fn mended_by(&mut self, fix: Fix) {
        if let Some(last) = self.0.last_mut() {
            last.fix = Some(fix);
        }
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// All of them as one diagnostic about the call of `name`.
    #[must_use]
    pub fn complaint(self, called: &str, signature: &str, call: Span) -> Box<Diagnostic> {
        let n_mistakes = self.0.len();
        let mut mistakes = self.0.into_iter();
        let Some(first) = mistakes.next() else {
            return Box::new(Diagnostic::error(
                Code::BadCall,
                call,
                format!("{called} cannot be called so"),
            ));
        };
        let ceiling = first.ceiling;
        let mut fixes: Vec<Fix> = first.fix.into_iter().collect();
        let mut hints: Vec<String> = first.hint.into_iter().collect();
        let mut diagnostic = if n_mistakes == 1 {
            Diagnostic::error(first.code, first.span, format!("{called}: {}", first.text))
        } else {
            let message = format!("{called} is called with {n_mistakes} mistakes");
            Diagnostic::error(first.code, first.span, message).label(first.text)
        };
        for mistake in mistakes.by_ref().take(MOST_TOLD - 1) {
            diagnostic = diagnostic.also(mistake.span, mistake.text);
            fixes.extend(mistake.fix);
            hints.extend(mistake.hint.filter(|hint| !hints.contains(hint)));
        }
        if let n_left @ 1.. = mistakes.len() {
            hints.push(format!("and {n_left} more mistakes"));
        }
        hints.push(format!("its signature is `{signature}`"));
        (diagnostic.hints, diagnostic.fixes, diagnostic.ceiling) = (hints, fixes, ceiling);
        Box::new(diagnostic)
    }
}

/// Mistakes of one call that are told one by one; the rest is counted.
const MOST_TOLD: usize = 20;

/// Hands the arguments of `call` to `formals`: one slot a parameter, empty where it was left out.
pub fn assign(
    formals: &[FormalParameter<'_>],
    call: Call,
    mistakes: &mut Mistakes,
) -> Vec<Option<Spanned<Value>>> {
    let mut slots: Vec<Option<Spanned<Value>>> = vec![None; formals.len()];

    // Arguments by name.
    let mut by_name: Vec<bool> = vec![false; formals.len()];
    let places = ParameterPlaces::of(formals, call.named.len());
    let mut unknown = Vec::new();
    for (label, value) in call.named {
        match places.find(formals, &label.value) {
            None => unknown.push((label, value)),
            Some(idx) if slots[idx].is_some() => {
                let text = format!("`{}` is given twice", label.value);
                mistakes.add(Code::BadCall, label.span, text, None);
            }
            Some(idx) => {
                by_name[idx] = true;
                slots[idx] = Some(value);
            }
        }
    }

    let n_positional = call.positional.len();
    take_unknown(formals, unknown, n_positional, (&mut slots, &mut by_name), mistakes);

    // Arguments by position fill the parameters that are still open for them.
    let is_open = |idx: &usize| {
        (!formals[*idx].optional || formals[*idx].by_position) && slots[*idx].is_none()
    };
    let open: Vec<usize> = (0..formals.len()).filter(is_open).collect();
    let n_given = call.positional.len();
    let mut leftover = Vec::new();
    for (place, value) in call.positional.into_iter().enumerate() {
        match open.get(place) {
            Some(&idx) => slots[idx] = Some(value),
            None => leftover.push(value),
        }
    }
    // Where a required parameter was given by name, one of the places was meant for it.
    let by_both = |&(formal, by_name): &(&FormalParameter<'_>, &bool)| !formal.optional && *by_name;
    let twice = formals.iter().zip(&by_name).find(by_both).map(|(formal, _)| formal.name);
    complain_of_leftover(formals, &slots, &leftover, twice, mistakes);

    // Whatever is required and still open is missing.
    let unfilled = open.iter().skip(n_given).filter(|&&idx| !formals[idx].optional);
    let missing: Vec<&str> = unfilled.map(|&idx| formals[idx].name).collect();
    if !missing.is_empty() {
        let named = missing.iter().take(MOST_TOLD).map(|name| format!("`{name}`"));
        let text = format!(
            "missing {} {}{}",
            if missing.len() == 1 { "argument" } else { "arguments" },
            named.collect::<Vec<_>>().join(", "),
            if MOST_TOLD < missing.len() { ", ..." } else { "" }
        );
        mistakes.add(Code::BadCall, call.span, text, None);
    }
    slots
}

/// Takes arguments whose names are misspelt or cut short for what they stand for, and complains of all that name no
/// parameter.
fn take_unknown(
    formals: &[FormalParameter<'_>],
    unknown: Vec<(Spanned<Arc<str>>, Spanned<Value>)>,
    n_positional: usize,
    (slots, by_name): (&mut [Option<Spanned<Value>>], &mut [bool]),
    mistakes: &mut Mistakes,
) {
    let n_unknown = unknown.len();
    for (n_searched, (label, value)) in unknown.into_iter().enumerate() {
        let meant = (n_searched < MOST_TOLD).then(|| meant_by(formals, slots, &label.value));
        let half = half_of(formals, &label.value);
        let only = || only_missing(formals, slots, n_positional, &value);
        let is_only = n_unknown == 1 && half.is_none();
        let meant = meant.flatten().or_else(|| is_only.then(only).flatten());
        let hint = match meant {
            Some(idx) => {
                by_name[idx] = true;
                slots[idx] = Some(value);
                Some(format!("did you mean `{}`?", formals[idx].name))
            }
            None => half,
        };
        let text = format!("there is no parameter `{}`", label.value);
        mistakes.add(Code::BadCall, label.span, text, hint);
        mistakes.meant(meant.map(|idx| formals[idx].name.to_owned()));
    }
}

/// Arguments by position for which no required parameter is left.
fn complain_of_leftover(
    formals: &[FormalParameter<'_>],
    slots: &[Option<Spanned<Value>>],
    leftover: &[Spanned<Value>],
    twice: Option<&str>,
    mistakes: &mut Mistakes,
) {
    let mut optional: Vec<usize> =
        (0..formals.len()).filter(|&idx| formals[idx].optional && slots[idx].is_none()).collect();
    for argument in leftover {
        let fits = |idx: &usize| formals[*idx].ty.is_none_or(|ty| ty.accepts(&argument.value));
        let (text, hint) = match (twice, optional.iter().position(fits)) {
            (Some(name), _) => {
                (format!("one argument too many, since `{name}` is given by name"), None)
            }
            (None, Some(place)) => {
                let name = formals[optional.remove(place)].name;
                let text = "this argument is optional and needs its name".to_owned();
                let fix = Fix::insert(argument.span.at_start(), format!("{name} = "));
                mistakes.add(
                    Code::BadCall,
                    argument.span,
                    text,
                    Some(format!("write `{name} = ...`")),
                );
                mistakes.mended_by(fix);
                continue;
            }
            (None, None) => ("one argument too many".to_owned(), None),
        };
        mistakes.add(Code::BadCall, argument.span, text, hint);
    }
}

/// Reads the arguments of one call of one operation.
#[derive(Debug)]
pub struct Binder<'s> {
    op: &'static Op,
    span: Span,
    slots: Vec<Option<Spanned<Value>>>,
    mistakes: Mistakes,
    /// Elements that a range may stand for.
    most: usize,
    /// The texts in which arguments stand.
    sources: Option<&'s Sources>,
    /// The document's unit of length.
    unit: &'static str,
}

impl<'s> Binder<'s> {
    /// Hands out the arguments of `call`; a range that is read as a list may have `most` elements.
    #[must_use]
    pub fn new(
        op: &'static Op,
        mut call: Call,
        most: usize,
        (sources, unit): (Option<&'s Sources>, &'static str),
    ) -> Self {
        gather_spread(op, &mut call);
        let mut mistakes = Mistakes::default();
        misplaced::correct(op, &mut call, sources, &mut mistakes);
        let span = call.span;
        if let Some(slots) = by_position(op, &mut call) {
            return Self { op, span, slots, mistakes, most, sources, unit };
        }
        let formals: Vec<FormalParameter<'_>> = op
            .params
            .iter()
            .map(|param| FormalParameter {
                name: param.name,
                optional: param.may_be_left_out(),
                by_position: param.by_position,
                ty: Some(param.ty),
            })
            .collect();
        let slots = assign(&formals, call, &mut mistakes);
        Self { op, span, slots, mistakes, most, sources, unit }
    }

    /// Takes parameter `name`; `None` records what is wrong with it.
    pub fn take<T: FromValue>(&mut self, name: &str, default: Option<T>) -> Option<T> {
        let idx = self.op.params.iter().position(|param| param.name == name)?;
        let Some(given) = self.slots[idx].take() else { return default.or_else(T::absent) };
        if let (Value::Range(range), Type::List(..)) = (&given.value, T::TYPE)
            && range.integers().is_some_and(|(_, count)| self.most < count)
        {
            let text = format!("a list of more than {} elements", self.most);
            let (code, span, ceiling) = (Code::TooLarge, given.span, Some(Ceiling::LIST_LENGTH));
            self.mistakes.0.push(Mistake { code, span, text, hint: None, fix: None, ceiling });
            return None;
        }
        let read = |value: &Value| T::from_value(value, given.span);
        let found = read(&given.value);
        found
            .map_err(|why| self.refuse(name, &given, (why, T::TYPE), &|value| read(value).is_ok()))
            .ok()
    }

    /// Records why an argument cannot be read; where it could be without its derivatives, that none pass through.
    #[cold]
    fn refuse(
        &mut self,
        name: &str,
        given: &Spanned<Value>,
        (mut mismatch, wanted): (Mismatch, Type),
        is_taken: &dyn Fn(&Value) -> bool,
    ) {
        if varies(&given.value) && is_taken(&looked_at(&given.value)) {
            mismatch = Mismatch::no_derivative();
        }
        let text = mismatch.sentence(&format!("`{name}`"), wanted);
        let place = element_span(self.sources, given.span, &mismatch.path);
        let own = mismatch.hint.map(|hint| hint.replace("`1mm", &format!("`1{}", self.unit)));
        self.mistakes.add(mismatch.code, place, text, own.or_else(|| wanted.remedy(&given.value)));
        self.mistakes.meant(mismatch.meant.map(|word| format!("\"{word}\"")));
        let source = self.sources.and_then(|sources| sources.at(place));
        let written = source.and_then(|source| source.text.get(source.local(place)));
        let is_number = written.is_some_and(|text| text.parse::<f64>().is_ok());
        if mismatch.code == Code::MissingAngleUnit && is_number {
            self.mistakes.mended_by(Fix::insert(place.at_end(), "deg"));
        }
    }

    /// Whether nothing was wrong so far.
    #[must_use]
    pub fn is_well(&self) -> bool {
        self.mistakes.is_empty()
    }

    /// Everything that was wrong, as one diagnostic.
    #[must_use]
    pub fn complaint(self) -> Box<Diagnostic> {
        self.mistakes.complaint(&format!("`{}`", self.op.name), &self.op.signature(), self.span)
    }
}

/// The arguments in the places of their parameters, where all stand by position and none is missing; as [`assign`] puts
/// them.
fn by_position(op: &Op, call: &mut Call) -> Option<Vec<Option<Spanned<Value>>>> {
    let takes = |param: &OpParameter| !param.may_be_left_out() || param.by_position;
    let open = || op.params.iter().filter(|param| takes(param));
    let n_given = call.positional.len();
    let is_plain = call.named.is_empty()
        && n_given <= open().count()
        && open().skip(n_given).all(OpParameter::may_be_left_out);
    if !is_plain {
        return None;
    }
    let mut given = std::mem::take(&mut call.positional).into_iter();
    Some(op.params.iter().map(|param| if takes(param) { given.next() } else { None }).collect())
}

/// Where the first parameter is a list whose elements may stand as the arguments, makes that list.
fn gather_spread(op: &Op, call: &mut Call) {
    let Some(param) = op.params.first().filter(|param| param.spreads) else { return };
    let Type::List(of, _) = param.ty else { return };
    if !call.positional.first().is_some_and(|arg| of.accepts(&arg.value)) {
        return;
    }
    // Where nothing else can stand by position, whatever stands there was meant as an element.
    let is_alone =
        op.params.iter().skip(1).all(|other| other.may_be_left_out() && !other.by_position);
    let n_run = match call.positional.iter().position(|arg| !of.accepts(&arg.value)) {
        Some(n_run) if !is_alone => n_run,
        _ => call.positional.len(),
    };
    let run: Vec<Spanned<Value>> = call.positional.drain(..n_run).collect();
    let span = run[0].span.to(run[n_run - 1].span);
    let list = Value::list(run.into_iter().map(|arg| arg.value).collect());
    call.positional.insert(0, Spanned::new(list, span));
}
