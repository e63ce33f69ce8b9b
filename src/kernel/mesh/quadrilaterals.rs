//! Pairs of triangles that are a cell of the parameters, as quadrilaterals.
//!
//! A triangle with two sides along the parameters is half a cell; the other half has the third side
//! too. A side may lean from the lines a little, as those do that end in the vertices of an edge. What is left over stays triangles: at poles, and where
//! the vertices of an edge are others than those of the lines inside.

use std::collections::HashMap;

use glam::DVec2;

use super::Mesh;
use crate::tolerance::LEAN_SHARE;

/// A triangle with two sides along the parameters.
struct HalfQuadrilateral {
    triangle: u32,
    /// The corner between these sides, and the way from there to the one of the cell across from it.
    corner: DVec2,
    far: DVec2,
    /// The vertices of the third side, the lesser first, and whether the triangle runs along it so.
    diagonal: [u32; 2],
    is_forward: bool,
}

impl Mesh {
    /// The same with halves of a cell of the parameters as one face, where the first of them stood.
    #[must_use]
    pub fn with_quadrilaterals(mut self) -> Self {
        let mut waiting: HashMap<[u32; 2], HalfQuadrilateral> = HashMap::new();
        let mut partners: Vec<Option<u32>> = vec![None; self.n_triangles()];
        let mut is_second = vec![false; partners.len()];
        for triangle in 0..self.n_triangles() as u32 {
            let Some(half) = self.half_of_cell(triangle) else { continue };
            match waiting.remove(&half.diagonal) {
                Some(other) if half.is_beside(&other) => {
                    partners[other.triangle as usize] = Some(triangle);
                    is_second[triangle as usize] = true;
                }
                _ => {
                    waiting.insert(half.diagonal, half);
                }
            }
        }
        let (mut triangles, mut sizes) = (Vec::with_capacity(partners.len()), Vec::new());
        for (first, partner) in partners.iter().enumerate().filter(|(idx, _)| !is_second[*idx]) {
            triangles.push(self.triangles[first]);
            triangles.extend(partner.map(|second| self.triangles[second as usize]));
            sizes.push(1 + u32::from(partner.is_some()));
        }
        self.triangles = triangles;
        self.of_runs(sizes)
    }

    fn half_of_cell(&self, triangle: u32) -> Option<HalfQuadrilateral> {
        let corners = self.triangles[triangle as usize];
        (0..3).find_map(|k| {
            let [first, next, last] = [0, 1, 2].map(|i| corners[(k + i) % 3]);
            let place = |vertex: u32| self.uvs.get(vertex as usize).copied();
            let (corner, a, b) = (place(first)?, place(next)?, place(last)?);
            let (a, b) = (a - corner, b - corner);
            let is_along = |one: f64, other: f64| one.abs() <= LEAN_SHARE * other.abs();
            let far = match () {
                () if is_along(a.x, b.x) && is_along(b.y, a.y) => DVec2::new(b.x, a.y),
                () if is_along(a.y, b.y) && is_along(b.x, a.x) => DVec2::new(a.x, b.y),
                () => return None,
            };
            let is_wide = far.x.abs() > 0.0 && far.y.abs() > 0.0;
            let diagonal = [next.min(last), next.max(last)];
            is_wide.then_some(HalfQuadrilateral {
                triangle,
                corner,
                far,
                diagonal,
                is_forward: next < last,
            })
        })
    }
}

impl HalfQuadrilateral {
    /// Whether both make a cell, each the half across from the other.
    fn is_beside(&self, other: &Self) -> bool {
        let is_across = |one: &Self, other: &Self| {
            let miss = (one.corner + one.far - other.corner).abs();
            miss.cmple(LEAN_SHARE * one.far.abs()).all()
        };
        self.is_forward != other.is_forward && is_across(self, other) && is_across(other, self)
    }
}
