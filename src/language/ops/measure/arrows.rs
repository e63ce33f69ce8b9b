//! `arrows`: vectors along a curve or over a surface, as segments with heads.

use glam::DVec3;

use super::curve::{check_segments, sample_parameters};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Curve, GeomError, LocalError, LocalGeometry, NurbsCurve, Side, Surface},
    value::{At, Choice, Ctx, Geometry, Value, op, shortest},
};

op! {
    /// Arrows that show vectors of a curve or surface, each from its point.
    ///
    /// Along a curve `"derivative"`, `"second"` (derivative), `"tangent"`, `"normal"` and
    /// `"binormal"`; over a surface `"tangent_u"`, `"tangent_v"`, `"twist"` and `"normal"`. Tangents
    /// and normals are unit vectors. Where there is no such vector there is no arrow.
    ///
    /// An arrow is one polyline that starts at the point and ends at the tip: the segment, and around
    /// its head, a triangle two thirds as wide as long. The head lies in the osculating plane of the
    /// curve, that of a flat curve's arrow in the curve's plane, and in the tangent plane of the surface,
    /// if the vector does. A vector of length zero has no head; with `head = 0` none has, and
    /// arrows are segments.
    arrows in Measure -> Vec<NurbsCurve> {
        /// A curve or surface, or a list of them.
        g: Spanned<Geometry>,
        /// Which vectors.
        field: Spanned<VectorSource>,
        /// How many along a curve, and in each direction of a surface; two or more.
        samples: Spanned<usize> = Spanned::unplaced(20),
        /// Length of a unit vector.
        scale: f64 = 1.0,
        /// Length of the head as a part of the arrow's, from 0, which draws none, to 1.
        head: Spanned<f64> = Spanned::unplaced(0.2),
    }
    example "arrows(circle((0, 0), 2), \"normal\", samples = 5)[0].end" => "(1, 0, 0)";
    example "len(arrows(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), \"normal\", samples = 3))" => "9";
    example "arrows(line((0, 0), (3, 0)), \"derivative\", samples = 2)[0].points ~= [(0, 0), (3, 0), (2.4, 0.2), (2.4, -0.2), (3, 0)]" => "true";
    example "arrows(line((0, 0), (3, 0)), \"derivative\", samples = 2, head = 0)[0].points" => "[(0, 0, 0), (3, 0, 0)]";
    refuses "arrows(circle((0, 0), 2), \"twist\")" => "E0402: a curve has no field \"twist\"; it has derivative, second, tangent, normal, binormal";
    refuses "arrows(circle((0, 0), 2), \"normal\", samples = 1)" => "E0601: a curve is sampled at 2 places or more, found 1";
    refuses "arrows(circle((0, 0), 2), \"normal\", head = 2)" => "E0502: `head` is 2; a head is as long as 0 to 1 of its arrow";
    scene r#"
        curve c = bezier((0, 0), (1, 3), (3, -2), (4, 1))
        curves normals = arrows(c, "normal") with (color = "red")
    "#;
}

/// Vectors that a curve or surface has everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
enum VectorSource {
    Derivative,
    Second,
    Tangent,
    Normal,
    Binormal,
    TangentU,
    TangentV,
    Twist,
}

impl Choice for VectorSource {
    const WORDS: &'static [&'static str] = &[
        "derivative",
        "second",
        "tangent",
        "normal",
        "binormal",
        "tangent_u",
        "tangent_v",
        "twist",
    ];
    const MEANINGS: &'static [Self] = &[
        Self::Derivative,
        Self::Second,
        Self::Tangent,
        Self::Normal,
        Self::Binormal,
        Self::TangentU,
        Self::TangentV,
        Self::Twist,
    ];
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    let head = args.head.value;
    if !(0.0..=1.0).contains(&head) {
        let message =
            format!("`head` is {}; a head is as long as 0 to 1 of its arrow", shortest(head));
        return Diagnostic::error(Code::Domain, args.head.span, message).fail();
    }
    let mut vectors = Vec::new();
    gather(&args.g.value.0, &args, ctx, &mut vectors)?;
    let arrow = |(foot, vector, plane): (DVec3, DVec3, DVec3)| {
        let vector = args.scale * vector;
        let barb = HEAD_SLIMNESS * head * across(vector, plane, ctx.tolerance.angle);
        let (tip, neck) = (foot + vector, foot + (1.0 - head) * vector);
        match barb == DVec3::ZERO {
            true => NurbsCurve::line(foot, tip).at(args.g.span),
            false => {
                NurbsCurve::polyline(&[foot, tip, neck + barb, neck - barb, tip]).at(args.g.span)
            }
        }
    };
    vectors.into_iter().map(arrow).collect()
}

/// Half of the width of a head over its length.
const HEAD_SLIMNESS: f64 = 1.0 / 3.0;

/// A vector as long as `vector` and across it, in the plane with normal `plane` if that can be, else
/// level, else along y; zero for a vector of length zero.
fn across(vector: DVec3, plane: DVec3, angle: f64) -> DVec3 {
    let Some(way) = vector.try_normalize() else { return DVec3::ZERO };
    let mut sides = [plane, DVec3::Z, DVec3::X].map(|normal| normal.cross(way)).into_iter();
    let side = sides.find(|side| angle < side.length());
    side.map_or(DVec3::ZERO, |side| vector.length() * side.normalize_or_zero())
}

