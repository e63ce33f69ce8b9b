//! What is wrong with curves that make no network, in the words of the script.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Span},
    kernel::{
        CountError, Direction, FitError, GeomError, NetworkError, NetworkInput,
        tolerance::EXACT_RELATIVE,
    },
    value::{Ctx, blamed_on, raised, rounded, shortest},
};

/// What a message about a network points at.
pub(super) struct NetworkPlaces<'p, 'a> {
    pub(super) ctx: &'p Ctx<'a>,
    pub(super) spans: [Span; 2],
    /// Where the parameters are, if they are given, at which the curves meet.
    pub(super) at: [Option<Span>; 2],
    pub(super) tolerance: f64,
}

impl NetworkPlaces<'_, '_> {
    /// A place; coordinates below the tolerance are zero.
    fn place(&self, point: DVec3) -> String {
        let least = self.tolerance.max(EXACT_RELATIVE * point.abs().max_element());
        let [x, y, z] = point.to_array().map(|x| shortest(if x.abs() <= least { 0.0 } else { x }));
        format!("({x}, {y}, {z})")
    }

    /// The name of a curve and where it is given.
    fn curve(&self, along: Direction, index: usize) -> (String, Span) {
        self.ctx.element(self.spans[along], index, along.name())
    }

    pub(super) fn diagnostic(&self, error: NetworkError) -> Box<Diagnostic> {
        Box::new(match error {
            NetworkError::Apart { pair, gap, at, point, n_pairs, are_all } => {
                let both = [(pair[0], at[0]), (pair[1], at[1])];
                self.apart(both, gap, point, (n_pairs, are_all))
            }
            NetworkError::Ambiguous { pair, at } => self.ambiguous(pair, &at),
            NetworkError::Together { pair, ends } => {
                let [(c, of_c), (d, of_d)] = self.pair(pair);
                let [from, to] = ends.map(|point| self.place(point));
                let message = format!(
                    "{c} and {d} run along one another from {from} to {to} instead of crossing"
                );
                Diagnostic::error(Code::Degenerate, of_c, message)
                    .also(of_d, "and this")
                    .hint("curves of `u` cross those of `v` at single places")
            }
            NetworkError::Mixed { along, closed, open, gap } => {
                let ((a, of_a), (b, of_b)) = (self.curve(along, closed), self.curve(along, open));
                let message =
                    format!("{a} is closed and {b} is open: its ends are {} apart", rounded(gap));
                Diagnostic::error(Code::Degenerate, of_b, message)
                    .also(of_a, "this closes")
                    .hint("close it, or `split` the closed ones where the open ones begin")
            }
            NetworkError::Crossing { along, curves, point } => {
                let [(a, of_a), (b, of_b)] = curves.map(|index| self.curve(along, index));
                let message = format!("{a} and {b} cross at {}", self.place(point));
                let name = along.name();
                Diagnostic::error(Code::Degenerate, of_b, message)
                    .also(of_a, "and this")
                    .hint(format!("curves of `{name}` lie beside one another, and cross only those of the other direction"))
            }
            NetworkError::Order { along, curve, others, at, crossing } => {
                self.out_of_order((along, curve), others, at, crossing)
            }
            NetworkError::Geometry(GeomError::Fit(FitError::ToleranceNotKept {
                found, ..
            })) => self.not_kept(found),
            NetworkError::Point { along, curve } => {
                let (own, span) = self.curve(along, curve);
                Diagnostic::error(Code::Degenerate, span, format!("{own} is one point")).hint(
                    "a surface that ends in a point is a `skin` whose first or last section is one",
                )
            }
            NetworkError::Input { of, error } => return self.of_input(of, error),
            NetworkError::Geometry(error) => return blamed_on(error, self.ctx.span),
        })
    }

    fn of_input(&self, of: NetworkInput, error: GeomError) -> Box<Diagnostic> {
        let (span, name, across) = match of {
            NetworkInput::U => (self.spans[0], "u", "v"),
            NetworkInput::V => (self.spans[1], "v", "u"),
            NetworkInput::AtU => (self.at[0].unwrap_or_default(), "at_u", "v"),
            NetworkInput::AtV => (self.at[1].unwrap_or_default(), "at_v", "u"),
        };
        Box::new(match error {
            GeomError::Count(CountError::TooFewCurves { got, needed }) => {
                let message =
                    format!("a network needs {needed} curves `{name}` or more, found {got}");
                Diagnostic::error(Code::BadCall, span, message)
                    .hint("sections without curves across them make a `skin`")
            }
            GeomError::Count(CountError::WrongCount { needed, got, .. }) => {
                let message = format!(
                    "`{name}` are {got} parameters, but there are {needed} curves `{across}`"
                );
                Diagnostic::error(Code::BadParameters, span, message).hint(format!(
                    "give one for each curve of `{across}`, or leave `{name}` out to have them found"
                ))
            }
            other => return blamed_on(other, span),
        })
    }

