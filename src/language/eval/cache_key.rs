//! The key of a definition: everything that its value follows from, spelled as bytes.
//!
//! Spelled are the tree with its names resolved, and in the place of each definition that it uses the
//! identity of that one's result. Left out are places, comments, the definition's own name and its
//! number in the file. Every part begins with what it is and tells its length, so that different
//! trees differ in their bytes; and nothing is hashed, so that equal bytes are equal trees.

use std::{collections::BTreeMap, sync::Arc};

use super::{
    env::ImportedFiles,
    globals::Globals,
    ir::{
        Arg, Block, CallExpr, CaptureSource, Comprehension, Definition, DefinitionRole, Element,
        Expr, ExprKind, Group, Lambda, StringPart,
    },
    param::GivenValue,
};
use crate::value::{Value, exact_key};

/// What a key is of; keys of different sorts never agree.
#[derive(Clone, Copy)]
pub(super) enum KeySort {
    /// What holds for all definitions of a file.
    File,
    /// A definition that does not use itself.
    Definition,
    /// Functions that use one another.
    Component,
    /// One of them.
    Member,
    /// What an import brings.
    Import,
    /// All definitions of a file.
    Script,
}

/// A key under way.
pub(super) struct CacheKey<'a> {
    bytes: Vec<u8>,
    home: &'a Globals,
    /// The files that it imports.
    library: Option<&'a dyn ImportedFiles>,
    /// The component of the definition, with the place of each member in it.
    members: BTreeMap<usize, usize>,
    /// Functions defined together that were spelled already, by their address.
    groups: BTreeMap<*const Group, usize>,
}

impl<'a> CacheKey<'a> {
    /// The start of a key about definitions of `home`; those of `members` may use one another, the
    /// others have their results.
    pub(super) fn new(
        sort: KeySort,
        home: &'a Globals,
        members: &[usize],
        library: Option<&'a dyn ImportedFiles>,
    ) -> Self {
        let members = members.iter().enumerate().map(|(place, &idx)| (idx, place)).collect();
        Self { bytes: vec![sort as u8], home, library, members, groups: BTreeMap::new() }
    }

    /// The key.
    pub(super) fn finish(self) -> Box<[u8]> {
        self.bytes.into_boxed_slice()
    }

    /// A definition; of a parameter also the value that it is given.
    pub(super) fn definition(&mut self, definition: &Definition, given: Option<&GivenValue<'_>>) {
        self.expr(&definition.value);
        let DefinitionRole::Param(rules) = &definition.role else {
            return self.tag(0);
        };
        self.tag(1);
        self.tag(rules.kind.map_or(0, |kind| 1 + kind as u8));
        for part in [&rules.allowed, &rules.step, &rules.label] {
            self.option(part.as_ref());
        }
        match given {
            None => self.tag(0),
            Some(GivenValue::Text(setting)) => {
                self.tag(1);
                self.text(&setting.text);
            }
            Some(GivenValue::Value(_, value)) => {
                self.tag(2);
                self.value(&value.value);
            }
        }
    }

    /// A count or a place.
    pub(super) fn number(&mut self, number: usize) {
        self.result(number as u64);
    }

    /// The identity of a result.
    pub(super) fn result(&mut self, result: u64) {
        self.bytes.extend(result.to_le_bytes());
    }

    /// A text.
    pub(super) fn text(&mut self, text: &str) {
        self.number(text.len());
        self.bytes.extend(text.as_bytes());
    }

    fn tag(&mut self, tag: u8) {
        self.bytes.push(tag);
    }

    fn value(&mut self, value: &Value) {
        exact_key(value, &mut self.bytes);
    }

