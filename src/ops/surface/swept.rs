//! What is to be said about a swept surface: warnings and its report.

use crate::{
    diag::{Code, Diagnostic, Result},
    kernel::{
        ConstructionReport, Frames, Grid, NurbsSurface, PathLeg, ReportEntry, Sweep, join_patches,
    },
    value::{At, Ctx, shortest},
};

/// Warns of what a sweep cannot promise.
pub(super) fn warn(ctx: &mut Ctx<'_>, sweep: &Sweep, frames: &Frames) {
    if let Some([before, behind]) = frames.flips().first() {
        let message = format!(
            "the frame turns around near parameter {} of the path",
            shortest(0.5 * (before + behind))
        );
        let hint = "`frame = \"rotation_minimizing\"` does not";
        ctx.warn(Diagnostic::warning(Code::FrameFlip, ctx.span, message).hint(hint));
    }
    if let Some([from, to]) = sweep.folds.first() {
        let more = match sweep.folds.len() - 1 {
            0 => String::new(),
            1 => ", and along another stretch,".to_owned(),
            n => format!(", and along {n} other stretches,"),
        };
        let message = format!(
            "between the parameters {} and {} of the path{more} the section reaches beyond the centre of curvature, so that the surface crosses itself",
            shortest(*from),
            shortest(*to)
        );
        let hint = "a smaller section, or a path that bends less, does not";
        ctx.warn(Diagnostic::warning(Code::SelfIntersecting, ctx.span, message).hint(hint));
    }
    if let Some(&t) = sweep.collapses.first() {
        let message = format!(
            "at parameter {} of the path the section shrinks to a line or a point",
            shortest(t)
        );
        let hint = "a `scale` that stays above zero between the ends keeps the surface regular";
        ctx.warn(Diagnostic::warning(Code::SelfIntersecting, ctx.span, message).hint(hint));
    }
}

/// Tells of a leg too short for the mitres at its ends.
pub(super) fn warn_of_corners(ctx: &mut Ctx<'_>, legs: &[PathLeg], reach: f64) {
    let over = legs.iter().map(|(part, frames)| {
        let domain = part.domain();
        (frames.overreach(reach), [domain.start(), domain.end()])
    });
    warn_of_short_legs(ctx, over.collect());
}

/// Tells of legs, by their parameters, that are more than once too short.
pub(super) fn warn_of_short_legs(ctx: &mut Ctx<'_>, legs: Vec<(f64, [f64; 2])>) {
    for (over, [from, to]) in legs {
        if over <= 1.0 {
            continue;
        }
        let message = format!(
            "between the parameters {} and {} the path is {} times too short for the mitres at its ends, so that the surface crosses itself",
            shortest(from),
            shortest(to),
            shortest((100.0 * over).round() / 100.0)
        );
        let hint = "a smaller section, or corners further apart";
        ctx.warn(Diagnostic::warning(Code::SelfIntersecting, ctx.span, message).hint(hint));
    }
}

/// The surface of all parts with its report.
pub(super) fn with_report(
    sweeps: Vec<Sweep>,
    legs: &[PathLeg],
    corners: Vec<f64>,
    ctx: &Ctx<'_>,
) -> Result<NurbsSurface> {
    let (mut deviation, mut at) = (0.0, sweeps[0].deviation.1);
    let mut placements: Vec<f64> = Vec::new();
    let mut folds: Vec<Vec<f64>> = Vec::new();
    let mut collapses: Vec<f64> = Vec::new();
    for sweep in &sweeps {
        if deviation < sweep.deviation.0 {
            (deviation, at) = sweep.deviation;
        }
        placements.extend(&sweep.placements);
        folds.extend(sweep.folds.iter().map(|ends| ends.to_vec()));
        collapses.extend(&sweep.collapses);
    }
    let surfaces: Vec<NurbsSurface> = sweeps.into_iter().map(|sweep| sweep.surface).collect();
    let surface = match &surfaces[..] {
        [only] => only.clone(),
        _ => {
            let patches = Grid::from_rows(vec![surfaces]).at(ctx.span)?;
            join_patches(&patches, ctx.tolerance.distance).at(ctx.span)?
        }
    };
    let net = surface.control_points();
    let both = |u: usize, v: usize| ConstructionReport::default().with("u", u).with("v", v);
    let frames = || legs.iter().map(|(_, frames)| frames);
    let flips: Vec<f64> = frames().flat_map(Frames::flips).map(|[a, b]| 0.5 * (a + b)).collect();
    let closing = frames().map(Frames::closing).sum::<f64>();
    let report = ConstructionReport::of("sweep")
        .with("placements", placements)
        .with("deviation", ConstructionReport::default().with("max", deviation).with("at", at))
        .with("closing_angle", ReportEntry::Angle(closing))
        .with("corners", corners)
        .with("flips", flips)
        .with("folds", folds)
        .with("collapses", collapses)
        .with("degree", both(surface.degree_u(), surface.degree_v()))
        .with("control_points", both(net.n_rows(), net.n_columns()));
    Ok(surface.with_report(report))
}
