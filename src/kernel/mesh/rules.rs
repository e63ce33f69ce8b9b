//! What the cells over a piece of a surface must keep to.

use std::{ops::Range, sync::Arc};

use super::form::ParameterBoxes;
use crate::{Grid, tolerance::VANISHING_RELATIVE};

/// The rules of the pieces of a surface.
#[derive(Clone, Debug)]
pub(super) struct PieceRules {
    /// Those of the deviation; none in a plane.
    pub(super) bends: Option<Arc<Grid<BendRules>>>,
    /// Of the angle between normals; of that between directions in a plane in which cells may fold.
    pub(super) angle: Option<Arc<Grid<ParameterBoxes>>>,
    /// Of the longest edge, of the lines in planes, where there are such.
    pub(super) others: Arc<Vec<Grid<ParameterBoxes>>>,
}

/// The rules of a deviation: a cell keeps to `whole` or to `near`.
#[derive(Clone, Copy, Debug)]
pub(super) struct BendRules {
    /// The deviation at equal parameters.
    pub(super) whole: ParameterBoxes,
    /// The deviation along the normal, where cells see nothing fold.
    pub(super) near: Option<NormalRules>,
}

/// Rules of cells of which the deviation along the normal counts.
#[derive(Clone, Copy, Debug)]
pub(super) struct NormalRules {
    /// What bends along the normal.
    pub(super) lift: ParameterBoxes,
    /// Whether it bends to one side along u and to the other along v, and to which along u.
    pub(super) saddle: Option<BendingSide>,
    /// The rest, as much of it as the slope lifts.
    pub(super) slip: ParameterBoxes,
    /// The square of how far the normal turns, and how far it may turn at most; radians.
    pub(super) turn: ParameterBoxes,
    pub(super) most_turn: f64,
    /// How far points may slide along the surface.
    pub(super) slide: ParameterBoxes,
    /// What lines need at which the surface is broken.
    pub(super) line: ParameterBoxes,
}

/// The side to which something bends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum BendingSide {
    Along,
    Against,
}

fn fits(form: &ParameterBoxes, widths: [f64; 2]) -> bool {
    form.share(widths) <= 1.0 + VANISHING_RELATIVE
}

fn is_round(form: ParameterBoxes, widths: [f64; 2]) -> bool {
    form.round_share(widths) <= 1.0 + VANISHING_RELATIVE
}

impl PieceRules {
    /// Those that hold besides the deviation, at each place no more than the piece there makes them.
    pub(super) fn besides(&self) -> impl Iterator<Item = &Grid<ParameterBoxes>> {
        self.angle.iter().map(Arc::as_ref).chain(self.others.iter())
    }

    /// Widths of a cell that keeps to the rules of a piece, about as large as one may be; `ratio` is how many
    /// times longer a step along u is than one along v.
    pub(super) fn largest(&self, [i, j]: [usize; 2], ratio: f64) -> [f64; 2] {
        let widths = match &self.bends {
            Some(bends) => bends.row(i)[j].largest(ratio),
            None => [f64::INFINITY; 2],
        };
        self.besides().map(|forms| forms.row(i)[j].largest(ratio)).fold(widths, narrower)
    }

    /// Whether a cell of these widths keeps to the rules of all pieces that it touches, those in these rows and
    /// columns.
    pub(super) fn allow(
        &self,
        rows: &Range<usize>,
        columns: &Range<usize>,
        widths: [f64; 2],
    ) -> bool {
        self.allow_besides(rows, columns, widths)
            && self.bends.as_ref().is_none_or(|bends| {
                let pieces = rows.clone().flat_map(|i| &bends.row(i)[columns.clone()]);
                let joined = pieces.copied().reduce(|joined, other| joined.joined(&other));
                joined.is_none_or(|joined| joined.allow(bends, rows, columns, widths))
            })
    }

    /// Lengths and turns are those of a path.
    fn allow_besides(&self, rows: &Range<usize>, columns: &Range<usize>, widths: [f64; 2]) -> bool {
        self.besides().all(|forms| {
            rows.clone()
                .all(|i| forms.row(i)[columns.clone()].iter().all(|form| fits(form, widths)))
        })
    }

