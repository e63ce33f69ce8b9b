//! Regions and solids as operations take them that can be differentiated: as they are, or with borders that
//! carry derivatives.

use std::sync::Arc;

use super::{FromValue, IntoValue, Mismatch, Type, Value};
use crate::{
    diag::Span,
    kernel::{GeomError, Jet, Region, Solid, VariedRegion, VariedSolid},
};

/// A region, or one that depends on the parameters of a function that is differentiated.
#[derive(Clone, Debug)]
pub enum RealRegion {
    /// As it is.
    Plain(Arc<Region>),
    /// With borders that vary.
    Varied(Arc<VariedRegion>),
}

/// A solid, or one that depends on the parameters of a function that is differentiated.
#[derive(Clone, Debug)]
pub enum RealSolid {
    /// As it is.
    Plain(Arc<Solid>),
    /// Made of what varies.
    Varied(Arc<VariedSolid>),
}

impl RealRegion {
    /// The region alone.
    #[must_use]
    pub fn plain(&self) -> &Arc<Region> {
        match self {
            Self::Plain(region) => region,
            Self::Varied(varied) => varied.region(),
        }
    }

    /// The region with its slopes, where it has any.
    #[must_use]
    pub fn varied(&self) -> Option<&VariedRegion> {
        match self {
            Self::Plain(_) => None,
            Self::Varied(varied) => Some(varied),
        }
    }
}

impl RealSolid {
    /// The solid alone.
    #[must_use]
    pub fn plain(&self) -> &Arc<Solid> {
        match self {
            Self::Plain(solid) => solid,
            Self::Varied(varied) => varied.solid(),
        }
    }

    /// The solid with its slopes, where it has any.
    #[must_use]
    pub fn varied(&self) -> Option<&VariedSolid> {
        match self {
            Self::Plain(_) => None,
            Self::Varied(varied) => Some(varied),
        }
    }
}

impl FromValue for RealRegion {
    const TYPE: Type = Type::Region;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        match value {
            Value::JetRegion(varied) => Ok(Self::Varied(Arc::clone(varied))),
            _ => Arc::from_value(value, span).map(Self::Plain),
        }
    }
}

impl FromValue for RealSolid {
    const TYPE: Type = Type::Solid;

    fn from_value(value: &Value, span: Span) -> Result<Self, Mismatch> {
        match value {
            Value::JetSolid(varied) => Ok(Self::Varied(Arc::clone(varied))),
            _ => Arc::from_value(value, span).map(Self::Plain),
        }
    }
}

impl IntoValue for RealRegion {
    const RETURNS: Type = Type::Region;

    fn into_value(self) -> Value {
        match self {
            Self::Plain(region) => Value::Region(region),
            Self::Varied(varied) => Value::JetRegion(varied),
        }
    }
}

impl IntoValue for RealSolid {
    const RETURNS: Type = Type::Solid;

    fn into_value(self) -> Value {
        match self {
            Self::Plain(solid) => Value::Solid(solid),
            Self::Varied(varied) => Value::JetSolid(varied),
        }
    }
}

/// A number with its slopes, where it has any.
///
/// # Errors
/// A slope that is no number.
pub fn with_slopes(
    value: f64,
    slopes: Option<Result<Vec<f64>, GeomError>>,
) -> Result<super::Real, GeomError> {
    Ok(match slopes {
        None => value.into(),
        Some(slopes) => super::Real::Jet(Jet::with_slopes(value, &slopes?)?),
    })
}
