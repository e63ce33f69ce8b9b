//! `skin`: the solid through regions.

use std::sync::Arc;

use super::{varied_walls::with_walls, walls::of_walls};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Curve, Face, NurbsCurve, SectionParameters, Solid},
    ops::surface::{
        section::{SectionPairing, SectionPlaces, SectionShape, SectionTangent},
        skin_options::{SkinOptions, skin_options},
    },
    value::{At, Ctx, Length, RealRegion, RealSolid, op},
};

op! {
    /// Solid through regions, whose ends are the first and the last of them.
    ///
    /// Their borders are skinned as curves are, the outer ones, and holes in their order: u along them, v from one region
    /// to the next. All regions have as many holes. A closed skin goes on from the last region to the first, without
    /// ends.
    skin | loft in Solid -> RealSolid {
        /// The regions in order, two or more.
        sections: Spanned<Vec<RealRegion>>,
        /// The degree along v, from 1; fewer regions than degree + 1 lower it.
        degree: Spanned<usize> = Spanned::unplaced(3),
        /// A curve whose tangents the sides take at the regions; degree 2 or 3.
        spine: Option<Spanned<Curve>>,
        /// The parameters of the spine at the regions.
        at: Option<Spanned<Vec<f64>>>,
        /// Where in v the regions stand: by a rule, or listed. A closed skin takes one more, for
        /// its return to the first region.
        parameters: Spanned<SectionPlaces> = Spanned::unplaced(SectionPlaces::By(SectionParameters::Places)),
        /// Whether the solid goes on from the last region to the first, as smooth there as anywhere.
        closed: bool = false,
        /// Whether borders are turned around, and seams moved, to run beside their neighbours.
        align: bool = true,
        /// The derivative by v along the borders of the first region: a vector, or a curve of vectors.
        start_tangent: Option<Spanned<SectionTangent>>,
        /// The derivative by v along those of the last region.
        end_tangent: Option<Spanned<SectionTangent>>,
        /// Whether the sides may swing out between regions.
        shape: Spanned<SectionShape> = Spanned::unplaced(SectionShape::Free),
        /// Whether points of equal parameter or of equal fraction of the length belong together;
        /// by "length", borders of uneven speed become cubic splines within the tolerance.
        pairing: SectionPairing = SectionPairing::Parameter,
        /// How far borders may move so that the sides have fewer knots along them.
        tolerance: Option<Spanned<Length>>,
    }
    example "volume(skin([region(circle((0, 0, 0), 2)), region(circle((0, 0, 3), 1))])) ~= 7*pi" => "true";
    example "len(skin([for z in 0..2: region(circle((0, 0, z), 2), holes = [circle((0, 0, z), 1)])]).faces)" => "4";
    example "volume(skin([region(circle((0, 0, 0), 2)), region(circle((0, 0, 3), 1))], start_tangent = (0, 0, 3), end_tangent = (0, 0, 3))) ~= 249/35*pi" => "true";
    example "gradient(r => volume(skin([region(circle((0, 0, 0), r)), region(circle((0, 0, 3), 1))])), 2) ~= 5*pi" => "true";
    refuses "skin([region(circle((0, 0), 2))])" => "E0401: a skin needs 2 sections or more, found 1";
    refuses "skin([region(circle((0, 0), 2)), region(circle((0, 0, 1), 2), holes = [circle((0, 0, 1), 1)])])" => "E0607: `sections[1]` has 1 hole, and the first region has 0";
    scene r#"
        region base = region(polyline((-2, -2), (2, -2), (2, 2), (-2, 2), closed = true), holes = [circle((0, 0), 1)])
        region neck = region(circle((0, 0, 5), 1), holes = [circle((0, 0, 5), 0.7)])
        solid funnel = skin([base, neck])
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<RealSolid> {
    let span = args.sections.span;
    let options = skin_options!(args);
    options.check()?;
    let regions = &args.sections.value;
    let borders = regions.iter().map(|region| region.plain().borders());
    let borders: Vec<Vec<NurbsCurve>> = borders.collect::<std::result::Result<_, _>>().at(span)?;
    let n_loops = borders.first().map_or(1, Vec::len);
    if let Some(odd) = borders.iter().position(|all| all.len() != n_loops) {
        let (own, span) = ctx.element(span, odd, "sections");
        let n_holes = borders[odd].len() - 1;
        let holes = if n_holes == 1 { "hole" } else { "holes" };
        let message =
            format!("{own} has {n_holes} {holes}, and the first region has {}", n_loops - 1);
        return Diagnostic::error(Code::Degenerate, span, message)
            .hint("each hole goes through all regions")
            .fail();
    }
    let mut sides = Vec::with_capacity(n_loops);
    for i in 0..n_loops {
        let sections: Vec<Curve> = borders.iter().map(|all| all[i].clone().into()).collect();
        sides.push(Arc::new(options.surface(ctx, sections, span)?));
    }
    let faces = sides.iter().map(|side| Face::whole(Arc::clone(side), ctx.tolerance));
    let faces: Vec<Face> = faces.collect::<std::result::Result<_, _>>().at(span)?;
    let made = Solid::capped(&faces, ctx.tolerance);
    let solid = of_walls(
        ctx,
        made,
        ctx.span,
        "holes go through all regions in their order: pair those that lie alike; sections whose walls cross want others between them",
    )?;
    with_walls(ctx, &options, (regions, span), &sides, Arc::new(solid))
}
