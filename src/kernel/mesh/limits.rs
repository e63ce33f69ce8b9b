//! What a mesh of a surface is asked for, and the cells that fulfil it.
//!
//! A triangle over a box of parameters of widths a and b is no further from the surface than
//! `(a²·|Suu| + 2ab·|Suv| + b²·|Svv|) / 8` at equal parameters (Filip, Magedson & Markot 1986), which
//! is one limit of the boxes. Over a surface that is flat enough for its mean normal to see all of
//! it, only what lies along that normal counts, and of the rest as much as the slope lifts: points
//! that a step along the surface brings to one another are not far. Another limit is the length of
//! a box's diagonal, a third how far the normal turns over it.

use std::f64::consts::PI;

use glam::DVec3;

use super::{
    bend::{Bend, Bends},
    form::Form,
};
use crate::kernel::{
    GeomError, Grid, NurbsSurface, Tolerance,
    tolerance::{BORDER_SHARE, EXACT_RELATIVE, FLAT_SLOPE, VANISHING_RELATIVE},
};

/// Places along a piece at which its normals are compared, as fractions of it.
const PLACES: [f64; 3] = [0.01, 0.5, 0.99];

/// What triangles are asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshLimits {
    /// No point of the mesh is further from the surface, none of the surface from the mesh.
    pub tolerance: f64,
    /// Normals at the corners of a triangle turn no further from one another; radians.
    pub angle: f64,
    /// No edge is longer.
    pub max_edge: f64,
    /// Corners and edges of surfaces that are no further apart are one, as far as the tolerance
    /// leaves room for that.
    pub weld: f64,
}

impl MeshLimits {
    /// A tolerance without other limits.
    #[must_use]
    pub const fn within(tolerance: f64) -> Self {
        Self { tolerance, angle: PI, max_edge: f64::INFINITY, weld: Tolerance::DEFAULT.distance }
    }

    /// # Errors
    /// [`GeomError::NotPositive`] for a limit that allows nothing.
    pub(super) fn check(&self) -> Result<(), GeomError> {
        let is_finite = self.tolerance.is_finite();
        let limits = [
            ("the tolerance", if is_finite { self.tolerance } else { f64::NAN }),
            ("the angle", self.angle),
            ("the longest edge", self.max_edge),
        ];
        match limits.into_iter().find(|&(_, got)| got <= 0.0 || got.is_nan()) {
            Some((what, _)) if what == "the tolerance" => {
                Err(GeomError::NotPositive { what, got: self.tolerance })
            }
            Some((what, got)) => Err(GeomError::NotPositive { what, got }),
            None => Ok(()),
        }
    }

    /// Whether the turn of the normal is limited at all.
    pub(super) fn limits_angle(&self) -> bool {
        self.angle < PI
    }
}

/// The limits of the boxes over each piece of a surface.
#[derive(Debug)]
pub(super) struct Limits {
    /// Where the pieces along u and along v begin and end.
    pub(super) ends: [Vec<f64>; 2],
    /// Each a limit for every piece.
    layers: Vec<Grid<Form>>,
    /// How many times longer a step along u is than one along v.
    ratios: Grid<f64>,
}

impl Limits {
    /// Those of a surface, with `lines` of constant u and of constant v that keep to the tolerance
    /// on their own; the angle is that of the wanted over `sharpness`.
    pub(super) fn new(
        surface: &NurbsSurface,
        wanted: &MeshLimits,
        lines: [&[f64]; 2],
        sharpness: f64,
    ) -> Self {
        let bends = Bends::of(surface);
        let per_tolerance = 1.0 / (8.0 * wanted.tolerance);
        let whole = bends.pieces.map(|bend| form(bend.second).scaled(per_tolerance));
        let ratios = bends.pieces.map(ratio);
        let mut layers = vec![whole];
        if let Some(flat) = flat_layers(&bends, per_tolerance)
            && n_cells(&flat, &ratios, &bends.ends) < n_cells(&layers, &ratios, &bends.ends)
        {
            layers = flat;
            layers.push(line_layer(&bends, lines, per_tolerance / BORDER_SHARE));
        }
        if wanted.max_edge.is_finite() {
            let per_edge = 1.0 / (wanted.max_edge * wanted.max_edge);
            layers.push(bends.pieces.map(|bend| diagonal(bend).scaled(per_edge)));
        }
        if wanted.limits_angle() {
            let chord = 2.0 * libm::sin(0.5 * wanted.angle) / sharpness;
            layers.push(turns(surface, &bends.ends).map(|form| form.scaled(1.0 / (chord * chord))));
        }
        Self { ends: bends.ends, layers, ratios }
    }

