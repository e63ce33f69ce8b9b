//! What `continuity` takes and answers where pieces of geometry meet: the limits that a script asks for, and the fields
//! that curves and surfaces have alike.

use std::sync::Arc;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{Continuity, JointTolerance, Tolerance},
    ops::positive,
    value::{Angle, Curvature, IntoValue, Length, LengthPower, Value, shortest},
};

/// The options of `continuity`.
pub(in crate::ops) struct ContinuityOptions {
    pub(in crate::ops) tolerance: Option<Spanned<Length>>,
    pub(in crate::ops) angle: Option<Spanned<Angle>>,
    pub(in crate::ops) curvature_gap: Option<Spanned<Curvature>>,
}

impl ContinuityOptions {
    /// What counts as equal at a joint in a document of this tolerance.
    pub(in crate::ops) fn over(self, document: Tolerance) -> Result<JointTolerance> {
        let distance =
            self.tolerance.map(|length| positive("the tolerance", length)).transpose()?;
        if let Some(angle) = self.angle.filter(|angle| angle.value.0 <= 0.0) {
            let degrees = shortest(angle.value.0.to_degrees());
            return refused(format!("the angle must be positive, found {degrees}deg"), angle.span);
        }
        if let Some(gap) = self.curvature_gap.filter(|gap| gap.value.0 <= 0.0) {
            let found = shortest(gap.value.0);
            return refused(format!("the curvature gap must be positive, found {found}"), gap.span);
        }
        Ok(JointTolerance {
            document,
            distance,
            angle: self.angle.map(|angle| angle.value.0),
            curvature_gap: self.curvature_gap.map(|gap| gap.value.0),
        })
    }
}

/// The fields of an answer.
pub(in crate::ops) fn continuity_fields(found: Continuity) -> [(Arc<str>, Value); 6] {
    let Continuity { c, g, gap, angle, curvature_gap, c_homogeneous } = found;
    let curvature_gap =
        curvature_gap.map_or(Value::None, |gap| LengthPower::<-1>(gap).into_value());
    [
        ("c".into(), i64::from(c).into_value()),
        ("g".into(), i64::from(g).into_value()),
        ("gap".into(), Length(gap).into_value()),
        ("angle".into(), Angle(angle).into_value()),
        ("curvature_gap".into(), curvature_gap),
        ("c_homogeneous".into(), i64::from(c_homogeneous).into_value()),
    ]
}

fn refused<T>(message: String, span: Span) -> Result<T> {
    Diagnostic::error(Code::Degenerate, span, message).fail()
}
