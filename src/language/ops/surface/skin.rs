//! `skin`: the surface through sections.

use super::{
    section::{SectionPairing, SectionPlaces, SectionShape, SectionTangent, SkinSection},
    skin_options::{SkinOptions, skin_options},
};
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, GeomError, NurbsSurface, SectionParameters},
    value::{At, Ctx, Length, op},
};

op! {
    /// Surface through sections: u along them, v from one to the next.
    ///
    /// Sections of other degrees and knots are made compatible, exactly; rational ones are skinned
    /// in homogeneous space after their weights are normalised, so that a common factor of a
    /// section's weights changes nothing. A section may be a point where the surface begins or
    /// ends. Sections that run against their neighbour are reversed, closed ones as the way between
    /// them passes both, and seams of closed ones that are far from their neighbour's are moved. Where closed sections have corners, such as the tails
    /// of aerofoils, all seams go to corners that belong together, smooth ones beside them;
    /// neighbours with as many corners have them at the same parameters, so that edges of the
    /// surface run through them. The sections stand at parameters averaged from
    /// the distances of their control points, over knots averaged from these; of sections of unlike weights from distances
    /// in homogeneous space about the first control point, in which a weight counts as a length of the document's unit,
    /// or with "places" from those of their places, whatever the unit. With a spine the
    /// derivatives by v at the sections point along its tangents, and v is its parameter. Where
    /// weights between rational sections do not stay positive, a warning says so; with a tolerance,
    /// or where they would vanish, these sections become splines within it.
    /// "monotone" keeps each coordinate of the control points between its values at two
    /// neighbouring sections, so that nothing swings out, with C1 where that needs it.
    /// Piegl & Tiller, *The NURBS Book*, §10.3.
    skin | loft in Surface -> NurbsSurface {
        /// The sections in order, two or more: curves, and points at the ends.
        sections: Spanned<Vec<SkinSection>>,
        /// The degree along v, from 1; fewer sections than degree + 1 lower it.
        degree: Spanned<usize> = Spanned::unplaced(3),
        /// A curve whose tangents the surface takes at the sections; degree 2 or 3.
        spine: Option<Spanned<Curve>>,
        /// The parameters of the spine at the sections.
        at: Option<Spanned<Vec<f64>>>,
        /// Where in v the sections stand: by a rule, or listed. A closed skin takes one more, for
        /// its return to the first section.
        parameters: Spanned<SectionPlaces> = Spanned::unplaced(SectionPlaces::By(SectionParameters::Average)),
        /// Whether the surface goes on from the last section to the first, as smooth there as
        /// anywhere.
        closed: bool = false,
        /// Whether sections are turned around, and seams moved, to run beside their neighbours.
        align: bool = true,
        /// The derivative by v along the first section: a vector, or a curve of vectors.
        start_tangent: Option<Spanned<SectionTangent>>,
        /// The derivative by v along the last section.
        end_tangent: Option<Spanned<SectionTangent>>,
        /// Whether the surface may swing out between sections.
        shape: Spanned<SectionShape> = Spanned::unplaced(SectionShape::Free),
        /// Whether points of equal parameter or of equal fraction of the length belong together;
        /// by "length", sections of uneven speed become cubic splines within the tolerance.
        pairing: SectionPairing = SectionPairing::Parameter,
        /// How far sections may move so that the surface has fewer knots along them.
        tolerance: Option<Spanned<Length>>,
    }
    example "skin([line((0, 0), (1, 0)), line((0, 1, 1), (1, 1, 1)), line((0, 2), (1, 2))])(0.5, 0.5)" => "(0.5, 1, 1)";
    example "skin([for z in 0..3: circle((0, 0, z), 1 + z)]).degree_v" => "3";
    example "skin([(0, 0, 0), circle((0, 0, 1), 1), circle((0, 0, 3), 1)])(0.3, 0)" => "(0, 0, 0)";
    refuses "skin([line((0, 0), (1, 0))])" => "E0401: a skin needs 2 sections or more, found 1";
    refuses "skin([line((0, 0), (1, 0)), (0, 1), line((0, 2), (1, 2))])" => "E0607: `(0, 1)` is a point; only the first and the last may be one";
    refuses "skin([line((0, 0), (1, 0)), line((0, 0), (1, 0)), line((0, 2), (1, 2))])" => "E0607: `sections[0]` and `sections[1]` are at one place";
    derivative shape;
    settling super::moving::SKIN;
    scene r#"
        curves rings = [circle((0, 0, 0), 2), circle((0, 0, 2), 1), circle((0, 0, 4), 1.5), circle((0, 0, 6), 0.5)] with (color = "red")
        surface s = skin(rings) with (color = "lightgray")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let options = skin_options!(args);
    options.check()?;
    let span = args.sections.span;
    let sections = args.sections.value.into_iter().map(SkinSection::curve);
    let sections: std::result::Result<Vec<Curve>, GeomError> = sections.collect();
    options.surface(ctx, sections.at(span)?, span)
}
