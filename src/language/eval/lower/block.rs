//! Lowering of blocks: definitions in the order of their dependencies, functions in groups.

use std::{collections::BTreeMap, sync::Arc};

use super::{
    super::ir::{Block, Expr, ExprKind, Group},
    Lowerer, graph,
    name_walk::NameWalk,
    scope::{Captures, Siblings},
};
use crate::{
    diag::{Code, Diagnostic, Span},
    syntax::ast::{self, Definition, Pattern, StatementKind},
};

/// A definition of a block.
enum BlockItem<'t, 's> {
    Function(&'t ast::Function<'s>),
    Value(&'t Definition<'s>),
}

impl<'s> BlockItem<'_, 's> {
    fn names(&self) -> Vec<ast::Name<'s>> {
        match self {
            Self::Function(function) => vec![function.name],
            Self::Value(definition) => match &definition.pattern {
                Pattern::Anonymous => Vec::new(),
                Pattern::Name(name) => vec![*name],
                Pattern::List(names, _) | Pattern::Record(names, _) => names.clone(),
            },
        }
    }
}

impl<'s> Lowerer<'_, 's> {
    /// Lowers `{ definitions  value }`.
    pub(super) fn block(&mut self, block: &ast::Block<'s>) -> ExprKind {
        let mark = self.scopes.mark();
        let items: Vec<BlockItem<'_, 's>> = block
            .statements
            .iter()
            .filter_map(|statement| match &statement.kind {
                StatementKind::Function(function) => Some(BlockItem::Function(function)),
                StatementKind::Definition(definition) => Some(BlockItem::Value(definition)),
                // The parser has told that only definitions stand in blocks.
                _ => None,
            })
            .collect();
        let owners = self.owners(&items);

        // Put the definitions in order, functions that use one another together.
        let edges: Vec<Vec<usize>> = items.iter().map(|item| uses(item, &owners)).collect();
        let edge_slices: Vec<&[usize]> = edges.iter().map(Vec::as_slice).collect();
        let mut definitions = Vec::new();
        for component in graph::components(&edge_slices) {
            let is_loop = component.len() > 1 || edges[component[0]].contains(&component[0]);
            self.component(&items, component, is_loop, &mut definitions);
        }

        let value = self.expr(&block.value);
        self.scopes.release(mark);
        ExprKind::Block(Box::new(Block { definitions, value }))
    }

    /// Which item defines each name; a name defined twice is reported.
    fn owners(&mut self, items: &[BlockItem<'_, 's>]) -> BTreeMap<&'s str, (usize, Span)> {
        let mut owners: BTreeMap<&'s str, (usize, Span)> = BTreeMap::new();
        for (idx, item) in items.iter().enumerate() {
            for name in item.names() {
                let span = self.at(name.span);
                if let Some(&(_, first)) = owners.get(name.text) {
                    self.report(duplicate(name.text, span, first));
                } else {
                    owners.insert(name.text, (idx, span));
                }
            }
        }
        owners
    }

    /// Lowers definitions that use one another, or a single one.
    fn component(
        &mut self,
        items: &[BlockItem<'_, 's>],
        mut component: Vec<usize>,
        is_loop: bool,
        definitions: &mut Vec<(usize, Expr)>,
    ) {
        component.sort_unstable();
        let functions: Vec<&ast::Function<'s>> = component
            .iter()
            .filter_map(|&idx| match items[idx] {
                BlockItem::Function(function) => Some(function),
                BlockItem::Value(_) => None,
            })
            .collect();
        if functions.len() == component.len() {
            self.functions(&functions, definitions);
            return;
        }
        if is_loop {
            let names: Vec<ast::Name<'s>> =
                component.iter().flat_map(|&idx| items[idx].names()).collect();
            self.circle(&names);
        }
        let n_found = self.diagnostics.len();
        for &idx in &component {
            match items[idx] {
                BlockItem::Function(function) => self.functions(&[function], definitions),
                BlockItem::Value(definition) => self.value(definition, definitions),
            }
        }
        if is_loop {
            // Names of the circle have no meaning here, which was told.
            let found = self.diagnostics.split_off(n_found);
            let is_other = |found: &Diagnostic| found.code != Code::UnknownName;
            self.diagnostics.extend(found.into_iter().filter(is_other));
        }
    }

    fn circle(&mut self, names: &[ast::Name<'s>]) {
        let Some((first, rest)) = names.split_first() else { return };
        let list: Vec<String> =
            names.iter().chain([first]).map(|name| format!("`{}`", name.text)).collect();
        let message = if rest.is_empty() {
            format!("`{}` is defined by itself", first.text)
        } else {
            format!("definitions go round in a circle: {}", list.join(" → "))
        };
        let mut diagnostic = Diagnostic::error(Code::Cycle, self.at(first.span), message);
        for name in rest {
            diagnostic = diagnostic.also(self.at(name.span), "part of the circle");
        }
        diagnostic = diagnostic.hint("only functions (`fn`) may use themselves");
        for name in names {
            if let Some(outer) = self.around(name.text) {
                let text = format!("this `{}` is hidden in the block", name.text);
                let hint = format!(
                    "to use the `{0}` of around the block, give the one inside another name",
                    name.text
                );
                diagnostic = diagnostic.also(outer, text).hint(hint);
            }
        }
        self.report(diagnostic);
    }

    /// Functions that may use one another: one group with common captures.
    fn functions(
        &mut self,
        functions: &[&ast::Function<'s>],
        definitions: &mut Vec<(usize, Expr)>,
    ) {
        let names =
            functions.iter().map(|function| (function.name.text, self.at(function.name.span)));
        let siblings = Arc::new(Siblings::new(names.collect()));
        let mut captures = Captures::default();
        let mut lambdas = Vec::new();
        for function in functions {
            let (lambda, taken) = self.function(function, Arc::clone(&siblings), captures);
            lambdas.push(lambda);
            captures = taken;
        }
        let group = Arc::new(Group { lambdas });
        for (idx, function) in functions.iter().enumerate() {
            let span = self.at(function.name.span);
            let kind = ExprKind::Lambda(Arc::clone(&group), idx, captures.sources());
            definitions.push((self.bind(&function.name), Expr { kind, span }));
        }
    }

    fn value(&mut self, definition: &Definition<'s>, definitions: &mut Vec<(usize, Expr)>) {
        let value = self.promised(definition);
        match &definition.pattern {
            Pattern::Name(name) => definitions.push((self.bind(name), value)),
            pattern => {
                let slot = self.scopes.reserve();
                definitions.push((slot, value));
                let parts =
                    self.take_apart(pattern, |span| Expr { kind: ExprKind::Local(slot), span });
                for (name, part) in parts {
                    definitions.push((self.bind(&name), part));
                }
            }
        }
    }
}

/// A second definition of a name.
pub(super) fn duplicate(name: &str, second: Span, first: Span) -> Diagnostic {
    Diagnostic::error(Code::Duplicate, second, format!("`{name}` is defined twice"))
        .label("defined again here")
        .also(first, "first defined here")
        .hint("every name is defined once; choose another name for one of them")
}

/// The items whose names an item uses: not those that it hides by names of its own.
fn uses<'s>(item: &BlockItem<'_, 's>, owners: &BTreeMap<&'s str, (usize, Span)>) -> Vec<usize> {
    let mut found = Vec::new();
    let mut see = |name: &str| {
        if let Some(&(idx, _)) = owners.get(name) {
            found.push(idx);
        }
    };
    let mut walk = NameWalk::new(&mut see);
    match item {
        BlockItem::Function(function) => walk.function(function),
        BlockItem::Value(definition) => walk.expr(&definition.value),
    }
    found.sort_unstable();
    found.dedup();
    found
}
