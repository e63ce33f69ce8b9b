//! The graph of a file: what its definitions and effects use. Nothing is evaluated.

use std::collections::BTreeMap;

use super::{
    ir::{
        Definition, DefinitionRole, Dependency, Effect, EffectKind, Expr, ExprKind, Kind, Program,
    },
    load::{LoadingScript, load},
    settings::Settings,
};
use crate::{
    diag::{Diagnostic, Sources},
    kernel::sorting::sort_by_key,
    value::Value,
};

/// A definition or an effect.
#[derive(Clone, Debug)]
pub struct DependencyNode {
    /// Its name, or `KIND@LINE` where it has none; another of the same name and line is `KIND@LINE#2`.
    pub name: String,
    /// `param`, `fn`, `import`, `let` or a kind of geometry; `check`, `print` or `export`.
    pub kind: &'static str,
    /// Its line, from 1.
    pub line: usize,
    /// What an effect says: the claim, the printed expressions, the path.
    pub text: Option<String>,
    /// The nodes that it uses directly, in the order of the source.
    pub uses: Vec<usize>,
}

/// The definitions and effects of a file, in the order of the source.
#[derive(Debug)]
pub struct Graph {
    /// Every one of them.
    pub nodes: Vec<DependencyNode>,
    /// What is wrong with the text or its names.
    pub diagnostics: Vec<Diagnostic>,
}

/// The graph of the script `text`, which messages call `name`.
#[must_use]
pub fn graph(name: &str, text: &str, sources: &mut Sources, settings: Settings<'_>) -> Graph {
    let loaded = load(name, text, sources, settings);
    let (program, document) = (&loaded.program, &loaded.document);
    let mut items: Vec<GraphItem<'_>> = program
        .definitions
        .iter()
        .enumerate()
        .filter(|(_, definition)| {
            !matches!(definition.role, DefinitionRole::Hidden | DefinitionRole::Known(_))
        })
        .map(|(idx, definition)| GraphItem::Definition(idx, definition))
        .chain(program.effects.iter().map(GraphItem::Effect))
        .collect();
    sort_by_key(&mut items, GraphItem::start);
    let places: BTreeMap<usize, usize> = items
        .iter()
        .enumerate()
        .filter_map(|(place, item)| match item {
            GraphItem::Definition(idx, _) => Some((*idx, place)),
            GraphItem::Effect(_) => None,
        })
        .collect();
    let mut nodes: Vec<DependencyNode> = Vec::with_capacity(items.len());
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    for item in &items {
        let mut node = item.node(document);
        let mut uses: Vec<usize> = item
            .dependencies(program)
            .iter()
            .flat_map(|&idx| shown(idx, program))
            .filter_map(|idx| places.get(&idx).copied())
            .collect();
        uses.sort_unstable();
        uses.dedup();
        node.uses = uses;
        let n_same = seen.entry(node.name.clone()).or_default();
        *n_same += 1;
        if *n_same > 1 {
            node.name = format!("{}#{n_same}", node.name);
        }
        nodes.push(node);
    }
    let mut diagnostics = loaded.diagnostics;
    diagnostics.extend(loaded.library.take_findings());
    super::in_order(&mut diagnostics);
    Graph { nodes, diagnostics }
}

/// What becomes a node.
enum GraphItem<'p> {
    Definition(usize, &'p Definition),
    Effect(&'p Effect),
}

impl GraphItem<'_> {
    fn start(&self) -> u32 {
        match self {
            Self::Definition(_, definition) => definition.name_span.start,
            Self::Effect(effect) => effect.span.start,
        }
    }

    /// The node, but for what it uses.
    fn node(&self, document: &LoadingScript<'_>) -> DependencyNode {
        let (kind, name, span, text) = match self {
            Self::Definition(_, definition) => {
                (kind(definition), &*definition.name, definition.name_span, None)
            }
            Self::Effect(effect) => {
                let (kind, text) = match &effect.kind {
                    EffectKind::Check { claim, .. } => ("check", document.excerpt(claim.span)),
                    EffectKind::Print(exprs) => {
                        let texts = exprs.iter().map(|printed| document.excerpt(printed.expr.span));
                        ("print", texts.collect::<Vec<_>>().join(", "))
                    }
                    EffectKind::Export { path, .. } => ("export", path_text(path, document)),
                    EffectKind::Expect { subject, .. } => {
                        ("expect", document.excerpt(subject.span))
                    }
                };
                (kind, "", effect.span, Some(text))
            }
        };
        let line = document.line(span);
        let name = if name.is_empty() { format!("{kind}@{line}") } else { name.to_owned() };
        DependencyNode { name, kind, line, text, uses: Vec::new() }
    }

    fn dependencies(&self, program: &Program) -> Vec<usize> {
        match self {
            Self::Definition(_, definition) => used(&definition.dependencies),
            Self::Effect(effect) => {
                let mut dependencies = used(&effect.dependencies);
                if let EffectKind::Export { subjects, .. } = &effect.kind
                    && subjects.is_of_whole_file()
                {
                    let is_taken = |&idx: &usize| is_exported_by_all(&program.definitions[idx]);
                    dependencies.extend((0..program.definitions.len()).filter(is_taken));
                }
                dependencies
            }
        }
    }
}

/// The path of an export, without its quotes where it is plain.
fn path_text(path: &Expr, document: &LoadingScript<'_>) -> String {
    match &path.kind {
        ExprKind::Constant(Value::Text(text)) => text.to_string(),
        _ => document.excerpt(path.span),
    }
}

fn kind(definition: &Definition) -> &'static str {
    match &definition.role {
        DefinitionRole::Param(_) => "param",
        DefinitionRole::Function => "fn",
        DefinitionRole::Import => "import",
        DefinitionRole::Value(kind) => kind.word(),
        DefinitionRole::Hidden | DefinitionRole::Known(_) => "",
    }
}

/// Whether `export all` takes a definition, as far as that can be told without evaluation.
fn is_exported_by_all(definition: &Definition) -> bool {
    let is_hidden = definition.with.iter().any(|option| {
        let is_true = option
            .value
            .as_ref()
            .is_some_and(|value| matches!(value.kind, ExprKind::Constant(Value::Bool(true))));
        is_true && option.label.as_ref().is_some_and(|(label, _)| &**label == "hidden")
    });
    match definition.role {
        DefinitionRole::Value(Kind::Let | Kind::Table | Kind::Tables) => false,
        DefinitionRole::Value(_) => !is_hidden,
        _ => false,
    }
}

/// The definitions that are used.
fn used(dependencies: &[Dependency]) -> Vec<usize> {
    dependencies.iter().map(|used| used.definition).collect()
}

/// A definition, or what stands behind one that is not shown: the right side of a pattern.
fn shown(idx: usize, program: &Program) -> Vec<usize> {
    match &program.definitions[idx] {
        Definition { role: DefinitionRole::Hidden, dependencies, .. } => used(dependencies),
        _ => vec![idx],
    }
}
