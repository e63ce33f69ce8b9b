//! What operations find by rules, where that moves with what is differentiated.

use std::sync::Arc;

use super::{Call, Record, Value};
use crate::kernel::{GeomError, NurbsSurface, VariedSurface};

/// What an operation finds by a rule before it makes a surface that is affine in all else.
#[derive(Debug)]
pub struct Settling {
    /// The parameter by which it may be given, and the entry of the report that tells what was found.
    pub parameter: &'static str,
    /// Of its answer and the report of that, the same with the derivatives that it has, where what it is made of tells them
    /// at once; none where they are not known so.
    pub known: Option<fn(&Call, &Arc<NurbsSurface>, &Record) -> MovingSurface>,
    /// Of its report, arguments that say what else it found, where that stays while what is differentiated moves a little.
    pub held: Option<fn(&Record) -> Vec<(&'static str, Value)>>,
    /// In which calls it moves with what is differentiated, and the surface with the derivatives that it has then, from
    /// those that it has while it stays at what was found; none where they are not known.
    pub moving: Option<(fn(&Call) -> bool, MovedSurface)>,
}

/// A surface that moves, from a call, the same surface while what was found stays, and what was found.
pub(super) type MovedSurface = fn(&Call, &VariedSurface, &Value) -> MovingSurface;

/// A surface with its derivatives, where they are known.
pub type MovingSurface = std::result::Result<Option<VariedSurface>, GeomError>;
