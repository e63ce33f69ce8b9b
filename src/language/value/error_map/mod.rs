//! From an error of the kernel to a diagnostic: its code, its message in the words of scripts, and what
//! to do, for each kind of failure.

mod codes;
mod hints;
mod hints_of_bodies;

use crate::{
    diag::{Diagnostic, Result, Span},
    kernel::{
        CountError, FitError, FormError, GeomError, InputError, JointError, KnotError, WeightError,
    },
    limits::Ceiling,
};

pub use codes::code_of;
pub use hints::{hint_of, raised};

/// Pins an error of the kernel to the place in the script that caused it.
pub trait At<T> {
    /// The same result, blamed on `span`.
    ///
    /// # Errors
    /// The error as a diagnostic.
    fn at(self, span: Span) -> Result<T>;
}

impl<T> At<T> for std::result::Result<T, GeomError> {
    fn at(self, span: Span) -> Result<T> {
        self.map_err(|error| blamed_on(error, span))
    }
}

/// The error as a diagnostic, at the place that is to blame.
#[must_use]
pub fn blamed_on(error: GeomError, span: Span) -> Box<Diagnostic> {
    if let Some(reason) = inside(&error) {
        return Box::new(asked_from(reason.clone(), span));
    }
    let mut diagnostic = Diagnostic::error(code_of(&error), span, error.to_string());
    diagnostic.elements = elements_of(&error);
    diagnostic.ceiling = ceiling_of(&error);
    Box::new(match hint_of(&error) {
        Some(hint) => diagnostic.hint(hint),
        None => diagnostic,
    })
}

/// The ceiling that an error of the kernel tells to be crossed.
fn ceiling_of(error: &GeomError) -> Option<&'static str> {
    match error {
        GeomError::Count(CountError::TooManyVertices { .. }) => Some(Ceiling::MESH_VERTICES),
        _ => None,
    }
}

/// What went wrong inside a function of the script that geometry is made of.
fn inside(error: &GeomError) -> Option<&Diagnostic> {
    match error {
        GeomError::Function(failure) => failure.reason(),
        _ => None,
    }
}

/// The mistake in a function, and who asked the function.
fn asked_from(reason: Diagnostic, span: Span) -> Diagnostic {
    let is_told =
        reason.primary.span == span || reason.others.iter().any(|other| other.span == span);
    if is_told { reason } else { reason.also(span, "asked from here") }
}

/// The elements of a list of the script that an error of the kernel is about, by their indices.
fn elements_of(error: &GeomError) -> Vec<Vec<usize>> {
    match error {
        GeomError::Joint(JointError::Gap { index, .. }) => vec![vec![*index], vec![index + 1]],
        GeomError::Joint(
            JointError::PatchGap { before, next, .. } | JointError::UnlikeWeights { before, next },
        ) => vec![before.to_vec(), next.to_vec()],
        GeomError::Input(InputError::CoincidentPoints { first, second }) => {
            vec![vec![*first], vec![*second]]
        }
        GeomError::Knots(KnotError::VanishingPatch { patch, .. }) => vec![patch.to_vec()],
        GeomError::Weights(
            WeightError::BadWeight { index, .. } | WeightError::BadEndWeight { index, .. },
        )
        | GeomError::Knots(
            KnotError::UnsortedKnots { index, .. }
            | KnotError::KnotMultiplicity { index, .. }
            | KnotError::VanishingPiece { index, .. },
        )
        | GeomError::Fit(FitError::ParametersNotIncreasing { index, .. })
        | GeomError::Form(FormError::NotScalar { index }) => vec![vec![*index]],
        _ => Vec::new(),
    }
}
