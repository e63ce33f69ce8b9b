//! `box`: the six sides of a box.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::NurbsSurface,
    value::{At, Ctx, FromValue, Mismatch, Type, Value, op, shortest},
};

op! {
    /// Six flat sides of a box along the axes, in the order lower x, upper x, lower y, upper y,
    /// lower z, upper z.
    ///
    /// Each is on 0..1 in both directions, with Su × Sv outward.
    box in Surface -> Vec<NurbsSurface> {
        /// The corner with the lowest coordinates.
        corner: DVec3,
        /// Its extents along x, y and z as a point, all positive; one number makes a cube.
        size: Spanned<Extents>,
    }
    example "len(box((0, 0), (4, 3, 2)))" => "6";
    example "box((0, 0, 1), (4, 3, 2))[5](0.5, 0.5)" => "(2, 1.5, 3)";
    example "[for side in box((0, 0), 1): normal(side, 0.5, 0.5)]" => "[(-1, 0, 0), (1, 0, 0), (0, -1, 0), (0, 1, 0), (0, 0, -1), (0, 0, 1)]";
    refuses "box((0, 0), (4, 3, 0))" => "E0607: the size along z must be positive, found 0";
    derivative affine;
}

/// The extent along each axis.
struct Extents(DVec3);

impl FromValue for Extents {
    const TYPE: Type = Type::OneOf(&[Type::Length, Type::Point]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Point(extents) => Ok(Self(*extents)),
            Value::Number(_) => {
                crate::value::Length::from_value(value, span).map(|edge| Self(DVec3::splat(edge.0)))
            }
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsSurface>> {
    let (corner, size) = (args.corner, args.size.value.0);
    for (axis, extent) in ["x", "y", "z"].into_iter().zip(size.to_array()) {
        if extent <= 0.0 {
            let found = shortest(extent);
            let message = format!("the size along {axis} must be positive, found {found}");
            return Diagnostic::error(Code::Degenerate, args.size.span, message)
                .hint("`box(corner, size)` takes the corner with the lowest coordinates")
                .fail();
        }
    }
    let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| axis * size);
    // From each corner two edges whose product points outward.
    let sides = [
        (corner, z, y),
        (corner + x, y, z),
        (corner, x, z),
        (corner + y, z, x),
        (corner, y, x),
        (corner + z, x, y),
    ];
    let side = |(at, u, v): (DVec3, DVec3, DVec3)| {
        NurbsSurface::bilinear(at, at + v, at + u, at + u + v).at(ctx.span)
    };
    sides.into_iter().map(side).collect()
}
