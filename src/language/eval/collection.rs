//! Evaluation of what holds other values: points, lists, records, texts, comprehensions.

use std::sync::Arc;

use glam::DVec3;

use super::{
    ir::{Comprehension, Element, Expr, Generator, StringPart, TextFormat},
    items::Items,
    lanes::{BlockResult, Lanes},
    machine::Machine,
};
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    limits::Ceiling,
    syntax::ast::Unit,
    value::{
        Dimension, IntoValue, List, Number, NumberFormat, Real, Record, Value, Vector, varies,
    },
};

/// Fails: this cannot be a coordinate.
fn not_a_coordinate(value: &Value, unit: Unit, span: Span) -> Result<Value> {
    match value.looked_at() {
        Value::Number(number) => {
            let message = format!("a coordinate must be a length, found {}", number.dim);
            let suffix = number.dim.suffix(unit.name()).unwrap_or_else(|| "rad".to_owned());
            Diagnostic::error(Code::UnitMismatch, span, message).hint(format!(
                "divide by `1{suffix}`: a number without a unit counts in the document's unit"
            ))
        }
        other => {
            let message = format!("a coordinate must be a number, found {}", other.phrase());
            Diagnostic::error(Code::WrongKind, span, message)
                .hint("points and groups take round brackets, lists take square ones")
        }
    }
    .fail()
}