    /// Whether a box keeps to the limits of all pieces that it touches.
    pub(super) fn allow(&self, box_of: [[f64; 2]; 2]) -> bool {
        let [rows, columns] = [0, 1].map(|along| {
            let (ends, [low, high]) = (&self.ends[along], box_of[along]);
            let first = ends.partition_point(|&t| t <= low).saturating_sub(1);
            let behind = ends.partition_point(|&t| t < high).min(ends.len() - 1);
            first.min(behind.saturating_sub(1))..behind.max(first + 1).min(ends.len() - 1)
        });
        let widths = box_of.map(|[low, high]| high - low);
        let fits = |form: Form| form.share(widths) <= 1.0 + VANISHING_RELATIVE;
        self.layers.iter().all(|layer| {
            rows.clone().all(|i| layer.row(i)[columns.clone()].iter().all(|&form| fits(form)))
        })
    }

    /// Widths of cells for each piece along u and along v, so that every cell keeps to every limit.
    pub(super) fn widths(&self) -> [Vec<f64>; 2] {
        let wholes = self.ends.each_ref().map(|ends| ends[ends.len() - 1] - ends[0]);
        let (n, m) = (self.ratios.n_rows(), self.ratios.n_columns());
        let mut widths = [vec![wholes[0]; n], vec![wholes[1]; m]];
        for layer in &self.layers {
            for i in 0..n {
                for j in 0..m {
                    let [a, b] = layer.get(i, j).largest(self.ratios.get(i, j));
                    widths[0][i] = widths[0][i].min(a);
                    widths[1][j] = widths[1][j].min(b);
                }
            }
        }
        // Take up what one direction leaves to the other.
        for along in [0, 1, 0, 1] {
            for i in 0..widths[along].len() {
                let mut widest = wholes[along];
                for layer in &self.layers {
                    for (j, &across) in widths[1 - along].iter().enumerate() {
                        let form = match along {
                            0 => layer.get(i, j),
                            _ => layer.get(j, i).swapped(),
                        };
                        widest = widest.min(form.widest(across));
                    }
                }
                widths[along][i] = widest.max(widths[along][i]);
            }
        }
        widths
    }
}

/// The limits beside lines that keep to the tolerance on their own.
fn line_layer(bends: &Bends, lines: [&[f64]; 2], per_tolerance: f64) -> Grid<Form> {
    let is_beside = |along: usize, i: usize| {
        let ends = &bends.ends[along][i..=i + 1];
        lines[along].iter().any(|&line| ends[0] <= line && line <= ends[1])
    };
    let [beside_u, beside_v] = [0, 1].map(|along| -> Vec<bool> {
        (0..bends.ends[along].len() - 1).map(|i| is_beside(along, i)).collect()
    });
    Grid::from_fn(beside_u.len(), beside_v.len(), |i, j| {
        let [uu, _, vv] = bends.pieces.get(i, j).second;
        let of = |is_beside: bool, bend: f64| if is_beside { bend } else { 0.0 };
        form([of(beside_v[j], uu), 0.0, of(beside_u[i], vv)]).scaled(per_tolerance)
    })
}

fn form([uu, uv, vv]: [f64; 3]) -> Form {
    Form { uu, uv, vv }
}

fn ratio(bend: &Bend) -> f64 {
    let ratio = bend.middle[0].length() / bend.middle[1].length();
    if ratio.is_normal() { ratio } else { 1.0 }
}

/// About how many cells the limits ask for.
fn n_cells(layers: &[Grid<Form>], ratios: &Grid<f64>, ends: &[Vec<f64>; 2]) -> f64 {
    let mut sum = 0.0;
    for (i, u) in ends[0].windows(2).enumerate() {
        for (j, v) in ends[1].windows(2).enumerate() {
            let sizes = layers.iter().map(|layer| {
                let [a, b] = layer.get(i, j).largest(ratios.get(i, j));
                (u[1] - u[0]) / a * ((v[1] - v[0]) / b)
            });
            sum += sizes.fold(0.0, f64::max);
        }
    }
    sum
}

/// The square of the length of a box's diagonal.
fn diagonal(bend: &Bend) -> Form {
    let [along_u, along_v, ..] = bend.middle;
    let ([u, v], [spread_u, spread_v]) = (bend.first, bend.spread);
    let product = along_u.dot(along_v).abs()
        + spread_u * along_v.length()
        + spread_v * along_u.length()
        + spread_u * spread_v;
    Form { uu: u * u, uv: product.min(u * v), vv: v * v }
}

