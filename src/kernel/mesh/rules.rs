//! What the cells over a piece of a surface must keep to.

use super::form::ParameterBoxes;
use crate::tolerance::VANISHING_RELATIVE;

/// The rules of a piece: a cell keeps to all of `also`, and to `whole` or to `near`.
#[derive(Clone, Copy, Debug)]
pub(super) struct CellRules {
    /// The deviation at equal parameters.
    pub(super) whole: ParameterBoxes,
    /// The deviation along the normal, where cells see nothing fold.
    pub(super) near: Option<NormalRules>,
    /// Of the longest edge, of the angle, of planes, of the lines in these.
    pub(super) also: [ParameterBoxes; 4],
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

/// The rules of the pieces of a surface without those that allow everything, one behind the other: to be gone through
/// many times.
#[derive(Debug)]
pub(super) struct CompactRules {
    n_columns: usize,
    pieces: Vec<CompactPiece>,
    forms: Vec<ParameterBoxes>,
}

/// Where among the forms those of a piece are: that of the whole, those along the normal, and those that hold besides.
#[derive(Clone, Copy, Debug)]
struct CompactPiece {
    first: usize,
    n_near: Option<usize>,
    n_also: usize,
}

impl CompactRules {
    /// Those of pieces in rows of `n_columns`.
    pub(super) fn new(n_columns: usize, all: impl Iterator<Item = CellRules>) -> Self {
        let (mut pieces, mut forms) = (Vec::new(), Vec::new());
        let counts = |form: &ParameterBoxes| *form != ParameterBoxes::NONE;
        for rules in all {
            let first = forms.len();
            forms.push(rules.whole);
            let n_near = rules.near.map(|near| {
                forms.extend(near.forms().into_iter().filter(counts));
                forms.len() - first - 1
            });
            let n_before = forms.len();
            forms.extend(rules.also.into_iter().filter(counts));
            pieces.push(CompactPiece { first, n_near, n_also: forms.len() - n_before });
        }
        Self { n_columns, pieces, forms }
    }

    /// The widest step along u over each row for steps along v, up to `whole`.
    pub(super) fn widest(&self, columns: &[f64], whole: f64) -> Vec<f64> {
        let of_row = |row: &[CompactPiece]| {
            let pieces = row.iter().zip(columns);
            pieces.fold(whole, |most, (&piece, &b)| self.widest_below(piece, most, b))
        };
        self.pieces.chunks(self.n_columns.max(1)).map(of_row).collect()
    }

    /// The widest step along u for one along v, if it is less than `most`: mostly it is not, which takes no root to
    /// tell. Nothing where the one along v is too wide alone.
    fn widest_below(&self, piece: CompactPiece, most: f64, b: f64) -> f64 {
        let forms = &self.forms[piece.first..];
        let (whole, n_near) = (forms[0], piece.n_near.unwrap_or(0));
        let near = piece.n_near.map(|n_near| &forms[1..][..n_near]);
        let also = &forms[1 + n_near..][..piece.n_also];
        let fits = |form: &ParameterBoxes| form.share([most, b]) <= 1.0;
        let keeps = |near: &[ParameterBoxes]| near.iter().all(fits);
        if keeps(also) && (fits(&whole) || near.is_some_and(keeps)) {
            return most;
        }
        let least = |forms: &[ParameterBoxes]| {
            forms.iter().map(|form| form.widest(b)).fold(f64::INFINITY, f64::min)
        };
        least(also).min(whole.widest(b).max(near.map_or(0.0, least))).min(most)
    }
}

/// The side to which something bends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum BendingSide {
    Along,
    Against,
}

impl CellRules {
    /// Whether a cell of these widths keeps to the rules of all pieces that it touches.
    ///
    /// Lengths and turns are those of a path, at each place no more than the piece there makes them.
    /// Which piece bends the cell most may differ from corner to corner: each second derivative
    /// counts where it is largest, or all where together they bend it most in any direction.
    pub(super) fn all_allow<'a>(
        pieces: impl Iterator<Item = &'a Self> + Clone,
        widths: [f64; 2],
    ) -> bool {
        let fits = |form: &ParameterBoxes| form.share(widths) <= 1.0 + VANISHING_RELATIVE;
        let is_round = |form: ParameterBoxes| form.round_share(widths) <= 1.0 + VANISHING_RELATIVE;
        if !pieces.clone().all(|rules| rules.also.iter().all(fits)) {
            return false;
        }
        let whole = pieces.clone().map(|rules| rules.whole).reduce(ParameterBoxes::joined);
        if whole.is_none_or(|whole| fits(&whole)) {
            return true;
        }
        let mut near = pieces.clone().map(|rules| rules.near.as_ref());
        let joined = near.next().flatten().copied().and_then(|first| {
            near.try_fold(first, |joined, other| other.map(|other| joined.joined(other)))
        });
        if joined.is_some_and(|near| near.forms().iter().all(fits)) {
            return true;
        }
        pieces.clone().all(|rules| is_round(rules.whole))
            || joined.is_some_and(|near| near.others().iter().all(fits))
                && pieces
                    .filter_map(|rules| rules.near)
                    .all(|near| is_round(near.lift.and(near.slip)))
    }

    /// Widths of a cell that keeps to them, about as large as one may be; `ratio` is how many times
    /// longer a step along u is than one along v.
    pub(super) fn largest(&self, ratio: f64) -> [f64; 2] {
        let least = |forms: &[ParameterBoxes]| {
            let sizes = forms.iter().map(|form| form.largest(ratio));
            sizes.fold([f64::INFINITY; 2], |[a, b], [c, d]| [a.min(c), b.min(d)])
        };
        let mut widths = self.whole.largest(ratio);
        if let Some(near) = self.near {
            let others = least(&near.forms());
            if widths[0] * widths[1] < others[0] * others[1] {
                widths = others;
            }
        }
        let others = least(&self.also);
        [widths[0].min(others[0]), widths[1].min(others[1])]
    }

    /// The same with u and v exchanged.
    pub(super) fn swapped(self) -> Self {
        Self {
            whole: self.whole.swapped(),
            near: self.near.map(NormalRules::swapped),
            also: self.also.map(ParameterBoxes::swapped),
        }
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
    fn forms(&self) -> [ParameterBoxes; 5] {
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

    fn swapped(self) -> Self {
        let turned = |sense| {
            if sense == BendingSide::Along { BendingSide::Against } else { BendingSide::Along }
        };
        Self {
            lift: self.lift.swapped(),
            saddle: self.saddle.map(turned),
            slip: self.slip.swapped(),
            turn: self.turn.swapped(),
            slide: self.slide.swapped(),
            line: self.line.swapped(),
            ..self
        }
    }
}
