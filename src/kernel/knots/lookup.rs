//! Which piece of a spline a parameter lies in, without a search.
//!
//! The domain is divided into equal parts, a few for each piece. A part with at most one break
//! between pieces needs one comparison; only where breaks crowd is there a search.

use super::KnotVector;

/// From here on every `f64` is a whole number.
const WHOLE: f64 = (1_u64 << 52) as f64;

/// Equal parts of the domain for each piece: more of them leave fewer parts with several breaks.
const PARTS_A_PIECE: usize = 2;

/// Parameters that are looked up at a time: enough to hide what each lookup waits for.
pub(crate) const BATCH: usize = 64;

/// The pieces of a spline, each with the place that its parameters are counted from.
#[derive(Clone, Debug)]
pub(crate) struct SpanLookup {
    pieces: Vec<SpanRange>,
    parts: Vec<DomainPart>,
    /// Start of the domain.
    start: f64,
    /// Parts over the length of the domain.
    per_part: f64,
    /// The number of the last part.
    last_part: f64,
}

/// The parameters of a piece.
#[derive(Clone, Copy, Debug)]
struct SpanRange {
    start: f64,
    /// Where its parameters are counted from.
    origin: f64,
    /// One over the width of its span.
    per_width: f64,
}

/// One of the equal parts of the domain.
#[derive(Clone, Copy, Debug)]
struct DomainPart {
    /// The piece at its start; where breaks crowd, a piece that there is none.
    first: usize,
    /// Where the next piece begins.
    next: f64,
}

/// A parameter within its piece.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct LocalParameter {
    pub(crate) piece: usize,
    /// From the origin of the piece, in widths of its span.
    pub(crate) s: f64,
}

impl SpanLookup {
    /// The halves of the spans, each counted from the knot beside it: the left one 0 to 1/2, the
    /// right one −1/2 to 0. What is counted from a knot is exact at the knot.
    pub(crate) fn of_halves(knots: &KnotVector) -> Self {
        let pieces = |span: usize| {
            let interval = knots.span_interval(span);
            let per_width = 1.0 / interval.length();
            let [left, right] = interval.halves();
            let half = |start: f64, origin: f64| SpanRange { start, origin, per_width };
            [half(left.start(), left.start()), half(right.start(), right.end())]
        };
        Self::new(knots, knots.spans().flat_map(pieces).collect())
    }

    fn new(knots: &KnotVector, pieces: Vec<SpanRange>) -> Self {
        let (domain, n_parts) = (knots.domain(), PARTS_A_PIECE * pieces.len());
        let mut lookup = Self {
            pieces,
            parts: Vec::with_capacity(n_parts + 1),
            start: domain.start(),
            per_part: n_parts as f64 / domain.length(),
            last_part: n_parts as f64,
        };
        let breaks: Vec<f64> = lookup.pieces[1..].iter().map(|piece| piece.start).collect();
        let mut first = 0;
        for part in 0..=n_parts {
            let inside = breaks[first..].iter().take_while(|&&t| lookup.part_at(t) <= part).count();
            lookup.parts.push(match inside {
                0 => DomainPart { first, next: f64::INFINITY },
                1 => DomainPart { first, next: breaks[first] },
                _ => DomainPart { first: lookup.pieces.len(), next: f64::INFINITY },
            });
            first += inside;
        }
        lookup
    }

    /// Where a parameter lies; outside the domain in the first or the last piece.
    #[inline(always)]
    pub(crate) fn place_at(&self, t: f64) -> LocalParameter {
        self.place_in(self.part_at(t), t)
    }

    /// The places of up to [`BATCH`] parameters.
    #[inline(always)]
    pub(crate) fn places_at(&self, parameters: &[f64], places: &mut [LocalParameter; BATCH]) {
        let mut parts = [0; BATCH];
        for (part, &t) in parts.iter_mut().zip(parameters) {
            *part = self.part_at(t);
        }
        for ((place, &t), &part) in places.iter_mut().zip(parameters).zip(&parts) {
            *place = self.place_in(part, t);
        }
    }

    /// One over the width of the span that a piece belongs to.
    #[inline(always)]
    pub(crate) fn per_width(&self, piece: usize) -> f64 {
        self.pieces[piece].per_width
    }

    #[inline(always)]
    fn place_in(&self, part: usize, t: f64) -> LocalParameter {
        let DomainPart { first, next } = self.parts[part];
        let piece = first + usize::from(next <= t);
        match self.pieces.get(piece) {
            Some(&SpanRange { origin, per_width, .. }) => {
                LocalParameter { piece, s: (t - origin) * per_width }
            }
            None => self.searched(t),
        }
    }

    /// The place where breaks crowd.
    #[cold]
    #[inline(never)]
    fn searched(&self, t: f64) -> LocalParameter {
        let piece = self.pieces.partition_point(|piece| piece.start <= t).saturating_sub(1);
        let SpanRange { origin, per_width, .. } = self.pieces[piece];
        LocalParameter { piece, s: (t - origin) * per_width }
    }

    /// Which of the equal parts of the domain holds `t`; beyond the ends the first or the last.
    ///
    /// Rounded to nearest, so that of even knots each lies amid its part: in this sum the last bits
    /// are the whole number, at a fraction of the cost of a conversion that saturates.
    #[inline(always)]
    fn part_at(&self, t: f64) -> usize {
        let part = (t - self.start) * self.per_part;
        let part = if 0.0 < part { part } else { 0.0 };
        let part = if part < self.last_part { part } else { self.last_part };
        ((part + WHOLE).to_bits() - WHOLE.to_bits()) as usize
    }
}

impl KnotVector {
    /// Whether any of [`Self::full_breaks`] is inside of the domain.
    pub(crate) fn has_inner_full_break(&self) -> bool {
        let (n, last) = (self.degree + 1, self.knots.len() - 1);
        let domain = self.domain();
        // Knots are in order: those of a run are equal where its ends are.
        (1..=last.saturating_sub(n)).any(|i| {
            let t = self.knots[i];
            t >= self.knots[i + n - 1] && domain.start() < t && t < domain.end()
        })
    }
}
