//! Completion of what is chosen from: labels of arguments, words and colours in strings, files, units.

use std::ops::Range;

use super::{
    Completion, CompletionKind, FolderEntry, NameRole, Outline, completion::CompletionSpot, hover,
    signature::left_to_give,
};
use crate::{
    diag::Code,
    docs, eval,
    export::{ExportOption, Format},
    session,
    syntax::{OpenCall, ast::Unit, open_call},
    value::{COLOR_NAMES, OpParameter},
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
        list(folder).into_iter().map(entry).collect()
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
                    let params = self.document.imported.iter().flat_map(Outline::of_file);
                    let params = params.filter(|name| name.role == NameRole::Param);
                    params.for_each(|name| {
                        add(label(&name.name).docs(name.docs.clone().unwrap_or_default()));
                    });
                }
                _ => eval::LOOK_OPTIONS.iter().for_each(|option| add(label(option))),
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
        if ops.iter().any(|op| op.names_script) && 0 < call.position {
            let params = self.document.imported.iter().flat_map(Outline::of_file);
            params.filter(|name| name.role == NameRole::Param).for_each(|name| {
                add(label(&name.name).docs(name.docs.clone().unwrap_or_default()));
            });
        }
    }
}
