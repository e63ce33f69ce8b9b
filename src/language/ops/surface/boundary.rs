//! What the operations that fill boundaries have in common: named curves whose ends must meet.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{Curve, NurbsCurve},
    value::{At, Ctx, rounded, shortest},
};

/// A curve under the name that messages call it by.
#[derive(Clone, Debug)]
pub(super) struct NamedEdge {
    pub(super) name: String,
    pub(super) curve: NurbsCurve,
}

impl NamedEdge {
    /// Its lower or upper end.
    pub(super) fn end(&self, which: usize) -> DVec3 {
        if which == 0 { self.curve.start() } else { self.curve.end() }
    }

    /// The same run backwards, under the name of what does that.
    pub(super) fn reversed(&self) -> Self {
        Self { name: format!("reversed({})", self.name), curve: self.curve.reversed() }
    }
}

/// The curves of a list, `label[0]` and so on; parametric ones are converted within the document's
/// tolerance.
pub(super) fn edges(
    label: &str,
    curves: &Spanned<Vec<Curve>>,
    ctx: &Ctx<'_>,
) -> Result<Vec<NamedEdge>> {
    let edge = |(idx, curve): (usize, &Curve)| {
        let curve = match curve {
            Curve::Nurbs(curve) => NurbsCurve::clone(curve),
            Curve::Parametric(curve) => curve.to_nurbs(ctx.tolerance.distance).at(curves.span)?,
        };
        Ok(NamedEdge { name: format!("{label}[{idx}]"), curve })
    };
    curves.value.iter().enumerate().map(edge).collect()
}

/// The two curves of a list.
pub(super) fn pair(
    label: &str,
    curves: &Spanned<Vec<Curve>>,
    ctx: &Ctx<'_>,
) -> Result<[NamedEdge; 2]> {
    edges(label, curves, ctx)?.try_into().map_err(|found: Vec<NamedEdge>| {
        let message = format!("`{label}` takes two curves, found {}", found.len());
        let across = if label == "u" { "v" } else { "u" };
        let hint = format!("the first is where {across} starts, the second where it ends");
        Box::new(Diagnostic::error(Code::BadCall, curves.span, message).hint(hint))
    })
}

/// `starts` or `ends`.
pub(super) fn verb(which: usize) -> &'static str {
    ["starts", "ends"][which]
}

/// A measured place or vector with six digits.
pub(super) fn place(p: DVec3) -> String {
    format!("({}, {}, {})", rounded(p.x), rounded(p.y), rounded(p.z))
}

/// Two curves along u and two along v.
#[derive(Clone, Debug)]
pub(super) struct Boundary {
    pub(super) u: [NamedEdge; 2],
    pub(super) v: [NamedEdge; 2],
}

impl Boundary {
    /// The largest distance of the ends at a corner, with the corner: the end of u and that of v.
    fn widest_gap(&self) -> (f64, [usize; 2]) {
        let corners = [[0, 0], [0, 1], [1, 0], [1, 1]];
        let gap = |[i, j]: [usize; 2]| self.u[j].end(i).distance(self.v[i].end(j));
        corners
            .into_iter()
            .map(|corner| (gap(corner), corner))
            .fold((0.0, [0, 0]), |widest, found| if widest.0 < found.0 { found } else { widest })
    }

    /// Fails unless the curves share their ends: `u[0]` and `v[0]` start together, and so on.
    pub(super) fn check(&self, spans: [Span; 2], tolerance: f64) -> Result<()> {
        let (gap, [i, j]) = self.widest_gap();
        if gap <= tolerance {
            return Ok(());
        }
        let (along_u, along_v) = (&self.u[j], &self.v[i]);
        let message = format!(
            "`{}` {} at {}, but `{}` {} at {}: {} apart, more than the tolerance {}",
            along_u.name,
            verb(i),
            place(along_u.end(i)),
            along_v.name,
            verb(j),
            place(along_v.end(j)),
            rounded(gap),
            shortest(tolerance)
        );
        let found = Diagnostic::error(Code::Gap, spans[0], message).also(spans[1], "the other");
        let hint = match self.that_fits(tolerance) {
            Some(fitting) => format!("`{fitting}` would fit"),
            None => "the u-curves go from `v[0]` to `v[1]`, the v-curves from `u[0]` to `u[1]`"
                .to_owned(),
        };
        found.hint(hint).fail()
    }

    /// The same curves in the order and directions that fit, if any do, with the fewest changes.
    fn that_fits(&self, tolerance: f64) -> Option<String> {
        /// Which two of `u[0] u[1] v[0] v[1]` are opposite, and which others.
        const OPPOSITE: [[[usize; 2]; 2]; 3] =
            [[[0, 1], [2, 3]], [[0, 2], [1, 3]], [[0, 3], [2, 1]]];
        let all = [&self.u[0], &self.u[1], &self.v[0], &self.v[1]];
        let mut best: Option<(u32, String)> = None;
        for (pairs, code) in OPPOSITE.iter().flat_map(|pairs| (0..128).map(move |c| (pairs, c))) {
            let is = |bit: usize| code & (1_u32 << bit) != 0;
            let turned = |i: usize| if is(i) { all[i].reversed() } else { all[i].clone() };
            let [mut u, mut v] = pairs.map(|pair| pair.map(turned));
            if is(4) {
                u.reverse();
            }
            if is(5) {
                v.reverse();
            }
            let other = if is(6) { Self { u: v, v: u } } else { Self { u, v } };
            let cost = code.count_ones() + u32::from(*pairs != OPPOSITE[0]);
            if best.as_ref().is_none_or(|(least, _)| cost < *least)
                && other.widest_gap().0 <= tolerance
            {
                best = Some((cost, other.description()));
            }
        }
        best.map(|(_, told)| told)
    }

    fn description(&self) -> String {
        let [u, v] = [&self.u, &self.v];
        format!("u = [{}, {}], v = [{}, {}]", u[0].name, u[1].name, v[0].name, v[1].name)
    }

    /// The curves along u, and those along v.
    pub(super) fn curves(&self) -> [[&NurbsCurve; 2]; 2] {
        [[&self.u[0].curve, &self.u[1].curve], [&self.v[0].curve, &self.v[1].curve]]
    }
}
