//! Conversions between language values and the Rust types of operations' parameters.

use glam::DVec3;

use super::{CARRIES_DERIVATIVES, List, Number, Real, Type, Value};
use crate::{
    diag::{Code, Span, Spanned},
    kernel::{CountError, GeomError, Grid},
    limits::work,
};

/// Why a value cannot be read as a type.
#[derive(Clone, Debug, PartialEq)]
pub struct Mismatch {
    /// What was expected there; empty where `found` is a reason in itself.
    pub wanted: String,
    /// What was found there.
    pub found: String,
    /// Indices that lead to the culprit inside lists, outermost first.
    pub path: Vec<usize>,
    /// The kind of mistake.
    pub code: Code,
    /// What to do.
    pub hint: Option<String>,
    /// The word that should stand there instead.
    pub meant: Option<&'static str>,
}

impl Mismatch {
    /// `value` is not of type `wanted`.
    #[must_use]
    pub fn kind(wanted: Type, value: &Value) -> Self {
        if value.is_jet() && wanted.accepts(&value.looked_at()) {
            return Self::no_derivative();
        }
        Self::new(wanted.phrase(), value.phrase())
    }

    /// A value that carries derivatives stands where nothing carries them on.
    #[must_use]
    pub fn no_derivative() -> Self {
        let reason = "no derivative passes through here, and derivatives are wanted";
        Self::because(reason, Code::NoDerivative).hint(CARRIES_DERIVATIVES)
    }

    /// Any other disappointment.
    #[must_use]
    pub fn new(wanted: impl Into<String>, found: impl Into<String>) -> Self {
        let (wanted, found) = (wanted.into(), found.into());
        Self { wanted, found, path: Vec::new(), code: Code::WrongKind, hint: None, meant: None }
    }

    /// A reason in a sentence of its own, such as an error of the kernel.
    #[must_use]
    pub fn because(reason: impl Into<String>, code: Code) -> Self {
        Self { code, ..Self::new("", reason) }
    }

    /// The same under another code.
    #[must_use]
    pub fn code(mut self, code: Code) -> Self {
        self.code = code;
        self
    }

    /// What to do about it.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }

    /// The same, found inside element `idx` of a list.
    #[must_use]
    pub fn inside(mut self, idx: usize) -> Self {
        self.path.insert(0, idx);
        self
    }

    /// `must be a point, but element [2] is a number`.
    #[must_use]
    pub fn sentence(&self, subject: &str, whole: Type) -> String {
        if self.wanted.is_empty() {
            return format!("{subject}: {}", self.found);
        }
        if self.path.is_empty() {
            return format!("{subject} must be {}, found {}", self.wanted, self.found);
        }
        let path: String = self.path.iter().map(|idx| format!("[{idx}]")).collect();
        format!(
            "{subject} must be {}, but its element {path} is {}; {} is expected there",
            whole.phrase(),
            self.found,
            self.wanted
        )
    }
}

/// A Rust type that an argument can be read as.
pub trait FromValue: Sized {
    /// How the type is called in help texts and messages.
    const TYPE: Type;
    /// Whether a parameter of this type may be left out although it has no default.
    const OPTIONAL: bool = false;
    /// Whether, as the first parameter, its elements may stand as the arguments themselves.
    const SPREADS: bool = false;

    /// Whether, although it may be left out, it may also stand by position.
    const BY_POSITION: bool = false;

    /// Reads `value`, which was written at `span`.
    ///
    /// # Errors
    /// What was expected and what was found, without naming the parameter.
    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch>;

    /// What a parameter that was left out becomes; `Some` exactly when `OPTIONAL`.
    fn absent() -> Option<Self> {
        None
    }
}

/// A word out of a few: parallel lists of the words and what they stand for.
pub trait Choice: Copy + PartialEq + 'static {
    /// The words as scripts write them.
    const WORDS: &'static [&'static str];
    /// What each stands for.
    const MEANINGS: &'static [Self];
}

impl<T: Choice> FromValue for T {
    const TYPE: Type = Type::Choice(T::WORDS);

    fn from_value(value: &Value, _: Span) -> Result<Self, Mismatch> {
        let Value::Text(text) = value else { return Err(Mismatch::kind(Self::TYPE, value)) };
        T::WORDS.iter().position(|word| *word == &**text).map(|idx| T::MEANINGS[idx]).ok_or_else(
            || {
                let mismatch = Mismatch::kind(Self::TYPE, value).code(Code::BadChoice);
                let meant = crate::diag::nearest(text, T::WORDS.iter().copied());
                let hint = meant.map(|word| format!("did you mean \"{word}\"?"));
                Mismatch { meant, hint, ..mismatch }
            },
        )
    }
}

impl FromValue for Value {
    const TYPE: Type = Type::Any;

    fn from_value(value: &Value, _: Span) -> Result<Self, Mismatch> {
        Ok(value.clone())
    }
}

impl FromValue for f64 {
    const TYPE: Type = Type::Ratio;