/// The vectors of all curves and surfaces in a value, with their points and the normals of the planes
/// of their heads, which are zero where there is no such plane.
fn gather(
    value: &Value,
    args: &Args,
    ctx: &Ctx<'_>,
    found: &mut Vec<(DVec3, DVec3, DVec3)>,
) -> Result<()> {
    let (span, field) = (args.g.span, args.field.value);
    match value {
        Value::Curve(curve) => {
            check_segments(args.samples, found.len() + 1, ctx)?;
            // Where it cannot be told the heads follow the curve.
            let flat = curve.plane_normal(ctx.tolerance).ok().flatten();
            for t in sample_parameters(curve, args.samples, ctx)? {
                let Some(vector) = along_curve(curve, t, field) else {
                    return misfit(args, "a curve", &VectorSource::WORDS[..5]);
                };
                let Some((foot, vector)) = existing(vector).at(span)? else { continue };
                let plane = flat.or_else(|| {
                    curve.local_at(t, Side::Right).and_then(|local| local.binormal()).ok()
                });
                found.push((foot, vector, plane.unwrap_or(DVec3::ZERO)));
            }
        }
        Value::Surface(surface) => {
            check_segments(args.samples, args.samples.value.max(found.len() + 1), ctx)?;
            let last = args.samples.value.saturating_sub(1);
            let [u_domain, v_domain] = [surface.domain_u(), surface.domain_v()];
            for u in u_domain.steps(last) {
                for v in v_domain.steps(last) {
                    let Some(vector) = over_surface(surface, [u, v], field) else {
                        let words = ["tangent_u", "tangent_v", "twist", "normal"];
                        return misfit(args, "a surface", &words);
                    };
                    let Some((foot, vector)) = existing(vector).at(span)? else { continue };
                    found.push((foot, vector, surface.normal_at(u, v).unwrap_or(DVec3::ZERO)));
                }
            }
        }
        Value::List(items) => {
            for item in items.iter() {
                gather(item, args, ctx, found)?;
            }
        }
        other => {
            let message = format!("curves and surfaces have vectors, found {}", other.phrase());
            return Diagnostic::error(Code::WrongKind, span, message).fail();
        }
    }
    Ok(())
}

/// A point with its vector.
type PlacedVector = std::result::Result<(DVec3, DVec3), GeomError>;

/// The vector at a parameter; `None` where curves have no such field.
fn along_curve(curve: &Curve, t: f64, field: VectorSource) -> Option<PlacedVector> {
    let derivative = |order: usize| curve.derivatives_at(t, order).map(|d| (d[0], d[order]));
    let local = |of: fn(&LocalGeometry) -> std::result::Result<DVec3, GeomError>| {
        let local = curve.local_at(t, Side::Right)?;
        Ok((local.point(), of(&local)?))
    };
    Some(match field {
        VectorSource::Derivative => derivative(1),
        VectorSource::Second => derivative(2),
        VectorSource::Tangent => local(|local| Ok(local.tangent())),
        VectorSource::Normal => local(LocalGeometry::normal),
        VectorSource::Binormal => local(LocalGeometry::binormal),
        VectorSource::TangentU | VectorSource::TangentV | VectorSource::Twist => return None,
    })
}

/// The vector at a place; `None` where surfaces have no such field.
fn over_surface(surface: &Surface, [u, v]: [f64; 2], field: VectorSource) -> Option<PlacedVector> {
    let partial = |order: [usize; 2]| {
        let derivatives = surface.derivatives_at(u, v, order[0] + order[1])?;
        Ok((derivatives.get(0, 0), derivatives.get(order[0], order[1])))
    };
    let at_point = |vector| Ok((surface.point_at(u, v)?, vector));
    Some(match field {
        VectorSource::TangentU => surface.tangent_u_at(u, v).and_then(at_point),
        VectorSource::TangentV => surface.tangent_v_at(u, v).and_then(at_point),
        VectorSource::Twist => partial([1, 1]),
        VectorSource::Normal => surface.normal_at(u, v).and_then(at_point),
        _ => return None,
    })
}

/// The vector, or nothing where the place is one that has none.
fn existing(vector: PlacedVector) -> std::result::Result<Option<(DVec3, DVec3)>, GeomError> {
    match vector {
        Err(
            GeomError::Local(LocalError::Straight { .. } | LocalError::UnboundedCurvature { .. })
            | GeomError::Local(
                LocalError::VanishingTangent { .. }
                | LocalError::NoTangentAlong { .. }
                | LocalError::NoNormal { .. },
            ),
        ) => Ok(None),
        vector => vector.map(Some),
    }
}

fn misfit(args: &Args, what: &str, words: &[&str]) -> Result<()> {
    let idx = VectorSource::MEANINGS.iter().position(|field| *field == args.field.value);
    let word = idx.map_or("", |idx| VectorSource::WORDS[idx]);
    let message = format!("{what} has no field \"{word}\"; it has {}", words.join(", "));
    Diagnostic::error(Code::BadChoice, args.field.span, message).fail()
}