    fn pair(&self, [k, l]: [usize; 2]) -> [(String, Span); 2] {
        [self.curve(Direction::U, k), self.curve(Direction::V, l)]
    }

    fn apart(
        &self,
        [(k, t), (l, s)]: [(usize, f64); 2],
        gap: f64,
        point: DVec3,
        (n_pairs, are_all): (usize, bool),
    ) -> Diagnostic {
        let [(c, of_c), (d, of_d)] = self.pair([k, l]);
        let (t, s, told) = (shortest(t), shortest(s), rounded(gap));
        let more = match n_pairs - 1 {
            0 => String::new(),
            1 => "; another pair does not meet either".to_owned(),
            n => format!("; {n} other pairs do not meet either"),
        };
        let message = format!(
            "{c} and {d} do not meet: they are {told} apart at {}, more than the tolerance {}{more}",
            self.place(point),
            shortest(self.tolerance)
        );
        let hint = if self.at.iter().any(Option::is_some) {
            "without `at_u` and `at_v` the places where the curves meet are found".to_owned()
        } else if are_all && 1 < n_pairs {
            "no curve of `u` meets one of `v`: both seem to run along one direction; `u` are the curves one way, `v` those across them".to_owned()
        } else {
            format!(
                "let them meet there (`extend` one that ends before), or allow the gap with a `tolerance` above {}",
                raised(gap)
            )
        };
        Diagnostic::error(Code::Gap, of_c, message)
            .label(format!("{c} is nearest at parameter {t}"))
            .also(of_d, format!("{d} at parameter {s}"))
            .hint(hint)
    }

    fn ambiguous(&self, pair: [usize; 2], at: &[([f64; 2], DVec3)]) -> Diagnostic {
        let [(c, of_c), (d, of_d)] = self.pair(pair);
        let list = |texts: Vec<String>| texts.join(", ");
        let message = format!(
            "{c} and {d} meet at {} places, {}, and no other curve tells which is meant",
            at.len(),
            list(at.iter().map(|&(_, point)| self.place(point)).collect())
        );
        let parameters = |i: usize| list(at.iter().map(|(both, _)| shortest(both[i])).collect());
        Diagnostic::error(Code::Degenerate, of_c, message)
            .label(format!("at the parameters {} of {c}", parameters(0)))
            .also(of_d, format!("at {} of {d}", parameters(1)))
            .hint("`trim` one of them so that they meet once, or give `at_u` and `at_v`")
    }

    fn not_kept(&self, found: f64) -> Diagnostic {
        let message = format!(
            "the surface cannot be kept within {} of all curves: it misses one by {}",
            shortest(self.tolerance),
            rounded(found)
        );
        Diagnostic::error(Code::BeyondTolerance, self.ctx.span, message).hint(format!(
            "allow it with a `tolerance` above {}; gaps where curves meet, and meetings that lie at very different parameters of the curves of one direction, cost most of it",
            raised(found)
        ))
    }

    fn out_of_order(
        &self,
        (along, curve): (Direction, usize),
        [a, b]: [usize; 2],
        at: [f64; 2],
        crossing: Option<DVec3>,
    ) -> Diagnostic {
        let (own, span) = self.curve(along, curve);
        let [(a, of_a), (b, of_b)] = [a, b].map(|index| self.curve(along.other(), index));
        let first = self.curve(along, 0).0;
        let [from, to] = at.map(shortest);
        let message = if at[0] < at[1] || at[1] < at[0] {
            format!(
                "{own} meets {b} (parameter {to}) before {a} (parameter {from}), unlike {first}"
            )
        } else {
            format!("{own} meets {a} and {b} at one place, parameter {from}")
        };
        let other = along.other().name();
        let told = Diagnostic::error(Code::Degenerate, span, message);
        let told = match crossing {
            Some(point) => {
                told.also(of_a, "this").also(of_b, format!("crosses this at {}", self.place(point)))
            }
            None => told,
        };
        told.hint(format!("the curves of `{other}` must not cross one another, nor be one curve"))
    }
}
