//! What operations find by rules, where that moves with what is differentiated.

use std::sync::Arc;

use super::{Call, Record, Value};
use crate::kernel::{GeomError, NurbsSurface, VariedSurface};

/// What an operation finds by a rule before it makes a surface that is affine in all else.
#[derive(Debug)]
pub struct Settling {
    /// The parameter by which it may be given, and the entry of the report that tells what was found.
    pub parameter: &'static str,
    /// In which calls it is found, and moves with what is differentiated.
    pub applies: fn(&Call) -> bool,
    /// Of its answer and the report of that, the same with the derivatives that it has, where what it is made of tells them
    /// at once; none where they are not known so.
    pub known: Option<fn(&Call, &Arc<NurbsSurface>, &Record) -> MovingSurface>,
    /// Of its report, arguments that say what else it found, where that stays while what is differentiated moves a little.
    pub held: Option<fn(&Record) -> Vec<(&'static str, Value)>>,
    /// The surface with the derivatives that it has while that moves, from those that it has while that stays at what was
    /// found; none where they are not known.
    pub moving: Option<fn(&Call, &VariedSurface, &Value) -> MovingSurface>,
}

/// A surface with its derivatives, where they are known.
pub type MovingSurface = std::result::Result<Option<VariedSurface>, GeomError>;
