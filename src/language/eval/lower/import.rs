//! Lowering of imports: a record under a name, or some of its fields under theirs.

use std::sync::Arc;

use super::{
    super::ir::{Definition, DefinitionRole, Expr, ExprKind},
    Imported, Lowerer,
};
use crate::{
    diag::{Code, Diagnostic, Fix, Span, nearest},
    syntax::{
        KEYWORDS,
        ast::{self, Import},
    },
};

impl<'s> Lowerer<'_, 's> {
    /// The names that an import defines; the whole comes first where they are listed.
    pub(super) fn import_names(&mut self, import: &Import<'s>) -> Vec<ast::Name<'s>> {
        match (&import.names, import.alias) {
            (Some(names), _) => names.clone(),
            (None, Some(alias)) => vec![alias],
            (None, None) => self.stem(import).into_iter().collect(),
        }
    }

    /// The name of an import without one: the file's, without folder and ending.
    fn stem(&mut self, import: &Import<'s>) -> Option<ast::Name<'s>> {
        let span = import.path.span;
        let start = span.start as usize + 1;
        let quoted = self.origin.text.get(start..(span.end as usize).saturating_sub(1))?;
        let file_at = quoted.rfind('/').map_or(0, |slash| slash + 1);
        let stem = quoted[file_at..].split('.').next().unwrap_or_default();
        let mut chars = stem.chars();
        let is_name = chars.next().is_some_and(|c| c.is_alphabetic() || c == '_')
            && chars.all(|c| c.is_alphanumeric() || c == '_')
            && !KEYWORDS.contains(&stem);
        if !is_name {
            let message = format!("`{stem}` cannot be the name of an import");
            let place = self.at(span);
            self.report(
                Diagnostic::error(Code::Syntax, place, message)
                    .hint(format!("name it: `import \"{quoted}\" as NAME`"))
                    .fix(Fix::insert(
                        Span::new(place.end, place.end),
                        format!(" as {}", name_of(stem)),
                    )),
            );
            return None;
        }
        let start = (start + file_at) as u32;
        Some(ast::Name { text: stem, span: Span::new(start, start + stem.len() as u32) })
    }

    /// What an import stands for; it is missing where its file could not be had, which was told.
    pub(super) fn imported(&self, import: &Import<'s>) -> Option<&'s Imported> {
        let imports = self.origin.imports;
        let at = imports.binary_search_by_key(&import.path.span.start, |(start, _)| *start).ok()?;
        imports[at].1.as_ref()
    }

    /// Lowers an import.
    pub(super) fn import(&mut self, import: &Import<'s>, definitions: &mut Vec<Definition>) {
        let imported = self.imported(import);
        let span = self.at(import.path.span);
        if !matches!(import.path.kind, ast::ExprKind::Text(_)) {
            self.report(
                Diagnostic::error(
                    Code::NotConstant,
                    span,
                    "the path of an import is a plain string",
                )
                .hint("files are read before anything is evaluated"),
            );
        }
        let with = self.args(&import.with);
        self.check_given(&with);
        if let Some(imported) = imported {
            self.note_import(import, imported);
        }
        let whole = match imported {
            Some(imported) => Expr { kind: ExprKind::Import(imported.file, with), span },
            None => self.poison(span),
        };
        let names = self.import_names(import);
        let Some(listed) = &import.names else {
            let (name, place) = match names.first() {
                Some(name) => (name.text, self.at(name.span)),
                None => ("", span),
            };
            if let Some(imported) = imported {
                self.noted.parts.extend(imported.parts_of(place));
            }
            definitions.push(self.finish(name, place, DefinitionRole::Import, whole));
            return;
        };
        let whole_idx = self.first + definitions.len();
        definitions.push(self.finish("the import", span, DefinitionRole::Hidden, whole));
        for name in listed {
            let place = self.at(name.span);
            if let Some(imported) = imported {
                self.check_listed(name, imported);
            }
            let text: Arc<str> = name.text.into();
            self.uses.add(whole_idx);
            self.uses.narrow(whole_idx, &text);
            let record = Expr { kind: ExprKind::Global(whole_idx), span: place };
            let field = ExprKind::Field(Box::new(record), text, place);
            let field = Expr { kind: field, span: place };
            definitions.push(self.finish(name.text, place, DefinitionRole::Import, field));
        }
    }

    /// Notes what the names of an import mean in its file.
    fn note_import(&mut self, import: &Import<'s>, imported: &Imported) {
        let defined = |name: &str| {
            imported.names.iter().find(|(known, _)| **known == *name).map(|&(_, place)| place)
        };
        let labels = import.with.iter().filter_map(|arg| arg.name.as_ref());
        for name in import.names.iter().flatten().chain(labels) {
            if let Some(place) = defined(name.text) {
                self.noted.uses.push((self.at(name.span), place));
            }
        }
        self.noted.imports.push((self.at(import.path.span), imported.path.clone()));
    }

    /// Whether a file shows a name that an import lists.
    fn check_listed(&mut self, name: &ast::Name<'s>, imported: &Imported) {
        let place = self.at(name.span);
        if name.text.starts_with('_')
            && imported.names.iter().any(|(known, _)| **known == *name.text)
        {
            let message = format!("`{}` is private to `{}`", name.text, imported.path);
            self.report(
                Diagnostic::error(Code::Private, place, message)
                    .hint("names that begin with `_` are not shown to other files"),
            );
            return;
        }
        let shown =
            imported.names.iter().map(|(name, _)| &**name).filter(|name| !name.starts_with('_'));
        if shown.clone().any(|known| known == name.text) {
            return;
        }
        let message = format!("`{}` defines no `{}`", imported.path, name.text);
        let diagnostic = Diagnostic::error(Code::UnknownName, place, message);
        self.report(match nearest(name.text, shown.clone()) {
            Some(near) => diagnostic.meant(near),
            None => match listed(shown) {
                Some(names) => diagnostic.hint(format!("it defines {names}")),
                None => diagnostic.hint("it defines nothing that other files see"),
            },
        });
    }
}

/// Names in quotes, the first few of them; none where there are none.
fn listed<'n>(names: impl Iterator<Item = &'n str>) -> Option<String> {
    /// Names that a message lists.
    const MOST_LISTED: usize = 12;
    let mut names = names.map(|name| format!("`{name}`"));
    let told: Vec<String> = names.by_ref().take(MOST_LISTED).collect();
    let rest = if names.next().is_some() { ", ..." } else { "" };
    (!told.is_empty()).then(|| format!("{}{rest}", told.join(", ")))
}

/// A name like the stem of a file.
fn name_of(stem: &str) -> String {
    let name: String = stem.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
    let is_name =
        name.starts_with(|c: char| c.is_alphabetic()) && !KEYWORDS.contains(&name.as_str());
    if is_name { name } else { format!("_{name}") }
}
