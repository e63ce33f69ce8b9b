//! What could stand at a place: names with their values, labels not yet given, words, fields, files, units.

use std::{collections::BTreeSet, ops::Range};

use super::{
    DefinedName, Document, NameRole, Values, completion_spot::CompletionSpot, hover,
    wanted_types::WantedTypes,
};
use crate::{
    docs, eval,
    kernel::sorting::sort_by,
    session::Session,
    syntax::{self, Binding, CompletionPlace, Highlight, KEYWORDS},
    value::{Op, Registry, Value},
};

/// What a completion is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum CompletionKind {
    /// A label of an argument that is not given yet.
    Label,
    /// A member of what stands before the dot.
    Field,
    /// A word that an option takes.
    Choice,
    /// A file or folder.
    File,
    /// A unit.
    Unit,
    /// A name that a function, a comprehension or a block defines around the place.
    Local,
    /// A definition of the file.
    Definition,
    /// A function of the script.
    Function,
    /// An imported file.
    Import,
    /// A built-in operation.
    BuiltIn,
    /// A built-in value.
    Constant,
    /// A word of the language.
    Keyword,
}

impl CompletionKind {
    /// Whether it is a name that stands for a value.
    fn is_name(self) -> bool {
        use CompletionKind::{BuiltIn, Constant, Definition, Function, Import, Local};
        matches!(self, Local | Definition | Function | Import | BuiltIn | Constant)
    }
}

/// Something that could stand at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Completion {
    /// What it is called.
    pub label: String,
    /// What it is, in a few words.
    pub detail: String,
    /// What the script says of it, as Markdown; of built-ins [`Completion::all_docs`] tells more.
    pub docs: String,
    /// What it is.
    pub kind: CompletionKind,
    /// What is replaced.
    pub range: Range<usize>,
    /// What stands there afterwards.
    pub insert: String,
    /// The same with places to fill in, as `name(${1:a}, ${2:b})`, where there are some.
    pub snippet: Option<String>,
    /// Whether it is of a kind that is taken at the place, as far as that is known.
    pub is_fitting: bool,
}

/// A file or folder of a folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FolderEntry {
    /// Its name.
    pub name: String,
    /// Whether it is a folder.
    pub is_folder: bool,
}

impl Completion {
    pub(super) fn new(
        label: impl Into<String>,
        kind: CompletionKind,
        range: &Range<usize>,
    ) -> Self {
        let label = label.into();
        Self {
            insert: label.clone(),
            label,
            detail: String::new(),
            docs: String::new(),
            kind,
            range: range.clone(),
            snippet: None,
            is_fitting: true,
        }
    }

    pub(super) fn detail(self, detail: impl Into<String>) -> Self {
        Self { detail: detail.into(), ..self }
    }

    pub(super) fn docs(self, docs: impl Into<String>) -> Self {
        Self { docs: docs.into(), ..self }
    }

    pub(super) fn fitting(self, is_fitting: bool) -> Self {
        Self { is_fitting, ..self }
    }

    /// What is likelier comes before.
    fn rank(&self) -> (bool, CompletionKind) {
        (!self.is_fitting, self.kind)
    }

    /// What it does, as Markdown, also of a built-in: a page that is made when somebody looks at it.
    #[must_use]
    pub fn all_docs(&self, registry: &Registry) -> String {
        let is_built_in = matches!(self.kind, CompletionKind::BuiltIn | CompletionKind::Constant);
        let page = is_built_in.then(|| docs::markdown(registry, &self.label)).flatten();
        page.unwrap_or_else(|| self.docs.clone())
    }
}

impl Document {
    /// What could stand at a byte; `list` gives the entries of a folder, relative to that of the text.
    #[must_use]
    pub fn completions(
        &self,
        session: &Session,
        values: Option<&Values>,
        list: &dyn Fn(&str) -> Vec<FolderEntry>,
        at: usize,
    ) -> Vec<Completion> {
        let at = self.text.floor_char_boundary(at.min(self.text.len()));
        let registry = session.registry();
        let place = CompletionSpot { document: self, session, registry, values, at };
        let mut found = place.all(list);
        sort_by(&mut found, |a, b| (a.rank(), &a.label).cmp(&(b.rank(), &b.label)));
        found.dedup_by(|b, a| a.label == b.label);
        found
    }
}

