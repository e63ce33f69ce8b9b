//! `transform`: geometry under any affine map.

use glam::{DAffine3, DMat3, DVec3};

use super::apply;
use crate::{
    diag::{Result, Span, Spanned},
    kernel::{InputError, tolerance::VANISHING_RELATIVE},
    value::{At, Ctx, FromValue, Geometry, Length, Mismatch, Type, Value, op},
};

op! {
    /// Geometry under an affine map, given by three rows of four numbers.
    ///
    /// A row (a, b, c, d) makes the coordinate a·x + b·y + c·z + d; d may be a length.
    /// Piegl & Tiller, *The NURBS Book*, §6.3.
    transform in Transform -> Geometry {
        /// What is moved.
        g: Geometry,
        /// The rows for x, y and z; they must not flatten space.
        matrix: Spanned<Matrix>,
    }
    example "transform((1, 2, 3), [[0, -1, 0, 10], [1, 0, 0, 20], [0, 0, 2, 0]])" => "(8, 21, 6)";
    refuses "transform((1, 2, 3), [[1, 0, 0, 0], [0, 1, 0, 0]])" => "E0301: `transform`: `matrix` must be three rows of four numbers, found 2 rows";
    refuses "transform((1, 2, 3), [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0]])" => "E0607: the transformation flattens space: its determinant is zero";
    derivative shape;
    scene r#"
        let letter = polyline((0, 0), (0, 3), (2, 3), (2, 2), (1, 2), (1, 0), closed = true) with (hidden = true)
        curve upright = letter with (color = "gray")
        curve slanted = transform(letter, [[1, 0.5, 0, 3], [0, 1, 0, 0], [0, 0, 1, 0]]) with (color = "red")
    "#;
}

/// Three rows of four.
struct Matrix(DAffine3);

impl FromValue for Matrix {
    const TYPE: Type = Type::List(&Type::List(&Type::Length, 4), 3);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        let rows: Vec<Vec<Value>> = Vec::from_value(value, span)?;
        let counted = |what: String| Mismatch::new("three rows of four numbers", what);
        if rows.len() != 3 {
            return Err(counted(format!("{} rows", rows.len())));
        }
        let mut entries = [[0.0; 4]; 3];
        for (i, row) in rows.iter().enumerate() {
            if row.len() != 4 {
                return Err(counted(format!("{} numbers in row {i}", row.len())));
            }
            for (j, entry) in row.iter().enumerate() {
                let number = match j {
                    3 => Length::from_value(entry, span).map(|length| length.0),
                    _ => f64::from_value(entry, span),
                };
                entries[i][j] = number.map_err(|mismatch| mismatch.inside(j).inside(i))?;
            }
        }
        let [x, y, z] = entries.map(|row| DVec3::new(row[0], row[1], row[2]));
        let matrix3 = DMat3::from_cols(x, y, z).transpose();
        let translation = DVec3::from(entries.map(|row| row[3]));
        Ok(Self(DAffine3 { matrix3, translation }))
    }
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Geometry> {
    let map = args.matrix.value.0;
    let sizes = map.matrix3.to_cols_array_2d().map(|column| DVec3::from(column).length());
    let volume = sizes.iter().product::<f64>();
    // A volume that is no number is told where the coordinates are.
    if map.matrix3.determinant().abs() <= VANISHING_RELATIVE * volume {
        return Err(InputError::SingularTransform.into()).at(args.matrix.span);
    }
    apply(&args.g, &map, ctx.span)
}
