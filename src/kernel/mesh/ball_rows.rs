//! Rows of triangles over a sphere, nearly equilateral: each row has as many as its length takes.
//!
//! A grid has as many around the poles as around the equator, and triangles with a right angle: twice as many as are
//! needed. Rows have the same number of vertices as those before them, each halfway between two of these, as long as
//! their distances are about the side of the equilateral triangle; where they are not, the number changes, and the
//! strip before it is narrow enough for triangles of any slant.

use super::ball::Ball;

/// Distances in a row, in sides of the equilateral triangle: where a row has fewer or more vertices than the one before.
const LEAST_SIDE: f64 = 0.8;
const MOST_SIDE: f64 = 1.04;

/// The first row around a pole, in reaches from it.
const POLE_STEP: f64 = 1.45;

/// Layouts of which the one is taken whose last step is least of a rest: their steps differ by up to one in all.
const EVEN_ROUNDS: usize = 8;

/// Rounds in which the number of vertices of a row and its place settle.
const COUNT_ROUNDS: usize = 3;

/// Rows of a ball are no more than this many: what has more is no small mesh.
const MOST_ROWS: usize = 1 << 20;

/// A row of vertices: how far along the meridians, and how many; angles.
#[derive(Clone, Copy, Debug)]
pub(super) struct BallRow {
    pub(super) along: f64,
    pub(super) n: usize,
}

/// What rows begin and end with: a pole, or an edge whose longest leg this is.
#[derive(Clone, Copy, Debug)]
pub(super) enum RowEnd {
    Pole,
    Legs(f64),
}

/// Rows for triangles in circles of a radius, between these ends.
#[derive(Debug)]
pub(super) struct RowLayout<'a> {
    pub(super) ball: &'a Ball,
    pub(super) reach: f64,
    pub(super) ends: [RowEnd; 2],
}

impl RowLayout<'_> {
    /// Rows of which the last is about as far from the end as it may be: of some layouts with steps a little shorter.
    pub(super) fn rows(&self) -> Vec<BallRow> {
        let rows = self.rows_by(1.0);
        let part = 1.0 / (EVEN_ROUNDS * rows.len().max(1)) as f64;
        let rest = |rows: &[BallRow]| {
            let left = |row: &BallRow| self.ball.radius * (self.whole() - row.along);
            rows.last().map_or(0.0, |row| left(row) / self.step_to_end(*row))
        };
        let mut best = (rest(&rows), rows);
        for round in 1..EVEN_ROUNDS {
            let rows = self.rows_by(1.0 - part * round as f64);
            let rest = rest(&rows);
            if best.0 < rest {
                best = (rest, rows);
            }
        }
        best.1
    }

    fn whole(&self) -> f64 {
        self.ball.angles[self.ball.around.other()].whole()
    }

    fn rows_by(&self, factor: f64) -> Vec<BallRow> {
        let (radius, whole) = (self.ball.radius, self.whole());
        let mut rows: Vec<BallRow> = Vec::new();
        loop {
            let (along, n) = match rows.last() {
                Some(&row) => {
                    let left = radius * (whole - row.along);
                    if left <= self.step_to_end(row) || MOST_ROWS <= rows.len() {
                        return rows;
                    }
                    self.next(row, factor)
                }
                None => self.first(factor),
            };
            if whole <= along {
                return rows;
            }
            rows.push(BallRow { along, n });
        }
    }

    /// The side of the equilateral triangle.
    fn side(&self) -> f64 {
        3.0_f64.sqrt() * self.reach
    }

    /// The length of a row.
    fn length(&self, along: f64) -> f64 {
        self.ball.circle(along) * self.ball.angles[self.ball.around].whole()
    }

    /// How many vertices a row has if their distance is about so many sides.
    fn count(&self, along: f64, sides: f64) -> usize {
        ((self.length(along) / (sides * self.side())).ceil() as usize).max(1)
    }

    fn width(&self, row: BallRow) -> f64 {
        self.length(row.along) / row.n as f64
    }

    /// How high triangles may be over a base, the tip halfway.
    fn tall(&self, base: f64) -> f64 {
        self.reach + (self.reach * self.reach - 0.25 * base * base).max(0.0).sqrt()
    }

    /// How high triangles of any slant may be between these bases.
    fn slanted(&self, base: f64) -> f64 {
        (4.0 * self.reach * self.reach - base * base).max(0.1 * self.reach * self.reach).sqrt()
    }

    /// How far from the end the last row may be.
    fn step_to_end(&self, row: BallRow) -> f64 {
        let width = self.width(row);
        match self.ends[1] {
            RowEnd::Pole => self.tall(width).min(POLE_STEP * self.reach),
            RowEnd::Legs(leg) => self.slanted(width.max(leg)),
        }
    }

    fn first(&self, factor: f64) -> (f64, usize) {
        let step = match self.ends[0] {
            RowEnd::Pole => POLE_STEP * self.reach,
            RowEnd::Legs(leg) => self.slanted(leg.max(self.side())),
        };
        let along = factor * step / self.ball.radius;
        (along, self.count(along, MOST_SIDE))
    }

    fn next(&self, row: BallRow, factor: f64) -> (f64, usize) {
        let (radius, side, width) = (self.ball.radius, self.side(), self.width(row));
        // Where rows become longer the next one has the longer bases.
        let mut step = self.tall(width);
        let beyond = |step: f64| row.along + factor * step / radius;
        let same = |step: f64| self.width(BallRow { along: beyond(step), ..row });
        step = self.tall(width.max(same(step)));
        let wide = same(step);
        if LEAST_SIDE * side <= wide && wide <= MOST_SIDE * side {
            return (beyond(step), row.n);
        }
        let sides = if wide < width { MOST_SIDE } else { LEAST_SIDE };
        // A step that any slant allows is shorter, and its row another one.
        let (mut n, mut next) = (row.n, beyond(step));
        for _ in 0..COUNT_ROUNDS {
            n = self.count(next, sides);
            next = beyond(self.slanted(width.max(self.length(next) / n as f64)));
        }
        (next, n)
    }
}
