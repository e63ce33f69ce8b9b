//! How far a surface that fills a hole is turned against its neighbours.

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{ConstructionReport, NurbsCurve, ReportEntry},
    value::{Angle, rounded},
};

/// Places of a span at which the angle is measured.
const N_PLACES: usize = 32;

/// The largest angle between two surfaces along a boundary.
#[derive(Clone, Debug, Default)]
pub(super) struct BoundaryAngle {
    /// Radians.
    pub(super) angle: f64,
    boundary: String,
    at: f64,
}

impl BoundaryAngle {
    /// The largest angle along a boundary: between the planes that its tangent spans with the derivative
    /// across it that was given, and with the one that the surface has.
    pub(super) fn along(
        (name, boundary): (&str, &NurbsCurve),
        [given, made]: [&NurbsCurve; 2],
    ) -> Self {
        let at = made.domain().start();
        let mut turned = Self { angle: 0.0, boundary: name.to_owned(), at };
        for span in made.knots().spans() {
            for t in made.knots().span_interval(span).steps(N_PLACES) {
                let along = boundary.derivatives_at(t, 1)[1];
                let normal = |field: &NurbsCurve| along.cross(field.point_at(t)).try_normalize();
                let Some((a, b)) = normal(given).zip(normal(made)) else { continue };
                let angle = libm::atan2(a.cross(b).length(), a.dot(b));
                if turned.angle < angle {
                    (turned.angle, turned.at) = (angle, t);
                }
            }
        }
        turned
    }

    /// The one with the largest angle, the first of several; none where no boundary is turned.
    pub(super) fn largest(all: &[Self]) -> Self {
        all.iter().fold(Self::default(), |most, turned| {
            if most.angle < turned.angle { turned.clone() } else { most }
        })
    }

    /// The angle of each boundary.
    pub(super) fn facts(all: &[Self]) -> ReportEntry {
        let fact = |turned: &Self| {
            ReportEntry::Record(
                ConstructionReport::default()
                    .with("boundary", ReportEntry::Text(turned.boundary.as_str().into()))
                    .with("max", ReportEntry::Angle(turned.angle))
                    .with("at", turned.at),
            )
        };
        ReportEntry::List(all.iter().map(fact).collect())
    }

    /// The error of an angle that is larger than allowed.
    pub(super) fn refused<T>(&self, allowed: Spanned<Angle>) -> Result<T> {
        let message = format!(
            "along `{}` the surface is turned by {} degrees against what its cross field asks for, at parameter {}, more than the {} allowed",
            self.boundary,
            rounded(self.angle.to_degrees()),
            rounded(self.at),
            rounded(allowed.value.0.to_degrees())
        );
        Diagnostic::error(Code::BeyondTolerance, allowed.span, message)
            .hint("cross fields whose derivatives agree at the corners need no mean of twists, and are met exactly")
            .fail()
    }

    pub(super) fn fact(&self) -> ReportEntry {
        let boundary = if self.boundary.is_empty() {
            ReportEntry::None
        } else {
            ReportEntry::Text(self.boundary.as_str().into())
        };
        ReportEntry::Record(
            ConstructionReport::default()
                .with("max", ReportEntry::Angle(self.angle))
                .with("boundary", boundary)
                .with("at", self.at),
        )
    }
}
