//! What scripts say of a section on its way: sizes, turns, and where it looks.

use glam::DVec3;

use crate::{
    diag::Span,
    kernel::{Curve, FunctionFailure, GeomError, Interval, Motion},
    value::{Angle, Callback, Ctx, FromValue, Mismatch, Type, Value},
};

/// The size along the way.
#[derive(Clone, Debug)]
pub(in crate::ops) enum Scale {
    Same(DVec3),
    /// At even parameters, with straight lines between.
    Listed(Vec<DVec3>),
    Function(Callback),
}

impl Scale {
    const ONE: Type = Type::OneOf(&[Type::Ratio, Type::Point]);

    fn factors(value: &Value, span: Span) -> Result<DVec3, Mismatch> {
        match value {
            Value::Point(factors) => Ok(*factors),
            Value::Number(_) => f64::from_value(value, span).map(DVec3::splat),
            _ => Err(Mismatch::kind(Self::ONE, value)),
        }
    }

    /// Parameters where the list bends.
    pub(super) fn breaks(&self, domain: Interval) -> Vec<f64> {
        let Self::Listed(list) = self else { return Vec::new() };
        let steps = domain.steps(list.len() - 1);
        steps[1..steps.len() - 1].to_vec()
    }
}

impl FromValue for Scale {
    const TYPE: Type =
        Type::OneOf(&[Type::Ratio, Type::Point, Type::List(&Self::ONE, 2), Type::Function]);

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        match value {
            Value::Number(_) | Value::Point(_) => Self::factors(value, span).map(Self::Same),
            Value::List(_) | Value::Range(_) => {
                let items = Vec::<Value>::from_value(value, span)?;
                if items.len() < 2 {
                    return Err(Mismatch::new("two factors or more", value.phrase()));
                }
                let one = |(idx, item): (usize, &Value)| {
                    Self::factors(item, span).map_err(|mismatch| mismatch.inside(idx))
                };
                items.iter().enumerate().map(one).collect::<Result<_, _>>().map(Self::Listed)
            }
            _ if Type::Function.accepts(value) => {
                Callback::from_value(value, span).map(Self::Function)
            }
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

/// The turn along the way.
#[derive(Clone, Debug)]
pub(in crate::ops) enum Twist {
    /// Reached at the end.
    Whole(f64),
    Function(Callback),
}

impl FromValue for Twist {
    const TYPE: Type = Type::OneOf(&[Type::Angle, Type::Function]);

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        match value {
            Value::Number(_) => Angle::from_value(value, span).map(|angle| Self::Whole(angle.0)),
            _ if Type::Function.accepts(value) => {
                Callback::from_value(value, span).map(Self::Function)
            }
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

/// What a script says of a section on its way.
pub(super) struct MotionArgs<'c, 'a> {
    pub(super) ctx: &'c mut Ctx<'a>,
    pub(super) scale: Option<Scale>,
    pub(super) twist: Option<Twist>,
    /// The path's.
    pub(super) domain: Interval,
}

impl MotionArgs<'_, '_> {
    fn call<T: FromValue>(&mut self, function: &Callback, t: f64) -> Result<T, GeomError> {
        let span = self.ctx.span;
        let parameter = Value::number(t);
        let value = self.ctx.call(function, &[parameter]);
        let value = value.map_err(|reason| FunctionFailure::new(*reason))?;
        T::from_value(&value, span).map_err(|mismatch| {
            let message = mismatch.sentence("what the function answers", T::TYPE);
            let reason = crate::diag::Diagnostic::error(mismatch.code, span, message);
            GeomError::Function(FunctionFailure::new(reason))
        })
    }
}

/// What a function of sizes answers.
struct SizeFactors(DVec3);

impl FromValue for SizeFactors {
    const TYPE: Type = Scale::ONE;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        Scale::factors(value, span).map(Self)
    }
}

impl Motion for MotionArgs<'_, '_> {
    fn scale(&mut self, t: f64) -> Result<DVec3, GeomError> {
        match self.scale.clone() {
            None => Ok(DVec3::ONE),
            Some(Scale::Same(factors)) => Ok(factors),
            Some(Scale::Listed(list)) => {
                let place = self.domain.fraction_of(t) * (list.len() - 1) as f64;
                let before = (place as usize).min(list.len() - 2);
                Ok(list[before].lerp(list[before + 1], place - before as f64))
            }
            Some(Scale::Function(function)) => self.call::<SizeFactors>(&function, t).map(|f| f.0),
        }
    }

    fn twist(&mut self, t: f64) -> Result<f64, GeomError> {
        match self.twist.clone() {
            None => Ok(0.0),
            Some(Twist::Whole(angle)) => Ok(angle * self.domain.fraction_of(t)),
            Some(Twist::Function(function)) => self.call::<Angle>(&function, t).map(|a| a.0),
        }
    }
}

/// What a section is turned by.
#[derive(Clone, Debug)]
pub(in crate::ops) enum Rails {
    /// z points to it.
    One(Curve),
    /// Both ends of the section run along them.
    Two([Curve; 2]),
}

impl FromValue for Rails {
    const TYPE: Type = Type::OneOf(&[Type::Curve, Type::List(&Type::Curve, 2)]);

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        match value {
            Value::Curve(curve) => Ok(Self::One(curve.clone())),
            Value::List(_) => {
                let curves = Vec::<Curve>::from_value(value, span)?;
                let n = curves.len();
                let two: Result<[Curve; 2], _> = curves.try_into();
                two.map(Self::Two)
                    .map_err(|_| Mismatch::new("one rail or a list of two", format!("{n} rails")))
            }
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}
