//! Claims: what a failed `check` reports: both sides, the limit, the margin.

mod behind;
mod digits;
mod list_test;
mod places;

use glam::DVec3;

use super::{
    ir::{BinaryOp, Expr, ExprKind, Program},
    machine::Machine,
    operator::{
        self,
        table::{BinaryMeaning, binary_meaning},
    },
};
use crate::{
    diag::{Result, Span, fault},
    syntax::ast::Unit,
    value::{Discrepancy, Value, deviation, radians_of, shortest},
};
use digits::{MORE_DIGITS, SIDE_DIGITS, brief, number, told_apart};
use places::ClaimPlaces;

/// How a claim came out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Verdict {
    /// Whether it holds.
    pub holds: bool,
    /// The left and the right side of a comparison; under `~=` their parts that differ most.
    pub sides: Vec<ClaimSide>,
    /// How far the sides are apart.
    pub apart: Option<f64>,
    /// How far they may be apart.
    pub limit: Option<f64>,
    /// What keeps them from being compared by distance.
    pub differ: Option<String>,
    /// Whether `==` fails where `~=` would hold.
    pub differs_by_rounding: bool,
    /// What decided the test of a list, or what both sides are that should not be the same.
    pub witness: Option<String>,
    /// Of a claim that fails: the points that its sides are, or from whose fields they come, such as `at`
    /// of a deviation, each once.
    pub places: Vec<DVec3>,
}

/// A side of a comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct ClaimSide {
    /// Where it stands.
    pub span: Span,
    /// The part of it that is shown, such as `[3].x`; empty for all of it.
    pub path: String,
    /// Its value.
    pub value: String,
}

impl Verdict {
    /// The figures on one line, with the unit that the sides are told in: how far apart, how far allowed, the
    /// margin.
    #[must_use]
    pub fn figures(&self) -> String {
        match &self.witness {
            Some(witness) if !self.holds => witness.clone(),
            _ => self.distances(),
        }
    }

    /// How far a claim is from failing, negative where it fails, in the unit of [`Self::unit`]; angles are in
    /// radians.
    #[must_use]
    pub fn margin(&self) -> Option<f64> {
        match (self.apart, self.limit) {
            (Some(apart), Some(limit)) => Some(limit - apart),
            (Some(apart), None) if self.holds => Some(apart),
            (Some(apart), None) => Some(-apart),
            (None, _) => None,
        }
    }

    /// The unit that the sides are told in, `deg` of angles; empty where they have none, or one of several parts
    /// with angles.
    #[must_use]
    pub fn unit(&self) -> &str {
        let sides = self.sides.iter().filter_map(|side| number(&side.value));
        match sides.map(|(_, unit)| unit).find(|unit| !unit.is_empty()) {
            Some(unit) if unit == DEGREES || !unit.contains(DEGREES) => unit,
            _ => "",
        }
    }

    /// How far the sides are apart, with their unit.
    fn distances(&self) -> String {
        match self.unit() {
            // Angles are compared in radians and told in degrees.
            DEGREES => self.figures_in(1.0 / radians_of(1.0), DEGREES),
            unit => self.figures_in(1.0, unit),
        }
    }

    /// The figures, each times `factor`, in this unit.
    fn figures_in(&self, factor: f64, unit: &str) -> String {
        let of = |a: f64, b: f64| format!("{}{unit}", brief([factor * a, factor * b])[0]);
        let exactly = |limit: f64| format!("{}{unit}", shortest(factor * limit));
        match (self.apart, self.limit, &self.differ) {
            (_, _, Some(what)) => format!("they differ: {what}"),
            (Some(apart), Some(limit), None) if self.holds => {
                format!("apart by {}, within {}", of(apart, limit), exactly(limit))
            }
            (Some(apart), Some(limit), None) => format!(
                "apart by {}, limit {}, misses by {}",
                of(apart, limit),
                exactly(limit),
                of(apart - limit, 0.0)
            ),
            (Some(apart), None, None) if self.holds => {
                format!("holds with margin {}", of(apart, 0.0))
            }
            (Some(apart), None, None) => format!("misses by {}", of(apart, 0.0)),
            (None, ..) if self.holds => "this holds".to_owned(),
            (None, ..) => "this is false".to_owned(),
        }
    }
}

