//! `centroid` of surfaces, or of what they enclose.

use glam::DVec3;

use super::{MassOf, RealSurfaces, Together, mass, volume::varying_volume};
use crate::{
    diag::{Result, Spanned},
    kernel::VariedSurface,
    value::{Ctx, Real, Vector, op},
};

op! {
    /// Centre of gravity of what closed surfaces enclose, or of the surfaces themselves.
    ///
    /// Of the volume the surfaces must close, as for `volume`; of the area they need not.
    /// Mirtich, *Fast and accurate computation of polyhedral mass properties*, JGT 1 (1996).
    centroid in Measure -> Vector {
        /// The surface, or a list of surfaces.
        s: Spanned<Together<RealSurfaces>>,
        /// What is heavy: the inside or the skin.
        of: MassOf = MassOf::Volume,
    }
    example "centroid(box((0, 0, 0), (1, 2, 3)))" => "(0.5, 1, 1.5)";
    example "centroid(bilinear((0, 0), (0, 2), (3, 0), (3, 2)), of = \"area\") ~= (1.5, 1)" => "true";
    example "gradient(h => centroid(box((0, 0, 0), (1, 2, h))).z, 3) ~= 0.5" => "true";
    refuses "centroid(plane_patch((0, 0), (1, 0), (0, 1)))" => "E0612: the surfaces do not close: edge \"u0\" is 0.4896 from the nearest other edge, at (0, 0.5104, 0)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let Spanned { value: Together(surfaces), span } = &args.s;
    let mass = mass(&surfaces.plain, *span, (args.of, "centroid"), ctx)?;
    let center = mass.centroid;
    if !surfaces.vary() {
        return Ok(Vector::Plain(center));
    }
    let volume = match args.of {
        MassOf::Area => None,
        MassOf::Volume => Some(varying_volume(surfaces, *span, "centroid", ctx)?),
    };
    // What the integral of S − C grows by, with the centre C held, is by how much C moves times what is heavy.
    let mut along = |axis: DVec3| {
        let slopes = |idx: usize, varied: &VariedSurface| {
            let (mut found, share) = match &volume {
                None => (varied.area_moment_slopes(center, axis)?, 1.0 / mass.amount),
                Some(volume) => {
                    let found = varied.volume_moment_slopes(volume.about, center, axis)?;
                    (found, volume.signs[idx] / volume.amount)
                }
            };
            found.slopes.iter_mut().for_each(|slope| *slope *= share);
            Ok(found)
        };
        surfaces.with_slopes(center.dot(axis), "centroid", ctx, slopes)
    };
    let coordinates: [Real; 3] = [along(DVec3::X)?, along(DVec3::Y)?, along(DVec3::Z)?];
    Ok(Vector::new(coordinates))
}
