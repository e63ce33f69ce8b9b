//! A script looked at rather than run: in canonical form, its parameters, its graph.

use std::sync::Arc;

use super::{Report, Session};
use crate::{
    diag::{Diagnostic, Sources},
    eval::{self, Graph, NameUses, Schema},
    limits::Limits,
    syntax::{self, ast::Tree},
    value::Files,
};

impl Session {
    /// The script `bytes` in canonical form.
    ///
    /// # Errors
    /// What is wrong with the text, if it cannot be parsed.
    pub fn format(&self, name: &str, bytes: &[u8]) -> Result<String, Box<Report>> {
        let (text, mut sources) = self.opened(name, bytes)?;
        self.on_stack(|limits| syntax::format(text, limits)).map_err(|found| {
            sources.add(name, Arc::from(text));
            Box::new(self.findings(sources, found))
        })
    }

    /// The parameters of the script `bytes`, their defaults and ranges evaluated.
    ///
    /// # Errors
    /// What is wrong with the script, as far as it concerns them.
    pub fn parameters(
        &self,
        name: &str,
        bytes: &[u8],
        files: &dyn Files,
    ) -> Result<Schema, Box<Report>> {
        let (text, mut sources) = self.opened(name, bytes)?;
        let mut schema = self.on_stack(|limits| {
            eval::parameters(name, text, &mut sources, self.settings(files, limits))
        });
        let found = std::mem::take(&mut schema.diagnostics);
        self.unless_wrong(schema, sources, found)
    }

    /// Those parameters of the script `bytes` that have a value whatever else is wrong; none of a text that
    /// cannot be read.
    pub fn known_parameters(&self, name: &str, bytes: &[u8], files: &dyn Files) -> Option<Schema> {
        let (text, mut sources) = self.opened(name, bytes).ok()?;
        Some(self.on_stack(|limits| {
            eval::parameters(name, text, &mut sources, self.settings(files, limits))
        }))
    }

    /// The definitions and effects of the script `bytes` with what they use; nothing is evaluated.
    ///
    /// # Errors
    /// What is wrong with the text or its names.
    pub fn graph(&self, name: &str, bytes: &[u8], files: &dyn Files) -> Result<Graph, Box<Report>> {
        let (text, mut sources) = self.opened(name, bytes)?;
        let mut graph = self
            .on_stack(|limits| eval::graph(name, text, &mut sources, self.settings(files, limits)));
        let found = std::mem::take(&mut graph.diagnostics);
        self.unless_wrong(graph, sources, found)
    }

    /// What `look` sees in the tree of a text, which is parsed with the stack that it needs.
    pub fn tree<R: Send>(
        &self,
        text: &str,
        look: impl Fn(&Tree<'_>, Vec<Diagnostic>) -> R + Sync,
    ) -> R {
        self.on_stack(|limits| {
            let (tree, found) = syntax::parse(text, limits);
            look(&tree, found)
        })
    }

    /// What the names of the script `bytes` and of the files that it imports mean, as places in the texts
    /// that come with it; nothing is evaluated.
    ///
    /// ```
    /// use virote_language::{diag::Span, session::Session, value::NoFiles};
    ///
    /// let (names, _) = Session::default().name_uses("demo", b"let a = 1  print a", &NoFiles);
    /// assert_eq!(names.uses, [(Span::new(17, 18), Span::new(4, 5))]);
    /// ```
    #[must_use]
    pub fn name_uses(&self, name: &str, bytes: &[u8], files: &dyn Files) -> (NameUses, Sources) {
        let (text, mut sources) = match self.opened(name, bytes) {
            Ok(opened) => opened,
            Err(report) => {
                let diagnostics = report.diagnostics;
                return (NameUses { diagnostics, ..NameUses::default() }, report.sources);
            }
        };
        let names = self.on_stack(|limits| {
            eval::name_uses(name, text, &mut sources, self.settings(files, limits))
        });
        (names, sources)
    }

    fn opened<'b>(&self, name: &str, bytes: &'b [u8]) -> Result<(&'b str, Sources), Box<Report>> {
        let mut sources = Sources::default();
        match self.read(bytes) {
            Ok(text) => Ok((text, sources)),
            Err((text, found)) => {
                sources.add(name, Arc::from(text));
                Err(Box::new(self.findings(sources, vec![*found])))
            }
        }
    }

    pub(super) fn settings<'a>(
        &'a self,
        files: &'a dyn Files,
        limits: &'a Limits,
    ) -> eval::Settings<'a> {
        eval::Settings {
            registry: &self.registry,
            limits,
            files,
            overrides: &[],
            n_threads: 1,
            purpose: eval::Purpose::Run,
            recall: None,
            known: &[],
            gauge: &self.gauge,
            stop: &self.stop,
        }
    }

    /// `answer`, unless there are errors among the findings.
    fn unless_wrong<T>(
        &self,
        answer: T,
        sources: Sources,
        found: Vec<Diagnostic>,
    ) -> Result<T, Box<Report>> {
        let report = self.findings(sources, found);
        if report.count(crate::diag::Severity::Error) == 0 {
            Ok(answer)
        } else {
            Err(Box::new(report))
        }
    }
}