impl Machine<'_> {
    #[inline(never)]
    pub(super) fn point(&mut self, coordinates: &[Expr; 3]) -> Result<Value> {
        let mut point = DVec3::ZERO;
        let mut jets: [Option<Real>; 3] = [None, None, None];
        for (i, expr) in coordinates.iter().enumerate() {
            point[i] = match self.eval(expr)? {
                Value::Number(number) if number.dim.is_as_length() => number.value,
                Value::Jet(number) if number.dim.is_as_length() => {
                    jets[i] = Some(number.value.clone());
                    number.value.value()
                }
                other => return not_a_coordinate(&other, self.env.unit, expr.span),
            };
        }
        if jets.iter().all(Option::is_none) {
            return Ok(Value::Point(point));
        }
        let [x, y, z] = jets;
        let real = |jet: Option<Real>, plain: f64| jet.unwrap_or(Real::Plain(plain));
        let coordinates = [real(x, point.x), real(y, point.y), real(z, point.z)];
        Ok(Vector::new(coordinates).into_value())
    }

    /// Fails when a list grows beyond its ceiling.
    pub(super) fn check_length(&self, n: usize, span: Span) -> Result<()> {
        let most = self.env.limits.list_length;
        if n <= most {
            return Ok(());
        }
        let message = format!("a list of more than {most} elements");
        Diagnostic::error(Code::TooLarge, span, message).crossing(Ceiling::LIST_LENGTH).fail()
    }

    #[inline(never)]
    pub(super) fn list(&mut self, elements: &[Element], span: Span) -> Result<Value> {
        if let Some((&Element::Grown { slot, span: place }, more)) = elements.split_first() {
            return self.grown((slot, place), more, span);
        }
        Ok(Value::list(self.elements(elements, 0, span)?))
    }

    /// The values of elements behind so many others.
    fn elements(&mut self, elements: &[Element], before: usize, span: Span) -> Result<Vec<Value>> {
        let mut items = Vec::with_capacity(elements.len());
        for element in elements {
            let (value, place) = match element {
                Element::Item(expr) => {
                    items.push(self.eval(expr)?);
                    continue;
                }
                Element::Spread(expr) => (self.eval(expr)?, expr.span),
                Element::Grown { slot, span } => (self.local(*slot), *span),
            };
            let n_items = self.iterate(&value, place)?.len();
            self.check_length(before + items.len() + n_items, span)?;
            self.check_memory(span)?;
            self.passes(n_items as u64, span)?;
            items.extend(self.iterate(&value, place)?);
        }
        Ok(items)
    }

    /// A list that begins with the elements of a value of the frame, which nobody asks for afterwards: in the memory
    /// of that, if nobody else has it.
    fn grown(
        &mut self,
        (slot, place): (usize, Span),
        more: &[Element],
        span: Span,
    ) -> Result<Value> {
        let n_items = self.iterate(&self.stack[self.base + slot], place)?.len();
        self.check_length(n_items, span)?;
        self.check_memory(span)?;
        let more = self.elements(more, n_items, span)?;
        let mut value = self.take_local(slot);
        let more = match &mut value {
            Value::List(list) => match list.append(more) {
                Ok(()) => return Ok(value),
                Err(more) => more,
            },
            _ => more,
        };
        self.passes(n_items as u64, span)?;
        let mut items = Vec::with_capacity(n_items + more.len());
        items.extend(self.iterate(&value, place)?);
        items.extend(more);
        Ok(Value::List(List::growing(items)))
    }

    /// What a list, a table by its rows, or a range of whole numbers runs through.
    pub(super) fn iterate<'v>(&self, value: &'v Value, span: Span) -> Result<Items<'v>> {
        match value {
            Value::List(items) => Ok(Items::of(items, 0..items.len())),
            Value::Table(table) => Ok(Items::Rows(table, 0..table.n_rows())),
            Value::Range(range) => match range.integers() {
                Some((start, count)) => {
                    self.check_length(count, span)?;
                    Ok(Items::Integers(start, count))
                }
                None => {
                    let message =
                        format!("only a range of whole numbers can be run through, found {range}");
                    Diagnostic::error(Code::WrongKind, span, message)
                        .hint("`linspace(a, b, n)` makes n numbers from a to b")
                        .fail()
                }
            },
            other => {
                let message = format!(
                    "a list, a table or a range of whole numbers is needed here, found {}",
                    other.phrase()
                );
                Diagnostic::error(Code::WrongKind, span, message).fail()
            }
        }
    }

    #[inline(never)]
    pub(super) fn record(&mut self, fields: &[(Arc<str>, Expr)]) -> Result<Value> {
        let mut values = Vec::with_capacity(fields.len());
        for (label, expr) in fields {
            values.push((Arc::clone(label), self.eval(expr)?));
        }
        Ok(Value::Record(Arc::new(Record::new(values))))
    }

    /// Fails when a text grows beyond its ceiling.
    fn check_text(&self, n_bytes: usize, span: Span) -> Result<()> {
        let most = self.env.limits.text_bytes;
        if n_bytes <= most {
            return Ok(());
        }
        let message = format!("a text of more than {most} bytes");
        Diagnostic::error(Code::TooLarge, span, message).crossing(Ceiling::TEXT_BYTES).fail()
    }

    fn formatted(&self, value: &Value, format: &TextFormat, span: Span) -> Result<String> {
        NumberFormat::new(format.digits, format.unit.as_deref(), self.env.unit.name())
            .map_err(|refusal| refusal.at(format.span))?
            .text(value)
            .map_err(|refusal| refusal.at(span))
    }

    #[inline(never)]
    pub(super) fn text(&mut self, pieces: &[StringPart], span: Span) -> Result<Value> {
        let mut out = String::new();
        for piece in pieces {
            match piece {
                StringPart::Text(text) => out.push_str(text),
                StringPart::Expr(expr, format) => {
                    let value = self.eval(expr)?;
                    self.has_varying_texts |= varies(&value);
                    match (value, format) {
                        (value, Some(format)) => {
                            out.push_str(&self.formatted(&value, format, expr.span)?);
                        }
                        (Value::Text(text), None) => out.push_str(&text),
                        (other, None) => {
                            out.push_str(&other.in_unit(self.env.unit.name()).to_string());
                        }
                    }
                }
            }
            self.check_text(out.len(), span)?;
        }
        let text = Value::text(&out);
        self.passes(text.extent().size, span)?;
        Ok(text)
    }

    #[inline(never)]
    pub(super) fn comprehension(
        &mut self,
        comprehension: &Comprehension,
        span: Span,
    ) -> Result<Value> {
        let mut collected = GrowingList::default();
        self.generate(comprehension, 0, &mut collected, span)?;
        Ok(Value::List(collected.into_list()))
    }

    fn generate(
        &mut self,
        comprehension: &Comprehension,
        level: usize,
        collected: &mut GrowingList,
        span: Span,
    ) -> Result<()> {
        let Some(generator) = comprehension.generators.get(level) else {
            self.check_length(collected.len() + 1, span)?;
            let item = self.eval(&comprehension.body)?;
            collected.push(item);
            return Ok(());
        };
        let source = self.eval(&generator.source)?;
        let items = self.iterate(&source, generator.source.span)?;
        if level + 1 == comprehension.generators.len()
            && let Some(lanes) = Lanes::of(self, comprehension, generator, &source)
        {
            return self.run_lanes(&lanes, comprehension, collected, span);
        }
        for item in items {
            self.element(comprehension, level, item, collected, span)?;
        }
        Ok(())
    }

    /// What one element of a generator leads to.
    fn element(
        &mut self,
        comprehension: &Comprehension,
        level: usize,
        item: Value,
        collected: &mut GrowingList,
        span: Span,
    ) -> Result<()> {
        if self.bind(&comprehension.generators[level], item, span)? {
            self.generate(comprehension, level + 1, collected, span)?;
        }
        Ok(())
    }

    /// Gives an element to the names of a generator; whether it counts.
    pub(super) fn bind(&mut self, generator: &Generator, item: Value, span: Span) -> Result<bool> {
        self.step(span)?;
        let base = self.base;
        self.stack[base + generator.slot] = item;
        for (slot, part) in &generator.parts {
            let value = self.eval(part)?;
            self.stack[base + slot] = value;
        }
        match &generator.condition {
            Some(condition) => self.truth(condition, "the condition of a comprehension"),
            None => Ok(true),
        }
    }

    /// The last generator block by block; where lanes cannot tell, element by element.
    fn run_lanes(
        &mut self,
        lanes: &Lanes,
        comprehension: &Comprehension,
        collected: &mut GrowingList,
        span: Span,
    ) -> Result<()> {
        let level = comprehension.generators.len() - 1;
        for block in lanes.blocks() {
            match lanes.run(&block) {
                Some((made, steps)) if self.has_steps(steps) => {
                    self.steps(steps, span)?;
                    self.check_length(collected.len() + made.len(), span)?;
                    collected.extend(made);
                }
                _ => {
                    for item in lanes.elements(block) {
                        self.element(comprehension, level, item, collected, span)?;
                    }
                }
            }
        }
        Ok(())
    }
}