impl Verdict {
    /// The sides as the report of a failure shows them: two numbers in no more digits than tell them apart.
    pub(crate) fn brief_sides(&self) -> Vec<ClaimSide> {
        let mut sides = self.sides.clone();
        if let [a, b] = &mut sides[..]
            && let (Some((x, x_unit)), Some((y, y_unit))) = (number(&a.value), number(&b.value))
        {
            let [x, y] = told_apart([x, y], SIDE_DIGITS, MORE_DIGITS);
            [a.value, b.value] = [x + x_unit, y + y_unit];
        }
        sides
    }
}

/// The unit that angles are told in.
const DEGREES: &str = "deg";

/// Characters of a value that a report shows.
const MOST_SHOWN: usize = 120;

/// A value as one line of a report.
pub(super) fn shown(value: &Value, unit: Unit) -> String {
    let text = value.in_unit(unit.name()).to_string();
    match text.char_indices().nth(MOST_SHOWN) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

impl Machine<'_> {
    /// Judges a claim of a program in a fresh frame.
    pub(crate) fn judge(
        &mut self,
        claim: &Expr,
        n_slots: usize,
        program: &Program,
    ) -> Result<Verdict> {
        self.prepare(n_slots);
        fault::caught(claim.span, || {
            let verdict = self.verdict(claim)?;
            Ok(self.with_witness(verdict, claim, (program, n_slots)))
        })
    }

    fn verdict(&mut self, claim: &Expr) -> Result<Verdict> {
        match &claim.kind {
            ExprKind::Binary(BinaryOp::And, sides) => {
                let first = self.verdict(&sides[0])?;
                if first.holds { self.verdict(&sides[1]) } else { Ok(first) }
            }
            ExprKind::Binary(BinaryOp::Or, sides) => {
                let first = self.verdict(&sides[0])?;
                if first.holds {
                    return Ok(first);
                }
                let second = self.verdict(&sides[1])?;
                Ok(if second.holds { second } else { neither(first, second) })
            }
            ExprKind::Binary(op, sides) if is_comparison(*op) => self.comparison(*op, sides, claim),
            ExprKind::Within(parts) => {
                let mut places = ClaimPlaces::default();
                let (a, b) =
                    (self.side(&parts[0], &mut places)?, self.side(&parts[1], &mut places)?);
                let tolerance = self.tolerance_of(&parts[2], [&a, &b])?;
                let spans = [parts[0].span, parts[1].span];
                let holds = operator::near(&a, &b, tolerance, spans[0].to(spans[1]))?;
                Ok(near_verdict(holds, [&a, &b], spans, tolerance, self.env.unit, places))
            }
            ExprKind::Block(block) => {
                self.define(block)?;
                self.verdict(&block.value)
            }
            _ => {
                self.witness = None;
                let value = self.eval(claim)?;
                self.plain_verdict(&value, claim)
            }
        }
    }

    fn comparison(&mut self, op: BinaryOp, sides: &[Expr; 2], claim: &Expr) -> Result<Verdict> {
        let mut named = ClaimPlaces::default();
        let (a, b) = (self.side(&sides[0], &mut named)?, self.side(&sides[1], &mut named)?);
        let places = operator::OperandPlaces {
            whole: claim.span,
            left: sides[0].span,
            right: sides[1].span,
        };
        let holds =
            matches!(operator::binary(op, &a, &b, places, self.env.tolerance)?, Value::Bool(true));
        let spans = [sides[0].span, sides[1].span];
        if op == BinaryOp::Near {
            return Ok(near_verdict(
                holds,
                [&a, &b],
                spans,
                self.env.tolerance.distance,
                self.env.unit,
                named,
            ));
        }
        let apart = match (&a, &b) {
            (Value::Number(x), Value::Number(y)) => Some((x.value - y.value).abs()),
            _ => None,
        };
        if op == BinaryOp::Equal && !holds && is_collection(&a) && is_collection(&b) {
            let verdict = near_verdict(holds, [&a, &b], spans, 0.0, self.env.unit, named);
            return Ok(Verdict { limit: None, ..verdict });
        }
        let sides = [(&a, spans[0]), (&b, spans[1])].map(|(value, span)| ClaimSide {
            span,
            path: String::new(),
            value: shown(value, self.env.unit),
        });
        named.note(&a);
        named.note(&b);
        let places = named.of_failure(holds);
        let differs_by_rounding = op == BinaryOp::Equal
            && !holds
            && apart.is_some_and(|apart| apart <= self.env.tolerance.distance);
        let is_same = op == BinaryOp::NotEqual && !holds;
        let witness = is_same.then(|| format!("both are {}", sides[0].value));
        let sides = sides.to_vec();
        Ok(Verdict {
            holds,
            sides,
            apart,
            differs_by_rounding,
            witness,
            places,
            ..Verdict::default()
        })
    }

    /// A side of a comparison; the points that it takes a field from, or that stand beside that field,
    /// are noted.
    fn side(&mut self, expr: &Expr, places: &mut ClaimPlaces) -> Result<Value> {
        let mut fields = Vec::new();
        let mut subject = expr;
        while let ExprKind::Field(inner, name, place) = &subject.kind {
            fields.push((inner.span, name, *place, subject.span));
            subject = inner;
        }
        let mut value = self.eval(subject)?;
        for (span, name, place, whole) in fields.into_iter().rev() {
            places.note(&value);
            value = self.field_of(&value, span, name, place)?;
            value = self.check_extent(value, whole)?;
        }
        Ok(value)
    }
}