    fn from_value(value: &Value, _: Span) -> Result<Self, Mismatch> {
        match value {
            Value::Number(number) if number.dim.is_bare() => Ok(number.value),
            Value::Number(number) => {
                let unit = number.dim.suffix("mm").unwrap_or_else(|| "rad".to_owned());
                Err(Mismatch::kind(Self::TYPE, value)
                    .code(Code::UnitMismatch)
                    .hint(format!("divide by `1{unit}` to take the unit away")))
            }
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

impl FromValue for i64 {
    const TYPE: Type = Type::Integer;

    fn from_value(value: &Value, _: Span) -> Result<Self, Mismatch> {
        let Value::Number(number) = value else { return Err(Mismatch::kind(Self::TYPE, value)) };
        let is_whole = number.dim.is_bare() && number.value.fract() == 0.0;
        number.as_integer().ok_or_else(|| match is_whole {
            true => Mismatch::new("a whole number of less than sixteen digits", value.phrase()),
            false => Mismatch::kind(Self::TYPE, value),
        })
    }
}

impl FromValue for usize {
    const TYPE: Type = Type::Count;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        let count = i64::from_value(value, span)?;
        Self::try_from(count)
            .map_err(|_| Mismatch::new("a whole number of zero or more", value.phrase()))
    }
}

/// A length in document units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Length<T = f64>(pub T);

impl FromValue for Length {
    const TYPE: Type = Type::Length;

    fn from_value(value: &Value, _: Span) -> Result<Self, Mismatch> {
        match value {
            Value::Number(number) if number.dim.is_as_length() => Ok(Self(number.value)),
            Value::Number(_) => Err(Mismatch::kind(Self::TYPE, value).code(Code::UnitMismatch)),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

/// An angle in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angle<T = f64>(pub T);

impl FromValue for Angle {
    const TYPE: Type = Type::Angle;

    fn from_value(value: &Value, _: Span) -> Result<Self, Mismatch> {
        match value {
            Value::Number(number) if number.dim.is_angle() => Ok(Self(number.value)),
            Value::Number(number) if number.dim.is_bare() => Err(Mismatch::kind(Self::TYPE, value)
                .code(Code::MissingAngleUnit)
                .hint(format!(
                    "write `{number}deg` or `{number}rad`; what was computed or read from a file becomes an angle by `* 1deg`"
                ))),
            Value::Number(_) => Err(Mismatch::kind(Self::TYPE, value).code(Code::UnitMismatch)),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

/// Anything that can be called: a function, a curve, a surface.
#[derive(Clone, Debug)]
pub struct Callback(pub Value);

impl FromValue for Callback {
    const TYPE: Type = Type::Function;

    fn from_value(value: &Value, _: Span) -> Result<Self, Mismatch> {
        if Type::Function.accepts(value) {
            Ok(Self(value.clone()))
        } else {
            Err(Mismatch::kind(Self::TYPE, value))
        }
    }
}

impl<T: FromValue> FromValue for Vec<T> {
    const TYPE: Type = Type::List(&T::TYPE, 0);
    const SPREADS: bool = matches!(T::TYPE, Type::Point);

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        let items = List::of(value, Self::TYPE)?;
        if !work::passes(items.len()) {
            return Ok(Self::new());
        }
        items
            .values()
            .enumerate()
            .map(|(idx, item)| T::from_value(&item, span).map_err(|mismatch| mismatch.inside(idx)))
            .collect()
    }
}

/// A list that must hold `N` elements or more.
#[derive(Clone, Debug, PartialEq)]
pub struct AtLeast<const N: usize, T>(pub Vec<T>);

impl<const N: usize, T: FromValue> FromValue for AtLeast<N, T> {
    const TYPE: Type = Type::List(&T::TYPE, N);
    const SPREADS: bool = matches!(T::TYPE, Type::Point);

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        let items = Vec::<T>::from_value(value, span)?;
        if items.len() < N {
            let code =
                if matches!(T::TYPE, Type::Point) { Code::TooFewPoints } else { Code::WrongKind };
            return Err(Mismatch::kind(Self::TYPE, value).code(code));
        }
        Ok(Self(items))
    }
}

/// Numbers, given as a list or as the arguments themselves.
#[derive(Clone, Debug, PartialEq)]
pub struct Numbers(pub Vec<Number<Real>>);

impl FromValue for Numbers {
    const TYPE: Type = Type::List(&Type::Number, 0);
    const SPREADS: bool = true;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        Vec::from_value(value, span).map(Self)
    }
}

/// Rows of points of one length: `grid[i][j]`, i along u.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows(pub Grid<DVec3>);

impl FromValue for Rows {
    const TYPE: Type = Type::Grid(&Type::Point);

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        let rows: Vec<Vec<DVec3>> = Vec::from_value(value, span)?;
        Grid::from_rows(rows).map(Self).map_err(|err| {
            let mismatch = Mismatch::because(err.to_string(), Code::RaggedGrid);
            match err {
                GeomError::Count(CountError::RaggedGrid { row, .. }) => mismatch.inside(row),
                _ => mismatch,
            }
        })
    }
}

impl<T: FromValue> FromValue for Option<T> {
    const TYPE: Type = T::TYPE;
    const OPTIONAL: bool = true;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        match value {
            Value::None => Ok(None),
            _ => T::from_value(value, span).map(Some),
        }
    }

    fn absent() -> Option<Self> {
        Some(None)
    }
}

/// An optional parameter that may stand by position: where a call reads better without its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Maybe<T>(pub Option<T>);

impl<T: FromValue> FromValue for Maybe<T> {
    const TYPE: Type = T::TYPE;
    const OPTIONAL: bool = true;
    const BY_POSITION: bool = true;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        Option::from_value(value, span).map(Self)
    }

    fn absent() -> Option<Self> {
        Some(Self(None))
    }
}

impl<T: FromValue> FromValue for Spanned<T> {
    const TYPE: Type = T::TYPE;
    const OPTIONAL: bool = T::OPTIONAL;
    const SPREADS: bool = T::SPREADS;
    const BY_POSITION: bool = T::BY_POSITION;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        T::from_value(value, span).map(|value| Self { value, span })
    }

    fn absent() -> Option<Self> {
        T::absent().map(|value| Self { value, span: Span::default() })
    }
}
