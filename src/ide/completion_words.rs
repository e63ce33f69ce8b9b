//! Completion of what is chosen from: labels of arguments, words and colours in strings, files, units.

use std::ops::Range;

use super::{
    Completion, CompletionKind, DefinedName, FolderEntry, NameRole, Outline,
    completion_spot::CompletionSpot, hover, owner::Owner, signature::left_to_give,
};
use crate::{
    diag::Code,
    docs, eval,
    export::{ExportOption, FORMATS, Format},
    session,
    syntax::{self, Highlight, OpenCall, ast::Unit, open_call},
    value::{COLOR_NAMES, OpParameter, Value},
};

impl CompletionSpot<'_> {
    /// Units behind a number, and behind the words that take one.
    pub(super) fn units(&self) -> Option<Vec<Completion>> {
        let before = self.before();
        let last =
            before.rsplit(|c: char| !(c.is_alphanumeric() || c == '_' || c == '.')).next()?;
        let is_number = last.starts_with(|c: char| c.is_ascii_digit());
        let digits = last.trim_end_matches(|c: char| c.is_alphabetic());
        let is_after_unit = before[..before.len() - last.len()].trim_end().ends_with("unit")
            && self.line_before().trim_start().starts_with("unit");
        if !is_number && !is_after_unit {
            return None;
        }
        if is_number && (last.contains("..") || !self.is_in_number()) {
            return None;
        }
        let start =
            if is_number { self.at - (last.len() - digits.len()) } else { self.at - last.len() };
        let range = self.word_from(start);
        let units = Unit::ALL.iter().filter(|(_, unit)| is_number || unit.millimetres().is_some());
        let number_start = self.at - if is_number { last.len() } else { 0 };
        let call = open_call(&self.document.text, number_start);
        let wanted = self.wanted(call.as_ref(), number_start);
        let told = |&(name, unit): &(&str, Unit)| {
            let detail = match unit.millimetres() {
                Some(size) => format!("{size} mm"),
                None => "angle".to_owned(),
            };
            Completion::new(name, CompletionKind::Unit, &range)
                .detail(detail)
                .fitting(!is_number || wanted.takes_unit(unit))
        };
        Some(units.map(told).collect())
    }

    /// A string: words that an option takes, colours, codes, files.
    pub(super) fn in_text(
        &self,
        start: usize,
        call: Option<&str>,
        label: Option<&str>,
        list: &dyn Fn(&str) -> Vec<FolderEntry>,
    ) -> Vec<Completion> {
        let quoted = self.document.text[self.at..].split(['"', '\n']).next().unwrap_or_default();
        let range = start..self.at + quoted.len();
        let choice = |word: &str| Completion::new(word, CompletionKind::Choice, &range);
        let parameters = self.parameters(call);
        let param = parameters.iter().find(|param| Some(param.name) == label);
        let words = param.map(|param| param.ty.words()).unwrap_or_default();
        if !words.is_empty() {
            return words.into_iter().map(choice).collect();
        }
        let words = self.words_of_params(start);
        if !words.is_empty() {
            return words.iter().map(|word| choice(word)).collect();
        }
        if label.is_some_and(|label| label.ends_with("color")) {
            return COLOR_NAMES
                .iter()
                .map(|&(name, [r, g, b])| choice(name).detail(format!("#{r:02x}{g:02x}{b:02x}")))
                .collect();
        }
        if let Some(option) = label
            .and_then(|label| self.export_options().into_iter().find(|option| option.name == label))
        {
            return (option.words)().iter().map(|word| choice(word)).collect();
        }
        if self
            .line_before()
            .trim_end_matches(|c: char| c != '"')
            .trim_end_matches('"')
            .trim_end()
            .ends_with("expect error")
        {
            let codes = Code::ALL.iter().filter(|code| code.is_error());
            return codes.map(|code| choice(code.id()).detail(code.title())).collect();
        }
        let Some(endings) = self.endings_of_files(start, call) else { return Vec::new() };
        let begun = self.document.text.get(start..self.at).unwrap_or_default();
        let (folder, name_start) = match begun.rfind('/') {
            Some(slash) => (&begun[..=slash], start + slash + 1),
            None => ("", start),
        };
        let range = name_start..range.end;
        let entry = |entry: FolderEntry| {
            let detail = if entry.is_folder { "folder" } else { "file" };
            let name = if entry.is_folder { entry.name + "/" } else { entry.name };
            let is_fitting = entry.is_folder
                || endings.is_empty()
                || name.rsplit_once('.').is_some_and(|(_, ending)| {
                    endings.iter().any(|of| of.eq_ignore_ascii_case(ending))
                });
            Completion::new(name, CompletionKind::File, &range).detail(detail).fitting(is_fitting)
        };
        let mut found: Vec<Completion> = list(folder).into_iter().map(entry).collect();
        if endings.is_empty() {
            found.extend(self.files_to_write(&range));
        }
        found
    }

    /// Files of every format, called as the path under way, or else as what is written.
    fn files_to_write(&self, range: &Range<usize>) -> Vec<Completion> {
        let begun = self.document.text.get(range.start..self.at).unwrap_or_default();
        let statement = self.before().rfind("export").map(|start| &self.before()[start..]);
        let subject = || {
            let pieces = syntax::pieces(statement?);
            let (_, name) = pieces.into_iter().find(|(paint, _)| *paint == Highlight::Name)?;
            statement?.get(name)
        };
        let stem = begun.rsplit_once('.').map_or(begun, |(stem, _)| stem);
        let stem = if stem.is_empty() { subject().unwrap_or("model") } else { stem };
        let file = |format: &&Format| {
            Completion::new(format!("{stem}.{}", format.ending), CompletionKind::File, range)
                .detail(format.title)
        };
        FORMATS.iter().map(file).collect()
    }

    /// The words that a parameter allows which the string at `start` is its default, its value, or compared with.
    fn words_of_params(&self, start: usize) -> Vec<String> {
        let quote = start.saturating_sub(1);
        let pieces = &self.document.pieces;
        let idx = pieces.partition_point(|(_, place)| place.start < quote);
        let before = |n: usize| idx.checked_sub(n).map_or("", |idx| self.document.piece(idx));
        let is_comparison = |mark: &str| matches!(mark, "==" | "!=");
        let param = if is_comparison(before(1)) {
            self.param(before(2), (before(3) == ".").then(|| before(4)))
        } else if is_comparison(self.document.piece(idx + 1)) {
            let is_field = self.document.piece(idx + 3) == ".";
            let (name, of) = if is_field { (idx + 4, Some(idx + 2)) } else { (idx + 2, None) };
            self.param(self.document.piece(name), of.map(|of| self.document.piece(of)))
        } else if before(1) == "=" {
            match open_call(&self.document.text, quote) {
                Some(call) => {
                    let mut params = self.params_of_file(&call).into_iter();
                    params.find(|name| Some(name.name.as_str()) == call.label)
                }
                None => self.param(before(2), None),
            }
        } else {
            None
        };
        let Some(allowed) = param.and_then(|param| param.allowed.as_deref()) else {
            return Vec::new();
        };
        let of_allowed = syntax::pieces(allowed);
        let texts = of_allowed.iter().filter(|(paint, _)| *paint == Highlight::Text);
        let words: Vec<String> =
            texts.map(|(_, place)| allowed[place.clone()].trim_matches('"').to_owned()).collect();
        let named = of_allowed.iter().find(|(paint, _)| *paint == Highlight::Name);
        match (named, self.values) {
            (Some((_, place)), Some(values)) if words.is_empty() => {
                match values.value(&allowed[place.clone()]) {
                    Some(Value::List(items)) => items.values().filter_map(word).collect(),
                    _ => Vec::new(),
                }
            }
            _ => words,
        }
    }

    /// The parameter of a name, of this file or, behind the name of an import, of another.
    fn param(&self, name: &str, of: Option<&str>) -> Option<&DefinedName> {
        let own = &self.document.outline;
        let known = own.of_file().find(|known| known.name == of.unwrap_or(name))?;
        if known.role != NameRole::Import {
            return Some(known).filter(|known| of.is_none() && known.role == NameRole::Param);
        }
        let file = self.document.outline_of_import(&known.whole)?;
        file.of_file().find(|param| param.name == name && param.role == NameRole::Param)
    }

    /// The parameters of the file that a call is given values for: an import's `with`, or a script's call.
    pub(super) fn params_of_file(&self, call: &OpenCall<'_>) -> Vec<&DefinedName> {
        let is_script = self
            .registry
            .get(call.name)
            .is_some_and(|(_, ops)| ops.iter().any(|op| op.names_script));
        let path = if call.name == "with" && call.statement == Some("import") {
            self.document.text[..call.start].rfind("import").map(|start| start..call.start)
        } else {
            is_script.then_some(call.start..self.at)
        };
        let file = path.and_then(|path| self.document.outline_of_import(&path));
        let names = file.into_iter().flat_map(Outline::of_file);
        names.filter(|name| name.role == NameRole::Param).collect()
    }

    /// How the number `of` can be written in a text.
    pub(super) fn number_formats(&self, of: &str, start: usize) -> Vec<Completion> {
        let is_part = |c: char| c.is_alphanumeric() || c == '.';
        let rest = &self.document.text[self.at..];
        let range = start..self.at + (rest.len() - rest.trim_start_matches(is_part).len());
        let dimension = match self.owner(of) {
            Some(Owner::Value(Value::Number(number))) => Some(number.dim),
            _ => None,
        };
        let fits = |(_, unit): &&(&str, Unit)| match dimension {
            Some(dimension) if dimension.is_bare() => false,
            Some(dimension) => dimension.is_angle() == unit.millimetres().is_none(),
            None => true,
        };
        let units = Unit::ALL.iter().filter(fits);
        let unit = |&(name, _): &(&str, Unit)| {
            Completion::new(name, CompletionKind::Unit, &range).detail("in this unit")
        };
        let mut found: Vec<Completion> = units.map(unit).collect();
        found.extend((0..=3).map(|digits| {
            Completion::new(format!(".{digits}"), CompletionKind::Choice, &range)
                .detail(format!("{digits} digits behind the point"))
        }));
        found
    }

    /// The endings of the files that the string at `start` may name, any without one; none where it names no file.
    fn endings_of_files(&self, start: usize, call: Option<&str>) -> Option<Vec<&'static str>> {
        match call {
            Some("load") => Some(session::loaded_endings().collect()),
            Some("script") => Some(vec!["geo"]),
            Some(_) => None,
            None => {
                let text = self.document.text.get(..start.saturating_sub(1)).unwrap_or_default();
                match text.trim_end().rsplit(|c: char| !c.is_alphanumeric()).next() {
                    Some("import") => Some(vec!["geo"]),
                    Some("to") => Some(Vec::new()),
                    _ => None,
                }
            }
        }
    }

    /// The parameters of the built-ins of a name.
    fn parameters(&self, call: Option<&str>) -> Vec<&'static OpParameter> {
        let ops = call.and_then(|call| self.registry.get(call));
        ops.map(|(_, ops)| ops.iter().flat_map(|op| op.params).collect()).unwrap_or_default()
    }

    /// The options of the export under way.
    pub(super) fn export_options(&self) -> Vec<&'static ExportOption> {
        let statement = self.before().rfind("export").map(|start| &self.before()[start..]);
        let path = statement.and_then(|text| text.split('"').nth(1));
        let format = path.and_then(Format::of_path);
        format.map(|format| format.options.to_vec()).unwrap_or_default()
    }

    /// Labels of the call around the place that are not given yet.
    pub(super) fn labels(
        &self,
        call: &OpenCall<'_>,
        range: &Range<usize>,
        found: &mut Vec<Completion>,
    ) {
        if call.label.is_some() {
            return;
        }
        let label = |name: &str| Completion {
            insert: format!("{name} = "),
            ..Completion::new(name, CompletionKind::Label, range)
        };
        let mut add = |completion: Completion| {
            if !call.labels.contains(&completion.label.as_str()) {
                found.push(completion);
            }
        };
        if call.name == "with" {
            match call.statement {
                Some("export") => {
                    let options = self.export_options();
                    options.iter().for_each(|option| add(label(option.name).detail(option.wants)));
                }
                Some("import") => {
                    for param in self.params_of_file(call) {
                        add(label(&param.name)
                            .detail(hover::signature(param))
                            .docs(param.docs.clone().unwrap_or_default()));
                    }
                }
                _ => eval::LOOK_OPTIONS
                    .iter()
                    .for_each(|(option, wants)| add(label(option).detail(*wants))),
            }
            return;
        }
        let imported = self.document.imported.iter().flat_map(Outline::of_file);
        let own = self
            .document
            .outline
            .of_file()
            .chain(imported)
            .find(|name| name.name == call.name && name.role == NameRole::Function);
        if let Some(function) = own {
            let given = function.parameters.iter().skip(call.position);
            given
                .for_each(|parameter| add(label(&parameter.0).detail(hover::parameter(parameter))));
            return;
        }
        let ops = self.registry.get(call.name).map(|(_, ops)| &ops[..]).unwrap_or_default();
        for param in ops.iter().flat_map(|op| left_to_give(op, call)) {
            add(label(param.name).detail(param.ty.to_string()).docs(docs::paragraph(param.docs)));
        }
        // What the script that is called takes.
        if 0 < call.position {
            for param in self.params_of_file(call) {
                add(label(&param.name)
                    .detail(hover::signature(param))
                    .docs(param.docs.clone().unwrap_or_default()));
            }
        }
    }
}

/// The text of a value that is one.
fn word(value: Value) -> Option<String> {
    match value {
        Value::Text(text) => Some(text.to_string()),
        _ => None,
    }
}
