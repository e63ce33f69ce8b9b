//! Curves with a report of what is known of them as curves of surfaces, which is found when somebody asks.

use std::sync::Arc;

use super::{
    super::{
        plane::ParameterPlane,
        pull::{ArcParameters, arcs_on_surface},
    },
    CurveEnd, SurfaceCurve, SurfaceCurveKind,
    found::sheet,
    piece::Carrier,
};
use crate::{
    ConstructionReport, Frame, GeomError, NurbsCurve, NurbsSurface, ReportEntry, Tolerance,
    tolerance::LAST_BIT,
};

impl SurfaceCurve {
    /// A curve that two surfaces share, as it is, with a report of an operation that says so: its `kind`, a bound of
    /// its `deviation` from both, whether it is `proven`, its curves of parameters `on` them, each over the
    /// parameter of the curve, and what it is `between`.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use virote_kernel::{
    ///     CircleForm, Frame, NurbsCurve, NurbsSurface, ReportEntry, SurfaceCurve, Tolerance, glam::DVec3,
    /// };
    ///
    /// let tube = Arc::new(NurbsSurface::cone(Frame::XY, [1.0, 1.0], 2.0)?);
    /// let plane = Frame::XY.at(DVec3::Z);
    /// let circle = NurbsCurve::ellipse(plane, [1.0; 2], CircleForm::NinePoint)?;
    /// let found = SurfaceCurve::reported_in_plane(circle, tube, plane, Tolerance::DEFAULT, "section");
    /// let report = found.report().expect("there is one");
    /// assert!(matches!(report.facts().find(|fact| fact.0 == "proven"), Some((_, ReportEntry::Truth(true)))));
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    #[must_use]
    pub fn reported(
        curve: NurbsCurve,
        surfaces: [Arc<NurbsSurface>; 2],
        tolerance: Tolerance,
        operation: &'static str,
    ) -> NurbsCurve {
        let asked = curve.clone();
        let ask = move || {
            let sizes = surfaces.each_ref().map(|surface| surface.bounds().diagonal());
            let distance = tolerance.distance_for(sizes[0].min(sizes[1]));
            told(operation, Self::of(&asked, [&surfaces[0], &surfaces[1]], distance))
        };
        curve.with_report(ConstructionReport::later(ask))
    }

    /// The same of a curve of a surface in a plane, whose parameters are its coordinates.
    #[must_use]
    pub fn reported_in_plane(
        curve: NurbsCurve,
        surface: Arc<NurbsSurface>,
        plane: Frame,
        tolerance: Tolerance,
        operation: &'static str,
    ) -> NurbsCurve {
        let asked = curve.clone();
        let ask = move || {
            let bounds = surface.bounds();
            let distance = tolerance.distance_for(bounds.diagonal());
            let found = sheet(plane, bounds)
                .and_then(|sheet| Self::of(&asked, [&surface, &sheet], distance));
            told(operation, found)
        };
        curve.with_report(ConstructionReport::later(ask))
    }

    /// The same of an edge of a face on a surface, which is proven to be there by its deviation alone. Where it runs
    /// over a seam it has several curves of parameters.
    #[must_use]
    pub fn reported_on(
        curve: NurbsCurve,
        surface: Arc<NurbsSurface>,
        tolerance: Tolerance,
        operation: &'static str,
    ) -> NurbsCurve {
        let asked = curve.clone();
        let ask = move || told_of_edge(operation, &asked, &surface, tolerance);
        curve.with_report(ConstructionReport::later(ask))
    }

    /// One of which nothing is known, as of a surface that is a function.
    #[must_use]
    pub fn reported_without_proof(curve: NurbsCurve, operation: &'static str) -> NurbsCurve {
        curve.with_report(unknown(operation))
    }
}

/// A distance, if there is one.
fn bound(distance: f64) -> ReportEntry {
    if distance.is_finite() { ReportEntry::Length(distance) } else { ReportEntry::None }
}

fn told(operation: &str, found: Result<SurfaceCurve, GeomError>) -> ConstructionReport {
    let Ok(found) = found else { return unknown(operation) };
    let on = match found.deviation.is_finite() {
        true => found.on.to_vec().into(),
        false => ReportEntry::None,
    };
    ConstructionReport::of(operation)
        .with("kind", found.kind.word())
        .with("deviation", bound(found.deviation))
        .with("radius", found.radius.map_or(ReportEntry::None, bound))
        .with("proven", found.is_proven)
        .with("on", on)
        .with("between", found.between.map(CurveEnd::word).to_vec())
}

fn told_of_edge(
    operation: &str,
    curve: &NurbsCurve,
    surface: &Arc<NurbsSurface>,
    tolerance: Tolerance,
) -> ConstructionReport {
    let distance = tolerance.distance_for(surface.bounds().diagonal());
    let plane = ParameterPlane::of(Arc::clone(surface), distance);
    let (what, form) = (("edge", 0), ArcParameters::OfCurve);
    let limits = [distance, tolerance.angle];
    let Ok(arcs) = arcs_on_surface(&plane, curve, None, what, limits, form) else {
        return unknown(operation);
    };
    let arcs: Vec<NurbsCurve> = arcs.iter().map(|arc| plane.to_parameters(arc)).collect();
    let deviations = arcs.iter().map(|arc| deviation(curve, arc, surface));
    let deviation = deviations.fold(0.0, f64::max);
    let is_closed = curve.start().distance(curve.end()) <= LAST_BIT * distance;
    let end = if is_closed { CurveEnd::Closed } else { CurveEnd::Junction };
    ConstructionReport::of(operation)
        .with("kind", SurfaceCurveKind::Border.word())
        .with("deviation", bound(deviation))
        .with("radius", ReportEntry::None)
        .with("proven", deviation <= distance)
        .with("on", arcs)
        .with("between", [end, end].map(CurveEnd::word).to_vec())
}

/// A bound of the distance between a curve and the surface at an arc of its parameters.
fn deviation(curve: &NurbsCurve, arc: &NurbsCurve, surface: &NurbsSurface) -> f64 {
    let Ok(part) = curve.trimmed(arc.domain()) else { return f64::INFINITY };
    let both = SurfaceCurve {
        curve: part,
        on: [arc.clone(), arc.clone()],
        deviation: f64::INFINITY,
        radius: None,
        kind: SurfaceCurveKind::Border,
        is_proven: false,
        between: [CurveEnd::Junction; 2],
    };
    let carrier = Carrier::new(surface);
    let of_piece = |piece: &super::piece::CurvePiece| {
        piece.residual(&carrier, 0).map_or(f64::INFINITY, |residual| residual.length())
    };
    both.pieces().iter().map(of_piece).fold(0.0, f64::max)
}

fn unknown(operation: &str) -> ConstructionReport {
    ConstructionReport::of(operation)
        .with("kind", ReportEntry::None)
        .with("deviation", ReportEntry::None)
        .with("radius", ReportEntry::None)
        .with("proven", false)
        .with("on", ReportEntry::None)
        .with("between", ReportEntry::None)
}
