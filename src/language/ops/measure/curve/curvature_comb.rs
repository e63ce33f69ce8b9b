//! `curvature_comb`: the porcupine of a curve.

use std::sync::Arc;

use glam::DVec3;

use super::{check_segments, sample_parameters};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{Curve, GeomError, KnotVector, LocalError, NurbsCurve, Side},
    value::{At, Choice, Ctx, IntoValue, Record, op},
};

op! {
    /// Curvature comb of a curve, `{teeth, envelope}`: segments from the curve as long as its
    /// curvature times the scale, and the polyline of their tips.
    ///
    /// Samples are evenly spaced in the parameter, both ends among them. At each the envelope has
    /// the tip of its tooth. Where the curvature has no bound there is no tooth, and a warning
    /// says so.
    curvature_comb in Measure -> Record {
        /// The curve.
        c: Spanned<Curve>,
        /// How many teeth, two or more.
        samples: Spanned<usize> = Spanned::unplaced(100),
        /// Length of a tooth where the curvature is 1.
        scale: f64 = 1.0,
        /// Away from the centre of curvature or towards it.
        side: CombSide = CombSide::Outside,
    }
    example "curvature_comb(bezier((0, 0), (1, 2), (2, 0)), samples = 3).teeth[1].end" => "(1, 3, 0)";
    example "curvature_comb(bezier((0, 0), (1, 2), (2, 0)), samples = 3, side = \"inside\").envelope(0.5)" => "(1, -1, 0)";
    refuses "curvature_comb(bezier((0, 0), (1, 2), (2, 0)), samples = 1)" => "E0601: a curve is sampled at 2 places or more, found 1";
    scene r#"
        curve c = bezier((0, 0), (1, 3), (3, -2), (4, 1))
        let comb = curvature_comb(c, scale = 0.3) with (hidden = true)
        curves teeth = comb.teeth with (color = "gray")
        curve envelope = comb.envelope with (color = "red")
    "#;
}

/// On which side of the curve the teeth stand.
#[derive(Clone, Copy, PartialEq)]
pub(in crate::ops::measure) enum CombSide {
    Outside,
    Inside,
}

impl Choice for CombSide {
    const WORDS: &'static [&'static str] = &["outside", "inside"];
    const MEANINGS: &'static [Self] = &[Self::Outside, Self::Inside];
}

impl CombSide {
    /// What the curvature vector is multiplied by.
    pub(in crate::ops::measure) fn signed(self, scale: f64) -> f64 {
        if self == Self::Outside { -scale } else { scale }
    }
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    check_segments(args.samples, 1, ctx)?;
    let comb = comb(ctx, &args.c, args.samples, args.side.signed(args.scale))?;
    Ok(Record::new([
        (Arc::from("teeth"), comb.teeth.into_value()),
        (Arc::from("envelope"), comb.envelope.into_value()),
    ]))
}

/// The comb of one curve.
pub(in crate::ops::measure) struct Comb {
    pub(in crate::ops::measure) teeth: Vec<NurbsCurve>,
    pub(in crate::ops::measure) envelope: NurbsCurve,
}

/// The comb whose teeth are the curvature vector times `sign`.
pub(in crate::ops::measure) fn comb(
    ctx: &mut Ctx<'_>,
    curve: &Spanned<Curve>,
    samples: Spanned<usize>,
    sign: f64,
) -> Result<Comb> {
    let (c, span) = (&curve.value, curve.span);
    if let Ok(nurbs) = c.nurbs() {
        nurbs.check_connected().at(span)?;
    }
    let (mut teeth, mut tips, mut bare) = (Vec::new(), Vec::new(), Vec::new());
    for t in sample_parameters(c, samples, ctx)? {
        let local = match c.local_at(t, Side::Right) {
            Err(GeomError::Local(LocalError::VanishingTangent { .. })) => None,
            local => Some(local.at(span)?),
        };
        match local.and_then(|local| Some((local.point(), local.curvature_vector()?))) {
            Some((foot, bending)) => {
                teeth.push(NurbsCurve::line(foot, foot + sign * bending).at(span)?);
                tips.push((t, foot + sign * bending));
            }
            None => bare.push(t),
        }
    }
    if let [first, ..] = bare[..] {
        let message = format!(
            "{} of {} samples have no tooth, the first at parameter {first}: the curvature has no bound there",
            bare.len(),
            samples.value
        );
        ctx.warn(Diagnostic::warning(Code::Unclean, ctx.span, message));
    }
    Ok(Comb { teeth, envelope: envelope(&tips, span)? })
}

/// The polyline through the tips, each at the parameter of its tooth.
fn envelope(tips: &[(f64, DVec3)], span: Span) -> Result<NurbsCurve> {
    let [(first, _), .., (last, _)] = *tips else {
        let message = "the curvature has no bound at any of the samples, so that there is no comb";
        return Diagnostic::error(Code::Degenerate, span, message)
            .hint("the curve stands still there: is it a single point?")
            .fail();
    };
    let inner = tips.iter().map(|&(t, _)| t);
    let knots = [first].into_iter().chain(inner).chain([last]).collect();
    let points: Vec<DVec3> = tips.iter().map(|&(_, tip)| tip).collect();
    NurbsCurve::polynomial(KnotVector::new(1, knots).at(span)?, &points).at(span)
}