    fn expr(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Poison => self.tag(0),
            ExprKind::Constant(value) => {
                self.tag(1);
                self.value(value);
            }
            ExprKind::Local(slot) => self.place(2, *slot),
            ExprKind::Captured(idx) => self.place(3, *idx),
            ExprKind::Sibling(idx) => self.place(4, *idx),
            ExprKind::Global(idx) => self.global(*idx),
            ExprKind::Point(parts) => self.all(7, &**parts),
            ExprKind::List(elements) => self.list(elements),
            ExprKind::Record(fields) => {
                self.place(9, fields.len());
                for (label, value) in fields {
                    self.text(label);
                    self.expr(value);
                }
            }
            ExprKind::Text(pieces) => self.pieces(pieces),
            ExprKind::Comprehension(comprehension) => self.comprehension(comprehension),
            ExprKind::Block(block) => self.block(block),
            ExprKind::Unary(op, operand) => {
                self.place(13, *op as usize);
                self.expr(operand);
            }
            ExprKind::Binary(op, sides) => {
                self.place(14, *op as usize);
                self.all(14, &**sides);
            }
            ExprKind::Within(parts) => self.all(15, &**parts),
            ExprKind::Call(call) => self.call(call),
            ExprKind::Index(parts) => self.all(17, &**parts),
            ExprKind::Field(subject, name, _) => self.field(subject, name),
            ExprKind::Lambda(group, idx, sources) => self.lambda(group, *idx, sources),
            ExprKind::If(parts) => self.all(21, &**parts),
            ExprKind::Exactly(list, n) => {
                self.place(22, *n);
                self.expr(list);
            }
            ExprKind::Import(file, with) => {
                self.file(23, *file);
                self.args(with);
            }
            ExprKind::Script(file, with) => {
                match file.found.get() {
                    Some(Ok(file)) => self.file(25, *file),
                    _ => self.tag(0),
                }
                self.args(with);
            }
            ExprKind::Promise(value, kind, _) => {
                self.place(24, *kind as usize);
                self.expr(value);
            }
        }
    }

    /// A part that is told by a number.
    fn place(&mut self, tag: u8, number: usize) {
        self.tag(tag);
        self.number(number);
    }

    /// Another file: all that it defines.
    fn file(&mut self, tag: u8, file: usize) {
        self.tag(tag);
        self.result(self.library.map_or(0, |library| library.identity(file)));
    }

    fn all(&mut self, tag: u8, parts: &[Expr]) {
        self.tag(tag);
        parts.iter().for_each(|part| self.expr(part));
    }

    fn option(&mut self, expr: Option<&Expr>) {
        match expr {
            None => self.tag(0),
            Some(expr) => self.all(1, std::slice::from_ref(expr)),
        }
    }

    /// A definition of the file: its place in the component, or the identity of its result.
    fn global(&mut self, idx: usize) {
        match (self.members.get(&idx), self.home.mark(idx)) {
            (Some(&place), _) => self.place(5, place),
            (None, Some(mark)) => {
                self.tag(6);
                self.result(mark.result);
            }
            (None, None) => unreachable!("what is used has been evaluated"),
        }
    }

    /// A field; of an imported file it is as good as the definition there, whatever else changes.
    fn field(&mut self, subject: &Expr, name: &str) {
        let imported = match subject.kind {
            ExprKind::Global(idx) => self.home.mark(idx).and_then(|mark| mark.field(name)),
            _ => None,
        };
        match imported {
            Some(result) => {
                self.tag(6);
                self.result(result);
            }
            None => {
                self.tag(18);
                self.text(name);
                self.expr(subject);
            }
        }
    }

    fn list(&mut self, elements: &[Element]) {
        self.place(8, elements.len());
        for element in elements {
            match element {
                Element::Item(item) => self.all(0, std::slice::from_ref(item)),
                Element::Spread(spread) => self.all(1, std::slice::from_ref(spread)),
                Element::Grown { slot, .. } => self.place(2, *slot),
            }
        }
    }

    fn pieces(&mut self, pieces: &[StringPart]) {
        self.place(10, pieces.len());
        for piece in pieces {
            match piece {
                StringPart::Text(text) => {
                    self.tag(0);
                    self.text(text);
                }
                StringPart::Expr(expr, format) => {
                    self.all(1, std::slice::from_ref(expr));
                    let Some(format) = format else { continue };
                    self.tag(2);
                    self.number(format.digits.map_or(0, |digits| digits + 1));
                    self.text(format.unit.as_deref().unwrap_or_default());
                }
            }
        }
    }

    fn comprehension(&mut self, comprehension: &Comprehension) {
        self.place(11, comprehension.generators.len());
        for generator in &comprehension.generators {
            self.number(generator.slot);
            self.expr(&generator.source);
            self.slots(&generator.parts);
            self.option(generator.condition.as_ref());
        }
        self.expr(&comprehension.body);
    }

    fn block(&mut self, block: &Block) {
        self.tag(12);
        self.slots(&block.definitions);
        self.expr(&block.value);
    }

    fn slots(&mut self, definitions: &[(usize, Expr)]) {
        self.number(definitions.len());
        for (slot, expr) in definitions {
            self.number(*slot);
            self.expr(expr);
        }
    }

    fn call(&mut self, call: &CallExpr) {
        self.tag(16);
        self.expr(&call.callee);
        self.args(&call.args);
    }

    fn args(&mut self, args: &[Arg]) {
        self.number(args.len());
        for arg in args {
            match &arg.label {
                None => self.tag(0),
                Some((label, _)) => {
                    self.tag(1);
                    self.text(label);
                }
            }
            self.option(arg.value.as_ref());
        }
    }

    /// A function. Those defined together with others are spelled once, however many name them.
    fn lambda(&mut self, group: &Arc<Group>, idx: usize, sources: &[CaptureSource]) {
        self.place(19, idx);
        self.number(sources.len());
        for source in sources {
            match source {
                CaptureSource::Local(slot) => self.place(0, *slot),
                CaptureSource::Captured(idx) => self.place(1, *idx),
                CaptureSource::Sibling(idx) => self.place(2, *idx),
            }
        }
        if let Some(&nth) = self.groups.get(&Arc::as_ptr(group)) {
            return self.place(0, nth);
        }
        if group.lambdas.len() > 1 {
            self.groups.insert(Arc::as_ptr(group), self.groups.len());
        }
        self.place(1, group.lambdas.len());
        group.lambdas.iter().for_each(|lambda| self.function(lambda));
    }

    /// Names of functions and their parameters show: in signatures, and as labels.
    fn function(&mut self, lambda: &Lambda) {
        match &lambda.name {
            None => self.tag(0),
            Some(name) => {
                self.tag(1);
                self.text(name);
            }
        }
        self.number(lambda.parameters.len());
        for parameter in &lambda.parameters {
            self.text(&parameter.name);
            self.option(parameter.default.as_ref());
        }
        self.expr(&lambda.body);
    }
}
