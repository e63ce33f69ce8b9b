//! Claims: what a failed `check` reports: both sides, the limit, the margin.

use super::{
    ir::{BinaryOp, Expr, ExprKind},
    machine::Machine,
    operator,
};
use crate::{
    diag::{Code, Diagnostic, Result, Span, fault},
    value::{Deviation, Value, deviation, shortest},
};

/// How a claim came out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Verdict {
    /// Whether it holds.
    pub holds: bool,
    /// The left and the right side of a comparison; under `~=` their parts that differ most.
    pub sides: Vec<Side>,
    /// How far the sides are apart.
    pub apart: Option<f64>,
    /// How far they may be apart.
    pub limit: Option<f64>,
    /// What keeps them from being compared by distance.
    pub differ: Option<String>,
}

/// A side of a comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct Side {
    /// Where it stands.
    pub span: Span,
    /// The part of it that is shown, such as `[3].x`; empty for all of it.
    pub path: String,
    /// Its value.
    pub value: String,
}

impl Verdict {
    /// The figures on one line: how far apart, how far allowed, the margin.
    #[must_use]
    pub fn figures(&self) -> String {
        match (self.apart, self.limit, &self.differ) {
            (_, _, Some(what)) => format!("they differ: {what}"),
            (Some(apart), Some(limit), None) if self.holds => {
                format!("apart by {}, within {}", shortest(apart), shortest(limit))
            }
            (Some(apart), Some(limit), None) => format!(
                "apart by {}, limit {}, misses by {}",
                shortest(apart),
                shortest(limit),
                shortest(apart - limit)
            ),
            (Some(apart), None, None) if self.holds => {
                format!("holds with margin {}", shortest(apart))
            }
            (Some(apart), None, None) => format!("misses by {}", shortest(apart)),
            (None, ..) if self.holds => "this holds".to_owned(),
            (None, ..) => "this is false".to_owned(),
        }
    }
}

/// Characters of a value that a report shows.
const MOST_SHOWN: usize = 120;

/// A value as one line of a report.
pub(super) fn shown(value: &Value) -> String {
    let text = value.to_string();
    match text.char_indices().nth(MOST_SHOWN) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

impl Machine<'_> {
    /// Judges a claim in a fresh frame.
    pub(crate) fn judge(&mut self, claim: &Expr, n_slots: usize) -> Result<Verdict> {
        self.prepare(n_slots);
        fault::caught(claim.span, || self.verdict(claim))
    }

    fn verdict(&mut self, claim: &Expr) -> Result<Verdict> {
        match &claim.kind {
            ExprKind::Binary(BinaryOp::And, sides) => {
                let first = self.verdict(&sides[0])?;
                if first.holds { self.verdict(&sides[1]) } else { Ok(first) }
            }
            ExprKind::Binary(op, sides) if is_comparison(*op) => self.comparison(*op, sides, claim),
            ExprKind::Within(parts) => {
                let (a, b) = (self.eval(&parts[0])?, self.eval(&parts[1])?);
                let tolerance = self.tolerance_of(&parts[2])?;
                let places = [parts[0].span, parts[1].span];
                let holds = operator::near(&a, &b, tolerance, places[0].to(places[1]))?;
                Ok(near_verdict(holds, [&a, &b], places, tolerance))
            }
            _ => match self.eval(claim)? {
                Value::Bool(holds) => Ok(Verdict { holds, ..Verdict::default() }),
                other => {
                    let message =
                        format!("a check takes something true or false, found {}", other.phrase());
                    Diagnostic::error(Code::CheckNotBool, claim.span, message)
                        .hint("compare it with something: `==`, `<`, `~=`")
                        .fail()
                }
            },
        }
    }

    fn comparison(&mut self, op: BinaryOp, sides: &[Expr; 2], claim: &Expr) -> Result<Verdict> {
        let (a, b) = (self.eval(&sides[0])?, self.eval(&sides[1])?);
        let places =
            operator::Places { whole: claim.span, left: sides[0].span, right: sides[1].span };
        let holds =
            matches!(operator::binary(op, &a, &b, places, self.env.tolerance)?, Value::Bool(true));
        let spans = [sides[0].span, sides[1].span];
        if op == BinaryOp::Near {
            return Ok(near_verdict(holds, [&a, &b], spans, self.env.tolerance.distance));
        }
        let apart = match (&a, &b) {
            (Value::Number(x), Value::Number(y)) => Some((x.value - y.value).abs()),
            _ => None,
        };
        let sides = [(&a, spans[0]), (&b, spans[1])].map(|(value, span)| Side {
            span,
            path: String::new(),
            value: shown(value),
        });
        Ok(Verdict { holds, sides: sides.to_vec(), apart, ..Verdict::default() })
    }
}

fn is_comparison(op: BinaryOp) -> bool {
    use BinaryOp as Op;
    matches!(
        op,
        Op::Equal
            | Op::NotEqual
            | Op::Less
            | Op::LessEqual
            | Op::Greater
            | Op::GreaterEqual
            | Op::Near
    )
}

/// Both sides where they differ most, by how much, and how much is allowed.
fn near_verdict(holds: bool, values: [&Value; 2], spans: [Span; 2], limit: f64) -> Verdict {
    let side = |i: usize, path: &str| Side {
        span: spans[i],
        path: path.to_owned(),
        value: shown(&follow(values[i], path)),
    };
    match deviation(values[0], values[1]) {
        Deviation::Apart(apart, path) => Verdict {
            holds,
            sides: vec![side(0, &path), side(1, &path)],
            apart: Some(apart),
            limit: Some(limit),
            differ: None,
        },
        Deviation::Different(what) | Deviation::Incomparable(what) => Verdict {
            holds,
            sides: vec![side(0, ""), side(1, "")],
            differ: Some(what),
            ..Verdict::default()
        },
    }
}

/// The part of a value at a path such as `[3].x`.
fn follow(value: &Value, path: &str) -> Value {
    let mut value = value.clone();
    for step in
        path.split_inclusive(']').flat_map(|part| part.split('.')).filter(|step| !step.is_empty())
    {
        let inner = match step.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            Some(idx) => match (&value, idx.parse::<usize>()) {
                (Value::List(items), Ok(idx)) => items.get(idx),
                _ => None,
            },
            None => crate::value::field(&value, step, crate::kernel::Tolerance::DEFAULT)
                .unwrap_or_default(),
        };
        match inner {
            Some(inner) => value = inner,
            None => break,
        }
    }
    value
}