/// The limits over a surface that its mean normal sees all of, with slopes of little height; none
/// over another.
///
/// A step along the surface by the part of the deviation that lies in the plane of that normal
/// changes the height by no more than the slope times this. The step exists where both the
/// surface and the triangles are over that plane without folds: where the directions of Su, and
/// those of Sv, do not turn so far that one of the former is along one of the latter, over all of
/// the surface, or of a plane over each box.
fn flat_layers(bends: &Bends, per_tolerance: f64) -> Option<Vec<Grid<Form>>> {
    let normal = bends.normal?;
    let size = bends.pieces.iter().map(|bend| bend.first[0].max(bend.first[1])).fold(0.0, f64::max);
    let is_plane = bends.pieces.iter().all(|bend| {
        let lifts = [0, 1].map(|i| normal.dot(bend.middle[i]).abs() + bend.lift_spread[i]);
        lifts[0].max(lifts[1]) <= EXACT_RELATIVE * size
    });
    let slope = slope(bends);
    if let Some(slope) = slope.filter(|&slope| slope <= FLAT_SLOPE) {
        let flat = bends.pieces.map(|bend| {
            let bends: [f64; 3] = std::array::from_fn(|i| bend.lift[i] + slope * bend.second[i]);
            form(bends).scaled(per_tolerance)
        });
        return Some(vec![flat]);
    }
    let faces = |bend: &Bend| 0.0 < normal.dot(bend.middle[0].cross(bend.middle[1]));
    if !is_plane || !bends.pieces.iter().all(faces) {
        return None;
    }
    let flat = bends.pieces.map(|bend| form(bend.lift).scaled(per_tolerance));
    Some(vec![flat, bends.pieces.map(unfolded)])
}

/// An upper bound of the slope over the plane of the mean normal; none where something folds.
fn slope(bends: &Bends) -> Option<f64> {
    let normal = bends.normal?;
    let along_plane = |vector: DVec3| vector - normal * normal.dot(vector);
    let x = along_plane(bends.pieces.as_slice().first()?.middle[0]);
    let y = normal.cross(x);
    let mut directions = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for bend in &bends.pieces {
        for (i, range) in directions.iter_mut().enumerate() {
            let along = bend.middle[i];
            let reach = bend.spread[i] / along_plane(along).length();
            if 1.0 <= reach || reach.is_nan() {
                return None;
            }
            let (angle, spread) = (libm::atan2(along.dot(y), along.dot(x)), libm::asin(reach));
            *range = [range[0].min(angle - spread), range[1].max(angle + spread)];
        }
    }
    let [u, v] = directions;
    let crossing = [v[0] - u[1], v[1] - u[0]];
    if crossing[0] <= 0.0 || PI <= crossing[1] {
        return None;
    }
    let sine = libm::sin(crossing[0]).min(libm::sin(crossing[1]));
    let mut steepest = 0.0_f64;
    for bend in &bends.pieces {
        let lengths = [0, 1].map(|i| along_plane(bend.middle[i]).length());
        let lifts = [0, 1].map(|i| normal.dot(bend.middle[i]).abs() + bend.lift_spread[i]);
        let most = [0, 1].map(|i| lengths[i] + bend.spread[i]);
        let least = [0, 1].map(|i| lengths[i] - bend.spread[i]);
        let slope = (most[0] * lifts[1] + most[1] * lifts[0]) / (least[0] * least[1] * sine);
        steepest = steepest.max(slope);
    }
    Some(steepest).filter(|slope| slope.is_finite())
}

/// The boxes over which neither Su nor Sv turns by half of the angle between them.
fn unfolded(bend: &Bend) -> Form {
    let [along_u, along_v, uu, uv, vv] = bend.middle;
    let angle = libm::atan2(along_u.cross(along_v).length(), along_u.dot(along_v));
    let room = 0.5 * angle.min(PI - angle);
    let turn = |along: DVec3, bend: DVec3| along.cross(bend).length() / along.length_squared();
    let per_u = turn(along_u, uu).max(turn(along_v, uv)) / room;
    let per_v = turn(along_u, uv).max(turn(along_v, vv)) / room;
    Form { uu: per_u * per_u, uv: per_u * per_v, vv: per_v * per_v }
}

/// The square of the distance between unit normals over a box, by their differences between
/// places of each piece.
fn turns(surface: &NurbsSurface, ends: &[Vec<f64>; 2]) -> Grid<Form> {
    let [us, vs] = ends.each_ref().map(|ends| -> Vec<f64> {
        let at = |pair: &[f64]| PLACES.map(|place| pair[0] + (pair[1] - pair[0]) * place);
        ends.windows(2).flat_map(at).collect()
    });
    let normals = surface.samples_on_grid(&us, &vs).normals;
    let n = PLACES.len();
    Grid::from_fn(ends[0].len() - 1, ends[1].len() - 1, |i, j| {
        let mut most = Form::NONE;
        for k in 0..n - 1 {
            for l in 0..n - 1 {
                let at = |dk: usize, dl: usize| normals.get(i * n + k + dk, j * n + l + dl);
                let (du, dv) =
                    (us[i * n + k + 1] - us[i * n + k], vs[j * n + l + 1] - vs[j * n + l]);
                let turns_u = [0, 1].map(|dl| (at(1, dl) - at(0, dl)) / du);
                let turns_v = [0, 1].map(|dk| (at(dk, 1) - at(dk, 0)) / dv);
                for turn_u in turns_u {
                    for turn_v in turns_v {
                        most.uu = most.uu.max(turn_u.length_squared());
                        most.vv = most.vv.max(turn_v.length_squared());
                        most.uv = most.uv.max(turn_u.dot(turn_v).abs());
                    }
                }
            }
        }
        most
    })
}