/// Two claims of which one would do, and both fail.
fn neither(first: Verdict, second: Verdict) -> Verdict {
    let sides = [first.sides, second.sides].concat();
    let places = [first.places, second.places].concat();
    Verdict { sides, places, ..Verdict::default() }
}

fn is_collection(value: &Value) -> bool {
    matches!(value, Value::List(_) | Value::Record(_))
}

fn is_comparison(op: BinaryOp) -> bool {
    matches!(binary_meaning(op), BinaryMeaning::Comparison(_) | BinaryMeaning::Near)
}

/// Both sides where they differ most, by how much, and how much is allowed.
fn near_verdict(
    holds: bool,
    values: [&Value; 2],
    spans: [Span; 2],
    limit: f64,
    unit: Unit,
    mut places: ClaimPlaces,
) -> Verdict {
    let mut side = |i: usize, path: &str| {
        let part = follow(values[i], path, &mut |value| places.note(value));
        let path = if part.is_some() { path.to_owned() } else { String::new() };
        let value = shown(part.as_ref().unwrap_or(values[i]), unit);
        ClaimSide { span: spans[i], path, value }
    };
    match deviation(values[0], values[1]) {
        Discrepancy::Apart(apart, path) => Verdict {
            holds,
            sides: vec![side(0, &path), side(1, &path)],
            apart: Some(apart),
            limit: Some(limit),
            places: places.of_failure(holds),
            ..Verdict::default()
        },
        Discrepancy::Different(what) | Discrepancy::Incomparable(what) => Verdict {
            holds,
            sides: vec![side(0, ""), side(1, "")],
            differ: Some(what),
            places: places.of_failure(holds),
            ..Verdict::default()
        },
    }
}

/// The part of a value at a path such as `.xs[3].x`, if it is there; `pass` sees each value on the way
/// to it.
fn follow(value: &Value, path: &str, pass: &mut dyn FnMut(&Value)) -> Option<Value> {
    let mut value = value.clone();
    pass(&value);
    let steps = path.replace('[', ".[");
    for step in steps.split('.').filter(|step| !step.is_empty()) {
        let inner = match step.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            Some(idx) => match (&value, idx.parse::<usize>()) {
                (Value::List(items), Ok(idx)) => items.get(idx),
                _ => None,
            },
            None => crate::value::field(&value, step, crate::kernel::Tolerance::DEFAULT)
                .unwrap_or_default(),
        };
        value = inner?;
        pass(&value);
    }
    Some(value)
}