impl CompletionSpot<'_> {
    pub(super) fn before(&self) -> &str {
        self.document.text.get(..self.at).unwrap_or_default()
    }

    /// The word under way: what is already behind the place is replaced too.
    pub(super) fn word_from(&self, start: usize) -> Range<usize> {
        let is_part = |c: char| c.is_alphanumeric() || c == '_';
        let rest = &self.document.text[self.at..];
        let behind = rest.len() - rest.trim_start_matches(is_part).len();
        start..self.at + behind
    }

    fn all(&self, list: &dyn Fn(&str) -> Vec<FolderEntry>) -> Vec<Completion> {
        if let Some(units) = self.units() {
            return units;
        }
        match syntax::place(self.before()) {
            CompletionPlace::Comment => Vec::new(),
            CompletionPlace::Field { start, of } => self.fields(of, &self.word_from(start)),
            CompletionPlace::Text { start, call, label } => self.in_text(start, call, label, list),
            CompletionPlace::Format { start, of } => self.number_formats(of, start),
            CompletionPlace::Name { start } => self.names(&self.word_from(start)),
        }
    }

    pub(super) fn line_before(&self) -> &str {
        self.before().rsplit('\n').next().unwrap_or_default()
    }

    /// Whether the piece before the place is a number.
    pub(super) fn is_in_number(&self) -> bool {
        syntax::pieces(self.before())
            .last()
            .is_some_and(|(paint, range)| *paint == Highlight::Number && range.end == self.at)
    }

    fn names(&self, range: &Range<usize>) -> Vec<Completion> {
        let before = self.document.text[..range.start].trim_end();
        if before.ends_with(':') && self.line_before().trim_start().starts_with("param") {
            return eval::param_kinds()
                .map(|word| Completion::new(word, CompletionKind::Keyword, range))
                .collect();
        }
        if let Some(names) = self.names_to_import(range) {
            return names;
        }
        let mut found = Vec::new();
        let call = syntax::open_call(&self.document.text, range.start);
        if let Some(call) = &call {
            self.labels(call, range, &mut found);
            if call.name == "with" && call.label.is_none() {
                return found;
            }
        }
        let wanted = self.wanted(call.as_ref(), range.start);
        found.extend(self.words_wanted(call.as_ref(), &wanted, range));
        self.locals(range, &mut found);
        let of_file = self.document.outline.of_file().filter(|name| !self.is_being_defined(name));
        found.extend(of_file.map(|name| self.definition(name, range, &wanted)));
        for name in self.registry.names() {
            found.push(self.built_in(name, range, &wanted));
        }
        // A name means one thing: what is defined around the place hides what is further away.
        let mut meant = BTreeSet::new();
        found.retain(|one| !one.kind.is_name() || meant.insert(one.label.clone()));
        let begins_line = self.line_before().trim_start().len() <= self.at - range.start;
        found.extend(KEYWORDS.iter().map(|word| {
            let snippet = begins_line.then(|| statement_snippet(word)).flatten();
            Completion {
                snippet: snippet.map(str::to_owned),
                ..Completion::new(*word, CompletionKind::Keyword, range)
                    .fitting(wanted.takes_word(word))
            }
        }));
        found
    }

    /// Names that are known here and not in all of the file.
    fn locals(&self, range: &Range<usize>, found: &mut Vec<Completion>) {
        let outline = &self.document.outline;
        let known = outline.names.iter().filter(|name| {
            !name.is_of_file && name.scope.start <= self.at && self.at <= name.scope.end
        });
        // What the whole file knows is offered as that.
        let mut seen: BTreeSet<&str> = outline.of_file().map(|name| &*name.name).collect();
        for name in known {
            seen.insert(&name.name);
            if self.is_being_defined(name) {
                continue;
            }
            let anything = WantedTypes::default();
            let local = self.definition(name, range, &anything);
            found.push(Completion { kind: CompletionKind::Local, ..local });
        }
        // A statement under way does not parse yet.
        for (name, _) in self.bindings() {
            if seen.insert(name) {
                found.push(Completion::new(name, CompletionKind::Local, range));
            }
        }
    }

    /// The names that statements bind which do not parse yet, or the one around the place, in their order.
    pub(super) fn bindings(&self) -> Vec<(&str, Binding)> {
        let outline = &self.document.outline;
        let acts = outline.acts.iter().map(|act| act.whole.end);
        let ends = acts.chain(outline.of_file().map(|name| name.whole.end));
        let start = ends.filter(|&end| end < self.at).max().unwrap_or(0);
        let text = self.document.text.get(start..self.at).unwrap_or_default();
        let bound = syntax::bindings(text).into_iter();
        let shifted = |range: Range<usize>| range.start + start..range.end + start;
        bound
            .map(|Binding { name, value, source }| {
                let text = &text[name.clone()];
                let (value, source) = (value.map(shifted), source.map(shifted));
                (text, Binding { name: shifted(name), value, source })
            })
            .collect()
    }

    /// Whether the place is in the definition of a name that may not use itself, as only functions may.
    fn is_being_defined(&self, name: &DefinedName) -> bool {
        matches!(name.role, NameRole::Definition(_) | NameRole::Param)
            && name.place.end < self.at
            && self.at <= name.whole.end
    }

    pub(super) fn definition(
        &self,
        name: &DefinedName,
        range: &Range<usize>,
        wanted: &WantedTypes,
    ) -> Completion {
        let value = self.values.and_then(|values| Some((values, values.value(&name.name)?)));
        let value =
            value.filter(|(_, value)| name.is_of_file && !matches!(value, Value::Function(_)));
        let is_fitting = wanted.takes_defined(name, value.map(|(_, value)| value));
        let detail = match value {
            Some((values, value)) => values.brief(value).unwrap_or_else(|| value.phrase()),
            None => hover::signature(name),
        };
        let (kind, snippet) = match name.role {
            NameRole::Function => {
                let required = name.parameters.iter().filter(|(_, default)| default.is_none());
                let required: Vec<&str> = required.map(|(name, _)| name.as_str()).collect();
                (CompletionKind::Function, self.call_snippet(&name.name, &required))
            }
            NameRole::Import => (CompletionKind::Import, None),
            _ => (CompletionKind::Definition, None),
        };
        let docs = name.docs.as_deref().map(docs::paragraph).unwrap_or_default();
        let found = Completion::new(&name.name, kind, range).detail(detail).docs(docs);
        Completion { snippet, ..found }.fitting(is_fitting)
    }

    fn built_in(&self, name: &str, range: &Range<usize>, wanted: &WantedTypes) -> Completion {
        if let Some(constant) = self.registry.constant(name) {
            let value = (constant.value)();
            return Completion::new(name, CompletionKind::Constant, range)
                .detail(value.to_string())
                .fitting(wanted.takes(&value));
        }
        let ops: &[&Op] = self.registry.get(name).map(|(_, ops)| &ops[..]).unwrap_or_default();
        let first = ops.first();
        let required: Vec<&str> = first
            .map(|op| {
                op.params
                    .iter()
                    .filter(|param| !param.may_be_left_out())
                    .map(|param| param.name)
                    .collect()
            })
            .unwrap_or_default();
        Completion {
            snippet: self.call_snippet(name, &required),
            ..Completion::new(name, CompletionKind::BuiltIn, range)
        }
        .detail(first.map(|op| op.signature()).unwrap_or_default())
        .fitting(ops.iter().any(|op| wanted.takes_type(op.returns)))
    }

    /// A call with places for its arguments, unless brackets stand there already.
    fn call_snippet(&self, name: &str, required: &[&str]) -> Option<String> {
        let word_end = self.word_from(self.at).end;
        if self.document.text[word_end..].starts_with('(') {
            return None;
        }
        let is_piped = self
            .before()
            .trim_end_matches(|c: char| c.is_alphanumeric() || c == '_')
            .trim_end()
            .ends_with("|>");
        let required = &required[usize::from(is_piped).min(required.len())..];
        let places: Vec<String> =
            required.iter().enumerate().map(|(i, name)| format!("${{{}:{name}}}", i + 1)).collect();
        Some(format!("{name}({}$0)", places.join(", ")))
    }
}

/// A statement with places to fill in.
fn statement_snippet(keyword: &str) -> Option<&'static str> {
    Some(match keyword {
        "param" => "param ${1:name} = ${2:10mm} in ${3:1mm..100mm}",
        "fn" => "fn ${1:name}(${2:x}) = $0",
        "check" => "check $1 ~= $2 within ${3:1e-6}",
        "export" => "export ${1:name} to \"${2:name.step}\"",
        "import" => "import \"$1\"",
        "test" => "test \"${1:what holds}\" {\n    check $0\n}",
        _ => return None,
    })
}