/// The elements of a list that grows; numbers of one dimension as long as there is nothing else.
#[derive(Debug)]
enum GrowingList {
    Numbers(Vec<f64>, Dimension),
    Values(Vec<Value>),
}

impl Default for GrowingList {
    fn default() -> Self {
        Self::Numbers(Vec::new(), Dimension::NONE)
    }
}

impl GrowingList {
    fn len(&self) -> usize {
        match self {
            Self::Numbers(values, _) => values.len(),
            Self::Values(values) => values.len(),
        }
    }

    fn push(&mut self, value: Value) {
        match (&mut *self, value) {
            (Self::Numbers(values, dim), Value::Number(number))
                if values.is_empty() || number.dim == *dim =>
            {
                *dim = number.dim;
                values.push(number.value);
            }
            (_, value) => self.values().push(value),
        }
    }

    fn extend(&mut self, made: BlockResult) {
        match (&mut *self, made) {
            (Self::Numbers(values, dim), BlockResult::Numbers(more, more_dim))
                if values.is_empty() || *dim == more_dim =>
            {
                *dim = more_dim;
                values.extend(more);
            }
            (_, made) => self.values().extend(made.into_values()),
        }
    }

    /// The elements as values from here on.
    fn values(&mut self) -> &mut Vec<Value> {
        if let Self::Numbers(numbers, dim) = self {
            let dim = *dim;
            let value = |&value: &f64| Value::Number(Number { value, dim });
            *self = Self::Values(numbers.iter().map(value).collect());
        }
        match self {
            Self::Values(values) => values,
            Self::Numbers(..) => unreachable!("they were turned into values above"),
        }
    }

    fn into_list(self) -> List {
        match self {
            Self::Numbers(values, dim) => List::of_numbers(values, dim),
            Self::Values(values) => List::from(values),
        }
    }
}
