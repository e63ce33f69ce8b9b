//! The rules of the pieces of a surface, to be gone through many times.

use super::{form::ParameterBoxes, rules::PieceRules};
use crate::Grid;

/// Those rules that do not allow everything, one behind the other.
#[derive(Debug)]
pub(super) struct CompactRules {
    pieces: Grid<CompactPiece>,
    forms: Vec<ParameterBoxes>,
}

/// Where among the forms those of a piece are: those that hold besides, that of the whole, and those along the normal,
/// of which some are kept wherever the first are.
#[derive(Clone, Copy, Debug)]
struct CompactPiece {
    first: u32,
    n_besides: u32,
    n_near: Option<[u32; 2]>,
}

impl CompactRules {
    /// Those of the pieces in some rows and columns.
    pub(super) fn new(rules: &PieceRules, [rows, columns]: [&[usize]; 2]) -> Self {
        let counts = |form: &ParameterBoxes| *form != ParameterBoxes::NONE;
        let mut forms = Vec::with_capacity(6 * rows.len() * columns.len());
        let pieces = Grid::from_fn(rows.len(), columns.len(), |row, column| {
            let (i, j) = (rows[row], columns[column]);
            let first = forms.len();
            forms.extend(rules.besides().map(|forms| forms.row(i)[j]).filter(counts));
            let n_besides = forms.len() - first;
            let bends = rules.bends.as_ref().map(|bends| &bends.row(i)[j]);
            forms.push(bends.map_or(ParameterBoxes::NONE, |bends| bends.whole));
            let n_near = bends.and_then(|bends| bends.near).map(|near| {
                let n_before = forms.len();
                let [both, all @ ..] = near.forms();
                let is_other = |form: &ParameterBoxes| !form.is_within(both);
                forms.push(both);
                forms.extend(all.into_iter().filter(is_other));
                let n_tested = forms.len() - n_before;
                forms.extend(all.into_iter().filter(|form| !is_other(form) && counts(form)));
                [n_tested as u32, (forms.len() - n_before) as u32]
            });
            CompactPiece { first: first as u32, n_besides: n_besides as u32, n_near }
        });
        Self { pieces, forms }
    }

    /// The widest step along u over each row for steps along v, up to `whole`.
    pub(super) fn widest_rows(&self, columns: &[f64], whole: f64) -> Vec<f64> {
        let of_row = |i: usize| {
            let pieces = self.pieces.row(i).iter().zip(columns);
            pieces.fold(whole, |most, (&piece, &b)| self.widest::<false>(piece, most, b))
        };
        (0..self.pieces.n_rows()).map(of_row).collect()
    }

    /// The widest step along v over each column for steps along u, up to `whole`.
    pub(super) fn widest_columns(&self, rows: &[f64], whole: f64) -> Vec<f64> {
        let mut widest = vec![whole; self.pieces.n_columns()];
        for (i, &a) in rows.iter().enumerate() {
            for (&piece, most) in self.pieces.row(i).iter().zip(&mut widest) {
                *most = self.widest::<true>(piece, *most, a);
            }
        }
        widest
    }

    /// The widest step along u for one along v, or the other way round, if it is less than `most`: mostly it is not,
    /// which takes no root to tell. Nothing where the one along v is too wide alone.
    #[inline]
    fn widest<const ALONG_V: bool>(&self, piece: CompactPiece, most: f64, across: f64) -> f64 {
        let turned = |form: &ParameterBoxes| if ALONG_V { form.swapped() } else { *form };
        let forms = &self.forms[piece.first as usize..];
        let (besides, forms) = forms.split_at(piece.n_besides as usize);
        let [n_tested, n_near] = piece.n_near.unwrap_or_default().map(|n| n as usize);
        let (whole, near) = (&forms[0], &forms[1..][..n_near]);
        let fits = |form: &ParameterBoxes| turned(form).share([most, across]) <= 1.0;
        let is_near = || 0 < n_near && near[..n_tested].iter().all(fits);
        if besides.iter().all(fits) && (fits(whole) || is_near()) {
            return most;
        }
        let least = |forms: &[ParameterBoxes]| {
            let widths = forms.iter().map(|form| turned(form).widest(across));
            widths.fold(f64::INFINITY, f64::min)
        };
        let near = if 0 < n_near { least(near) } else { 0.0 };
        least(besides).min(turned(whole).widest(across).max(near)).min(most)
    }
}