    /// The pieces touched by those cells of a row that break the rules.
    pub(super) fn faults(
        &self,
        rows: &Range<usize>,
        height: f64,
        steps: &[(f64, Range<usize>)],
        room: &mut Vec<BendRules>,
    ) -> Vec<Range<usize>> {
        // Cells of one row of pieces have this in common.
        if let Some(bends) = &self.bends {
            room.clear();
            room.extend_from_slice(bends.row(rows.start));
            for i in rows.start + 1..rows.end {
                for (joined, other) in room.iter_mut().zip(bends.row(i)) {
                    *joined = joined.joined(other);
                }
            }
        }
        let is_faulty = |(width, columns): &&(f64, Range<usize>)| {
            // Widths are those that cells of one piece may have.
            if rows.len() + columns.len() <= 2 {
                return false;
            }
            let widths = [height, *width];
            let is_allowed = self.allow_besides(rows, columns, widths)
                && self.bends.as_ref().is_none_or(|bends| {
                    let joined = room[columns.clone()].iter().copied();
                    let joined = joined.reduce(|joined, other| joined.joined(&other));
                    joined.is_none_or(|joined| joined.allow(bends, rows, columns, widths))
                });
            !is_allowed
        };
        steps.iter().filter(is_faulty).map(|(_, columns)| columns.clone()).collect()
    }
}

fn narrower([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a.min(c), b.min(d)]
}

impl BendRules {
    /// The rules over two pieces: which of them bends the cell most may differ from corner to corner, so that each
    /// second derivative counts where it is largest.
    fn joined(self, other: &Self) -> Self {
        let near = match (self.near, &other.near) {
            (Some(near), Some(other)) => Some(near.joined(other)),
            _ => None,
        };
        Self { whole: self.whole.joined(other.whole), near }
    }

    /// Whether a cell keeps to the rules that are joined here of the pieces in these rows and columns; or all second
    /// derivatives count where together they bend it most in any direction.
    fn allow(
        &self,
        pieces: &Grid<Self>,
        rows: &Range<usize>,
        columns: &Range<usize>,
        widths: [f64; 2],
    ) -> bool {
        let keeps = |forms: &[ParameterBoxes]| forms.iter().all(|form| fits(form, widths));
        if keeps(&[self.whole]) || self.near.is_some_and(|near| keeps(&near.forms())) {
            return true;
        }
        let all = || rows.clone().flat_map(|i| &pieces.row(i)[columns.clone()]);
        all().all(|rules| is_round(rules.whole, widths))
            || self.near.is_some_and(|near| keeps(&near.others()))
                && all()
                    .filter_map(|rules| rules.near)
                    .all(|near| is_round(near.lift.and(near.slip), widths))
    }

    fn largest(&self, ratio: f64) -> [f64; 2] {
        let widths = self.whole.largest(ratio);
        let Some(near) = &self.near else { return widths };
        let sizes = near.forms().map(|form| form.largest(ratio));
        let others = sizes.into_iter().fold([f64::INFINITY; 2], narrower);
        if widths[0] * widths[1] < others[0] * others[1] { others } else { widths }
    }
}

impl NormalRules {
    fn joined(self, other: &Self) -> Self {
        Self {
            lift: self.lift.joined(other.lift),
            saddle: self.saddle.filter(|_| self.saddle == other.saddle),
            slip: self.slip.joined(other.slip),
            turn: self.turn.joined(other.turn),
            most_turn: self.most_turn.min(other.most_turn),
            slide: self.slide.joined(other.slide),
            line: self.line.joined(other.line),
        }
    }

    /// All that a cell must keep to.
    ///
    /// Where the surface bends to one side along u and to the other along v, what is between it and
    /// a triangle is convex along u and concave along v, so that it is largest on the sides of the
    /// triangle; along one of these the two take away from one another.
    pub(super) fn forms(&self) -> [ParameterBoxes; 5] {
        let Self { lift, slip, .. } = *self;
        let both = lift.and(slip);
        let [turn, slide, line] = self.others();
        if self.saddle.is_none() {
            return [both, ParameterBoxes::NONE, turn, slide, line];
        }
        [
            ParameterBoxes { vv: slip.vv, ..both },
            ParameterBoxes { uu: slip.uu, ..both },
            turn,
            slide,
            line,
        ]
    }

    fn others(&self) -> [ParameterBoxes; 3] {
        [self.turn.scaled(1.0 / (self.most_turn * self.most_turn)), self.slide, self.line]
    }
}
